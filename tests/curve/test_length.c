#include "katagami/curve.h"
#include "tests/check.h"

/* The promise of kg_curve_length. */
#define RELATIVE 1e-13

static bool make(kg_curve *c, const kg_vec3 *p, size_t count) {
    return kg_curve_init(p, count, c, NULL) == KG_OK;
}

static bool random_curve(kg_random *r, kg_curve *c) {
    kg_vec3 p[6];
    for (int i = 0; i < 6; i++)
        p[i] = kg_v3(kg_random_in(r, -9, 9), kg_random_in(r, -9, 9), kg_random_in(r, -9, 9));
    return make(c, p, kg_random_bits(r) & 1 ? 4 : 6);
}

/* Composite Simpson, summed in long double. */
static double simpson(const kg_curve *c, double v0, double v1, int n) {
    long double sum = 0, h = ((long double)v1 - v0) / n;
    for (int i = 0; i <= n; i++) {
        kg_vec3 d[2];
        kg_curve_derivatives(c, (double)(v0 + i * h), 1, d);
        long double s = sqrtl((long double)d[1].x * d[1].x + (long double)d[1].y * d[1].y +
                              (long double)d[1].z * d[1].z);
        sum += (i == 0 || i == n ? 1 : i & 1 ? 4 : 2) * s;
    }
    return (double)(sum * h / 3);
}

static void a_straight_curve_is_as_long_as_its_chord(void **state) {
    (void)state;
    /* uneven speed, so that v is not proportional to length */
    const kg_vec3 p[4] = {{1, 1, 1}, {1.5, 1, 1}, {9, 1, 1}, {11, 1, 1}};
    kg_curve c;
    assert_true(make(&c, p, 4));
    assert_near(kg_curve_length(&c, 0, 1), 10, 10 * RELATIVE);
    assert_near(kg_curve_length(&c, 0, 0.3), kg_curve_point(&c, 0.3).x - 1, 10 * RELATIVE);
    assert_near(kg_curve_point(&c, kg_curve_at_length(&c, 2.5)).x, 3.5, 1e-11);
}

/* y = x² over [0,b]: (b sqrt(1+4b²) + asinh(2b)/2) / 2, raised to degree 3. */
static void a_parabola_has_its_closed_form_length(void **state) {
    (void)state;
    for (int k = 0; k < 8; k++) {
        double b = pow(3, k - 2);
        const kg_vec3 p[4] = {{0, 0, 0}, {b / 3, 0, 0}, {2 * b / 3, b * b / 3, 0}, {b, b * b, 0}};
        kg_curve c;
        assert_true(make(&c, p, 4));
        double exact = 0.5 * (b * sqrt(1 + 4 * b * b) + 0.5 * asinh(2 * b));
        assert_near(kg_curve_length(&c, 0, 1) / exact, 1, RELATIVE);
    }
}

static void random_lengths_agree_with_a_fine_composite_rule(void **state) {
    (void)state;
    kg_random r = {1};
    for (int round = 0; round < 60; round++) {
        kg_curve c;
        if (!random_curve(&r, &c))
            continue;
        double v0 = kg_random_in(&r, 0, 1), v1 = kg_random_in(&r, 0, 1);
        double fine = simpson(&c, v0, v1, 4000), coarse = simpson(&c, v0, v1, 2000);
        /* Simpson's own error, from its two grids, comes on top */
        double tolerance = RELATIVE * kg_curve_length(&c, 0, 1) + fabs(fine - coarse);
        assert_near(kg_curve_length(&c, v0, v1), fine, tolerance);
    }
}

static void lengths_add_up_and_turn_their_sign(void **state) {
    (void)state;
    kg_random r = {2};
    for (int round = 0; round < 300; round++) {
        kg_curve c;
        if (!random_curve(&r, &c))
            continue;
        double v = kg_random_in(&r, 0, 1), whole = kg_curve_length(&c, 0, 1);
        assert_near(kg_curve_length(&c, 0, v) + kg_curve_length(&c, v, 1), whole, RELATIVE * whole);
        assert_near(kg_curve_length(&c, v, 0), -kg_curve_length(&c, 0, v), RELATIVE * whole);
        assert_true(kg_curve_length(&c, v, v) == 0);
    }
}

/* p' = ((v-½)·a, g): |p'| has the closed form integral of sqrt(a²t² + g²). */
static void a_near_cusp_keeps_its_accuracy(void **state) {
    (void)state;
    for (int e = 0; e <= 6; e++) {
        double g = pow(10, -e), a = 8, h = 0.5;
        /* parabola x = a t²/2, y = g t, t in [-½,½], raised to degree 3 */
        double x = a * h * h / 2;
        const kg_vec3 q[3] = {{x, -g * h, 0}, {-x, 0, 0}, {x, g * h, 0}};
        const kg_vec3 p[4] = {q[0], kg_lerp(q[0], q[1], 2.0 / 3), kg_lerp(q[1], q[2], 1.0 / 3),
                              q[2]};
        kg_curve c;
        assert_true(make(&c, p, 4));
        double root = sqrt(a * a * h * h + g * g);
        double exact = h * root + g * g / a * asinh(a * h / g);
        assert_near(kg_curve_length(&c, 0, 1) / exact, 1, RELATIVE);
        assert_near(kg_curve_length(&c, 0.5, 1) / (0.5 * exact), 1, RELATIVE);
        double back = kg_curve_at_length(&c, 0.7 * exact);
        assert_near(kg_curve_length(&c, 0, back) / (0.7 * exact), 1, 1e-12);
    }
}

static void the_inverse_returns_to_v_within_its_promise(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 300; round++) {
        kg_curve c;
        if (!random_curve(&r, &c))
            continue;
        double whole = kg_curve_length(&c, 0, 1);
        double wanted = kg_random_in(&r, 0, whole), v = kg_curve_at_length(&c, wanted);
        assert_near(kg_curve_length(&c, 0, v), wanted, 1e-12 * whole);
    }
}

static void the_inverse_is_clamped(void **state) {
    (void)state;
    kg_random r = {4};
    kg_curve c;
    while (!random_curve(&r, &c))
        ;
    assert_true(kg_curve_at_length(&c, -1) == 0);
    assert_true(kg_curve_at_length(&c, 0) == 0);
    assert_true(kg_curve_at_length(&c, NAN) == 0);
    assert_true(kg_curve_at_length(&c, INFINITY) == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_curve_is_as_long_as_its_chord),
        cmocka_unit_test(a_parabola_has_its_closed_form_length),
        cmocka_unit_test(random_lengths_agree_with_a_fine_composite_rule),
        cmocka_unit_test(lengths_add_up_and_turn_their_sign),
        cmocka_unit_test(a_near_cusp_keeps_its_accuracy),
        cmocka_unit_test(the_inverse_returns_to_v_within_its_promise),
        cmocka_unit_test(the_inverse_is_clamped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
