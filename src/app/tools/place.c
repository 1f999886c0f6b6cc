/* Placing: clicks on the reference (or the view plane) make the control points of a new patch. */
#include "app/text.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"
#include "model/edit.h"

#include <stdio.h>
#include <stdlib.h>

enum { POINT_COUNT = 4, SAMPLES = 33 };

/* Half the width of a new patch over its length. */
#define FIRST_EXTENT 0.25

typedef struct state {
    kg_vec3 points[POINT_COUNT]; /* places on the geodesic, the last one under the pointer */
    size_t count;                /* clicked */
    bool aimed;                  /* points[count] is meaningful */
    char hint[160];
} state;

/* The depth of a click comes from the reference, else from the plane that faces the camera through
 * the last point (or the view's center). */
static kg_vec3 place_under(const kg_editor *e, const state *s, kg_vec2 px) {
    kg_vec3 origin, direction;
    kg_mesh_hit hit;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    if (e->backdrop.query && kg_editor_model(e)->reference.visible &&
        kg_mesh_query_ray(e->backdrop.query, origin, direction, &hit)) {
        kg_vec3 n = kg_dot(hit.normal, direction) > 0 ? kg_neg(hit.normal) : hit.normal;
        return kg_madd(hit.point, e->settings.lift, n);
    }
    return kg_pane_on_screen_plane(&e->pane, px,
                                   s->count > 0 ? s->points[s->count - 1] : e->pane.camera.center);
}

/*
 * The cubic that passes through four points at v = 0, v1, v2, 1, spaced by their chords: with
 * B(v) the Bernstein polynomials, two linear equations for the inner control points.
 */
static void interpolate(const kg_vec3 q[POINT_COUNT], kg_vec3 out[POINT_COUNT]) {
    double l[3], sum = 0;
    for (int i = 0; i < 3; i++)
        sum += l[i] = kg_dist(q[i], q[i + 1]);
    double v1 = sum > 0 ? l[0] / sum : 1.0 / 3, v2 = sum > 0 ? (l[0] + l[1]) / sum : 2.0 / 3;
    double w1 = 1 - v1, w2 = 1 - v2;
    kg_vec3 r1 = kg_sub(q[1], kg_add(kg_scale(q[0], w1 * w1 * w1), kg_scale(q[3], v1 * v1 * v1)));
    kg_vec3 r2 = kg_sub(q[2], kg_add(kg_scale(q[0], w2 * w2 * w2), kg_scale(q[3], v2 * v2 * v2)));
    double a = 3 * w1 * w1 * v1, b = 3 * w1 * v1 * v1, c = 3 * w2 * w2 * v2, d = 3 * w2 * v2 * v2;
    double det = a * d - b * c;
    out[0] = q[0];
    out[3] = q[3];
    if (fabs(det) < 1e-9) { /* two clicks at one place */
        out[1] = q[1];
        out[2] = q[2];
        return;
    }
    out[1] = kg_scale(kg_sub(kg_scale(r1, d), kg_scale(r2, b)), 1 / det);
    out[2] = kg_scale(kg_sub(kg_scale(r2, a), kg_scale(r1, c)), 1 / det);
}

/* The patch of the clicks so far, missing ones in place of the last. With three, the geodesic is
 * the parabola through them. */
static bool input_of(const state *s, size_t count, kg_patch_input *out) {
    kg_vec3 q[POINT_COUNT];
    if (count < 3)
        return false;
    for (size_t i = 0; i < POINT_COUNT; i++)
        q[i] = s->points[i < count ? i : count - 1];
    *out = (kg_patch_input){.point_count = POINT_COUNT};
    if (count == 3) {
        double t = kg_dist(q[0], q[1]) / fmax(kg_dist(q[0], q[1]) + kg_dist(q[1], q[2]), 1e-12);
        t = fmin(fmax(t, 0.05), 0.95);
        kg_vec3 middle =
            kg_scale(kg_sub(q[1], kg_add(kg_scale(q[0], (1 - t) * (1 - t)), kg_scale(q[2], t * t))),
                     1 / (2 * t * (1 - t)));
        out->points[0] = q[0];
        out->points[1] = kg_lerp(q[0], middle, 2.0 / 3);
        out->points[2] = kg_lerp(q[2], middle, 2.0 / 3);
        out->points[3] = q[2];
    } else {
        interpolate(q, out->points);
    }
    double length = 0;
    for (size_t i = 1; i < count; i++)
        length += kg_dist(q[i - 1], q[i]);
    out->extent[1] = fmax(FIRST_EXTENT * length, 0.1);
    out->extent[0] = -out->extent[1];
    return true;
}

static void finish(kg_editor *e, const state *s) {
    kg_patch_input input;
    kg_error error;
    int64_t id;
    input_of(s, POINT_COUNT, &input);
    kg_status status = kg_editor_begin(e, N_("New patch"), &error);
    if (!status)
        status = kg_model_add_patch(kg_editor_model(e), &input, NULL, &id, &error);
    kg_editor_touch(e);
    if (!kg_editor_finish(e, status))
        kg_editor_select(e, id, false);
    else
        kg_editor_say(e, KG_FAULT, "%s", error.message);
    kg_editor_use_default(e);
}

static bool on_key(kg_editor *e, state *s, const kg_event *event) {
    if (event->key == KG_KEY_BACKSPACE) {
        s->count -= s->count > 0;
        return true;
    }
    if (event->key == KG_KEY_ESCAPE) {
        kg_editor_use_default(e);
        return true;
    }
    return false;
}

static bool on_event(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    switch (event->type) {
    case KG_EVENT_MOVE:
        s->points[s->count] = place_under(e, s, event->position);
        s->aimed = true;
        return true;
    case KG_EVENT_PRESS:
        if (event->button != KG_MOUSE_LEFT)
            return false;
        s->points[s->count] = place_under(e, s, event->position);
        s->aimed = false;
        if (++s->count == POINT_COUNT)
            finish(e, s);
        return true;
    case KG_EVENT_KEY:
        return on_key(e, s, event);
    default:
        return false;
    }
}

static void draw_preview(const kg_patch *patch, kg_overlay *o) {
    kg_vec3 rows[3][SAMPLES];
    kg_style edge = kg_style_default((kg_color){1, 0.82F, 0.1F, 1}), ruling = edge;
    edge.size_px = 2;
    ruling.size_px = 1;
    edge.hidden = ruling.hidden = 0.4F;
    for (int i = 0; i < SAMPLES; i++) {
        double v = (double)i / (SAMPLES - 1);
        for (int k = 0; k < 3; k++)
            rows[k][i] = kg_patch_point(patch, k == 1 ? 0 : patch->extent[k / 2], v);
        if (i % 4 == 0)
            kg_overlay_line(o, (const kg_vec3[]){rows[0][i], rows[2][i]}, 2, ruling);
    }
    for (int k = 0; k < 3; k++)
        kg_overlay_line(o, rows[k], SAMPLES, edge);
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    const state *s = e->tool_state;
    size_t count = s->count + (s->aimed && s->count < POINT_COUNT);
    kg_style dot = kg_style_default((kg_color){1, 0.82F, 0.1F, 1});
    kg_patch_input input;
    kg_patch patch;
    dot.size_px = 9;
    dot.hidden = 0.6F;
    kg_overlay_points(overlay, s->points, count, dot);
    if (input_of(s, count, &input) && !kg_patch_init(&input, &patch, NULL))
        draw_preview(&patch, overlay);
    else
        kg_overlay_line(overlay, s->points, count, kg_style_default((kg_color){1, 0.82F, 0.1F, 1}));
}

static const char *hint_now(const kg_editor *e) {
    state *s = e->tool_state;
    snprintf(s->hint, sizeof s->hint,
             _("Point %zu of 4: click   Backspace: drop the last   Esc: cancel"), s->count + 1);
    return s->hint;
}

kg_status kg_tool_start_place(kg_editor *e, kg_error *error) {
    state *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_editor_use(e, &kg_tool_place, s);
    return KG_OK;
}

const kg_tool kg_tool_place = {
    "place",
    N_("New patch"),
    N_("Click four points of the strip's middle line"),
    on_event,
    draw,
    hint_now,
    NULL,
};
