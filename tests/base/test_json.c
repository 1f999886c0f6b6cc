/* JSON as text: numbers, line lengths, and the lines that errors point at. */
#include "base/json.h"
#include "tests/check.h"

#include <locale.h>
#include <stdlib.h>

static void numbers_are_the_shortest_that_read_back(void **state) {
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},
                 {1.0 / 3, "0.3333333333333333"},
                 {-2.5, "-2.5"},
                 {1e20, "1e+20"},
                 {5e-324, "4.94065645841247e-324"},
                 {100000, "100000"},
                 {-0.0, "-0.0"},
                 {INFINITY, "0"},
                 {NAN, "0"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[32];
        kg_json_number(cases[i].value, text);
        assert_string_equal(text, cases[i].text);
    }
    kg_random r = {2};
    for (int i = 0; i < 100000; i++) {
        union {
            uint64_t bits;
            double value;
        } x = {kg_random_bits(&r)};
        char text[32];
        kg_json_number(x.value, text);
        assert_true(strlen(text) < 32);
        if (isfinite(x.value))
            assert_true(strtod(text, NULL) == x.value);
    }
}

static void a_locale_with_commas_changes_nothing(void **state) {
    (void)state;
    if (!setlocale(LC_NUMERIC, "de_DE.UTF-8"))
        skip();
    char text[32];
    kg_json_number(0.1, text);
    setlocale(LC_NUMERIC, "C");
    assert_string_equal(text, "0.1");
}

static void short_values_stay_on_a_line_long_ones_do_not(void **state) {
    (void)state;
    json_t *v = json_pack("{s:[f,f], s:s, s:n, s:{}}", "a", 1.5, 2.0, "日本", "\"\n", "n", "o");
    char *text = kg_json_text(v);
    assert_string_equal(text, "{\"a\": [1.5, 2], \"日本\": \"\\\"\\n\", \"n\": null, \"o\": {}}\n");
    free(text);
    json_t *list = json_array();
    for (int i = 0; i < 60; i++)
        json_array_append_new(list, json_integer(i));
    json_object_set_new(v, "list", list);
    text = kg_json_text(v);
    json_t *back = json_loads(text, 0, NULL);
    assert_true(json_equal(json_object_get(back, "list"), list));
    assert_non_null(strstr(text, "\n  \"a\": [1.5, 2],\n"));
    /* numbers fill lines: 60 of them with their commas take more than two and less than three */
    assert_non_null(strstr(text, "\n    0, 1, 2, 3,"));
    assert_non_null(strstr(text, " 58, 59\n"));
    for (const char *line = text; *line; line = strchr(line, '\n') + 1)
        assert_true(strcspn(line, "\n") <= 100);
    free(text);
    json_decref(back);
    json_decref(v);
}

/* Costs grow with the size of the tree, not with its size times its depth. */
static void deep_trees_are_written(void **state) {
    (void)state;
    json_t *v = json_integer(1);
    for (int i = 0; i < 2000; i++)
        v = json_pack("[o,i]", v, i);
    char *text = kg_json_text(v);
    assert_non_null(text);
    json_t *back = json_loads(text, 0, NULL);
    assert_true(json_equal(back, v));
    json_decref(back);
    json_decref(v);
    free(text);
}

static void lines_of_values(void **state) {
    (void)state;
    const char *text = "\n{ \"a}\": \"[\\\"\",\n  \"list\": [1,\n [2, 3],\n {\"x\":\n 5}],\n"
                       "  \"end\": true}";
    const kg_json_step list = {"list", 0}, second = {NULL, 1}, third = {NULL, 2}, x = {"x", 0},
                       end = {"end", 0}, none = {"none", 0}, far = {NULL, 9};
    assert_int_equal(kg_json_line(text, NULL, 0), 2);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){list}, 1), 3);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){list, second}, 2), 4);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){list, third, x}, 3), 6);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){end}, 1), 7);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){none}, 1), 2);
    assert_int_equal(kg_json_line(text, (kg_json_step[]){list, far}, 2), 3);
    assert_int_equal(kg_json_line("", (kg_json_step[]){list}, 1), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_the_shortest_that_read_back),
        cmocka_unit_test(a_locale_with_commas_changes_nothing),
        cmocka_unit_test(short_values_stay_on_a_line_long_ones_do_not),
        cmocka_unit_test(deep_trees_are_written),
        cmocka_unit_test(lines_of_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
