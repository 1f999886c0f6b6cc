/*
 * Polynomials in Bernstein form on [0,1]: coefficients a[0..n] of sum a[i] C(n,i) t^i (1-t)^(n-i).
 * Farouki and Rajan 1988, "Algorithms for polynomials in Bernstein form".
 */
#ifndef KG_CURVE_BERNSTEIN_H
#define KG_CURVE_BERNSTEIN_H

#include "katagami/base.h"

enum { KG_BERNSTEIN_MAX_DEGREE = 48 };

/* C(n, k) for n <= KG_BERNSTEIN_MAX_DEGREE; exact in double. */
double kg_binomial(int n, int k);

/* The value by Horner's scheme in t/(1-t) or (1-t)/t: n multiply-adds, all basis terms positive, so
 * as stable as de Casteljau. */
kg_vec3 kg_bernstein_eval3(const kg_vec3 *a, int n, double t);

/* Products, degree n + m. `out` must not overlap the inputs. */
void kg_bernstein_mul(const double *a, int n, const double *b, int m, double *out);
void kg_bernstein_mul3(const double *a, int n, const kg_vec3 *b, int m, kg_vec3 *out);
void kg_bernstein_dot(const kg_vec3 *a, int n, const kg_vec3 *b, int m, double *out);
void kg_bernstein_cross(const kg_vec3 *a, int n, const kg_vec3 *b, int m, kg_vec3 *out);

/* The same polynomial with degree `m` >= n. In place is allowed. */
void kg_bernstein_elevate3(const kg_vec3 *a, int n, int m, kg_vec3 *out);

/* The quotient by (t - root), degree n - 1, where a(root) = 0; the remainder is dropped. Works
 * from the end farther from the root, where the recurrence is stable. In place is allowed. */
void kg_bernstein_deflate3(const kg_vec3 *a, int n, double root, kg_vec3 *out);

/* Coefficients of the same polynomial on [lo, hi], in place. */
void kg_bernstein_restrict3(kg_vec3 *a, int n, double lo, double hi);

#endif
