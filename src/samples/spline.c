#include "samples/spline.h"

#include <assert.h>
#include <math.h>

enum { DEGREE = 3, MAX_WIDTH = 8 };

/* Knot i of the clamped uniform knot vector for `count` rows: 0 0 0 0 1 2 … s s s s. */
static double knot(int i, int count) {
    return fmin(fmax(i - DEGREE, 0), count - DEGREE);
}

/* De Boor's algorithm. */
void spline_at(const double *rows, int count, int width, double t, double *out) {
    assert(count > DEGREE && width > 0 && width <= MAX_WIDTH);
    int spans = count - DEGREE;
    double x = fmin(fmax(t, 0), 1) * spans;
    int span = x < spans ? (int)x : spans - 1;
    double d[DEGREE + 1][MAX_WIDTH];
    for (int j = 0; j <= DEGREE; j++)
        for (int k = 0; k < width; k++)
            d[j][k] = rows[(span + j) * width + k];
    for (int r = 1; r <= DEGREE; r++)
        for (int j = DEGREE; j >= r; j--) {
            double lo = knot(span + j, count), hi = knot(span + j + 1 + DEGREE - r, count);
            double a = (x - lo) / (hi - lo);
            for (int k = 0; k < width; k++)
                d[j][k] = (1 - a) * d[j - 1][k] + a * d[j][k];
        }
    for (int k = 0; k < width; k++)
        out[k] = d[DEGREE][k];
}
