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

/* Flaps are what single patches hold: without one of them they fall off back and base. */
static void check_flaps(const kg_oa_stability *s) {
    bool *flap = calloc(s->patch_count, sizeof *flap),
         *held = malloc(s->patch_count * sizeof *held);
    assert_true(flap && held);
    for (int gone = 0; gone < (int)s->patch_count; gone++) {
        memset(held, 0, s->patch_count * sizeof *held);
        held[s->back] = s->back != gone;
        held[s->base] = s->base != gone;
        for (bool more = true; more;) {
            more = false;
            for (size_t i = 0; i < s->hinge_count; i++) {
                int a = s->hinges[i].patches[0], b = s->hinges[i].patches[1];
                if (a == gone || b == gone || held[a] == held[b])
                    continue;
                held[a] = held[b] = more = true;
            }
        }
        for (int i = 0; i < (int)s->patch_count; i++)
            flap[i] |= i != gone && !held[i];
    }
    for (size_t i = 0; i < s->patch_count; i++)
        assert_int_equal(s->patches[i].flap, flap[i]);
    free(flap);
    free(held);
}

/* Against speeds of patches that are gathered from faces in space: degrees of freedom, and which
 * cells are loose. */
static void check_freedom(const kg_oa *oa, size_t *out_loose) {
    kg_oa_sheet *sheet;
    kg_oa_stability *s;
    int degrees;
    face *faces = faces_of(oa);
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &s, NULL), KG_OK);
    assert_int_equal(kg_oa_mobility(s, &degrees, NULL), KG_OK);
    size_t cells = (size_t)sheet->width * (size_t)sheet->rows;
    bool *still = calloc(cells, sizeof *still);
    assert_non_null(still);
    assert_int_equal(degrees, move_freely(oa, faces, still));
    assert_int_equal(s->loose_count == 0, degrees == 1);
    for (size_t i = 0; i < cells; i++)
        assert_int_equal(s->patches[s->patch_of[2 * i]].stable, still[i]);
    check_flaps(s);
    *out_loose = s->loose_count;
    free(still);
    free(faces);
    kg_oa_stability_destroy(s);
    kg_oa_sheet_destroy(sheet);
}

static void closure_equals_exact_mobility(void **state) {
    (void)state;
    kg_random r = {21};
    int cards = 0, wobbly = 0;
    while (cards < 2000) {
        kg_oa *oa = random_card(&r, cards % 4 * 0.06, cards % 3 == 0 ? 0.08 : 0, true);
        verdict v = judge(oa);
        if (v.valid) {
            size_t loose;
            check_freedom(oa, &loose);
            cards++;
            wobbly += loose > 0;
            assert_true(v.degrees >= 1);
        }
        kg_oa_destroy(oa);
    }
    assert_true(wobbly > 200 && wobbly < 1800); /* both outcomes are common */
}

/* With more patches some follow only from several others together. */
static void wide_cards_are_judged_as_exactly(void **state) {
    (void)state;
    kg_random r = {22};
    for (int cards = 0; cards < 60;) {
        kg_oa *oa = random_card_of(&r, 16, 12, 12, 0.02, 0.02, true);
        if (judge(oa).valid) {
            size_t loose;
            check_freedom(oa, &loose);
            cards++;
        }
        kg_oa_destroy(oa);
    }
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
        cmocka_unit_test(wide_cards_are_judged_as_exactly),
        cmocka_unit_test(plain_steps_are_stable),
        cmocka_unit_test(double_step_in_one_column_wobbles),
        cmocka_unit_test(step_on_a_stable_block_is_stable),
        cmocka_unit_test(window_flap_is_a_flap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
