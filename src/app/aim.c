#include "app/aim.h"

/* Strips between rulings are flat to a pixel; the nearest point of the surface makes up for the
 * rest. */
enum { STRIP_COUNT = 96 };

/* Möller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997). */
bool kg_ray_meets(const kg_ray *ray, const kg_vec3 triangle[3], double *out_t, double *out_s,
                  double *out_r) {
    kg_vec3 ab = kg_sub(triangle[1], triangle[0]), ac = kg_sub(triangle[2], triangle[0]);
    kg_vec3 p = kg_cross(ray->direction, ac), ao = kg_sub(ray->origin, triangle[0]);
    double det = kg_dot(ab, p);
    if (det == 0)
        return false;
    kg_vec3 q = kg_cross(ao, ab);
    *out_s = kg_dot(ao, p) / det;
    *out_r = kg_dot(ray->direction, q) / det;
    *out_t = kg_dot(ac, q) / det;
    return *out_s >= 0 && *out_r >= 0 && *out_s + *out_r <= 1 && *out_t > 0;
}

bool kg_patch_aim(const kg_patch *patch, kg_vec3 o, kg_vec3 d, kg_vec2 *out_uv) {
    const kg_ray ray = {o, d};
    double nearest = (double)INFINITY, lo = patch->extent[0], hi = patch->extent[1];
    kg_vec3 a = kg_patch_point(patch, lo, 0), b = kg_patch_point(patch, hi, 0);
    for (int i = 0; i < STRIP_COUNT; i++) {
        double v = (double)i / STRIP_COUNT, w = (double)(i + 1) / STRIP_COUNT, t, s, r;
        kg_vec3 c = kg_patch_point(patch, lo, w), e = kg_patch_point(patch, hi, w);
        if (kg_ray_meets(&ray, (const kg_vec3[]){a, b, c}, &t, &s, &r) && t < nearest) {
            nearest = t;
            *out_uv = kg_v2(lo + s * (hi - lo), v + r * (w - v));
        }
        if (kg_ray_meets(&ray, (const kg_vec3[]){e, c, b}, &t, &s, &r) && t < nearest) {
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

bool kg_patch_aim_px(const kg_patch *patch, const kg_pane *pane, kg_vec2 px, kg_vec2 *out_uv) {
    const double lo = patch->extent[0], hi = patch->extent[1];
    const kg_vec2 corners[] = {{lo, 0}, {hi, 0}, {hi, 1}, {lo, 1}, {lo, 0}};
    kg_vec3 origin, direction;
    kg_pane_ray(pane, px, &origin, &direction);
    if (kg_patch_aim(patch, origin, direction, out_uv))
        return true;
    double nearest = (double)INFINITY;
    for (int k = 0; k < 4 * STRIP_COUNT; k++) {
        const kg_vec2 *side = &corners[k / STRIP_COUNT];
        kg_vec2 ends[2], shown[2];
        bool seen = true;
        for (int i = 0; i < 2 && seen; i++) {
            ends[i] = kg_lerp2(side[0], side[1], (double)(k % STRIP_COUNT + i) / STRIP_COUNT);
            seen = kg_pane_project(pane, kg_patch_point(patch, ends[i].x, ends[i].y), &shown[i]);
        }
        double fraction, distance;
        if (!seen || (distance = kg_segment_distance(px, shown[0], shown[1], &fraction)) >= nearest)
            continue;
        nearest = distance;
        *out_uv = kg_lerp2(ends[0], ends[1], fraction);
    }
    return isfinite(nearest);
}
