#include "model/pairs.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

static void destroy_pair(kg_pair *pair) {
    kg_crossings_clear(&pair->seen[0]);
    kg_crossings_clear(&pair->seen[1]);
    free(pair);
}

/* Where the pair is, or would be put. */
static size_t position_of(const kg_pairs *pairs, int64_t lo_id, int64_t hi_id) {
    size_t lo = 0, hi = pairs->count;
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        const int64_t *id = pairs->items[mid]->id;
        if (id[0] < lo_id || (id[0] == lo_id && id[1] < hi_id))
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

static kg_status copy_crossings(const kg_crossings *from, kg_crossings *out) {
    kg_crossings copy = {.branches = calloc(from->count + 1, sizeof *copy.branches)};
    if (!copy.branches)
        return KG_ERR_MEMORY;
    for (; copy.count < from->count; copy.count++) {
        const kg_crossing *b = &from->branches[copy.count];
        kg_crossing *c = &copy.branches[copy.count];
        *c = *b;
        c->points = malloc(b->count * sizeof *c->points);
        if (!c->points) {
            kg_crossings_clear(&copy);
            return KG_ERR_MEMORY;
        }
        memcpy(c->points, b->points, b->count * sizeof *c->points);
    }
    *out = copy;
    return KG_OK;
}

static kg_status compute(const kg_pair_side *lo, const kg_pair_side *hi, double tolerance,
                         kg_pair **out_pair, kg_error *error) {
    kg_pair *pair = calloc(1, sizeof *pair);
    if (!pair)
        return KG_ERR_MEMORY;
    *pair = (kg_pair){{lo->id, hi->id}, {lo->input, hi->input}, {{0}, {0}}};
    kg_status status = kg_crossings_find(lo->patch, hi->patch, tolerance, &pair->seen[0], error);
    if (!status)
        status = copy_crossings(&pair->seen[0], &pair->seen[1]);
    if (status) {
        destroy_pair(pair);
        return status;
    }
    kg_crossings_swap(&pair->seen[1]);
    *out_pair = pair;
    return KG_OK;
}

kg_status kg_pairs_find(kg_pairs *pairs, const kg_pair_side sides[2], double tolerance,
                        const kg_crossings **out_crossings, kg_error *error) {
    size_t low = sides[0].id < sides[1].id ? 0 : 1;
    const kg_pair_side *lo = &sides[low], *hi = &sides[1 - low];
    size_t at = position_of(pairs, lo->id, hi->id);
    bool known =
        at < pairs->count && pairs->items[at]->id[0] == lo->id && pairs->items[at]->id[1] == hi->id;
    if (!known) {
        kg_pair *pair = NULL;
        kg_status status = compute(lo, hi, tolerance, &pair, error);
        if (status)
            return status;
        if (!kg_push(pairs, pair)) {
            destroy_pair(pair);
            return KG_ERR_MEMORY;
        }
        memmove(pairs->items + at + 1, pairs->items + at,
                (pairs->count - 1 - at) * sizeof *pairs->items);
        pairs->items[at] = pair;
    }
    *out_crossings = &pairs->items[at]->seen[low];
    return KG_OK;
}

kg_status kg_pairs_adopt(kg_pairs *pairs, kg_pairs *old,
                         bool (*holds)(const void *user, const kg_pair *pair), const void *user) {
    if (!kg_reserve(pairs, old->count))
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < old->count; i++) {
        if (holds(user, old->items[i]))
            pairs->items[pairs->count++] = old->items[i];
        else
            destroy_pair(old->items[i]);
    }
    old->count = 0;
    return KG_OK;
}

void kg_pairs_clear(kg_pairs *pairs) {
    for (size_t i = 0; i < pairs->count; i++)
        destroy_pair(pairs->items[i]);
    free(pairs->items);
    *pairs = (kg_pairs){0};
}
