#include "model/pairs.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

static void destroy_pair(kg_pair *pair) {
    kg_crossings_clear(&pair->seen[0]);
    kg_crossings_clear(&pair->seen[1]);
    free(pair);
}

static kg_pair **lookup(kg_pairs *pairs, int64_t a, int64_t b) {
    for (size_t i = 0; i < pairs->count; i++)
        if (pairs->items[i] && pairs->items[i]->id[0] == a && pairs->items[i]->id[1] == b)
            return &pairs->items[i];
    return NULL;
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
        if (status == KG_ERR_INPUT)
            return kg_fail_in(error, status, "patches %lld and %lld: ", (long long)lo->id,
                              (long long)hi->id);
        return status;
    }
    kg_crossings_swap(&pair->seen[1]);
    *out_pair = pair;
    return KG_OK;
}

kg_status kg_pairs_find(kg_pairs *pairs, kg_pairs *old, const kg_pair_side sides[2],
                        double tolerance, const kg_crossings **out_crossings, kg_error *error) {
    size_t low = sides[0].id < sides[1].id ? 0 : 1;
    const kg_pair_side *lo = &sides[low], *hi = &sides[1 - low];
    kg_pair **known = lookup(pairs, lo->id, hi->id), *pair = known ? *known : NULL;
    if (!pair) {
        kg_pair **lent = old ? lookup(old, lo->id, hi->id) : NULL;
        if (lent && (*lent)->input[0] == lo->input && (*lent)->input[1] == hi->input) {
            pair = *lent;
            *lent = NULL;
        } else {
            kg_status status = compute(lo, hi, tolerance, &pair, error);
            if (status)
                return status;
        }
        if (!kg_push(pairs, pair)) {
            destroy_pair(pair);
            return KG_ERR_MEMORY;
        }
    }
    *out_crossings = &pair->seen[low];
    return KG_OK;
}

void kg_pairs_clear(kg_pairs *pairs) {
    for (size_t i = 0; i < pairs->count; i++)
        if (pairs->items[i])
            destroy_pair(pairs->items[i]);
    free(pairs->items);
    *pairs = (kg_pairs){0};
}
