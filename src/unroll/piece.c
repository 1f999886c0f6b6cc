#include "unroll/piece.h"

#include "unroll/split.h"

#include <stdlib.h>

const kg_region_loop *kg_piece_loop(const kg_pieces *pieces, kg_edge_ref edge) {
    return &pieces->items[edge.piece].region->loops[edge.loop];
}

const kg_region_edge *kg_piece_edge(const kg_pieces *pieces, kg_edge_ref edge) {
    return &kg_piece_loop(pieces, edge)->edges[edge.edge];
}

const kg_patch *kg_piece_patch(const kg_pieces *pieces, size_t piece) {
    return &pieces->items[piece].patch->patch;
}

const kg_patch *kg_piece_cutter(const kg_pieces *pieces, const kg_region_edge *edge) {
    if (edge->kind != KG_EDGE_CUT)
        return NULL;
    return &kg_solution_find(pieces->solution, edge->source)->patch;
}

bool kg_piece_closed(const kg_pieces *pieces, kg_edge_ref edge) {
    return kg_piece_loop(pieces, edge)->edge_count == 1;
}

/* A position within the edge. */
static double wrapped(const kg_region_edge *edge, double position) {
    double count = (double)edge->count;
    return position > count ? position - count : position < 0 ? position + count : position;
}

kg_cross_point kg_piece_point(const kg_pieces *pieces, kg_edge_ref edge, double position,
                              kg_cross_point *out_slope) {
    const kg_region_loop *l = kg_piece_loop(pieces, edge);
    const kg_region_edge *e = kg_piece_edge(pieces, edge);
    position = wrapped(e, position);
    size_t i = (size_t)fmin(floor(position), (double)e->count - 1);
    double f = position - (double)i;
    if (!out_slope && (f == 0 || f == 1))
        return kg_region_edge_point(l, e, i + (f == 1));
    return kg_region_edge_at(kg_piece_patch(pieces, edge.piece), l, e, kg_piece_cutter(pieces, e),
                             i, f, out_slope);
}

/* ---- measures --------------------------------------------------------------------------- */

static kg_measure combined(kg_measure a, double sign, kg_measure b) {
    return (kg_measure){
        a.space_length + sign * b.space_length, a.paper_length + sign * b.paper_length,
        a.space_moment + sign * b.space_moment, a.paper_moment + sign * b.paper_moment};
}

/* The sums of an edge: as many as it has points, both ends included. */
static kg_measure *edge_sums(const kg_pieces *pieces, kg_edge_ref edge) {
    const kg_piece *p = &pieces->items[edge.piece];
    size_t at = p->first_sum;
    for (size_t k = 0; k < edge.loop; k++)
        at += p->region->loops[k].point_count + p->region->loops[k].edge_count;
    return pieces->sums + at + kg_piece_edge(pieces, edge)->first + edge.edge;
}

static kg_measure measure_directly(const kg_pieces *pieces, kg_edge_ref edge, double from,
                                   double to) {
    const kg_region_edge *e = kg_piece_edge(pieces, edge);
    return kg_region_edge_measure(kg_piece_patch(pieces, edge.piece), kg_piece_loop(pieces, edge),
                                  e, kg_piece_cutter(pieces, e), from, to);
}

/* From the start of the edge to a position in it. */
static kg_measure measure_up_to(const kg_pieces *pieces, kg_edge_ref edge, double position) {
    double whole = floor(position);
    kg_measure sum = edge_sums(pieces, edge)[(size_t)whole];
    return position == whole ? sum
                             : combined(sum, 1, measure_directly(pieces, edge, whole, position));
}

kg_measure kg_piece_measure(const kg_pieces *pieces, kg_edge_ref edge, double from, double to) {
    double count = (double)kg_piece_edge(pieces, edge)->count;
    if (from >= count && to > count) {
        from -= count;
        to -= count;
    }
    kg_measure m = combined(measure_up_to(pieces, edge, fmin(to, count)), -1,
                            measure_up_to(pieces, edge, from));
    return to > count ? combined(m, 1, measure_up_to(pieces, edge, to - count)) : m;
}

static kg_status measure_edges(kg_pieces *pieces) {
    size_t n = 0;
    for (size_t i = 0; i < pieces->count; i++) {
        pieces->items[i].first_sum = n;
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++)
            n += pieces->items[i].region->loops[k].point_count +
                 pieces->items[i].region->loops[k].edge_count;
    }
    pieces->sums = calloc(n + 1, sizeof *pieces->sums);
    if (!pieces->sums)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < pieces->count; i++)
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++)
            for (size_t e = 0; e < pieces->items[i].region->loops[k].edge_count; e++) {
                kg_edge_ref edge = {i, k, e};
                kg_measure *sums = edge_sums(pieces, edge);
                size_t count = kg_piece_edge(pieces, edge)->count;
                for (size_t q = 0; q < count; q++)
                    sums[q + 1] = combined(
                        sums[q], 1, measure_directly(pieces, edge, (double)q, (double)q + 1));
            }
    return KG_OK;
}

static int compare_edges(kg_edge_ref a, kg_edge_ref b) {
    if (a.piece != b.piece)
        return a.piece < b.piece ? -1 : 1;
    if (a.loop != b.loop)
        return a.loop < b.loop ? -1 : 1;
    return a.edge < b.edge ? -1 : a.edge > b.edge;
}

bool kg_same_edge(kg_edge_ref a, kg_edge_ref b) {
    return compare_edges(a, b) == 0;
}

void kg_piece_stretches(const kg_pieces *pieces, kg_edge_ref edge, size_t *out_first,
                        size_t *out_end) {
    size_t lo = 0, hi = pieces->stretch_count;
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        if (compare_edges(pieces->stretches[mid].edge, edge) < 0)
            lo = mid + 1;
        else
            hi = mid;
    }
    *out_first = lo;
    while (hi < pieces->stretch_count && kg_same_edge(pieces->stretches[hi].edge, edge))
        hi++;
    *out_end = hi;
}

/* ---- gathering -------------------------------------------------------------------------- */

typedef struct cut_key {
    int64_t source;
    kg_edge_ref edge;
} cut_key;

static int compare_cuts(const void *a, const void *b) {
    const cut_key *x = a, *y = b;
    if (x->source != y->source)
        return x->source < y->source ? -1 : 1;
    return compare_edges(x->edge, y->edge);
}

/* Lists all cut edges by source. */
static kg_status list_cuts(kg_pieces *pieces) {
    size_t n = 0;
    for (size_t i = 0; i < pieces->count; i++)
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++)
            n += pieces->items[i].region->loops[k].edge_count;
    cut_key *keys = calloc(n + 1, sizeof *keys);
    pieces->cuts = calloc(n + 1, sizeof *pieces->cuts);
    if (!keys || !pieces->cuts) {
        free(keys);
        return KG_ERR_MEMORY;
    }
    n = 0;
    for (size_t i = 0; i < pieces->count; i++)
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++) {
            const kg_region_loop *loop = &pieces->items[i].region->loops[k];
            for (size_t e = 0; e < loop->edge_count; e++)
                if (loop->edges[e].kind == KG_EDGE_CUT)
                    keys[n++] = (cut_key){loop->edges[e].source, {i, k, e}};
        }
    qsort(keys, n, sizeof *keys, compare_cuts);
    for (size_t i = 0; i < n; i++)
        pieces->cuts[i] = keys[i].edge;
    pieces->cut_count = n;
    free(keys);
    return KG_OK;
}

/* Cuts up a patch's regions that are too large for the room. */
static kg_status cut_up(kg_pieces *pieces, const kg_solved_patch *p, kg_vec2 room) {
    kg_trim trim = {&p->patch, kg_solution_finder(pieces->solution),
                    kg_solution_tolerance(pieces->solution), NULL};
    int64_t source = 1;
    kg_status status = KG_OK;
    for (size_t i = 0; i < p->regions.count && !status; i++, pieces->region_count++)
        if (room.x > 0 && p->valid && !p->construction)
            status = kg_split_to_fit(&trim, &p->regions.items[i], room, &source,
                                     &pieces->cut_up[pieces->region_count], NULL);
    return status;
}

/* Lists a patch's pieces; `first` is the number of its first region. */
static void add_pieces(kg_pieces *pieces, const kg_solved_patch *p, const kg_model_patch *model,
                       size_t first) {
    for (size_t k = 0; k < p->regions.count && p->valid && !p->construction; k++) {
        const kg_regions *cut = &pieces->cut_up[first + k];
        const kg_region *regions = cut->count ? cut->items : &p->regions.items[k];
        for (size_t i = 0; i < (cut->count ? cut->count : 1); i++)
            pieces->items[pieces->count++] = (kg_piece){p, model, &regions[i], 0};
    }
}

static kg_status gather(kg_pieces *pieces, const kg_model *model, kg_vec2 room) {
    size_t patches = kg_solution_count(pieces->solution), n = 0, first = 0;
    for (size_t i = 0; i < patches; i++)
        n += kg_solution_patch(pieces->solution, i)->regions.count;
    pieces->cut_up = calloc(n + 1, sizeof *pieces->cut_up);
    pieces->first_of_patch = calloc(patches + 1, sizeof *pieces->first_of_patch);
    if (!pieces->cut_up || !pieces->first_of_patch)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < patches; i++)
        if (cut_up(pieces, kg_solution_patch(pieces->solution, i), room))
            return KG_ERR_MEMORY;
    for (size_t i = 0; i < pieces->region_count; i++)
        n += pieces->cut_up[i].count;
    pieces->items = calloc(n + 1, sizeof *pieces->items);
    if (!pieces->items)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < patches; i++) {
        const kg_solved_patch *p = kg_solution_patch(pieces->solution, i);
        pieces->first_of_patch[i] = pieces->count;
        add_pieces(pieces, p, &model->patches[i], first);
        first += p->regions.count;
    }
    pieces->first_of_patch[patches] = pieces->count;
    return KG_OK;
}

kg_status kg_pieces_create(const kg_model *model, const kg_solution *solution, kg_vec2 room,
                           kg_pieces *out) {
    kg_pieces pieces = {.solution = solution};
    kg_status status = gather(&pieces, model, room);
    if (!status)
        status = list_cuts(&pieces);
    if (!status)
        status = measure_edges(&pieces);
    if (status) {
        kg_pieces_clear(&pieces);
        return status;
    }
    *out = pieces;
    return KG_OK;
}

void kg_pieces_clear(kg_pieces *pieces) {
    free(pieces->items);
    free(pieces->first_of_patch);
    for (size_t i = 0; i < pieces->region_count; i++)
        kg_regions_clear(&pieces->cut_up[i]);
    free(pieces->cut_up);
    free(pieces->cuts);
    free(pieces->sums);
    free(pieces->stretches);
    *pieces = (kg_pieces){0};
}
