#include "curve/bernstein.h"

#include <assert.h>
#include <string.h>

double kg_binomial(int n, int k) {
    assert(n >= 0 && n <= KG_BERNSTEIN_MAX_DEGREE && k >= 0 && k <= n);
    if (k > n - k)
        k = n - k;
    double c = 1;
    for (int i = 1; i <= k; i++)
        c = c * (n - k + i) / i; /* exact: every prefix is a binomial below 2^53 */
    return c;
}

/* t^n by squaring */
static double power(double t, int n) {
    double r = 1;
    for (; n > 0; n >>= 1, t *= t)
        if (n & 1)
            r *= t;
    return r;
}

kg_vec3 kg_bernstein_eval3(const kg_vec3 *a, int n, double t) {
    /* step / i is a table so that the loop holds no division */
    static const double inverse[KG_BERNSTEIN_MAX_DEGREE + 1] = {
        0,        1.0 / 1,  1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,  1.0 / 8,
        1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17,
        1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24, 1.0 / 25, 1.0 / 26,
        1.0 / 27, 1.0 / 28, 1.0 / 29, 1.0 / 30, 1.0 / 31, 1.0 / 32, 1.0 / 33, 1.0 / 34, 1.0 / 35,
        1.0 / 36, 1.0 / 37, 1.0 / 38, 1.0 / 39, 1.0 / 40, 1.0 / 41, 1.0 / 42, 1.0 / 43, 1.0 / 44,
        1.0 / 45, 1.0 / 46, 1.0 / 47, 1.0 / 48};
    double s = 1 - t, w = 1;
    bool low = t <= 0.5;
    double r = low ? t / s : s / t;
    kg_vec3 acc = low ? a[0] : a[n];
    for (int i = 1; i <= n; i++) {
        w *= r * (n - i + 1) * inverse[i];
        acc = kg_madd(acc, w, low ? a[i] : a[n - i]);
    }
    return kg_scale(acc, power(low ? s : t, n));
}

/* Products: with a^[i] = C(n,i) a[i] the coefficients simply convolve. */
typedef struct row {
    double c[KG_BERNSTEIN_MAX_DEGREE + 1];
} row;

/* C(n, 0 … n) */
static row binomials(int n) {
    assert(n >= 0 && n <= KG_BERNSTEIN_MAX_DEGREE);
    row r;
    r.c[0] = 1;
    for (int i = 1; i <= n; i++)
        r.c[i] = 2 * i <= n ? r.c[i - 1] * (n - i + 1) / i : r.c[n - i];
    return r;
}

void kg_bernstein_mul(const double *a, int n, const double *b, int m, double *out) {
    row ca = binomials(n), cb = binomials(m), c = binomials(n + m);
    memset(out, 0, sizeof *out * (size_t)(n + m + 1));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            out[i + j] += ca.c[i] * cb.c[j] * a[i] * b[j];
    for (int k = 0; k <= n + m; k++)
        out[k] /= c.c[k];
}

static void divide3(kg_vec3 *a, int n) {
    row c = binomials(n);
    for (int k = 0; k <= n; k++)
        a[k] = kg_scale(a[k], 1 / c.c[k]);
}

void kg_bernstein_mul3(const double *a, int n, const kg_vec3 *b, int m, kg_vec3 *out) {
    row ca = binomials(n), cb = binomials(m);
    memset(out, 0, sizeof *out * (size_t)(n + m + 1));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            out[i + j] = kg_madd(out[i + j], ca.c[i] * cb.c[j] * a[i], b[j]);
    divide3(out, n + m);
}

void kg_bernstein_dot(const kg_vec3 *a, int n, const kg_vec3 *b, int m, double *out) {
    row ca = binomials(n), cb = binomials(m), c = binomials(n + m);
    memset(out, 0, sizeof *out * (size_t)(n + m + 1));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            out[i + j] += ca.c[i] * cb.c[j] * kg_dot(a[i], b[j]);
    for (int k = 0; k <= n + m; k++)
        out[k] /= c.c[k];
}

void kg_bernstein_cross(const kg_vec3 *a, int n, const kg_vec3 *b, int m, kg_vec3 *out) {
    row ca = binomials(n), cb = binomials(m);
    memset(out, 0, sizeof *out * (size_t)(n + m + 1));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++)
            out[i + j] = kg_madd(out[i + j], ca.c[i] * cb.c[j], kg_cross(a[i], b[j]));
    divide3(out, n + m);
}

void kg_bernstein_elevate3(const kg_vec3 *a, int n, int m, kg_vec3 *out) {
    memmove(out, a, sizeof *a * (size_t)(n + 1));
    for (; n < m; n++) {
        out[n + 1] = out[n];
        for (int i = n; i >= 1; i--)
            out[i] = kg_lerp(out[i], out[i - 1], (double)i / (n + 1));
    }
}

void kg_bernstein_deflate3(const kg_vec3 *a, int n, double root, kg_vec3 *out) {
    /* (t - root) = -root (1-t) + (1-root) t, so C(n,i) a[i] =
     * (1-root) C(n-1,i-1) q[i-1] - root C(n-1,i) q[i]. */
    if (root > 0.5) {
        for (int i = 0; i < n; i++) {
            kg_vec3 r = kg_scale(a[i], -kg_binomial(n, i));
            if (i > 0)
                r = kg_madd(r, (1 - root) * kg_binomial(n - 1, i - 1), out[i - 1]);
            out[i] = kg_scale(r, 1 / (root * kg_binomial(n - 1, i)));
        }
    } else {
        kg_vec3 above = a[n]; /* a[i + 1], which may be out[i + 1] */
        for (int i = n - 1; i >= 0; i--) {
            kg_vec3 r = kg_scale(above, kg_binomial(n, i + 1));
            above = a[i];
            if (i + 1 < n)
                r = kg_madd(r, root * kg_binomial(n - 1, i + 1), out[i + 1]);
            out[i] = kg_scale(r, 1 / ((1 - root) * kg_binomial(n - 1, i)));
        }
    }
}

void kg_bernstein_restrict3(kg_vec3 *a, int n, double lo, double hi) {
    /* Keep [0,hi] by de Casteljau from the left, then [lo/hi,1] of that from the right. */
    if (hi < 1)
        for (int k = 1; k <= n; k++)
            for (int i = n; i >= k; i--)
                a[i] = kg_lerp(a[i - 1], a[i], hi);
    double cut = lo / hi;
    if (cut > 0)
        for (int k = 1; k <= n; k++)
            for (int i = 0; i <= n - k; i++)
                a[i] = kg_lerp(a[i], a[i + 1], cut);
}
