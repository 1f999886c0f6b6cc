/* Clamped uniform cubic B-splines through rows of numbers: the curves the samples are drawn with.
 */
#ifndef KG_SAMPLES_SPLINE_H
#define KG_SAMPLES_SPLINE_H

/* Evaluates the spline with `count` >= 4 rows of `width` numbers at t in [0,1]; it starts in the
 * first row, ends in the last and keeps close to the others. */
void spline_at(const double *rows, int count, int width, double t, double *out);

#endif
