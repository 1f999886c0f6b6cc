/* Surfaces that coincide, and pairs of planes in one. */
#include "trim/crossing.h"

/* Fraction of the size: surfaces nearer than this to each other are one. Ten times the rounding
 * of a file with nine digits. */
#define SAME_SURFACE 1e-8

static kg_vec3 plane_normal(const kg_patch *p) {
    const kg_curve *c = &p->geodesic;
    return kg_unit(kg_cross(kg_sub(c->points[c->degree], c->points[0]), p->rulings[0]));
}

static void corners(const kg_patch *p, kg_vec3 out[4]) {
    for (int i = 0; i < 4; i++)
        out[i] = kg_patch_point(p, p->extent[i & 1], i >> 1);
}

bool kg_coplanar(const kg_patch *a, const kg_patch *b) {
    kg_vec3 n = plane_normal(a), x[4], y[4];
    corners(a, x);
    corners(b, y);
    for (int i = 0; i < 4; i++)
        if (!(fabs(kg_dot(n, kg_sub(y[i], x[0]))) <= SAME_SURFACE * fmax(a->size, b->size)))
            return false;
    return true;
}

bool kg_coplanar_overlap(const kg_patch *a, const kg_patch *b) {
    /* separating axes of two parallelograms: the normals of their sides */
    kg_vec3 n = plane_normal(a), x[4], y[4];
    corners(a, x);
    corners(b, y);
    kg_vec3 sides[4] = {kg_sub(x[1], x[0]), kg_sub(x[2], x[0]), kg_sub(y[1], y[0]),
                        kg_sub(y[2], y[0])};
    for (int k = 0; k < 4; k++) {
        kg_vec3 axis = kg_unit(kg_cross(n, sides[k]));
        double rx[2] = {INFINITY, -INFINITY}, ry[2] = {INFINITY, -INFINITY};
        for (int i = 0; i < 4; i++) {
            double px = kg_dot(axis, kg_sub(x[i], x[0])), py = kg_dot(axis, kg_sub(y[i], x[0]));
            rx[0] = fmin(rx[0], px), rx[1] = fmax(rx[1], px);
            ry[0] = fmin(ry[0], py), ry[1] = fmax(ry[1], py);
        }
        double gap = SAME_SURFACE * fmax(a->size, b->size);
        if (rx[0] > ry[1] - gap || ry[0] > rx[1] - gap)
            return false;
    }
    return true;
}

/* Does a stretch of the ruling v of A lie in the rectangle of B? */
static bool lies_in(const kg_patch *a, double v, const kg_patch *b) {
    enum { SAMPLES = 17 };
    int run = 0;
    if (v < 0 || v > 1)
        return false;
    for (int i = 0; i < SAMPLES; i++) {
        double u = a->extent[0] + (a->extent[1] - a->extent[0]) * i / (SAMPLES - 1), s, t;
        double gap = kg_patch_closest(b, kg_patch_point(a, u, v), &s, &t);
        run = gap <= SAME_SURFACE * fmax(a->size, b->size) ? run + 1 : 0;
        if (run == 3)
            return true;
    }
    return false;
}

bool kg_coincide_near(const kg_patch *a, double v, const kg_patch *b) {
    /* Surfaces that only touch along a ruling are apart by the square of this on each side. */
    const double step = 2e-3;
    return (lies_in(a, v - step, b) && lies_in(a, v - 2 * step, b)) ||
           (lies_in(a, v + step, b) && lies_in(a, v + 2 * step, b));
}

kg_status kg_fail_coincident(kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT,
                   "the two surfaces coincide on a piece, so they have no curve of crossing; move "
                   "or turn one of them, or shorten its extent");
}
