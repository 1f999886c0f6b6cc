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

static sample sample_at(const sampler *s, double f) {
    sample r = {.uv = kg_v2(s->from.x + f * s->along.x, s->from.y + f * s->along.y)};
    double u = r.uv.x, du = s->along.x, dv = s->along.y;
    kg_ruling g = kg_patch_ruling(s->patch, r.uv.y);
    r.x = kg_madd(g.p, u, g.d);
    r.dx = kg_madd(kg_scale(g.d, du), dv, kg_madd(g.dp, u, g.dd));
    r.paper = kg_v2(u * g.sin_theta, u * g.cos_theta + kg_patch_length(s->patch, r.uv.y));
    double turn = u * g.dtheta * dv;
    r.dpaper = kg_v2(du * g.sin_theta + turn * g.cos_theta,
                     du * g.cos_theta - turn * g.sin_theta + g.speed * dv);
    return r;
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

/* Points of [lo, hi) where a and b are its ends. */
static kg_status halve(const sampler *s, double lo, double hi, const sample *a, const sample *b,
                       int depth) {
    double middle = 0.5 * (lo + hi), step = hi - lo;
    sample m = sample_at(s, middle);
    if (depth >= MAX_DEPTH ||
        (depth >= FIRST_DEPTH &&
         fmax(space_gap(a, &m, b, step), paper_gap(a, &m, b, step)) <= s->tolerance)) {
        kg_cross_point p = {.u = a->uv.x, .v = a->uv.y, .x = a->x};
        return kg_push(s->points, p) ? KG_OK : KG_ERR_MEMORY;
    }
    kg_status status = halve(s, lo, middle, a, &m, depth + 1);
    return status ? status : halve(s, middle, hi, &m, b, depth + 1);
}

kg_status kg_sample_straight(const kg_patch *patch, kg_vec2 a, kg_vec2 b, double tolerance,
                             kg_points *points) {
    sampler s = {patch, a, kg_sub2(b, a), tolerance, points};
    sample from = sample_at(&s, 0), to = sample_at(&s, 1);
    /* along a ruling the segment is straight everywhere */
    if (a.y == b.y) {
        kg_cross_point p = {.u = a.x, .v = a.y, .x = from.x};
        return kg_push(points, p) ? KG_OK : KG_ERR_MEMORY;
    }
    return halve(&s, 0, 1, &from, &to, 0);
}
