/* Gauss-Legendre quadrature on an interval. */
#ifndef KG_CURVE_QUADRATURE_H
#define KG_CURVE_QUADRATURE_H

enum { KG_GAUSS_COUNT = 16 };

/* Nodes in (0,1) and weights that sum to 1; exact for polynomials of degree 31. */
extern const double kg_gauss_node[KG_GAUSS_COUNT];
extern const double kg_gauss_weight[KG_GAUSS_COUNT];

typedef double (*kg_integrand)(const void *data, double t);

/* Integral of f over [a,b], halving where two estimates differ by more than `relative` of the
 * whole (and by more than rounding). f must be finite; integrable corners are fine. */
double kg_integrate(kg_integrand f, const void *data, double a, double b, double relative);

#endif
