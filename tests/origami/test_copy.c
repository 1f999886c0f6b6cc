/* Copies of origamis, and sheets placed before the first fold. */
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <jansson.h>
#include <stdlib.h>

static char *text_of(const kg_origami *o) {
    char *text;
    size_t size;
    assert_int_equal(kg_origami_write_memory(o, &text, &size, NULL), KG_OK);
    return text;
}

static void assert_same_text(const kg_origami *a, const kg_origami *b) {
    char *x = text_of(a), *y = text_of(b);
    assert_string_equal(x, y);
    free(x);
    free(y);
}

static kg_origami *folded(void) {
    kg_origami *o = square_sheet(100);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(100, 100, 0), 180));
    must_fold(o, fold_to(kg_v3(100, 0, 0), kg_v3(50, 50, 0), 90));
    return o;
}

static void test_copies_redo_what_was_undone(void **user) {
    (void)user;
    kg_origami *o = folded();
    assert_true(kg_origami_undo(o));
    kg_origami *copy = kg_origami_copy(o);
    assert_non_null(copy);
    assert_true(kg_origami_equal(o, copy));
    assert_true(kg_origami_redo(copy));
    assert_false(kg_origami_equal(o, copy));
    assert_true(kg_origami_redo(o));
    assert_true(kg_origami_equal(o, copy));
    assert_true(same_state(last(o), last(copy)));
    kg_origami_destroy(o); /* the copy keeps the states */
    assert_int_equal(last(copy)->loops.count, 4);
    kg_origami_destroy(copy);
}

static void test_folding_a_copy_leaves_the_original(void **user) {
    (void)user;
    kg_origami *o = folded(), *copy = kg_origami_copy(o), *before = kg_origami_copy(o);
    assert_true(kg_origami_undo(copy));
    must_fold(copy, fold_to(kg_v3(0, 100, 0), kg_v3(50, 50, 0), -120));
    assert_true(kg_origami_equal(o, before));
    assert_false(kg_origami_equal(o, copy));
    assert_int_equal(kg_origami_unfold(o, 1, NULL), KG_OK);
    assert_int_equal(kg_origami_fold_count(before), 2);
    kg_origami_destroy(before);
    kg_origami_destroy(copy);
    kg_origami_destroy(o);
}

static void test_every_difference_counts(void **user) {
    (void)user;
    kg_origami *o = folded(), *copy = kg_origami_copy(o);
    assert_int_equal(kg_origami_set_title(copy, "other", NULL), KG_OK);
    assert_false(kg_origami_equal(o, copy));
    assert_int_equal(kg_origami_set_title(copy, "", NULL), KG_OK);
    assert_true(kg_origami_equal(o, copy));
    assert_same_text(o, copy);
    assert_int_equal(kg_origami_set_colors(copy, 0, 0x123456, 0xffffff, NULL), KG_OK);
    assert_false(kg_origami_equal(o, copy));
    kg_origami_destroy(copy);
    copy = kg_origami_copy(o);
    kg_origami_net_settings(copy)->scale = 0.5;
    assert_false(kg_origami_equal(o, copy));
    kg_origami_destroy(o);
    o = kg_origami_copy(copy);
    assert_true(kg_origami_equal(o, copy));
    assert_same_text(o, copy);
    kg_origami_destroy(copy);
    kg_origami_destroy(o);
}

static void test_placing_a_sheet_keeps_order_and_colors(void **user) {
    (void)user;
    kg_origami *o = square_sheet(100);
    add_rectangle(o, 200, 0, 50, 50);
    assert_int_equal(kg_origami_pair_count(last(o)), 0);
    assert_int_equal(kg_origami_set_colors(o, 1, 0x2b7bba, 0xccddee, NULL), KG_OK);
    kg_vec2 moved[] = {{50, 50}, {100, 50}, {100, 120}, {50, 120}};
    assert_int_equal(kg_origami_place_sheet(o, 1, moved, 4, NULL), KG_OK);
    assert_int_equal(kg_origami_pair_count(last(o)), 1);
    assert_near(kg_origami_sheet(o, 1)->polygon[2].y, 120, 0);
    assert_int_equal(kg_origami_sheet(o, 1)->front, 0x2b7bba);
    assert_int_equal(kg_origami_remove_sheet(o, 0, NULL), KG_OK);
    assert_int_equal(kg_origami_sheet_count(o), 1);
    assert_int_equal(last(o)->loops.count, 1);
    assert_near(last(o)->vertices.items[0].position.x, 50, 0);
    kg_origami_destroy(o);
}

static void test_refused_placements_change_nothing(void **user) {
    (void)user;
    kg_origami *o = folded(), *before = kg_origami_copy(o);
    kg_vec2 good[] = {{0, 0}, {10, 0}, {0, 10}}, bad[] = {{0, 0}, {10, 0}, {20, 0}};
    kg_error error;
    assert_int_equal(kg_origami_place_sheet(o, 0, good, 3, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "first fold"));
    assert_int_equal(kg_origami_remove_sheet(o, 0, &error), KG_ERR_INPUT);
    assert_true(kg_origami_equal(o, before));
    while (kg_origami_undo(o))
        ;
    while (kg_origami_undo(before))
        ;
    assert_int_equal(kg_origami_place_sheet(o, 0, bad, 3, &error), KG_ERR_INPUT);
    assert_int_equal(kg_origami_place_sheet(o, 1, good, 3, &error), KG_ERR_INPUT);
    assert_int_equal(kg_origami_remove_sheet(o, 1, &error), KG_ERR_INPUT);
    assert_int_equal(kg_origami_set_colors(o, 1, 0, 0, &error), KG_ERR_INPUT);
    assert_true(kg_origami_equal(o, before));
    assert_int_equal(kg_origami_place_sheet(o, 0, good, 3, &error), KG_OK);
    assert_int_equal(kg_origami_fold_count(o), 0); /* its folds were of another sheet */
    kg_origami_destroy(before);
    kg_origami_destroy(o);
}

static void test_colors_of_a_pattern_are_saved(void **user) {
    (void)user;
    static const char cp[] = "1 0 0 10 0\n1 10 0 10 10\n1 10 10 0 10\n1 0 10 0 0\n3 0 0 10 10\n";
    kg_origami *o, *again;
    assert_int_equal(kg_origami_import_memory(cp, sizeof cp - 1, "x.cp", NULL, &o, NULL, NULL),
                     KG_OK);
    kg_origami *copy = kg_origami_copy(o);
    assert_int_equal(kg_origami_set_colors(o, 0, 0x00ff00, 0x0000ff, NULL), KG_OK);
    assert_false(kg_origami_equal(o, copy));
    char *text = text_of(o);
    assert_int_equal(kg_origami_read_memory(text, strlen(text), "m", &again, NULL), KG_OK);
    uint32_t front, back;
    kg_origami_colors(again, 0, &front, &back);
    assert_int_equal(front, 0x00ff00);
    assert_int_equal(back, 0x0000ff);
    assert_int_equal(last(again)->loops.count, last(o)->loops.count);
    kg_paper_sheet sheet = *kg_origami_sheet(again, 0);
    assert_int_equal(kg_origami_add_sheet(again, &sheet, NULL), KG_ERR_INPUT);
    free(text);
    kg_origami_destroy(again);
    kg_origami_destroy(copy);
    kg_origami_destroy(o);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_copies_redo_what_was_undone),
        cmocka_unit_test(test_folding_a_copy_leaves_the_original),
        cmocka_unit_test(test_every_difference_counts),
        cmocka_unit_test(test_placing_a_sheet_keeps_order_and_colors),
        cmocka_unit_test(test_refused_placements_change_nothing),
        cmocka_unit_test(test_colors_of_a_pattern_are_saved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
