#include "katagami/curve.h"

#include "curve/bernstein.h"
#include "curve/quadrature.h"

#include <assert.h>

/* |p'| below this fraction of its largest value counts as a stationary point: the tangent there
 * would have lost half of its digits. */
#define STATIONARY 1e-7

static double speed(const void *data, double v) {
    kg_vec3 d[2];
    kg_curve_derivatives(data, v, 1, d);
    return kg_len(d[1]);
}

/* The smallest |p'| on [0,1] and where: samples, then golden section around the best. */
static double slowest(const kg_curve *curve, double *out_v) {
    enum { N = 64 };
    double best = INFINITY, at = 0;
    for (int i = 0; i <= N; i++) {
        double s = speed(curve, (double)i / N);
        if (s < best) {
            best = s;
            at = (double)i / N;
        }
    }
    const double golden = 0.61803398874989485;
    double lo = fmax(0, at - 1.0 / N), hi = fmin(1, at + 1.0 / N);
    double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    double fa = speed(curve, a), fb = speed(curve, b);
    while (hi - lo > 1e-12) {
        if (fa < fb) {
            hi = b, b = a, fb = fa;
            a = hi - golden * (hi - lo), fa = speed(curve, a);
        } else {
            lo = a, a = b, fa = fb;
            b = lo + golden * (hi - lo), fb = speed(curve, b);
        }
    }
    double s = speed(curve, 0.5 * (lo + hi));
    if (s < best) {
        best = s;
        at = 0.5 * (lo + hi);
    }
    *out_v = at;
    return best;
}

kg_status kg_curve_init(const kg_vec3 *points, size_t count, kg_curve *out_curve,
                        kg_error *error) {
    if (count != 4 && count != 6)
        return kg_fail(error, KG_ERR_INPUT,
                       "a geodesic has 4 or 6 control points, not %zu; give one of these", count);
    kg_curve c = {.degree = (int)count - 1};
    double fastest = 0;
    for (size_t i = 0; i < count; i++) {
        kg_vec3 p = points[i];
        if (!(fabs(p.x) <= KG_MAX_COORDINATE && fabs(p.y) <= KG_MAX_COORDINATE &&
              fabs(p.z) <= KG_MAX_COORDINATE))
            return kg_fail(error, KG_ERR_INPUT,
                           "control point %zu (%g, %g, %g) is beyond 1e6 mm; bring it nearer to "
                           "the origin",
                           i + 1, p.x, p.y, p.z);
        c.points[i] = p;
        if (i > 0)
            fastest = fmax(fastest, c.degree * kg_dist(p, points[i - 1]));
    }
    double v;
    if (slowest(&c, &v) <= STATIONARY * fastest)
        return kg_fail(error, KG_ERR_INPUT,
                       "the geodesic stands still at v = %.4g (control points coincide or the "
                       "curve has a cusp); move the control points apart",
                       v);
    *out_curve = c;
    return KG_OK;
}

kg_vec3 kg_curve_point(const kg_curve *curve, double v) {
    kg_vec3 p;
    kg_curve_derivatives(curve, v, 0, &p);
    return p;
}

void kg_curve_derivatives(const kg_curve *curve, double v, int order, kg_vec3 *out) {
    assert(order >= 0 && order <= 4);
    kg_vec3 q[KG_CURVE_MAX_POINTS];
    int n = curve->degree;
    double factor = 1;
    for (int i = 0; i <= n; i++)
        q[i] = curve->points[i];
    for (int k = 0; k <= order; k++) {
        /* q: the k-th differences; their Bézier value times n!/(n-k)! is the derivative */
        if (k > n) {
            out[k] = kg_v3(0, 0, 0);
            continue;
        }
        kg_vec3 r[KG_CURVE_MAX_POINTS];
        for (int i = 0; i <= n - k; i++)
            r[i] = q[i];
        for (int j = 1; j <= n - k; j++)
            for (int i = 0; i <= n - k - j; i++)
                r[i] = kg_lerp(r[i], r[i + 1], v);
        out[k] = kg_scale(r[0], factor);
        factor *= n - k;
        for (int i = 0; i < n - k; i++)
            q[i] = kg_sub(q[i + 1], q[i]);
    }
}

kg_curve kg_curve_segment(const kg_curve *curve, double v0, double v1) {
    assert(v0 < v1);
    kg_curve r = *curve;
    kg_bernstein_restrict3(r.points, r.degree, v0, v1);
    return r;
}

double kg_curve_length(const kg_curve *curve, double v0, double v1) {
    return kg_integrate(speed, curve, v0, v1, 1e-14);
}

double kg_curve_at_length(const kg_curve *curve, double length) {
    double total = kg_curve_length(curve, 0, 1);
    if (length <= 0)
        return 0;
    if (length >= total)
        return 1;
    /* Newton steps kept inside a shrinking bracket. */
    double lo = 0, hi = 1, v = length / total, at = kg_curve_length(curve, 0, v);
    for (int i = 0; i < 60 && fabs(at - length) > 1e-15 * total; i++) {
        if (at < length)
            lo = v;
        else
            hi = v;
        double next = v - (at - length) / speed(curve, v);
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        if (next == v)
            break;
        at += kg_curve_length(curve, v, next);
        v = next;
    }
    return v;
}

kg_frenet kg_curve_frenet(const kg_curve *curve, double v) {
    kg_vec3 d[4];
    kg_curve_derivatives(curve, v, 3, d);
    kg_vec3 c = kg_cross(d[1], d[2]);
    double c2 = kg_dot(c, c), s = kg_len(d[1]);
    kg_frenet f = {.tangent = kg_unit(d[1])};
    if (c2 > 0) {
        f.binormal = kg_unit(c);
        f.normal = kg_cross(f.binormal, f.tangent);
        f.curvature = sqrt(c2) / (s * s * s);
        f.torsion = kg_dot(c, d[3]) / c2;
    }
    return f;
}

double kg_curve_size(const kg_curve *curve) {
    double size = 0;
    for (int i = 0; i <= curve->degree; i++)
        for (int j = 0; j < i; j++)
            size = fmax(size, kg_dist(curve->points[i], curve->points[j]));
    return size;
}

kg_curve_shape kg_curve_classify(const kg_curve *curve) {
    /* The longest chord of the control polygon, then the point farthest from that line, then the
     * one farthest from that plane: twice their distance bounds the flatness either way. */
    int n = curve->degree, a = 0, b = 1;
    const kg_vec3 *p = curve->points;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < i; j++)
            if (kg_dist(p[i], p[j]) > kg_dist(p[a], p[b]))
                a = j, b = i;
    double size = kg_dist(p[a], p[b]);
    kg_vec3 along = kg_unit(kg_sub(p[b], p[a])), normal = kg_v3(0, 0, 0);
    for (int i = 0; i <= n; i++) {
        kg_vec3 c = kg_cross(along, kg_sub(p[i], p[a]));
        if (kg_len(c) > kg_len(normal))
            normal = c;
    }
    if (kg_len(normal) <= KG_FLATNESS * size)
        return KG_CURVE_STRAIGHT;
    normal = kg_unit(normal);
    for (int i = 0; i <= n; i++)
        if (fabs(kg_dot(normal, kg_sub(p[i], p[a]))) > KG_FLATNESS * size)
            return KG_CURVE_SPATIAL;
    return KG_CURVE_PLANAR;
}

int kg_curve_darboux(const kg_curve *curve, kg_vec3 *out) {
    /* With p' as the binary form P(s,t) of degree m and coefficients a[i]:
     *     p' × p''          = m (A × B),  A, B = forms of a[i] and a[i+1], degree m - 1
     *     det(p',p'',p''')  = m² (m-1) det of the forms of a[i], a[i+1], a[i+2], degree m - 2
     * (Euler's relation), so that no degree has to be taken out again afterwards. */
    int m = curve->degree - 1;
    kg_vec3 a[KG_CURVE_MAX_POINTS];
    for (int i = 0; i <= m; i++)
        a[i] = kg_scale(kg_sub(curve->points[i + 1], curve->points[i]), curve->degree);

    kg_vec3 c[7], inner[5];
    int nc = 2 * m - 2;
    kg_bernstein_cross(a, m - 1, a + 1, m - 1, c);
    for (int i = 0; i <= nc; i++)
        c[i] = kg_scale(c[i], m);
    double delta[7];
    int nd = 3 * (m - 2);
    kg_bernstein_cross(a + 1, m - 2, a + 2, m - 2, inner);
    kg_bernstein_dot(a, m - 2, inner, 2 * (m - 2), delta);
    for (int i = 0; i <= nd; i++)
        delta[i] *= m * m * (m - 1);

    double speed2[9], twist[15], cross2[13];
    kg_vec3 bend[KG_DARBOUX_MAX_COUNT];
    int degree = 3 * nc;
    kg_bernstein_dot(a, m, a, m, speed2);
    kg_bernstein_mul(speed2, 2 * m, delta, nd, twist);
    kg_bernstein_mul3(twist, 2 * m + nd, a, m, out);
    kg_bernstein_dot(c, nc, c, nc, cross2);
    kg_bernstein_mul3(cross2, 2 * nc, c, nc, bend);
    assert(degree == 2 * m + nd + m);
    for (int i = 0; i <= degree; i++)
        out[i] = kg_add(out[i], bend[i]);
    return degree;
}
