/* Gauss-Legendre rules on [0,1]. */
#ifndef KG_CURVE_QUADRATURE_H
#define KG_CURVE_QUADRATURE_H

enum { KG_GAUSS_COUNT = 16 };

/* Nodes in (0,1) and weights that sum to 1; exact for polynomials of degree 31. */
extern const double kg_gauss_node[KG_GAUSS_COUNT];
extern const double kg_gauss_weight[KG_GAUSS_COUNT];

/* The rules of 8 and 5 points, for functions that are smooth far around. */
extern const double kg_gauss8_node[8], kg_gauss8_weight[8];
extern const double kg_gauss5_node[5], kg_gauss5_weight[5];

#endif
