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

typedef struct kg_pairs {
    kg_pair **items;
    size_t count, capacity;
} kg_pairs;

/* The crossings with sides[0] as A: from `pairs`, else taken over from `old` (may be NULL) where
 * neither patch changed, else computed. The result lives as long as `pairs`. */
kg_status kg_pairs_find(kg_pairs *pairs, kg_pairs *old, const kg_pair_side sides[2],
                        double tolerance, const kg_crossings **out_crossings,
                        kg_error *error) KG_CHECKED;
void kg_pairs_clear(kg_pairs *pairs);

#endif
