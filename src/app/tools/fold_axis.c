/* Axes from edges and points: Huzita's axioms 3 and 4. */
#include "app/tools/fold.h"

/* Sine of the angle between lines that count as parallel. */
#define PARALLEL 1e-9

static kg_vec3 direction_of(const kg_fold_edge *e) {
    return kg_unit(kg_sub(e->ends[1], e->ends[0]));
}

static kg_vec3 foot_on(const kg_fold_edge *e, kg_vec3 p) {
    kg_vec3 d = direction_of(e);
    return kg_madd(e->ends[0], kg_dot(kg_sub(p, e->ends[0]), d), d);
}

/* From where two lines meet to the place clicked, or to the farther end when that is the place. */
static kg_vec3 ray_from(kg_vec3 meet, const kg_fold_edge *e) {
    double length = kg_dist(e->ends[0], e->ends[1]);
    kg_vec3 to = e->at;
    if (kg_dist(meet, to) < 1e-6 * length)
        to = e->ends[kg_dist(meet, e->ends[1]) > kg_dist(meet, e->ends[0])];
    return kg_unit(kg_sub(to, meet));
}

bool kg_axis_bisect(const kg_fold_edge *a, const kg_fold_edge *b, kg_vec3 out_axis[2]) {
    kg_vec3 d = direction_of(a), n = direction_of(b), across = kg_cross(d, n);
    double square = kg_dot(across, across);
    if (square < PARALLEL * PARALLEL) {
        kg_vec3 foot = foot_on(b, a->ends[0]);
        if (kg_dist(foot, a->ends[0]) < 1e-6 * kg_dist(a->ends[0], a->ends[1]))
            return false;
        out_axis[0] = kg_lerp(a->ends[0], foot, 0.5);
        out_axis[1] = kg_add(out_axis[0], kg_sub(a->ends[1], a->ends[0]));
        return true;
    }
    double t = kg_dot(kg_cross(kg_sub(b->ends[0], a->ends[0]), n), across) / square;
    kg_vec3 meet = kg_madd(a->ends[0], t, d);
    kg_vec3 half = kg_add(ray_from(meet, a), ray_from(meet, b));
    if (kg_len(half) < PARALLEL)
        return false;
    out_axis[0] = meet;
    out_axis[1] = kg_madd(meet, kg_dist(a->ends[0], a->ends[1]), kg_unit(half));
    return true;
}

bool kg_axis_square(const kg_fold_edge *edge, kg_vec3 point, kg_vec3 normal, kg_vec3 out_axis[2]) {
    kg_vec3 along = kg_cross(normal, direction_of(edge));
    if (!(kg_len(along) > 0.5)) /* the edge is not of this plane */
        return false;
    out_axis[0] = point;
    out_axis[1] = kg_madd(point, kg_dist(edge->ends[0], edge->ends[1]), kg_unit(along));
    return true;
}
