/* Remarks: what is wrong, where, and in which words. */
#include "reference.h"

#include <stdlib.h>

/* The only remark of a trouble; asserts that there is one. */
static const kg_oa_remark *only(const solved *s, kg_oa_trouble trouble) {
    const kg_oa_remark *found = NULL;
    for (size_t i = 0; i < s->remarks->count; i++)
        if (s->remarks->items[i].trouble == trouble) {
            assert_null(found);
            found = &s->remarks->items[i];
        }
    assert_non_null(found);
    return found;
}

/* A box of 3 x 2 x 3 voxels in the middle of a plain card. */
static kg_oa *house(void) {
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 4, 5, 10, &oa, NULL), KG_OK);
    for (int x = 1; x <= 3; x++)
        kg_oa_add(oa, x, 1, 2);
    return oa;
}

static void a_good_card_has_none(void **state) {
    (void)state;
    kg_oa *oa = house();
    solved s = solve(oa);
    assert_int_equal(s.remarks->count, 0);
    clear(&s);
    kg_oa_destroy(oa);
}

static void a_front_without_ground_is_named(void **state) {
    (void)state;
    char text[256];
    kg_oa *oa = house();
    for (int x = 1; x <= 3; x++)
        kg_oa_set_window(oa, x, 0, true);
    solved s = solve(oa);
    const kg_oa_remark *r = only(&s, KG_OA_NOT_CARRIED);
    assert_int_equal(s.remarks->faults, 1);
    assert_true(r->x0 == 1 && r->x1 == 4 && r->row0 == 4 && r->row1 == 6 && r->cells == 6);
    assert_true(r->lo[0] == 1 && r->hi[0] == 3 && r->lo[2] == 1 && r->hi[2] == 2);
    kg_oa_remark_say(r, text, sizeof text);
    assert_non_null(strstr(text, "front at depth 2, columns 1-3, levels 1-2: a front that stands "
                                 "on nothing below"));
    assert_non_null(strstr(text, "window"));
    kg_oa_remark_say(r, text, 8); /* cut short, but a text */
    assert_string_equal(text, "front a");
    clear(&s);
    kg_oa_destroy(oa);
}

static void margins_do_not_move_places(void **state) {
    (void)state;
    char plain[256], wide[256];
    kg_oa *oa = house();
    for (int x = 1; x <= 3; x++)
        kg_oa_set_window(oa, x, 0, true);
    solved s = solve(oa);
    kg_oa_remark_say(only(&s, KG_OA_NOT_CARRIED), plain, sizeof plain);
    clear(&s);
    oa->margin_cells = 3;
    s = solve(oa);
    assert_int_equal(only(&s, KG_OA_NOT_CARRIED)->x0, 4);
    kg_oa_remark_say(only(&s, KG_OA_NOT_CARRIED), wide, sizeof wide);
    assert_string_equal(plain, wide);
    clear(&s);
    kg_oa_destroy(oa);
}

static void models_at_the_edge_are_named(void **state) {
    (void)state;
    char text[256];
    kg_oa *oa = house();
    kg_oa_add(oa, 4, 1, 2);
    solved s = solve(oa);
    const kg_oa_remark *r = only(&s, KG_OA_BARE_EDGE);
    assert_true(r->x0 == 4 && r->x1 == 5);
    kg_oa_remark_place(r, text, sizeof text);
    assert_non_null(strstr(text, "column 4"));
    clear(&s);
    oa->margin_cells = 1;
    s = solve(oa);
    assert_int_equal(s.remarks->count, 0);
    clear(&s);
    kg_oa_destroy(oa);
}

static void tiny_features_depend_on_their_limit(void **state) {
    (void)state;
    kg_oa *oa = house(); /* three cells wide: folds of 30 mm, strips of 10 mm beside it */
    const struct {
        double tiny, scale;
        size_t necks, folds;
    } cases[] = {{0, 1, 0, 0},    {10, 1, 0, 0}, {10.1, 1, 2, 2}, {10.1, 2, 0, 0},
                 {10, 0.5, 2, 2}, {30, 1, 2, 2}, {31, 1, 3, 5}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        size_t necks = 0, folds = 0;
        oa->tiny_mm = cases[i].tiny;
        oa->net.scale = cases[i].scale;
        solved s = solve(oa);
        for (size_t k = 0; k < s.remarks->count; k++) {
            const kg_oa_remark *r = &s.remarks->items[k];
            necks += r->trouble == KG_OA_TINY_NECK;
            folds += r->trouble == KG_OA_TINY_FOLD;
            assert_true(r->mm > 0 && r->mm < oa->tiny_mm);
            if (r->trouble == KG_OA_TINY_NECK)
                assert_true(r->row0 == 2 && r->row1 == 7); /* all along the cuts */
        }
        assert_int_equal(necks, cases[i].necks);
        assert_int_equal(folds, cases[i].folds);
        assert_int_equal(s.remarks->faults, 0);
        clear(&s);
    }
    kg_oa_destroy(oa);
}

/* Faults are what the flood misses, cell by cell; loose patches are all named, with their cells. */
static void remarks_hold_every_cell_at_fault_once(void **state) {
    (void)state;
    kg_random r = {77};
    size_t faults = 0, loose = 0;
    for (int n = 0; n < 500; n++) {
        kg_oa *oa = random_card(&r, 0.3, 0.2, n % 2);
        oa->margin_cells = whole(&r, 0, 2);
        oa->tiny_mm = 1.5;
        solved s = solve(oa);
        size_t cells = (size_t)s.sheet->width * (size_t)s.sheet->rows, missing, named = 0;
        unsigned char *reached = calloc(cells, 1);
        assert_non_null(reached);
        assert_int_equal(kg_oa_flood(s.sheet, reached, &missing, NULL), KG_OK);
        size_t patches = 0;
        for (size_t i = 0; i < s.remarks->count; i++) {
            const kg_oa_remark *m = &s.remarks->items[i];
            char text[512];
            kg_oa_remark_say(m, text, sizeof text);
            assert_true(strlen(text) < 500 && strlen(text) > 40);
            assert_true(i == 0 || m->trouble >= m[-1].trouble);
            assert_true(m->cells > 0);
            bool patch = m->trouble == KG_OA_LOOSE || m->trouble == KG_OA_FLAP;
            patches += patch;
            if (patch) {
                const kg_oa_patch *p = &s.stability->patches[m->patch];
                assert_true(!p->stable && p->flap == (m->trouble == KG_OA_FLAP));
                assert_true(p->x0 == m->x0 && p->x1 == m->x1 && p->row0 == m->row0);
                assert_int_equal(p->cells, m->cells);
            }
            for (size_t k = 0; k < m->cells; k++) {
                int32_t cell = s.remarks->cells[m->first_cell + k];
                int x = cell % s.sheet->width, row = cell / s.sheet->width;
                assert_true(x >= m->x0 && x < m->x1 && row >= m->row0 && row < m->row1);
                if (kg_oa_is_fault(m->trouble)) {
                    assert_true(kg_oa_must_hold(s.sheet, (size_t)cell));
                    assert_int_not_equal(reached[cell], 3);
                    reached[cell] = 3; /* named once */
                    named++;
                }
            }
        }
        assert_int_equal(named, missing);
        assert_int_equal(patches, s.stability->loose_count);
        faults += missing;
        loose += patches;
        free(reached);
        clear(&s);
        kg_oa_destroy(oa);
    }
    assert_true(faults > 500 && loose > 500);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_good_card_has_none),
                                       cmocka_unit_test(a_front_without_ground_is_named),
                                       cmocka_unit_test(margins_do_not_move_places),
                                       cmocka_unit_test(models_at_the_edge_are_named),
                                       cmocka_unit_test(tiny_features_depend_on_their_limit),
                                       cmocka_unit_test(remarks_hold_every_cell_at_fault_once)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
