#include "katagami/patch.h"

#include "curve/bernstein.h"
#include "curve/quadrature.h"

#include <assert.h>
#include <string.h>

/* Samples of v when extremes over a patch are looked for: a degree-18 polynomial has fewer wiggles
 * than this by far. */
enum { SCAN = 96 };

/* ---- rulings --------------------------------------------------------------------------- */

/* D of a quintic vanishes where p' × p'' does: an inflection. A removable one (geometry: D has a
 * triple root there) is divided out, so that R never vanishes; each root inside [0,1] turns the
 * direction by its sign. |D| below this fraction of its largest value is a root. */
#define DARBOUX_ZERO 1e-9

static int remove_inflections(kg_vec3 *rulings, int degree) {
    for (int guard = 0; guard < 3; guard++) {
        double largest = 0, least = INFINITY, at = 0;
        for (int i = 0; i <= SCAN; i++) {
            double v = (double)i / SCAN, d = kg_len(kg_bernstein_eval3(rulings, degree, v));
            largest = fmax(largest, d);
            if (d < least)
                least = d, at = v;
        }
        double lo = fmax(0, at - 1.0 / SCAN), hi = fmin(1, at + 1.0 / SCAN);
        for (int i = 0; i < 100; i++) {
            double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
            if (kg_len(kg_bernstein_eval3(rulings, degree, a)) <
                kg_len(kg_bernstein_eval3(rulings, degree, b)))
                hi = b;
            else
                lo = a;
        }
        at = 0.5 * (lo + hi);
        if (degree < 4 ||
            kg_len(kg_bernstein_eval3(rulings, degree, at)) > DARBOUX_ZERO * largest)
            return degree;
        for (int k = 0; k < 3; k++, degree--)
            kg_bernstein_deflate3(rulings, degree, at, rulings);
        if (at > 0)
            for (int i = 0; i <= degree; i++)
                rulings[i] = kg_neg(rulings[i]);
    }
    return degree;
}

/* The plane's normal with the sign of p' × p'' where the curve starts to bend. */
static kg_vec3 planar_ruling(const kg_curve *c) {
    kg_vec3 largest = kg_v3(0, 0, 0);
    for (int i = 0; i <= c->degree; i++)
        for (int j = 0; j < i; j++) {
            kg_vec3 n = kg_cross(kg_sub(c->points[j], c->points[0]),
                                 kg_sub(c->points[i], c->points[0]));
            if (kg_len(n) > kg_len(largest))
                largest = n;
        }
    for (int i = 0; i <= SCAN; i++) {
        kg_vec3 d[3];
        kg_curve_derivatives(c, (double)i / SCAN, 2, d);
        double bend = kg_dot(kg_cross(d[1], d[2]), largest);
        if (fabs(bend) > KG_FLATNESS * kg_dot(d[1], d[1]) * kg_len(largest))
            return kg_scale(kg_unit(largest), bend < 0 ? -1 : 1);
    }
    return kg_unit(largest);
}

static kg_status straight_ruling(const kg_patch_input *in, kg_vec3 along, kg_vec3 *out,
                                 kg_error *error) {
    /* sin of the angle below which a wish does not tell a direction */
    const double parallel = 1e-6;
    if (in->has_ruling) {
        kg_vec3 r = in->ruling;
        bool finite = isfinite(r.x) && isfinite(r.y) && isfinite(r.z);
        r = kg_unit(r);
        kg_vec3 across = kg_madd(r, -kg_dot(r, along), along);
        if (!finite || kg_len(across) < parallel)
            return kg_fail(error, KG_ERR_INPUT,
                           "the ruling (%g, %g, %g) is parallel to the straight geodesic or not a "
                           "direction; give one across it",
                           in->ruling.x, in->ruling.y, in->ruling.z);
        *out = kg_unit(across);
        return KG_OK;
    }
    kg_vec3 up = kg_v3(0, 0, 1);
    kg_vec3 across = kg_madd(up, -kg_dot(up, along), along);
    if (kg_len(across) < parallel) {
        up = kg_v3(1, 0, 0);
        across = kg_madd(up, -kg_dot(up, along), along);
    }
    *out = kg_unit(across);
    return KG_OK;
}

static kg_status init_rulings(const kg_patch_input *in, kg_patch *p, kg_error *error) {
    const kg_curve *c = &p->geodesic;
    p->ruling_degree = 0;
    if (p->shape == KG_CURVE_STRAIGHT) {
        kg_vec3 along = kg_unit(kg_sub(c->points[c->degree], c->points[0]));
        return straight_ruling(in, along, &p->rulings[0], error);
    }
    if (p->shape == KG_CURVE_PLANAR) {
        p->rulings[0] = planar_ruling(c);
        return KG_OK;
    }
    int n = kg_curve_darboux(c, p->rulings);
    n = remove_inflections(p->rulings, n);
    double largest = 0;
    for (int i = 0; i <= n; i++)
        largest = fmax(largest, kg_len(p->rulings[i]));
    for (int i = 0; i <= n; i++)
        p->rulings[i] = kg_scale(p->rulings[i], 1 / largest);
    p->ruling_degree = n;
    return KG_OK;
}

kg_ruling kg_patch_ruling(const kg_patch *patch, double v) {
    kg_ruling r = {.v = v};
    kg_vec3 c[3];
    kg_curve_derivatives(&patch->geodesic, v, 2, c);
    r.p = c[0], r.dp = c[1], r.ddp = c[2];
    r.speed = kg_len(r.dp);
    int n = patch->ruling_degree;
    if (n == 0) {
        r.d = patch->rulings[0];
    } else {
        /* the two halves of the last de Casteljau step give value and derivative together */
        kg_vec3 a = kg_bernstein_eval3(patch->rulings, n - 1, v);
        kg_vec3 b = kg_bernstein_eval3(patch->rulings + 1, n - 1, v);
        kg_vec3 value = kg_lerp(a, b, v), slope = kg_scale(kg_sub(b, a), n);
        double inverse = 1 / kg_len(value);
        r.d = kg_scale(value, inverse);
        r.dd = kg_scale(kg_madd(slope, -kg_dot(slope, r.d), r.d), inverse);
    }
    kg_vec3 across = kg_cross(r.dp, r.d);
    double cross = kg_len(across);
    r.sin_theta = cross / r.speed;
    r.cos_theta = kg_dot(r.dp, r.d) / r.speed;
    r.normal = kg_scale(across, (patch->flip ? -1 : 1) / cross);
    /* (p'·d)' = p''·d + p'·d' and (cos θ)' = -sin θ θ' */
    double dspeed = kg_dot(r.dp, r.ddp) / r.speed;
    double dcos =
        (kg_dot(r.ddp, r.d) + kg_dot(r.dp, r.dd) - r.cos_theta * dspeed) / r.speed;
    r.dtheta = -dcos / r.sin_theta;
    return r;
}

kg_vec3 kg_patch_point(const kg_patch *patch, double u, double v) {
    kg_vec3 p = kg_curve_point(&patch->geodesic, v);
    kg_vec3 d = patch->ruling_degree == 0
                    ? patch->rulings[0]
                    : kg_unit(kg_bernstein_eval3(patch->rulings, patch->ruling_degree, v));
    return kg_madd(p, u, d);
}

kg_vec3 kg_patch_derivatives(const kg_patch *patch, double u, double v, kg_vec3 *out_du,
                             kg_vec3 *out_dv) {
    kg_ruling r = kg_patch_ruling(patch, v);
    *out_du = r.d;
    *out_dv = kg_madd(r.dp, u, r.dd);
    return kg_madd(r.p, u, r.d);
}

kg_vec3 kg_patch_normal(const kg_patch *patch, double v) {
    return kg_patch_ruling(patch, v).normal;
}

/* ---- edge of regression ---------------------------------------------------------------- */

/* The signed u of the edge of regression on a ruling: -b/c. */
static double regression_u(const kg_ruling *r) {
    kg_vec3 w = kg_sub(r->dp, kg_scale(r->d, kg_dot(r->dp, r->d)));
    double b = kg_len(w);
    double c = kg_dot(r->dd, w) / b;
    return c == 0 ? INFINITY : -b / c;
}

void kg_patch_regression(const kg_patch *patch, double v, double *out_lo, double *out_hi) {
    kg_ruling r = kg_patch_ruling(patch, v);
    double u = regression_u(&r);
    *out_lo = u < 0 ? u : -INFINITY;
    *out_hi = u > 0 ? u : INFINITY;
}

/* 1/u of the edge of regression is smooth where u runs through infinity: its largest and smallest
 * values bound the extent. */
static double inverse_regression(const kg_patch *p, double v) {
    kg_ruling r = kg_patch_ruling(p, v);
    return 1 / regression_u(&r);
}

/* The largest value of sign * f on [lo, hi] by ternary search around the best sample. */
static double climb(const kg_patch *p, double (*f)(const kg_patch *, double), double sign, double lo,
                    double hi, double *out_v) {
    while (hi - lo > 1e-10) {
        double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (sign * f(p, a) < sign * f(p, b))
            lo = a;
        else
            hi = b;
    }
    *out_v = 0.5 * (lo + hi);
    return f(p, *out_v);
}

static double theta_of(const kg_patch *p, double v) {
    kg_ruling r = kg_patch_ruling(p, v);
    return atan2(r.sin_theta, r.cos_theta);
}

/* Smallest and largest value of f over v, refined between samples. */
static void extremes(const kg_patch *p, double (*f)(const kg_patch *, double), double *out_value,
                     double *out_v) {
    double values[SCAN + 1];
    int best[2] = {0, 0};
    for (int i = 0; i <= SCAN; i++) {
        values[i] = f(p, (double)i / SCAN);
        if (values[i] < values[best[0]])
            best[0] = i;
        if (values[i] > values[best[1]])
            best[1] = i;
    }
    for (int k = 0; k < 2; k++) {
        int i = best[k];
        out_value[k] = values[i];
        out_v[k] = (double)i / SCAN;
        double v, lo = fmax(0, (i - 1.0) / SCAN), hi = fmin(1, (i + 1.0) / SCAN);
        double refined = climb(p, f, k ? 1 : -1, lo, hi, &v);
        if (k ? refined > out_value[k] : refined < out_value[k]) {
            out_value[k] = refined;
            out_v[k] = v;
        }
    }
}

static kg_status init_extent(const kg_patch_input *in, kg_patch *p, kg_error *error) {
    double lo = in->extent[0], hi = in->extent[1];
    if (!(isfinite(lo) && isfinite(hi) && lo < hi && lo >= -KG_MAX_COORDINATE &&
          hi <= KG_MAX_COORDINATE))
        return kg_fail(error, KG_ERR_INPUT,
                       "the extent [%g, %g] is not an interval; give two numbers, the smaller "
                       "first",
                       lo, hi);
    p->regression[0] = -INFINITY, p->regression[1] = INFINITY;
    p->regression_v[0] = p->regression_v[1] = NAN;
    p->theta[0] = p->theta[1] = acos(0);
    p->flattest_v = 0;
    if (p->shape == KG_CURVE_SPATIAL) {
        double value[2], v[2];
        extremes(p, inverse_regression, value, v);
        for (int k = 0; k < 2; k++)
            if (k ? value[k] > 0 : value[k] < 0) {
                p->regression[k] = 1 / value[k];
                p->regression_v[k] = v[k];
            }
        extremes(p, theta_of, p->theta, v);
        p->flattest_v = p->theta[0] < acos(-1.0) - p->theta[1] ? v[0] : v[1];
    }
    p->wished_extent[0] = lo, p->wished_extent[1] = hi;
    p->extent[0] = fmax(lo, KG_REGRESSION_LIMIT * p->regression[0]);
    p->extent[1] = fmin(hi, KG_REGRESSION_LIMIT * p->regression[1]);
    p->clamped = p->extent[0] != lo || p->extent[1] != hi;
    if (!(p->extent[0] < p->extent[1]))
        return kg_fail(error, KG_ERR_INPUT,
                       "the extent [%g, %g] lies wholly beyond the edge of regression (allowed: "
                       "%g to %g); bring it nearer to the geodesic or bend the geodesic less",
                       lo, hi, KG_REGRESSION_LIMIT * p->regression[0],
                       KG_REGRESSION_LIMIT * p->regression[1]);
    return KG_OK;
}

/* ---- preparation ----------------------------------------------------------------------- */

static void init_lengths(kg_patch *p) {
    p->length_at[0] = 0;
    for (int i = 0; i < KG_PATCH_CELLS; i++)
        p->length_at[i + 1] =
            p->length_at[i] + kg_curve_length(&p->geodesic, (double)i / KG_PATCH_CELLS,
                                              (double)(i + 1) / KG_PATCH_CELLS);
}

/* A box around p + u d: p is in the hull of its control points, d among the unit vectors. */
static void init_box(kg_patch *p) {
    kg_box3 box = kg_box3_empty();
    const kg_curve *c = &p->geodesic;
    /* d lies in the convex cone of the coefficients of R: within `spread` of their mean. */
    kg_vec3 mean = kg_v3(0, 0, 0);
    for (int i = 0; i <= p->ruling_degree; i++)
        mean = kg_add(mean, kg_unit(p->rulings[i]));
    mean = kg_unit(mean);
    double spread = 0;
    for (int i = 0; i <= p->ruling_degree; i++)
        spread = fmax(spread, kg_dist(kg_unit(p->rulings[i]), mean));
    for (int i = 0; i <= c->degree; i++)
        for (int k = 0; k < 2; k++) {
            double u = p->extent[k], r = spread < 1 ? fabs(u) * spread : 0;
            kg_vec3 q = kg_madd(c->points[i], spread < 1 ? u : 0, mean);
            if (spread >= 1)
                r = fabs(u);
            kg_box3_add(&box, kg_sub(q, kg_v3(r, r, r)));
            kg_box3_add(&box, kg_add(q, kg_v3(r, r, r)));
        }
    p->box = box;
    p->size = kg_curve_size(c);
    kg_vec3 corner[4];
    for (int i = 0; i < 4; i++) {
        corner[i] = kg_patch_point(p, p->extent[i & 1], i >> 1);
        for (int j = 0; j < i; j++)
            p->size = fmax(p->size, kg_dist(corner[i], corner[j]));
    }
}

kg_status kg_patch_init(const kg_patch_input *input, kg_patch *out_patch, kg_error *error) {
    kg_patch p;
    memset(&p, 0, sizeof p);
    kg_status status = kg_curve_init(input->points, input->point_count, &p.geodesic, error);
    if (status)
        return status;
    p.shape = kg_curve_classify(&p.geodesic);
    p.flip = input->flip;
    if ((status = init_rulings(input, &p, error)) || (status = init_extent(input, &p, error)))
        return status;
    init_lengths(&p);
    init_box(&p);
    *out_patch = p;
    return KG_OK;
}

/* ---- unrolling ------------------------------------------------------------------------- */

static double speed_at(const kg_curve *c, double v) {
    kg_vec3 d[2];
    kg_curve_derivatives(c, v, 1, d);
    return kg_len(d[1]);
}

double kg_patch_length(const kg_patch *patch, double v) {
    /* From the nearer end of the cell; Gauss-Legendre of degree 31 on at most 1/64 of the curve
     * reaches rounding except next to a near-cusp, where the adaptive rule takes over. */
    double x = v * KG_PATCH_CELLS;
    int i = (int)fmin(fmax(floor(x + 0.5), 0), KG_PATCH_CELLS);
    double from = (double)i / KG_PATCH_CELLS;
    if (v == from)
        return patch->length_at[i];
    const kg_curve *c = &patch->geodesic;
    double slow = speed_at(c, from), fast = speed_at(c, v);
    if (fmin(slow, fast) < 0.25 * fmax(slow, fast))
        return patch->length_at[i] + kg_curve_length(c, from, v);
    double sum = 0;
    for (int k = 0; k < KG_GAUSS_COUNT; k++)
        sum += kg_gauss_weight[k] * speed_at(c, from + (v - from) * kg_gauss_node[k]);
    return patch->length_at[i] + sum * (v - from);
}

kg_vec2 kg_patch_unroll(const kg_patch *patch, double u, double v) {
    kg_ruling r = kg_patch_ruling(patch, v);
    return kg_v2(u * r.sin_theta, u * r.cos_theta + kg_patch_length(patch, v));
}

kg_vec2 kg_patch_unroll_derivatives(const kg_patch *patch, double u, double v, kg_vec2 *out_du,
                                    kg_vec2 *out_dv) {
    kg_ruling r = kg_patch_ruling(patch, v);
    *out_du = kg_v2(r.sin_theta, r.cos_theta);
    *out_dv = kg_v2(u * r.cos_theta * r.dtheta, r.speed - u * r.sin_theta * r.dtheta);
    return kg_v2(u * r.sin_theta, u * r.cos_theta + kg_patch_length(patch, v));
}

/* ---- closest point --------------------------------------------------------------------- */

/* Squared distance from `point` to the ruling segment at v. */
static double ruling_distance2(const kg_patch *patch, kg_vec3 point, double v, double *out_u) {
    kg_vec3 p = kg_curve_point(&patch->geodesic, v);
    kg_vec3 d = kg_sub(kg_patch_point(patch, 1, v), p);
    double u = fmin(fmax(kg_dot(kg_sub(point, p), d), patch->extent[0]), patch->extent[1]);
    kg_vec3 gap = kg_sub(kg_madd(p, u, d), point);
    *out_u = u;
    return kg_dot(gap, gap);
}

double kg_patch_closest(const kg_patch *patch, kg_vec3 point, double *out_u, double *out_v) {
    double d2[SCAN + 1], u;
    double best = INFINITY;
    for (int i = 0; i <= SCAN; i++)
        d2[i] = ruling_distance2(patch, point, (double)i / SCAN, &u);
    for (int i = 0; i <= SCAN; i++) {
        if ((i > 0 && d2[i - 1] < d2[i]) || (i < SCAN && d2[i + 1] < d2[i]))
            continue;
        const double golden = 0.61803398874989485;
        double lo = fmax(0, (i - 1.0) / SCAN), hi = fmin(1, (i + 1.0) / SCAN);
        double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo), unused;
        double fa = ruling_distance2(patch, point, a, &unused);
        double fb = ruling_distance2(patch, point, b, &unused);
        while (hi - lo > 1e-9) {
            if (fa < fb) {
                hi = b, b = a, fb = fa, a = hi - golden * (hi - lo);
                fa = ruling_distance2(patch, point, a, &unused);
            } else {
                lo = a, a = b, fa = fb, b = lo + golden * (hi - lo);
                fb = ruling_distance2(patch, point, b, &unused);
            }
        }
        /* the ends of the bracket are candidates too: minima at v = 0 and 1 */
        double candidates[4] = {0.5 * (lo + hi), (double)i / SCAN, lo, hi};
        for (int k = 0; k < 4; k++) {
            double f = ruling_distance2(patch, point, candidates[k], &u);
            if (f < best) {
                best = f;
                *out_u = u;
                *out_v = candidates[k];
            }
        }
    }
    return sqrt(best);
}
