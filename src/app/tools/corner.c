#include "app/tools/corner.h"

#include "app/aim.h"
#include "app/text.h"

#include <stdlib.h>
#include <string.h>

enum { GRAB_DISTANCE = 8, EDGE_SAMPLES = 64 };

/* The patch whose corners are shown, and its geometry; NULL: none. */
static const kg_model_patch *with_corners(const kg_editor *e, const kg_patch **out_patch) {
    if (e->level != KG_LEVEL_POINTS || e->selection.patches.count != 1)
        return NULL;
    int64_t id = e->selection.patches.items[0];
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), id);
    if (!p || p->hidden || !s || !s->prepared)
        return NULL;
    *out_patch = &s->patch;
    return p;
}

kg_corner kg_corner_under(const kg_editor *e, kg_vec2 px) {
    const kg_patch *patch;
    const kg_model_patch *p = with_corners(e, &patch);
    kg_corner best = {0};
    double nearest = GRAB_DISTANCE * e->pane.scale;
    for (size_t n = 0; p && n < p->trim_count; n++)
        for (size_t i = 0; i < p->trims[n].contour_count; i++) {
            kg_vec2 uv = p->trims[n].contour[i], at;
            if (!kg_pane_project(&e->pane, kg_patch_point(patch, uv.x, uv.y), &at) ||
                kg_dist2(at, px) >= nearest)
                continue;
            nearest = kg_dist2(at, px);
            best = (kg_corner){p->id, n, i};
        }
    return best;
}

void kg_corner_move(kg_editor *e, kg_corner c, kg_vec2 px) {
    kg_model_patch *p = kg_model_find(kg_editor_model(e), c.patch);
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), c.patch);
    kg_vec2 uv;
    if (!p || !s || !s->prepared || c.trim >= p->trim_count ||
        c.corner >= p->trims[c.trim].contour_count ||
        !kg_patch_aim_px(&s->patch, &e->pane, px, &uv))
        return;
    p->trims[c.trim].contour[c.corner] = uv;
    kg_editor_touch(e);
}

/* The edge under a pixel, `corner` being its first corner, and the place on it, (u, v). */
static kg_corner edge_under(const kg_editor *e, kg_vec2 px, kg_vec2 *out_uv) {
    const kg_patch *patch;
    const kg_model_patch *p = with_corners(e, &patch);
    kg_corner best = {0};
    double nearest = GRAB_DISTANCE * e->pane.scale;
    for (size_t n = 0; p && n < p->trim_count; n++)
        for (size_t i = 0; i < p->trims[n].contour_count; i++) {
            const kg_trim_op *op = &p->trims[n];
            kg_vec2 a = op->contour[i], b = op->contour[(i + 1) % op->contour_count], at;
            for (int k = 1; k < EDGE_SAMPLES; k++) {
                kg_vec2 uv = kg_lerp2(a, b, (double)k / EDGE_SAMPLES);
                if (!kg_pane_project(&e->pane, kg_patch_point(patch, uv.x, uv.y), &at) ||
                    kg_dist2(at, px) >= nearest)
                    continue;
                nearest = kg_dist2(at, px);
                best = (kg_corner){p->id, n, i};
                *out_uv = uv;
            }
        }
    return best;
}

kg_corner kg_corner_insert(kg_editor *e, kg_vec2 px) {
    kg_vec2 uv = {0, 0};
    kg_corner at = edge_under(e, px, &uv);
    if (!at.patch || kg_editor_begin(e, N_("Add corner"), NULL))
        return (kg_corner){0};
    kg_trim_op *op = &kg_model_find(kg_editor_model(e), at.patch)->trims[at.trim];
    kg_vec2 *more = realloc(op->contour, (op->contour_count + 1) * sizeof *more);
    if (!more)
        return (kg_corner){0};
    op->contour = more;
    at.corner++;
    memmove(more + at.corner + 1, more + at.corner, (op->contour_count - at.corner) * sizeof *more);
    more[at.corner] = uv;
    op->contour_count++;
    kg_editor_touch(e);
    return at;
}

void kg_corner_remove(kg_editor *e, kg_corner c) {
    kg_trim_op *op = &kg_model_find(kg_editor_model(e), c.patch)->trims[c.trim];
    if (op->contour_count <= 3 || kg_editor_begin(e, N_("Remove corner"), NULL))
        return;
    op->contour_count--;
    memmove(op->contour + c.corner, op->contour + c.corner + 1,
            (op->contour_count - c.corner) * sizeof *op->contour);
    kg_editor_touch(e);
    kg_editor_commit(e);
}

void kg_corners_draw(const kg_editor *e, kg_overlay *overlay) {
    const kg_patch *patch;
    const kg_model_patch *p = with_corners(e, &patch);
    kg_corner under = kg_corner_under(e, e->pointer);
    for (size_t n = 0; p && n < p->trim_count; n++)
        for (size_t i = 0; i < p->trims[n].contour_count; i++) {
            kg_vec2 uv = p->trims[n].contour[i];
            kg_vec3 at = kg_patch_point(patch, uv.x, uv.y);
            bool hovered = under.patch && under.trim == n && under.corner == i;
            kg_style style = kg_style_default(hovered ? (kg_color){1, 0.82F, 0.1F, 1}
                                                      : (kg_color){0.35F, 0.85F, 0.75F, 1});
            style.size_px = hovered ? 10 : 7;
            style.hidden = 0.5F;
            kg_overlay_points(overlay, &at, 1, style);
        }
}
