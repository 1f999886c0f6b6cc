#include "reference.h"

#include <stdlib.h>

static void check_windows(kg_oa *oa, const unsigned char *candidates) {
    kg_oa *slow = kg_oa_copy(oa);
    size_t cells = (size_t)oa->width * (size_t)oa->height;
    assert_int_equal(kg_oa_open_windows(oa, candidates, NULL, NULL), KG_OK);
    open_windows_slowly(slow, candidates);
    assert_memory_equal(oa->window, slow->window, cells);
    kg_oa_destroy(slow);
}

static void windows_equal_flood_fill_for_every_flag(void **state) {
    (void)state;
    kg_random r = {11};
    size_t opened = 0, refused = 0;
    for (int i = 0; i < 500; i++) {
        /* some cards begin with windows, and some of those are not valid */
        kg_oa *oa = random_card(&r, i % 4 == 0 ? 0.1 : 0, i % 5 == 0 ? 0.1 : 0, i % 3 > 0);
        size_t cells = (size_t)oa->width * (size_t)oa->height;
        unsigned char *candidates = calloc(cells, 1);
        for (size_t k = 0; k < cells; k++)
            candidates[k] = chance(&r, i % 2 ? 1 : 0.5);
        check_windows(oa, candidates);
        for (size_t k = 0; k < cells; k++) {
            opened += oa->window[k];
            refused += candidates[k] && oa->depth[k] > 0 && !oa->window[k];
        }
        free(candidates);
        kg_oa_destroy(oa);
    }
    assert_true(opened > 1000 && refused > 1000);
}

/* Towers, arches and overhangs as depths from the front have them. */
static void rough_depths(kg_random *r, kg_oa *oa) {
    for (int n = 0; n < 60; n++) {
        int x0 = whole(r, 1, oa->width - 2), x1 = whole(r, x0, oa->width - 2);
        int z0 = whole(r, 0, oa->height - 2), z1 = whole(r, z0, oa->height - 2);
        int depth = whole(r, 0, oa->depth_limit - 1);
        x1 = x1 > x0 + 12 ? x0 + 12 : x1;
        for (int x = x0; x <= x1; x++)
            for (int z = z0; z <= z1; z++)
                oa->depth[x * oa->height + z] = depth;
    }
}

static void windows_of_large_cards_equal_flood_fill(void **state) {
    (void)state;
    kg_random r = {12};
    for (int i = 0; i < 2; i++) {
        kg_oa *oa;
        unsigned char raised[80 * 40];
        assert_int_equal(kg_oa_create(80, 40, 40, 1, &oa, NULL), KG_OK);
        rough_depths(&r, oa);
        kg_oa_staircase(oa->depth, 80, 40, raised);
        assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
        check_windows(oa, raised);
        kg_oa_destroy(oa);
    }
}

static void windows_leave_cards_valid(void **state) {
    (void)state;
    kg_random r = {13};
    for (int i = 0; i < 20; i++) {
        kg_oa *oa;
        assert_int_equal(kg_oa_create(200, 70, 90, 1, &oa, NULL), KG_OK);
        unsigned char *raised = malloc(200 * 90);
        rough_depths(&r, oa);
        kg_oa_staircase(oa->depth, 200, 90, raised);
        assert_int_equal(kg_oa_open_windows(oa, raised, NULL, NULL), KG_OK);
        assert_int_equal(kg_oa_thin_tops(oa, 2, NULL), KG_OK);
        assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
        face *faces = faces_of(oa);
        assert_int_equal(flood_fill(oa, faces), 0);
        free(faces);
        free(raised);
        kg_oa_destroy(oa);
    }
}

static bool stop(void *user, double fraction, const char *what) {
    (void)user;
    (void)what;
    return fraction < 0.5;
}

static void search_for_windows_can_be_cancelled(void **state) {
    (void)state;
    kg_oa *oa;
    unsigned char all[5 * 9];
    kg_progress progress = {stop, NULL};
    memset(all, 1, sizeof all);
    assert_int_equal(kg_oa_create(5, 4, 9, 1, &oa, NULL), KG_OK);
    assert_int_equal(kg_oa_open_windows(oa, all, &progress, NULL), KG_ERR_CANCELLED);
    kg_oa_destroy(oa);
}

/* ---- thin tops -------------------------------------------------------------------------- */

/* A battlement: merlons two high and one deep on a thick wall. */
static void battlements_lose_their_lower_tops_only(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(9, 5, 8, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 8; x++) {
        kg_oa_add(oa, x, 1, 3); /* the wall, 2 deep */
        kg_oa_add(oa, x, 2, x % 2 ? 5 : 3);
    }
    for (int x = 1; x < 8; x++) { /* behind the merlons nothing */
        for (int z = 4; z < 6; z++)
            assert_int_equal(kg_oa_depth(oa, x, z), x % 2 ? 3 : 0);
    }
    kg_oa_destroy(oa);

    /* a wall one deep of heights 2, 4, 2, 4, 2 before a block: between the towers it needs none */
    assert_int_equal(kg_oa_create(7, 5, 7, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 6; x++)
        kg_oa_add(oa, x, 0, x % 2 ? 1 : 3);
    assert_int_equal(kg_oa_thin_tops(oa, 1, NULL), KG_OK);
    for (int x = 1; x < 6; x++) {
        assert_int_equal(kg_oa_omitted(oa, x, 2), x % 2);
        assert_int_equal(kg_oa_omitted(oa, x, 4), 0);
    }
    face *faces = faces_of(oa);
    assert_int_equal(flood_fill(oa, faces), 0);
    free(faces);
    kg_oa_destroy(oa);
}

static void thick_and_lonely_tops_stay(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 5, 5, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 1, 2);
    assert_int_equal(kg_oa_thin_tops(oa, 1, NULL), KG_OK); /* two deep */
    assert_int_equal(kg_oa_thin_tops(oa, 2, NULL), KG_OK); /* all are the tallest */
    for (int x = 0; x < 5; x++)
        for (int z = 0; z <= 5; z++)
            assert_false(kg_oa_omitted(oa, x, z));
    kg_oa_destroy(oa);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_equal_flood_fill_for_every_flag),
        cmocka_unit_test(windows_of_large_cards_equal_flood_fill),
        cmocka_unit_test(windows_leave_cards_valid),
        cmocka_unit_test(search_for_windows_can_be_cancelled),
        cmocka_unit_test(battlements_lose_their_lower_tops_only),
        cmocka_unit_test(thick_and_lonely_tops_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
