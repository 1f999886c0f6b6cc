#include "tests/net/sample.h"

#include <jansson.h>

static void report_holds_what_formats_promise(void **state) {
    (void)state;
    kg_net *net = sample_net(1);
    net->parts[1].isometry_error = NAN;
    net->parts[0].perimeter = 300.25;
    kg_net_line tab = {.kind = KG_NET_VALLEY,
                       .count = 2,
                       .points = (kg_vec2[]){{1, 1}, {2, 2}},
                       .tab = 3,
                       .join = 0};
    assert_int_equal(kg_net_add_line(net, 1, &tab, NULL, NULL), KG_OK);
    kg_net_options options = kg_net_options_default();
    kg_net_layout *layout;
    assert_int_equal(kg_net_layout_create(net, &options, NULL, &layout, NULL), KG_OK);
    const kg_net_warning warning = {12, "end_inside", "patch 12: \"背\" ends inside"};
    char *text;
    assert_int_equal(kg_net_report(net, layout, &warning, 1, 0, &text, NULL), KG_OK);
    json_t *root = json_loads(text, 0, NULL);
    assert_non_null(root);
    const char *name, *kind, *code;
    int part, parts, pages, tabs, overlaps, page;
    json_int_t patch, a, b, source;
    double area, perimeter, fill, l0, l1;
    assert_int_equal(json_unpack(root,
                                 "{s:[{s:i,s:I,s:s,s:F,s:F,s:i}], s:[{s:s,s:[I,I],s:[F,F]}], "
                                 "s:{s:i,s:i,s:F,s:i,s:i}, s:[{s:I,s:s}]}",
                                 "parts", "part", &part, "patch", &patch, "name", &name, "area_mm2",
                                 &area, "perimeter_mm", &perimeter, "page", &page, "seams", "kind",
                                 &kind, "patches", &a, &b, "length_mm", &l0, &l1, "totals", "parts",
                                 &parts, "pages", &pages, "page_fill", &fill, "tabs", &tabs,
                                 "tab_overlaps", &overlaps, "warnings", "patch", &source, "code",
                                 &code),
                     0);
    assert_int_equal(part, 1);
    assert_int_equal(patch, 11);
    assert_string_equal(name, "胴体 body");
    assert_near(area, net->parts[0].area, 1e-9);
    assert_near(perimeter, 300.25, 0);
    assert_int_equal(page, 1);
    assert_string_equal(kind, "contact");
    assert_int_equal(a, 12);
    assert_int_equal(b, 11);
    assert_near(l0 - l1, 0, 0);
    assert_int_equal(parts, 3);
    assert_int_equal(pages, 1);
    assert_int_equal(tabs, 3);
    assert_int_equal(overlaps, 0);
    assert_string_equal(code, "end_inside");
    assert_int_equal(source, 12);
    double sum = 0;
    for (size_t i = 0; i < net->part_count; i++)
        sum += net->parts[i].area;
    assert_near(fill, sum / ((210 - 16) * (297 - 16)), 1e-9);
    assert_true(json_is_null(
        json_object_get(json_array_get(json_object_get(root, "parts"), 1), "isometry_error")));
    json_decref(root);
    free(text);
    kg_net_layout_destroy(layout);
    kg_net_destroy(net);
}

static void without_pages_the_report_still_stands(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    char *text;
    assert_int_equal(kg_net_report(net, NULL, NULL, 0, 0, &text, NULL), KG_OK);
    assert_non_null(strstr(text, "\"parts\": []"));
    free(text);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(report_holds_what_formats_promise),
        cmocka_unit_test(without_pages_the_report_still_stands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
