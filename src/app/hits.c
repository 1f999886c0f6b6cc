/* Which patches are under the pointer. */
#include "app/editor.h"

/* A sheet seen edge-on is a line, which nobody hits exactly; layout units. */
enum { OUTLINE_DISTANCE = 5 };

/* Where the outline of a patch passes nearest to a pixel; true when that is near. */
static bool outline_hit(const kg_editor *e, int64_t patch, kg_vec2 px, kg_hit *out) {
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), patch);
    double nearest = OUTLINE_DISTANCE * e->pane.scale;
    kg_vec3 eye, direction;
    kg_pane_ray(&e->pane, px, &eye, &direction);
    *out = (kg_hit){0};
    for (size_t i = 0; s && s->valid && i < s->regions.count; i++) {
        const kg_region_loop *loop = &s->regions.items[i].loops[0];
        kg_vec2 from = {0, 0}, to = from;
        bool seen = false, sees;
        for (size_t k = 0; loop->point_count > 0 && k <= loop->point_count;
             k++, from = to, seen = sees) {
            kg_vec3 b = loop->points[k % loop->point_count].x;
            sees = kg_pane_project(&e->pane, b, &to);
            double f = 0,
                   distance = seen && sees ? kg_segment_distance(px, from, to, &f) : HUGE_VAL;
            if (distance >= nearest)
                continue;
            nearest = distance;
            kg_vec3 place = kg_lerp(loop->points[k - 1].x, b, f);
            *out = (kg_hit){kg_dist(eye, place), patch, i, place};
        }
    }
    return out->patch != 0;
}

static bool surface_hit(const kg_editor *e, int64_t patch, kg_vec2 px, kg_hit *out) {
    const kg_patch_surface *surface = kg_surfaces_find(&e->surfaces, patch);
    kg_vec3 origin, direction;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    return surface && kg_surface_hit(surface, origin, direction, out);
}

size_t kg_editor_hits(const kg_editor *e, kg_vec2 px, kg_hit *out_hits, size_t most) {
    enum { MOST_OUTLINES = 16 };
    const kg_model *m = kg_editor_model(e);
    kg_hit hit, outlines[MOST_OUTLINES];
    size_t count = 0, near = 0;
    for (size_t i = 0; i < m->patch_count; i++) {
        int64_t id = m->patches[i].id;
        if (m->patches[i].hidden)
            continue;
        if (surface_hit(e, id, px, &hit))
            count = kg_hits_keep(out_hits, count, most, &hit, sizeof hit);
        else if (outline_hit(e, id, px, &hit))
            near = kg_hits_keep(outlines, near, MOST_OUTLINES, &hit, sizeof hit);
    }
    for (size_t i = 0; i < near && count < most; i++)
        out_hits[count++] = outlines[i];
    return count;
}
