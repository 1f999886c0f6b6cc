/* Comparing, resizing and mirroring cards. */
#include "base/json.h"
#include "reference.h"

#include <stdlib.h>

static void copies_are_equal_until_anything_changes(void **state) {
    (void)state;
    kg_random r = {5};
    for (int change = 0; change < 13; change++) {
        kg_oa *a = random_card(&r, 0.3, 0.3, true);
        kg_oa_add(a, 1, 0, 0);
        kg_oa *b = kg_oa_copy(a);
        assert_non_null(b);
        assert_true(kg_oa_equal(a, b) && kg_oa_equal(b, a));
        switch (change) {
        case 0:
            b->cell_mm *= 2;
            break;
        case 1:
            b->diagonals = true;
            break;
        case 2:
            b->margin_cells = 1;
            break;
        case 3:
            b->net.margin = 1;
            break;
        case 4:
            b->net.scale = 3;
            break;
        case 5:
            b->tiny_mm = 1;
            break;
        case 6:
            free(b->title), b->title = strdup("x");
            break;
        case 7:
            b->net.paper = strdup("A3");
            break;
        case 8:
            b->depth[a->height]++;
            break;
        case 9:
            b->window[a->height] ^= 1;
            break;
        case 10:
            b->omitted[a->height] ^= 1;
            break;
        case 11:
            b->json = json_pack("{s:i}", "own", 1);
            break;
        default:
            assert_int_equal(kg_oa_resize(b, a->width + 1, a->depth_limit, a->height, NULL), KG_OK);
        }
        assert_false(kg_oa_equal(a, b));
        assert_false(kg_oa_equal(b, a));
        kg_oa_destroy(a);
        kg_oa_destroy(b);
    }
}

static void resizing_keeps_what_fits(void **state) {
    (void)state;
    kg_random r = {6};
    for (int n = 0; n < 500; n++) {
        kg_oa *a = random_card(&r, 0.3, 0.3, false), *b = kg_oa_copy(a);
        int w = whole(&r, 1, 12), d = whole(&r, 1, 10), h = whole(&r, 1, 11);
        assert_non_null(b);
        assert_int_equal(kg_oa_resize(b, w, d, h, NULL), KG_OK);
        assert_true(b->width == w && b->depth_limit == d && b->height == h);
        assert_int_equal(kg_oa_check(b, NULL), KG_OK);
        for (int x = 0; x < w; x++)
            for (int z = 0; z < h; z++) {
                bool kept = x < a->width && z < a->height;
                int wanted = kept ? kg_oa_depth(a, x, z) : 0;
                assert_int_equal(kg_oa_depth(b, x, z), wanted < d ? wanted : d);
                assert_int_equal(kg_oa_window(b, x, z), kept && kg_oa_window(a, x, z));
            }
        if (w >= a->width && d >= a->depth_limit && h >= a->height) { /* there and back */
            assert_int_equal(kg_oa_resize(b, a->width, a->depth_limit, a->height, NULL), KG_OK);
            assert_true(kg_oa_equal(a, b));
        }
        kg_oa_destroy(a);
        kg_oa_destroy(b);
    }
}

static void sizes_out_of_range_change_nothing(void **state) {
    (void)state;
    kg_random r = {7};
    kg_oa *a = random_card(&r, 0.3, 0.3, true), *b = kg_oa_copy(a);
    kg_error error;
    assert_int_equal(kg_oa_resize(b, 0, 4, 4, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "width"));
    assert_int_equal(kg_oa_resize(b, 4, 4, KG_OA_MAX_SIZE + 1, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "height"));
    assert_true(kg_oa_equal(a, b));
    kg_oa_destroy(a);
    kg_oa_destroy(b);
}

static void mirrored_cards_are_symmetric(void **state) {
    (void)state;
    kg_random r = {9};
    for (int n = 0; n < 200; n++) {
        kg_oa *a = random_card(&r, 0.3, 0.3, false), *b = kg_oa_copy(a);
        bool from_right = n % 2;
        bool changed = kg_oa_mirror(b, from_right ? KG_OA_RIGHT_HALF : KG_OA_LEFT_HALF);
        assert_int_equal(changed, !kg_oa_equal(a, b));
        assert_int_equal(kg_oa_check(b, NULL), KG_OK);
        for (int x = 0; x < a->width; x++) {
            bool kept = from_right ? 2 * x >= a->width - 1 : 2 * x <= a->width - 1;
            for (int z = 0; z < a->height; z++) {
                assert_int_equal(kg_oa_depth(b, x, z), kg_oa_depth(b, a->width - 1 - x, z));
                assert_int_equal(kg_oa_window(b, x, z), kg_oa_window(b, a->width - 1 - x, z));
                assert_true(!kept || kg_oa_depth(b, x, z) == kg_oa_depth(a, x, z));
            }
        }
        assert_false(kg_oa_mirror(b, from_right
                                         ? KG_OA_LEFT_HALF
                                         : KG_OA_RIGHT_HALF)); /* it is the same from both sides */
        kg_oa_destroy(a);
        kg_oa_destroy(b);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(copies_are_equal_until_anything_changes),
                                       cmocka_unit_test(resizing_keeps_what_fits),
                                       cmocka_unit_test(sizes_out_of_range_change_nothing),
                                       cmocka_unit_test(mirrored_cards_are_symmetric)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
