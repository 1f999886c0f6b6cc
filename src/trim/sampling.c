/* Straight segments of the (u,v) plane as points whose chords keep to a tolerance. */
#include "trim/region.h"

#include "base/array.h"

/* Halvings of a segment at most: 4096 chords on the bend of one patch. */
enum { MAX_DEPTH = 12, FIRST_DEPTH = 2 };

/* A point of the segment with its derivatives by the fraction of it. */
typedef struct sample {
    kg_vec2 uv;
    kg_vec3 x, dx;
    kg_vec2 off, dpaper;  /* place on paper from the foot of the ruling; derivative of the place */
    double speed, dspeed; /* of the geodesic */
} sample;

typedef struct sampler {
    const kg_patch *patch;
    kg_vec2 from, along;
    double tolerance;
    kg_points *points;
} sampler;

static sample sample_on(const kg_ruling *g, double u, kg_vec2 along) {
    sample r = {.uv = kg_v2(u, g->v)};
    double du = along.x, dv = along.y;
    r.x = kg_madd(g->p, u, g->d);
    r.dx = kg_madd(kg_scale(g->d, du), dv, kg_madd(g->dp, u, g->dd));
    r.off = kg_v2(u * g->sin_theta, u * g->cos_theta);
    double turn = u * g->dtheta * dv;
    r.speed = g->speed * dv;
    r.dspeed = kg_dot(g->dp, g->ddp) / g->speed * (dv * dv);
    r.dpaper = kg_v2(du * g->sin_theta + turn * g->cos_theta,
                     du * g->cos_theta - turn * g->sin_theta + r.speed);
    return r;
}

static sample sample_at(const sampler *s, double f) {
    kg_ruling g = kg_patch_ruling(s->patch, s->from.y + f * s->along.y);
    return sample_on(&g, s->from.x + f * s->along.x, s->along);
}

/* A span between two samples is as good as its curve is near the cubic with the same ends and end
 * slopes. The cubic of a span of twice the length was off by `miss` in its middle, where the curve
 * is known; that of its halves is off by a sixteenth of it where the curve is smooth. */
#define SHARE_OF_MISS 0.125

/* Height over the chord of the cubic with these slopes across it at the ends: an S-bend may cross
 * the chord halfway, its ends do not run along it. 0.1 is the height of the symmetric one, √3/18,
 * rounded up. */
static double bend_height(double across0, double across1, double step) {
    return 0.1 * step * kg_max(across0, across1);
}

static double space_gap(const sample *a, const sample *b, double step) {
    kg_vec3 chord = kg_unit(kg_sub(b->x, a->x));
    double bend = bend_height(kg_len(kg_cross(a->dx, chord)), kg_len(kg_cross(b->dx, chord)), step);
    return kg_max(bend, 0.125 * step * kg_dist(a->dx, b->dx));
}

static double paper_gap(const sample *a, const sample *b, double step) {
    /* the geodesic's length by the trapezoidal rule with corrected ends (Euler and Maclaurin) */
    double length = step * (0.5 * (a->speed + b->speed) + step / 12 * (a->dspeed - b->dspeed));
    kg_vec2 chord = kg_v2(b->off.x - a->off.x, b->off.y - a->off.y + length);
    double n = kg_len2(chord), turn0 = fabs(kg_cross2(a->dpaper, chord)),
           turn1 = fabs(kg_cross2(b->dpaper, chord));
    double bend = n > 0 ? bend_height(turn0 / n, turn1 / n, step) : 0;
    return kg_max(bend, 0.125 * step * kg_dist2(a->dpaper, b->dpaper));
}

static bool is_good(const sample *a, const sample *b, double miss, double step, int depth,
                    double tolerance) {
    if (depth < FIRST_DEPTH || depth >= MAX_DEPTH)
        return depth >= MAX_DEPTH;
    double room = tolerance - SHARE_OF_MISS * miss;
    return space_gap(a, b, step) <= room && paper_gap(a, b, step) <= room;
}

/* How far the middle m of a span is off the middle of its cubic. */
static double miss_at(const sample *a, const sample *m, const sample *b, double step) {
    kg_vec3 middle = kg_lerp(a->x, b->x, 0.5);
    return kg_dist(m->x, kg_madd(middle, 0.125 * step, kg_sub(a->dx, b->dx)));
}

static bool push(kg_points *points, const sample *s) {
    return kg_push(points, ((kg_cross_point){.u = s->uv.x, .v = s->uv.y, .x = s->x}));
}

/* Points of [lo, hi) where a and b are its ends. */
static kg_status halve(const sampler *s, double lo, double hi, const sample *a, const sample *b,
                       double miss, int depth) {
    double middle = 0.5 * (lo + hi), step = hi - lo;
    if (is_good(a, b, miss, step, depth, s->tolerance))
        return push(s->points, a) ? KG_OK : KG_ERR_MEMORY;
    sample m = sample_at(s, middle);
    miss = miss_at(a, &m, b, step);
    kg_status status = halve(s, lo, middle, a, &m, miss, depth + 1);
    return status ? status : halve(s, middle, hi, &m, b, miss, depth + 1);
}

kg_status kg_sample_straight(const kg_patch *patch, kg_vec2 a, kg_vec2 b, double tolerance,
                             kg_points *points) {
    sampler s = {patch, a, kg_sub2(b, a), tolerance, points};
    sample from = sample_at(&s, 0);
    /* along a ruling the segment is straight everywhere */
    if (a.y == b.y)
        return push(points, &from) ? KG_OK : KG_ERR_MEMORY;
    sample to = sample_at(&s, 1);
    return halve(&s, 0, 1, &from, &to, INFINITY, 0);
}

/* ---- both sides of a patch ---------------------------------------------------------------- */

typedef struct sides {
    const kg_patch *patch;
    double tolerance;
    kg_points *points;
} sides;

static void sides_at(const sides *s, double v, sample out[2]) {
    kg_ruling g = kg_patch_ruling(s->patch, v);
    for (int k = 0; k < 2; k++)
        out[k] = sample_on(&g, s->patch->extent[k], kg_v2(0, 1));
}

/* As `halve` for both sides at once, those in `open`: points of (lo, hi] of the low side and of
 * [lo, hi) of the high one. */
static kg_status halve_sides(const sides *s, double lo, double hi, const sample a[2],
                             const sample b[2], const bool open[2], const double miss[2],
                             int depth) {
    double middle = 0.5 * (lo + hi), step = hi - lo, next[2] = {0};
    bool rest[2] = {false, false};
    for (int k = 0; k < 2; k++)
        if (open[k]) {
            rest[k] = !is_good(&a[k], &b[k], miss[k], step, depth, s->tolerance);
            if (!rest[k] && !push(&s->points[k], k ? &a[k] : &b[k]))
                return KG_ERR_MEMORY;
        }
    if (!rest[0] && !rest[1])
        return KG_OK;
    sample m[2];
    sides_at(s, middle, m);
    for (int k = 0; k < 2; k++)
        next[k] = miss_at(&a[k], &m[k], &b[k], step);
    kg_status status = halve_sides(s, lo, middle, a, m, rest, next, depth + 1);
    return status ? status : halve_sides(s, middle, hi, m, b, rest, next, depth + 1);
}

kg_status kg_sample_sides(const kg_patch *patch, double tolerance, kg_points points[2]) {
    sides s = {patch, tolerance, points};
    sample from[2], to[2];
    sides_at(&s, 0, from);
    sides_at(&s, 1, to);
    kg_status status = halve_sides(&s, 0, 1, from, to, (const bool[2]){true, true},
                                   (const double[2]){INFINITY, INFINITY}, 0);
    kg_cross_point *low = points[0].items;
    for (size_t i = 0, j = points[0].count; i + 1 < j; i++) {
        kg_cross_point swap = low[--j];
        low[j] = low[i];
        low[i] = swap;
    }
    return status;
}
