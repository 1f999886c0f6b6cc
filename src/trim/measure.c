/* Lengths and areas of regions, by quadrature along their exact edges. */
#include "katagami/trim.h"

/* Three-point Gauss-Legendre on spans whose chords already keep to the sampling tolerance: the
 * error is of sixth order in the span. */
static const double gauss_node[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
static const double gauss_weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/* A span may be straight and still be run through at a changing speed (next to a cusp): it is
 * halved while the speeds at its nodes differ by more than this ratio, at most MAX_DEPTH times. */
#define STEADY 1.1
enum { MAX_DEPTH = 16 };

/* Straight edges are never measured in longer steps of v than this. */
#define LONGEST_STEP (1.0 / KG_PATCH_CELLS)

typedef struct span {
    const kg_patch *patch;
    const kg_region_loop *loop;
    const kg_region_edge *edge;
    const kg_patch *cutter;
    size_t i;
    double dv; /* from point i to point i + 1 */
} span;

/* What one Gauss point stands for. Area by Green's theorem: on paper ½ (x dy - y dx); in space
 * |X_u × X_v| = b + u c is linear in u on each ruling, so its integral over u is b u + c u²/2. */
static kg_measure measure_at(const span *s, double fraction) {
    const kg_patch *patch = s->patch;
    kg_cross_point slope,
        at = kg_region_edge_at(patch, s->loop, s->edge, s->cutter, s->i, fraction, &slope);
    kg_ruling r = kg_patch_ruling(patch, at.v);
    kg_vec3 xv = kg_madd(r.dp, at.u, r.dd);
    kg_vec3 dx = kg_add(kg_scale(r.d, slope.u), kg_scale(xv, slope.v));
    kg_vec3 w = kg_sub(r.dp, kg_scale(r.d, kg_dot(r.dp, r.d)));
    double b = kg_len(w), c = kg_dot(r.dd, w) / b;
    kg_vec2 y = kg_v2(at.u * r.sin_theta, at.u * r.cos_theta + kg_patch_length(patch, at.v));
    kg_vec2 dy = kg_v2(r.sin_theta * slope.u + at.u * r.cos_theta * r.dtheta * slope.v,
                       r.cos_theta * slope.u + (r.speed - at.u * r.sin_theta * r.dtheta) * slope.v);
    return (kg_measure){.space_length = kg_len(dx),
                        .paper_length = kg_len2(dy),
                        .space_moment = at.u * (b + 0.5 * c * at.u) * slope.v,
                        .paper_moment = 0.5 * kg_cross2(y, dy)};
}

static void add_scaled(kg_measure *sum, double weight, const kg_measure *m) {
    sum->space_length += weight * m->space_length;
    sum->paper_length += weight * m->paper_length;
    sum->space_moment += weight * m->space_moment;
    sum->paper_moment += weight * m->paper_moment;
}

static void measure_span(const span *s, double lo, double hi, int depth, kg_measure *sum) {
    kg_measure node[3];
    double slow = INFINITY, fast = 0;
    bool short_enough =
        s->edge->kind == KG_EDGE_CUT || fabs(s->dv) * (hi - lo) <= LONGEST_STEP || s->dv == 0;
    for (int k = 0; k < 3 && short_enough; k++) {
        node[k] = measure_at(s, lo + (hi - lo) * gauss_node[k]);
        slow = fmin(slow, node[k].space_length);
        fast = fmax(fast, node[k].space_length);
    }
    if (depth < MAX_DEPTH && !(short_enough && fast <= STEADY * slow)) {
        measure_span(s, lo, 0.5 * (lo + hi), depth + 1, sum);
        measure_span(s, 0.5 * (lo + hi), hi, depth + 1, sum);
        return;
    }
    for (int k = 0; k < 3 && short_enough; k++)
        add_scaled(sum, (hi - lo) * gauss_weight[k], &node[k]);
}

/* Where two cuts meet, each ends on its own curve, a little beside the other: the step between
 * counts for areas, or its distance from where moments are taken about would. */
static void close_gap(const kg_patch *patch, const kg_region_loop *loop, const kg_region_edge *edge,
                      kg_measure *sum) {
    const kg_cross_point a = kg_region_edge_point(loop, edge, edge->count),
                         b = loop->points[(edge->first + edge->count) % loop->point_count];
    if (a.u == b.u && a.v == b.v)
        return;
    kg_ruling r = kg_patch_ruling(patch, a.v);
    kg_vec3 w = kg_sub(r.dp, kg_scale(r.d, kg_dot(r.dp, r.d)));
    double wide = kg_len(w), c = kg_dot(r.dd, w) / wide, u = 0.5 * (a.u + b.u);
    sum->space_moment += u * (wide + 0.5 * c * u) * (b.v - a.v);
    sum->paper_moment +=
        0.5 * kg_cross2(kg_patch_unroll(patch, a.u, a.v), kg_patch_unroll(patch, b.u, b.v));
}

kg_measure kg_region_edge_measure(const kg_patch *patch, const kg_region_loop *loop,
                                  const kg_region_edge *edge, const kg_patch *cutter, double from,
                                  double to) {
    kg_measure m = {0};
    for (size_t i = (size_t)fmax(floor(from), 0); i < edge->count && (double)i < to; i++) {
        double lo = fmax(from - (double)i, 0), hi = fmin(to - (double)i, 1);
        kg_cross_point p = kg_region_edge_point(loop, edge, i),
                       q = kg_region_edge_point(loop, edge, i + 1);
        span s = {patch, loop, edge, cutter, i, q.v - p.v};
        if (lo < hi)
            measure_span(&s, lo, hi, 0, &m);
    }
    if (from < to && to == (double)edge->count)
        close_gap(patch, loop, edge, &m);
    return m;
}

kg_measure kg_region_measure(const kg_patch *patch, const kg_region *region,
                             kg_patch_finder finder) {
    kg_measure sum = {0};
    for (size_t i = 0; i < region->loop_count; i++)
        for (size_t k = 0; k < region->loops[i].edge_count; k++) {
            const kg_region_edge *e = &region->loops[i].edges[k];
            const kg_patch *cutter =
                e->kind == KG_EDGE_CUT ? finder.find(finder.user, e->source) : NULL;
            kg_measure m =
                kg_region_edge_measure(patch, &region->loops[i], e, cutter, 0, (double)e->count);
            add_scaled(&sum, 1, &m);
        }
    return sum;
}
