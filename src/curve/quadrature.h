/* The Gauss-Legendre rule on [0,1]. */
#ifndef KG_CURVE_QUADRATURE_H
#define KG_CURVE_QUADRATURE_H

enum { KG_GAUSS_COUNT = 16 };

/* Nodes in (0,1) and weights that sum to 1; exact for polynomials of degree 31. */
extern const double kg_gauss_node[KG_GAUSS_COUNT];
extern const double kg_gauss_weight[KG_GAUSS_COUNT];

#endif
