/* Folding by hand: what the mouse does to sheets. */
#include "app/tools/fold.h"

#include "app/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GRAB_DISTANCE = 10, MOST_HITS = 64 }; /* layout units; layers under a pixel */

static kg_vec3 vertex_position(const kg_sheets *s, int32_t vertex) {
    return s->state->vertices.items[vertex].position;
}

/* ---- what lies under the pointer ----------------------------------------------------------- */

static void set_group(kg_editor *e, kg_fold_tool *t, int32_t loop, kg_vec3 near) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_vec2 px;
    kg_vec3 origin, direction;
    t->group = s->state->loops.items[loop].group;
    t->topology = s->topology;
    if (!kg_pane_project(&e->pane, near, &px))
        px = e->pointer;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    t->sign = kg_dot(s->state->groups.items[t->group].normal, direction) < 0 ? 1 : -1;
}

/* The vertex under the pointer and the loop of it that is seen there. */
static void find_vertex(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    kg_sheets *s = kg_sheets_of(e);
    kg_sheet_corner corner;
    kg_sheet_hit hit;
    t->vertex = t->picked = -1;
    if (kg_sheets_nearest_vertex(e, px, GRAB_DISTANCE * e->pane.scale, &corner)) {
        kg_vec3 at = vertex_position(s, corner.vertex);
        t->vertex = corner.vertex;
        if (kg_sheets_hit(e, px, &hit, 1) > 0 && kg_fold_has_corner(s->state, hit.loop, at))
            t->picked = hit.loop;
        set_group(e, t, t->picked >= 0 ? t->picked : corner.loop, corner.drawn);
    }
    s->hover_vertex = t->vertex;
}

/* The plane that a point under the pointer is looked for in: of the paper there, else as before. */
static void find_plane(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_sheet_hit hit;
    kg_sheet_corner corner;
    if (kg_sheets_hit(e, px, &hit, 1) > 0)
        set_group(e, t, hit.loop, hit.drawn);
    else if (kg_sheets_nearest_vertex(e, px, 2 * GRAB_DISTANCE * e->pane.scale, &corner))
        set_group(e, t, corner.loop, corner.drawn);
    else if (t->topology != s->topology && s->state->loops.count > 0)
        set_group(e, t, 0, s->drawn[s->state->loops.items[0].first]);
}

static bool find_edge(kg_editor *e, kg_fold_tool *t, kg_vec2 px, bool any_plane,
                      kg_fold_edge *out) {
    kg_sheets *s = kg_sheets_of(e);
    kg_sheet_side side;
    s->hover_edge = -1;
    if (!kg_sheets_nearest_edge(e, px, GRAB_DISTANCE * e->pane.scale, &side))
        return false;
    const kg_half_edge *halves = s->state->halves.items;
    *out = (kg_fold_edge){{vertex_position(s, halves[side.half].origin),
                           vertex_position(s, halves[side.half ^ 1].origin)},
                          side.position,
                          side.half};
    if (any_plane)
        set_group(e, t, side.loop, side.drawn);
    s->hover_edge = side.edge;
    return true;
}

static double side_of_axis(const kg_fold_tool *t, const kg_sheets *s, kg_vec3 p) {
    kg_vec3 n = s->state->groups.items[t->group].normal;
    return kg_dot(kg_sub(p, t->axis[0]), kg_cross(n, kg_unit(kg_sub(t->axis[1], t->axis[0]))));
}

/* The corner of a loop farthest from the axis on the side of a point. */
static int32_t far_corner(const kg_fold_tool *t, const kg_sheets *s, int32_t loop, kg_vec3 at) {
    double side = side_of_axis(t, s, at) < 0 ? -1 : 1, most = 1e-6 * s->state->size;
    int32_t first = s->state->loops.items[loop].first, h = first, best = -1;
    do {
        int32_t v = s->state->halves.items[h].origin;
        double d = side * side_of_axis(t, s, vertex_position(s, v));
        if (d > most)
            most = d, best = v;
    } while ((h = s->state->halves.items[h].next) != first);
    return best;
}

/* The vertex that stands for the side under the pointer: a corner there, else of the face there. */
static void find_side(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    kg_sheets *s = kg_sheets_of(e);
    kg_sheet_corner corner;
    kg_sheet_hit hits[MOST_HITS];
    t->vertex = t->picked = s->hover_vertex = -1;
    size_t count = kg_sheets_hit(e, px, hits, MOST_HITS);
    for (size_t i = 0; i < count && t->vertex < 0; i++)
        if (s->state->loops.items[hits[i].loop].group == t->group) {
            t->vertex = far_corner(t, s, hits[i].loop, hits[i].position);
            t->picked = hits[i].loop;
        }
    if (kg_sheets_nearest_vertex(e, px, GRAB_DISTANCE * e->pane.scale, &corner) &&
        s->state->loops.items[corner.loop].group == t->group &&
        fabs(side_of_axis(t, s, vertex_position(s, corner.vertex))) > 1e-6 * s->state->size) {
        t->vertex = s->hover_vertex = corner.vertex;
        if (t->picked >= 0 &&
            !kg_fold_has_corner(s->state, t->picked, vertex_position(s, t->vertex)))
            t->picked = -1;
    }
}

static void try_side(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    kg_sheets *s = kg_sheets_of(e);
    kg_fold fold = kg_fold_default();
    find_side(e, t, px);
    kg_fold_forget(t);
    if (t->vertex < 0)
        return;
    fold.by_axis = true;
    fold.points[0] = t->axis[0], fold.points[1] = t->axis[1];
    fold.vertex = vertex_position(s, t->vertex);
    kg_fold_try(e, fold);
}

/* ---- ways -------------------------------------------------------------------------------- */

static void try_drag(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_vec3 from = vertex_position(s, t->vertex);
    kg_fold fold = kg_fold_default();
    kg_fold_forget(t);
    t->aimed = kg_snap_find(e, t, px, e->mods, &from, &t->snap);
    if (!t->aimed || kg_dist(from, t->snap.point) < 2e-3 * s->state->size)
        return;
    fold.points[0] = from, fold.points[1] = t->snap.point;
    kg_fold_try(e, fold);
}

static void try_bisect(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    kg_fold_edge onto;
    kg_fold fold = kg_fold_default();
    kg_fold_forget(t);
    if (!find_edge(e, t, px, false, &onto) || !kg_axis_bisect(&t->edge, &onto, t->axis))
        return;
    /* the end of the edge that is farther from the axis, on the side that was clicked */
    const kg_sheets *s = kg_sheets_of(e);
    const kg_half_edge *halves = s->state->halves.items;
    double at = side_of_axis(t, s, t->edge.at), most = -INFINITY;
    fold.by_axis = true;
    fold.points[0] = t->axis[0], fold.points[1] = t->axis[1];
    for (int i = 0; i < 2; i++) {
        double d = side_of_axis(t, s, t->edge.ends[i]) * (at < 0 ? -1 : 1);
        if (d > most)
            most = d, t->vertex = halves[t->edge.half ^ i].origin;
    }
    t->picked = halves[t->edge.half].loop;
    fold.vertex = vertex_position(s, t->vertex);
    kg_fold_try(e, fold);
}

static void aim(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    t->aimed = kg_snap_find(e, t, px, e->mods, NULL, &t->snap);
}

/* Shows what a click would do. */
static void follow(kg_editor *e, kg_fold_tool *t, kg_vec2 px) {
    kg_sheets *s = kg_sheets_of(e);
    kg_fold_edge edge;
    if (!s->state || s->state->loops.count == 0 || t->phase == KG_PHASE_HELD)
        return;
    t->aimed = false;
    s->hover_edge = -1;
    if (t->phase == KG_PHASE_DRAGGING) {
        try_drag(e, t, px);
    } else if (t->phase == KG_PHASE_SIDE) {
        try_side(e, t, px);
    } else if (t->way == KG_WAY_DRAG) {
        find_vertex(e, t, px);
        if (t->vertex >= 0)
            kg_fold_find_pile(e, t);
    } else if (t->phase == KG_PHASE_SECOND && t->way == KG_WAY_BISECT) {
        try_bisect(e, t, px);
    } else if (t->phase == KG_PHASE_SECOND) {
        aim(e, t, px);
        if (t->aimed && t->way == KG_WAY_SQUARE)
            t->aimed = kg_axis_square(&t->edge, t->snap.point,
                                      s->state->groups.items[t->group].normal, t->axis);
    } else if (t->way == KG_WAY_AXIS) {
        find_plane(e, t, px);
        aim(e, t, px);
        if (t->aimed && t->snap.kind == KG_SNAP_EDGE && !(e->mods & KG_MOD_SHIFT))
            s->hover_edge = t->snap.half / 2;
    } else if (find_edge(e, t, px, true, &edge)) {
        t->edge = edge;
    }
}

/* ---- clicks ------------------------------------------------------------------------------ */

static void finish(kg_editor *e, kg_fold_tool *t, bool hold) {
    kg_error error;
    if (!t->given)
        return;
    if (hold) {
        t->phase = KG_PHASE_HELD;
        kg_fold_find_gaps(e);
        return;
    }
    if (kg_fold_done(e, &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
}

static void begin_side(kg_fold_tool *t, kg_vec3 a, kg_vec3 b) {
    t->axis[0] = a, t->axis[1] = b;
    t->phase = KG_PHASE_SIDE;
}

static void click_axis(kg_editor *e, kg_fold_tool *t) {
    const kg_sheets *s = kg_sheets_of(e);
    const kg_half_edge *halves = s->state->halves.items;
    if (!t->aimed)
        return;
    if (t->phase == KG_PHASE_SECOND) {
        if (kg_dist(t->first, t->snap.point) > 2e-3 * s->state->size)
            begin_side(t, t->first, t->snap.point);
    } else if (t->snap.kind == KG_SNAP_EDGE && !(e->mods & KG_MOD_SHIFT)) {
        begin_side(t, vertex_position(s, halves[t->snap.half].origin),
                   vertex_position(s, halves[t->snap.half ^ 1].origin));
    } else {
        t->first = t->snap.point;
        t->phase = KG_PHASE_SECOND;
    }
}

static void press(kg_editor *e, kg_fold_tool *t, const kg_event *event) {
    kg_sheets *s = kg_sheets_of(e);
    t->pressed = event->position;
    kg_editor_say(e, KG_WARNING, "%s", "");
    kg_sheets_skip(e);
    if (!kg_sheets_can_fold(e)) {
        kg_editor_say(e, KG_WARNING, "%s", kg_sheets_why_not(e));
        return;
    }
    if (t->phase == KG_PHASE_HELD)
        return;
    follow(e, t, event->position);
    if (t->phase == KG_PHASE_SIDE || (t->phase == KG_PHASE_SECOND && t->way == KG_WAY_BISECT)) {
        finish(e, t, event->mods & KG_MOD_SHIFT);
    } else if (t->way == KG_WAY_DRAG) {
        t->phase = t->vertex >= 0 ? KG_PHASE_DRAGGING : KG_PHASE_READY;
    } else if (t->way == KG_WAY_AXIS) {
        click_axis(e, t);
    } else if (t->phase == KG_PHASE_SECOND) { /* square */
        if (t->aimed)
            begin_side(t, t->axis[0], t->axis[1]);
    } else if (s->hover_edge >= 0) {
        t->phase = KG_PHASE_SECOND;
    }
    if (t->phase == KG_PHASE_SIDE)
        follow(e, t, event->position);
}

/* A click that drags nothing asks for one layer more, in turn. */
static void next_layer(kg_editor *e, kg_fold_tool *t) {
    kg_fold_find_pile(e, t);
    t->layers = t->layers < t->pile_count ? t->layers + 1 : 1;
}

static void release(kg_editor *e, kg_fold_tool *t, const kg_event *event) {
    if (t->phase != KG_PHASE_DRAGGING)
        return;
    follow(e, t, event->position);
    t->phase = KG_PHASE_READY;
    if (kg_dist2(event->position, t->pressed) < KG_CLICK_DISTANCE * e->pane.scale) {
        kg_fold_forget(t);
        next_layer(e, t);
    } else {
        finish(e, t, event->mods & KG_MOD_SHIFT);
        if (t->phase == KG_PHASE_READY && t->given)
            kg_fold_drop(e);
    }
}

static bool wheel(kg_editor *e, kg_fold_tool *t, const kg_event *event) {
    int by = event->wheel > 0 ? 1 : -1;
    if (!t->given || t->phase == KG_PHASE_HELD || t->phase == KG_PHASE_READY)
        return false;
    if (event->mods & KG_MOD_SHIFT) {
        kg_fold_find_gaps(e);
        size_t count = t->gap_count + 1;
        kg_fold_set_gap(e, (kg_fold_gap_now(t) + (by > 0 ? count - 1 : 1)) % count);
    } else {
        int32_t count, now = kg_fold_layers_now(t, &count);
        kg_fold_set_layers(e, now + by < 1 ? 1 : now + by > count ? count : now + by);
    }
    return true;
}

/* ---- keys -------------------------------------------------------------------------------- */

/* Digits, a point, a sign: the angle of the fold being made. */
static bool type_angle(kg_editor *e, kg_fold_tool *t, int key) {
    size_t n = strlen(t->typed);
    int digit = key >= KG_KEY_PAD_0 && key < KG_KEY_PAD_0 + 10 ? key - KG_KEY_PAD_0 + '0'
                : key == KG_KEY_PAD_DECIMAL                    ? '.'
                                                               : key;
    if (key == '-') {
        kg_fold_set_angle(e, -t->angle_deg);
        return true;
    }
    if (key == KG_KEY_BACKSPACE && n > 0)
        t->typed[n - 1] = '\0';
    else if ((digit >= '0' && digit <= '9') || digit == '.') {
        if (n + 1 < sizeof t->typed)
            t->typed[n] = (char)digit, t->typed[n + 1] = '\0';
    } else
        return false;
    char kept[sizeof t->typed];
    memcpy(kept, t->typed, sizeof kept);
    double angle = strtod(t->typed, NULL);
    kg_fold_set_angle(e, copysign(angle > 0 ? angle : 180, t->angle_deg));
    memcpy(t->typed, kept, sizeof kept);
    return true;
}

static void step_back(kg_editor *e, kg_fold_tool *t) {
    bool has_axis = t->way == KG_WAY_AXIS || t->way == KG_WAY_SQUARE;
    kg_fold_forget(t);
    t->phase = t->phase == KG_PHASE_HELD && has_axis ? KG_PHASE_SIDE : KG_PHASE_READY;
    t->typed[0] = '\0';
    follow(e, t, e->pointer);
}

static bool on_key(kg_editor *e, kg_fold_tool *t, const kg_event *event) {
    bool working = t->phase != KG_PHASE_READY;
    if (event->mods & (KG_MOD_CTRL | KG_MOD_ALT))
        return false;
    if (event->key == KG_KEY_ESCAPE && kg_sheets_of(e)->playing)
        return false; /* it stops that */
    if (event->key == KG_KEY_ESCAPE) {
        kg_editor_say(e, KG_WARNING, "%s", "");
        if (!working)
            t->way = KG_WAY_DRAG;
        kg_fold_drop(e);
        return true;
    }
    if (working && t->given && type_angle(e, t, event->key))
        return true;
    if (working && event->key == KG_KEY_BACKSPACE) {
        step_back(e, t);
        return true;
    }
    if (t->phase == KG_PHASE_HELD &&
        (event->key == KG_KEY_ENTER || event->key == KG_KEY_PAD_ENTER)) {
        finish(e, t, false);
        return true;
    }
    if (!working && t->way == KG_WAY_DRAG && t->vertex >= 0 && event->key >= '0' &&
        event->key <= '9') {
        kg_fold_set_layers(e, event->key == '0' ? KG_ALL_LAYERS : event->key - '0');
        return true;
    }
    return false;
}

static bool on_event(kg_editor *e, const kg_event *event) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t)
        return false;
    switch (event->type) {
    case KG_EVENT_MOVE:
        if (t->phase == KG_PHASE_READY && !kg_sheets_can_fold(e))
            kg_sheets_of(e)->hover_vertex = kg_sheets_of(e)->hover_edge = -1;
        else
            follow(e, t, event->position);
        return true;
    case KG_EVENT_PRESS:
        if (event->button != KG_MOUSE_LEFT)
            return false;
        press(e, t, event);
        return true;
    case KG_EVENT_RELEASE:
        if (event->button == KG_MOUSE_LEFT)
            release(e, t, event);
        else if (event->button == KG_MOUSE_RIGHT && t->phase == KG_PHASE_READY)
            e->request = KG_REQUEST_MENU;
        return true;
    case KG_EVENT_WHEEL:
        return wheel(e, t, event);
    case KG_EVENT_KEY:
        return on_key(e, t, event);
    default:
        return false;
    }
}

/* ---- words ------------------------------------------------------------------------------- */

static const char *hint_now(const kg_editor *e) {
    static const char *const ready[KG_WAY_COUNT] = {
        N_("Drag a corner to where it goes   Click it: another layer   V: mountain or valley   "
           "A: by an axis   B: edge onto edge   R: right angle"),
        N_("Click an edge to fold along, or the first of two points   Shift: a point on an edge   "
           "Esc: back"),
        N_("Click the edge that moves   Esc: back"),
        N_("Click the edge that the fold is at right angles to   Esc: back"),
    };
    static const char *const second[KG_WAY_COUNT] = {
        "",
        N_("Click the second point of the axis   Ctrl: steps   Alt: free   Backspace: back"),
        N_("Click the edge that it comes to lie on   numbers: angle   Shift: look first"),
        N_("Click the point that the fold goes through   Ctrl: steps   Alt: free"),
    };
    const kg_fold_tool *t = kg_fold_tool_seen(e);
    if (t && t->given && t->refused)
        return t->reason;
    switch (t ? t->phase : KG_PHASE_READY) {
    case KG_PHASE_DRAGGING:
        return _("Let go to fold   numbers: angle   wheel: layers   Shift+wheel: between   Ctrl: "
                 "steps   Alt: free   Shift: look first");
    case KG_PHASE_SECOND:
        return _(second[t->way]);
    case KG_PHASE_SIDE:
        return _("Click the corner or the side that moves   numbers: angle   wheel: layers   "
                 "Shift: look first");
    case KG_PHASE_HELD:
        return _("Enter: fold   numbers: angle   Page Up, Page Down: layers   Esc: no fold");
    default:
        return _(ready[t ? t->way : KG_WAY_DRAG]);
    }
}

static void end(kg_editor *e) {
    kg_fold_tool *t = e->tool_state;
    if (!t)
        return;
    kg_fold_forget(t);
    free(t->pile);
    if (kg_editor_is(e, KG_DOCUMENT_ORIGAMI) && e->mode_state)
        kg_sheets_unmark(e);
}

const kg_tool kg_tool_fold = {
    "fold", N_("Fold"), N_("Drag a corner to where it goes"), on_event, kg_fold_draw, hint_now, end,
};
