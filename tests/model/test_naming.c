#include "tests/check.h"

#include "model/edit.h"
#include "model/naming.h"

#include <string.h>

static const kg_patch_input strip = {
    .points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, .point_count = 4, .extent = {-1, 1}};

/* What a copy of a patch with this name is called in a model with another one, called `beside`. */
static void assert_copy(const char *name, const char *beside, bool mirrored, const char *expected) {
    kg_model *m = kg_model_create();
    int64_t id, other, copy;
    assert_int_equal(kg_model_add_patch(m, &strip, name, &id, NULL), KG_OK);
    assert_int_equal(kg_model_add_patch(m, &strip, beside, &other, NULL), KG_OK);
    assert_int_equal(kg_model_duplicate_patch(m, id, &copy, NULL), KG_OK);
    assert_int_equal(kg_model_name_copy(m, copy, mirrored, NULL), KG_OK);
    assert_string_equal(kg_model_find(m, copy)->name, expected);
    assert_string_equal(kg_model_find(m, id)->name, name);
    kg_model_destroy(m);
}

static void mirrored_copies_change_sides(void **state) {
    (void)state;
    assert_copy("ear L", "", true, "ear R");
    assert_copy("ear_r", "", true, "ear_l");
    assert_copy("flank left", "", true, "flank right");
    assert_copy("Ear (Right", "", true, "Ear (Left");
    assert_copy("耳左", "", true, "耳右");
    assert_copy("右耳", "", true, "左耳");
    assert_copy("L", "", true, "R");
}

static void all_others_are_numbered(void **state) {
    (void)state;
    assert_copy("ear", "", true, "ear 2");
    assert_copy("ear", "", false, "ear 2");
    assert_copy("ear 2", "", true, "ear 3");
    assert_copy("ear", "ear 2", true, "ear 3");
    assert_copy("ear L", "ear R", true, "ear R 2");
    assert_copy("ear L", "", false, "ear L 2");
    assert_copy("ear 99999999999999999999", "", false, "ear 99999999999999999999 2");
    assert_copy("7", "", true, "7 2");
    /* words that only end like a side */
    assert_copy("tail", "", true, "tail 2");
    assert_copy("BAR", "", true, "BAR 2");
    assert_copy("背びれ", "", true, "背びれ 2");
}

static void patches_without_a_name_stay_so(void **state) {
    (void)state;
    assert_copy("", "x", true, "");
    kg_model *m = kg_model_create();
    assert_int_equal(kg_model_name_copy(m, 3, true, NULL), KG_ERR_INPUT);
    kg_model_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirrored_copies_change_sides),
        cmocka_unit_test(all_others_are_numbered),
        cmocka_unit_test(patches_without_a_name_stay_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
