#include "trim/arrangement.h"

#include "base/array.h"
#include "trim/noding.h"

#include <stdlib.h>
#include <string.h>

/* ---- arcs ------------------------------------------------------------------------------ */

static bool push_point(kg_arrangement *a, kg_cross_point p) {
    if (!kg_reserve_bytes((void **)&a->pool, &a->pool_capacity, a->pool_count + 1, sizeof p))
        return false;
    a->pool[a->pool_count++] = p;
    return true;
}

/* One arc from event e to event f of the same chain, through the chain's own points. For closed
 * chains f may come before e: the arc then runs over the chain's start. */
static kg_status add_arc(kg_arrangement *a, const kg_event *e, const kg_event *f, bool wraps) {
    const kg_chain *c = &a->chains->items[e->chain];
    kg_arc arc = {.chain = e->chain,
                  .first = a->pool_count,
                  .node = {e->node, f->node},
                  .labels = c->labels,
                  .doubles = KG_NO_ARC};
    bool ok = push_point(a, e->point);
    size_t segments = c->count - 1;
    size_t last = f->segment + (wraps ? segments : 0);
    for (size_t i = e->segment + 1; i <= last && ok; i++) {
        size_t k = c->closed ? i % segments : i;
        if (i == last && f->fraction == 0)
            break; /* the vertex is the event itself */
        ok = push_point(a, c->points[k]);
    }
    ok = ok && push_point(a, f->point);
    arc.count = a->pool_count - arc.first;
    /* two events of one place make no arc */
    if (ok && e->node == f->node && !wraps && arc.count <= 3) {
        double reach = 0;
        for (size_t i = 0; i < arc.count; i++)
            reach = kg_max(kg_dist2(kg_pool_plane(a, arc.first + i), a->nodes[e->node]), reach);
        if (reach <= 2 * a->snap) {
            a->pool_count = arc.first;
            return KG_OK;
        }
    }
    if (!ok || !kg_reserve_bytes((void **)&a->arcs, &a->arc_capacity, a->arc_count + 1, sizeof arc))
        return KG_ERR_MEMORY;
    a->arcs[a->arc_count++] = arc;
    return KG_OK;
}

static kg_status make_arcs(kg_arrangement *a, const kg_events *events) {
    size_t begin = 0;
    while (begin < events->count) {
        const kg_event *e = events->items;
        size_t end = begin, chain = e[begin].chain;
        while (end < events->count && e[end].chain == chain)
            end++;
        size_t last = begin;
        kg_status status = KG_OK;
        for (size_t i = begin + 1; i < end && !status; i++) {
            bool same = e[i].node == e[last].node && e[i].segment == e[last].segment &&
                        e[i].fraction == e[last].fraction;
            if (same)
                continue;
            status = add_arc(a, &e[last], &e[i], false);
            last = i;
        }
        if (!status && a->chains->items[chain].closed)
            status = add_arc(a, &e[last], &e[begin], true);
        if (status)
            return status;
        begin = end;
    }
    return KG_OK;
}

/* The point halfway along an arc's polyline. */
static kg_vec2 arc_middle(const kg_arrangement *a, const kg_arc *arc) {
    double total = 0, run = 0;
    for (size_t i = 1; i < arc->count; i++)
        total += kg_dist2(kg_arc_plane(a, arc, i - 1), kg_arc_plane(a, arc, i));
    for (size_t i = 1; i < arc->count; i++) {
        kg_vec2 p = kg_arc_plane(a, arc, i - 1), q = kg_arc_plane(a, arc, i);
        double d = kg_dist2(p, q);
        if (run + d >= 0.5 * total && d > 0)
            return kg_lerp2(p, q, (0.5 * total - run) / d);
        run += d;
    }
    return kg_arc_plane(a, arc, 0);
}

/* Arcs that lie on each other (a contour drawn along the outline, two cutters meeting in one
 * line) become one that carries the labels of both; the older one stays. Doubles have nodes at all
 * points of both, so that they agree but for rounding. */
static void merge_doubles(kg_arrangement *a) {
    for (size_t i = 0; i < a->arc_count; i++)
        for (size_t j = 0; j < i && !a->arcs[i].dropped; j++) {
            kg_arc *x = &a->arcs[j], *y = &a->arcs[i];
            bool forward = x->node[0] == y->node[0] && x->node[1] == y->node[1];
            bool backward = x->node[0] == y->node[1] && x->node[1] == y->node[0];
            if (x->dropped || x->node[0] == x->node[1] || !(forward || backward) ||
                kg_dist2(arc_middle(a, x), arc_middle(a, y)) > 4 * a->snap)
                continue;
            x->labels ^= y->labels;
            y->dropped = true;
            y->doubles = j;
        }
}

static kg_status drop_dangling(kg_arrangement *a) {
    size_t *degree = calloc(a->node_count ? a->node_count : 1, sizeof *degree);
    if (!degree)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < a->arc_count; i++)
        if (!a->arcs[i].dropped)
            degree[a->arcs[i].node[0]]++, degree[a->arcs[i].node[1]]++;
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < a->arc_count; i++) {
            kg_arc *arc = &a->arcs[i];
            if (arc->dropped || (degree[arc->node[0]] > 1 && degree[arc->node[1]] > 1))
                continue;
            arc->dropped = again = true;
            degree[arc->node[0]]--, degree[arc->node[1]]--;
        }
    }
    free(degree);
    return KG_OK;
}

kg_status kg_arrangement_build(const kg_patch *patch, kg_chains *chains, kg_arrangement *out) {
    kg_arrangement a = {.patch = patch,
                        .scale = patch->length_at[KG_PATCH_CELLS],
                        .snap = KG_NODE_SNAP * patch->size,
                        .chains = chains};
    kg_events events = {0};
    kg_status status = kg_node_chains(&a, &events);
    if (!status)
        status = make_arcs(&a, &events);
    free(events.items);
    if (!status) {
        merge_doubles(&a);
        status = drop_dangling(&a);
    }
    if (!status)
        status = kg_arrangement_faces(&a);
    if (status) {
        kg_arrangement_clear(&a);
        return status;
    }
    *out = a;
    return KG_OK;
}

void kg_arrangement_clear(kg_arrangement *a) {
    free(a->nodes);
    free(a->pool);
    free(a->arcs);
    free(a->halfedges);
    free(a->loops);
    free(a->labels);
    *a = (kg_arrangement){0};
}
