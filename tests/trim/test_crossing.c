/* Random pairs: every branch found, every point exact. */
#include "tests/trim/pairs.h"

#define TOLERANCE 0.01

static const kg_vec3 O = {0, 0, 0};

/* Runs `count` pairs of two kinds; returns the number of branches. */
static size_t run(uint64_t seed, pair_kind first, pair_kind second, int count) {
    kg_random r = {seed};
    size_t branches = 0;
    for (int i = 0; i < count; i++) {
        char name[64];
        snprintf(name, sizeof name, "kinds %d and %d, pair %d", (int)first, (int)second, i);
        kg_patch a = random_patch(&r, first, O);
        kg_vec3 shift = {kg_random_in(&r, -25, 25), kg_random_in(&r, -25, 25),
                         kg_random_in(&r, -25, 25)};
        kg_patch b = random_patch(&r, second, shift);
        kg_crossings found = {0};
        kg_error error = {0};
        if (kg_crossings_find(&a, &b, TOLERANCE, &found, &error))
            fail_msg("%s: %s", name, error.message);
        check_points(&a, &b, &found, TOLERANCE);
        check_against_rays(&a, &b, &found, TOLERANCE, name);
        branches += found.count;
        kg_crossings_clear(&found);
    }
    return branches;
}

static void no_branch_is_missed_among_gentle_patches(void **state) {
    (void)state;
    size_t branches = run(11, PAIR_CUBIC, PAIR_CUBIC, 120) +
                      run(12, PAIR_CUBIC, PAIR_QUINTIC, 100) +
                      run(13, PAIR_QUINTIC, PAIR_QUINTIC, 80);
    assert_true(branches > 150);
}

static void no_branch_is_missed_among_planar_and_straight_patches(void **state) {
    (void)state;
    static const pair_kind kinds[][2] = {
        {PAIR_CUBIC, PAIR_PLANAR},     {PAIR_PLANAR, PAIR_PLANAR},
        {PAIR_CUBIC, PAIR_PLANAR_S},   {PAIR_PLANAR_S, PAIR_PLANAR_S},
        {PAIR_CUBIC, PAIR_STRAIGHT},   {PAIR_PLANAR, PAIR_STRAIGHT},
        {PAIR_QUINTIC, PAIR_STRAIGHT}, {PAIR_STRAIGHT, PAIR_STRAIGHT},
    };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        assert_true(run(20 + k, kinds[k][0], kinds[k][1], 60) > 20);
}

static void no_branch_is_missed_among_wildly_twisted_patches(void **state) {
    (void)state;
    run(31, PAIR_WILD, PAIR_WILD, 100);
    run(32, PAIR_CUBIC, PAIR_WILD, 70);
    run(33, PAIR_QUINTIC, PAIR_WILD, 70);
}

/* Two bulges that pierce each other a little: closed curves, several branches, near touches. */
static void no_branch_is_missed_where_bulges_pierce_each_other(void **state) {
    (void)state;
    kg_random r = {41};
    size_t closed = 0, several = 0;
    for (int i = 0; i < 150; i++) {
        char name[32];
        snprintf(name, sizeof name, "bulges %d", i);
        kg_patch a = random_patch(&r, (pair_kind)(i % 3), O);
        kg_patch b = random_patch(&r, (pair_kind)(i / 3 % 3), O);
        /* bring the middle of b to the middle of a, turned so that both planes are one, and then
         * push it through by a little */
        kg_ruling ra = kg_patch_ruling(&a, 0.5), rb = kg_patch_ruling(&b, 0.5);
        kg_vec3 za = ra.normal, zb = kg_scale(rb.normal, i & 1 ? -1 : 1);
        kg_vec3 xa = ra.d, ya = kg_cross(za, xa), xb = rb.d, yb = kg_cross(zb, xb);
        double turn = kg_random_in(&r, 0, 6.28), push = kg_random_in(&r, -0.6, 0.6);
        kg_vec3 x = kg_add(kg_scale(xa, cos(turn)), kg_scale(ya, sin(turn))), y = kg_cross(za, x);
        kg_vec3 ua = kg_patch_point(&a, 0.5 * (a.extent[0] + a.extent[1]), 0.5);
        kg_vec3 ub = kg_patch_point(&b, 0.5 * (b.extent[0] + b.extent[1]), 0.5);
        kg_vec3 q[KG_CURVE_MAX_POINTS];
        for (int k = 0; k <= b.geodesic.degree; k++) {
            kg_vec3 p = kg_sub(b.geodesic.points[k], ub);
            q[k] = kg_madd(ua, kg_dot(p, xb), x);
            q[k] = kg_madd(q[k], kg_dot(p, yb), y);
            q[k] = kg_madd(q[k], kg_dot(p, zb) + push, za);
        }
        kg_patch moved =
            make_patch(q, (size_t)b.geodesic.degree + 1, b.extent[0], b.extent[1], NULL);
        kg_crossings found = {0};
        kg_error error = {0};
        if (kg_crossings_find(&a, &moved, TOLERANCE, &found, &error))
            fail_msg("%s: %s", name, error.message);
        check_points(&a, &moved, &found, TOLERANCE);
        check_against_rays(&a, &moved, &found, TOLERANCE, name);
        for (size_t k = 0; k < found.count; k++)
            closed += found.branches[k].closed;
        several += found.count > 1;
        kg_crossings_clear(&found);
    }
    assert_true(closed >= 10);
    assert_true(several >= 20);
}

/* Is the ruling by the naive formula trustworthy? It loses its digits where the curve is straight.
 */
static bool naive_holds(const kg_patch *p) {
    for (int i = 0; i <= 800; i++)
        if (kg_dist(naive_point(p, 50, i / 800.0), kg_patch_point(p, 50, i / 800.0)) > 1e-9)
            return false;
    return true;
}

static bool lattice_patch(kg_random *r, int span, kg_patch *out) {
    kg_patch_input in = {.point_count = kg_random_in(r, 0, 1) < 0.6 ? 4 : 6, .has_ruling = true};
    for (size_t i = 0; i < in.point_count; i++) {
        in.points[i].x = 10 * floor(kg_random_in(r, 0, span));
        in.points[i].y = 10 * floor(kg_random_in(r, 0, span));
        in.points[i].z = 10 * floor(kg_random_in(r, 0, span));
    }
    in.extent[0] = -10 * floor(kg_random_in(r, 0, 4));
    in.extent[1] = in.extent[0] + 10 * floor(kg_random_in(r, 1, 5));
    in.ruling.x = floor(kg_random_in(r, 0, 3));
    in.ruling.y = floor(kg_random_in(r, 0, 3));
    in.ruling.z = 1;
    return kg_patch_init(&in, out, NULL) == KG_OK && naive_holds(out);
}

/* Control points on a coarse lattice: corners on surfaces, shared points, parallel rulings, curves
 * along sides, swinging rulings. */
static void no_branch_is_missed_among_patches_on_a_lattice(void **state) {
    (void)state;
    kg_random r = {71};
    size_t branches = 0;
    for (int i = 0; i < 600; i++) {
        char name[32];
        snprintf(name, sizeof name, "lattice %d", i);
        kg_patch a, b;
        if (!lattice_patch(&r, 2 + i % 4, &a) || !lattice_patch(&r, 2 + i % 4, &b))
            continue;
        kg_crossings found = {0};
        kg_error error = {0};
        kg_status status = kg_crossings_find(&a, &b, TOLERANCE, &found, &error);
        if (status) {
            assert_int_equal(status, KG_ERR_INPUT);
            continue;
        }
        check_points(&a, &b, &found, TOLERANCE);
        check_against_rays(&a, &b, &found, TOLERANCE, name);
        branches += found.count;
        kg_crossings_clear(&found);
    }
    assert_true(branches > 60);
}

static void exchanging_the_patches_gives_the_same_points(void **state) {
    (void)state;
    kg_random r = {51};
    for (int i = 0; i < 100; i++) {
        kg_patch a = random_patch(&r, (pair_kind)(i % PAIR_KINDS), O);
        kg_patch b = random_patch(&r, (pair_kind)(i / 6 % PAIR_KINDS), kg_v3(5, -3, 8));
        kg_crossings ab = {0}, ba = {0};
        assert_int_equal(kg_crossings_find(&a, &b, TOLERANCE, &ab, NULL), KG_OK);
        assert_int_equal(kg_crossings_find(&b, &a, TOLERANCE, &ba, NULL), KG_OK);
        kg_crossings_swap(&ba);
        assert_int_equal(ab.count, ba.count);
        for (size_t k = 0; k < ab.count; k++) {
            const kg_crossing *x = &ab.branches[k], *y = &ba.branches[k];
            assert_int_equal(x->count, y->count);
            assert_true(x->ends[0] == y->ends[0] && x->ends[1] == y->ends[1]);
            assert_memory_equal(x->points, y->points, x->count * sizeof *x->points);
        }
        kg_crossings_clear(&ab);
        kg_crossings_clear(&ba);
    }
}

/* Derivatives by fraction against central differences, and the span's ends. */
static void points_inside_spans_are_smooth(void **state) {
    (void)state;
    kg_random r = {61};
    for (int i = 0; i < 60; i++) {
        kg_patch a = random_patch(&r, (pair_kind)(i % 5), O);
        kg_patch b = random_patch(&r, (pair_kind)(i / 5 % 5), kg_v3(5, -3, 8));
        kg_crossings found = {0};
        assert_int_equal(kg_crossings_find(&a, &b, TOLERANCE, &found, NULL), KG_OK);
        for (size_t j = 0; j < found.count; j++)
            for (size_t k = 0; k + 1 < found.branches[j].count; k++) {
                const kg_crossing *c = &found.branches[j];
                double h = 1e-4;
                kg_cross_point slope, lo, hi, at;
                lo = kg_crossing_at(&a, &b, c, k, 0.37 - h, NULL);
                hi = kg_crossing_at(&a, &b, c, k, 0.37 + h, NULL);
                kg_crossing_at(&a, &b, c, k, 0.37, &slope);
                double reach = kg_dist(c->points[k].x, c->points[k + 1].x);
                assert_near((hi.u - lo.u) / (2 * h), slope.u, 1e-4 * reach);
                assert_near((hi.s - lo.s) / (2 * h), slope.s, 1e-4 * reach);
                assert_near((hi.v - lo.v) / (2 * h), slope.v, 1e-6 * reach);
                assert_near((hi.t - lo.t) / (2 * h), slope.t, 1e-6 * reach);
                assert_near(kg_len(kg_sub(kg_scale(kg_sub(hi.x, lo.x), 0.5 / h), slope.x)), 0,
                            1e-4 * reach);
                at = kg_crossing_at(&a, &b, c, k, 0, NULL);
                assert_near(kg_dist(at.x, c->points[k].x), 0, 1e-9 * a.size);
                at = kg_crossing_at(&a, &b, c, k, 1, NULL);
                assert_near(kg_dist(at.x, c->points[k + 1].x), 0, 1e-9 * a.size);
            }
        kg_crossings_clear(&found);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_branch_is_missed_among_gentle_patches),
        cmocka_unit_test(no_branch_is_missed_among_planar_and_straight_patches),
        cmocka_unit_test(no_branch_is_missed_among_wildly_twisted_patches),
        cmocka_unit_test(no_branch_is_missed_where_bulges_pierce_each_other),
        cmocka_unit_test(no_branch_is_missed_among_patches_on_a_lattice),
        cmocka_unit_test(exchanging_the_patches_gives_the_same_points),
        cmocka_unit_test(points_inside_spans_are_smooth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
