#include "app/aim.h"

/* Strips between rulings are flat to a pixel; the nearest point of the surface makes up for the
 * rest. */
enum { STRIP_COUNT = 96 };

/* Möller and Trumbore (1997); a + s (b - a) + r (c - a). */
static bool meets(kg_vec3 o, kg_vec3 d, kg_vec3 a, kg_vec3 b, kg_vec3 c, double *t, double *s,
                  double *r) {
    kg_vec3 ab = kg_sub(b, a), ac = kg_sub(c, a), p = kg_cross(d, ac), ao = kg_sub(o, a);
    double det = kg_dot(ab, p);
    if (det == 0)
        return false;
    kg_vec3 q = kg_cross(ao, ab);
    *s = kg_dot(ao, p) / det;
    *r = kg_dot(d, q) / det;
    *t = kg_dot(ac, q) / det;
    return *s >= 0 && *r >= 0 && *s + *r <= 1 && *t > 0;
}

bool kg_patch_aim(const kg_patch *patch, kg_vec3 o, kg_vec3 d, kg_vec2 *out_uv) {
    double nearest = (double)INFINITY, lo = patch->extent[0], hi = patch->extent[1];
    kg_vec3 a = kg_patch_point(patch, lo, 0), b = kg_patch_point(patch, hi, 0);
    for (int i = 0; i < STRIP_COUNT; i++) {
        double v = (double)i / STRIP_COUNT, w = (double)(i + 1) / STRIP_COUNT, t, s, r;
        kg_vec3 c = kg_patch_point(patch, lo, w), e = kg_patch_point(patch, hi, w);
        if (meets(o, d, a, b, c, &t, &s, &r) && t < nearest) {
            nearest = t;
            *out_uv = kg_v2(lo + s * (hi - lo), v + r * (w - v));
        }
        if (meets(o, d, e, c, b, &t, &s, &r) && t < nearest) {
            nearest = t;
            *out_uv = kg_v2(hi + s * (lo - hi), w + r * (v - w));
        }
        a = c;
        b = e;
    }
    if (!isfinite(nearest))
        return false;
    kg_patch_closest(patch, kg_madd(o, nearest, d), &out_uv->x, &out_uv->y);
    return true;
}
