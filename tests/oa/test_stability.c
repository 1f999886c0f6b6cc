#include "reference.h"

#include <stdlib.h>

typedef struct verdict {
    bool valid;
    size_t loose;
    int degrees;
} verdict;

static verdict judge(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    kg_oa_stability *s;
    verdict v;
    size_t missing;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    unsigned char *reached = malloc((size_t)sheet->width * (size_t)sheet->rows);
    assert_int_equal(kg_oa_flood(sheet, reached, &missing, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &s, NULL), KG_OK);
    assert_int_equal(kg_oa_mobility(s, &v.degrees, NULL), KG_OK);
    v.valid = missing == 0;
    v.loose = s->loose_count;
    for (size_t i = 0; i < s->patch_count; i++)
        if (s->patches[i].flap) /* R2 is necessary */
            assert_true(!s->patches[i].stable || s->patches[i].cells == 0);
    free(reached);
    kg_oa_stability_destroy(s);
    kg_oa_sheet_destroy(sheet);
    return v;
}

static void closure_equals_exact_mobility(void **state) {
    (void)state;
    kg_random r = {21};
    int cards = 0, wobbly = 0;
    while (cards < 2000) {
        kg_oa *oa = random_card(&r, cards % 4 * 0.06, cards % 3 == 0 ? 0.08 : 0, true);
        verdict v = judge(oa);
        if (v.valid) {
            cards++;
            wobbly += v.loose > 0;
            assert_true(v.degrees >= 1);
            assert_int_equal(v.loose == 0, v.degrees == 1);
        }
        kg_oa_destroy(oa);
    }
    assert_true(wobbly > 200 && wobbly < 1800); /* both outcomes are common */
}

static void plain_steps_are_stable(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 5, 5, 1, &oa, NULL), KG_OK);
    assert_int_equal(judge(oa).degrees, 1);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 1, 2);
    verdict v = judge(oa);
    assert_int_equal(v.degrees, 1);
    assert_int_equal(v.loose, 0);
    kg_oa_destroy(oa);
}

/* Two steps in one column: a chain of four patches between back and base, which wobbles. */
static void double_step_in_one_column_wobbles(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(3, 5, 5, 1, &oa, NULL), KG_OK);
    kg_oa_add(oa, 1, 0, 3);
    kg_oa_add(oa, 1, 2, 1);
    verdict v = judge(oa);
    assert_true(v.valid);
    assert_int_equal(v.loose, 4);
    assert_int_equal(v.degrees, 3);
    kg_oa_destroy(oa);
}

/* The lower step is wide: it stands by itself and holds the upper one. */
static void step_on_a_stable_block_is_stable(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 5, 5, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 2, 1);
    kg_oa_add(oa, 2, 0, 3);
    verdict v = judge(oa);
    assert_true(v.valid);
    assert_int_equal(v.loose, 0);
    assert_int_equal(v.degrees, 1);
    kg_oa_destroy(oa);
}

static void window_flap_is_a_flap(void **state) {
    (void)state;
    kg_oa *oa;
    kg_oa_sheet *sheet;
    kg_oa_stability *s;
    assert_int_equal(kg_oa_create(5, 6, 7, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 3, 4);
    kg_oa_set_window(oa, 2, 2, true);
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &s, NULL), KG_OK);
    size_t flaps = 0;
    for (size_t i = 0; i < s->patch_count; i++)
        if (s->patches[i].flap) {
            flaps++;
            assert_false(s->patches[i].front);
            assert_false(s->patches[i].stable);
            assert_int_equal(s->patches[i].cells, 1);
        }
    assert_int_equal(flaps, 1);
    assert_int_equal(s->loose_count, 1);
    kg_oa_stability_destroy(s);
    kg_oa_sheet_destroy(sheet);
    kg_oa_destroy(oa);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closure_equals_exact_mobility),
        cmocka_unit_test(plain_steps_are_stable),
        cmocka_unit_test(double_step_in_one_column_wobbles),
        cmocka_unit_test(step_on_a_stable_block_is_stable),
        cmocka_unit_test(window_flap_is_a_flap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
