#include "curve/quadrature.h"
#include "katagami/curve.h"

/* |p'| is analytic but for branch points where p'·p' = 0 at a complex v. Seen from the middle a of
 * an interval of half width h, with
 *
 *     W(r) = sum over k >= 2 of |p^(k)(a)| r^(k-1) / (k-1)!  >=  |p'(z) - p'(a)|  for |z - a| <= r,
 *
 * p'(z)·p'(z) cannot vanish while W² + 2 W |p'(a)| < |p'(a)|², that is W < (√2 - 1) |p'(a)|. With
 * no branch point within c h a rule of n points converges like (c + √(c² - 1))^-2n: each rule has
 * the c where that is below 1e-15. */
#define CLEAR_SHARE 0.414

typedef struct rule {
    double clear; /* c */
    int count;
    const double *node, *weight;
} rule;

static const rule rules[] = {{16.2, 5, kg_gauss5_node, kg_gauss5_weight},
                             {4.45, 8, kg_gauss8_node, kg_gauss8_weight},
                             {1.65, KG_GAUSS_COUNT, kg_gauss_node, kg_gauss_weight}};
enum { RULES = sizeof rules / sizeof *rules };

/* Halvings at most; a curve's cusps are no sharper than 1e-7 (kg_curve_init), which takes 25. */
enum { MAX_DEPTH = 40 };

/* The first rule that converges on an interval of half width h, none if there is none; size[k]:
 * |p^(k)| / (k-1)! in its middle. */
static const rule *rule_for(const double *size, int n, double h) {
    for (int i = 0; i < RULES; i++) {
        double r = rules[i].clear * h, w = 0;
        for (int k = n; k >= 2; k--)
            w = (w + size[k]) * r;
        if (w <= CLEAR_SHARE * size[1])
            return &rules[i];
    }
    return NULL;
}

static double length(const kg_curve *c, double a, double h, int depth) {
    kg_vec3 d[KG_CURVE_MAX_POINTS];
    double size[KG_CURVE_MAX_POINTS] = {0}, factorial = 1;
    int n = c->degree;
    kg_curve_derivatives(c, a, n, d);
    for (int k = 1; k <= n; k++) {
        factorial *= k > 1 ? k - 1 : 1;
        d[k] = kg_scale(d[k], 1 / factorial); /* Taylor coefficients of p' */
        size[k] = kg_len(d[k]);
    }
    const rule *chosen = rule_for(size, n, fabs(h));
    if (!chosen && depth < MAX_DEPTH)
        return length(c, a - 0.5 * h, 0.5 * h, depth + 1) +
               length(c, a + 0.5 * h, 0.5 * h, depth + 1);
    if (!chosen)
        chosen = &rules[RULES - 1];
    double sum = 0;
    for (int i = 0; i < chosen->count; i++) {
        double t = h * (2 * chosen->node[i] - 1);
        kg_vec3 hodograph = d[n];
        for (int k = n - 1; k >= 1; k--)
            hodograph = kg_madd(d[k], t, hodograph);
        sum += chosen->weight[i] * kg_len(hodograph);
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
