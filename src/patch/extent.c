/* How far a patch may reach: the edge of regression over all rulings, and their angles. */
#include "patch/minimum.h"
#include "patch/prepare.h"

/* A ruling nearer to its geodesic than this (radians) runs along it: sin θ is all rounding. */
#define LEAST_THETA 1e-12

/* A patch that has to be narrower than this share of its size is none: its edge would be within
 * what trims take for one point. */
#define LEAST_WIDTH 1e-6

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

typedef struct slope {
    const kg_patch *patch;
    measure f;
    double sign;
} slope;

static double height(void *user, double v) {
    const slope *s = user;
    kg_ruling r = kg_patch_ruling(s->patch, v);
    return -s->sign * s->f(&r);
}

/* The largest (sign 1) or smallest (-1) value of f in [lo, hi], where it has one. v to 1e-7 of the
 * bracket puts a smooth extreme right to 1e-14. */
static double climb(const kg_patch *p, measure f, double sign, double lo, double hi,
                    double *out_v) {
    slope s = {p, f, sign};
    return -sign * kg_minimum(height, &s, lo, hi, fmax(1e-7 * (hi - lo), 4e-16 * hi), out_v);
}

/* ---- samples ---------------------------------------------------------------------------- */

/* Even samples miss what happens beside a near-inflection or near-cusp, as narrow as the place is
 * sharp. So such places are samples too, and more are put in between while φ = ln tan(θ/2) moves
 * by more than this from one to the next: the edge of regression is at 1/u = φ'/|p'|. */
#define MOST_TURN 0.4
enum { MAX_SAMPLES = 512, MAX_PLACES = 8, MAX_DEPTH = 24 };

/* |p'| or |p'×p''|/|p'| with a minimum below this share of its largest value is such a place; above
 * it the even samples see enough. */
#define SHARP 0.2

typedef struct samples {
    kg_ruling rulings[MAX_SAMPLES];
    double phi[MAX_SAMPLES];
    int count;
} samples;

static void add_sharp_places(const kg_patch *p, measure f, const kg_ruling *even, double *places,
                             int *count) {
    enum { N = KG_PATCH_SCAN };
    double value[N + 1], largest = 0;
    for (int i = 0; i <= N; i++) {
        value[i] = f(&even[i]);
        largest = fmax(largest, value[i]);
    }
    for (int i = 0; i <= N && *count < MAX_PLACES; i++) {
        if (!(value[i] < SHARP * largest) || (i > 0 && value[i - 1] < value[i]) ||
            (i < N && value[i + 1] < value[i]))
            continue;
        double lo = fmax(0, (i - 1.0) / N), hi = fmin(1, (i + 1.0) / N);
        climb(p, f, -1, lo, hi, &places[(*count)++]);
    }
}

/* φ = ln tan(θ/2) = -asinh(cot θ) */
static double phi(const kg_ruling *r) {
    return -asinh(r->cos_theta / r->sin_theta);
}

/* Appends what lies between the last sample and `end`, and `end`. */
static void fill(const kg_patch *p, const kg_ruling *end, double end_phi, int depth, samples *s) {
    int last = s->count - 1;
    /* room is kept for the ends of the cells still to come */
    if (fabs(end_phi - s->phi[last]) > MOST_TURN && depth < MAX_DEPTH &&
        s->count < MAX_SAMPLES - KG_PATCH_SCAN - MAX_PLACES - MAX_DEPTH - 2) {
        kg_ruling middle = kg_patch_ruling(p, 0.5 * (s->rulings[last].v + end->v));
        fill(p, &middle, phi(&middle), depth + 1, s);
        fill(p, end, end_phi, depth + 1, s);
        return;
    }
    s->rulings[s->count] = *end;
    s->phi[s->count++] = end_phi;
}

static void sample(const kg_patch *p, samples *s) {
    enum { N = KG_PATCH_SCAN };
    kg_ruling even[N + 1];
    for (int i = 0; i <= N; i++)
        even[i] = kg_patch_ruling(p, (double)i / N);
    double places[MAX_PLACES + 1];
    int count = 0;
    add_sharp_places(p, bend, even, places, &count);
    add_sharp_places(p, speed, even, places, &count);
    for (int i = 1; i < count; i++) /* insertion sort of a handful */
        for (int k = i; k > 0 && places[k - 1] > places[k]; k--) {
            double swap = places[k];
            places[k] = places[k - 1], places[k - 1] = swap;
        }
    s->rulings[0] = even[0];
    s->phi[0] = phi(&even[0]);
    s->count = 1;
    for (int i = 1, k = 0; i <= N; i++) {
        for (; k < count && places[k] < even[i].v; k++)
            if (places[k] > even[i - 1].v) {
                kg_ruling place = kg_patch_ruling(p, places[k]);
                fill(p, &place, phi(&place), 0, s);
            }
        fill(p, &even[i], phi(&even[i]), 0, s);
    }
}

/* The smallest and the largest value of f over v: samples, refined at every peak that may be the
 * highest. A peak between samples tops its highest one by less than this factor. */
#define PEAK 3

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
        double high = sign * values[best], close = high > 0 ? high / PEAK : high * PEAK;
        for (int i = 0; i < s->count; i++) {
            int before = i > 0 ? i - 1 : i, after = i + 1 < s->count ? i + 1 : i;
            if (sign * values[i] < close || sign * values[before] > sign * values[i] ||
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
        p->theta[0] = p->theta[1] = KG_PI / 2;
        return KG_OK;
    }
    samples s;
    sample(p, &s);
    double value[2], v[2];
    /* NaN where p' × p'' vanishes */
    for (int i = 0; i < s.count; i++) {
        double t = theta(&s.rulings[i]);
        if (!(t >= LEAST_THETA && t <= KG_PI - LEAST_THETA))
            return kg_fail(error, KG_ERR_INPUT,
                           "the ruling runs along the geodesic at v = %.4g, a twisted inflection; "
                           "flatten the geodesic into a plane or bend it one way only",
                           s.rulings[i].v);
    }
    extremes(p, &s, theta, p->theta, v);
    p->flattest_v = p->theta[0] < KG_PI - p->theta[1] ? v[0] : v[1];
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
    double upright = fmin(fmax(KG_PI / 2, patch->theta[0]), patch->theta[1]);
    double width = (patch->extent[1] - patch->extent[0]) * sin(upright);
    if ((patch->clamped || sin(upright) < 0.5) &&
        width < LEAST_WIDTH * kg_curve_size(&patch->geodesic))
        return kg_fail(error, KG_ERR_INPUT,
                       "the paper folds back on itself right beside the geodesic, at v = %.4g (it "
                       "would be %.2g mm wide); flatten the geodesic into a plane or bend it "
                       "one way only",
                       patch->flattest_v, width);
    return KG_OK;
}
