/* Heights to draw layers at. */
#include "origami/convex.h"
#include "origami/layers.h"

#include <stdlib.h>

/* Longest chains of loops from the lowest up, per loop (Kahn 1962). What is in a ring, or above
 * one, gets -1. */
static kg_status find_levels(const kg_origami_state *s, const kg_outlines *o, int32_t *levels) {
    size_t n = s->loops.count, count = 0;
    int32_t *below = calloc(n + 1, sizeof *below), *todo = malloc((n + 1) * sizeof *todo);
    kg_status status = below && todo ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        levels[i] = -1;
        const uint64_t *row = kg_layer_pile(s, o, (int32_t)i, -1);
        for (size_t w = 0; w < s->layers.words; w++)
            below[i] += __builtin_popcountll(row[w]);
        if (below[i] == 0) {
            levels[i] = 0;
            todo[count++] = (int32_t)i;
        }
    }
    /* `levels` of loops not yet reached hold the chain so far, less 2 */
    for (size_t t = 0; t < count && !status; t++) {
        int32_t loop = todo[t];
        const uint64_t *row = kg_layer_pile(s, o, loop, 1);
        for (size_t w = 0; w < s->layers.words; w++)
            for (uint64_t bits = row[w]; bits != 0;) {
                int32_t other = (int32_t)(64 * w) + kg_bit_next(&bits), chain = -3 - levels[loop];
                levels[other] = chain < levels[other] ? chain : levels[other];
                if (--below[other] == 0) {
                    levels[other] = -2 - levels[other];
                    todo[count++] = other;
                }
            }
    }
    for (size_t i = 0; i < n && !status; i++)
        levels[i] = levels[i] < 0 ? -1 : levels[i];
    free(below);
    free(todo);
    return status;
}

static bool holds(const kg_outlines *o, int32_t loop, kg_vec2 p) {
    const kg_vec2 *q = kg_outline_points(o, loop);
    size_t n = kg_outline_size(o, loop);
    for (size_t i = 0; i < n; i++)
        if (kg_cross2(kg_sub2(q[i + 1 < n ? i + 1 : 0], q[i]), kg_sub2(p, q[i])) <= 0)
            return false;
    return true;
}

/* How many layers lie below a loop just beside a corner. */
static double count_below(const kg_origami_state *s, const kg_outlines *o, int32_t loop,
                          kg_vec2 corner) {
    const kg_vec2 *q = kg_outline_points(o, loop);
    kg_vec2 middle = kg_v2(0, 0);
    size_t n = kg_outline_size(o, loop), below = 0;
    for (size_t i = 0; i < n; i++)
        middle = kg_add2(middle, kg_scale2(q[i], 1 / (double)n));
    kg_vec2 p = kg_lerp2(corner, middle, 0.02);
    const uint64_t *row = kg_layer_pile(s, o, loop, -1);
    for (size_t w = 0; w < s->layers.words; w++)
        for (uint64_t bits = row[w]; bits != 0;)
            below += holds(o, (int32_t)(64 * w) + kg_bit_next(&bits), p);
    return (double)below;
}

kg_status kg_origami_heights(const kg_origami_state *s, double *out_heights, kg_error *error) {
    kg_outlines o = {0};
    int32_t *levels = malloc((s->loops.count + 1) * sizeof *levels);
    bool *rings = calloc(s->groups.count + 1, sizeof *rings);
    kg_status status = levels && rings ? kg_outlines_create(s, &o) : KG_ERR_MEMORY;
    if (!status)
        status = find_levels(s, &o, levels);
    for (size_t i = 0; i < s->loops.count && !status; i++)
        rings[s->loops.items[i].group] |= levels[i] < 0;
    for (size_t h = 0; h < s->halves.count && !status; h++) {
        int32_t loop = s->halves.items[h].loop;
        out_heights[h] = loop < 0 ? 0 : levels[loop];
        if (loop < 0 || !rings[s->loops.items[loop].group])
            continue;
        kg_vec3 u, v, p = *kg_origin(s, (int32_t)h);
        kg_plane_axes(s->groups.items[s->loops.items[loop].group].normal, &u, &v);
        out_heights[h] = count_below(s, &o, loop, kg_v2(kg_dot(u, p), kg_dot(v, p)));
    }
    free(levels);
    free(rings);
    kg_outlines_clear(&o);
    return status ? kg_fail(error, status, "out of memory") : KG_OK;
}
