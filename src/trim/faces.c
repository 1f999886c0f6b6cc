/* Faces of an arrangement: half-edges in order around nodes, traced, nested and labelled. */
#include "trim/arrangement.h"

#include "base/array.h"

#include <stdlib.h>

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
    kg_vec2 from = a->nodes[kg_half_origin(a, h)], to = from;
    for (size_t i = 1; i < arc->count; i++) {
        to = kg_arc_plane(a, arc, h & 1 ? arc->count - 1 - i : i);
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
            out[n++] = (leaving){kg_half_origin(a, h), h, leaving_angle(a, h)};
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

static void measure_half(const kg_arrangement *a, size_t h, kg_face_loop *loop) {
    const kg_arc *arc = &a->arcs[h / 2];
    for (size_t i = 1; i < arc->count; i++) {
        kg_vec2 p = kg_arc_plane(a, arc, i - 1), q = kg_arc_plane(a, arc, i);
        loop->area += (h & 1 ? -0.5 : 0.5) * kg_cross2(p, q);
        loop->length += kg_dist2(p, q);
    }
}

/* The halves of each face's boundary in order: cycle[h] numbers them. */
static void number_cycles(const kg_arrangement *a, const size_t *next, size_t *cycle) {
    size_t count = 0;
    for (size_t h = 0; h < 2 * a->arc_count; h++)
        cycle[h] = SIZE_MAX;
    for (size_t h = 0; h < 2 * a->arc_count; h++) {
        if (a->arcs[h / 2].dropped || cycle[h] != SIZE_MAX)
            continue;
        for (size_t k = h; cycle[k] == SIZE_MAX; k = next[k])
            cycle[k] = count;
        count++;
    }
}

/* Drops arcs with one face on both sides: a cut from the outline to a hole divides nothing. */
static bool drop_bridges(kg_arrangement *a, const size_t *cycle) {
    bool any = false;
    for (size_t i = 0; i < a->arc_count; i++)
        if (!a->arcs[i].dropped && cycle[2 * i] == cycle[2 * i + 1])
            a->arcs[i].dropped = any = true;
    return any;
}

static kg_status add_loop(kg_arrangement *a, const size_t *halves, size_t count, size_t cycle) {
    kg_face_loop loop = {.cycle = cycle, .first = a->halfedge_count, .count = count};
    if (!kg_reserve_bytes((void **)&a->halfedges, &a->halfedge_capacity, a->halfedge_count + count,
                          sizeof *a->halfedges) ||
        !kg_reserve_bytes((void **)&a->loops, &a->loop_capacity, a->loop_count + 1, sizeof loop))
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < count; i++) {
        a->halfedges[a->halfedge_count++] = halves[i];
        measure_half(a, halves[i], &loop);
    }
    a->loops[a->loop_count++] = loop;
    return KG_OK;
}

/* Follows all cycles. Where one comes through a node again the part since then becomes a loop of
 * its own, so that every loop is simple. `stack`: room for all halves; `place`: for all nodes. */
static kg_status trace_loops(kg_arrangement *a, const size_t *next, const size_t *cycle,
                             size_t *stack, size_t *place) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < a->node_count; i++)
        place[i] = SIZE_MAX;
    size_t done = 0; /* cycles are numbered in the order of their first halves */
    for (size_t h = 0; h < 2 * a->arc_count && !status; h++) {
        if (a->arcs[h / 2].dropped || cycle[h] != done)
            continue;
        size_t top = 0, k = h;
        do {
            size_t node = kg_half_origin(a, k);
            if (place[node] != SIZE_MAX) {
                size_t from = place[node];
                status = add_loop(a, stack + from, top - from, done);
                while (top > from)
                    place[kg_half_origin(a, stack[--top])] = SIZE_MAX;
            }
            place[node] = top;
            stack[top++] = k;
            k = next[k];
        } while (k != h && !status);
        if (!status)
            status = add_loop(a, stack, top, done);
        while (top > 0)
            place[kg_half_origin(a, stack[--top])] = SIZE_MAX;
        done++;
    }
    return status;
}

/* Winding of a loop around a point that is not on it. */
static bool loop_around(const kg_arrangement *a, const kg_face_loop *loop, kg_vec2 q) {
    bool inside = false;
    for (size_t k = 0; k < loop->count; k++) {
        const kg_arc *arc = &a->arcs[a->halfedges[loop->first + k] / 2];
        for (size_t i = 1; i < arc->count; i++) {
            kg_vec2 p = kg_arc_plane(a, arc, i - 1), r = kg_arc_plane(a, arc, i);
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

/* The face of a loop in whose cycle there is an outer loop; face 0 if there is none. */
static size_t face_of_cycle(const kg_arrangement *a, size_t cycle) {
    for (size_t i = 0; i < a->loop_count; i++)
        if (a->loops[i].cycle == cycle && a->loops[i].area > 0)
            return a->loops[i].face;
    return 0;
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
        hole->face = face_of_cycle(a, hole->cycle);
        kg_vec2 at = a->nodes[kg_half_origin(a, a->halfedges[hole->first])];
        double best = hole->face ? 0 : INFINITY;
        for (size_t j = 0; j < a->loop_count; j++) {
            const kg_face_loop *outer = &a->loops[j];
            if (outer->area <= 0 || outer->area >= best)
                continue;
            bool same = component[kg_half_origin(a, a->halfedges[outer->first])] ==
                        component[kg_half_origin(a, a->halfedges[hole->first])];
            if (!same && loop_around(a, outer, at)) {
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
    for (size_t i = 0; i < a->arc_count; i++)
        if (a->arcs[i].doubles != KG_NO_ARC)
            for (int side = 0; side < 2; side++)
                a->arcs[i].face[side] = a->arcs[a->arcs[i].doubles].face[side];
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

kg_status kg_arrangement_faces(kg_arrangement *a) {
    size_t halves = 2 * a->arc_count;
    size_t *scratch = calloc(3 * halves + a->node_count + 1, sizeof *scratch);
    if (!scratch)
        return KG_ERR_MEMORY;
    size_t *next = scratch, *cycle = next + halves, *stack = cycle + halves,
           *place = stack + halves;
    kg_status status = link_halfedges(a, next);
    if (!status) {
        number_cycles(a, next, cycle);
        if (drop_bridges(a, cycle)) {
            status = link_halfedges(a, next);
            number_cycles(a, next, cycle);
        }
    }
    if (!status)
        status = trace_loops(a, next, cycle, stack, place);
    free(scratch);
    if (!status)
        status = assign_faces(a);
    if (!status)
        status = label_faces(a);
    return status;
}
