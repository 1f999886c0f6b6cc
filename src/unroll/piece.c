#include "unroll/piece.h"

#include "base/array.h"

#include <stdlib.h>

/* A point this many chord errors from another piece's boundary counts as on it: both boundaries
 * are polylines of the same curve, each off by one chord error. */
#define ON_EDGE 4.0

/* Stretches shorter than this, mm, hold no glue and are left out: corners where parts touch. */
#define SHORTEST 0.05

kg_status kg_pieces_create(const kg_model *model, const kg_solution *solution, kg_pieces *out) {
    kg_pieces pieces = {.solution = solution};
    size_t n = 0;
    for (size_t i = 0; i < kg_solution_count(solution); i++)
        n += kg_solution_patch(solution, i)->regions.count;
    pieces.items = calloc(n + 1, sizeof *pieces.items);
    if (!pieces.items)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < kg_solution_count(solution); i++) {
        const kg_solved_patch *p = kg_solution_patch(solution, i);
        for (size_t k = 0; k < p->regions.count && p->valid && !p->construction; k++)
            pieces.items[pieces.count++] =
                (kg_piece){p, &model->patches[i], &p->regions.items[k], k};
    }
    *out = pieces;
    return KG_OK;
}

void kg_pieces_clear(kg_pieces *pieces) {
    free(pieces->items);
    free(pieces->stretches);
    *pieces = (kg_pieces){0};
}

const kg_patch *kg_piece_cutter(const kg_pieces *pieces, const kg_region_edge *edge) {
    if (edge->kind != KG_EDGE_CUT)
        return NULL;
    return &kg_solution_find(pieces->solution, edge->source)->patch;
}

kg_cross_point kg_piece_point(const kg_pieces *pieces, size_t piece, size_t loop, size_t edge,
                              double position, kg_cross_point *out_slope) {
    const kg_piece *p = &pieces->items[piece];
    const kg_region_loop *l = &p->region->loops[loop];
    const kg_region_edge *e = &l->edges[edge];
    size_t i = (size_t)fmin(floor(position), (double)e->count - 1);
    double f = position - (double)i;
    if (!out_slope && (f == 0 || f == 1))
        return kg_region_edge_point(l, e, i + (f == 1));
    return kg_region_edge_at(&p->patch->patch, l, e, kg_piece_cutter(pieces, e), i, f, out_slope);
}

/* ---- where a point of an edge lies on another patch -------------------------------------- */

typedef enum lie { FREE, INSIDE, ON_BOUNDARY } lie;

typedef struct place {
    lie kind;
    size_t piece;
} place;

static bool same_place(place a, place b) {
    return a.kind == b.kind && a.piece == b.piece;
}

/* Distance in the (u, v L) plane from a point to a loop, given up on beyond `near`. */
static bool near_loop(const kg_region_loop *loop, double scale, double u, double v, double near) {
    kg_vec2 at = kg_v2(u, v * scale);
    const kg_cross_point *p = &loop->points[loop->point_count - 1];
    kg_vec2 a = kg_v2(p->u, p->v * scale);
    for (size_t i = 0; i < loop->point_count; i++) {
        kg_vec2 b = kg_v2(loop->points[i].u, loop->points[i].v * scale);
        bool far = at.x < fmin(a.x, b.x) - near || at.x > fmax(a.x, b.x) + near ||
                   at.y < fmin(a.y, b.y) - near || at.y > fmax(a.y, b.y) + near;
        if (!far) {
            kg_vec2 d = kg_sub2(b, a);
            double n = kg_dot2(d, d), f = n > 0 ? kg_dot2(kg_sub2(at, a), d) / n : 0;
            if (kg_dist2(at, kg_lerp2(a, b, fmin(fmax(f, 0), 1))) <= near)
                return true;
        }
        a = b;
    }
    return false;
}

static place locate(const kg_pieces *pieces, int64_t patch, double s, double t) {
    double near = ON_EDGE * kg_solution_tolerance(pieces->solution);
    place found = {FREE, 0};
    for (size_t i = 0; i < pieces->count; i++) {
        const kg_piece *p = &pieces->items[i];
        if (p->patch->id != patch)
            continue;
        double scale = p->patch->patch.length_at[KG_PATCH_CELLS];
        for (size_t k = 0; k < p->region->loop_count; k++)
            if (near_loop(&p->region->loops[k], scale, s, t, near))
                return (place){ON_BOUNDARY, i};
        if (kg_region_contains(p->region, s, t))
            found = (place){INSIDE, i};
    }
    return found;
}

/* ---- stretches -------------------------------------------------------------------------- */

typedef struct walk {
    kg_pieces *pieces;
    size_t piece, loop, edge;
    int64_t source;
} walk;

static place place_at(const walk *w, double position) {
    kg_cross_point p = kg_piece_point(w->pieces, w->piece, w->loop, w->edge, position, NULL);
    return locate(w->pieces, w->source, p.s, p.t);
}

static kg_status add_stretch(const walk *w, double from, double to, place at) {
    const kg_piece *p = &w->pieces->items[w->piece];
    const kg_region_loop *loop = &p->region->loops[w->loop];
    const kg_region_edge *e = &loop->edges[w->edge];
    double length =
        kg_region_edge_measure(&p->patch->patch, loop, e, kg_piece_cutter(w->pieces, e), from, to)
            .space_length;
    if (at.kind == FREE || length < SHORTEST)
        return KG_OK;
    kg_pieces *all = w->pieces;
    if (!kg_reserve_bytes((void **)&all->stretches, &all->stretch_capacity, all->stretch_count + 1,
                          sizeof *all->stretches))
        return KG_ERR_MEMORY;
    size_t own = all->stretch_count++;
    all->stretches[own] = (kg_stretch){.piece = w->piece,
                                       .loop = w->loop,
                                       .edge = w->edge,
                                       .from = from,
                                       .to = to,
                                       .partner = at.piece,
                                       .on_edge = at.kind == ON_BOUNDARY,
                                       .mate = own};
    all->stretches[own].ends[0] = kg_piece_point(all, w->piece, w->loop, w->edge, from, NULL);
    all->stretches[own].ends[1] = kg_piece_point(all, w->piece, w->loop, w->edge, to, NULL);
    return KG_OK;
}

/* Where the place changes between two positions, snapped to a point of the edge that is there. */
static double change_between(const walk *w, double lo, double hi, place before) {
    double middle = floor(hi);
    for (int k = 0; k < 48; k++) {
        double mid = 0.5 * (lo + hi);
        if (same_place(place_at(w, mid), before))
            lo = mid;
        else
            hi = mid;
    }
    double at = 0.5 * (lo + hi);
    kg_cross_point p = kg_piece_point(w->pieces, w->piece, w->loop, w->edge, at, NULL);
    kg_cross_point q = kg_piece_point(w->pieces, w->piece, w->loop, w->edge, middle, NULL);
    /* The places on either side of a corner blur over ON_EDGE chord errors, at flat angles over
     * several times that. */
    double blur = 10 * ON_EDGE * kg_solution_tolerance(w->pieces->solution);
    return kg_dist(p.x, q.x) <= blur ? middle : at;
}

static kg_status walk_edge(const walk *w, size_t count) {
    double from = 0;
    place current = place_at(w, 0.5);
    kg_status status = KG_OK;
    for (size_t i = 1; i < count && !status; i++) {
        place next = place_at(w, (double)i + 0.5);
        if (same_place(next, current))
            continue;
        double at = change_between(w, (double)i - 0.5, (double)i + 0.5, current);
        if (at > from)
            status = add_stretch(w, from, at, current);
        from = at;
        current = next;
    }
    return status ? status : add_stretch(w, from, (double)count, current);
}

/* Two stretches are mates when each lies on the other's piece and their ends coincide. */
static void mate_stretches(kg_pieces *all) {
    double near = 20 * ON_EDGE * kg_solution_tolerance(all->solution);
    for (size_t i = 0; i < all->stretch_count; i++)
        for (size_t j = i + 1; j < all->stretch_count; j++) {
            kg_stretch *a = &all->stretches[i], *b = &all->stretches[j];
            bool fit = a->mate == i && b->mate == j && a->on_edge && b->on_edge &&
                       a->partner == b->piece && b->partner == a->piece;
            if (!fit)
                continue;
            bool same = kg_dist(a->ends[0].x, b->ends[0].x) <= near &&
                        kg_dist(a->ends[1].x, b->ends[1].x) <= near;
            bool opposite = kg_dist(a->ends[0].x, b->ends[1].x) <= near &&
                            kg_dist(a->ends[1].x, b->ends[0].x) <= near;
            if (!same && !opposite)
                continue;
            /* closed stretches fit both ways: a quarter of the way in tells the direction */
            if (same && opposite) {
                kg_vec3 qa = kg_piece_point(all, a->piece, a->loop, a->edge,
                                            0.75 * a->from + 0.25 * a->to, NULL)
                                 .x;
                kg_vec3 b1 = kg_piece_point(all, b->piece, b->loop, b->edge,
                                            0.75 * b->from + 0.25 * b->to, NULL)
                                 .x;
                kg_vec3 b3 = kg_piece_point(all, b->piece, b->loop, b->edge,
                                            0.25 * b->from + 0.75 * b->to, NULL)
                                 .x;
                opposite = kg_dist(qa, b3) < kg_dist(qa, b1);
            }
            a->mate = j, b->mate = i;
            a->mate_reversed = b->mate_reversed = opposite;
        }
}

kg_status kg_pieces_find_stretches(kg_pieces *pieces) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < pieces->count; i++)
        for (size_t k = 0; k < pieces->items[i].region->loop_count; k++) {
            const kg_region_loop *loop = &pieces->items[i].region->loops[k];
            for (size_t e = 0; e < loop->edge_count && !status; e++) {
                walk w = {pieces, i, k, e, loop->edges[e].source};
                if (loop->edges[e].kind == KG_EDGE_CUT)
                    status = walk_edge(&w, loop->edges[e].count);
            }
        }
    if (!status)
        mate_stretches(pieces);
    return status;
}
