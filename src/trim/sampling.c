/* Straight segments of the (u,v) plane as points whose chords keep to a tolerance. */
#include "trim/region.h"

#include "base/array.h"

/* Halvings of a segment at most: 4096 chords on the bend of one patch. */
enum { MAX_DEPTH = 12, FIRST_DEPTH = 2 };

/* A point of the segment with its derivatives by the fraction of it. */
typedef struct sample {
    kg_vec2 uv;
    kg_vec3 x, dx;
    kg_vec2 paper, dpaper;
} sample;

typedef struct sampler {
    const kg_patch *patch;
    kg_vec2 from, along;
    double tolerance;
    kg_points *points;
} sampler;

/* What all points of one ruling share. */
typedef struct row {
    kg_ruling g;
    double length;
} row;

static row row_at(const kg_patch *patch, double v) {
    return (row){kg_patch_ruling(patch, v), kg_patch_length(patch, v)};
}

static sample sample_on(const row *on, double u, kg_vec2 along) {
    const kg_ruling *g = &on->g;
    sample r = {.uv = kg_v2(u, g->v)};
    double du = along.x, dv = along.y;
    r.x = kg_madd(g->p, u, g->d);
    r.dx = kg_madd(kg_scale(g->d, du), dv, kg_madd(g->dp, u, g->dd));
    r.paper = kg_v2(u * g->sin_theta, u * g->cos_theta + on->length);
    double turn = u * g->dtheta * dv;
    r.dpaper = kg_v2(du * g->sin_theta + turn * g->cos_theta,
                     du * g->cos_theta - turn * g->sin_theta + g->speed * dv);
    return r;
}

static sample sample_at(const sampler *s, double f) {
    row on = row_at(s->patch, s->from.y + f * s->along.y);
    return sample_on(&on, s->from.x + f * s->along.x, s->along);
}

/* Height of the cubic with these end slopes over its chord: an S-bend may cross the chord halfway,
 * its ends do not run along it. 0.1 is the height of the symmetric one, √3/18, rounded up. */
static double bend_height(double across0, double across1, double step) {
    return 0.1 * step * fmax(across0, across1);
}

static double space_gap(const sample *a, const sample *m, const sample *b, double step) {
    kg_vec3 chord = kg_unit(kg_sub(b->x, a->x));
    double bend = bend_height(kg_len(kg_cross(a->dx, chord)), kg_len(kg_cross(b->dx, chord)), step);
    return fmax(bend, kg_dist(m->x, kg_lerp(a->x, b->x, 0.5)));
}

static double paper_gap(const sample *a, const sample *m, const sample *b, double step) {
    kg_vec2 chord = kg_sub2(b->paper, a->paper);
    double n = kg_len2(chord), turn0 = fabs(kg_cross2(a->dpaper, chord)),
           turn1 = fabs(kg_cross2(b->dpaper, chord));
    double bend = n > 0 ? bend_height(turn0 / n, turn1 / n, step) : 0;
    return fmax(bend, kg_dist2(m->paper, kg_lerp2(a->paper, b->paper, 0.5)));
}

static bool is_good(const sample *a, const sample *m, const sample *b, double step, int depth,
                    double tolerance) {
    return depth >= MAX_DEPTH ||
           (depth >= FIRST_DEPTH &&
            fmax(space_gap(a, m, b, step), paper_gap(a, m, b, step)) <= tolerance);
}

static bool push(kg_points *points, const sample *s) {
    return kg_push(points, ((kg_cross_point){.u = s->uv.x, .v = s->uv.y, .x = s->x}));
}

/* Points of [lo, hi) where a and b are its ends. */
static kg_status halve(const sampler *s, double lo, double hi, const sample *a, const sample *b,
                       int depth) {
    double middle = 0.5 * (lo + hi), step = hi - lo;
    sample m = sample_at(s, middle);
    if (is_good(a, &m, b, step, depth, s->tolerance))
        return push(s->points, a) ? KG_OK : KG_ERR_MEMORY;
    kg_status status = halve(s, lo, middle, a, &m, depth + 1);
    return status ? status : halve(s, middle, hi, &m, b, depth + 1);
}

kg_status kg_sample_straight(const kg_patch *patch, kg_vec2 a, kg_vec2 b, double tolerance,
                             kg_points *points) {
    sampler s = {patch, a, kg_sub2(b, a), tolerance, points};
    sample from = sample_at(&s, 0), to = sample_at(&s, 1);
    /* along a ruling the segment is straight everywhere */
    if (a.y == b.y)
        return push(points, &from) ? KG_OK : KG_ERR_MEMORY;
    return halve(&s, 0, 1, &from, &to, 0);
}

/* ---- both sides of a patch ---------------------------------------------------------------- */

typedef struct sides {
    const kg_patch *patch;
    double tolerance;
    kg_points *points;
} sides;

static void sides_at(const sides *s, double v, sample out[2]) {
    row on = row_at(s->patch, v);
    for (int k = 0; k < 2; k++)
        out[k] = sample_on(&on, s->patch->extent[k], kg_v2(0, 1));
}

/* As `halve` for both sides at once, those in `open`: points of (lo, hi] of the low side and of
 * [lo, hi) of the high one. */
static kg_status halve_sides(const sides *s, double lo, double hi, const sample a[2],
                             const sample b[2], const bool open[2], int depth) {
    double middle = 0.5 * (lo + hi);
    sample m[2];
    bool rest[2] = {false, false};
    sides_at(s, middle, m);
    for (int k = 0; k < 2; k++)
        if (open[k]) {
            rest[k] = !is_good(&a[k], &m[k], &b[k], hi - lo, depth, s->tolerance);
            if (!rest[k] && !push(&s->points[k], k ? &a[k] : &b[k]))
                return KG_ERR_MEMORY;
        }
    if (!rest[0] && !rest[1])
        return KG_OK;
    kg_status status = halve_sides(s, lo, middle, a, m, rest, depth + 1);
    return status ? status : halve_sides(s, middle, hi, m, b, rest, depth + 1);
}

kg_status kg_sample_sides(const kg_patch *patch, double tolerance, kg_points points[2]) {
    sides s = {patch, tolerance, points};
    sample from[2], to[2];
    sides_at(&s, 0, from);
    sides_at(&s, 1, to);
    kg_status status = halve_sides(&s, 0, 1, from, to, (const bool[2]){true, true}, 0);
    kg_cross_point *low = points[0].items;
    for (size_t i = 0, j = points[0].count; i + 1 < j; i++) {
        kg_cross_point swap = low[--j];
        low[j] = low[i];
        low[i] = swap;
    }
    return status;
}
