#include "app/tools/gizmo.h"

#include "app/tools/tool.h"

/* Layout units. */
enum { ARROW = 78, RING = 58, SQUARE = 7, GRAB = 7, RING_POINTS = 49 };

static const kg_color colors[] = {
    {0.90F, 0.32F, 0.30F, 1}, {0.40F, 0.74F, 0.34F, 1}, {0.32F, 0.57F, 0.95F, 1}};

static kg_vec3 axis_of(int axis) {
    return kg_v3(axis == 0, axis == 1, axis == 2);
}

static bool is_shown(const kg_editor *e, kg_vec3 *out_center) {
    bool points = e->level == KG_LEVEL_POINTS;
    if (e->tool != &kg_tool_select ||
        (points ? e->selection.points.count < 2 : e->selection.patches.count == 0))
        return false;
    *out_center = kg_selection_center(e);
    return true;
}

/* ---- shapes in the window ---------------------------------------------------------------- */

typedef struct shapes {
    kg_vec2 center, tips[3], square;
    kg_vec2 rings[3][RING_POINTS];
    bool in_front[3][RING_POINTS]; /* of the center */
    double scale;
} shapes;

static bool make_shapes(const kg_editor *e, shapes *out) {
    kg_vec3 center, right, up, back;
    if (!is_shown(e, &center) || !kg_pane_project(&e->pane, center, &out->center))
        return false;
    double mm = kg_pane_pixel_mm(&e->pane, center) * e->pane.scale;
    kg_camera_axes(&e->pane.camera, &right, &up, &back);
    out->scale = e->pane.scale;
    bool ok = kg_pane_project(
        &e->pane, kg_madd(kg_madd(center, -0.7 * ARROW * mm, right), -0.7 * ARROW * mm, up),
        &out->square);
    for (int i = 0; i < 3; i++) {
        kg_vec3 a = axis_of((i + 1) % 3), b = axis_of((i + 2) % 3);
        ok =
            ok && kg_pane_project(&e->pane, kg_madd(center, ARROW * mm, axis_of(i)), &out->tips[i]);
        for (int k = 0; k < RING_POINTS && ok; k++) {
            double t = 2 * KG_PI * k / (RING_POINTS - 1);
            kg_vec3 spoke = kg_add(kg_scale(a, cos(t)), kg_scale(b, sin(t)));
            out->in_front[i][k] = kg_dot(spoke, back) > -0.05;
            ok = kg_pane_project(&e->pane, kg_madd(center, RING * mm, spoke), &out->rings[i][k]);
        }
    }
    return ok;
}

kg_gizmo_handle kg_gizmo_under(const kg_editor *e, kg_vec2 px) {
    shapes s;
    kg_gizmo_handle best = {.axis = -1};
    if (!make_shapes(e, &s))
        return best;
    double nearest = GRAB * s.scale;
    for (int i = 0; i < 3; i++) {
        /* the inner part of an arrow belongs to what lies under it */
        kg_vec2 from = kg_lerp2(s.center, s.tips[i], 0.25);
        double d = kg_segment_distance(px, from, s.tips[i], NULL);
        if (d < nearest && kg_dist2(s.center, s.tips[i]) > 2 * GRAB * s.scale) {
            nearest = d;
            best = (kg_gizmo_handle){true, KG_TRANSFORM_MOVE, i};
        }
        for (int k = 1; k < RING_POINTS; k++) {
            if (!s.in_front[i][k] || !s.in_front[i][k - 1])
                continue;
            d = kg_segment_distance(px, s.rings[i][k - 1], s.rings[i][k], NULL);
            if (d < 0.7 * nearest) {
                nearest = d;
                best = (kg_gizmo_handle){true, KG_TRANSFORM_ROTATE, i};
            }
        }
    }
    if (kg_dist2(px, s.square) < 1.5 * SQUARE * s.scale)
        best = (kg_gizmo_handle){true, KG_TRANSFORM_SCALE, -1};
    return best;
}

static void draw_arrow(const shapes *s, int i, kg_color color, double width) {
    kg_vec2 along = kg_sub2(s->tips[i], s->center);
    double length = kg_len2(along);
    if (length < 2 * GRAB * s->scale)
        return;
    along = kg_scale2(along, s->scale / length);
    kg_vec2 across = kg_v2(-along.y, along.x);
    kg_vec2 head[3] = {kg_add2(s->tips[i], kg_scale2(along, 8)),
                       kg_add2(s->tips[i], kg_scale2(across, 5)),
                       kg_sub2(s->tips[i], kg_scale2(across, 5))};
    kg_ui_canvas_line(s->center, s->tips[i], color, width);
    kg_ui_canvas_polygon(head, 3, color);
}

void kg_gizmo_draw(const kg_editor *e) {
    shapes s;
    if (!make_shapes(e, &s))
        return;
    kg_gizmo_handle under = kg_gizmo_under(e, e->pointer);
    kg_color lit = {1, 0.85F, 0.25F, 1};
    for (int i = 0; i < 3; i++) {
        bool on = under.any && under.kind == KG_TRANSFORM_ROTATE && under.axis == i;
        for (int k = 1; k < RING_POINTS; k++)
            if (s.in_front[i][k] && s.in_front[i][k - 1])
                kg_ui_canvas_line(s.rings[i][k - 1], s.rings[i][k], on ? lit : colors[i],
                                  (on ? 3 : 1.5) * s.scale);
    }
    for (int i = 0; i < 3; i++) {
        bool on = under.any && under.kind == KG_TRANSFORM_MOVE && under.axis == i;
        draw_arrow(&s, i, on ? lit : colors[i], (on ? 4 : 2.5) * s.scale);
    }
    bool on = under.any && under.kind == KG_TRANSFORM_SCALE;
    double side = 2 * SQUARE * s.scale;
    kg_ui_canvas_line(s.center, s.square, (kg_color){0.9F, 0.9F, 0.92F, 0.5F}, s.scale);
    kg_ui_canvas_rect((kg_area){s.square.x - side / 2, s.square.y - side / 2, side, side},
                      on ? lit : (kg_color){0.9F, 0.9F, 0.92F, 1}, 2 * s.scale);
}
