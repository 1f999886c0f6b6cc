#include "tests/check.h"

#include "model/edit.h"
#include "model/mirror.h"

#include <stdlib.h>
#include <string.h>

static kg_model *read_model(const char *text) {
    kg_model *m;
    assert_int_equal(kg_model_read_memory(text, strlen(text), "test", &m, NULL), KG_OK);
    return m;
}

static char *text_of(const kg_model *m) {
    char *text;
    size_t size;
    assert_int_equal(kg_model_write_memory(m, &text, &size, NULL), KG_OK);
    return text;
}

static void the_plane_is_kept_in_the_file(void **state) {
    (void)state;
    kg_model *m = kg_model_create();
    char *before = text_of(m);
    assert_int_equal(m->mirror.axis, 1);
    for (int axis = 0; axis < 3; axis++) {
        m->mirror = (kg_mirror_plane){axis, -12.5};
        char *text = text_of(m);
        kg_model *again = read_model(text);
        assert_int_equal(again->mirror.axis, axis);
        assert_near(again->mirror.at, -12.5, 0);
        char *same = text_of(again);
        assert_string_equal(text, same);
        free(same);
        kg_vec3 n = kg_mirror_plane_normal(again->mirror);
        const double along[] = {n.x, n.y, n.z};
        assert_near(along[axis], 1, 0);
        assert_near(kg_len(n), 1, 0);
        kg_model_destroy(again);
        free(text);
    }
    /* the usual one leaves no trace */
    m->mirror = (kg_mirror_plane){1, 0};
    char *after = text_of(m);
    assert_string_equal(before, after);
    free(before);
    free(after);
    kg_model_destroy(m);
}

static void planes_that_make_no_sense_are_the_usual_one_and_stay(void **state) {
    (void)state;
    static const char *const odd[] = {
        "7",    "{}", "{\"across\":3,\"at\":\"far\"}", "{\"across\":\"w\",\"at\":1e300}",
        "null", "[]"};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        char text[200];
        snprintf(text, sizeof text,
                 "{\"katagami\":1,\"kind\":\"patches\",\"mirror\":%s,\"patches\":[]}", odd[i]);
        kg_model *m = read_model(text);
        assert_int_equal(m->mirror.axis, 1);
        assert_near(m->mirror.at, 0, 0);
        char *kept = text_of(m);
        assert_non_null(strstr(kept, "\"mirror\":"));
        free(kept);
        m->mirror = (kg_mirror_plane){0, 7};
        kept = text_of(m);
        assert_non_null(strstr(kept, "\"mirror\": {\"across\": \"x\", \"at\": 7}"));
        free(kept);
        kg_model_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_plane_is_kept_in_the_file),
        cmocka_unit_test(planes_that_make_no_sense_are_the_usual_one_and_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
