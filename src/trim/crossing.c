/* kg_crossings_find: which way a pair goes, and what all of them have in common. */
#include "trim/crossing.h"

#include <stdlib.h>

/* Constant rulings whose directions differ by less than this drift apart by less than rounding
 * over any extent: they are parallel. */
#define PARALLEL 1e-10

/* Of the size, and of v and t: a tenth of the exactness that points are promised. */
#define SLACK 1e-10

/* Of the size: the finest tolerance. Where branches meet, or all but meet, cells end at 4e-6 and
 * the curve goes straight through them; F is flat there, so that points themselves are known only
 * to 1e-8, the root of rounding. */
#define FINEST 1e-6

/* ---- order ----------------------------------------------------------------------------- */

static int compare_vectors(kg_vec3 a, kg_vec3 b) {
    return a.x != b.x   ? (a.x < b.x ? -1 : 1)
           : a.y != b.y ? (a.y < b.y ? -1 : 1)
           : a.z != b.z ? (a.z < b.z ? -1 : 1)
                        : 0;
}

/* An order of patches by their geometry, so that a pair gives the same points either way. */
static int compare_patches(const kg_patch *a, const kg_patch *b) {
    int order = a->geodesic.degree - b->geodesic.degree;
    for (int i = 0; i <= a->geodesic.degree && !order; i++)
        order = compare_vectors(a->geodesic.points[i], b->geodesic.points[i]);
    for (int i = 0; i < 2 && !order; i++)
        order = a->extent[i] < b->extent[i] ? -1 : a->extent[i] > b->extent[i];
    return order ? order : compare_vectors(a->rulings[0], b->rulings[0]);
}

static int compare_branches(const void *x, const void *y) {
    const kg_crossing *a = x, *b = y;
    const kg_cross_point *p = a->points, *q = b->points;
    if (p->v != q->v)
        return p->v < q->v ? -1 : 1;
    if (p->t != q->t)
        return p->t < q->t ? -1 : 1;
    p = &a->points[1], q = &b->points[1]; /* branches that start in one point */
    if (p->v != q->v)
        return p->v < q->v ? -1 : 1;
    return p->t < q->t ? -1 : p->t > q->t;
}

/* Open branches start at the end with the smaller v, t or u. */
static void orient(kg_crossing *c) {
    const kg_cross_point *p = &c->points[0], *q = &c->points[c->count - 1];
    bool back = p->v != q->v ? p->v > q->v : p->t != q->t ? p->t > q->t : p->u > q->u;
    if (c->closed || !back)
        return;
    for (size_t i = 0, j = c->count - 1; i < j; i++, j--) {
        kg_cross_point swap = c->points[i];
        c->points[i] = c->points[j];
        c->points[j] = swap;
    }
    unsigned swap = c->ends[0];
    c->ends[0] = c->ends[1];
    c->ends[1] = swap;
}

/* ---- pairs ----------------------------------------------------------------------------- */

static bool boxes_meet(const kg_box3 *a, const kg_box3 *b, double gap, kg_vec3 *out_middle) {
    kg_vec3 lo = kg_v3(fmax(a->lo.x, b->lo.x), fmax(a->lo.y, b->lo.y), fmax(a->lo.z, b->lo.z));
    kg_vec3 hi = kg_v3(fmin(a->hi.x, b->hi.x), fmin(a->hi.y, b->hi.y), fmin(a->hi.z, b->hi.z));
    *out_middle = kg_lerp(lo, hi, 0.5);
    return lo.x <= hi.x + gap && lo.y <= hi.y + gap && lo.z <= hi.z + gap;
}

static bool parallel(const kg_patch *a, const kg_patch *b) {
    if (a->ruling_degree > 0 || b->ruling_degree > 0)
        return false;
    return kg_len(kg_cross(kg_unit(a->rulings[0]), kg_unit(b->rulings[0]))) <= PARALLEL;
}

/* Is F singular along a curve because the surfaces are one on a piece? */
static bool coincide(const kg_ruled_pair *pair, const kg_topology *t) {
    enum { SAMPLES = 16 };
    size_t step = t->hubs.count / SAMPLES + 1;
    for (size_t i = 0; i < t->hubs.count; i += step) {
        const kg_hub *h = &t->hubs.items[i];
        if (kg_coincide_near(pair->a.patch, 0.5 * (h->v[0] + h->v[1]), pair->b.patch))
            return true;
    }
    return false;
}

static kg_status find_general(kg_strips *a, kg_strips *b, double tolerance, kg_crossings *out,
                              kg_error *error) {
    kg_topology topology;
    if (!kg_topology_find(a, b, &topology))
        return kg_fail(error, KG_ERR_MEMORY, "not enough memory for the crossings");
    kg_ruled_pair pair = {a->ruled, b->ruled, tolerance, SLACK};
    kg_status status = KG_OK;
    if (topology.crowded && coincide(&pair, &topology))
        status = kg_fail_coincident(error);
    bool ok = status || kg_trace(&pair, &topology, out);
    for (size_t i = 0; i < topology.singular.count && ok && !status; i++)
        ok = kg_shared_ruling(&pair, topology.singular.items[i].x, topology.singular.items[i].y,
                              out);
    kg_topology_clear(&topology);
    return ok ? status : kg_fail(error, KG_ERR_MEMORY, "not enough memory for the crossings");
}

static kg_status find(const kg_patch *a, const kg_patch *b, double tolerance, kg_crossings *out,
                      kg_error *error) {
    double size = fmax(a->size, b->size);
    kg_vec3 origin;
    if (!boxes_meet(&a->box, &b->box, 1e-9 * size, &origin))
        return KG_OK;
    if (a->shape == KG_CURVE_STRAIGHT && b->shape == KG_CURVE_STRAIGHT && kg_coplanar(a, b))
        return kg_coplanar_overlap(a, b) ? kg_fail_coincident(error) : KG_OK;
    kg_strips sa = {0}, sb = {0};
    kg_status status = KG_OK;
    if (!kg_strips_init(&sa, a, 0, origin, size) || !kg_strips_init(&sb, b, 1, origin, size))
        status = kg_fail(error, KG_ERR_MEMORY, "not enough memory for the crossings");
    else if (kg_strips_apart(&sa, 0, &sb, 0))
        status = KG_OK;
    else if (parallel(a, b)) {
        kg_ruled_pair pair = {sa.ruled, sb.ruled, tolerance, SLACK};
        status = kg_parallel_find(&pair, out, error);
    } else
        status = find_general(&sa, &sb, tolerance, out, error);
    kg_strips_clear(&sa);
    kg_strips_clear(&sb);
    return status;
}

kg_status kg_crossings_find(const kg_patch *a, const kg_patch *b, double tolerance,
                            kg_crossings *out_crossings, kg_error *error) {
    if (!(tolerance > 0 && isfinite(tolerance)))
        return kg_fail(error, KG_ERR_INPUT,
                       "a tolerance of %g mm is not possible; give a length above 0", tolerance);
    bool swap = compare_patches(a, b) > 0;
    tolerance = fmax(tolerance, FINEST * fmax(a->size, b->size));
    kg_crossings found = {0};
    kg_status status =
        swap ? find(b, a, tolerance, &found, error) : find(a, b, tolerance, &found, error);
    if (status) {
        kg_crossings_clear(&found);
        return status;
    }
    for (size_t i = 0; i < found.count; i++)
        orient(&found.branches[i]);
    if (found.count > 1)
        qsort(found.branches, found.count, sizeof *found.branches, compare_branches);
    if (swap)
        kg_crossings_swap(&found);
    *out_crossings = found;
    return KG_OK;
}

void kg_crossings_clear(kg_crossings *crossings) {
    for (size_t i = 0; i < crossings->count; i++)
        free(crossings->branches[i].points);
    free(crossings->branches);
    *crossings = (kg_crossings){0};
}

void kg_crossings_swap(kg_crossings *crossings) {
    for (size_t i = 0; i < crossings->count; i++) {
        kg_crossing *c = &crossings->branches[i];
        for (size_t k = 0; k < c->count; k++) {
            kg_cross_point p = c->points[k];
            c->points[k] = (kg_cross_point){p.s, p.t, p.u, p.v, p.x};
        }
        for (int k = 0; k < 2; k++)
            c->ends[k] = (c->ends[k] & KG_SIDES_A) << 4 | (c->ends[k] & KG_SIDES_B) >> 4;
    }
}
