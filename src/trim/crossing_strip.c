#include "trim/crossing.h"

#include "base/array.h"
#include "curve/bernstein.h"

#include <stdlib.h>

/* The domain reaches this far beyond [0,1], so that curves along a side or through a corner lie
 * inside it; all unequal, so that those on a diagonal miss its corners. */
static const double reach[2][2] = {{0.7e-6, 0.9e-6}, {1.1e-6, 1.5e-6}};

/* Strips are not cut in the middle, where symmetric models have their special points, and the two
 * of a pair at different places, so that the diagonals are not special either. */
static const double cuts[2] = {0.4921, 0.5173};

static kg_vec3 coefficient(const kg_strip *s, int k, int i) {
    return kg_v3(s->c[k][i], s->c[k + 1][i], s->c[k + 2][i]);
}

/* The range of a · X over the strip. */
static void range(const kg_strips *set, const kg_strip *s, kg_vec3 a, double out[2]) {
    double p[2] = {INFINITY, -INFINITY}, d[2] = {INFINITY, -INFINITY};
    for (int i = 0; i <= set->ruled.patch->geodesic.degree; i++) {
        double x = kg_dot(a, s->p[i]);
        p[0] = kg_min(p[0], x), p[1] = kg_max(p[1], x);
    }
    int n = set->ruled.patch->ruling_degree == 0 ? 0 : set->ruled.degree;
    for (int i = 0; i <= n; i++) {
        double x = kg_dot(a, s->d[i]);
        d[0] = kg_min(d[0], x), d[1] = kg_max(d[1], x);
    }
    d[0] *= d[0] < 0 ? s->widen : 1;
    d[1] *= d[1] > 0 ? s->widen : 1;
    const double *u = set->ruled.patch->extent;
    out[0] = p[0] + kg_min(kg_min(u[0] * d[0], u[0] * d[1]), kg_min(u[1] * d[0], u[1] * d[1]));
    out[1] = p[1] + kg_max(kg_max(u[0] * d[0], u[0] * d[1]), kg_max(u[1] * d[0], u[1] * d[1]));
}

/* Unit vectors d_i = R_i/|R_i| hold every unit ruling in their cone; with m their mean direction,
 * a convex mixture of them is at least min d_i · m long. */
static void measure(const kg_strips *set, kg_strip *s) {
    int n = set->ruled.degree;
    for (int k = 0; k < 6; k++) {
        s->largest[k] = 0;
        for (int i = 0; i <= n; i++)
            s->largest[k] = kg_max(s->largest[k], fabs(s->c[k][i]));
    }
    if (s->depth > KG_STRIP_DEPTH)
        return;
    if (set->ruled.patch->ruling_degree == 0) {
        s->d[0] = kg_unit(coefficient(s, 0, 0));
        s->widen = 1;
    } else {
        kg_vec3 mean = kg_v3(0, 0, 0);
        for (int i = 0; i <= n; i++) {
            s->d[i] = kg_unit(coefficient(s, 0, i));
            mean = kg_add(mean, s->d[i]);
        }
        mean = kg_unit(mean);
        double least = 1;
        for (int i = 0; i <= n; i++)
            least = kg_min(least, kg_dot(s->d[i], mean));
        s->widen = least > 1e-3 ? 1 / least : HUGE_VAL;
    }
    int m = set->ruled.patch->geodesic.degree;
    if (isinf(s->widen)) {
        /* a fan of more than a half-turn: every direction */
        double u = kg_max(fabs(set->ruled.patch->extent[0]), fabs(set->ruled.patch->extent[1]));
        s->box = kg_box3_empty();
        for (int i = 0; i <= m; i++) {
            kg_box3_add(&s->box, kg_sub(s->p[i], kg_v3(u, u, u)));
            kg_box3_add(&s->box, kg_add(s->p[i], kg_v3(u, u, u)));
        }
        return;
    }
    double x[2], y[2], z[2];
    range(set, s, kg_v3(1, 0, 0), x);
    range(set, s, kg_v3(0, 1, 0), y);
    range(set, s, kg_v3(0, 0, 1), z);
    s->box.lo = kg_v3(x[0], y[0], z[0]);
    s->box.hi = kg_v3(x[1], y[1], z[1]);
    s->normal = kg_unit(kg_cross(s->d[0], kg_sub(s->p[m], s->p[0])));
    range(set, s, s->normal, s->along_normal);
}

bool kg_strips_apart(const kg_strips *a, int i, const kg_strips *b, int j) {
    const kg_strip *s = &a->items[i], *t = &b->items[j];
    if (s->depth > KG_STRIP_DEPTH)
        return false;
    double gap = 1e-9 * a->ruled.size; /* mm: touching strips are together */
    if (s->box.lo.x > t->box.hi.x + gap || t->box.lo.x > s->box.hi.x + gap ||
        s->box.lo.y > t->box.hi.y + gap || t->box.lo.y > s->box.hi.y + gap ||
        s->box.lo.z > t->box.hi.z + gap || t->box.lo.z > s->box.hi.z + gap)
        return true;
    if (isinf(s->widen) || isinf(t->widen))
        return false;
    double r[2];
    range(b, t, s->normal, r);
    if (r[0] > s->along_normal[1] + gap || r[1] < s->along_normal[0] - gap)
        return true;
    range(a, s, t->normal, r);
    return r[0] > t->along_normal[1] + gap || r[1] < t->along_normal[0] - gap;
}

/* De Casteljau's scheme beyond both ends of [0,1] (kg_bernstein_restrict3 only goes inside). */
static void extend(kg_vec3 *a, int n, double lo, double hi) {
    for (int k = 1; k <= n; k++)
        for (int i = n; i >= k; i--)
            a[i] = kg_lerp(a[i - 1], a[i], hi);
    for (int k = 1; k <= n; k++)
        for (int i = 0; i <= n - k; i++)
            a[i] = kg_lerp(a[i], a[i + 1], lo / hi);
}

/* One root of a tree: Plücker coefficients with the origin moved, on the reach of the domain. */
static void plant(const kg_ruled *ruled, const double beyond[2], kg_strip *s) {
    const kg_patch *patch = ruled->patch;
    kg_vec3 r[KG_PLUCKER_MAX], moment[KG_PLUCKER_MAX];
    int m = patch->geodesic.degree, n = ruled->degree;
    for (int i = 0; i <= m; i++)
        s->p[i] = ruled->p[i];
    kg_bernstein_cross(patch->rulings, patch->ruling_degree, s->p, m, moment);
    kg_bernstein_elevate3(patch->rulings, patch->ruling_degree, n, r);
    s->lo = -beyond[0], s->hi = 1 + beyond[1];
    extend(r, n, s->lo, s->hi);
    extend(moment, n, s->lo, s->hi);
    extend(s->p, m, s->lo, s->hi);
    for (int i = 0; i <= n; i++) {
        s->c[0][i] = r[i].x, s->c[1][i] = r[i].y, s->c[2][i] = r[i].z;
        s->c[3][i] = moment[i].x, s->c[4][i] = moment[i].y, s->c[5][i] = moment[i].z;
    }
}

bool kg_strips_init(kg_strips *strips, const kg_patch *patch, int which, kg_vec3 origin,
                    double size) {
    kg_strips set = {.cut = cuts[which], .ruled = {.patch = patch, .origin = origin, .size = size}};
    set.ruled.degree = patch->ruling_degree + patch->geodesic.degree;
    for (int i = 0; i <= patch->geodesic.degree; i++)
        set.ruled.p[i] = kg_sub(patch->geodesic.points[i], origin);
    if (!kg_reserve(&set, 24))
        return false;
    kg_strip *s = &set.items[0];
    set.count = 1;
    s->child[0] = s->child[1] = -1;
    s->depth = 0;
    plant(&set.ruled, reach[which], s);
    measure(&set, s);
    *strips = set;
    return true;
}

void kg_strips_clear(kg_strips *strips) {
    free(strips->items);
    strips->items = NULL;
}

bool kg_strips_split(kg_strips *strips, int index) {
    if (strips->items[index].child[0] >= 0)
        return true;
    if (!kg_reserve(strips, strips->count + 2))
        return false;
    kg_strip *s = &strips->items[index];
    kg_strip *lo = &strips->items[strips->count], *hi = lo + 1;
    s->child[0] = (int)strips->count;
    s->child[1] = (int)strips->count + 1;
    strips->count += 2;
    double cut = strips->cut;
    lo->lo = s->lo, hi->hi = s->hi;
    lo->hi = hi->lo = s->lo + cut * (s->hi - s->lo);
    lo->depth = hi->depth = s->depth + 1;
    lo->child[0] = lo->child[1] = hi->child[0] = hi->child[1] = -1;
    int n = strips->ruled.degree, m = strips->ruled.patch->geodesic.degree;
    for (int k = 0; k < 6; k++) {
        double *h = hi->c[k], *l = lo->c[k];
        for (int i = 0; i <= n; i++)
            h[i] = s->c[k][i];
        l[0] = h[0];
        for (int j = 1; j <= n; j++) {
            for (int i = 0; i <= n - j; i++)
                h[i] += cut * (h[i + 1] - h[i]);
            l[j] = h[0];
        }
    }
    for (int i = 0; i <= m; i++)
        hi->p[i] = s->p[i];
    lo->p[0] = hi->p[0];
    for (int j = 1; j <= m; j++) {
        for (int i = 0; i <= m - j; i++)
            hi->p[i] = kg_lerp(hi->p[i], hi->p[i + 1], cut);
        lo->p[j] = hi->p[0];
    }
    measure(strips, lo);
    measure(strips, hi);
    return true;
}
