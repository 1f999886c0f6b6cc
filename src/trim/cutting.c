#include "trim/cutting.h"

#include "base/array.h"
#include "trim/region.h"

#include <stdlib.h>
#include <string.h>

/* A prolonged cut runs on past what it meets by this fraction of the patch, so that the two truly
 * cross and the node can be polished; the rest dangles and is dropped. */
#define OVERSHOOT 1e-5

kg_status kg_trim_note_add(const kg_trim *trim, kg_trim_note note) {
    if (trim->notes && !kg_push(trim->notes, note))
        return KG_ERR_MEMORY;
    return KG_OK;
}

/* ---- chains of a cut -------------------------------------------------------------------- */

static kg_status add_span(const kg_cut *cut, const kg_points *points, bool closed,
                          kg_chains *chains) {
    if (points->count < 2)
        return KG_OK;
    kg_cross_point *copy = malloc(points->count * sizeof *copy);
    if (!copy)
        return KG_ERR_MEMORY;
    memcpy(copy, points->items, points->count * sizeof *copy);
    return kg_chains_add(chains, (kg_chain){.kind = KG_EDGE_CUT,
                                            .source = cut->source,
                                            .other = cut->cutter,
                                            .closed = closed,
                                            .count = points->count,
                                            .points = copy});
}

static bool on_loop(const kg_patch *patch, const kg_region_loop *loop, kg_vec2 at) {
    double near = KG_CROSSING_EXACT * patch->size;
    size_t n = loop->point_count;
    const kg_cross_point *p = loop->points;
    for (size_t i = 0, j = n - 1; i < n; j = i++) {
        kg_vec2 a = kg_plane(patch, p[j].u, p[j].v), b = kg_plane(patch, p[i].u, p[i].v);
        if (kg_dist2(kg_lerp2(a, b, kg_nearest_fraction(at, a, b)), at) <= near)
            return true;
    }
    return false;
}

/* Is a point of the cutter in what is left of it? The boundary counts: where the cutter was cut by
 * the patch that it cuts now, the two end on each other. */
static bool is_left(const kg_cut *cut, double s, double t) {
    const kg_region *regions = cut->bounded->items;
    for (size_t i = 0; i < cut->bounded->count; i++) {
        if (kg_region_contains(&regions[i], s, t))
            return true;
        for (size_t k = 0; k < regions[i].loop_count; k++)
            if (on_loop(cut->cutter, &regions[i].loops[k], kg_plane(cut->cutter, s, t)))
                return true;
    }
    return false;
}

/* Where a span of a branch enters or leaves the cutter's regions, by bisection. */
static kg_cross_point region_border(const kg_patch *patch, const kg_cut *cut,
                                    const kg_crossing *branch, size_t i, bool starts_inside) {
    double lo = 0, hi = 1;
    kg_cross_point at = branch->points[i];
    for (int k = 0; k < 50; k++) {
        double mid = 0.5 * (lo + hi);
        at = kg_crossing_at(patch, cut->cutter, branch, i, mid, NULL);
        if (is_left(cut, at.s, at.t) == starts_inside)
            lo = mid;
        else
            hi = mid;
    }
    return at;
}

static kg_status add_bounded(const kg_patch *patch, const kg_cut *cut, const kg_crossing *branch,
                             kg_chains *chains) {
    kg_points run = {0};
    kg_status status = KG_OK;
    bool inside = is_left(cut, branch->points[0].s, branch->points[0].t), whole = true;
    for (size_t i = 0; i < branch->count && !status; i++) {
        const kg_cross_point *p = &branch->points[i];
        bool now = is_left(cut, p->s, p->t);
        if (now != inside) {
            kg_cross_point border = region_border(patch, cut, branch, i - 1, inside);
            status = kg_push(&run, border) ? KG_OK : KG_ERR_MEMORY;
            if (!status && inside) {
                status = add_span(cut, &run, false, chains);
                run.count = 0;
            }
            whole = false;
            inside = now;
        }
        if (!status && now && !kg_push(&run, *p))
            status = KG_ERR_MEMORY;
    }
    if (!status && inside)
        status = add_span(cut, &run, whole && branch->closed, chains);
    free(run.items);
    return status;
}

kg_status kg_cut_chains(const kg_patch *patch, const kg_cut *cut, kg_chains *chains) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < cut->crossings->count && !status; i++) {
        const kg_crossing *b = &cut->crossings->branches[i];
        if (cut->bounded) {
            status = add_bounded(patch, cut, b, chains);
        } else {
            kg_points all = {b->points, b->count, b->count};
            status = add_span(cut, &all, b->closed, chains);
        }
    }
    return status;
}

/* ---- loose ends ------------------------------------------------------------------------- */

static kg_vec2 end_plane(const kg_patch *p, const kg_chain *c, bool last, kg_vec2 *out_ahead) {
    const kg_cross_point *e = &c->points[last ? c->count - 1 : 0];
    kg_cross_point slope;
    kg_chain_at(p, c, last ? c->count - 2 : 0, last ? 1 : 0, &slope);
    kg_vec2 d = kg_plane(p, slope.u, slope.v);
    double n = kg_len2(d);
    *out_ahead = n > 0 ? kg_scale2(d, (last ? 1 : -1) / n) : kg_v2(0, 0);
    return kg_plane(p, e->u, e->v);
}

/* A straight tail from a chain's end to a place in the plane. */
static kg_status add_tail(const kg_trim *t, size_t chain, bool last, kg_vec2 to,
                          kg_trim_note_kind kind, kg_chains *chains) {
    const kg_patch *p = t->patch;
    const kg_chain *c = &chains->items[chain];
    kg_cross_point end = c->points[last ? c->count - 1 : 0];
    int64_t source = c->source;
    kg_vec2 from = kg_v2(end.u, end.v), goal = kg_v2(to.x, to.y / p->length_at[KG_PATCH_CELLS]);
    kg_points points = {0};
    kg_status status = kg_sample_straight(p, from, goal, t->tolerance, &points);
    kg_cross_point head = {.u = goal.x, .v = goal.y, .x = kg_patch_point(p, goal.x, goal.y)};
    if (!status && !kg_push(&points, head))
        status = KG_ERR_MEMORY;
    if (status) {
        free(points.items);
        return status;
    }
    double length = 0;
    for (size_t i = 1; i < points.count; i++)
        length += kg_dist(points.items[i - 1].x, points.items[i].x);
    if (kind == KG_NOTE_PROLONGED)
        length -= OVERSHOOT * p->size;
    status = kg_chains_add(chains, (kg_chain){.kind = KG_EDGE_TAIL,
                                              .source = source,
                                              .count = points.count,
                                              .points = points.items});
    /* nothing to tell where the gap is below what can be cut */
    if (!status && length > t->tolerance)
        status = kg_trim_note_add(t, (kg_trim_note){kind, source, end.x, length});
    return status;
}

kg_status kg_cut_prolong(const kg_trim *trim, const kg_region *region, size_t first,
                         kg_chains *chains) {
    const kg_patch *p = trim->patch;
    size_t cuts = chains->count;
    for (size_t i = first; i < cuts; i++)
        for (int last = 0; last < 2; last++) {
            const kg_chain *c = &chains->items[i];
            const kg_cross_point *end = &c->points[last ? c->count - 1 : 0];
            if (c->closed || !kg_region_contains(region, end->u, end->v) ||
                kg_chains_touch(p, chains, i, last))
                continue;
            kg_vec2 ahead, from = end_plane(p, c, last, &ahead);
            double reach = kg_chains_ray(p, chains, from, kg_add2(from, ahead));
            if (!isfinite(reach))
                continue;
            kg_vec2 to = kg_add2(from, kg_scale2(ahead, reach + OVERSHOOT * p->size));
            kg_status status = add_tail(trim, i, last, to, KG_NOTE_PROLONGED, chains);
            if (status)
                return status;
        }
    return KG_OK;
}

typedef struct loose_end {
    size_t chain;
    bool last, used;
    kg_vec2 at, ahead;
} loose_end;

kg_status kg_cut_join(const kg_trim *trim, size_t first, kg_chains *chains) {
    const kg_patch *p = trim->patch;
    struct {
        loose_end *items;
        size_t count, capacity;
    } ends = {0};
    kg_status status = KG_OK;
    for (size_t i = first; i < chains->count && !status; i++)
        for (int last = 0; last < 2 && !status; last++) {
            if (chains->items[i].closed || kg_chains_touch(p, chains, i, last))
                continue;
            loose_end e = {.chain = i, .last = last};
            e.at = end_plane(p, &chains->items[i], last, &e.ahead);
            if (!kg_push(&ends, e))
                status = KG_ERR_MEMORY;
        }
    size_t found = ends.count;
    for (size_t i = 0; i < found && !status; i++) {
        loose_end *e = &ends.items[i], *mate = NULL;
        double gap = INFINITY;
        for (size_t j = 0; j < found; j++) {
            double d = kg_dist2(e->at, ends.items[j].at);
            if (ends.items[j].chain != e->chain && d < gap)
                gap = d, mate = &ends.items[j];
        }
        if (e->used)
            continue;
        double reach = kg_chains_ray(p, chains, e->at, kg_add2(e->at, e->ahead));
        if (mate && gap <= reach) {
            mate->used = true;
            status = add_tail(trim, e->chain, e->last, mate->at, KG_NOTE_JOINED, chains);
        } else if (isfinite(reach)) {
            kg_vec2 to = kg_add2(e->at, kg_scale2(e->ahead, reach + OVERSHOOT * p->size));
            status = add_tail(trim, e->chain, e->last, to, KG_NOTE_PROLONGED, chains);
        }
    }
    free(ends.items);
    return status;
}
