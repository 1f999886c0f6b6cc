/* The smallest value of a function of one variable in an interval. */
#ifndef KG_PATCH_MINIMUM_H
#define KG_PATCH_MINIMUM_H

#include "katagami/base.h"

/* Where f is smallest in [lo, hi], if it has one minimum there, to about `narrow`: parabolas
 * through the best three points, golden section where they do not shrink (Brent 1973, "Algorithms
 * for minimization without derivatives", chapter 5). Returns the value there. */
double kg_minimum(double (*f)(void *user, double x), void *user, double lo, double hi,
                  double narrow, double *out_x);

#endif
