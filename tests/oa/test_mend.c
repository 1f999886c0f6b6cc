/* Cards made to stand: stable by the exact oracle, valid, and little else. */
#include "reference.h"

#include <stdlib.h>

/* Without margins and pyramids: by faces in space and the speeds of patches. */
static void check_by_faces(const kg_oa *oa) {
    face *faces = faces_of(oa);
    bool *still = calloc((size_t)oa->width * (size_t)(oa->height + oa->depth_limit), sizeof *still);
    assert_non_null(still);
    assert_int_equal(flood_fill(oa, faces), 0);
    assert_int_equal(move_freely(oa, faces, still), 1);
    free(still);
    free(faces);
}

/* The model may cover the whole fold; then only the hands that open the card join back and base. */
static bool back_meets_base(const kg_oa_stability *s) {
    for (size_t i = 0; i < s->hinge_count; i++)
        if (s->hinges[i].patches[0] + s->hinges[i].patches[1] == s->back + s->base &&
            (s->hinges[i].patches[0] == s->back || s->hinges[i].patches[0] == s->base))
            return true;
    return false;
}

/* By the rank of the loop equations. */
static void check_by_rank(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    kg_oa_stability *s;
    int degrees;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &s, NULL), KG_OK);
    assert_int_equal(s->loose_count, 0);
    assert_int_equal(kg_oa_mobility(s, &degrees, NULL), KG_OK);
    if (back_meets_base(s))
        assert_int_equal(degrees, 1);
    kg_oa_stability_destroy(s);
    kg_oa_sheet_destroy(sheet);
}

/* Loose patches and cells that nothing holds. */
static size_t troubles_of(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    kg_oa_stability *s;
    size_t missing;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &s, NULL), KG_OK);
    unsigned char *reached = malloc((size_t)sheet->width * (size_t)sheet->rows);
    assert_int_equal(kg_oa_flood(sheet, reached, &missing, NULL), KG_OK);
    size_t troubles = s->loose_count + missing;
    free(reached);
    kg_oa_stability_destroy(s);
    kg_oa_sheet_destroy(sheet);
    return troubles;
}

static size_t cells_that_differ(const kg_oa *a, const kg_oa *b) {
    size_t count = 0;
    for (int x = 0; x < a->width; x++)
        for (int z = 0; z < a->height; z++)
            count += kg_oa_depth(a, x, z) != kg_oa_depth(b, x, z) ||
                     kg_oa_window(a, x, z) != kg_oa_window(b, x, z) ||
                     kg_oa_omitted(a, x, z + 1) != kg_oa_omitted(b, x, z + 1);
    return count;
}

static size_t filled_cells(const kg_oa *oa) {
    size_t count = 0;
    for (int i = 0; i < oa->width * oa->height; i++)
        count += oa->depth[i] > 0;
    return count;
}

/* Mends a card and a copy of it. Returns the cells changed. */
static size_t mend(kg_oa *oa) {
    kg_oa *was = kg_oa_copy(oa), *again = kg_oa_copy(oa);
    bool stood = troubles_of(oa) == 0;
    kg_oa_mended mended;
    assert_int_equal(kg_oa_stabilize(oa, NULL, &mended, NULL), KG_OK);
    assert_int_equal(mended.loose, 0);
    assert_int_equal(mended.missing, 0);
    assert_int_equal(mended.cells, cells_that_differ(oa, was));
    assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
    assert_int_equal(troubles_of(oa), 0);
    check_by_rank(oa);
    if (stood)
        assert_true(kg_oa_equal(oa, was));
    else
        assert_true(mended.cells > 0);
    assert_int_equal(kg_oa_stabilize(again, NULL, &mended, NULL), KG_OK);
    assert_true(kg_oa_equal(oa, again)); /* every time the same */
    size_t cells = mended.cells;
    assert_int_equal(kg_oa_stabilize(again, NULL, &mended, NULL), KG_OK);
    assert_int_equal(mended.cells, 0); /* and done at once */
    assert_true(kg_oa_equal(oa, again));
    kg_oa_destroy(was);
    kg_oa_destroy(again);
    return cells;
}

static void random_cards_stand_when_mended(void **state) {
    (void)state;
    kg_random r = {51};
    size_t stood = 0, mended = 0, changed = 0, filled = 0;
    for (int n = 0; n < 600; n++) {
        kg_oa *oa = random_card(&r, n % 4 * 0.08, n % 3 == 0 ? 0.1 : 0, n % 5 > 0);
        bool firm = troubles_of(oa) == 0;
        size_t cells = filled_cells(oa), changes = mend(oa);
        if (n % 5 > 0) /* whose border is plain */
            check_by_faces(oa);
        stood += firm;
        mended += !firm;
        changed += changes;
        filled += firm ? 0 : cells;
        kg_oa_destroy(oa);
    }
    assert_true(stood > 50 && mended > 200);
    if (getenv("KATAGAMI_SHARES"))
        print_message("%zu of %zu cells changed\n", changed, filled);
    assert_true(changed < filled / 2);
}

/* Margins join what else were apart; pyramids fold where steps were. */
static void margins_and_pyramids_count(void **state) {
    (void)state;
    kg_random r = {52};
    for (int n = 0; n < 150; n++) {
        kg_oa *oa = random_card(&r, n % 3 * 0.1, n % 4 * 0.05, n % 2);
        oa->margin_cells = n % 3;
        oa->diagonals = n % 2;
        mend(oa);
        kg_oa_destroy(oa);
    }
}

static void symmetric_cards_stay_so(void **state) {
    (void)state;
    kg_random r = {55};
    size_t mended = 0;
    for (int n = 0; n < 200; n++) {
        kg_oa *oa = random_card(&r, n % 3 * 0.1, n % 4 * 0.05, n % 5 > 0);
        oa->diagonals = n % 4 == 0;
        kg_oa_mirror(oa, n % 2 ? KG_OA_RIGHT_HALF : KG_OA_LEFT_HALF);
        mended += mend(oa) > 0;
        assert_false(kg_oa_mirror(oa, KG_OA_LEFT_HALF));
        kg_oa_destroy(oa);
    }
    assert_true(mended > 100);
}

static void wide_cards_stand_when_mended(void **state) {
    (void)state;
    kg_random r = {53};
    for (int n = 0; n < 12; n++) {
        kg_oa *oa = random_card_of(&r, 40, 16, 20, 0.05, 0.03, true);
        size_t cells = filled_cells(oa), changes = mend(oa);
        assert_true(changes < cells / 2);
        kg_oa_destroy(oa);
    }
}

/* Two steps in one column wobble: the smaller change is made. */
static void a_double_step_loses_its_smaller_step(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(3, 5, 6, 1, &oa, NULL), KG_OK);
    kg_oa_add(oa, 1, 1, 3);
    kg_oa_add(oa, 1, 2, 0);
    assert_int_equal(mend(oa), 1);
    for (int z = 0; z < 4; z++)
        assert_int_equal(kg_oa_depth(oa, 1, z), 2);
    kg_oa_destroy(oa);
}

static void a_flap_is_closed(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 6, 7, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 3, 4);
    kg_oa_set_window(oa, 2, 2, true);
    assert_int_equal(mend(oa), 1);
    assert_false(kg_oa_window(oa, 2, 2));
    kg_oa_destroy(oa);
}

static void a_front_that_falls_off_is_held(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 4, 5, 1, &oa, NULL), KG_OK);
    for (int x = 1; x <= 3; x++) {
        kg_oa_add(oa, x, 1, 2);
        kg_oa_set_window(oa, x, 0, true);
    }
    size_t cells = mend(oa);
    assert_true(cells > 0 && cells <= 3);
    kg_oa_destroy(oa);
}

static bool stop(void *user, double fraction, const char *what) {
    (void)user;
    (void)what;
    return fraction < 0;
}

static void mending_can_be_cancelled(void **state) {
    (void)state;
    kg_random r = {54};
    kg_progress progress = {stop, NULL};
    kg_oa_mended mended = {77, 78, 79};
    kg_oa *oa = random_card_of(&r, 30, 12, 12, 0.1, 0.1, true), *was = kg_oa_copy(oa);
    assert_int_equal(kg_oa_stabilize(oa, &progress, &mended, NULL), KG_ERR_CANCELLED);
    assert_int_equal(mended.cells, 77);
    assert_true(kg_oa_equal(oa, was));
    kg_oa_destroy(oa);
    kg_oa_destroy(was);
}

/* The castle still is one: few voxels change. */
static void castle_stands(void **state) {
    (void)state;
    const char *folder = getenv("KATAGAMI_DATA");
    char path[4096];
    kg_mesh *mesh;
    kg_oa *oa;
    kg_oa_options o = kg_oa_options_default();
    snprintf(path, sizeof path, "%s/castle.obj", folder ? folder : DATA);
    if (kg_mesh_read(path, &mesh, NULL))
        skip();
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_OK);
    kg_oa *was = kg_oa_copy(oa);
    size_t voxels = 0, others = 0;
    assert_true(troubles_of(oa) > 50);
    assert_true(mend(oa) < filled_cells(was) / 10);
    for (int i = 0; i < oa->width * oa->height; i++) {
        voxels += (size_t)was->depth[i];
        others += (size_t)abs(oa->depth[i] - was->depth[i]);
    }
    assert_true(others < voxels / 100);
    kg_oa_destroy(was);
    kg_oa_destroy(oa);
    kg_mesh_destroy(mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_cards_stand_when_mended),
        cmocka_unit_test(margins_and_pyramids_count),
        cmocka_unit_test(symmetric_cards_stay_so),
        cmocka_unit_test(wide_cards_stand_when_mended),
        cmocka_unit_test(a_double_step_loses_its_smaller_step),
        cmocka_unit_test(a_flap_is_closed),
        cmocka_unit_test(a_front_that_falls_off_is_held),
        cmocka_unit_test(mending_can_be_cancelled),
        cmocka_unit_test(castle_stands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
