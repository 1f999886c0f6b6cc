/* States just before a fold, with the topology after it. */
#include "guide/diagram.h"

#include "origami/state.h"

#include <stdlib.h>

/* Corners of cut loops take over the mean height of the whole. */
static kg_status find_heights(kg_moment *m, kg_error *error) {
    const kg_origami_state *s = m->topology, *before = m->layers;
    double *heights = calloc(before->halves.count + 1, sizeof *heights);
    double *means = calloc(before->loops.count + 1, sizeof *means);
    kg_status status = heights && means ? kg_origami_heights(before, heights, error)
                                        : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < before->loops.count && !status; i++) {
        int32_t first = before->loops.items[i].first, h = first;
        double count = 0;
        do {
            means[i] += heights[h];
            count++;
        } while ((h = before->halves.items[h].next) != first);
        means[i] /= count;
    }
    for (size_t h = 0; h < s->halves.count && !status; h++) {
        int32_t loop = s->halves.items[h].loop;
        if (loop < 0)
            continue;
        bool same = h < before->halves.count && before->halves.items[h].loop == loop &&
                    before->halves.items[h].origin == s->halves.items[h].origin;
        m->heights[h] = same ? heights[h] : means[m->parents[loop]];
    }
    free(heights);
    free(means);
    return status;
}

kg_status kg_moment_create(const kg_origami *o, size_t step, kg_moment *out, kg_error *error) {
    bool folds = step < kg_origami_step(o);
    kg_moment m = {.topology = kg_origami_state_at(o, folds ? step + 1 : step),
                   .layers = kg_origami_state_at(o, step)};
    const kg_origami_state *s = m.topology;
    m.positions = calloc(s->vertices.count + 1, sizeof *m.positions);
    m.parents = calloc(s->loops.count + 1, sizeof *m.parents);
    m.moves = calloc(s->loops.count + 1, sizeof *m.moves);
    m.heights = calloc(s->halves.count + 1, sizeof *m.heights);
    kg_status status = m.positions && m.parents && m.moves && m.heights
                           ? KG_OK
                           : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status && folds)
        kg_origami_between(o, step, 0, m.positions);
    for (size_t i = 0; i < s->vertices.count && !status && !folds; i++)
        m.positions[i] = s->vertices.items[i].position;
    for (size_t h = 0; h < s->halves.count && !status; h++) {
        int32_t loop = s->halves.items[h].loop, v = s->halves.items[h].origin;
        if (loop >= 0 && kg_dist(m.positions[v], s->vertices.items[v].position) > s->touch)
            m.moves[loop] = true;
    }
    for (size_t i = 0; i < s->loops.count && !status; i++)
        m.parents[i] = kg_loop_in(m.layers, s, (int32_t)i);
    if (!status)
        status = find_heights(&m, error);
    if (status) {
        kg_moment_clear(&m);
        return status;
    }
    *out = m;
    return KG_OK;
}

void kg_moment_clear(kg_moment *m) {
    free(m->positions);
    free(m->parents);
    free(m->moves);
    free(m->heights);
    *m = (kg_moment){0};
}
