#include "model/border.h"

#include "trim/chain.h"

static double distance(kg_vec2 at, kg_vec2 a, kg_vec2 b) {
    return kg_dist2(at, kg_lerp2(a, b, kg_nearest_fraction(at, a, b)));
}

bool kg_edge_near(const kg_patch *patch, const kg_region_loop *loop, const kg_region_edge *edge,
                  bool of_cutter, double u, double v, double near) {
    double scale = patch->length_at[KG_PATCH_CELLS];
    kg_vec2 at = kg_v2(u, v * scale), before = at;
    for (size_t i = 0; i <= edge->count; i++) {
        size_t k = edge->first + i;
        const kg_cross_point *p = i == edge->count ? &loop->ends[edge - loop->edges]
                                                   : &loop->points[k % loop->point_count];
        kg_vec2 q = of_cutter ? kg_v2(p->s, p->t * scale) : kg_v2(p->u, p->v * scale);
        bool far = at.x < kg_min(before.x, q.x) - near || at.x > kg_max(before.x, q.x) + near ||
                   at.y < kg_min(before.y, q.y) - near || at.y > kg_max(before.y, q.y) + near;
        if (i > 0 && !far && distance(at, before, q) <= near)
            return true;
        before = q;
    }
    return false;
}

bool kg_loop_near(const kg_patch *patch, const kg_region_loop *loop, double u, double v,
                  double near) {
    for (size_t i = 0; i < loop->edge_count; i++)
        if (kg_edge_near(patch, loop, &loop->edges[i], false, u, v, near))
            return true;
    return false;
}
