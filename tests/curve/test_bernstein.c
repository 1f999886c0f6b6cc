/* The algebra against direct values: a product's value is the product of the values. */
#include "curve/bernstein.h"
#include "tests/check.h"

/* Sums of at most 49 terms of size 1, each with a few roundings. */
#define ROUNDING 1e-13

static double direct(const double *a, int n, double t) {
    double sum = 0;
    for (int i = 0; i <= n; i++)
        sum += a[i] * kg_binomial(n, i) * pow(t, i) * pow(1 - t, n - i);
    return sum;
}

static kg_vec3 direct3(const kg_vec3 *a, int n, double t) {
    double x[49], y[49], z[49];
    for (int i = 0; i <= n; i++)
        x[i] = a[i].x, y[i] = a[i].y, z[i] = a[i].z;
    return kg_v3(direct(x, n, t), direct(y, n, t), direct(z, n, t));
}

static void fill(kg_random *r, double *a, kg_vec3 *b, int n) {
    for (int i = 0; i <= n; i++) {
        a[i] = kg_random_in(r, -1, 1);
        b[i] = kg_v3(kg_random_in(r, -1, 1), kg_random_in(r, -1, 1), kg_random_in(r, -1, 1));
    }
}

static void assert_near3(kg_vec3 a, kg_vec3 b, double tolerance) {
    assert_near(a.x, b.x, tolerance);
    assert_near(a.y, b.y, tolerance);
    assert_near(a.z, b.z, tolerance);
}

static void binomials_follow_pascals_triangle_up_to_the_largest_degree(void **state) {
    (void)state;
    for (int n = 1; n <= KG_BERNSTEIN_MAX_DEGREE; n++) {
        assert_true(kg_binomial(n, 0) == 1 && kg_binomial(n, n) == 1);
        for (int k = 1; k < n; k++)
            assert_true(kg_binomial(n, k) == kg_binomial(n - 1, k - 1) + kg_binomial(n - 1, k));
    }
}

static void values_agree_with_the_definition(void **state) {
    (void)state;
    kg_random r = {1};
    double a[49];
    kg_vec3 b[49];
    const double special[] = {0, 1, 0.5, 0x1p-1022, 1 - 0x1p-53, -0.25, 1.25};
    for (int n = 0; n <= KG_BERNSTEIN_MAX_DEGREE; n++) {
        fill(&r, a, b, n);
        for (int k = 0; k < 20; k++) {
            double t = k < 5 ? special[k] : kg_random_in(&r, 0, 1);
            assert_near3(kg_bernstein_eval3(b, n, t), direct3(b, n, t), ROUNDING);
        }
        if (n <= 6) /* outside [0,1] terms alternate and grow; low degrees still hold */
            for (int k = 5; k < 7; k++)
                assert_near3(kg_bernstein_eval3(b, n, special[k]), direct3(b, n, special[k]),
                             1e-11);
    }
}

static void products_take_the_product_of_the_values(void **state) {
    (void)state;
    kg_random r = {2};
    for (int round = 0; round < 500; round++) {
        int n = (int)kg_random_in(&r, 0, 24), m = (int)kg_random_in(&r, 0, 25);
        double a[25], b[25], product[49];
        kg_vec3 p[25], q[25], product3[49];
        fill(&r, a, p, n);
        fill(&r, b, q, m);
        double t = kg_random_in(&r, 0, 1);
        double av = direct(a, n, t);
        kg_vec3 pv = direct3(p, n, t), qv = direct3(q, m, t);
        kg_bernstein_mul(a, n, b, m, product);
        assert_near(direct(product, n + m, t), av * direct(b, m, t), ROUNDING);
        kg_bernstein_dot(p, n, q, m, product);
        assert_near(direct(product, n + m, t), kg_dot(pv, qv), ROUNDING);
        kg_bernstein_mul3(a, n, q, m, product3);
        assert_near3(direct3(product3, n + m, t), kg_scale(qv, av), ROUNDING);
        kg_bernstein_cross(p, n, q, m, product3);
        assert_near3(direct3(product3, n + m, t), kg_cross(pv, qv), ROUNDING);
    }
}

static void elevation_and_restriction_keep_the_polynomial(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 300; round++) {
        int n = (int)kg_random_in(&r, 0, 19), m = n + (int)kg_random_in(&r, 0, 20);
        double a[49];
        kg_vec3 p[49], q[49];
        fill(&r, a, p, n);
        double t = kg_random_in(&r, 0, 1);
        kg_bernstein_elevate3(p, n, m, q);
        assert_near3(direct3(q, m, t), direct3(p, n, t), ROUNDING);
        memcpy(q, p, sizeof q);
        kg_bernstein_elevate3(q, n, m, q);
        assert_near3(direct3(q, m, t), direct3(p, n, t), ROUNDING);

        double lo = kg_random_in(&r, 0, 0.9), hi = kg_random_in(&r, lo + 0.01, 1);
        if (round % 3 == 0)
            lo = 0;
        if (round % 5 == 0)
            hi = 1;
        memcpy(q, p, sizeof q);
        kg_bernstein_restrict3(q, n, lo, hi);
        assert_near3(direct3(q, n, t), direct3(p, n, lo + t * (hi - lo)), ROUNDING);
        assert_near3(q[0], direct3(p, n, lo), ROUNDING);
        assert_near3(q[n], direct3(p, n, hi), ROUNDING);
    }
}

static void dividing_a_root_out_gives_the_cofactor_back(void **state) {
    (void)state;
    kg_random r = {5};
    for (int round = 0; round < 300; round++) {
        int n = (int)kg_random_in(&r, 1, 18);
        const double special[] = {0, 1, 0.5, 1e-12};
        double root = round < 4 ? special[round] : kg_random_in(&r, 0, 1);
        double a[49], linear[2] = {-root, 1 - root};
        kg_vec3 p[49], product[49], q[49];
        fill(&r, a, p, n);
        kg_bernstein_mul3(linear, 1, p, n, product);
        kg_bernstein_deflate3(product, n + 1, root, q);
        for (int i = 0; i <= n; i++) /* the recurrence doubles errors a few times */
            assert_near3(q[i], p[i], 1e-9);
        kg_bernstein_deflate3(product, n + 1, root, product);
        assert_memory_equal(product, q, sizeof *q * (size_t)(n + 1));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(binomials_follow_pascals_triangle_up_to_the_largest_degree),
        cmocka_unit_test(values_agree_with_the_definition),
        cmocka_unit_test(products_take_the_product_of_the_values),
        cmocka_unit_test(elevation_and_restriction_keep_the_polynomial),
        cmocka_unit_test(dividing_a_root_out_gives_the_cofactor_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
