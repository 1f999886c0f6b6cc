/* Pairs with a known answer, and the ugly ones. */
#include "tests/trim/pairs.h"

#define TOLERANCE 0.01

/* A bent sheet: a cubic arc of about the radius in the plane of x and y around `middle`, square
 * rulings along the plane's normal. Half-angle `half` radians. */
static kg_patch arc(kg_vec3 middle, kg_vec3 x, kg_vec3 y, double radius, double half, double lo,
                    double hi) {
    double k = 4.0 / 3 * tan(half / 2), c = cos(half), s = sin(half);
    double at[4][2] = {{c, -s}, {c + k * s, -s + k * c}, {c + k * s, s - k * c}, {c, s}};
    kg_vec3 p[4];
    for (int i = 0; i < 4; i++)
        p[i] = kg_madd(kg_madd(middle, radius * at[i][0], x), radius * at[i][1], y);
    return make_patch(p, 4, lo, hi, NULL);
}

/* A plane rectangle: geodesic from p along `along`, rulings in direction `ruling`. */
static kg_patch plane(kg_vec3 p, kg_vec3 along, kg_vec3 ruling, double lo, double hi) {
    kg_vec3 q[4];
    for (int i = 0; i < 4; i++)
        q[i] = kg_madd(p, i / 3.0, along);
    return make_patch(q, 4, lo, hi, &ruling);
}

static kg_crossings find(const kg_patch *a, const kg_patch *b) {
    kg_crossings found = {0};
    kg_error error = {0};
    if (kg_crossings_find(a, b, TOLERANCE, &found, &error))
        fail_msg("%s", error.message);
    check_points(a, b, &found, TOLERANCE);
    return found;
}

static void expect(const kg_patch *a, const kg_patch *b, size_t count) {
    kg_crossings found = find(a, b), back = find(b, a);
    assert_int_equal(found.count, count);
    kg_crossings_swap(&back);
    assert_int_equal(back.count, found.count);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(back.branches[i].count, found.branches[i].count);
    kg_crossings_clear(&found);
    kg_crossings_clear(&back);
}

static void expect_coincident(const kg_patch *a, const kg_patch *b) {
    kg_crossings found = {.count = 77};
    kg_error error = {0};
    assert_int_equal(kg_crossings_find(a, b, TOLERANCE, &found, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "coincide"));
    assert_int_equal(found.count, 77);
}

static const kg_vec3 X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1}, O = {0, 0, 0};

/* ---- planes and cylinders -------------------------------------------------------------- */

static void two_planes_cross_in_a_segment(void **state) {
    (void)state;
    kg_patch a = plane(kg_v3(-50, 0, 0), kg_v3(100, 0, 0), Y, -30, 30);
    kg_patch b = plane(kg_v3(0, -50, 3), kg_v3(0, 100, 0), Z, -20, 20);
    kg_crossings found = find(&a, &b);
    assert_int_equal(found.count, 1);
    const kg_crossing *c = &found.branches[0];
    assert_near(kg_dist(c->points[0].x, c->points[c->count - 1].x), 60, 1e-9);
    assert_true((c->ends[0] | c->ends[1]) == (KG_SIDE_A_U_LO | KG_SIDE_A_U_HI));
    kg_crossings_clear(&found);
}

static void plane_cuts_cylinder_in_an_ellipse_arc(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 1.2, -60, 60);
    /* the plane z = x - 40 */
    kg_patch b = plane(kg_v3(0, -80, -40), kg_v3(0, 160, 0), kg_unit(kg_v3(1, 0, 1)), -10, 200);
    kg_crossings found = find(&a, &b);
    assert_int_equal(found.count, 1);
    for (size_t i = 0; i < found.branches[0].count; i++) {
        kg_vec3 x = found.branches[0].points[i].x;
        assert_near(x.z, x.x - 40, 1e-9);
    }
    assert_true(found.branches[0].ends[0] == KG_SIDE_A_V_LO &&
                found.branches[0].ends[1] == KG_SIDE_A_V_HI);
    kg_crossings_clear(&found);
}

static void parallel_cylinders_cross_as_often_as_their_sections(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 1.2, -20, 30);
    kg_patch none = arc(kg_v3(150, 0, 0), kg_neg(X), Y, 50, 1.2, -20, 30);
    kg_patch one = arc(kg_v3(20, 40, 0), X, Y, 50, 1.2, -10, 60);
    kg_patch two = arc(kg_v3(70, 0, 0), kg_neg(X), Y, 50, 1.2, -20, 30);
    expect(&a, &none, 0);
    expect(&a, &one, 1);
    expect(&a, &two, 2);
    /* an S against a line: three */
    kg_vec3 s[4] = {{-50, -20, 0}, {-10, 60, 0}, {10, -60, 0}, {50, 20, 0}};
    kg_patch wave = make_patch(s, 4, -20, 30, NULL);
    kg_patch line = plane(kg_v3(-60, 0, 0), kg_v3(120, 0, 0), Z, -25, 15);
    expect(&wave, &line, 3);
    kg_crossings found = find(&wave, &line);
    for (size_t i = 0; i < found.count; i++) {
        assert_int_equal(found.branches[i].count, 2);
        assert_true(found.branches[i].points[0].v == found.branches[i].points[1].v);
    }
    kg_crossings_clear(&found);
}

static void parallel_cylinders_that_miss_each_other_along_u(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 1.2, -20, 30);
    kg_patch above = arc(kg_v3(70, 0, 100), kg_neg(X), Y, 50, 1.2, -20, 30);
    expect(&a, &above, 0);
}

static void equal_cylinders_at_right_angles_cross_in_two_points(void **state) {
    (void)state;
    /* Steinmetz: two ellipses that meet where the cylinders touch, at x = 50 */
    kg_patch a = arc(O, X, Y, 50, 0.9, -60, 60), b = arc(O, X, Z, 50, 0.9, -60, 60);
    kg_crossings found = find(&a, &b);
    assert_int_equal(found.count, 4);
    for (size_t i = 0; i < 4; i++) {
        const kg_crossing *c = &found.branches[i];
        assert_true((c->ends[0] == 0) != (c->ends[1] == 0));
        const kg_cross_point *p = c->ends[0] == 0 ? &c->points[0] : &c->points[c->count - 1];
        /* (the arc is only a cubic: its middle is a little off the radius) */
        assert_near(p->v, 0.5, 1e-9);
        assert_near(p->t, 0.5, 1e-9);
        assert_near(kg_dist(p->x, kg_patch_point(&a, 0, 0.5)), 0, 1e-7);
    }
    kg_crossings_clear(&found);
}

static void bent_away_from_each_other_they_cross_in_a_closed_curve(void **state) {
    (void)state;
    kg_patch a = arc(kg_v3(100, 0, 0), kg_neg(X), Y, 50, 1.2, -60, 60);
    kg_patch b = arc(kg_v3(30, 0, 0), X, Z, 21, 1.5, -60, 60);
    kg_crossings found = find(&a, &b);
    assert_int_equal(found.count, 1);
    assert_true(found.branches[0].closed);
    kg_crossings_clear(&found);
}

/* ---- touching -------------------------------------------------------------------------- */

static void tangent_plane_only_touches(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 1.2, -60, 60);
    kg_vec3 top = kg_patch_point(&a, 0, 0.5);
    kg_patch along = plane(kg_madd(top, -40, Y), kg_v3(0, 80, 0), Z, -30, 30);
    kg_patch across = plane(kg_madd(top, -40, Z), kg_v3(0, 0, 80), Y, -30, 30);
    kg_patch slanted = plane(kg_madd(top, -40, Z), kg_v3(0, 30, 80), Y, -30, 30);
    expect(&a, &along, 0);
    expect(&a, &across, 0);
    expect(&a, &slanted, 0);
}

static void rectangles_that_touch_at_a_corner(void **state) {
    (void)state;
    kg_patch a = plane(O, kg_v3(100, 0, 0), Y, 0, 30);
    kg_patch b = plane(O, kg_v3(-70, 0, 10), kg_v3(0, -1, 2), 0, 20);
    expect(&a, &b, 0);
}

/* ---- along rulings --------------------------------------------------------------------- */

static void plane_through_a_ruling(void **state) {
    (void)state;
    kg_vec3 p[4] = {{0, 0, 0}, {30, 10, 2}, {60, 10, 9}, {90, -10, 20}};
    kg_patch a = make_patch(p, 4, -20, 25, NULL);
    for (int i = 0; i <= 4; i++) {
        double v = 0.25 * i;
        kg_ruling r = kg_patch_ruling(&a, v);
        /* a plane that holds the ruling and is square to the surface there: by rulings along it,
         * and by rulings across it */
        kg_vec3 from = kg_madd(r.p, -60, r.normal);
        kg_patch along = plane(from, kg_scale(r.normal, 120), r.d, -30, 30);
        kg_patch across = plane(kg_madd(r.p, -40, r.d), kg_scale(r.d, 80), r.normal, -60, 60);
        kg_patch *cutter[2] = {&along, &across};
        for (int k = 0; k < 2; k++) {
            kg_crossings found = find(&a, cutter[k]);
            size_t hits = 0;
            for (size_t j = 0; j < found.count; j++) {
                const kg_crossing *c = &found.branches[j];
                if (fabs(c->points[0].v - v) < 1e-8 && fabs(c->points[c->count - 1].v - v) < 1e-8) {
                    hits++;
                    assert_near(kg_dist(c->points[0].x, c->points[c->count - 1].x), 45, 1e-6);
                }
            }
            if (hits != 1)
                fail_msg("cutter %d at v = %g: %zu branches, %zu along the ruling", k, v,
                         found.count, hits);
            kg_crossings_clear(&found);
        }
    }
}

/* ---- coincidence ----------------------------------------------------------------------- */

static void coincident_surfaces_are_refused(void **state) {
    (void)state;
    kg_vec3 p[4] = {{0, 0, 0}, {30, 10, 2}, {60, 10, 9}, {90, -10, 20}};
    kg_patch a = make_patch(p, 4, -20, 25, NULL), longer = make_patch(p, 4, -30, 40, NULL);
    expect_coincident(&a, &a);
    expect_coincident(&a, &longer);
    kg_curve part = kg_curve_segment(&a.geodesic, 0.31, 0.77);
    kg_patch piece = make_patch(part.points, 4, -10, 15, NULL);
    expect_coincident(&a, &piece);
    expect_coincident(&piece, &a);
    kg_patch cylinder = arc(O, X, Y, 50, 1.2, -60, 60);
    part = kg_curve_segment(&cylinder.geodesic, 0.2, 0.6);
    piece = make_patch(part.points, 4, -10, 15, NULL);
    expect_coincident(&cylinder, &cylinder);
    expect_coincident(&cylinder, &piece);
    kg_patch flat = plane(O, kg_v3(100, 0, 0), Y, 0, 30);
    kg_patch turned = plane(kg_v3(10, 10, 0), kg_v3(50, 50, 0), kg_v3(1, -1, 0), -5, 9);
    expect_coincident(&flat, &turned);
    expect_coincident(&flat, &flat);
}

static void coplanar_rectangles_apart_do_not_cross(void **state) {
    (void)state;
    kg_patch a = plane(O, kg_v3(100, 0, 0), Y, 0, 30);
    kg_patch b = plane(kg_v3(0, 40, 0), kg_v3(100, 0, 0), Y, 0, 30);
    kg_patch c = plane(kg_v3(110, -30, 0), kg_v3(50, 80, 0), kg_v3(1, -1, 0), -15, 9);
    kg_patch neighbour = plane(kg_v3(0, 30, 0), kg_v3(100, 0, 0), Y, 0, 30);
    expect(&a, &b, 0);
    expect(&a, &c, 0);
    expect(&a, &neighbour, 0);
}

static void same_cylinder_apart_does_not_cross(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 1.2, -60, 60);
    kg_curve part = kg_curve_segment(&a.geodesic, 0, 0.4);
    kg_patch lo = make_patch(part.points, 4, -10, 15, NULL);
    part = kg_curve_segment(&a.geodesic, 0.6, 1);
    kg_patch hi = make_patch(part.points, 4, -10, 15, NULL);
    expect(&lo, &hi, 0);
}

/* ---- near-singular --------------------------------------------------------------------- */

static void branches_that_nearly_meet_stay_apart_or_join(void **state) {
    (void)state;
    kg_patch a = arc(O, X, Y, 50, 0.9, -60, 60);
    double gaps[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6};
    for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++)
        for (int side = -1; side <= 1; side += 2) {
            kg_patch b = arc(kg_v3(side * gaps[i], 0, 0), X, Z, 50, 0.9, -60, 60);
            kg_crossings found = find(&a, &b);
            assert_true(found.count == 2 || (gaps[i] <= 1e-5 && found.count == 4));
            check_against_rays(&a, &b, &found, TOLERANCE, "nearly meeting");
            kg_crossings_clear(&found);
        }
}

/* ---- size and place -------------------------------------------------------------------- */

static void far_from_the_origin(void **state) {
    (void)state;
    kg_random r = {5};
    for (int i = 0; i < 20; i++) {
        kg_vec3 far = kg_v3(1e5, -7e4, 5e4);
        kg_patch a = random_patch(&r, (pair_kind)(i % 3), far);
        kg_patch b = random_patch(&r, (pair_kind)(i % 5), kg_add(far, kg_v3(3, 5, -8)));
        kg_crossings found = find(&a, &b);
        check_against_rays(&a, &b, &found, TOLERANCE, "far");
        kg_crossings_clear(&found);
    }
}

static kg_patch scaled(const kg_patch *p, double f) {
    kg_vec3 q[KG_CURVE_MAX_POINTS];
    for (int i = 0; i <= p->geodesic.degree; i++)
        q[i] = kg_scale(p->geodesic.points[i], f);
    return make_patch(q, (size_t)p->geodesic.degree + 1, f * p->extent[0], f * p->extent[1],
                      &p->rulings[0]);
}

static void tiny_and_huge_models_have_the_same_branches(void **state) {
    (void)state;
    kg_random r = {6};
    for (int i = 0; i < 20; i++) {
        kg_patch a = random_patch(&r, (pair_kind)(i % 4), O);
        kg_patch b = random_patch(&r, (pair_kind)(i % 5), kg_v3(3, 5, -8));
        kg_crossings found = find(&a, &b);
        for (int k = 0; k < 2; k++) {
            double f = k ? 5000 : 1e-3;
            kg_patch sa = scaled(&a, f), sb = scaled(&b, f);
            kg_crossings other = {0};
            assert_int_equal(kg_crossings_find(&sa, &sb, TOLERANCE * f, &other, NULL), KG_OK);
            check_points(&sa, &sb, &other, TOLERANCE * f);
            assert_int_equal(other.count, found.count);
            for (size_t j = 0; j < found.count; j++)
                assert_near(other.branches[j].points[0].v, found.branches[j].points[0].v, 1e-9);
            kg_crossings_clear(&other);
        }
        kg_crossings_clear(&found);
    }
}

static void planar_inflection_gives_no_false_branch(void **state) {
    (void)state;
    /* D has a triple root in the middle: taken at its word it crosses everything there */
    kg_vec3 s[4] = {{-50, -20, 0}, {-10, 30, 0}, {10, -30, 0}, {50, 20, 0}};
    kg_patch a = make_patch(s, 4, -20, 30, NULL);
    kg_patch b = plane(kg_v3(-60, 0, 3), kg_v3(120, 0, 1), Y, -40, 40);
    expect(&a, &b, 1);
    kg_patch away = plane(kg_v3(-60, 0, 300), kg_v3(120, 0, 1), Y, -40, 40);
    expect(&a, &away, 0);
}

static void tangent_plane_at_an_inflection_crosses_along_the_ruling(void **state) {
    (void)state;
    kg_vec3 s[4] = {{-50, -20, 0}, {-10, 30, 0}, {10, -30, 0}, {50, 20, 0}};
    kg_patch a = make_patch(s, 4, -20, 30, NULL);
    kg_ruling r = kg_patch_ruling(&a, 0.5);
    kg_vec3 t = kg_scale(r.dp, 1 / r.speed);
    kg_patch across = plane(kg_madd(r.p, -5, Z), kg_scale(Z, 10), t, -10, 10);
    kg_crossings found = {0};
    assert_int_equal(kg_crossings_find(&a, &across, TOLERANCE, &found, NULL), KG_OK);
    assert_int_equal(found.count, 1);
    kg_crossings_clear(&found);
}

static void mirrored_patches_meet_in_the_mirror(void **state) {
    (void)state;
    kg_random r = {8};
    size_t branches = 0;
    for (int i = 0; i < 40; i++) {
        kg_patch a = random_patch(&r, (pair_kind)(i % 5), kg_v3(0, kg_random_in(&r, -20, 20), 0));
        kg_vec3 q[KG_CURVE_MAX_POINTS], d = a.rulings[0];
        d.y = -d.y;
        for (int k = 0; k <= a.geodesic.degree; k++) {
            q[k] = a.geodesic.points[k];
            q[k].y = -q[k].y;
        }
        size_t count = (size_t)a.geodesic.degree + 1;
        kg_patch b = make_patch(q, count, a.extent[0], a.extent[1], &d);
        /* the ruling of a mirrored curve is the mirrored one reversed */
        kg_vec3 x = kg_patch_point(&a, 10, 0.3), y = kg_patch_point(&b, 10, 0.3);
        if (fabs(x.y + y.y) > 1e-6)
            b = make_patch(q, count, -a.extent[1], -a.extent[0], &d);
        kg_crossings found = find(&a, &b);
        check_against_rays(&a, &b, &found, TOLERANCE, "mirrored");
        for (size_t k = 0; k < found.count; k++) {
            bool mirror = true;
            for (size_t j = 0; j < found.branches[k].count; j++)
                mirror &= fabs(found.branches[k].points[j].x.y) < 1e-9;
            branches += mirror;
        }
        kg_crossings_clear(&found);
    }
    assert_true(branches > 10);
}

static void tangents_are_rounding_where_mirrored_patches_cross_twice(void **state) {
    (void)state;
    /* the curve in the mirror meets another one; an arc passes within 1e-8 of the meeting point */
    const kg_vec3 p[4] = {{0, 4.6411685459588607, 0.87196347750467074},
                          {33.333333333333329, 8.0908738619237575, 7.499476577623458},
                          {66.666666666666657, 11.779539533858346, 6.2072161837573399},
                          {100, 10.563754052817437, 0.69189388049412437}};
    kg_vec3 q[4];
    for (int i = 0; i < 4; i++)
        q[i] = kg_v3(p[i].x, -p[i].y, p[i].z);
    kg_patch a = make_patch(p, 4, -30, 30, NULL), b = make_patch(q, 4, -30, 30, NULL);
    const double tolerances[] = {1, 1e-2, 1e-3, 1e-5, 1e-9, 1e-300};
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances; i++) {
        kg_crossings found = {0};
        size_t points = 0;
        assert_int_equal(kg_crossings_find(&a, &b, tolerances[i], &found, NULL), KG_OK);
        double exact = fmax(tolerances[i], 1e-6 * a.size);
        check_points(&a, &b, &found, exact);
        check_against_rays(&a, &b, &found, exact, "mirrored");
        for (size_t k = 0; k < found.count; k++)
            points += found.branches[k].count;
        assert_in_range(points, 10, 1000);
        kg_crossings_clear(&found);
    }
}

static void pieces_of_one_patch_side_by_side_do_not_cross(void **state) {
    (void)state;
    kg_random r = {9};
    for (int i = 0; i < 20; i++) {
        kg_patch a = random_patch(&r, (pair_kind)(i % 4), O);
        kg_patch part[2];
        for (int k = 0; k < 2; k++) {
            kg_curve c = kg_curve_segment(&a.geodesic, k ? 0.55 : 0, k ? 1 : 0.55);
            part[k] = make_patch(c.points, (size_t)c.degree + 1, a.extent[0], a.extent[1], NULL);
        }
        expect(&part[0], &part[1], 0);
    }
}

static void folded_neighbours_share_their_ruling(void **state) {
    (void)state;
    /* two planes that meet in an edge, and a plane on the last ruling of a bent patch */
    kg_patch a = plane(O, kg_v3(100, 0, 0), Y, -10, 30);
    kg_patch b = plane(O, kg_v3(70, 0, 70), Y, -10, 30);
    expect(&a, &b, 1);
    kg_vec3 p[4] = {{0, 0, 0}, {30, 10, 2}, {60, 10, 9}, {90, -10, 20}};
    kg_patch bent = make_patch(p, 4, -20, 25, NULL);
    kg_ruling r = kg_patch_ruling(&bent, 1);
    kg_patch flap = plane(r.p, kg_scale(r.normal, 50), r.d, -20, 25);
    kg_crossings found = find(&bent, &flap);
    assert_int_equal(found.count, 1);
    assert_near(kg_dist(found.branches[0].points[0].x,
                        found.branches[0].points[found.branches[0].count - 1].x),
                45, 1e-6);
    kg_crossings_clear(&found);
}

static void impossible_tolerances_are_refused(void **state) {
    (void)state;
    kg_patch a = plane(O, kg_v3(100, 0, 0), Y, 0, 30);
    kg_crossings found;
    kg_error error;
    assert_int_equal(kg_crossings_find(&a, &a, 0, &found, &error), KG_ERR_INPUT);
    assert_int_equal(kg_crossings_find(&a, &a, (double)NAN, &found, &error), KG_ERR_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_planes_cross_in_a_segment),
        cmocka_unit_test(plane_cuts_cylinder_in_an_ellipse_arc),
        cmocka_unit_test(parallel_cylinders_cross_as_often_as_their_sections),
        cmocka_unit_test(parallel_cylinders_that_miss_each_other_along_u),
        cmocka_unit_test(equal_cylinders_at_right_angles_cross_in_two_points),
        cmocka_unit_test(bent_away_from_each_other_they_cross_in_a_closed_curve),
        cmocka_unit_test(tangent_plane_only_touches),
        cmocka_unit_test(rectangles_that_touch_at_a_corner),
        cmocka_unit_test(plane_through_a_ruling),
        cmocka_unit_test(coincident_surfaces_are_refused),
        cmocka_unit_test(coplanar_rectangles_apart_do_not_cross),
        cmocka_unit_test(same_cylinder_apart_does_not_cross),
        cmocka_unit_test(branches_that_nearly_meet_stay_apart_or_join),
        cmocka_unit_test(far_from_the_origin),
        cmocka_unit_test(tiny_and_huge_models_have_the_same_branches),
        cmocka_unit_test(planar_inflection_gives_no_false_branch),
        cmocka_unit_test(tangent_plane_at_an_inflection_crosses_along_the_ruling),
        cmocka_unit_test(mirrored_patches_meet_in_the_mirror),
        cmocka_unit_test(tangents_are_rounding_where_mirrored_patches_cross_twice),
        cmocka_unit_test(pieces_of_one_patch_side_by_side_do_not_cross),
        cmocka_unit_test(folded_neighbours_share_their_ruling),
        cmocka_unit_test(impossible_tolerances_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
