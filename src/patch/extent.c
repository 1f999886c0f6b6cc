/* How far a patch may reach: the edge of regression over all rulings, and their angles. */
#include "patch/prepare.h"

#include <stdlib.h>
#include <string.h>

/* A ruling nearer to its geodesic than this (radians) is taken to run along it: the paper beside
 * it would be narrower than a millionth of the patch. */
#define LEAST_THETA 1e-6

typedef double (*measure)(const kg_ruling *r);

/* 1/u of the edge of regression: smooth where u runs through infinity. */
static double inverse_regression(const kg_ruling *r) {
    return r->dtheta / (r->speed * r->sin_theta);
}

static double theta(const kg_ruling *r) {
    return atan2(r->sin_theta, r->cos_theta);
}

static double speed(const kg_ruling *r) {
    return r->speed;
}

/* |p' × p''| / |p'|: what stands between the ruling and the geodesic. */
static double bend(const kg_ruling *r) {
    return kg_len(kg_cross(r->dp, r->ddp)) / r->speed;
}

/* The largest (sign 1) or smallest (-1) value of f in [lo, hi], where it has one, by golden
 * section. v within 1e-7 of the bracket puts a smooth extreme right to 1e-14. */
static double climb(const kg_patch *p, measure f, double sign, double lo, double hi,
                    double *out_v) {
    const double golden = 0.61803398874989485, narrow = 1e-7 * (hi - lo);
    double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    kg_ruling ra = kg_patch_ruling(p, a), rb = kg_patch_ruling(p, b);
    double fa = sign * f(&ra), fb = sign * f(&rb);
    while (hi - lo > narrow) {
        if (fa > fb) {
            hi = b, b = a, fb = fa;
            a = hi - golden * (hi - lo);
            ra = kg_patch_ruling(p, a), fa = sign * f(&ra);
        } else {
            lo = a, a = b, fa = fb;
            b = lo + golden * (hi - lo);
            rb = kg_patch_ruling(p, b), fb = sign * f(&rb);
        }
        if (hi - lo <= 4e-16 * hi) /* no room left between doubles */
            break;
    }
    *out_v = fa > fb ? a : b;
    return sign * fmax(fa, fb);
}

/* ---- samples ---------------------------------------------------------------------------- */

/* Even samples miss what happens beside a near-inflection or near-cusp, as narrow as the place is
 * sharp: there the samples draw together by halves, down to 2^-GRADES of an even step. */
enum {
    GRADES = 28,
    MAX_PLACES = 8,
    MAX_SAMPLES = KG_PATCH_SCAN + 1 + MAX_PLACES * (2 * GRADES + 1)
};

/* A minimum below this share of the largest value is such a place. Above it the even samples see
 * enough. */
#define SHARP 0.2

typedef struct samples {
    kg_ruling rulings[MAX_SAMPLES];
    int count;
} samples;

static int by_v(const void *a, const void *b) {
    double x = ((const kg_ruling *)a)->v, y = ((const kg_ruling *)b)->v;
    return (x > y) - (x < y);
}

static void add_sharp_places(const kg_patch *p, measure f, samples *s) {
    enum { N = KG_PATCH_SCAN };
    double value[N + 1], largest = 0;
    for (int i = 0; i <= N; i++) {
        value[i] = f(&s->rulings[i]);
        largest = fmax(largest, value[i]);
    }
    for (int i = 0; i <= N; i++) {
        if (!(value[i] < SHARP * largest) || (i > 0 && value[i - 1] < value[i]) ||
            (i < N && value[i + 1] < value[i]))
            continue;
        if (s->count + 2 * GRADES + 1 > MAX_SAMPLES)
            return;
        double at, lo = fmax(0, (i - 1.0) / N), hi = fmin(1, (i + 1.0) / N);
        climb(p, f, -1, lo, hi, &at);
        s->rulings[s->count++] = kg_patch_ruling(p, at);
        double step = 1.0 / N;
        for (int k = 0; k < GRADES; k++, step *= 0.5) {
            if (at - step >= 0)
                s->rulings[s->count++] = kg_patch_ruling(p, at - step);
            if (at + step <= 1)
                s->rulings[s->count++] = kg_patch_ruling(p, at + step);
        }
    }
}

static void sample(const kg_patch *p, samples *s) {
    s->count = 0;
    for (int i = 0; i <= KG_PATCH_SCAN; i++)
        s->rulings[s->count++] = kg_patch_ruling(p, (double)i / KG_PATCH_SCAN);
    int even = s->count;
    add_sharp_places(p, bend, s);
    add_sharp_places(p, speed, s);
    if (s->count > even)
        qsort(s->rulings, (size_t)s->count, sizeof *s->rulings, by_v);
}

/* The smallest and the largest value of f over v: samples, refined where one stands out. */
static void extremes(const kg_patch *p, const samples *s, measure f, double *out_value,
                     double *out_v) {
    double values[MAX_SAMPLES];
    for (int i = 0; i < s->count; i++)
        values[i] = f(&s->rulings[i]);
    for (int k = 0; k < 2; k++) {
        double sign = k ? 1 : -1;
        int best = 0;
        for (int i = 1; i < s->count; i++)
            if (sign * values[i] > sign * values[best])
                best = i;
        out_value[k] = values[best];
        out_v[k] = s->rulings[best].v;
        /* a peak between samples tops its highest sample by less than this */
        double close = values[best] - sign * 0.1 * fabs(values[best]);
        for (int i = 0; i < s->count; i++) {
            int before = i > 0 ? i - 1 : i, after = i + 1 < s->count ? i + 1 : i;
            if (sign * values[i] < sign * close || sign * values[before] > sign * values[i] ||
                sign * values[after] > sign * values[i])
                continue;
            double v, lo = s->rulings[before].v, hi = s->rulings[after].v;
            double value = climb(p, f, sign, lo, hi, &v);
            if (sign * value > sign * out_value[k])
                out_value[k] = value, out_v[k] = v;
        }
    }
}

/* ---- extent ----------------------------------------------------------------------------- */

static kg_status measure_rulings(kg_patch *p, kg_error *error) {
    p->regression[0] = -HUGE_VAL, p->regression[1] = HUGE_VAL;
    p->regression_v[0] = p->regression_v[1] = NAN;
    p->flattest_v = 0;
    if (p->ruling_degree == 0) {
        p->theta[0] = p->theta[1] = acos(0);
        return KG_OK;
    }
    samples s;
    sample(p, &s);
    const double pi = acos(-1.0);
    double value[2], v[2];
    /* NaN where p' × p'' vanishes */
    for (int i = 0; i < s.count; i++) {
        double t = theta(&s.rulings[i]);
        if (!(t >= LEAST_THETA && t <= pi - LEAST_THETA))
            return kg_fail(error, KG_ERR_INPUT,
                           "the ruling runs along the geodesic at v = %.4g, a twisted inflection; "
                           "flatten the geodesic into a plane or bend it one way",
                           s.rulings[i].v);
    }
    extremes(p, &s, theta, p->theta, v);
    p->flattest_v = p->theta[0] < pi - p->theta[1] ? v[0] : v[1];
    extremes(p, &s, inverse_regression, value, v);
    for (int k = 0; k < 2; k++)
        if (k ? value[k] > 0 : value[k] < 0) {
            p->regression[k] = 1 / value[k];
            p->regression_v[k] = v[k];
        }
    return KG_OK;
}

kg_status kg_patch_init_extent(const kg_patch_input *input, kg_patch *patch, kg_error *error) {
    double lo = input->extent[0], hi = input->extent[1];
    if (!(lo < hi && lo >= -KG_MAX_COORDINATE && hi <= KG_MAX_COORDINATE))
        return kg_fail(error, KG_ERR_INPUT,
                       "the extent [%g, %g] is not an interval; give two numbers within 1e6 mm, "
                       "the smaller first",
                       lo, hi);
    kg_status status = measure_rulings(patch, error);
    if (status)
        return status;
    double least = KG_REGRESSION_LIMIT * patch->regression[0];
    double most = KG_REGRESSION_LIMIT * patch->regression[1];
    patch->wished_extent[0] = lo, patch->wished_extent[1] = hi;
    patch->extent[0] = fmax(lo, least);
    patch->extent[1] = fmin(hi, most);
    patch->clamped = lo < least || hi > most;
    if (!(patch->extent[0] < patch->extent[1]))
        return kg_fail(error, KG_ERR_INPUT,
                       "the extent [%g, %g] lies wholly beyond the edge of regression (allowed: "
                       "%g to %g); bring it nearer to the geodesic or bend the geodesic less",
                       lo, hi, least, most);
    return KG_OK;
}
