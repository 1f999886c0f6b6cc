#include "model/border.h"

bool kg_loop_near(const kg_patch *patch, const kg_region_loop *loop, size_t first, size_t count,
                  double u, double v, double near) {
    double scale = patch->length_at[KG_PATCH_CELLS];
    kg_vec2 at = kg_v2(u, v * scale);
    const kg_cross_point *p = &loop->points[first % loop->point_count];
    kg_vec2 a = kg_v2(p->u, p->v * scale);
    for (size_t i = 1; i <= count; i++) {
        p = &loop->points[(first + i) % loop->point_count];
        kg_vec2 b = kg_v2(p->u, p->v * scale);
        bool far = at.x < fmin(a.x, b.x) - near || at.x > fmax(a.x, b.x) + near ||
                   at.y < fmin(a.y, b.y) - near || at.y > fmax(a.y, b.y) + near;
        if (!far) {
            kg_vec2 d = kg_sub2(b, a);
            double n = kg_dot2(d, d), f = n > 0 ? kg_dot2(kg_sub2(at, a), d) / n : 0;
            if (kg_dist2(at, kg_lerp2(a, b, fmin(fmax(f, 0), 1))) <= near)
                return true;
        }
        a = b;
    }
    return false;
}
