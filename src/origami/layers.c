#include "origami/layers.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_layers_create(kg_origami_state *s) {
    size_t loops = s->loops.count, words = kg_layer_words(loops);
    uint64_t *bits =
        loops < SIZE_MAX / 16 / words ? calloc(2 * loops + 1, words * sizeof *bits) : NULL;
    if (!bits)
        return KG_ERR_MEMORY;
    free(s->layers.bits);
    s->layers.bits = bits;
    s->layers.words = words;
    return KG_OK;
}

void kg_layers_empty(kg_origami_state *s) {
    memset(s->layers.bits, 0, 2 * s->loops.count * s->layers.words * sizeof *s->layers.bits);
}

/* Rows of 64 by 64 bits to columns (Warren, Hacker's Delight, 7-3). */
static void transpose(uint64_t block[64]) {
    uint64_t mask = 0x00000000ffffffff;
    for (int j = 32; j != 0; j >>= 1, mask ^= mask << j)
        for (int k = 0; k < 64; k = (k + j + 1) & ~j) {
            uint64_t swap = (block[k] >> j ^ block[k + j]) & mask;
            block[k] ^= swap << j;
            block[k + j] ^= swap;
        }
}

void kg_layers_mirror(kg_origami_state *s, const kg_outlines *o) {
    int32_t loops = (int32_t)s->loops.count;
    for (int32_t from = 0; from < loops; from += 64)
        for (int32_t to = from; to < loops; to += 64)
            for (int above = -1; above <= 1; above += 2) {
                uint64_t block[64] = {0}, any = 0;
                for (int32_t i = 0; i < 64 && from + i < loops; i++) {
                    block[i] = kg_layer_pile(s, o, from + i, above)[to / 64];
                    if (from == to) /* later ones only */
                        block[i] &= ~(uint64_t)1 << i;
                    any |= block[i];
                }
                if (any == 0)
                    continue;
                transpose(block);
                for (int32_t i = 0; i < 64 && to + i < loops; i++)
                    kg_layer_pile(s, o, to + i, -above)[from / 64] |= block[i];
            }
}

bool kg_layers_equal(const kg_origami_state *a, const kg_origami_state *b) {
    size_t words = 2 * a->loops.count * a->layers.words;
    return a->layers.words == b->layers.words &&
           (words == 0 || memcmp(a->layers.bits, b->layers.bits, words * sizeof(uint64_t)) == 0);
}

/* ---- questions -------------------------------------------------------------------------- */

int kg_origami_order(const kg_origami_state *s, int32_t a, int32_t b) {
    return s->layers.bits
               ? kg_bit_at(kg_layer_row(s, a, 1), b) - kg_bit_at(kg_layer_row(s, a, -1), b)
               : 0;
}

bool kg_origami_next_order(const kg_origami_state *s, kg_layer_order *order) {
    size_t words = s->layers.words;
    int32_t after = order->b;
    for (int32_t a = order->a; words > 0 && a < (int32_t)s->loops.count; a++, after = a) {
        const uint64_t *back = kg_layer_row(s, a, -1), *front = back + words;
        uint64_t wanted = ~(uint64_t)1 << (after & 63); /* of the first word */
        for (size_t w = (size_t)after / 64; w < words; w++, wanted = ~(uint64_t)0) {
            uint64_t both = (back[w] | front[w]) & wanted;
            if (both == 0)
                continue;
            int32_t bit = kg_bit_next(&both);
            *order = (kg_layer_order){a, (int32_t)(64 * w) + bit, front[w] >> bit & 1 ? 1 : -1};
            return true;
        }
    }
    return false;
}

size_t kg_origami_pair_count(const kg_origami_state *s) {
    size_t count = 0;
    for (size_t i = 0; i < 2 * s->loops.count * s->layers.words; i++)
        count += (size_t)__builtin_popcountll(s->layers.bits[i]);
    return count / 2;
}
