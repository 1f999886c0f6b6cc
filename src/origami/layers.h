/*
 * Orders as rows of bits: smaller and faster than lists in stacks, where most pairs overlap. Takes
 * half a byte for each two loops that there are, overlapping or not: 50 MB for 10,000.
 */
#ifndef KG_ORIGAMI_LAYERS_H
#define KG_ORIGAMI_LAYERS_H

#include "origami/outline.h"

typedef struct kg_layer_bits {
    size_t count, words; /* loops; words of one row */
    uint64_t *rows;      /* two for each loop: what lies below it, what lies above */
} kg_layer_bits;

/* No loops on each other. KG_ERR_MEMORY. */
kg_status kg_layer_bits_create(size_t loops, kg_layer_bits *out);
/* The orders of a state: each pair in the rows of both loops, but in `group` only what lies on the
 * side `above` of a loop in the row of that one. KG_ERR_MEMORY. */
kg_status kg_layer_bits_read(const kg_origami_state *state, const kg_outlines *outlines,
                             int32_t group, int above, kg_layer_bits *out);
/* Makes the rows the orders of a state; only pairs in the rows of their smaller loop count.
 * KG_ERR_MEMORY. */
kg_status kg_layer_bits_write(const kg_layer_bits *bits, const kg_outlines *outlines,
                              kg_origami_state *state);
void kg_layer_bits_clear(kg_layer_bits *bits);

/* What lies on a loop along the group's normal (`above` 1) or against it (-1). */
static inline uint64_t *kg_layer_row(const kg_layer_bits *bits, int32_t loop, int above) {
    return bits->rows + (2 * (size_t)loop + (above > 0)) * bits->words;
}

/* b lies above (1) or below (-1) a: in the row of a. */
static inline void kg_layer_put(kg_layer_bits *bits, int32_t a, int32_t b, int above) {
    kg_layer_row(bits, a, above)[b >> 6] |= (uint64_t)1 << (b & 63);
}

/* The lowest bit of a word that is not 0, taken out of it. */
static inline int32_t kg_bit_next(uint64_t *word) {
    int32_t bit = __builtin_ctzll(*word);
    *word &= *word - 1;
    return bit;
}

#endif
