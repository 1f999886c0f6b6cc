#include "app/tools/box.h"

#include <stdlib.h>

typedef struct box {
    kg_vec2 lo, hi;
} box;

static bool holds(const box *b, kg_vec2 p) {
    return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y;
}

/* Triangle and box, by the five axes that can part them: the box's and the normals of the edges. */
static bool meets(const box *b, const kg_vec2 t[3]) {
    if (fmax(fmax(t[0].x, t[1].x), t[2].x) < b->lo.x ||
        fmin(fmin(t[0].x, t[1].x), t[2].x) > b->hi.x ||
        fmax(fmax(t[0].y, t[1].y), t[2].y) < b->lo.y ||
        fmin(fmin(t[0].y, t[1].y), t[2].y) > b->hi.y)
        return false;
    kg_vec2 middle = kg_lerp2(b->lo, b->hi, 0.5), half = kg_scale2(kg_sub2(b->hi, b->lo), 0.5);
    for (int i = 0; i < 3; i++) {
        kg_vec2 edge = kg_sub2(t[(i + 1) % 3], t[i]), normal = kg_v2(-edge.y, edge.x);
        double at = kg_dot2(normal, kg_sub2(t[i], middle));
        double other = kg_dot2(normal, kg_sub2(t[(i + 2) % 3], middle));
        double reach = half.x * fabs(normal.x) + half.y * fabs(normal.y);
        if (fmin(at, other) > reach || fmax(at, other) < -reach)
            return false;
    }
    return true;
}

/* What is seen of a patch: does all of it lie in the box, or any of it? */
static bool takes_piece(const kg_editor *e, const kg_tessellation *piece, const box *b,
                        bool touching) {
    kg_vec2 t[3];
    for (size_t i = 0; i < piece->triangle_count; i++) {
        bool seen = true, inside = true;
        for (int k = 0; k < 3; k++) {
            kg_vec3 x = piece->vertices[piece->triangles[3 * i + (size_t)k]].position;
            seen = seen && kg_pane_project(&e->pane, x, &t[k]);
            inside = inside && seen && holds(b, t[k]);
        }
        if (touching && seen && meets(b, t))
            return true;
        if (!touching && !inside)
            return false;
    }
    return !touching;
}

static bool takes_patch(const kg_editor *e, const kg_model_patch *p, const box *b, bool touching) {
    const kg_patch_surface *s = kg_surfaces_find(&e->surfaces, p->id);
    kg_vec2 at;
    for (size_t i = 0; s && i < s->piece_count; i++)
        if (takes_piece(e, &s->pieces[i], b, touching) == touching)
            return touching;
    if (s && s->piece_count > 0)
        return !touching;
    for (size_t i = 0; i < p->input.point_count; i++)
        if ((kg_pane_project(&e->pane, p->input.points[i], &at) && holds(b, at)) == touching)
            return touching;
    return !touching;
}

static void select_points(kg_editor *e, const kg_model_patch *p, const box *b) {
    kg_vec2 at;
    for (size_t i = 0; i < p->input.point_count; i++) {
        kg_point_ref ref = {p->id, i};
        if (kg_pane_project(&e->pane, p->input.points[i], &at) && holds(b, at) &&
            !kg_editor_is_point_selected(e, ref))
            kg_editor_select_point(e, ref, true);
    }
}

void kg_select_in_box(kg_editor *e, kg_vec2 from, kg_vec2 to, bool add) {
    const kg_model *m = kg_editor_model(e);
    box b = {kg_v2(fmin(from.x, to.x), fmin(from.y, to.y)),
             kg_v2(fmax(from.x, to.x), fmax(from.y, to.y))};
    bool points = e->level == KG_LEVEL_POINTS && e->selection.patches.count > 0;
    if (!add && points)
        e->selection.points.count = 0;
    else if (!add)
        kg_editor_select_none(e);
    for (size_t i = 0; i < m->patch_count; i++) {
        const kg_model_patch *p = &m->patches[i];
        if (points && kg_editor_shows_points(e, p->id))
            select_points(e, p, &b);
        else if (!points && !p->hidden && !kg_editor_is_selected(e, p->id) &&
                 takes_patch(e, p, &b, kg_box_touches(from, to)))
            kg_editor_select(e, p->id, true);
    }
}
