/*
 * Which loops lie on each other, as rows of bits: of each loop what lies on its back and what lies
 * on its front. Loops that move together keep their rows; in stacks, where most pairs overlap, a
 * bit is a hundredth of an entry of a list. Half a byte for each two loops that there are: 25 MB
 * for 10,000.
 */
#ifndef KG_ORIGAMI_LAYERS_H
#define KG_ORIGAMI_LAYERS_H

#include "origami/outline.h"

/* No loops on each other, with room for those that there are. KG_ERR_MEMORY. */
kg_status kg_layers_create(kg_origami_state *state);

/* No loops on each other any more. */
void kg_layers_empty(kg_origami_state *state);

/* Words of a row of bits, one for each loop. */
static inline size_t kg_layer_words(size_t loops) {
    return loops / 64 + 1;
}

/* What lies on the front of a loop (`side` 1) or on its back (-1). */
static inline uint64_t *kg_layer_row(const kg_origami_state *s, int32_t loop, int side) {
    return s->layers.bits + (2 * (size_t)loop + (side > 0)) * s->layers.words;
}

/* One word of what lies on a loop, on either side. */
static inline uint64_t kg_layer_any(const kg_origami_state *s, int32_t loop, size_t word) {
    return kg_layer_row(s, loop, -1)[word] | kg_layer_row(s, loop, 1)[word];
}

/* What lies on a loop along the group's normal (`above` 1) or against it (-1). */
static inline uint64_t *kg_layer_pile(const kg_origami_state *s, const kg_outlines *o, int32_t loop,
                                      int above) {
    return kg_layer_row(s, loop, above * o->facing[loop]);
}

static inline bool kg_bit_at(const uint64_t *row, int32_t bit) {
    return row[bit >> 6] >> (bit & 63) & 1;
}
static inline void kg_bit_set(uint64_t *row, int32_t bit) {
    row[bit >> 6] |= (uint64_t)1 << (bit & 63);
}
static inline void kg_bit_unset(uint64_t *row, int32_t bit) {
    row[bit >> 6] &= ~((uint64_t)1 << (bit & 63));
}

/* The lowest bit of a word that is not 0, taken out of it. */
static inline int32_t kg_bit_next(uint64_t *word) {
    int32_t bit = __builtin_ctzll(*word);
    *word &= *word - 1;
    return bit;
}

/* b lies above (1) or below (-1) a, along the group's normal: in the rows of both. */
static inline void kg_layer_put(kg_origami_state *s, const kg_outlines *o, int32_t a, int32_t b,
                                int above) {
    kg_bit_set(kg_layer_pile(s, o, a, above), b);
    kg_bit_set(kg_layer_pile(s, o, b, -above), a);
}

/* Of as many loops. */
bool kg_layers_equal(const kg_origami_state *a, const kg_origami_state *b);

/* Tells the later loops in every row what the row says of them. */
void kg_layers_mirror(kg_origami_state *state, const kg_outlines *outlines);

#endif
