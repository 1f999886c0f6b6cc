/* The least value of a function of a few numbers, without derivatives. */
#ifndef KG_PATCH_SIMPLEX_H
#define KG_PATCH_SIMPLEX_H

enum { KG_SIMPLEX_MOST = 8 };

typedef double (*kg_simplex_cost)(const double *x, const void *data);

/* Nelder and Mead (1965), "A simplex method for function minimization": from `x`, with `step` in
 * every direction, at most `rounds` rounds. Leaves the best place in `x` and returns its value,
 * which is never worse than the first. count <= KG_SIMPLEX_MOST; values may be infinite but not
 * NaN. */
double kg_simplex_descend(kg_simplex_cost cost, const void *data, int count, double step,
                          int rounds, double *x);

#endif
