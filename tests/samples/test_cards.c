#include "katagami/oa.h"
#include "tests/check.h"

#include <stdlib.h>

typedef struct sample_card {
    kg_oa *oa;
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    size_t missing, windows;
    int degrees;
} sample_card;

static sample_card load(const char *path) {
    sample_card c = {0};
    kg_error error;
    if (kg_oa_read(path, &c.oa, &error))
        fail_msg("%s", error.message);
    assert_int_equal(kg_oa_sheet_create(c.oa, &c.sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(c.sheet, &c.stability, NULL), KG_OK);
    assert_int_equal(kg_oa_mobility(c.stability, &c.degrees, NULL), KG_OK);
    unsigned char *reached = malloc((size_t)c.sheet->width * (size_t)c.sheet->rows);
    assert_int_equal(kg_oa_flood(c.sheet, reached, &c.missing, NULL), KG_OK);
    free(reached);
    for (int i = 0; i < c.oa->width * c.oa->height; i++)
        c.windows += c.oa->window[i];
    assert_int_equal(c.missing, 0);
    return c;
}

static void unload(sample_card *c) {
    kg_oa_stability_destroy(c->stability);
    kg_oa_sheet_destroy(c->sheet);
    kg_oa_destroy(c->oa);
}

static void tower_and_pyramids_stand_still(void **state) {
    (void)state;
    sample_card c = load(KG_SAMPLES "/tower.katagami");
    assert_int_equal(c.stability->loose_count, 0);
    assert_int_equal(c.degrees, 1);
    unload(&c);
    c = load(KG_SAMPLES "/pyramids.katagami");
    assert_int_equal(c.sheet->pyramid_count, 3);
    assert_int_equal(c.stability->loose_count, 0);
    assert_int_equal(c.degrees, 1);
    unload(&c);
}

/* Nothing of the house is loose but the sills that lie back behind its windows. */
static void house_has_windows_and_stands(void **state) {
    (void)state;
    sample_card c = load(KG_SAMPLES "/house.katagami");
    assert_true(c.windows > 20);
    for (size_t i = 0; i < c.stability->patch_count; i++)
        if (!c.stability->patches[i].stable)
            assert_true(c.stability->patches[i].flap && !c.stability->patches[i].front);
    unload(&c);
}

/* Nothing sticks out when they are closed, and they fit on A4 with its margins of 8 mm. */
static void all_are_covered_when_closed_and_fit_their_page(void **state) {
    (void)state;
    static const char *const names[] = {"castle", "house", "pyramids", "tower"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[1024];
        snprintf(path, sizeof path, KG_SAMPLES "/%s.katagami", names[i]);
        sample_card c = load(path);
        assert_int_equal(kg_oa_overhang(c.sheet), 0);
        assert_true(c.sheet->width * c.oa->cell_mm <= 210 - 2 * 8);
        assert_true(c.sheet->rows * c.oa->cell_mm <= 297 - 2 * 8);
        unload(&c);
    }
}

static void castle_stands_and_has_an_open_gate(void **state) {
    (void)state;
    sample_card c = load(KG_SAMPLES "/castle.katagami");
    assert_true(c.windows > 200);
    assert_int_equal(c.stability->loose_count, 0);
    int middle = c.oa->width / 2;
    assert_true(kg_oa_window(c.oa, middle, 2));
    unload(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tower_and_pyramids_stand_still),
        cmocka_unit_test(house_has_windows_and_stands),
        cmocka_unit_test(castle_stands_and_has_an_open_gate),
        cmocka_unit_test(all_are_covered_when_closed_and_fit_their_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
