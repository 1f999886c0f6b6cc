/* Moving, turning and scaling the selection: by the pointer, along an axis, or by a typed number.
 */
#include "app/text.h"
#include "app/tools/drag.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"
#include "model/edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FINE 0.1
#define ANGLE_STEP_DEG 5.0
#define SCALE_STEP 0.1

typedef struct state {
    kg_transform_kind kind;
    kg_vec3 center;
    kg_vec2 pressed, aim; /* the pointer, fine movements taken in */
    kg_vec2 last;
    int axis;   /* 0 x, 1 y, 2 z; -1 free */
    bool plane; /* moves in the plane across the axis instead */
    bool held;  /* began by pressing the mouse: letting go ends it */
    char typed[24];
    char hint[200];
} state;

static kg_vec3 axis_of(int axis) {
    return kg_v3(axis == 0, axis == 1, axis == 2);
}

/* ---- what is moved ----------------------------------------------------------------------- */

/* At the level of points with some selected these move, else the patches. */
static bool moves_points(const kg_editor *e) {
    return e->level == KG_LEVEL_POINTS && e->selection.points.count > 0;
}

kg_vec3 kg_selection_center(const kg_editor *e) {
    kg_box3 box = kg_box3_empty();
    if (!moves_points(e)) {
        for (size_t i = 0; i < e->selection.patches.count; i++) {
            const kg_model_patch *p =
                kg_model_find(kg_editor_model(e), e->selection.patches.items[i]);
            for (size_t k = 0; k < p->input.point_count; k++)
                kg_box3_add(&box, p->input.points[k]);
        }
    }
    for (size_t i = 0; moves_points(e) && i < e->selection.points.count; i++) {
        kg_point_ref r = e->selection.points.items[i];
        kg_box3_add(&box, kg_model_find(kg_editor_model(e), r.patch)->input.points[r.index]);
    }
    return kg_lerp(box.lo, box.hi, 0.5);
}

static kg_status apply(kg_editor *e, const kg_similarity *map, kg_error *error) {
    kg_model *m = kg_editor_model(e);
    kg_status status = KG_OK;
    for (size_t i = 0; !moves_points(e) && i < e->selection.patches.count && !status; i++)
        status = kg_model_transform_patch(m, e->selection.patches.items[i], map, error);
    for (size_t i = 0; moves_points(e) && i < e->selection.points.count; i++) {
        kg_point_ref r = e->selection.points.items[i];
        kg_vec3 *p = &kg_model_find(m, r.patch)->input.points[r.index];
        *p = kg_similarity_apply(map, *p);
    }
    return status;
}

/* ---- how ---------------------------------------------------------------------------------- */

static bool typed_number(const state *s, double *out) {
    char *end;
    if (!s->typed[0])
        return false;
    *out = strtod(s->typed, &end);
    return end != s->typed && isfinite(*out);
}

static kg_vec3 move_by(const kg_editor *e, const state *s) {
    double from, to, number;
    kg_vec3 by = {0, 0, 0}, a, b;
    if (s->axis >= 0 && typed_number(s, &number))
        return kg_madd(kg_v3(0, 0, 0), number, axis_of(s->axis)); /* never -0, which is shown */
    if (typed_number(s, &number))                                 /* without an axis: along x */
        return kg_v3(number, 0, 0);
    if (s->axis >= 0 && !s->plane) {
        kg_vec3 axis = axis_of(s->axis);
        if (kg_pane_along_axis(&e->pane, s->pressed, s->center, axis, &from) &&
            kg_pane_along_axis(&e->pane, s->aim, s->center, axis, &to))
            by = kg_scale(axis, to - from);
    } else if (s->axis >= 0) {
        if (kg_pane_on_plane(&e->pane, s->pressed, s->center, axis_of(s->axis), &a) &&
            kg_pane_on_plane(&e->pane, s->aim, s->center, axis_of(s->axis), &b))
            by = kg_sub(b, a);
    } else {
        by = kg_sub(kg_pane_on_screen_plane(&e->pane, s->aim, s->center),
                    kg_pane_on_screen_plane(&e->pane, s->pressed, s->center));
    }
    if (e->mods & KG_MOD_CTRL)
        by = kg_v3(kg_round_to_step(e, by.x), kg_round_to_step(e, by.y), kg_round_to_step(e, by.z));
    return by;
}

/* Radians about the axis, which without a lock points to the eye. */
static double turn_by(const kg_editor *e, const state *s, kg_vec3 axis) {
    double number;
    kg_vec2 c;
    if (typed_number(s, &number))
        return number * KG_PI / 180;
    if (!kg_pane_project(&e->pane, s->center, &c))
        return 0;
    kg_vec2 a = kg_sub2(s->pressed, c), b = kg_sub2(s->aim, c);
    kg_vec3 right, up, back;
    kg_camera_axes(&e->pane.camera, &right, &up, &back);
    double angle = -atan2(kg_cross2(a, b), kg_dot2(a, b)); /* y is down in the window */
    if (kg_dot(axis, back) < 0)
        angle = -angle;
    if (e->mods & KG_MOD_CTRL)
        angle = round(angle * 180 / KG_PI / ANGLE_STEP_DEG) * ANGLE_STEP_DEG * KG_PI / 180;
    return angle;
}

static double scale_by(const kg_editor *e, const state *s) {
    double number;
    kg_vec2 c;
    if (typed_number(s, &number))
        return number > 0 ? number : 1;
    if (!kg_pane_project(&e->pane, s->center, &c))
        return 1;
    double factor = fmax(kg_dist2(s->aim, c), 1) / fmax(kg_dist2(s->pressed, c), 1);
    return e->mods & KG_MOD_CTRL ? fmax(round(factor / SCALE_STEP), 1) * SCALE_STEP : factor;
}

static kg_similarity map_of(const kg_editor *e, const state *s) {
    kg_similarity map = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, 1, {0, 0, 0}};
    kg_vec3 right, up, axis;
    kg_camera_axes(&e->pane.camera, &right, &up, &axis);
    if (s->axis >= 0)
        axis = axis_of(s->axis);
    switch (s->kind) {
    case KG_TRANSFORM_MOVE:
        map.offset = move_by(e, s);
        break;
    case KG_TRANSFORM_ROTATE:
        map = kg_similarity_turn(s->center, axis, turn_by(e, s, axis));
        break;
    case KG_TRANSFORM_SCALE:
        map.scale = scale_by(e, s);
        map.offset = kg_scale(s->center, 1 - map.scale);
        break;
    }
    return map;
}

/* The selection as it was, moved as the pointer says now. */
static void update(kg_editor *e) {
    state *s = e->tool_state;
    if (!e->before) /* something else ended the step */
        return;
    kg_similarity map = map_of(e, s);
    kg_model *fresh = kg_model_copy(kg_document_model(e->before));
    kg_error error;
    if (!fresh)
        return;
    kg_model_swap(kg_editor_model(e), fresh);
    if (apply(e, &map, &error)) {
        kg_model_swap(kg_editor_model(e), fresh);
        kg_editor_say(e, KG_FAULT, "%s", error.message);
    }
    kg_model_destroy(fresh);
    kg_editor_touch(e);
}

/* ---- events ----------------------------------------------------------------------------- */

static bool type_character(state *s, const kg_event *event) {
    size_t n = strlen(s->typed);
    char c = (char)event->key;
    if (event->key == KG_KEY_BACKSPACE && n > 0) {
        s->typed[n - 1] = '\0';
        return true;
    }
    if (event->key >= KG_KEY_PAD_0 && event->key < KG_KEY_PAD_0 + 10)
        c = (char)('0' + event->key - KG_KEY_PAD_0);
    else if (event->key == KG_KEY_PAD_DECIMAL)
        c = '.';
    else if (event->key > 127)
        return false;
    if (c == '-') { /* changes the sign, wherever it is typed */
        if (s->typed[0] == '-')
            memmove(s->typed, s->typed + 1, n);
        else if (n + 2 < sizeof s->typed)
            memmove(s->typed + 1, s->typed, n + 1), s->typed[0] = '-';
        return true;
    }
    if (((c < '0' || c > '9') && c != '.') || n + 2 >= sizeof s->typed)
        return false;
    s->typed[n] = c;
    s->typed[n + 1] = '\0';
    return true;
}

static bool on_key(kg_editor *e, state *s, const kg_event *event) {
    if (event->key == KG_KEY_ESCAPE) {
        kg_editor_use_default(e); /* which takes the open step back */
        return true;
    }
    if (event->key == KG_KEY_ENTER || event->key == KG_KEY_PAD_ENTER) {
        kg_editor_commit(e);
        kg_editor_use_default(e);
        return true;
    }
    /* scaled in one direction, paper would not stay paper */
    bool axes = s->kind != KG_TRANSFORM_SCALE;
    if (axes && event->key >= 'X' && event->key <= 'Z' &&
        !(event->mods & (KG_MOD_CTRL | KG_MOD_ALT))) {
        int axis = event->key - 'X';
        bool plane = event->mods & KG_MOD_SHIFT;
        bool same = s->axis == axis && s->plane == plane;
        s->axis = same ? -1 : axis;
        s->plane = plane;
        update(e);
        return true;
    }
    if (type_character(s, event))
        update(e);
    return true; /* no command begins while this goes on */
}

static bool on_event(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    switch (event->type) {
    case KG_EVENT_MOVE: {
        kg_vec2 by = kg_sub2(event->position, s->last);
        s->last = event->position;
        s->aim = kg_add2(s->aim, kg_scale2(by, event->mods & KG_MOD_SHIFT ? FINE : 1));
        update(e);
        return true;
    }
    case KG_EVENT_PRESS:
        if (event->button == KG_MOUSE_RIGHT) {
            kg_editor_use_default(e);
            return true;
        }
        if (event->button == KG_MOUSE_LEFT) {
            kg_editor_commit(e);
            kg_editor_use_default(e);
        }
        return event->button == KG_MOUSE_LEFT;
    case KG_EVENT_RELEASE:
        if (!s->held || event->button != KG_MOUSE_LEFT)
            return true;
        kg_editor_commit(e);
        kg_editor_use_default(e);
        return true;
    case KG_EVENT_KEY:
        return on_key(e, s, event);
    default:
        return false;
    }
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    const state *s = e->tool_state;
    for (int i = 0; i < 3; i++)
        if (s->axis >= 0 && (i == s->axis) != s->plane)
            kg_axis_draw(e, s->center, i, overlay);
    kg_legal_band_draw(e, overlay);
}

static const char *hint_now(const kg_editor *e) {
    state *s = e->tool_state;
    kg_similarity map = map_of(e, s);
    const char *what = s->kind == KG_TRANSFORM_MOVE     ? _("Move")
                       : s->kind == KG_TRANSFORM_ROTATE ? _("Rotate")
                                                        : _("Scale");
    char value[80];
    if (s->kind == KG_TRANSFORM_MOVE)
        snprintf(value, sizeof value, "%.2f, %.2f, %.2f mm", map.offset.x, map.offset.y,
                 map.offset.z);
    else if (s->kind == KG_TRANSFORM_SCALE)
        snprintf(value, sizeof value, "%.3f", map.scale);
    else
        snprintf(value, sizeof value, "%s°", s->typed[0] ? s->typed : "…");
    snprintf(s->hint, sizeof s->hint,
             s->kind == KG_TRANSFORM_SCALE
                 ? _("%s %s   numbers: exactly   Ctrl: steps   Enter or click: done   Esc: back")
                 : _("%s %s   X/Y/Z: axis   numbers: exactly   Enter or click: done   Esc: back"),
             what, value);
    return s->hint;
}

kg_status kg_tool_start_transform(kg_editor *e, kg_transform_kind kind, kg_error *error) {
    static const char *const labels[] = {N_("Move"), N_("Rotate"), N_("Scale")};
    if (e->selection.patches.count == 0)
        return kg_fail(error, KG_ERR_INPUT, "select a patch first");
    state *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *s = (state){.kind = kind, .axis = -1, .center = kg_selection_center(e)};
    s->pressed = s->aim = s->last = e->pointer;
    kg_editor_use(e, &kg_tool_transform, s);
    return kg_editor_begin(e, labels[kind], error);
}

kg_status kg_tool_hold_transform(kg_editor *e, kg_transform_kind kind, int axis, kg_error *error) {
    kg_status status = kg_tool_start_transform(e, kind, error);
    if (status)
        return status;
    state *s = e->tool_state;
    s->axis = axis;
    s->held = true;
    return KG_OK;
}

const kg_tool kg_tool_transform = {
    "transform", N_("Move"), N_("Move the pointer"), on_event, draw, hint_now, NULL,
};
