#include "origami/layers.h"

#include <stdlib.h>

kg_status kg_layer_bits_create(size_t loops, kg_layer_bits *out) {
    size_t words = loops / 64 + 1;
    uint64_t *rows =
        loops < SIZE_MAX / 16 / words ? calloc(2 * loops + 1, words * sizeof *rows) : NULL;
    if (!rows)
        return KG_ERR_MEMORY;
    *out = (kg_layer_bits){loops, words, rows};
    return KG_OK;
}

void kg_layer_bits_clear(kg_layer_bits *bits) {
    free(bits->rows);
    *bits = (kg_layer_bits){0};
}

kg_status kg_layer_bits_read(const kg_origami_state *s, const kg_outlines *o, int32_t group,
                             int above, kg_layer_bits *out) {
    kg_status status = kg_layer_bits_create(s->loops.count, out);
    for (size_t i = 0; i < s->orders.count && !status; i++) {
        const kg_layer_order *p = &s->orders.items[i];
        int b_above = p->side * o->facing[p->a];
        int32_t low = b_above == above ? p->a : p->b;
        kg_layer_put(out, low, p->a ^ p->b ^ low, above);
        if (s->loops.items[p->a].group != group)
            kg_layer_put(out, p->a ^ p->b ^ low, low, -above);
    }
    return status;
}

kg_status kg_layer_bits_write(const kg_layer_bits *bits, const kg_outlines *o,
                              kg_origami_state *s) {
    size_t words = bits->words, count = 0;
    for (size_t i = 0; i < 2 * bits->count * words; i++)
        count += (size_t)__builtin_popcountll(bits->rows[i]);
    if (!kg_reserve(&s->orders, count))
        return KG_ERR_MEMORY;
    kg_layer_order *out = s->orders.items;
    for (size_t a = 0; a < bits->count; a++) {
        const uint64_t *below = kg_layer_row(bits, (int32_t)a, -1), *above = below + words;
        const uint64_t *front = o->facing[a] > 0 ? above : below;
        for (size_t w = a / 64; w < words; w++)
            for (uint64_t both = below[w] | above[w]; both != 0;) {
                int32_t bit = kg_bit_next(&both);
                *out++ = (kg_layer_order){(int32_t)a, (int32_t)(64 * w) + bit,
                                          front[w] >> bit & 1 ? 1 : -1};
            }
    }
    s->orders.count = count;
    return KG_OK;
}
