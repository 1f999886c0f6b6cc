/* The point of a patch nearest to a given one. */
#include "patch/minimum.h"
#include "patch/prepare.h"

enum { SCAN = KG_PATCH_SCAN };

/* The best of the candidates so far. */
typedef struct nearest {
    double d2, u, v;
} nearest;

static double clamp(double x, double lo, double hi) {
    return fmin(fmax(x, lo), hi);
}

/* Squared distance from `point` to the ruling segment at v. */
static double ruling_distance2(const kg_patch *patch, kg_vec3 point, double v, double *out_u) {
    kg_vec3 d, p = kg_patch_line(patch, v, &d);
    double u = clamp(kg_dot(kg_sub(point, p), d), patch->extent[0], patch->extent[1]);
    kg_vec3 gap = kg_sub(kg_madd(p, u, d), point);
    *out_u = u;
    return kg_dot(gap, gap);
}

/* Keeps v if its ruling comes nearer. */
static void offer(const kg_patch *patch, kg_vec3 point, double v, nearest *best) {
    double u, d2 = ruling_distance2(patch, point, v, &u);
    if (d2 < best->d2)
        *best = (nearest){d2, u, v};
}

typedef struct search {
    const kg_patch *patch;
    kg_vec3 point;
} search;

static double distance2_at(void *user, double v) {
    const search *s = user;
    double unused;
    return ruling_distance2(s->patch, s->point, v, &unused);
}

/* A search by values alone goes to this width of v; Gauss-Newton goes on from there. */
#define NARROW 1e-6

static void descend(const kg_patch *patch, kg_vec3 point, double lo, double hi, nearest *best) {
    double v;
    kg_minimum(distance2_at, &(search){patch, point}, lo, hi, NARROW, &v);
    /* the foot of the perpendicular in the tangent plane, along the ruling's normal in it */
    nearest at = {INFINITY, 0, 0};
    offer(patch, point, v, &at);
    for (int i = 0; i < 8; i++) {
        kg_vec3 du, dv, x = kg_patch_derivatives(patch, at.u, at.v, &du, &dv);
        kg_vec3 across = kg_madd(dv, -kg_dot(dv, du), du);
        double step = kg_dot(kg_sub(point, x), across) / kg_dot(across, across);
        nearest next = at;
        offer(patch, point, clamp(at.v + step, 0, 1), &next);
        if (!(next.d2 < at.d2))
            break;
        at = next;
    }
    if (at.d2 < best->d2)
        *best = at;
}

double kg_patch_closest(const kg_patch *patch, kg_vec3 point, double *out_u, double *out_v) {
    double d2[SCAN + 1], u;
    for (int i = 0; i <= SCAN; i++)
        d2[i] = ruling_distance2(patch, point, (double)i / SCAN, &u);
    nearest best = {INFINITY, 0, 0};
    for (int i = 0; i <= SCAN; i++) {
        if ((i > 0 && d2[i - 1] < d2[i]) || (i < SCAN && d2[i + 1] < d2[i]))
            continue;
        offer(patch, point, (double)i / SCAN, &best); /* minima at v = 0 and 1 */
        descend(patch, point, fmax(0, (i - 1.0) / SCAN), fmin(1, (i + 1.0) / SCAN), &best);
    }
    *out_u = best.u;
    *out_v = best.v;
    return sqrt(best.d2);
}
