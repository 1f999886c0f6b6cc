/* Crease patterns as nets. */
#include "origami/origami.h"
#include "origami/state.h"

#include <stdlib.h>

/* Paper has y up, pages have it down. */
static kg_vec2 on_page(const kg_origami_state *s, int32_t half) {
    kg_vec2 p = s->vertices.items[s->halves.items[half].origin].paper;
    return kg_v2(p.x, -p.y);
}

static bool is_border(const kg_origami_state *s, int32_t half) {
    return kg_loop_of(s, half) >= 0 && kg_loop_of(s, kg_twin(half)) < 0;
}

/* The border that follows: around the end's loops to the next one without a neighbour. */
static int32_t next_border(const kg_origami_state *s, int32_t half) {
    int32_t h = kg_next(s, half);
    while (!is_border(s, h))
        h = kg_next(s, kg_twin(h));
    return h;
}

typedef struct outline {
    kg_vec2 *items;
    size_t count, capacity;
} outline;

static double area_of(const outline *o) {
    double twice = 0;
    for (size_t i = 0; i < o->count; i++)
        twice += kg_cross2(o->items[i], o->items[(i + 1) % o->count]);
    return twice / 2;
}

/* Contours of one sheet: the outer one first, running as nets want it, then holes. */
static kg_status add_contours(const kg_origami_state *s, int32_t sheet, kg_net *net, size_t part,
                              kg_error *error) {
    bool *done = calloc(s->halves.count + 1, sizeof *done);
    kg_status status = done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (int holes = 0; holes < 2 && !status; holes++) {
        for (size_t h = 0; h < s->halves.count; h++)
            done[h] = false;
        for (size_t h = 0; h < s->halves.count && !status; h++) {
            outline o = {0};
            if (done[h] || !is_border(s, (int32_t)h) ||
                s->loops.items[kg_loop_of(s, (int32_t)h)].sheet != sheet)
                continue;
            bool ok = true;
            double length = 0;
            for (int32_t k = (int32_t)h; !done[k]; k = next_border(s, k)) {
                done[k] = true;
                ok = ok && kg_push(&o, on_page(s, k));
                length += kg_dist2(on_page(s, k), on_page(s, kg_twin(k)));
            }
            /* mirrored by y, so it runs the other way round */
            for (size_t a = 0, b = o.count - 1; ok && a < b; a++, b--) {
                kg_vec2 swap = o.items[a];
                o.items[a] = o.items[b], o.items[b] = swap;
            }
            if (!ok)
                status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
            else if ((area_of(&o) < 0) == holes) {
                status = kg_net_add_loop(net, part, o.items, NULL, o.count, error);
                net->parts[part].perimeter += length;
            }
            free(o.items);
        }
    }
    free(done);
    return status;
}

static kg_status add_creases(const kg_origami_state *s, int32_t sheet, kg_net *net, size_t part,
                             kg_error *error) {
    for (size_t e = 0; e < s->edges.count; e++) {
        const kg_paper_edge *edge = &s->edges.items[e];
        int32_t h = (int32_t)(2 * e), loop = kg_loop_of(s, h);
        if (edge->kind != KG_PAPER_CREASE || loop < 0 || s->loops.items[loop].sheet != sheet)
            continue;
        kg_vec2 ends[2] = {on_page(s, h), on_page(s, h + 1)};
        kg_net_line line = {.kind = edge->angle > 0   ? KG_NET_VALLEY
                                    : edge->angle < 0 ? KG_NET_MOUNTAIN
                                                      : KG_NET_MARK,
                            .count = 2,
                            .points = ends,
                            .join = -1};
        kg_status status = kg_net_add_line(net, part, &line, NULL, error);
        if (status)
            return status;
    }
    return KG_OK;
}

kg_status kg_origami_net(const kg_origami *o, size_t step, kg_net **out_net, kg_error *error) {
    const kg_origami_state *s = o->states.items[step];
    int32_t sheets = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        sheets = s->loops.items[i].sheet + 1 > sheets ? s->loops.items[i].sheet + 1 : sheets;
    kg_net *net = kg_net_create();
    kg_status status = net ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (int32_t sheet = 0; sheet < sheets && !status; sheet++) {
        size_t part;
        status = kg_net_add_part(net, sheet + 1, NULL, &part, error);
        if (!status)
            status = add_contours(s, sheet, net, part, error);
        if (!status)
            status = add_creases(s, sheet, net, part, error);
        if (status)
            break;
        for (size_t i = 0; i < net->parts[part].loop_count; i++) {
            const kg_net_line *l = &net->parts[part].loops[i].line;
            net->parts[part].area += area_of(&(outline){l->points, l->count, l->count});
        }
        net->parts[part].surface = net->parts[part].area;
    }
    if (status) {
        kg_net_destroy(net);
        return status;
    }
    *out_net = net;
    return KG_OK;
}
