#include "katagami/curve.h"

#include "curve/bernstein.h"

#include <assert.h>

/* |p'| below this fraction of its largest value counts as a stationary point: the tangent there
 * would have lost half of its digits. */
#define STATIONARY 1e-7

/* Halvings of [0,1] at most while a stationary point is looked for. */
enum { MAX_DEPTH = 40 };

/* Whether |p'| > `least` on the piece [lo, hi] of the curve with the control legs `legs` (n of
 * them): the legs are Bézier coefficients of p', so it holds where all reach farther than that in
 * one direction. Else `*out_v` is where not. */
static bool moves(const kg_vec3 *legs, int n, double least, double lo, double hi, int depth,
                  double *out_v) {
    /* de Casteljau at the middle, in place, leaves the right half */
    kg_vec3 left[KG_CURVE_MAX_POINTS], right[KG_CURVE_MAX_POINTS];
    for (int i = 0; i < n; i++)
        right[i] = legs[i];
    for (int k = 1; k <= n; k++) {
        left[k - 1] = right[0];
        for (int i = 0; i < n - k; i++)
            right[i] = kg_scale(kg_add(right[i], right[i + 1]), 0.5);
    }
    double v = 0.5 * (lo + hi), speed = kg_len(right[0]), reach = INFINITY;
    for (int i = 0; i < n; i++)
        reach = fmin(reach, kg_dot(legs[i], right[0]));
    if (reach > least * speed)
        return true;
    bool start = kg_len(legs[0]) <= least, end = kg_len(legs[n - 1]) <= least;
    *out_v = start ? lo : end ? hi : v;
    if (start || end || speed <= least || depth == MAX_DEPTH)
        return false;
    return moves(left, n, least, lo, v, depth + 1, out_v) &&
           moves(right, n, least, v, hi, depth + 1, out_v);
}

kg_status kg_curve_init(const kg_vec3 *points, size_t count, kg_curve *out_curve, kg_error *error) {
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
    kg_vec3 legs[KG_CURVE_MAX_POINTS];
    for (int i = 0; i < c.degree; i++)
        legs[i] = kg_scale(kg_sub(c.points[i + 1], c.points[i]), c.degree);
    double v;
    if (!moves(legs, c.degree, STATIONARY * fastest, 0, 1, 0, &v))
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

/* Value of a Bézier form of degree n <= 5: powers of v and 1-v build up in one pass, no term
 * negative. */
static inline kg_vec3 value(const kg_vec3 *a, int n, double v) {
    static const double binomial[KG_CURVE_MAX_POINTS][KG_CURVE_MAX_POINTS] = {
        {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1},
    };
    double s = 1 - v, w = 1;
    kg_vec3 r = a[0];
    for (int i = 1; i <= n; i++) {
        w *= v;
        r = kg_madd(kg_scale(r, s), w * binomial[n][i], a[i]);
    }
    return r;
}

/* n is a constant where this is called, so that the loops unroll. */
static inline void derivatives(const kg_vec3 *points, int n, double v, int order, kg_vec3 *out) {
    kg_vec3 q[KG_CURVE_MAX_POINTS]; /* k-th differences, times n!/(n-k)! coefficients of p^(k) */
    for (int i = 0; i <= n; i++)
        q[i] = points[i];
    out[0] = value(q, n, v);
    double factor = 1;
    for (int k = 1; k <= n; k++) {
        if (k > order)
            return;
        factor *= n - k + 1;
        for (int i = 0; i <= n - k; i++)
            q[i] = kg_sub(q[i + 1], q[i]);
        out[k] = kg_scale(value(q, n - k, v), factor);
    }
    for (int k = n + 1; k <= order; k++)
        out[k] = kg_v3(0, 0, 0);
}

void kg_curve_derivatives(const kg_curve *curve, double v, int order, kg_vec3 *out) {
    assert(order >= 0 && order < KG_CURVE_MAX_POINTS);
    if (curve->degree == 3)
        derivatives(curve->points, 3, v, order, out);
    else
        derivatives(curve->points, 5, v, order, out);
}

kg_curve kg_curve_segment(const kg_curve *curve, double v0, double v1) {
    assert(v0 < v1);
    kg_curve r = *curve;
    kg_bernstein_restrict3(r.points, r.degree, v0, v1);
    return r;
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
