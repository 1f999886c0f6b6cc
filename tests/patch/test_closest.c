#include "random_patch.h"

static void no_dense_sample_is_nearer(void **state) {
    (void)state;
    kg_random r = {1};
    for (int round = 0; round < 200; round++) {
        kg_patch p = random_patch(&r, round);
        kg_vec3 q = kg_v3(kg_random_in(&r, -100, 100), kg_random_in(&r, -100, 100),
                          kg_random_in(&r, -100, 100));
        double u, v, d = kg_patch_closest(&p, q, &u, &v);
        assert_true(u >= p.extent[0] && u <= p.extent[1] && v >= 0 && v <= 1);
        assert_near(kg_dist(q, kg_patch_point(&p, u, v)), d, 1e-10);
        for (int i = 0; i <= 500; i++)
            for (int k = 0; k <= 50; k++) {
                double w = p.extent[0] + (p.extent[1] - p.extent[0]) * k / 50;
                assert_true(kg_dist(q, kg_patch_point(&p, w, i / 500.0)) >= d - 1e-9);
            }
    }
}

static void a_point_of_the_patch_is_found_again(void **state) {
    (void)state;
    kg_random r = {2};
    for (int round = 0; round < 500; round++) {
        kg_patch p = random_patch(&r, round);
        double u0 = kg_random_in(&r, p.extent[0], p.extent[1]), v0 = kg_random_in(&r, 0, 1);
        if (round % 10 == 0)
            v0 = round % 20 == 0, u0 = p.extent[round % 3 == 0]; /* corners */
        double u, v, d = kg_patch_closest(&p, kg_patch_point(&p, u0, v0), &u, &v);
        assert_near(d, 0, 1e-9);
        (void)(u + v); /* the patch may cross itself: other coordinates are as good */
    }
}

static void straight_and_planar_patches_give_the_foot_of_the_perpendicular(void **state) {
    (void)state;
    kg_patch_input in = {.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
                         .point_count = 4,
                         .extent = {-1, 1},
                         .has_ruling = true,
                         .ruling = {0, 2, 0}};
    kg_patch p;
    assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
    double u, v;
    assert_near(kg_patch_closest(&p, kg_v3(1.2, 0.25, 7), &u, &v), 7, 1e-12);
    assert_near(u, 0.25, 1e-12);
    assert_near(v, 0.4, 1e-6); /* distances grow with the square of the offset */
    assert_near(kg_patch_closest(&p, kg_v3(6, 5, 0), &u, &v), 5, 1e-12);
    assert_true(u == 1 && v == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_dense_sample_is_nearer),
        cmocka_unit_test(a_point_of_the_patch_is_found_again),
        cmocka_unit_test(straight_and_planar_patches_give_the_foot_of_the_perpendicular),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
