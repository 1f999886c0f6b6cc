/* Where the paper would fold back: the edge of regression, extents, ruling angles, boxes. */
#include "random_patch.h"

/* Signed area factor: X_v × X_u against the front normal. Positive where the surface is regular. */
static double jacobian(const kg_patch *p, double u, double v) {
    kg_vec3 du, dv, n = kg_patch_normal(p, v);
    kg_patch_derivatives(p, u, v, &du, &dv);
    return kg_dot(kg_cross(dv, du), n) * (p->flip ? -1 : 1);
}

static void the_surface_is_regular_all_over_the_extent_in_force(void **state) {
    (void)state;
    kg_random r = {1};
    int clamped = 0;
    for (int round = 0; round < 1000; round++) {
        kg_patch p = random_patch(&r, round);
        clamped += p.clamped;
        assert_true(p.extent[0] >= p.wished_extent[0] && p.extent[1] <= p.wished_extent[1]);
        for (int i = 0; i < 500; i++)
            for (int k = 0; k < 2; k++)
                assert_true(jacobian(&p, p.extent[k], i / 499.0) > 0);
    }
    assert_true(clamped > 100 && clamped < 900);
}

static void the_jacobian_changes_sign_at_the_reported_edge(void **state) {
    (void)state;
    kg_random r = {2};
    int seen = 0;
    for (int round = 0; round < 1000; round++) {
        kg_patch p = random_patch(&r, round);
        double v = kg_random_in(&r, 0, 1), edge[2];
        kg_patch_regression(&p, v, &edge[0], &edge[1]);
        assert_true(edge[0] < 0 && edge[1] > 0);
        assert_true(isinf(edge[0]) || isinf(edge[1])); /* one edge per ruling */
        for (int k = 0; k < 2; k++) {
            assert_true(k ? p.regression[1] <= edge[1] * (1 + 1e-9)
                          : p.regression[0] >= edge[0] * (1 + 1e-9));
            if (isinf(edge[k]) || fabs(edge[k]) > 1e6)
                continue;
            seen++;
            assert_true(jacobian(&p, edge[k] * (1 - 1e-6), v) > 0);
            assert_true(jacobian(&p, edge[k] * (1 + 1e-6), v) < 0);
        }
    }
    assert_true(seen > 300);
}

static void the_reported_extremes_are_the_true_ones(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 300; round++) {
        kg_patch p = random_patch(&r, round);
        double dense[2] = {-HUGE_VAL, HUGE_VAL}, theta[2] = {10, -10};
        for (int i = 0; i <= 5000; i++) {
            double lo, hi, v = i / 5000.0;
            kg_patch_regression(&p, v, &lo, &hi);
            dense[0] = fmax(dense[0], lo);
            dense[1] = fmin(dense[1], hi);
            kg_ruling g = kg_patch_ruling(&p, v);
            double t = atan2(g.sin_theta, g.cos_theta);
            theta[0] = fmin(theta[0], t), theta[1] = fmax(theta[1], t);
        }
        for (int k = 0; k < 2; k++) {
            /* never wider than what the dense scan sees, and reached at the v that is reported */
            assert_true(fabs(p.regression[k]) <= fabs(dense[k]) * (1 + 1e-9));
            if (isinf(p.regression[k])) {
                assert_true(isnan(p.regression_v[k]));
            } else {
                double lo, hi;
                kg_patch_regression(&p, p.regression_v[k], &lo, &hi);
                assert_near((k ? hi : lo) / p.regression[k], 1, 1e-9);
            }
        }
        assert_true(p.theta[0] <= theta[0] + 1e-9 && p.theta[1] >= theta[1] - 1e-9);
        kg_ruling flattest = kg_patch_ruling(&p, p.flattest_v);
        double sine = fmin(sin(p.theta[0]), sin(p.theta[1]));
        assert_near(flattest.sin_theta, sine, 1e-6);
    }
}

/* Even samples alone would step over the spikes beside a near-inflection. */
static void spikes_beside_a_near_inflection_are_found(void **state) {
    (void)state;
    for (int e = 0; e <= 5; e++) {
        /* an S with the twist `lift` between its halves */
        double lift = 10 * pow(4, -e);
        kg_patch_input in = {.points = {{0, 0, 0}, {33, 20, lift}, {71, -20, 0}, {100, 0, 0}},
                             .point_count = 4,
                             .extent = {-30, 30}};
        kg_patch p;
        assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
        assert_true(p.clamped);
        double middle = p.flattest_v;
        for (int i = -4000; i <= 4000; i++) {
            double v = middle + copysign(pow(10, -9 + 8.5 * fabs(i / 4000.0)), i);
            double lo, hi;
            if (v < 0 || v > 1)
                continue;
            kg_patch_regression(&p, v, &lo, &hi);
            assert_true(lo <= p.regression[0] * (1 - 1e-6) && hi >= p.regression[1] * (1 - 1e-6));
        }
    }
}

static void extents_are_cut_back_at_the_limit_and_only_there(void **state) {
    (void)state;
    kg_random r = {4};
    for (int round = 0; round < 500; round++) {
        kg_patch_input in = random_input(&r, ARC, round & 1 ? 6 : 4);
        in.extent[0] = -1e5, in.extent[1] = 1e5;
        kg_patch p, q;
        if (kg_patch_init(&in, &p, NULL) != KG_OK)
            continue;
        for (int k = 0; k < 2; k++)
            assert_near(p.extent[k], fmax(-1e5, fmin(1e5, KG_REGRESSION_LIMIT * p.regression[k])),
                        1e-9 * fabs(p.extent[k]));
        assert_int_equal(p.clamped, p.extent[0] != -1e5 || p.extent[1] != 1e5);
        in.extent[0] = p.extent[0], in.extent[1] = p.extent[1];
        assert_int_equal(kg_patch_init(&in, &q, NULL), KG_OK);
        assert_false(q.clamped);
        in.extent[0] = 0.995 * p.regression[1], in.extent[1] = 2 * p.regression[1];
        if (isfinite(in.extent[1])) {
            kg_error error;
            assert_int_equal(kg_patch_init(&in, &q, &error), KG_ERR_INPUT);
            assert_non_null(strstr(error.message, "edge of regression"));
        }
    }
}

static void the_box_contains_the_patch(void **state) {
    (void)state;
    kg_random r = {5};
    for (int round = 0; round < 500; round++) {
        kg_patch p = random_patch(&r, round);
        double slack = 1e-12 * (p.size + 100);
        for (int i = 0; i <= 200; i++)
            for (int k = 0; k <= 4; k++) {
                double u = p.extent[0] + (p.extent[1] - p.extent[0]) * k / 4;
                kg_vec3 x = kg_patch_point(&p, u, i / 200.0);
                assert_true(x.x >= p.box.lo.x - slack && x.x <= p.box.hi.x + slack);
                assert_true(x.y >= p.box.lo.y - slack && x.y <= p.box.hi.y + slack);
                assert_true(x.z >= p.box.lo.z - slack && x.z <= p.box.hi.z + slack);
            }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_surface_is_regular_all_over_the_extent_in_force),
        cmocka_unit_test(the_jacobian_changes_sign_at_the_reported_edge),
        cmocka_unit_test(the_reported_extremes_are_the_true_ones),
        cmocka_unit_test(spikes_beside_a_near_inflection_are_found),
        cmocka_unit_test(extents_are_cut_back_at_the_limit_and_only_there),
        cmocka_unit_test(the_box_contains_the_patch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
