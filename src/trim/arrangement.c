#include "trim/arrangement.h"

#include "base/array.h"
#include "trim/noding.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_chains_add(kg_chains *chains, kg_chain chain) {
    if (kg_push(chains, chain))
        return KG_OK;
    free(chain.points);
    return KG_ERR_MEMORY;
}

void kg_chains_clear(kg_chains *chains) {
    for (size_t i = 0; i < chains->count; i++)
        free(chains->items[i].points);
    free(chains->items);
    *chains = (kg_chains){0};
}

static kg_vec2 pool_plane(const kg_arrangement *a, size_t i) {
    return kg_plane(a->patch, a->pool[i].u, a->pool[i].v);
}

static size_t half_origin(const kg_arrangement *a, size_t h) {
    return a->arcs[h / 2].node[h & 1];
}

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
    kg_arc arc = {
        .chain = e->chain, .first = a->pool_count, .node = {e->node, f->node}, .labels = c->labels};
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
            reach = fmax(reach, kg_dist2(pool_plane(a, arc.first + i), a->nodes[e->node]));
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
        total += kg_dist2(pool_plane(a, arc->first + i - 1), pool_plane(a, arc->first + i));
    for (size_t i = 1; i < arc->count; i++) {
        kg_vec2 p = pool_plane(a, arc->first + i - 1), q = pool_plane(a, arc->first + i);
        double d = kg_dist2(p, q);
        if (run + d >= 0.5 * total && d > 0)
            return kg_lerp2(p, q, (0.5 * total - run) / d);
        run += d;
    }
    return pool_plane(a, arc->first);
}

/* Arcs that lie on each other (a contour drawn along the outline, two cutters meeting in one
 * line) become one that carries the labels of both; the older one stays. */
static void merge_doubles(kg_arrangement *a) {
    /* doubles are sampled differently, so their middles agree to the chord error only; a
     * thousandth of the arc's span tells them from lens-shaped faces */
    const double alike = 1e-3;
    for (size_t i = 0; i < a->arc_count; i++)
        for (size_t j = 0; j < i && !a->arcs[i].dropped; j++) {
            kg_arc *x = &a->arcs[j], *y = &a->arcs[i];
            bool forward = x->node[0] == y->node[0] && x->node[1] == y->node[1];
            bool backward = x->node[0] == y->node[1] && x->node[1] == y->node[0];
            if (x->dropped || x->node[0] == x->node[1] || !(forward || backward))
                continue;
            double span = kg_dist2(a->nodes[x->node[0]], a->nodes[x->node[1]]);
            if (kg_dist2(arc_middle(a, x), arc_middle(a, y)) > alike * span + a->snap)
                continue;
            x->labels ^= y->labels;
            y->dropped = true;
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

/* ---- faces ----------------------------------------------------------------------------- */

typedef struct leaving {
    size_t node, half;
    double angle;
} leaving;

static int compare_leaving(const void *x, const void *y) {
    const leaving *a = x, *b = y;
    if (a->node != b->node)
        return a->node < b->node ? -1 : 1;
    if (a->angle != b->angle)
        return a->angle < b->angle ? -1 : 1;
    return a->half < b->half ? -1 : a->half > b->half;
}

/* Direction in which a half-edge leaves its node, taken a little way along it so that the
 * rounding of the node itself does not turn it. */
static double leaving_angle(const kg_arrangement *a, size_t h) {
    const kg_arc *arc = &a->arcs[h / 2];
    kg_vec2 from = pool_plane(a, h & 1 ? arc->first + arc->count - 1 : arc->first), to = from;
    for (size_t i = 1; i < arc->count; i++) {
        to = pool_plane(a, h & 1 ? arc->first + arc->count - 1 - i : arc->first + i);
        if (kg_dist2(from, to) > 20 * a->snap)
            break;
    }
    return atan2(to.y - from.y, to.x - from.x);
}

/* next[h]: the half-edge that follows h around the face on its left. */
static kg_status link_halfedges(const kg_arrangement *a, size_t *next) {
    leaving *out = malloc(2 * a->arc_count * sizeof *out + 1);
    if (!out)
        return KG_ERR_MEMORY;
    size_t n = 0;
    for (size_t h = 0; h < 2 * a->arc_count; h++)
        if (!a->arcs[h / 2].dropped)
            out[n++] = (leaving){half_origin(a, h), h, leaving_angle(a, h)};
    qsort(out, n, sizeof *out, compare_leaving);
    for (size_t begin = 0; begin < n;) {
        size_t end = begin;
        while (end < n && out[end].node == out[begin].node)
            end++;
        /* arriving against out[i], go on with the next one clockwise */
        for (size_t i = begin; i < end; i++)
            next[out[i].half ^ 1] = out[i == begin ? end - 1 : i - 1].half;
        begin = end;
    }
    free(out);
    return KG_OK;
}

static double half_area(const kg_arrangement *a, size_t h) {
    const kg_arc *arc = &a->arcs[h / 2];
    double sum = 0;
    for (size_t i = 1; i < arc->count; i++)
        sum += kg_cross2(pool_plane(a, arc->first + i - 1), pool_plane(a, arc->first + i));
    return h & 1 ? -0.5 * sum : 0.5 * sum;
}

static kg_status trace_loops(kg_arrangement *a, const size_t *next) {
    unsigned char *seen = calloc(2 * a->arc_count + 1, 1);
    if (!seen)
        return KG_ERR_MEMORY;
    kg_status status = KG_OK;
    for (size_t h = 0; h < 2 * a->arc_count && !status; h++) {
        if (seen[h] || a->arcs[h / 2].dropped)
            continue;
        kg_face_loop loop = {.first = a->halfedge_count};
        for (size_t k = h; !seen[k] && !status; k = next[k]) {
            seen[k] = 1;
            if (!kg_reserve_bytes((void **)&a->halfedges, &a->halfedge_capacity,
                                  a->halfedge_count + 1, sizeof *a->halfedges)) {
                status = KG_ERR_MEMORY;
                break;
            }
            a->halfedges[a->halfedge_count++] = k;
            loop.area += half_area(a, k);
        }
        loop.count = a->halfedge_count - loop.first;
        if (!status && !kg_reserve_bytes((void **)&a->loops, &a->loop_capacity, a->loop_count + 1,
                                         sizeof loop))
            status = KG_ERR_MEMORY;
        if (!status)
            a->loops[a->loop_count++] = loop;
    }
    free(seen);
    return status;
}

/* Winding of a loop around a point that is not on it. */
static bool loop_around(const kg_arrangement *a, const kg_face_loop *loop, kg_vec2 q) {
    bool inside = false;
    for (size_t k = 0; k < loop->count; k++) {
        const kg_arc *arc = &a->arcs[a->halfedges[loop->first + k] / 2];
        for (size_t i = 1; i < arc->count; i++) {
            kg_vec2 p = pool_plane(a, arc->first + i - 1), r = pool_plane(a, arc->first + i);
            if ((p.y > q.y) != (r.y > q.y) && q.x < p.x + (q.y - p.y) / (r.y - p.y) * (r.x - p.x))
                inside = !inside;
        }
    }
    return inside;
}

/* Gives each node the smallest node it hangs together with. */
static size_t *node_components(const kg_arrangement *a) {
    size_t *component = malloc(a->node_count * sizeof *component + 1);
    if (!component)
        return NULL;
    for (size_t i = 0; i < a->node_count; i++)
        component[i] = i;
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < a->arc_count; i++) {
            size_t *x = &component[a->arcs[i].node[0]], *y = &component[a->arcs[i].node[1]];
            if (a->arcs[i].dropped || *x == *y)
                continue;
            *x = *y = *x < *y ? *x : *y;
            again = true;
        }
    }
    return component;
}

/* Numbers faces by their outer loops and finds the face that each inner loop is a hole of. */
static kg_status assign_faces(kg_arrangement *a) {
    size_t *component = node_components(a);
    if (!component)
        return KG_ERR_MEMORY;
    a->face_count = 1;
    for (size_t i = 0; i < a->loop_count; i++)
        if (a->loops[i].area > 0)
            a->loops[i].face = a->face_count++;
    for (size_t i = 0; i < a->loop_count; i++) {
        kg_face_loop *hole = &a->loops[i];
        if (hole->area > 0)
            continue;
        kg_vec2 at = pool_plane(a, a->arcs[a->halfedges[hole->first] / 2].first);
        double best = INFINITY;
        hole->face = 0;
        for (size_t j = 0; j < a->loop_count; j++) {
            const kg_face_loop *outer = &a->loops[j];
            bool same = component[half_origin(a, a->halfedges[outer->first])] ==
                        component[half_origin(a, a->halfedges[hole->first])];
            if (!same && outer->area > 0 && outer->area < best && loop_around(a, outer, at)) {
                best = outer->area;
                hole->face = outer->face;
            }
        }
    }
    for (size_t i = 0; i < a->loop_count; i++)
        for (size_t k = 0; k < a->loops[i].count; k++) {
            size_t h = a->halfedges[a->loops[i].first + k];
            a->arcs[h / 2].face[h & 1] = a->loops[i].face;
        }
    free(component);
    return KG_OK;
}

static kg_status label_faces(kg_arrangement *a) {
    a->labels = calloc(a->face_count, sizeof *a->labels);
    unsigned char *known = calloc(a->face_count, 1);
    if (!a->labels || !known) {
        free(known);
        return KG_ERR_MEMORY;
    }
    known[0] = 1;
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < a->arc_count; i++) {
            const kg_arc *arc = &a->arcs[i];
            if (arc->dropped || known[arc->face[0]] == known[arc->face[1]])
                continue;
            int from = known[arc->face[0]] ? 0 : 1;
            a->labels[arc->face[!from]] = a->labels[arc->face[from]] ^ arc->labels;
            known[arc->face[!from]] = 1;
            again = true;
        }
    }
    free(known);
    return KG_OK;
}

kg_status kg_arrangement_build(const kg_patch *patch, const kg_chains *chains,
                               kg_arrangement *out) {
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
    size_t *next = status ? NULL : malloc(2 * a.arc_count * sizeof *next + 1);
    if (!status && !next)
        status = KG_ERR_MEMORY;
    if (!status)
        status = link_halfedges(&a, next);
    if (!status)
        status = trace_loops(&a, next);
    free(next);
    if (!status)
        status = assign_faces(&a);
    if (!status)
        status = label_faces(&a);
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

/* ---- questions about chains before they are noded --------------------------------------- */

double kg_chains_ray(const kg_patch *patch, const kg_chains *chains, kg_vec2 from, kg_vec2 to) {
    kg_vec2 d = kg_sub2(to, from);
    double best = INFINITY, away = KG_NODE_SNAP * patch->size / kg_len2(d);
    for (size_t i = 0; i < chains->count; i++) {
        const kg_chain *c = &chains->items[i];
        kg_vec2 p = kg_plane(patch, c->points[0].u, c->points[0].v);
        for (size_t k = 1; k < c->count; k++) {
            kg_vec2 q = kg_plane(patch, c->points[k].u, c->points[k].v);
            kg_vec2 e = kg_sub2(q, p), g = kg_sub2(p, from);
            double den = kg_cross2(d, e);
            if (den != 0) {
                double f = kg_cross2(g, e) / den, h = kg_cross2(g, d) / den;
                if (h >= 0 && h <= 1 && f > away && f < best)
                    best = f;
            }
            p = q;
        }
    }
    return best;
}

bool kg_chains_touch(const kg_patch *patch, const kg_chains *chains, size_t chain, bool last) {
    const kg_chain *own = &chains->items[chain];
    const kg_cross_point *end = &own->points[last ? own->count - 1 : 0];
    kg_vec2 at = kg_plane(patch, end->u, end->v);
    double snap = KG_NODE_SNAP * patch->size;
    for (size_t i = 0; i < chains->count; i++) {
        const kg_chain *c = &chains->items[i];
        if (i == chain)
            continue;
        kg_vec2 p = kg_plane(patch, c->points[0].u, c->points[0].v);
        for (size_t k = 1; k < c->count; k++) {
            kg_vec2 q = kg_plane(patch, c->points[k].u, c->points[k].v), e = kg_sub2(q, p);
            double n = kg_dot2(e, e), f = n > 0 ? kg_dot2(kg_sub2(at, p), e) / n : 0;
            if (kg_dist2(at, kg_lerp2(p, q, fmin(fmax(f, 0), 1))) <= snap)
                return true;
            p = q;
        }
    }
    return false;
}
