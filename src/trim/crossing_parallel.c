/*
 * Two patches with constant, parallel rulings: F vanishes everywhere. Their crossings are common
 * rulings, at the crossings of their cross-sections, two plane Bézier curves.
 */
#include "trim/crossing.h"

#include "base/array.h"
#include "curve/bernstein.h"

#include <stdlib.h>

enum { MAX_DEPTH = 26, MAX_VISITS = 4000 };

/* Where pieces of v and t of this length are not yet transversal, the sections touch. */
#define POINT 1e-7

/* v and t of one crossing found twice, at the common end of two pieces. */
#define SAME_POINT 1e-8

typedef struct section {
    kg_vec2 q[KG_CURVE_MAX_POINTS];
    int n;
    double lo, hi;
} section;

typedef struct search {
    const section *a, *b;
    double size;
    int visits;
    struct {
        kg_vec2 *items; /* (v,t) */
        size_t count, capacity;
    } found;
    double crowd_v; /* where the search gave up */
    bool crowded, no_memory;
} search;

static void halve(const section *s, section *lo, section *hi) {
    *lo = *hi = *s;
    lo->hi = hi->lo = 0.5 * (s->lo + s->hi);
    for (int j = 1; j <= s->n; j++) {
        for (int i = 0; i <= s->n - j; i++)
            hi->q[i] = kg_lerp2(hi->q[i], hi->q[i + 1], 0.5);
        lo->q[j] = hi->q[0];
    }
}

static bool boxes_apart(const section *a, const section *b, double gap) {
    kg_box2 x = kg_box2_empty(), y = kg_box2_empty();
    for (int i = 0; i <= a->n; i++)
        kg_box2_add(&x, a->q[i]);
    for (int i = 0; i <= b->n; i++)
        kg_box2_add(&y, b->q[i]);
    return x.lo.x > y.hi.x + gap || y.lo.x > x.hi.x + gap || x.lo.y > y.hi.y + gap ||
           y.lo.y > x.hi.y + gap;
}

/* All of b on one side of a's hull, in the direction square to a's chord. */
static bool beside(const section *a, const section *b, double gap) {
    kg_vec2 chord = kg_sub2(a->q[a->n], a->q[0]);
    double length = kg_len2(chord), lo = 0, hi = 0, from = INFINITY, to = -INFINITY;
    if (length == 0)
        return false;
    for (int i = 1; i <= a->n; i++) {
        double x = kg_cross2(chord, kg_sub2(a->q[i], a->q[0])) / length;
        lo = fmin(lo, x), hi = fmax(hi, x);
    }
    for (int i = 0; i <= b->n; i++) {
        double x = kg_cross2(chord, kg_sub2(b->q[i], a->q[0])) / length;
        from = fmin(from, x), to = fmax(to, x);
    }
    return from > hi + gap || to < lo - gap;
}

static void value(const section *s, double x, kg_vec2 *out_q, kg_vec2 *out_dq) {
    kg_vec2 q[KG_CURVE_MAX_POINTS];
    for (int i = 0; i <= s->n; i++)
        q[i] = s->q[i];
    for (int k = s->n; k > 1; k--)
        for (int i = 0; i < k; i++)
            q[i] = kg_lerp2(q[i], q[i + 1], x);
    *out_dq = kg_scale2(kg_sub2(q[1], q[0]), s->n);
    *out_q = kg_lerp2(q[0], q[1], x);
}

/* Tangents of the two pieces never parallel: at most one crossing. */
static bool transversal(const section *a, const section *b) {
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            double x = kg_cross2(kg_sub2(a->q[i + 1], a->q[i]), kg_sub2(b->q[j + 1], b->q[j]));
            lo = fmin(lo, x), hi = fmax(hi, x);
        }
    return lo > 0 || hi < 0;
}

/* Newton's method on the whole curves from the middle of a piece; true if it ends in the piece. */
static bool newton(const search *s, const section *a, const section *b, kg_vec2 *out) {
    double v = 0.5 * (a->lo + a->hi), t = 0.5 * (b->lo + b->hi);
    for (int i = 0; i < 20; i++) {
        kg_vec2 x, dx, y, dy;
        value(s->a, v, &x, &dx);
        value(s->b, t, &y, &dy);
        kg_vec2 gap = kg_sub2(y, x);
        double det = kg_cross2(dx, dy);
        double sv = kg_cross2(gap, dy) / det, st = kg_cross2(gap, dx) / det;
        v += sv, t += st;
        if (!(fabs(v - 0.5) < 2 && fabs(t - 0.5) < 2))
            return false;
        if (fabs(sv) + fabs(st) < 1e-15)
            break;
    }
    double slack = 1e-10;
    *out = kg_v2(v, t);
    return v >= a->lo - slack && v <= a->hi + slack && t >= b->lo - slack && t <= b->hi + slack;
}

static void record(search *s, kg_vec2 at) {
    for (size_t i = 0; i < s->found.count; i++)
        if (kg_dist2(s->found.items[i], at) < SAME_POINT)
            return;
    if (!kg_push(&s->found, at))
        s->no_memory = true;
}

static void visit(search *s, const section *a, const section *b, int depth) {
    double gap = 1e-12 * s->size;
    if (s->no_memory || s->crowded || boxes_apart(a, b, gap) || beside(a, b, gap) ||
        beside(b, a, gap))
        return;
    if (++s->visits > MAX_VISITS) {
        s->crowded = true;
        s->crowd_v = 0.5 * (a->lo + a->hi);
        return;
    }
    kg_vec2 at;
    if (transversal(a, b) && newton(s, a, b, &at)) {
        record(s, at);
        return;
    }
    /* a touch that is no crossing ends here */
    if (depth == MAX_DEPTH || (a->hi - a->lo < POINT && b->hi - b->lo < POINT))
        return;
    section pa[2], pb[2];
    halve(a, &pa[0], &pa[1]);
    halve(b, &pb[0], &pb[1]);
    for (int k = 0; k < 4; k++)
        visit(s, &pa[k >> 1], &pb[k & 1], depth + 1);
}

static section project(const kg_ruled *r, kg_vec3 x, kg_vec3 y) {
    section s = {.n = r->patch->geodesic.degree, .lo = 0, .hi = 1};
    for (int i = 0; i <= s.n; i++)
        s.q[i] = kg_v2(kg_dot(r->p[i], x), kg_dot(r->p[i], y));
    return s;
}

static int by_place(const void *x, const void *y) {
    const kg_vec2 *a = x, *b = y;
    return a->x != b->x ? (a->x < b->x ? -1 : 1) : a->y < b->y ? -1 : a->y > b->y;
}

kg_status kg_parallel_find(const kg_ruled_pair *pair, kg_crossings *out, kg_error *error) {
    kg_vec3 d = kg_unit(pair->a.patch->rulings[0]);
    kg_vec3 x = fabs(d.x) < 0.6 ? kg_v3(1, 0, 0) : kg_v3(0, 1, 0);
    x = kg_unit(kg_madd(x, -kg_dot(x, d), d));
    kg_vec3 y = kg_cross(d, x);
    section a = project(&pair->a, x, y), b = project(&pair->b, x, y);
    search s = {.a = &a, .b = &b, .size = pair->a.size};
    visit(&s, &a, &b, 0);
    kg_status status = KG_OK;
    if (s.no_memory)
        status = kg_fail(error, KG_ERR_MEMORY, "not enough memory for the crossings");
    else if (s.crowded && kg_coincide_near(pair->a.patch, s.crowd_v, pair->b.patch))
        status = kg_fail_coincident(error);
    if (!status && s.found.count > 0)
        qsort(s.found.items, s.found.count, sizeof *s.found.items, by_place);
    for (size_t i = 0; i < s.found.count && !status; i++)
        if (!kg_shared_ruling(pair, s.found.items[i].x, s.found.items[i].y, out))
            status = kg_fail(error, KG_ERR_MEMORY, "not enough memory for the crossings");
    free(s.found.items);
    return status;
}

bool kg_shared_ruling(const kg_ruled_pair *pair, double v, double t, kg_crossings *out) {
    const double slack = 1e-9, slack_mm = pair->slack * pair->a.size;
    if (!(v >= -slack && v <= 1 + slack && t >= -slack && t <= 1 + slack))
        return true;
    v = fmin(fmax(v, 0), 1), t = fmin(fmax(t, 0), 1);
    kg_line a = kg_ruled_line(&pair->a, v), b = kg_ruled_line(&pair->b, t);
    kg_vec3 da, dda, db, ddb;
    kg_line_unit(&a, &da, &dda);
    kg_line_unit(&b, &db, &ddb);
    /* one line: parallel and no way apart; and the surfaces do not merely touch along it */
    kg_vec3 gap = kg_sub(b.p, a.p);
    double size = pair->a.size, offset = kg_dot(gap, da);
    kg_vec3 na = kg_unit(kg_cross(a.dp, da)), nb = kg_unit(kg_cross(b.dp, db));
    if (kg_len(kg_cross(da, db)) > 1e-8 || kg_len(kg_madd(gap, -offset, da)) > 1e-9 * size ||
        kg_len(kg_cross(na, nb)) < 1e-6)
        return true;
    /* u on A is s = sign (u - offset) on B */
    double sign = kg_dot(da, db) < 0 ? -1 : 1;
    const double *ua = pair->a.patch->extent, *ub = pair->b.patch->extent;
    double from = offset + fmin(sign * ub[0], sign * ub[1]);
    double to = offset + fmax(sign * ub[0], sign * ub[1]);
    double u[2] = {fmax(ua[0], from), fmin(ua[1], to)};
    if (u[1] - u[0] <= slack_mm)
        return true;
    kg_sample ends[2] = {0};
    for (int k = 0; k < 2; k++) {
        kg_cross_point *at = &ends[k].at;
        double s = sign * (u[k] - offset);
        if (u[k] == (k ? to : from))
            s = k == (sign > 0) ? ub[1] : ub[0];
        s = fabs(s - ub[0]) <= slack_mm ? ub[0] : fabs(s - ub[1]) <= slack_mm ? ub[1] : s;
        *at = (kg_cross_point){u[k], v, s, t, kg_add(kg_madd(a.p, u[k], da), pair->a.origin)};
    }
    return kg_crossings_add(out, pair, ends, 2, false);
}
