/* What a fold would do, worked out without doing it. */
#include "origami/folding.h"

#include <stdlib.h>
#include <string.h>

/* More gaps than this are more than anybody chooses from. */
enum { MOST_GAPS = 64 };

/* Pairs of layers looked at in all while gaps are tried, so that people do not wait: some 0.2 s. */
#define MOST_PAIRS 40000000

void kg_fold_preview_clear(kg_fold_preview *p) {
    free(p->layers);
    free(p->points);
    free(p->starts);
    free(p->loops);
    free(p->creases);
    *p = (kg_fold_preview){0};
}

static kg_fold_axis axis_of(const kg_fold_preview *p) {
    return (kg_fold_axis){.origin = p->origin,
                          .axis = p->axis,
                          .side = p->side,
                          .normal = p->normal,
                          .angle = p->angle};
}

kg_vec3 kg_fold_preview_turn(const kg_fold_preview *p, kg_vec3 point, double fraction) {
    kg_fold_axis axis = axis_of(p);
    return kg_fold_turn(&axis, point, fraction * p->angle);
}

/* ---- how many layers there are ----------------------------------------------------------- */

/* Picks one layer after another, noting with which of them each loop moves. */
static kg_status count_layers(kg_folding *f, const kg_fold *fold, kg_fold_preview *p) {
    size_t loops = f->state->loops.count;
    kg_fold one = *fold;
    one.layers = 1;
    p->layers = calloc(loops + 1, sizeof *p->layers);
    kg_status status = p->layers ? KG_OK : KG_ERR_MEMORY;
    while (!status && !(status = kg_folding_pick(f, &one, NULL))) {
        p->layer_count++;
        for (size_t i = 0; i < loops; i++)
            if (f->moves[i] && p->layers[i] == 0)
                p->layers[i] = p->layer_count;
        one.face = -1;
    }
    kg_folding_rest(f);
    f->blame = (kg_fold_blame){.faces = {-1, -1}};
    return status == KG_ERR_INPUT ? KG_OK : status;
}

/* ---- what moves ------------------------------------------------------------------------- */

/* The part of a loop that moves, as it lies before the fold; `crossing` receives the ends of its
 * cut. Returns how many corners it has. */
static size_t moving_part(const kg_folding *f, int32_t loop, kg_vec3 *out, kg_vec3 crossing[2],
                          size_t *crossing_count) {
    const kg_origami_state *s = f->state;
    bool whole = s->loops.items[loop].group != f->axis.group || !(f->reach[loop] & 2);
    int32_t first = s->loops.items[loop].first, h = first;
    size_t count = 0, cuts = 0;
    do {
        kg_vec3 a = *kg_origin(s, h), b = *kg_origin(s, kg_next(s, h));
        int side = f->sides[s->halves.items[h].origin],
            next = f->sides[s->halves.items[kg_next(s, h)].origin];
        if (whole || side >= 0)
            out[count++] = a;
        if (!whole && side == 0 && cuts < 2)
            crossing[cuts++] = a;
        if (!whole && side * next < 0 && cuts < 2) {
            double x = kg_dot(kg_sub(a, f->axis.origin), f->axis.side),
                   y = kg_dot(kg_sub(b, f->axis.origin), f->axis.side);
            out[count++] = crossing[cuts++] = kg_lerp(a, b, x / (x - y));
        }
    } while ((h = kg_next(s, h)) != first);
    *crossing_count = cuts;
    return count;
}

static kg_status collect_parts(const kg_folding *f, kg_fold_preview *p) {
    size_t loops = f->state->loops.count, halves = f->state->halves.count, points = 0;
    p->points = malloc((halves + 2 * loops + 1) * sizeof *p->points);
    p->starts = malloc((loops + 1) * sizeof *p->starts);
    p->loops = malloc((loops + 1) * sizeof *p->loops);
    p->creases = malloc((2 * loops + 1) * sizeof *p->creases);
    if (!p->points || !p->starts || !p->loops || !p->creases)
        return KG_ERR_MEMORY;
    p->starts[0] = 0;
    for (size_t i = 0; i < loops; i++) {
        kg_vec3 cut[2];
        size_t cuts;
        if (!f->moves[i])
            continue;
        points += moving_part(f, (int32_t)i, p->points + points, cut, &cuts);
        p->loops[p->part_count++] = (int32_t)i;
        p->starts[p->part_count] = points;
        if (cuts == 2) {
            memcpy(p->creases + 2 * p->crease_count, cut, sizeof cut);
            p->crease_count++;
        }
    }
    return KG_OK;
}

kg_status kg_fold_preview_make(const kg_origami_state *state, const kg_fold *fold,
                               kg_fold_preview *out, kg_error *error) {
    kg_folding f;
    kg_fold_preview p = {.faces = {-1, -1}};
    kg_origami_state *after = NULL;
    kg_status status = kg_folding_create(state, fold, &f, error);
    *out = p;
    if (status)
        return status;
    p.has_axis = true;
    p.origin = f.axis.origin, p.axis = f.axis.axis, p.side = f.axis.side, p.normal = f.axis.normal;
    p.angle = f.axis.angle, p.group = f.axis.group;
    status = count_layers(&f, fold, &p);
    if (!status)
        status = kg_folding_pick(&f, fold, error);
    if (status != KG_ERR_MEMORY && collect_parts(&f, &p))
        status = KG_ERR_MEMORY;
    if (!status)
        status = kg_folding_finish(&f, fold, &after, NULL, error);
    p.fault = f.blame.fault;
    memcpy(p.faces, f.blame.faces, sizeof p.faces);
    p.meets_deg = f.blame.angle * 180 / KG_PI;
    kg_state_destroy(after);
    kg_folding_clear(&f);
    if (status == KG_ERR_MEMORY) {
        kg_fold_preview_clear(&p);
        return kg_fail(error, status, "out of memory");
    }
    *out = p;
    return status;
}

/* ---- where it could go between ----------------------------------------------------------- */

typedef struct gaps {
    kg_fold_gap *items;
    size_t count, capacity;
} gaps;

/* Bits of the loops at rest that the fold ends on; free() them. */
static uint64_t *find_landing(const kg_origami_state *after, const bool *moves, int32_t group) {
    uint64_t *landing = calloc(after->layers.words, sizeof *landing);
    for (size_t i = 0; i < after->loops.count && landing; i++)
        for (size_t w = 0;
             moves[i] && after->loops.items[i].group == group && w < after->layers.words; w++)
            landing[w] |= kg_layer_any(after, (int32_t)i, w);
    for (size_t i = 0; i < after->loops.count && landing; i++)
        if (moves[i])
            kg_bit_unset(landing, (int32_t)i);
    return landing;
}

/* What lies on a loop (1) or below it (-1), seen from the side it folds to. */
static const uint64_t *seen_row(const kg_origami_state *s, const kg_fold_axis *axis, int32_t loop,
                                int above) {
    double facing = kg_dot(kg_origami_normal(s, loop), axis->normal) * axis->angle;
    return kg_layer_row(s, loop, facing > 0 ? above : -above);
}

static int32_t count_common(const uint64_t *a, const uint64_t *b, size_t words) {
    int32_t count = 0;
    for (size_t w = 0; w < words; w++)
        count += __builtin_popcountll(a[w] & b[w]);
    return count;
}

static bool meet(const uint64_t *a, const uint64_t *b, const uint64_t *c, size_t words) {
    for (size_t w = 0; w < words; w++)
        if (a[w] & b[w] & c[w])
            return true;
    return false;
}

/* Of the layers that the fold ends on, those that lie right on `lower`. */
static bool add_gaps(const kg_origami_state *after, const kg_fold_axis *axis,
                     const uint64_t *landing, int32_t lower, gaps *list) {
    size_t words = after->layers.words;
    const uint64_t *on = seen_row(after, axis, lower, 1);
    for (size_t w = 0; w < words; w++)
        for (uint64_t bits = on[w] & landing[w]; bits != 0;) {
            int32_t upper = (int32_t)(64 * w) + kg_bit_next(&bits);
            if (meet(on, landing, seen_row(after, axis, upper, -1), words))
                continue;
            int32_t depth = 1 + count_common(seen_row(after, axis, upper, 1), landing, words);
            if (!kg_push(list, ((kg_fold_gap){lower, upper, depth})))
                return false;
        }
    return true;
}

/* From the top down. */
static int compare_gaps(const void *a, const void *b) {
    const kg_fold_gap *x = a, *y = b;
    if (x->depth != y->depth)
        return x->depth < y->depth ? -1 : 1;
    if (x->lower != y->lower)
        return x->lower < y->lower ? -1 : 1;
    return x->upper < y->upper ? -1 : x->upper > y->upper;
}

/* Neighbours among the layers that the fold ends on. */
static kg_status find_candidates(const kg_fold_axis *axis, const kg_origami_state *after,
                                 const bool *moves, gaps *list) {
    uint64_t *landing = find_landing(after, moves, axis->group);
    bool ok = landing;
    for (int32_t i = 0; ok && i < (int32_t)after->loops.count; i++)
        if (kg_bit_at(landing, i))
            ok = add_gaps(after, axis, landing, i, list);
    free(landing);
    if (ok && list->count > 0)
        qsort(list->items, list->count, sizeof *list->items, compare_gaps);
    return ok ? KG_OK : KG_ERR_MEMORY;
}

/* Adds a gap where the fold can end, unless an earlier one comes to the same. */
static kg_status try_gap(kg_folding *f, const kg_fold *fold, kg_fold_gap gap, gaps *list,
                         kg_origami_state **states) {
    kg_fold between = *fold;
    between.between[0] = gap.lower, between.between[1] = gap.upper;
    kg_origami_state *after;
    kg_status status = kg_folding_finish(f, &between, &after, NULL, NULL);
    if (status)
        return status == KG_ERR_INPUT ? KG_OK : status;
    for (size_t i = 0; i < list->count; i++)
        if (kg_layers_equal(states[i], after)) {
            kg_state_destroy(after);
            return KG_OK;
        }
    if (!kg_push(list, gap)) {
        kg_state_destroy(after);
        return KG_ERR_MEMORY;
    }
    states[list->count - 1] = after;
    return KG_OK;
}

static kg_status try_gaps(kg_folding *f, const kg_fold *fold, const kg_origami_state *after,
                          const bool *moves, gaps *list) {
    gaps candidates = {0};
    kg_origami_state *states[MOST_GAPS] = {0};
    kg_status status = find_candidates(&f->axis, after, moves, &candidates);
    size_t most = MOST_PAIRS / (kg_origami_pair_count(after) + 1);
    for (size_t i = 0; i < candidates.count && i < most && list->count < MOST_GAPS && !status; i++)
        status = try_gap(f, fold, candidates.items[i], list, states);
    for (size_t i = 0; i < list->count; i++)
        kg_state_destroy(states[i]);
    free(candidates.items);
    return status;
}

kg_status kg_fold_gaps(const kg_origami_state *state, const kg_fold *fold, kg_fold_gap **out_gaps,
                       size_t *out_count, kg_error *error) {
    kg_folding f;
    kg_fold outside = *fold;
    kg_origami_state *after = NULL;
    bool *moves = NULL;
    gaps list = {0};
    outside.between[0] = outside.between[1] = -1;
    kg_status status = kg_folding_create(state, &outside, &f, error);
    if (status)
        return status;
    status = kg_folding_pick(&f, &outside, error);
    if (!status)
        status = kg_folding_finish(&f, &outside, &after, &moves, error);
    if (!status)
        status = try_gaps(&f, &outside, after, moves, &list);
    kg_state_destroy(after);
    free(moves);
    kg_folding_clear(&f);
    if (status) {
        free(list.items);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
    }
    *out_gaps = list.items;
    *out_count = list.count;
    return KG_OK;
}
