/* Computed to 40 digits by Newton's method on the Legendre polynomial P16. */
#include "curve/quadrature.h"

#include <math.h>

const double kg_gauss_node[KG_GAUSS_COUNT] = {
    0.00529953250417503370,
    0.02771248846338371196,
    0.06718439880608412805,
    0.12229779582249848305,
    0.19106187779867812577,
    0.27099161117138630682,
    0.35919822461037054338,
    0.45249374508118127990,
    0.54750625491881872009,
    0.64080177538962945661,
    0.72900838882861369317,
    0.80893812220132187422,
    0.87770220417750151694,
    0.93281560119391587194,
    0.97228751153661628803,
    0.99470046749582496629,
};

const double kg_gauss_weight[KG_GAUSS_COUNT] = {
    0.0135762297058770474258,
    0.0311267619693239464314,
    0.0475792558412463924049,
    0.0623144856277669360262,
    0.0747979944082883660407,
    0.0845782596975012690946,
    0.0913017075224617944333,
    0.0947253052275342481426,
    0.0947253052275342481426,
    0.0913017075224617944333,
    0.0845782596975012690946,
    0.0747979944082883660407,
    0.0623144856277669360262,
    0.0475792558412463924049,
    0.0311267619693239464314,
    0.0135762297058770474258,
};

static double gauss(kg_integrand f, const void *data, double a, double b) {
    double sum = 0;
    for (int i = 0; i < KG_GAUSS_COUNT; i++)
        sum += kg_gauss_weight[i] * f(data, a + (b - a) * kg_gauss_node[i]);
    return sum * (b - a);
}

/* Deep enough to resolve a corner of the integrand to rounding; a hang is impossible. */
enum { MAX_DEPTH = 40 };

static double refine(kg_integrand f, const void *data, double a, double b, double whole,
                     double tolerance, int depth) {
    double m = 0.5 * (a + b);
    double left = gauss(f, data, a, m), right = gauss(f, data, m, b);
    if (depth >= MAX_DEPTH || fabs(left + right - whole) <= tolerance)
        return left + right;
    return refine(f, data, a, m, left, tolerance, depth + 1) +
           refine(f, data, m, b, right, tolerance, depth + 1);
}

double kg_integrate(kg_integrand f, const void *data, double a, double b, double relative) {
    double whole = gauss(f, data, a, b);
    return refine(f, data, a, b, whole, relative * fabs(whole), 0);
}
