/*
 * Crossings of pairs of patches, each computed once and seen from either patch.
 *
 * Both sides of a seam read the same points, so they fit to the last bit.
 */
#ifndef KG_MODEL_PAIRS_H
#define KG_MODEL_PAIRS_H

#include "katagami/crossing.h"

typedef struct kg_pair_side {
    int64_t id;
    uint64_t input; /* hash of what the patch is made from */
    const kg_patch *patch;
} kg_pair_side;

typedef struct kg_pair {
    int64_t id[2]; /* id[0] < id[1] */
    uint64_t input[2];
    kg_crossings seen[2]; /* with id[0] as A, with id[1] as A */
} kg_pair;

/* In the order of ids. */
typedef struct kg_pairs {
    kg_pair **items;
    size_t count, capacity;
} kg_pairs;

/* The crossings with sides[0] as A: from `pairs`, else computed and kept there, where they live as
 * long as `pairs`. */
kg_status kg_pairs_find(kg_pairs *pairs, const kg_pair_side sides[2], double tolerance,
                        const kg_crossings **out_crossings, kg_error *error) KG_CHECKED;

/* Moves to `pairs`, which is empty, all of `old` that `holds` says still hold; the rest is freed.
 */
kg_status kg_pairs_adopt(kg_pairs *pairs, kg_pairs *old,
                         bool (*holds)(const void *user, const kg_pair *pair),
                         const void *user) KG_CHECKED;
void kg_pairs_clear(kg_pairs *pairs);

#endif
