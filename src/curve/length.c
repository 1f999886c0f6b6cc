#include "curve/quadrature.h"
#include "katagami/curve.h"

#include <assert.h>

/* |p'| is analytic but for branch points where p'·p' = 0 at a complex v. Seen from the middle a of
 * an interval of half width h, with
 *
 *     W(r) = sum over k >= 2 of |p^(k)(a)| r^(k-1) / (k-1)!  >=  |p'(z) - p'(a)|  for |z - a| <= r,
 *
 * p'(z)·p'(z) cannot vanish while W² + 2 W |p'(a)| < |p'(a)|², that is W < (√2 - 1) |p'(a)|. With
 * no branch point within 1.65 h the 16-point rule converges like 2.96^-32 < 1e-15. */
#define CLEAR_RADIUS 1.65
#define CLEAR_SHARE 0.414

/* Halvings at most; a curve's cusps are no sharper than 1e-7 (kg_curve_init), which takes 25. */
enum { MAX_DEPTH = 40 };

static double length(const kg_curve *c, double a, double h, int depth) {
    kg_vec3 d[KG_CURVE_MAX_POINTS];
    int n = c->degree;
    kg_curve_derivatives(c, a, n, d);
    double factorial = 1, r = 1, w = 0;
    for (int k = 2; k <= n; k++) {
        factorial *= k - 1;
        r *= CLEAR_RADIUS * fabs(h);
        d[k] = kg_scale(d[k], 1 / factorial); /* Taylor coefficients of p' */
        w += kg_len(d[k]) * r;
    }
    if (w > CLEAR_SHARE * kg_len(d[1]) && depth < MAX_DEPTH)
        return length(c, a - 0.5 * h, 0.5 * h, depth + 1) +
               length(c, a + 0.5 * h, 0.5 * h, depth + 1);
    double sum = 0;
    for (int i = 0; i < KG_GAUSS_COUNT; i++) {
        double t = h * (2 * kg_gauss_node[i] - 1);
        kg_vec3 hodograph = d[n];
        for (int k = n - 1; k >= 1; k--)
            hodograph = kg_madd(d[k], t, hodograph);
        sum += kg_gauss_weight[i] * kg_len(hodograph);
    }
    return sum * 2 * h;
}

double kg_curve_length(const kg_curve *curve, double v0, double v1) {
    return length(curve, 0.5 * (v0 + v1), 0.5 * (v1 - v0), 0);
}

double kg_curve_at_length(const kg_curve *curve, double wanted) {
    double total = kg_curve_length(curve, 0, 1);
    if (!(wanted > 0))
        return 0;
    if (wanted >= total)
        return 1;
    /* Newton steps kept inside a shrinking bracket. */
    double lo = 0, hi = 1, v = wanted / total, at = kg_curve_length(curve, 0, v);
    for (int i = 0; i < 60 && fabs(at - wanted) > 1e-15 * total; i++) {
        if (at < wanted)
            lo = v;
        else
            hi = v;
        kg_vec3 d[2];
        kg_curve_derivatives(curve, v, 1, d);
        double next = v - (at - wanted) / kg_len(d[1]);
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        if (next == v)
            break;
        at += kg_curve_length(curve, v, next);
        v = next;
    }
    return v;
}
