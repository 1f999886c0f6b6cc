/* The rulings of a patch: what d is a multiple of. */
#include "patch/prepare.h"

#include "curve/bernstein.h"

#include <string.h>

enum { SCAN = KG_PATCH_SCAN };

/* The plane's normal with the sign of p' × p'' where the curve starts to bend. */
static kg_vec3 planar_ruling(const kg_curve *c) {
    kg_vec3 largest = kg_v3(0, 0, 0);
    for (int i = 0; i <= c->degree; i++)
        for (int j = 0; j < i; j++) {
            kg_vec3 n =
                kg_cross(kg_sub(c->points[j], c->points[0]), kg_sub(c->points[i], c->points[0]));
            if (kg_len(n) > kg_len(largest))
                largest = n;
        }
    for (int i = 0; i <= SCAN; i++) {
        kg_vec3 d[3];
        kg_curve_derivatives(c, (double)i / SCAN, 2, d);
        double bend = kg_dot(kg_cross(d[1], d[2]), largest);
        if (fabs(bend) > KG_FLATNESS * kg_dot(d[1], d[1]) * kg_len(largest))
            return kg_scale(kg_unit(largest), bend < 0 ? -1 : 1);
    }
    return kg_unit(largest);
}

static kg_status straight_ruling(const kg_patch_input *in, kg_vec3 along, kg_vec3 *out,
                                 kg_error *error) {
    /* sin of the angle below which a wish does not tell a direction */
    const double parallel = 1e-6;
    if (in->has_ruling) {
        kg_vec3 r = in->ruling;
        bool finite = isfinite(r.x) && isfinite(r.y) && isfinite(r.z);
        /* by the largest coordinate first: squares must not overflow */
        r = kg_unit(kg_scale(r, 1 / fmax(fabs(r.x), fmax(fabs(r.y), fabs(r.z)))));
        kg_vec3 across = kg_madd(r, -kg_dot(r, along), along);
        if (!finite || !(kg_len(across) >= parallel))
            return kg_fail(error, KG_ERR_INPUT,
                           "the ruling (%g, %g, %g) is parallel to the straight geodesic or not a "
                           "direction; give one across it",
                           in->ruling.x, in->ruling.y, in->ruling.z);
        *out = kg_unit(across);
        return KG_OK;
    }
    kg_vec3 up = kg_v3(0, 0, 1);
    kg_vec3 across = kg_madd(up, -kg_dot(up, along), along);
    if (kg_len(across) < parallel) {
        up = kg_v3(1, 0, 0);
        across = kg_madd(up, -kg_dot(up, along), along);
    }
    *out = kg_unit(across);
    return KG_OK;
}

/* ---- inflections ----------------------------------------------------------------------- */

/* What is lost, as a fraction of the remaining polynomial R, when an inflection is divided out of
 * D. R is then off by this, and lengths on paper with it: well below the 1e-6 that nets promise.
 * An inflection that a file's decimals moved off its exact place by KG_FLATNESS still passes. */
#define REMAINDER 1e-6

/* Where p' × p'' comes nearest to zero next to v: Gauss-Newton steps on its length. */
static double inflection_near(const kg_curve *c, double v, double *out_bend) {
    kg_vec3 d[4];
    for (int i = 0; i < 50; i++) {
        kg_curve_derivatives(c, v, 3, d);
        kg_vec3 bend = kg_cross(d[1], d[2]), slope = kg_cross(d[1], d[3]);
        double step = kg_dot(bend, slope) / kg_dot(slope, slope);
        if (!(fabs(step) > 1e-17)) /* below the rounding of v; or no slope */
            break;
        v = fmin(fmax(v - fmin(fmax(step, -1.0 / SCAN), 1.0 / SCAN), 0), 1);
    }
    kg_curve_derivatives(c, v, 2, d);
    *out_bend = kg_len(kg_cross(d[1], d[2]));
    return v;
}

/* Divides (v - at)³ out of D; false if it does not go, and `d` is untouched. */
static bool divide_out(kg_vec3 *d, int degree, double at) {
    kg_vec3 quotient[KG_DARBOUX_MAX_COUNT], product[KG_DARBOUX_MAX_COUNT];
    memcpy(quotient, d, sizeof *d * (size_t)(degree + 1));
    for (int k = 0; k < 3; k++)
        kg_bernstein_deflate3(quotient, degree - k, at, quotient);
    double a = -at, b = 1 - at;
    const double cube[4] = {a * a * a, a * a * b, a * b * b, b * b * b};
    kg_bernstein_mul3(cube, 3, quotient, degree - 3, product);
    double lost = 0;
    for (int i = 0; i <= degree; i++)
        lost = fmax(lost, kg_dist(product[i], d[i]));
    if (!(lost <= REMAINDER * kg_len(kg_bernstein_eval3(quotient, degree - 3, at))))
        return false;
    memcpy(d, quotient, sizeof *d * (size_t)(degree - 2));
    return true;
}

/* At an inflection with det(p',p''',p'''') = 0 the Darboux polynomial of a quintic has a triple
 * root, where d goes on continuously while D turns round. Divided out, what is left has the
 * direction of d all along. Other inflections stay, and show as rulings along the geodesic. */
static void remove_inflections(const kg_curve *c, kg_patch *p) {
    double bend[SCAN + 1], largest = 0;
    for (int i = 0; i <= SCAN; i++) {
        kg_vec3 d[3];
        kg_curve_derivatives(c, (double)i / SCAN, 2, d);
        bend[i] = kg_len(kg_cross(d[1], d[2]));
        largest = fmax(largest, bend[i]);
    }
    double last = -1;
    for (int i = 0; i <= SCAN; i++) {
        if ((i > 0 && bend[i - 1] < bend[i]) || (i < SCAN && bend[i + 1] < bend[i]))
            continue;
        double least, at = inflection_near(c, (double)i / SCAN, &least);
        /* two samples may lead to one inflection */
        if (least > KG_FLATNESS * largest || fabs(at - last) < KG_FLATNESS ||
            !divide_out(p->rulings, p->ruling_degree, at))
            continue;
        last = at;
        p->ruling_degree -= 3;
        if (at > KG_FLATNESS) /* D's sign holds at the start of the curve */
            for (int k = 0; k <= p->ruling_degree; k++)
                p->rulings[k] = kg_neg(p->rulings[k]);
    }
}

kg_status kg_patch_init_rulings(const kg_patch_input *input, kg_patch *patch, kg_error *error) {
    const kg_curve *c = &patch->geodesic;
    patch->ruling_degree = 0;
    if (patch->shape == KG_CURVE_STRAIGHT) {
        kg_vec3 along = kg_unit(kg_sub(c->points[c->degree], c->points[0]));
        return straight_ruling(input, along, &patch->rulings[0], error);
    }
    if (patch->shape == KG_CURVE_PLANAR) {
        patch->rulings[0] = planar_ruling(c);
        return KG_OK;
    }
    /* of unit size: D grows with up to the 18th power of it */
    kg_curve unit = *c;
    double size = kg_curve_size(c);
    for (int i = 0; i <= c->degree; i++)
        unit.points[i] = kg_scale(kg_sub(c->points[i], c->points[0]), 1 / size);
    patch->ruling_degree = kg_curve_darboux(&unit, patch->rulings);
    if (c->degree == 5) /* a spatial cubic has no inflections */
        remove_inflections(&unit, patch);
    double largest = 0;
    for (int i = 0; i <= patch->ruling_degree; i++)
        largest = fmax(largest, kg_len(patch->rulings[i]));
    for (int i = 0; i <= patch->ruling_degree; i++)
        patch->rulings[i] = kg_scale(patch->rulings[i], 1 / largest);
    return KG_OK;
}
