/* Descartes' rule in Bernstein form: no more roots than sign changes of the coefficients. */
#include "trim/crossing.h"

#include <assert.h>
#include <string.h>

enum { MAX_COUNT = KG_PLUCKER_MAX + 1, MAX_DEPTH = 40 };

static int sign_of(double x, double noise) {
    return x > noise ? 1 : x < -noise ? -1 : 0;
}

static int variations(const double *c, int n, double noise) {
    int last = 0, count = 0;
    for (int i = 0; i <= n; i++) {
        int s = sign_of(c[i], noise);
        if (s && last && s != last)
            count++;
        last = s ? s : last;
    }
    return count;
}

/* Value and derivative by de Casteljau. */
static double evaluate(const double *c, int n, double t, double *out_slope) {
    double b[MAX_COUNT];
    memcpy(b, c, sizeof *b * (size_t)(n + 1));
    for (int k = n; k > 1; k--)
        for (int i = 0; i < k; i++)
            b[i] += t * (b[i + 1] - b[i]);
    *out_slope = n * (b[1] - b[0]);
    return b[0] + t * (b[1] - b[0]);
}

/* The only root between ends of different sign: Newton steps kept inside the bracket, to about
 * 1e-12. */
static double single_root(const double *c, int n) {
    double lo = 0, hi = 1, t = c[0] / (c[0] - c[n]);
    for (int i = 0; i < 60; i++) {
        double slope, f = evaluate(c, n, t, &slope), step = f / slope, next = t - step;
        if (fabs(step) < 1e-6) /* the next step would be its square */
            return kg_min(kg_max(next, 0), 1);
        *((f > 0) == (c[0] > 0) ? &lo : &hi) = t;
        t = next > lo && next < hi ? next : 0.5 * (lo + hi);
    }
    return t;
}

static void isolate(const double *c, int n, double noise, double lo, double hi, int depth,
                    double *out, int *count) {
    int v = variations(c, n, noise);
    if (v == 0 || *count == n)
        return;
    int s0 = sign_of(c[0], noise), s1 = sign_of(c[n], noise);
    if (v == 1 && s0 && s1) {
        out[(*count)++] = lo + (hi - lo) * single_root(c, n);
        return;
    }
    if (depth == MAX_DEPTH) {
        if (s0 * s1 < 0)
            out[(*count)++] = 0.5 * (lo + hi);
        return;
    }
    /* A cut that falls on a root would lose it: move the cut. */
    static const double cuts[4] = {0.5, 0.4619, 0.5473, 0.4217};
    double left[MAX_COUNT], right[MAX_COUNT], cut = 0.5;
    for (int k = 0; k < 4; k++) {
        cut = cuts[k];
        memcpy(right, c, sizeof *right * (size_t)(n + 1));
        left[0] = right[0];
        for (int j = 1; j <= n; j++) {
            for (int i = 0; i <= n - j; i++)
                right[i] += cut * (right[i + 1] - right[i]);
            left[j] = right[0];
        }
        if (sign_of(right[0], noise))
            break;
    }
    double mid = lo + cut * (hi - lo);
    int before = *count;
    int s = sign_of(right[0], noise);
    isolate(left, n, noise, lo, mid, depth + 1, out, count);
    isolate(right, n, noise, mid, hi, depth + 1, out, count);
    /* Values too small to tell all around: what the ends say decides. */
    if (s == 0 && s0 * s1 != 0 && ((*count - before) & 1) != (s0 * s1 < 0)) {
        *count = before;
        if (s0 * s1 < 0)
            out[(*count)++] = mid;
    }
}

int kg_sign_changes(const double *c, int n, double noise, double *out_roots) {
    assert(n < MAX_COUNT);
    int s0 = sign_of(c[0], noise), s1 = sign_of(c[n], noise);
    if (!s0 || !s1)
        return -1;
    int count = 0;
    isolate(c, n, noise, 0, 1, 0, out_roots, &count);
    return (count & 1) == (s0 != s1) ? count : -1;
}
