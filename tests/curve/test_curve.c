#include "curve/bernstein.h"
#include "katagami/curve.h"
#include "tests/check.h"

static kg_curve random_curve(kg_random *r, double size) {
    kg_curve c;
    do {
        kg_vec3 p[6];
        size_t count = kg_random_bits(r) & 1 ? 4 : 6;
        for (size_t i = 0; i < count; i++)
            p[i] = kg_v3(kg_random_in(r, -size, size), kg_random_in(r, -size, size),
                         kg_random_in(r, -size, size));
        if (kg_curve_init(p, count, &c, NULL) == KG_OK)
            return c;
    } while (true);
}

static void assert_near3(kg_vec3 a, kg_vec3 b, double tolerance) {
    assert_near(a.x, b.x, tolerance);
    assert_near(a.y, b.y, tolerance);
    assert_near(a.z, b.z, tolerance);
}

static void derivatives_agree_with_the_power_basis(void **state) {
    (void)state;
    kg_random r = {1};
    for (int round = 0; round < 500; round++) {
        kg_curve c = random_curve(&r, 10);
        /* p = sum of C(n,k) Δ^k p0 v^k */
        kg_vec3 power[6], d[6];
        memcpy(power, c.points, sizeof power);
        for (int k = 1; k <= c.degree; k++)
            for (int i = c.degree; i >= k; i--)
                power[i] = kg_sub(power[i], power[i - 1]);
        double v = round % 7 == 0 ? round % 2 : kg_random_in(&r, 0, 1);
        kg_curve_derivatives(&c, v, 5, d);
        for (int order = 0; order <= 5; order++) {
            kg_vec3 sum = kg_v3(0, 0, 0);
            for (int k = order; k <= c.degree; k++) {
                double f = kg_binomial(c.degree, k) * pow(v, k - order);
                for (int i = 0; i < order; i++)
                    f *= k - i;
                sum = kg_madd(sum, f, power[k]);
            }
            assert_near3(d[order], sum, 1e-10); /* derivatives up to 120 · 32 · 10 */
        }
        assert_near3(kg_curve_point(&c, v), d[0], 0);
    }
}

static void each_derivative_is_the_difference_quotient_of_the_one_before(void **state) {
    (void)state;
    kg_random r = {2};
    const double step = 1e-5; /* error step² times two orders up: 1e-10 · 1e5 */
    for (int round = 0; round < 200; round++) {
        kg_curve c = random_curve(&r, 10);
        double v = kg_random_in(&r, step, 1 - step);
        kg_vec3 a[6], b[6], d[6];
        kg_curve_derivatives(&c, v - step, 5, a);
        kg_curve_derivatives(&c, v, 5, d);
        kg_curve_derivatives(&c, v + step, 5, b);
        for (int k = 0; k < 5; k++)
            assert_near3(kg_scale(kg_sub(b[k], a[k]), 0.5 / step), d[k + 1], 1e-4);
    }
}

static void a_segment_is_the_same_curve(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 500; round++) {
        kg_curve c = random_curve(&r, 10);
        double v0 = kg_random_in(&r, 0, 0.95), v1 = kg_random_in(&r, v0 + 0.01, 1);
        kg_curve part = kg_curve_segment(&c, v0, v1);
        double t = kg_random_in(&r, 0, 1);
        kg_vec3 a[2], b[2];
        kg_curve_derivatives(&part, t, 1, a);
        kg_curve_derivatives(&c, v0 + t * (v1 - v0), 1, b);
        assert_near3(a[0], b[0], 1e-13);
        assert_near3(a[1], kg_scale(b[1], v1 - v0), 1e-12);
    }
    kg_curve c = random_curve(&r, 10), whole = kg_curve_segment(&c, 0, 1);
    for (int i = 0; i <= c.degree; i++)
        assert_near3(whole.points[i], c.points[i], 0);
}

/* A degree-elevated arc of the helix does not exist; a twisted cubic (t, t², t³) has known
 * κ = 2 sqrt(9t⁴+9t²+1) / (9t⁴+4t²+1)^1.5 and τ = 3 / (9t⁴+9t²+1). */
static void the_twisted_cubic_has_its_known_curvature_and_torsion(void **state) {
    (void)state;
    const kg_vec3 p[4] = {{0, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 1.0 / 3, 0}, {1, 1, 1}};
    kg_curve c;
    assert_int_equal(kg_curve_init(p, 4, &c, NULL), KG_OK);
    assert_int_equal(kg_curve_classify(&c), KG_CURVE_SPATIAL);
    for (int i = 0; i <= 20; i++) {
        double t = i / 20.0, a = 9 * t * t * t * t + 9 * t * t + 1;
        double b = 9 * t * t * t * t + 4 * t * t + 1;
        kg_frenet f = kg_curve_frenet(&c, t);
        assert_near(f.curvature, 2 * sqrt(a) / (b * sqrt(b)), 1e-13);
        assert_near(f.torsion, 3 / a, 1e-13);
    }
}

static void frenet_frames_are_right_handed_and_turn_as_the_formulas_say(void **state) {
    (void)state;
    kg_random r = {4};
    const double step = 1e-6;
    int done = 0;
    for (int round = 0; round < 300; round++) {
        kg_curve c = random_curve(&r, 10);
        double v = kg_random_in(&r, 0.01, 0.99);
        kg_frenet f = kg_curve_frenet(&c, v), a = kg_curve_frenet(&c, v - step),
                  b = kg_curve_frenet(&c, v + step);
        assert_near(kg_det(f.tangent, f.normal, f.binormal), 1, 1e-12);
        assert_near(kg_dot(f.tangent, f.normal), 0, 1e-12);
        kg_vec3 d[2];
        kg_curve_derivatives(&c, v, 1, d);
        double s = kg_len(d[1]);
        if (s < 3 || f.curvature > 3 || fabs(f.torsion) > 3)
            continue; /* too fast for difference quotients */
        done++;
        kg_vec3 dt = kg_scale(kg_sub(b.tangent, a.tangent), 0.5 / (step * s));
        kg_vec3 db = kg_scale(kg_sub(b.binormal, a.binormal), 0.5 / (step * s));
        assert_near3(dt, kg_scale(f.normal, f.curvature), 1e-5); /* T' = κN */
        assert_near3(db, kg_scale(f.normal, -f.torsion), 1e-5);  /* B' = -τN */
    }
    assert_true(done > 150);
}

static void a_straight_curve_has_no_normal(void **state) {
    (void)state;
    const kg_vec3 p[4] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}};
    kg_curve c;
    assert_int_equal(kg_curve_init(p, 4, &c, NULL), KG_OK);
    kg_frenet f = kg_curve_frenet(&c, 0.3);
    assert_near3(f.tangent, kg_v3(0, 1, 0), 1e-15);
    assert_near3(f.normal, kg_v3(0, 0, 0), 0);
    assert_true(f.curvature == 0 && f.torsion == 0);
}

static kg_vec3 pointwise_darboux(const kg_curve *c, double v) {
    kg_vec3 d[4];
    kg_curve_derivatives(c, v, 3, d);
    kg_vec3 b = kg_cross(d[1], d[2]);
    return kg_add(kg_scale(d[1], kg_dot(d[1], d[1]) * kg_det(d[1], d[2], d[3])),
                  kg_scale(b, kg_dot(b, b)));
}

static void the_darboux_polynomial_has_the_values_of_d(void **state) {
    (void)state;
    kg_random r = {5};
    for (int round = 0; round < 1000; round++) {
        kg_curve c = random_curve(&r, 1);
        kg_vec3 poly[KG_DARBOUX_MAX_COUNT];
        int n = kg_curve_darboux(&c, poly);
        assert_int_equal(n, c.degree == 3 ? 6 : 18);
        double largest = 0;
        for (int i = 0; i <= n; i++)
            largest = fmax(largest, kg_len(poly[i]));
        for (int k = 0; k < 4; k++) {
            double v = kg_random_in(&r, 0, 1);
            kg_vec3 gap = kg_sub(kg_bernstein_eval3(poly, n, v), pointwise_darboux(&c, v));
            assert_near(kg_len(gap) / largest, 0, 1e-12);
        }
        /* by arc length: parallel to τT + κB */
        kg_frenet f = kg_curve_frenet(&c, 0.4);
        kg_vec3 axis =
            kg_unit(kg_add(kg_scale(f.tangent, f.torsion), kg_scale(f.binormal, f.curvature)));
        assert_near3(kg_unit(pointwise_darboux(&c, 0.4)), axis, 1e-9);
    }
}

/* The degree is exact, not only an upper bound: its leading power coefficient does not vanish, and
 * the same expression expanded without cancelling (degree 8 for a cubic) has nothing above. */
static void the_darboux_polynomial_of_a_general_curve_has_full_degree(void **state) {
    (void)state;
    kg_random r = {6};
    for (int round = 0; round < 50; round++) {
        kg_curve c = random_curve(&r, 1);
        kg_vec3 poly[KG_DARBOUX_MAX_COUNT];
        int n = kg_curve_darboux(&c, poly);
        kg_vec3 leading = kg_v3(0, 0, 0);
        double scale = 0;
        for (int i = 0; i <= n; i++) {
            double w = kg_binomial(n, i);
            leading = kg_madd(leading, (n - i) & 1 ? -w : w, poly[i]);
            scale += w * kg_len(poly[i]);
        }
        assert_true(kg_len(leading) > 1e-12 * scale);
    }
}

static void curves_are_classified_at_the_flatness_threshold(void **state) {
    (void)state;
    const kg_vec3 along = {3, 4, 12}, up = {4, -3, 0}, side = {12, 0, -3}; /* not orthonormal */
    const struct {
        double bend, twist;
        kg_curve_shape shape;
    } cases[] = {
        {0, 0, KG_CURVE_STRAIGHT},
        {0.3e-7, 0, KG_CURVE_STRAIGHT},
        {0.3e-7, 0.3e-7, KG_CURVE_STRAIGHT},
        {1e-6, 0, KG_CURVE_PLANAR},
        {1, 0, KG_CURVE_PLANAR},
        {1, 0.3e-7, KG_CURVE_PLANAR},
        {1, 1e-5, KG_CURVE_SPATIAL},
        {1, 1, KG_CURVE_SPATIAL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double h = cases[i].bend, k = cases[i].twist;
        kg_vec3 p[4] = {{0, 0, 0},
                        kg_madd(along, h, up),
                        kg_madd(kg_madd(kg_scale(along, 2), h, up), k, side),
                        kg_scale(along, 3)};
        kg_curve c;
        assert_int_equal(kg_curve_init(p, 4, &c, NULL), KG_OK);
        assert_int_equal(kg_curve_classify(&c), cases[i].shape);
    }
}

static void standing_still_anywhere_is_an_error_that_names_v(void **state) {
    (void)state;
    const struct {
        kg_vec3 p[4];
        const char *where;
    } cases[] = {
        {{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {2, 0, 0}}, "v = 0"},   /* first two coincide */
        {{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 0, 0}}, "v = 1"},   /* last two coincide */
        {{{0, 0, 0}, {3, 3, 0}, {0, 3, 0}, {3, 0, 0}}, "v = 0.5"}, /* cusp */
        {{{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {2, 0, 0}}, "v = "},    /* straight, out of order */
        {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, "v = "},    /* all coincide */
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, "v = 0"},   /* three coincide */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        kg_curve c = {.degree = 77};
        kg_error error;
        assert_int_equal(kg_curve_init(cases[i].p, 4, &c, &error), KG_ERR_INPUT);
        assert_non_null(strstr(error.message, cases[i].where));
        assert_non_null(strstr(error.message, "stands still"));
        assert_int_equal(c.degree, 77);
    }
}

static void inner_control_points_may_coincide(void **state) {
    (void)state;
    const kg_vec3 p[4] = {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, {2, 0, 0}};
    kg_curve c;
    assert_int_equal(kg_curve_init(p, 4, &c, NULL), KG_OK);
}

static void nearly_a_cusp_is_a_curve_and_a_cusp_is_not(void **state) {
    (void)state;
    for (int e = 1; e <= 12; e++) {
        double gap = pow(10, -e); /* |p'| at the middle is about this */
        const kg_vec3 p[4] = {{0, 0, 0}, {3 + gap, 3, 0}, {-gap, 3, 0}, {3, 0, 0}};
        kg_curve c;
        assert_int_equal(kg_curve_init(p, 4, &c, NULL), e <= 6 ? KG_OK : KG_ERR_INPUT);
    }
}

static void ugly_points_are_refused(void **state) {
    (void)state;
    const double ugly[] = {NAN, INFINITY, -INFINITY, 1e7, -1e300};
    for (size_t k = 0; k < 5; k++)
        for (int i = 0; i < 18; i++) {
            kg_vec3 p[6] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 1}, {4, 0, 1}, {5, 0, 0}};
            (i % 3 == 0 ? &p[i / 3].x : i % 3 == 1 ? &p[i / 3].y : &p[i / 3].z)[0] = ugly[k];
            kg_curve c;
            kg_error error;
            assert_int_equal(kg_curve_init(p, 6, &c, &error), KG_ERR_INPUT);
            assert_non_null(strstr(error.message, "control point"));
        }
    kg_vec3 p[6] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 1}, {4, 0, 1}, {5, 0, 0}};
    kg_curve c;
    for (size_t count = 0; count <= 6; count++)
        assert_int_equal(kg_curve_init(p, count, &c, NULL),
                         count == 4 || count == 6 ? KG_OK : KG_ERR_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_agree_with_the_power_basis),
        cmocka_unit_test(each_derivative_is_the_difference_quotient_of_the_one_before),
        cmocka_unit_test(a_segment_is_the_same_curve),
        cmocka_unit_test(the_twisted_cubic_has_its_known_curvature_and_torsion),
        cmocka_unit_test(frenet_frames_are_right_handed_and_turn_as_the_formulas_say),
        cmocka_unit_test(a_straight_curve_has_no_normal),
        cmocka_unit_test(the_darboux_polynomial_has_the_values_of_d),
        cmocka_unit_test(the_darboux_polynomial_of_a_general_curve_has_full_degree),
        cmocka_unit_test(curves_are_classified_at_the_flatness_threshold),
        cmocka_unit_test(standing_still_anywhere_is_an_error_that_names_v),
        cmocka_unit_test(inner_control_points_may_coincide),
        cmocka_unit_test(nearly_a_cusp_is_a_curve_and_a_cusp_is_not),
        cmocka_unit_test(ugly_points_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
