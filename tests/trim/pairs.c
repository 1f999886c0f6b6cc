#include "tests/trim/pairs.h"

kg_patch make_patch(const kg_vec3 *points, size_t count, double lo, double hi,
                    const kg_vec3 *ruling) {
    kg_patch_input in = {.point_count = count, .extent = {lo, hi}};
    for (size_t i = 0; i < count; i++)
        in.points[i] = points[i];
    if (ruling) {
        in.has_ruling = true;
        in.ruling = *ruling;
    }
    kg_patch patch;
    kg_error error = {0};
    if (kg_patch_init(&in, &patch, &error))
        fail_msg("%s", error.message);
    return patch;
}

static kg_vec3 direction(kg_random *r) {
    for (;;) {
        kg_vec3 v; /* one by one: compilers evaluate arguments in orders of their own */
        v.x = kg_random_in(r, -1, 1);
        v.y = kg_random_in(r, -1, 1);
        v.z = kg_random_in(r, -1, 1);
        double n = kg_len(v);
        if (n > 0.1 && n < 1)
            return kg_scale(v, 1 / n);
    }
}

kg_patch random_patch(kg_random *r, pair_kind kind, kg_vec3 middle) {
    for (;;) {
        kg_vec3 x = direction(r), y = kg_unit(kg_cross(x, direction(r))), z = kg_cross(x, y);
        size_t count =
            kind == PAIR_QUINTIC || (kind != PAIR_CUBIC && kg_random_in(r, 0, 1) < 0.3) ? 6 : 4;
        double leg = 100.0 / (double)(count - 1),
               turn = kg_random_in(r, 0.2, 1.8) / 3 * 4 / (double)count,
               twist = kind == PAIR_CUBIC || kind == PAIR_QUINTIC ? kg_random_in(r, -0.25, 0.25)
                       : kind == PAIR_WILD                        ? kg_random_in(r, -1, 1)
                                                                  : 0;
        double heading = 0, height = 0;
        kg_patch_input in = {.point_count = count};
        kg_vec3 p = kg_v3(0, 0, 0), sum = p;
        for (size_t i = 0; i < count; i++) {
            in.points[i] = p;
            sum = kg_add(sum, p);
            double length = leg * kg_random_in(r, 0.6, 1.4);
            if (kind == PAIR_STRAIGHT)
                heading = height = 0;
            kg_vec3 step = kg_add(kg_scale(x, cos(heading)), kg_scale(y, sin(heading)));
            p = kg_madd(p, length, kg_madd(step, height, z));
            double sign = kind == PAIR_PLANAR_S && 2 * i >= count - 1 ? -1 : 1;
            heading += sign * turn * kg_random_in(r, 0.7, 1.3);
            height += twist * kg_random_in(r, 0.5, 1.5);
        }
        kg_vec3 shift = kg_sub(middle, kg_scale(sum, 1 / (double)count));
        for (size_t i = 0; i < count; i++)
            in.points[i] = kg_add(in.points[i], shift);
        in.extent[0] = kg_random_in(r, -60, 10);
        in.extent[1] = in.extent[0] + kg_random_in(r, 10, 80);
        in.has_ruling = kind == PAIR_STRAIGHT;
        in.ruling = y;
        kg_patch patch;
        if (kg_patch_init(&in, &patch, NULL) == KG_OK && patch.extent[1] - patch.extent[0] > 8)
            return patch;
    }
}

static kg_vec3 casteljau(const kg_vec3 *points, int n, double t) {
    kg_vec3 q[KG_CURVE_MAX_POINTS];
    memcpy(q, points, sizeof *q * (size_t)(n + 1));
    for (int k = n; k > 0; k--)
        for (int i = 0; i < k; i++)
            q[i] = kg_lerp(q[i], q[i + 1], t);
    return q[0];
}

kg_vec3 naive_point(const kg_patch *patch, double u, double v) {
    kg_vec3 q[KG_CURVE_MAX_POINTS], d[4];
    int n = patch->geodesic.degree;
    memcpy(q, patch->geodesic.points, sizeof q);
    for (int k = 0; k < 4; k++) {
        d[k] = casteljau(q, n - k, v);
        for (int i = 0; i < n - k; i++)
            q[i] = kg_scale(kg_sub(q[i + 1], q[i]), n - k);
    }
    if (patch->shape != KG_CURVE_SPATIAL)
        return kg_madd(d[0], u, kg_unit(patch->rulings[0]));
    /* T = p'/s, and by arc length: T' = (p'' - (p''·T) T)/s², T'' up to multiples of T and T' is
     * (p''' - 3 (p''·T)/s p'' )/s³ - … : the full formula is used */
    double s = kg_len(d[1]);
    kg_vec3 t = kg_scale(d[1], 1 / s);
    double s1 = kg_dot(d[2], t);
    double s2 = (kg_dot(d[2], d[2]) + kg_dot(d[1], d[3]) - s1 * s1) / s;
    /* d²p/ds² = (p'' - s1 T)/s²;  d³p/ds³ = (p''' - 3 s1/s p'' + (3 s1²/s - s2) T)/s³ */
    kg_vec3 x2 = kg_scale(kg_madd(d[2], -s1, t), 1 / (s * s));
    kg_vec3 x3 = kg_scale(kg_madd(kg_madd(d[3], -3 * s1 / s, d[2]), 3 * s1 * s1 / s - s2, t),
                          1 / (s * s * s));
    kg_vec3 ruling = kg_unit(kg_cross(x2, x3));
    /* the sign is the patch's own */
    kg_vec3 own = kg_sub(kg_patch_point(patch, 1, v), kg_patch_point(patch, 0, v));
    return kg_madd(d[0], kg_dot(own, ruling) < 0 ? -u : u, ruling);
}

/* ---- points ---------------------------------------------------------------------------- */

static void check_end(const kg_patch *a, const kg_patch *b, const kg_cross_point *p,
                      unsigned sides) {
    const double unit[2] = {0, 1};
    const double *range[4] = {a->extent, unit, b->extent, unit};
    const double x[4] = {p->u, p->v, p->s, p->t};
    for (unsigned k = 0; k < 4; k++)
        for (unsigned h = 0; h < 2; h++)
            assert_true(((sides >> (2 * k + h)) & 1) == (x[k] == range[k][h]));
}

static double chord_distance(kg_vec3 x, kg_vec3 p, kg_vec3 q) {
    kg_vec3 c = kg_sub(q, p);
    double f = fmin(fmax(kg_dot(kg_sub(x, p), c) / kg_dot(c, c), 0), 1);
    return kg_dist(x, kg_madd(p, f, c));
}

static double paper_distance(kg_vec2 x, kg_vec2 p, kg_vec2 q) {
    return chord_distance(kg_v3(x.x, x.y, 0), kg_v3(p.x, p.y, 0), kg_v3(q.x, q.y, 0));
}

static void check_span(const kg_patch *a, const kg_patch *b, const kg_crossing *c, size_t i,
                       double tolerance, double size) {
    const kg_cross_point *p = &c->points[i], *q = p + 1;
    kg_vec2 pa = kg_patch_unroll(a, p->u, p->v), qa = kg_patch_unroll(a, q->u, q->v);
    kg_vec2 pb = kg_patch_unroll(b, p->s, p->t), qb = kg_patch_unroll(b, q->s, q->t);
    for (int k = 1; k < 6; k++) {
        kg_cross_point slope, x = kg_crossing_at(a, b, c, i, k / 6.0, &slope);
        assert_near(kg_dist(naive_point(a, x.u, x.v), x.x), 0, KG_CROSSING_EXACT * size);
        assert_near(kg_dist(naive_point(b, x.s, x.t), x.x), 0, KG_CROSSING_EXACT * size);
        assert_near(chord_distance(x.x, p->x, q->x), 0, tolerance);
        assert_near(paper_distance(kg_patch_unroll(a, x.u, x.v), pa, qa), 0, tolerance);
        assert_near(paper_distance(kg_patch_unroll(b, x.s, x.t), pb, qb), 0, tolerance);
    }
}

void check_points(const kg_patch *a, const kg_patch *b, const kg_crossings *found,
                  double tolerance) {
    double size = fmax(a->size, b->size);
    for (size_t i = 0; i < found->count; i++) {
        const kg_crossing *c = &found->branches[i];
        assert_true(c->count >= 2);
        for (size_t k = 0; k < c->count; k++) {
            const kg_cross_point *p = &c->points[k];
            assert_near(kg_dist(naive_point(a, p->u, p->v), p->x), 0, KG_CROSSING_EXACT * size);
            assert_near(kg_dist(naive_point(b, p->s, p->t), p->x), 0, KG_CROSSING_EXACT * size);
            assert_true(p->u >= a->extent[0] && p->u <= a->extent[1] && p->v >= 0 && p->v <= 1);
            assert_true(p->s >= b->extent[0] && p->s <= b->extent[1] && p->t >= 0 && p->t <= 1);
            if (k + 1 < c->count)
                check_span(a, b, c, k, tolerance, size);
        }
        if (c->closed) {
            assert_memory_equal(&c->points[0], &c->points[c->count - 1], sizeof c->points[0]);
            assert_true(c->ends[0] == 0 && c->ends[1] == 0);
        } else {
            check_end(a, b, &c->points[0], c->ends[0]);
            check_end(a, b, &c->points[c->count - 1], c->ends[1]);
        }
    }
}

/* ---- rays ------------------------------------------------------------------------------ */

enum { RAYS = 97, GRID = 400 };

typedef struct line {
    kg_vec3 p, d;
} line;

static line line_at(const kg_patch *p, double v) {
    line l = {naive_point(p, 0, v), naive_point(p, 1, v)};
    l.d = kg_sub(l.d, l.p);
    return l;
}

static double det_of(const line *x, const line *y) {
    return kg_det(x->d, y->d, kg_sub(y->p, x->p));
}

/* Is there a point of a branch with parameter `fixed` (v, or t if `by_t`) near `x`? */
static bool on_branch(const kg_crossings *found, double fixed, bool by_t, kg_vec3 x, double near) {
    for (size_t i = 0; i < found->count; i++)
        for (size_t k = 0; k + 1 < found->branches[i].count; k++) {
            const kg_cross_point *p = &found->branches[i].points[k];
            double v0 = by_t ? p[0].t : p[0].v, v1 = by_t ? p[1].t : p[1].v;
            if (fixed < fmin(v0, v1) - 0.02 || fixed > fmax(v0, v1) + 0.02)
                continue;
            if (chord_distance(x, p[0].x, p[1].x) <= near)
                return true;
        }
    return false;
}

typedef struct ray_hits {
    kg_vec3 x[64];
    size_t count;
} ray_hits;

/* Crossings of the ruling `fixed` of `a` with `b`, at least `margin` mm inside both rectangles
 * (negative: outside by that much). */
static ray_hits hits_of(const kg_patch *a, const kg_patch *b, const line *grid, double fixed,
                        double margin) {
    line ray = line_at(a, fixed);
    ray_hits hits = {.count = 0};
    for (int j = 0; j < GRID; j++) {
        double f0 = det_of(&ray, &grid[j]), f1 = det_of(&ray, &grid[j + 1]);
        if ((f0 > 0) == (f1 > 0))
            continue;
        double lo = (double)j / GRID, hi = (double)(j + 1) / GRID;
        for (int k = 0; k < 50; k++) {
            double mid = 0.5 * (lo + hi);
            line y = line_at(b, mid);
            *(((det_of(&ray, &y) > 0) == (f0 > 0)) ? &lo : &hi) = mid;
        }
        line y = line_at(b, lo);
        kg_vec3 n = kg_cross(ray.d, y.d), gap = kg_sub(y.p, ray.p);
        double n2 = kg_dot(n, n);
        if (n2 < 1e-12)
            continue;
        double u = kg_det(gap, y.d, n) / n2, s = kg_det(gap, ray.d, n) / n2;
        if (u >= a->extent[0] + margin && u <= a->extent[1] - margin &&
            s >= b->extent[0] + margin && s <= b->extent[1] - margin && hits.count < 64)
            hits.x[hits.count++] = kg_madd(ray.p, u, ray.d);
    }
    return hits;
}

static size_t check_rays(const kg_patch *a, const kg_patch *b, const kg_crossings *found,
                         double tolerance, bool by_t, const char *name) {
    static line grid[GRID + 1];
    for (int j = 0; j <= GRID; j++)
        grid[j] = line_at(b, (double)j / GRID);
    size_t checked = 0;
    for (int i = 0; i < RAYS; i++) {
        double fixed = (i + 0.5) / RAYS;
        /* a curve that looks into a rectangle by less than the tolerance may be left out */
        ray_hits hits = hits_of(a, b, grid, fixed, 0.5 * tolerance);
        for (size_t k = 0; k < hits.count; k++) {
            checked++;
            if (!on_branch(found, fixed, by_t, hits.x[k], 1.01 * tolerance))
                fail_msg("%s: the point (%g, %g, %g) at %s = %.6g is on no branch", name,
                         hits.x[k].x, hits.x[k].y, hits.x[k].z, by_t ? "t" : "v", fixed);
        }
    }
    return checked;
}

size_t check_against_rays(const kg_patch *a, const kg_patch *b, const kg_crossings *found,
                          double tolerance, const char *name) {
    return check_rays(a, b, found, tolerance, false, name) +
           check_rays(b, a, found, tolerance, true, name);
}
