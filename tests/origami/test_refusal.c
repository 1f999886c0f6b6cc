/* What paper cannot do, and where exactly it touches. */
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>

static void assert_touches_at(const kg_error *error, double degrees) {
    const char *at = strstr(error->message, " at ");
    if (!strstr(error->message, "pass through paper") || !at)
        fail_msg("%s", error->message);
    assert_near(strtod(at + 4, NULL), degrees, 0.05);
}

/* A square of 100 whose strip x > 70 stands up as a wall 30 high. */
static kg_origami *walled_sheet(void) {
    kg_origami *o = square_sheet(100);
    must_fold(o, fold_axis(kg_v3(70, 0, 0), kg_v3(70, 100, 0), kg_v3(100, 0, 0), 90));
    return o;
}

static kg_fold fold_left(double x, double angle) {
    return fold_axis(kg_v3(x, 0, 0), kg_v3(x, 100, 0), kg_v3(0, 0, 0), angle);
}

static void test_edge_meets_a_raised_face(void **user) {
    (void)user;
    kg_origami *o = walled_sheet();
    kg_error error;
    /* its edge, 40 from the axis, comes down on the wall 30 behind it */
    must_refuse(o, fold_left(40, 180), &error);
    assert_touches_at(&error, 180 - acos(30.0 / 40) * 180 / KG_PI);
    /* up to there it is free */
    must_fold(o, fold_left(40, 138));
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
}

static void test_face_meets_a_raised_edge(void **user) {
    (void)user;
    kg_origami *o = walled_sheet();
    kg_error error;
    must_refuse(o, fold_left(50, 180), &error);
    assert_touches_at(&error, 180 - atan2(30, 20) * 180 / KG_PI);
    /* away from it, to the other side, and where it is too short */
    must_fold(o, fold_left(50, -180));
    assert_true(kg_origami_undo(o));
    must_fold(o, fold_left(30, 180));
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
}

static void test_corner_meets_a_face(void **user) {
    (void)user;
    kg_origami *o = walled_sheet();
    kg_error error;
    /* the corner (0,0) goes over a slanting axis to beyond the wall */
    kg_fold f = fold_to(kg_v3(0, 0, 0), kg_v3(80, 40, 0), 180);
    must_refuse(o, f, &error);
    /* it moves on a circle about the axis through (40,20); at height z it passes x = 70 */
    double radius = hypot(40, 20), x = (70 - 40) / (40 / radius);
    assert_touches_at(&error, 180 - acos(x / radius) * 180 / KG_PI);
    kg_origami_destroy(o);
}

static void test_two_sheets_through_each_other(void **user) {
    (void)user;
    kg_origami *o = kg_origami_create();
    kg_error error;
    add_rectangle(o, 0, 0, 100, 100);
    add_rectangle(o, 120, 0, 100, 100);
    must_fold(o, fold_axis(kg_v3(70, 0, 0), kg_v3(70, 100, 0), kg_v3(100, 0, 0), 90));
    must_refuse(o, fold_axis(kg_v3(130, 0, 0), kg_v3(130, 100, 0), kg_v3(220, 0, 0), 180), &error);
    assert_touches_at(&error, 180 - atan2(30, 60) * 180 / KG_PI);
    kg_origami_destroy(o);
}

static void test_leaves_close_and_do_not_pass(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    kg_error error;
    must_fold(o, fold_axis(kg_v3(50, 0, 0), kg_v3(50, 100, 0), kg_v3(100, 0, 0), 60));
    must_refuse(o, fold_left(50, 130), &error);
    assert_touches_at(&error, 120);
    must_fold(o, fold_left(50, 120));
    assert_int_equal(kg_origami_pair_count(last(o)), 1);
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
}

static void test_a_wall_across_the_axis_cannot_bend(void **user) {
    (void)user;
    kg_origami *o = walled_sheet();
    kg_error error;
    must_refuse(o, fold_axis(kg_v3(0, 50, 0), kg_v3(70, 50, 0), kg_v3(0, 100, 0), 180), &error);
    assert_non_null(strstr(error.message, "would have to move"));
    kg_origami_destroy(o);
}

static void test_wishes_that_make_no_fold(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    kg_error error;
    must_refuse(o, fold_to(kg_v3(50, 50, 0), kg_v3(0, 0, 0), 180), &error);
    assert_non_null(strstr(error.message, "no vertex"));
    must_refuse(o, fold_to(kg_v3(0, 0, 0), kg_v3(0, 0, 0), 180), &error);
    must_refuse(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 0), &error);
    must_refuse(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 181), &error);
    must_refuse(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), NAN), &error);
    must_refuse(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 50), 180), &error);
    must_refuse(o, fold_axis(kg_v3(-10, 0, 0), kg_v3(-10, 9, 0), kg_v3(0, 0, 0), 180), &error);
    assert_non_null(strstr(error.message, "whole paper"));
    kg_fold f = fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 180);
    f.layers = 2;
    must_refuse(o, f, &error);
    f.layers = 0, f.face = 7;
    must_refuse(o, f, &error);
    kg_origami_destroy(o);
}

/* ---- between layers --------------------------------------------------------------------- */

/* A strip folded in half with its crease at x = 50, and another beside its open end. */
static kg_origami *pocket(void) {
    kg_origami *o = kg_origami_create();
    add_rectangle(o, 0, 0, 100, 60);
    add_rectangle(o, 110, 10, 90, 40);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 0, 0), 180));
    return o;
}

static kg_fold fold_tongue(double axis, bool between) {
    kg_fold f = fold_axis(kg_v3(axis, 10, 0), kg_v3(axis, 50, 0), kg_v3(200, 10, 0), 180);
    if (between)
        f.between[0] = 0, f.between[1] = 2;
    return f;
}

static void test_a_tongue_goes_into_a_pocket(void **user) {
    (void)user;
    kg_origami *o = pocket();
    must_fold(o, fold_tongue(130, true));
    const kg_origami_state *s = last(o);
    assert_sound(s, 1e-9);
    int32_t tongue = (int32_t)s->loops.count - 1;
    assert_int_equal(kg_origami_order(s, 0, tongue), 1); /* above the lower half */
    assert_int_equal(kg_origami_order(s, 0, 2), 1);
    assert_int_equal(kg_origami_order(s, 2, tongue), 1); /* on the front, inside, of the upper */
    kg_origami_destroy(o);
}

static void test_a_pocket_is_closed_at_its_crease(void **user) {
    (void)user;
    kg_origami *o = pocket();
    kg_error error;
    must_refuse(o, fold_tongue(120, true), &error); /* would reach x = 40 */
    assert_non_null(strstr(error.message, "joined"));
    must_fold(o, fold_tongue(120, false)); /* outside it may */
    assert_sound(last(o), 1e-9);
    kg_origami_destroy(o);
}

static void test_a_fold_taken_out_leaves_the_others(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100), *direct = square_sheet(100);
    kg_error error;
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(20, 20, 0), 180));
    must_fold(o, fold_to(kg_v3(100, 100, 0), kg_v3(80, 80, 0), 180));
    must_fold(o, fold_to(kg_v3(80, 80, 0), kg_v3(90, 90, 0), 180));
    must_fold(direct, *kg_origami_fold_at(o, 1));
    must_fold(direct, *kg_origami_fold_at(o, 2));
    assert_int_equal(kg_origami_unfold(o, 1, &error), KG_ERR_INPUT); /* the third needs it */
    assert_int_equal(kg_origami_step(o), 3);
    assert_int_equal(kg_origami_unfold(o, 0, &error), KG_OK);
    assert_int_equal(kg_origami_step(o), 2);
    assert_true(same_state(last(o), last(direct)));
    kg_origami_destroy(o);
    kg_origami_destroy(direct);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_edge_meets_a_raised_face),
        cmocka_unit_test(test_face_meets_a_raised_edge),
        cmocka_unit_test(test_corner_meets_a_face),
        cmocka_unit_test(test_two_sheets_through_each_other),
        cmocka_unit_test(test_leaves_close_and_do_not_pass),
        cmocka_unit_test(test_a_wall_across_the_axis_cannot_bend),
        cmocka_unit_test(test_wishes_that_make_no_fold),
        cmocka_unit_test(test_a_tongue_goes_into_a_pocket),
        cmocka_unit_test(test_a_pocket_is_closed_at_its_crease),
        cmocka_unit_test(test_a_fold_taken_out_leaves_the_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
