#include "origami/overlap.h"

#include <stdlib.h>
#include <string.h>

/* Points are middles of loops that hold few of them yet: many where many loops lie, and some for
 * the small ones. Loops take turns in a scattered order, since neighbours often came of one fold.
 */
enum { POINTS = 128, POINT_WORDS = POINTS / 64, FEW_POINTS = 4, SCATTER = 1000003 };

/* Slabs across x, y and both diagonals. For each slab there are two rows: the loops that start in
 * it or before, and those that end before it. */
enum { DIRECTIONS = 4, SLABS = 64 };

static uint64_t *starts_by(const kg_overlaps *v, int direction, int slab) {
    return v->slabs + (size_t)(2 * (direction * SLABS + slab)) * v->words;
}
static uint64_t *ends_before(const kg_overlaps *v, int direction, int slab) {
    return starts_by(v, direction, slab) + v->words;
}

/* ---- slabs ------------------------------------------------------------------------------ */

static double along(int direction, kg_vec2 p) {
    return direction == 0 ? p.x : direction == 1 ? p.y : direction == 2 ? p.x + p.y : p.x - p.y;
}

/* Monotone: what starts after something else ends does not start in an earlier slab. */
static unsigned char slab_of(double t, const double range[2]) {
    double slab = (t - range[0]) * (SLABS / (range[1] - range[0]));
    return slab > 0 ? (unsigned char)(slab < SLABS - 1 ? slab : SLABS - 1) : 0;
}

static void find_slabs(kg_overlaps *v, int direction, double (*stretches)[2]) {
    double range[2] = {INFINITY, -INFINITY};
    for (size_t i = 0; i < v->loops; i++) {
        const kg_vec2 *p = kg_outline_points(v->outlines, (int32_t)i);
        size_t n = kg_outline_size(v->outlines, (int32_t)i);
        double *t = stretches[i];
        t[0] = INFINITY, t[1] = -INFINITY;
        for (size_t k = 0; k < n; k++) {
            double at = along(direction, p[k]);
            t[0] = at < t[0] ? at : t[0];
            t[1] = at > t[1] ? at : t[1];
        }
        range[0] = t[0] < range[0] ? t[0] : range[0];
        range[1] = t[1] > range[1] ? t[1] : range[1];
    }
    for (size_t i = 0; i < v->loops; i++) {
        unsigned char *span = v->spans + 2 * (DIRECTIONS * i + (size_t)direction);
        span[0] = slab_of(stretches[i][0], range);
        span[1] = slab_of(stretches[i][1], range);
        kg_bit_set(starts_by(v, direction, span[0]), (int32_t)i);
        if (span[1] + 1 < SLABS)
            kg_bit_set(ends_before(v, direction, span[1] + 1), (int32_t)i);
    }
    for (int k = 1; k < SLABS; k++) /* both rows of a slab at once */
        for (size_t w = 0; w < 2 * v->words; w++)
            starts_by(v, direction, k)[w] |= starts_by(v, direction, k - 1)[w];
}

/* ---- points ----------------------------------------------------------------------------- */

/* The point is inside a loop, farther than touch from every side. */
static bool holds(const kg_overlaps *v, int32_t loop, kg_vec2 p) {
    const kg_box2 *box = &v->outlines->boxes[loop];
    if (!(p.x > box->lo.x && p.x < box->hi.x && p.y > box->lo.y && p.y < box->hi.y))
        return false;
    const kg_outline_side *sides = v->outlines->sides + v->outlines->starts[loop];
    size_t n = kg_outline_size(v->outlines, loop), i = 0;
    while (i < n && kg_outline_depth(&sides[i], p) > v->touch)
        i++;
    return i == n;
}

static int count_held(const kg_overlaps *v, size_t loop) {
    int count = 0;
    for (size_t k = 0; k < POINT_WORDS; k++)
        count += __builtin_popcountll(v->held[loop * POINT_WORDS + k]);
    return count;
}

static void find_points(kg_overlaps *v) {
    int32_t count = 0;
    for (size_t k = 0; k < v->loops && count < POINTS; k++) {
        size_t from = k * SCATTER % v->loops;
        if (count_held(v, from) >= FEW_POINTS)
            continue;
        kg_vec2 p = v->outlines->middles[from];
        for (size_t i = 0; i < v->loops; i++)
            if (holds(v, (int32_t)i, p)) {
                kg_bit_set(v->points + (size_t)count * v->words, (int32_t)i);
                kg_bit_set(v->held + i * POINT_WORDS, count);
            }
        count++;
    }
}

/* ---- groups ----------------------------------------------------------------------------- */

static kg_status find_planes(kg_overlaps *v, const kg_origami_state *s) {
    int32_t *places = calloc(s->groups.count + 1, sizeof *places), count = 0;
    if (!places)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < v->loops; i++)
        places[s->loops.items[i].group]++;
    for (size_t g = 0; g < s->groups.count; g++)
        places[g] = places[g] > 1 ? count++ : -1;
    v->planes = calloc((size_t)count + 1, v->words * sizeof *v->planes);
    for (size_t i = 0; i < v->loops && v->planes; i++) {
        v->places[i] = places[s->loops.items[i].group];
        if (v->places[i] >= 0)
            kg_bit_set(v->planes + (size_t)v->places[i] * v->words, (int32_t)i);
    }
    free(places);
    return v->planes ? KG_OK : KG_ERR_MEMORY;
}

/* ---- all -------------------------------------------------------------------------------- */

kg_status kg_overlaps_create(const kg_origami_state *s, const kg_outlines *o, kg_overlaps *out) {
    size_t loops = s->loops.count, words = kg_layer_words(loops);
    kg_overlaps v = {.outlines = o,
                     .touch = s->touch,
                     .loops = loops,
                     .words = words,
                     .places = malloc((loops + 1) * sizeof *v.places),
                     .points = calloc(POINTS, words * sizeof *v.points),
                     .held = calloc(loops + 1, POINT_WORDS * sizeof *v.held),
                     .slabs = calloc(2 * DIRECTIONS * SLABS, words * sizeof *v.slabs),
                     .spans = calloc(loops + 1, 2 * DIRECTIONS)};
    double(*stretches)[2] = malloc((loops + 1) * sizeof *stretches);
    bool ok = v.places && v.points && v.held && v.slabs && v.spans && stretches;
    kg_status status = ok ? find_planes(&v, s) : KG_ERR_MEMORY;
    for (int d = 0; d < DIRECTIONS && !status; d++)
        find_slabs(&v, d, stretches);
    if (!status)
        find_points(&v);
    free(stretches);
    if (status)
        kg_overlaps_clear(&v);
    else
        *out = v;
    return status;
}

void kg_overlaps_clear(kg_overlaps *v) {
    free(v->planes);
    free(v->places);
    free(v->points);
    free(v->held);
    free(v->slabs);
    free(v->spans);
    *v = (kg_overlaps){0};
}

/* Loops whose slabs meet those of a loop, in every direction. */
static void find_near(const kg_overlaps *v, int32_t loop, const uint64_t *wanted, size_t first,
                      uint64_t *out) {
    const uint64_t *plane = v->planes + (size_t)v->places[loop] * v->words;
    for (size_t w = first; w < v->words; w++)
        out[w] = wanted[w] & plane[w];
    for (int d = 0; d < DIRECTIONS; d++) {
        const unsigned char *span = v->spans + 2 * (DIRECTIONS * loop + d);
        const uint64_t *starts = starts_by(v, d, span[1]), *ends = ends_before(v, d, span[0]);
        for (size_t w = first; w < v->words; w++)
            out[w] &= starts[w] & ~ends[w];
    }
}

void kg_overlaps_find(const kg_overlaps *v, int32_t loop, const uint64_t *wanted, size_t first,
                      uint64_t *out) {
    if (v->places[loop] < 0) {
        memset(out + first, 0, (v->words - first) * sizeof *out);
        return;
    }
    find_near(v, loop, wanted, first, out);
    for (size_t w = first; w < v->words; w++) {
        uint64_t sure = 0;
        for (size_t k = 0; k < POINT_WORDS && out[w] & ~sure; k++)
            for (uint64_t held = v->held[(size_t)loop * POINT_WORDS + k]; held != 0;)
                sure |= v->points[(64 * k + (size_t)kg_bit_next(&held)) * v->words + w];
        for (uint64_t open = out[w] & ~sure; open != 0;) {
            int32_t bit = kg_bit_next(&open);
            if (!kg_outlines_overlap(v->outlines, loop, (int32_t)(64 * w) + bit, v->touch))
                out[w] &= ~((uint64_t)1 << bit);
        }
    }
}

kg_status kg_overlaps_fill(kg_origami_state *s, const kg_outlines *o) {
    kg_overlaps v = {0};
    kg_status status = kg_layers_create(s);
    if (!status)
        status = kg_overlaps_create(s, o, &v);
    uint64_t *later = malloc(kg_layer_words(s->loops.count) * sizeof *later);
    if (!later)
        status = KG_ERR_MEMORY;
    for (int32_t i = 0; i < (int32_t)s->loops.count && !status; i++) {
        size_t first = (size_t)i / 64;
        memset(later, 0xff, v.words * sizeof *later);
        later[first] &= ~(uint64_t)1 << (i & 63);
        kg_overlaps_find(&v, i, later, first, kg_layer_pile(s, o, i, 1));
    }
    if (!status)
        kg_layers_mirror(s, o);
    free(later);
    kg_overlaps_clear(&v);
    return status;
}
