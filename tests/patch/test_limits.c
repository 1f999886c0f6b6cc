/* Ugly input, and behaviour across the thresholds between straight, planar and spatial. */
#include "random_patch.h"

static const kg_patch_input arc = {
    .points = {{0, 0, 0}, {35, 30, 5}, {70, 30, 0}, {100, 0, 0}},
    .point_count = 4,
    .extent = {-5, 5},
};

static void assert_refused(const kg_patch_input *in, const char *words) {
    kg_patch p;
    memset(&p, 0x5a, sizeof p);
    kg_patch before = p;
    kg_error error;
    assert_int_equal(kg_patch_init(in, &p, &error), KG_ERR_INPUT);
    assert_int_equal(error.status, KG_ERR_INPUT);
    assert_memory_equal(&p, &before, sizeof p);
    if (!strstr(error.message, words))
        fail_msg("\"%s\" is not in \"%s\"", words, error.message);
}

static void assert_sound(const kg_patch *p) {
    for (int i = 0; i <= 100; i++)
        for (int k = 0; k < 2; k++) {
            kg_vec3 du, dv, x = kg_patch_derivatives(p, p->extent[k], i / 100.0, &du, &dv);
            kg_vec2 q = kg_patch_unroll(p, p->extent[k], i / 100.0);
            kg_vec3 n = kg_patch_normal(p, i / 100.0);
            assert_true(isfinite(x.x + x.y + x.z + dv.x + dv.y + dv.z + q.x + q.y));
            assert_near(kg_len(du), 1, 1e-9);
            assert_near(kg_len(n), 1, 1e-9);
        }
    assert_true(p->extent[0] < p->extent[1]);
    assert_true(isfinite(p->size + p->box.lo.x + p->box.hi.z + p->theta[0] + p->theta[1]));
    assert_true(p->regression[0] < 0 && p->regression[1] > 0);
}

static void an_ordinary_patch_is_accepted(void **state) {
    (void)state;
    kg_patch p;
    assert_int_equal(kg_patch_init(&arc, &p, NULL), KG_OK);
    assert_sound(&p);
}

static void extents_that_are_no_interval_are_refused(void **state) {
    (void)state;
    const double bad[][2] = {{5, -5},        {3, 3},        {NAN, 1}, {1, NAN},
                             {-INFINITY, 1}, {0, INFINITY}, {0, 1e7}, {-1e7, 0}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        kg_patch_input in = arc;
        in.extent[0] = bad[i][0], in.extent[1] = bad[i][1];
        assert_refused(&in, "extent");
    }
}

static void an_extent_on_one_side_of_the_geodesic_is_fine(void **state) {
    (void)state;
    kg_patch_input in = arc;
    in.extent[0] = 2, in.extent[1] = 3;
    kg_patch p;
    assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
    assert_true(p.extent[0] == 2 && p.extent[1] == 3 && !p.clamped);
}

static void broken_control_points_are_refused(void **state) {
    (void)state;
    for (int i = 0; i < 4; i++) {
        kg_patch_input in = arc;
        in.points[i].y = i & 1 ? (double)NAN : 1e7;
        assert_refused(&in, "control point");
    }
    const struct {
        kg_vec3 p[4];
    } still[] = {
        {{{0, 0, 0}, {0, 0, 0}, {5, 5, 5}, {9, 0, 0}}},
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {9, 0, 0}}},
        {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}, {7, 7, 7}}},
        {{{0, 0, 0}, {3, 3, 0}, {0, 3, 0}, {3, 0, 0}}},  /* cusp */
        {{{0, 0, 0}, {9, 0, 0}, {-3, 0, 0}, {6, 0, 0}}}, /* straight, turning back */
    };
    for (size_t k = 0; k < sizeof still / sizeof *still; k++) {
        kg_patch_input in = arc;
        memcpy(in.points, still[k].p, sizeof still[k].p);
        assert_refused(&in, "stands still");
    }
    kg_patch_input in = arc;
    in.point_count = 5;
    assert_refused(&in, "control points");
}

static kg_patch_input straight(void) {
    kg_patch_input in = arc;
    for (int i = 0; i < 4; i++)
        in.points[i] = kg_v3(1 + i, 2 + 2 * i, 3 - 2 * i);
    in.has_ruling = true;
    return in;
}

static void a_straight_geodesic_takes_the_wished_ruling_made_square(void **state) {
    (void)state;
    const kg_vec3 wishes[] = {{2, -1, 0}, {0, 3, 0}, {1e-300, -1e-300, 0}, {1e300, 0, 1e300}};
    const kg_vec3 along = kg_unit(kg_v3(1, 2, -2));
    for (size_t i = 0; i < 4; i++) {
        kg_patch_input in = straight();
        in.ruling = wishes[i];
        kg_patch p;
        assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
        assert_sound(&p);
        kg_ruling r = kg_patch_ruling(&p, 0.3);
        assert_near(kg_dot(r.d, along), 0, 1e-15);
        kg_vec3 wish = kg_scale(wishes[i], 1 / fmax(fabs(wishes[i].x), fabs(wishes[i].y)));
        assert_true(kg_dot(r.d, wish) > 0);
        assert_near(kg_det(r.d, along, wish), 0, 1e-15);
    }
}

static void a_ruling_wish_that_is_none_is_refused(void **state) {
    (void)state;
    const kg_vec3 wishes[] = {
        {1, 2, -2},       {-2, -4, 4},           {0, 0, 0}, {NAN, 0, 0}, {0, 1, NAN},
        {INFINITY, 0, 0}, {1e300, 2e300, -2e300}};
    for (size_t i = 0; i < sizeof wishes / sizeof *wishes; i++) {
        kg_patch_input in = straight();
        in.ruling = wishes[i];
        assert_refused(&in, "ruling");
    }
    /* curved geodesics have their own rulings: the wish is not looked at */
    kg_patch_input in = arc;
    in.has_ruling = true;
    in.ruling = kg_v3(NAN, NAN, NAN);
    kg_patch p;
    assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
}

static void a_straight_geodesic_without_a_wish_has_some_ruling_across(void **state) {
    (void)state;
    for (int k = 0; k < 2; k++) {
        kg_patch_input in = arc;
        for (int i = 0; i < 4; i++)
            in.points[i] = k ? kg_v3(0, 0, i) : kg_v3(i, i, 0);
        kg_patch p;
        assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
        assert_int_equal(p.shape, KG_CURVE_STRAIGHT);
        assert_sound(&p);
        assert_near(kg_patch_ruling(&p, 0.5).cos_theta, 0, 1e-15);
    }
}

static void extreme_sizes_do_not_overflow(void **state) {
    (void)state;
    kg_random r = {1};
    const double sizes[] = {1e-100, 1e-30, 1e-6, 1e3, 9e5 / 120};
    for (int round = 0; round < 100; round++)
        for (size_t k = 0; k < 5; k++) {
            kg_patch_input in = random_input(&r, ARC, round & 1 ? 6 : 4);
            for (size_t i = 0; i < in.point_count; i++)
                in.points[i] = kg_scale(in.points[i], sizes[k]);
            in.extent[0] *= sizes[k], in.extent[1] *= sizes[k];
            kg_patch p;
            if (kg_patch_init(&in, &p, NULL) == KG_OK)
                assert_sound(&p);
        }
}

/* Any finite or broken numbers: an error or a sound patch, never NaN. */
static void random_garbage_gives_an_error_or_a_sound_patch(void **state) {
    (void)state;
    kg_random r = {2};
    int accepted = 0;
    const double coordinates[] = {0, 0, 1, -1, 2, 1e-9, 1e6, -1e-300, 3, 0.5};
    for (int round = 0; round < 5000; round++) {
        kg_patch_input in = {.point_count = kg_random_bits(&r) & 1 ? 4 : 6};
        for (size_t i = 0; i < in.point_count; i++)
            in.points[i] =
                kg_v3(coordinates[kg_random_bits(&r) % 10], coordinates[kg_random_bits(&r) % 10],
                      coordinates[kg_random_bits(&r) % 10]);
        in.extent[0] = -kg_random_in(&r, 0, 3), in.extent[1] = kg_random_in(&r, 0, 3);
        kg_patch p;
        kg_error error = {KG_OK, ""};
        if (kg_patch_init(&in, &p, &error) == KG_OK) {
            accepted++;
            assert_sound(&p);
        } else {
            assert_true(error.message[0]);
            assert_null(strstr(error.message, "nan"));
        }
    }
    assert_true(accepted > 100);
}

/* ---- thresholds -------------------------------------------------------------------------- */

/* In a slanted frame: x along, `bend` beside at both inner points, `twist` out of the plane. */
static kg_patch_input bent(double bend1, double bend2, double twist) {
    const kg_vec3 x = {0.6, 0.8, 0}, y = {-0.64, 0.48, 0.6}, z = kg_cross(x, y);
    const double a[4] = {0, 35, 70, 100}, b[4] = {0, bend1, bend2, 0}, c[4] = {0, twist, 0, 0};
    kg_patch_input in = {.point_count = 4, .extent = {-10, 10}};
    for (int i = 0; i < 4; i++)
        in.points[i] = kg_madd(kg_madd(kg_madd(kg_v3(10, 20, 30), a[i], x), b[i], y), c[i], z);
    return in;
}

/* Largest move of the unrolled rectangle between two patches, mm. */
static double moved(const kg_patch *a, const kg_patch *b) {
    double most = 0;
    for (int i = 0; i <= 50; i++)
        for (int k = 0; k < 2; k++)
            most = fmax(most, kg_dist2(kg_patch_unroll(a, a->extent[k], i / 50.0),
                                       kg_patch_unroll(b, b->extent[k], i / 50.0)));
    return most;
}

/* Relative error of the boundary's length on paper, by chords fine enough for 1e-7. */
static double stretch(const kg_patch *p) {
    double space = 0, paper = 0;
    for (int i = 0; i < 2000; i++) {
        double v = i / 2000.0, w = (i + 1) / 2000.0, u = p->extent[1];
        space += kg_dist(kg_patch_point(p, u, v), kg_patch_point(p, u, w));
        paper += kg_dist2(kg_patch_unroll(p, u, v), kg_patch_unroll(p, u, w));
    }
    return fabs(paper / space - 1);
}

/* How far, in mm, outlines a hundred long may move across a threshold: a few times its share of
 * the size, since a ruling tilts by the twist over the bend. */
#define JUMP (100 * 5 * KG_FLATNESS)

static void outlines_do_not_jump_between_planar_and_spatial_arcs(void **state) {
    (void)state;
    kg_patch planar, spatial;
    double twist = 1e-8;
    kg_patch_input in;
    do { /* up to the first spatial one */
        in = bent(30, 25, 100 * twist);
        assert_int_equal(kg_patch_init(&in, &spatial, NULL), KG_OK);
        if (spatial.shape == KG_CURVE_PLANAR)
            planar = spatial;
        twist *= 1.02;
    } while (spatial.shape == KG_CURVE_PLANAR);
    assert_true(twist > KG_FLATNESS && twist < 10 * KG_FLATNESS);
    assert_true(moved(&planar, &spatial) < JUMP);
    assert_true(stretch(&planar) < 1e-6 && stretch(&spatial) < 1e-6);
    /* and the ruling goes on the same way */
    assert_true(kg_dist(kg_patch_ruling(&planar, 0.5).d, kg_patch_ruling(&spatial, 0.5).d) < 1e-5);
}

static void outlines_do_not_jump_between_straight_and_planar(void **state) {
    (void)state;
    kg_patch before, after;
    kg_patch_input in = bent(0, 0, 0);
    assert_int_equal(kg_patch_init(&in, &before, NULL), KG_OK);
    bool straight_seen = false, planar_seen = false;
    for (double e = 1e-12; e < 1e-4; e *= 1.5) {
        in = bent(100 * e, 80 * e, 0);
        assert_int_equal(kg_patch_init(&in, &after, NULL), KG_OK);
        straight_seen |= after.shape == KG_CURVE_STRAIGHT;
        planar_seen |= after.shape == KG_CURVE_PLANAR;
        assert_int_equal(after.ruling_degree, 0);
        assert_false(after.clamped);
        assert_true(moved(&before, &after) < JUMP);
        assert_true(stretch(&after) < 1e-6);
        before = after;
    }
    assert_true(straight_seen && planar_seen);
}

/* Almost straight and twisted as much as bent, or an S with a twist: below the threshold a plain
 * strip, above it such curves bear no strip of any width, and the patch is refused or cut back to
 * what is true. There is no third way; but nothing in between is wrong or not a number. */
static void nearly_straight_and_twisted_is_true_or_refused(void **state) {
    (void)state;
    int accepted = 0, refused = 0;
    for (int kind = 0; kind < 3; kind++)
        for (double e = 1e-12; e < 1e-2; e *= 1.7) {
            kg_patch_input in = kind == 0   ? bent(100 * e, 100 * e, 100 * e)
                                : kind == 1 ? bent(30, -25, 100 * e)
                                            : bent(100 * e, 80 * e, 100 * e * e);
            kg_patch p;
            kg_error error;
            if (kg_patch_init(&in, &p, &error) != KG_OK) {
                refused++;
                assert_true(e > KG_FLATNESS);
                assert_non_null(strstr(error.message, "flatten"));
                continue;
            }
            accepted++;
            assert_sound(&p);
            assert_true(stretch(&p) < 1e-6);
            if (e < 0.5 * KG_FLATNESS)
                assert_false(p.clamped);
        }
    assert_true(accepted > 50 && refused > 5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_ordinary_patch_is_accepted),
        cmocka_unit_test(extents_that_are_no_interval_are_refused),
        cmocka_unit_test(an_extent_on_one_side_of_the_geodesic_is_fine),
        cmocka_unit_test(broken_control_points_are_refused),
        cmocka_unit_test(a_straight_geodesic_takes_the_wished_ruling_made_square),
        cmocka_unit_test(a_ruling_wish_that_is_none_is_refused),
        cmocka_unit_test(a_straight_geodesic_without_a_wish_has_some_ruling_across),
        cmocka_unit_test(extreme_sizes_do_not_overflow),
        cmocka_unit_test(random_garbage_gives_an_error_or_a_sound_patch),
        cmocka_unit_test(outlines_do_not_jump_between_planar_and_spatial_arcs),
        cmocka_unit_test(outlines_do_not_jump_between_straight_and_planar),
        cmocka_unit_test(nearly_straight_and_twisted_is_true_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
