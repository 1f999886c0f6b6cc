#include "trim/region.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

void kg_region_clear(kg_region *region) {
    for (size_t i = 0; i < region->loop_count; i++) {
        free(region->loops[i].points);
        free(region->loops[i].edges);
        free(region->loops[i].ends);
    }
    free(region->loops);
    *region = (kg_region){0};
}

void kg_regions_clear(kg_regions *regions) {
    for (size_t i = 0; i < regions->count; i++)
        kg_region_clear(&regions->items[i]);
    free(regions->items);
    *regions = (kg_regions){0};
}

kg_status kg_regions_add(kg_regions *regions, kg_region region) {
    size_t capacity = regions->count; /* grows by one: a patch has few pieces */
    if (!kg_reserve_bytes((void **)&regions->items, &capacity, regions->count + 1, sizeof region)) {
        kg_region_clear(&region);
        return KG_ERR_MEMORY;
    }
    regions->items[regions->count++] = region;
    return KG_OK;
}

static kg_status append(kg_points *points, const kg_points *more) {
    for (size_t i = 0; i < more->count; i++)
        if (!kg_push(points, more->items[i]))
            return KG_ERR_MEMORY;
    return KG_OK;
}

kg_status kg_regions_rectangle(const kg_patch *patch, double tolerance, kg_regions *out_regions,
                               kg_error *error) {
    double lo = patch->extent[0], hi = patch->extent[1];
    const kg_vec2 corner[5] = {{lo, 0}, {hi, 0}, {hi, 1}, {lo, 1}, {lo, 0}};
    static const int64_t side[4] = {2, 1, 3, 0};
    kg_points points = {0}, sides[2] = {{0}, {0}};
    kg_region region = {.loop_count = 1, .loops = calloc(1, sizeof *region.loops)};
    kg_region_edge *edges = calloc(4, sizeof *edges);
    kg_cross_point *ends = calloc(4, sizeof *ends);
    kg_status status = region.loops && edges && ends ? KG_OK : KG_ERR_MEMORY;
    if (!status)
        status = kg_sample_sides(patch, tolerance, sides);
    for (size_t i = 0; i < 4 && !status; i++) {
        size_t first = points.count;
        if (i % 2 == 0)
            status = kg_sample_straight(patch, corner[i], corner[i + 1], tolerance, &points);
        else
            status = append(&points, &sides[i == 1]);
        edges[i] = (kg_region_edge){KG_EDGE_OUTLINE, side[i], first, points.count - first};
    }
    free(sides[0].items);
    free(sides[1].items);
    if (status) {
        free(region.loops);
        free(edges);
        free(ends);
        free(points.items);
        return kg_fail(error, status, "out of memory");
    }
    for (size_t i = 0; i < 4; i++)
        ends[i] = points.items[edges[(i + 1) % 4].first];
    region.loops[0] = (kg_region_loop){points.count, points.items, 4, edges, ends};
    kg_regions regions = {0};
    if (kg_regions_add(&regions, region))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_regions = regions;
    return KG_OK;
}

/* ---- to and from arrangements ----------------------------------------------------------- */

/* The arc after (step 1) or before (step -1) another on its chain; arcs lie in the order of their
 * chains. KG_NO_ARC at an open chain's end. */
static size_t neighbour_arc(const kg_arrangement *a, size_t arc, int step) {
    size_t chain = a->arcs[arc].chain, next = step > 0 ? arc + 1 : arc - 1;
    if (next < a->arc_count && a->arcs[next].chain == chain)
        return next;
    if (!a->chains->items[chain].closed)
        return KG_NO_ARC;
    for (next = arc; next - (size_t)step < a->arc_count;) {
        if (a->arcs[next - (size_t)step].chain != chain)
            break;
        next -= (size_t)step;
    }
    return next;
}

/* Does half-edge h go on where g ends, along the same chain in the same direction? Where loops of
 * one cycle touch each other edges end, so that their common node stays known. */
static bool continues(const kg_arrangement *a, size_t g, size_t h, bool touching) {
    return (g & 1) == (h & 1) && !touching && neighbour_arc(a, g / 2, g & 1 ? -1 : 1) == h / 2;
}

static kg_cross_point half_point(const kg_arrangement *a, size_t h, size_t i) {
    const kg_arc *arc = &a->arcs[h / 2];
    return a->pool[arc->first + (h & 1 ? arc->count - 1 - i : i)];
}

static kg_status loop_from_face(const kg_arrangement *a, const kg_face_loop *face,
                                kg_region_loop *out) {
    const size_t *half = a->halfedges + face->first;
    size_t n = face->count, start = 0, total = 0, edges = 0;
    bool touching = false;
    for (size_t i = 0; i < a->loop_count; i++)
        touching = touching || (a->loops[i].cycle == face->cycle && &a->loops[i] != face);
    /* begin where a chain changes, so that no edge runs over the loop's start */
    while (start < n && continues(a, half[(start + n - 1) % n], half[start], touching))
        start++;
    start %= n;
    for (size_t k = 0; k < n; k++) {
        total += a->arcs[half[k] / 2].count - 1;
        edges +=
            k == 0 || !continues(a, half[(start + k - 1) % n], half[(start + k) % n], touching);
    }
    kg_region_loop loop = {.points = calloc(total, sizeof *loop.points),
                           .edges = calloc(edges, sizeof *loop.edges),
                           .ends = calloc(edges, sizeof *loop.ends)};
    if (!loop.points || !loop.edges || !loop.ends) {
        free(loop.points);
        free(loop.edges);
        free(loop.ends);
        return KG_ERR_MEMORY;
    }
    for (size_t k = 0; k < n; k++) {
        size_t h = half[(start + k) % n];
        const kg_arc *arc = &a->arcs[h / 2];
        const kg_chain *chain = &a->chains->items[arc->chain];
        if (k == 0 || !continues(a, half[(start + k - 1) % n], h, touching))
            loop.edges[loop.edge_count++] =
                (kg_region_edge){chain->kind, chain->source, loop.point_count, 0};
        for (size_t i = 0; i + 1 < arc->count; i++)
            loop.points[loop.point_count++] = half_point(a, h, i);
        loop.edges[loop.edge_count - 1].count += arc->count - 1;
        loop.ends[loop.edge_count - 1] = half_point(a, h, arc->count - 1);
    }
    *out = loop;
    return KG_OK;
}

kg_status kg_region_from_face(const kg_arrangement *a, size_t face, kg_region *out_region) {
    size_t count = 0;
    for (size_t i = 0; i < a->loop_count; i++)
        count += a->loops[i].face == face;
    kg_region region = {.loops = calloc(count, sizeof *region.loops)};
    if (!region.loops)
        return KG_ERR_MEMORY;
    for (int holes = 0; holes < 2; holes++)
        for (size_t i = 0; i < a->loop_count; i++) {
            const kg_face_loop *loop = &a->loops[i];
            if (loop->face != face || (loop->area <= 0) != holes ||
                (holes && kg_is_sliver(a, loop->area, loop->length)))
                continue;
            if (loop_from_face(a, loop, &region.loops[region.loop_count])) {
                kg_region_clear(&region);
                return KG_ERR_MEMORY;
            }
            region.loop_count++;
        }
    *out_region = region;
    return KG_OK;
}

kg_status kg_region_chains(const kg_region *region, kg_patch_finder finder, kg_chains *chains) {
    for (size_t i = 0; i < region->loop_count; i++) {
        const kg_region_loop *loop = &region->loops[i];
        for (size_t k = 0; k < loop->edge_count; k++) {
            const kg_region_edge *e = &loop->edges[k];
            kg_cross_point start = kg_region_edge_point(loop, e, 0), *end = &loop->ends[k];
            kg_chain chain = {.kind = e->kind,
                              .source = e->source,
                              .labels = KG_LABEL_REGION,
                              /* a cutter that crosses itself may come back elsewhere on itself */
                              .closed =
                                  loop->edge_count == 1 && start.s == end->s && start.t == end->t,
                              .count = e->count + 1};
            if (e->kind == KG_EDGE_CUT)
                chain.other = finder.find(finder.user, e->source);
            chain.points = malloc(chain.count * sizeof *chain.points);
            if (!chain.points)
                return KG_ERR_MEMORY;
            for (size_t j = 0; j <= e->count; j++)
                chain.points[j] = kg_region_edge_point(loop, e, j);
            kg_status status = kg_chains_add(chains, chain);
            if (status)
                return status;
        }
    }
    return KG_OK;
}

/* ---- points of edges -------------------------------------------------------------------- */

kg_cross_point kg_region_edge_point(const kg_region_loop *loop, const kg_region_edge *edge,
                                    size_t i) {
    if (i == edge->count)
        return loop->ends[edge - loop->edges];
    return loop->points[(edge->first + i) % loop->point_count];
}

kg_cross_point kg_region_edge_at(const kg_patch *patch, const kg_region_loop *loop,
                                 const kg_region_edge *edge, const kg_patch *cutter, size_t i,
                                 double fraction, kg_cross_point *out_slope) {
    kg_cross_point span[2] = {kg_region_edge_point(loop, edge, i),
                              kg_region_edge_point(loop, edge, i + 1)};
    kg_chain chain = {.kind = edge->kind, .other = cutter, .count = 2, .points = span};
    return kg_chain_at(patch, &chain, 0, fraction, out_slope);
}

/* ---- where points lie ------------------------------------------------------------------- */

bool kg_region_contains(const kg_region *region, double u, double v) {
    bool inside = false;
    for (size_t i = 0; i < region->loop_count; i++) {
        const kg_region_loop *loop = &region->loops[i];
        const kg_cross_point *p = &loop->points[loop->point_count - 1];
        for (size_t k = 0; k < loop->point_count; k++) {
            const kg_cross_point *q = &loop->points[k];
            if ((p->v > v) != (q->v > v) && u < p->u + (v - p->v) / (q->v - p->v) * (q->u - p->u))
                inside = !inside;
            p = q;
        }
    }
    return inside;
}

static double segment_distance2(kg_vec3 p, kg_vec3 a, kg_vec3 b) {
    kg_vec3 d = kg_sub(b, a), off = kg_sub(p, a);
    double n = kg_dot(d, d), f = n > 0 ? kg_dot(off, d) / n : 0;
    kg_vec3 gap = kg_madd(off, -kg_min(kg_max(f, 0), 1), d);
    return kg_dot(gap, gap);
}

void kg_feet_find(const kg_patch *patch, kg_vec3 point, kg_feet *out) {
    out->point = point;
    for (int i = 0; i <= KG_FEET_ROWS; i++) {
        kg_vec3 d, p = kg_patch_line(patch, (double)i / KG_FEET_ROWS, &d), off = kg_sub(point, p);
        out->u[i] = kg_dot(off, d);
        kg_vec3 gap = kg_madd(off, -out->u[i], d);
        out->distance2[i] = kg_dot(gap, gap);
    }
}

double kg_feet_distance2(const kg_feet *feet, const kg_region *region, double most) {
    double best = most;
    kg_box2 box = kg_box2_empty(); /* in (u,v) */
    for (size_t i = 0; i < region->loop_count; i++) {
        const kg_region_loop *loop = &region->loops[i];
        kg_vec3 last = loop->points[loop->point_count - 1].x;
        for (size_t k = 0; k < loop->point_count; k++) {
            const kg_cross_point *p = &loop->points[k];
            kg_box2_add(&box, kg_v2(p->u, p->v));
            best = kg_min(segment_distance2(feet->point, last, p->x), best);
            last = p->x;
        }
    }
    for (int i = 0; i <= KG_FEET_ROWS; i++) {
        double u = feet->u[i], v = (double)i / KG_FEET_ROWS;
        if (feet->distance2[i] < best && u > box.lo.x && u < box.hi.x && v > box.lo.y &&
            v < box.hi.y && kg_region_contains(region, u, v))
            best = feet->distance2[i];
    }
    return best;
}

double kg_region_distance(const kg_patch *patch, const kg_region *region, kg_vec3 point) {
    double u, v, distance = kg_patch_closest(patch, point, &u, &v);
    if (kg_region_contains(region, u, v))
        return distance;
    kg_feet feet;
    kg_feet_find(patch, point, &feet);
    return sqrt(kg_feet_distance2(&feet, region, INFINITY));
}
