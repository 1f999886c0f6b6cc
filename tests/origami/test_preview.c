/* Folds worked out without doing them: what moves, what is to blame, where they could end between.
 */
#include "tests/check.h"
#include "tests/origami/samples.h"

#include <stdlib.h>

static void assert_point(kg_vec3 p, double x, double y, double z) {
    assert_near(p.x, x, 1e-9);
    assert_near(p.y, y, 1e-9);
    assert_near(p.z, z, 1e-9);
}

static kg_fold_preview must_show(const kg_origami_state *s, kg_fold fold) {
    kg_fold_preview p;
    kg_error error = {0};
    if (kg_fold_preview_make(s, &fold, &p, &error))
        fail_msg("%s", error.message);
    return p;
}

static void test_the_moving_part_is_what_lies_beyond_the_axis(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    kg_fold fold = fold_to(kg_v3(0, 0, 0), kg_v3(40, 0, 0), 180);
    kg_fold_preview p = must_show(last(o), fold);
    assert_int_equal(p.part_count, 1);
    assert_int_equal(p.starts[1], 4);
    assert_int_equal(p.crease_count, 1);
    for (size_t i = 0; i < 4; i++)
        assert_true(p.points[i].x <= 20 + 1e-9);
    assert_point(kg_fold_preview_turn(&p, kg_v3(0, 0, 0), 1), 40, 0, 0);
    assert_point(kg_fold_preview_turn(&p, kg_v3(0, 0, 0), 0.5), 20, 0, 20);
    assert_near(kg_dist(p.creases[0], p.creases[1]), 100, 1e-9);
    assert_int_equal(kg_origami_step(o), 0);
    kg_fold_preview_clear(&p);
    kg_origami_destroy(o);
}

/* Every number of layers moves what that many layers move when they are folded. */
static void test_layers_are_counted_from_the_top(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 0, 0), 180));
    must_fold(o, fold_to(kg_v3(100, 0, 0), kg_v3(100, 100, 0), 180));
    kg_fold fold = fold_axis(kg_v3(100, 75, 0), kg_v3(75, 100, 0), kg_v3(100, 100, 0), 180);
    kg_fold_preview all = must_show(last(o), fold);
    assert_int_equal(all.layer_count, 4);
    for (int32_t n = 1; n <= all.layer_count; n++) {
        fold.layers = n;
        kg_fold_preview p;
        kg_status status = kg_fold_preview_make(last(o), &fold, &p, NULL);
        assert_true(status == KG_OK || status == KG_ERR_INPUT);
        size_t moving = 0;
        for (size_t i = 0; i < last(o)->loops.count; i++)
            moving += all.layers[i] > 0 && all.layers[i] <= n;
        assert_int_equal(p.part_count, moving);
        kg_fold_preview_clear(&p);
    }
    fold.layers = all.layer_count + 1;
    kg_fold_preview p;
    kg_error error;
    assert_int_equal(kg_fold_preview_make(last(o), &fold, &p, &error), KG_ERR_INPUT);
    kg_fold_preview_clear(&p);
    kg_fold_preview_clear(&all);
    kg_origami_destroy(o);
}

static void test_a_face_in_the_way_is_named(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    must_fold(o, fold_axis(kg_v3(70, 0, 0), kg_v3(70, 100, 0), kg_v3(100, 0, 0), 90));
    kg_fold fold = fold_axis(kg_v3(40, 0, 0), kg_v3(40, 100, 0), kg_v3(0, 0, 0), 180);
    kg_fold_preview p;
    kg_error error;
    assert_int_equal(kg_fold_preview_make(last(o), &fold, &p, &error), KG_ERR_INPUT);
    assert_int_equal(p.fault, KG_FOLD_IN_WAY);
    assert_near(p.meets_deg, 180 - acos(30.0 / 40) * 180 / KG_PI, 1e-3);
    assert_near(fabs(kg_origami_normal(last(o), p.faces[1]).x), 1, 1e-9); /* the wall */
    assert_true(p.has_axis && p.part_count == 1);
    kg_fold_preview_clear(&p);
    /* without axis nothing is known */
    fold.vertex = kg_v3(33, 33, 33);
    assert_int_equal(kg_fold_preview_make(last(o), &fold, &p, &error), KG_ERR_INPUT);
    assert_false(p.has_axis);
    kg_fold_preview_clear(&p);
    kg_origami_destroy(o);
}

static void test_the_only_gap_of_a_pocket_is_found(void **user) {
    (void)user;
    kg_origami *o = kg_origami_create();
    add_rectangle(o, 0, 0, 100, 60);
    add_rectangle(o, 110, 10, 90, 40);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 0, 0), 180));
    kg_fold fold = fold_axis(kg_v3(130, 10, 0), kg_v3(130, 50, 0), kg_v3(200, 10, 0), 180);
    kg_fold_gap *gaps;
    size_t count;
    kg_error error;
    assert_int_equal(kg_fold_gaps(last(o), &fold, &gaps, &count, &error), KG_OK);
    assert_int_equal(count, 1);
    assert_int_equal(gaps[0].depth, 1);
    fold.between[0] = gaps[0].lower, fold.between[1] = gaps[0].upper;
    free(gaps);
    must_fold(o, fold);
    int32_t strip = (int32_t)last(o)->loops.count - 1;
    assert_int_equal(kg_origami_order(last(o), fold.between[0], strip),
                     -kg_origami_order(last(o), fold.between[1], strip) *
                         (kg_origami_normal(last(o), fold.between[0]).z *
                                      kg_origami_normal(last(o), fold.between[1]).z >
                                  0
                              ? 1
                              : -1));
    kg_origami_destroy(o);
}

/* A flap goes between any two sheets of a pile: those on top are offered, and are what they say. */
static void test_gaps_of_a_tall_pile_are_the_uppermost(void **user) {
    (void)user;
    enum { SHEETS = 130 };
    kg_origami *o = kg_origami_create();
    add_rectangle(o, 0, 0, 100, 60);
    for (int i = 0; i < SHEETS; i++)
        add_rectangle(o, 0, 0, 50, 50);
    kg_fold fold = fold_axis(kg_v3(60, 0, 0), kg_v3(60, 60, 0), kg_v3(100, 0, 0), 180);
    kg_fold_gap *gaps;
    size_t count;
    kg_error error;
    assert_int_equal(kg_fold_gaps(last(o), &fold, &gaps, &count, &error), KG_OK);
    assert_int_equal(count, 64);
    for (int i = 0; i < 64; i++) {
        assert_int_equal(gaps[i].depth, i + 1);
        assert_int_equal(gaps[i].upper, SHEETS - i);
        assert_int_equal(gaps[i].lower, SHEETS - i - 1);
    }
    fold.between[0] = gaps[40].lower, fold.between[1] = gaps[40].upper;
    free(gaps);
    must_fold(o, fold);
    for (int32_t i = 1; i <= SHEETS; i++)
        assert_int_equal(kg_origami_order(last(o), i, SHEETS + 1), i <= SHEETS - 41 ? 1 : -1);
    kg_origami_destroy(o);
}

static void test_random_previews_agree_with_folding(void **user) {
    (void)user;
    kg_random random = {7};
    for (int round = 0; round < 40; round++) {
        kg_origami *o = square_sheet(100);
        for (int i = 0; i < 6; i++) {
            const kg_origami_state *s = last(o);
            size_t v = kg_random_bits(&random) % s->vertices.count;
            double x = kg_random_in(&random, 0, 100), y = kg_random_in(&random, 0, 100);
            double angle = kg_random_bits(&random) % 2 ? 180 : -120;
            kg_fold fold = fold_to(s->vertices.items[v].position, kg_v3(x, y, 0), angle);
            fold.layers = 1 + (int32_t)(kg_random_bits(&random) % 2);
            kg_fold_preview p;
            kg_error said = {0}, done = {0};
            kg_status status = kg_fold_preview_make(s, &fold, &p, &said);
            assert_int_equal(kg_origami_fold(o, &fold, &done), status);
            assert_string_equal(said.message, done.message);
            assert_true(status || (p.part_count > 0 && p.layer_count >= fold.layers));
            kg_fold_preview_clear(&p);
        }
        kg_origami_destroy(o);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_moving_part_is_what_lies_beyond_the_axis),
        cmocka_unit_test(test_layers_are_counted_from_the_top),
        cmocka_unit_test(test_a_face_in_the_way_is_named),
        cmocka_unit_test(test_the_only_gap_of_a_pocket_is_found),
        cmocka_unit_test(test_gaps_of_a_tall_pile_are_the_uppermost),
        cmocka_unit_test(test_random_previews_agree_with_folding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
