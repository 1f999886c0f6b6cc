#include "origami/convex.h"

/* Some side of p has all of q on its outside, or less than `tolerance` deep inside. Sides shorter
 * than that, left over from cuts through a corner, have no direction to speak of. */
static bool side_separates(const kg_vec2 *p, size_t p_count, const kg_vec2 *q, size_t q_count,
                           double tolerance) {
    for (size_t i = 0; i < p_count; i++) {
        kg_vec2 a = p[i], d = kg_sub2(p[i + 1 < p_count ? i + 1 : 0], a);
        double limit = tolerance * tolerance * kg_dot2(d, d), depth;
        size_t k = 0;
        if (limit <= tolerance * tolerance * tolerance * tolerance)
            continue;
        while (k < q_count &&
               ((depth = kg_cross2(d, kg_sub2(q[k], a))) <= 0 || depth * depth <= limit))
            k++;
        if (k == q_count)
            return true;
    }
    return false;
}

bool kg_convex_overlap(const kg_vec2 *p, size_t p_count, const kg_vec2 *q, size_t q_count,
                       double tolerance) {
    return !side_separates(p, p_count, q, q_count, tolerance) &&
           !side_separates(q, q_count, p, p_count, tolerance);
}

bool kg_convex_holds(const kg_vec2 *p, size_t p_count, kg_vec2 point, double tolerance) {
    for (size_t i = 0; i < p_count; i++) {
        kg_vec2 a = p[i], d = kg_sub2(p[i + 1 < p_count ? i + 1 : 0], a);
        double depth = kg_cross2(d, kg_sub2(point, a));
        if (depth <= 0 || depth * depth <= tolerance * tolerance * kg_dot2(d, d))
            return false;
    }
    return true;
}

size_t kg_convex_clip(const kg_vec2 *p, size_t p_count, kg_vec2 m, double offset, kg_vec2 *out) {
    size_t n = 0;
    for (size_t i = 0; i < p_count; i++) {
        kg_vec2 a = p[i], b = p[i + 1 < p_count ? i + 1 : 0];
        double da = kg_dot2(m, a) - offset, db = kg_dot2(m, b) - offset;
        if (da >= 0)
            out[n++] = a;
        if ((da > 0 && db < 0) || (da < 0 && db > 0))
            out[n++] = kg_lerp2(a, b, da / (da - db));
        if (n > p_count) /* rounding may make a thin polygon look concave */
            break;
    }
    return n < 3 ? 0 : n;
}

size_t kg_convex_common(const kg_vec2 *p, size_t p_count, const kg_vec2 *q, size_t q_count,
                        kg_vec2 *out, kg_vec2 *scratch) {
    size_t n = p_count;
    for (size_t i = 0; i < n; i++)
        out[i] = p[i];
    for (size_t i = 0; i < q_count && n > 0; i++) {
        kg_vec2 a = q[i], d = kg_sub2(q[i + 1 < q_count ? i + 1 : 0], a), m = kg_v2(-d.y, d.x);
        size_t clipped = kg_convex_clip(out, n, m, kg_dot2(m, a), scratch);
        for (size_t k = 0; k < clipped; k++)
            out[k] = scratch[k];
        n = clipped;
    }
    return n;
}

double kg_polygon_area(const kg_vec2 *p, size_t count) {
    double twice = 0;
    for (size_t i = 1; i + 1 < count; i++)
        twice += kg_cross2(kg_sub2(p[i], p[0]), kg_sub2(p[i + 1], p[0]));
    return twice / 2;
}

void kg_plane_axes(kg_vec3 n, kg_vec3 *out_u, kg_vec3 *out_v) {
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    kg_vec3 e = x <= y && x <= z ? kg_v3(1, 0, 0) : y <= z ? kg_v3(0, 1, 0) : kg_v3(0, 0, 1);
    *out_u = kg_unit(kg_madd(e, -kg_dot(e, n), n));
    *out_v = kg_cross(n, *out_u);
}
