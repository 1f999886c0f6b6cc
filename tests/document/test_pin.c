/* What a model says about its net beside the patches: pins and settings. */
#include "tests/check.h"

#include "document/pin.h"
#include "net/settings.h"

#include <stdlib.h>

static kg_model *read(const char *net) {
    char text[1024];
    kg_model *model;
    kg_error error;
    int n = snprintf(text, sizeof text,
                     "{\"katagami\": 1, \"kind\": \"patches\", \"net\": %s, "
                     "\"patches\": []}",
                     net);
    if (kg_model_read_memory(text, (size_t)n, "test", &model, &error))
        fail_msg("%s", error.message);
    return model;
}

/* Three parts, two of them of patch 7. */
static kg_net *three_parts(void) {
    static const int64_t sources[] = {7, 4, 7};
    kg_net *net = kg_net_create();
    assert_non_null(net);
    for (size_t i = 0; i < 3; i++) {
        size_t part;
        assert_int_equal(kg_net_add_part(net, sources[i], NULL, &part, NULL), KG_OK);
    }
    return net;
}

static void a_pin_finds_its_piece_of_the_patch(void **state) {
    (void)state;
    kg_model *model = read("{}");
    kg_net *net = three_parts();
    kg_net_placement place = {2, 1.25, {30, 40}};
    assert_int_equal(kg_pin_piece(net, 0), 0);
    assert_int_equal(kg_pin_piece(net, 1), 0);
    assert_int_equal(kg_pin_piece(net, 2), 1);
    assert_int_equal(kg_pin_set(model, 7, 1, place, NULL), KG_OK);
    kg_pin_parts(model, net);
    assert_false(net->parts[0].pinned);
    assert_false(net->parts[1].pinned);
    assert_true(net->parts[2].pinned);
    assert_int_equal(net->parts[2].pin.page, 2);
    assert_near(net->parts[2].pin.angle, 1.25, 1e-12);
    assert_near(net->parts[2].pin.offset.x, 30, 1e-12);
    kg_net_destroy(net);
    kg_model_destroy(model);
}

static void pins_survive_the_file_and_other_keys_too(void **state) {
    (void)state;
    kg_model *model = read("{\"glue\": \"wheat\", \"placements\": [{\"patch\": 4, \"page\": 1, "
                           "\"x\": 5, \"y\": 6, \"note\": \"keep\"}]}");
    assert_int_equal(kg_pin_set(model, 7, 0, (kg_net_placement){0, 0, {1, 2}}, NULL), KG_OK);
    char *text;
    size_t size;
    assert_int_equal(kg_model_write_memory(model, &text, &size, NULL), KG_OK);
    assert_non_null(strstr(text, "wheat"));
    assert_non_null(strstr(text, "keep"));
    kg_model *again;
    assert_int_equal(kg_model_read_memory(text, size, "again", &again, NULL), KG_OK);
    kg_net *net = three_parts();
    kg_pin_parts(again, net);
    assert_true(net->parts[0].pinned && net->parts[1].pinned && !net->parts[2].pinned);
    assert_near(net->parts[1].pin.offset.y, 6, 0);
    free(text);
    kg_net_destroy(net);
    kg_model_destroy(again);
    kg_model_destroy(model);
}

static void removing_pins_leaves_no_empty_list(void **state) {
    (void)state;
    kg_model *model = read("{}");
    kg_model *before = kg_model_copy(model);
    kg_net_placement place = {0, 0, {30, 40}};
    assert_int_equal(kg_pin_set(model, 7, 0, place, NULL), KG_OK);
    assert_int_equal(kg_pin_set(model, 7, 1, place, NULL), KG_OK);
    assert_int_equal(kg_pin_set(model, 4, 0, place, NULL), KG_OK);
    kg_net *net = three_parts();
    assert_int_equal(kg_pin_remove(model, 7, 1, NULL), KG_OK);
    kg_pin_parts(model, net);
    assert_true(net->parts[0].pinned && net->parts[1].pinned && !net->parts[2].pinned);
    assert_int_equal(kg_pin_remove(model, 7, KG_PIN_ALL, NULL), KG_OK);
    assert_int_equal(kg_pin_remove(model, 0, KG_PIN_ALL, NULL), KG_OK);
    char *texts[2];
    size_t sizes[2];
    assert_int_equal(kg_model_write_memory(model, &texts[0], &sizes[0], NULL), KG_OK);
    assert_int_equal(kg_model_write_memory(before, &texts[1], &sizes[1], NULL), KG_OK);
    assert_string_equal(texts[0], texts[1]);
    free(texts[0]);
    free(texts[1]);
    kg_net_destroy(net);
    kg_model_destroy(before);
    kg_model_destroy(model);
}

static void pins_that_make_no_sense_are_ignored(void **state) {
    (void)state;
    kg_model *model = read(
        "{\"placements\": [3, null, {}, {\"patch\": 7}, {\"patch\": 7, \"page\": -1, \"x\": 0, "
        "\"y\": 0}, {\"patch\": 7, \"page\": 900, \"x\": 0, \"y\": 0}, {\"patch\": 7, \"page\": 0, "
        "\"x\": 1e9, \"y\": 0}, {\"patch\": 7, \"piece\": 5, \"page\": 0, \"x\": 0, \"y\": 0}, "
        "{\"patch\": 99, \"page\": 0, \"x\": 0, \"y\": 0}]}");
    kg_net *net = three_parts();
    kg_pin_parts(model, net);
    for (size_t i = 0; i < 3; i++)
        assert_false(net->parts[i].pinned);
    assert_int_equal(kg_pin_set(model, 7, 0, (kg_net_placement){0, 0, {NAN, 0}}, NULL),
                     KG_ERR_INPUT);
    kg_net_destroy(net);
    kg_model_destroy(model);
}

static void a_removed_patch_leaves_no_pins_or_joins(void **state) {
    (void)state;
    kg_model *model = read("{\"placements\": [{\"patch\": 7, \"page\": 0, \"x\": 0, \"y\": 0}, "
                           "{\"patch\": 4, \"page\": 0, \"x\": 1, \"y\": 2}], \"joins\": "
                           "[{\"patches\": [4, 7], \"tab\": \"none\"}, {\"patches\": [4, 5], "
                           "\"merge\": true, \"note\": 1}]}");
    kg_net *net = three_parts();
    assert_int_equal(kg_pin_forget_patch(model, 7, NULL), KG_OK);
    kg_pin_parts(model, net);
    assert_true(!net->parts[0].pinned && net->parts[1].pinned && !net->parts[2].pinned);
    assert_int_equal(model->join_count, 1);
    assert_null(kg_model_find_join(model, 4, 7));
    assert_non_null(kg_model_find_join(model, 5, 4));
    kg_net_destroy(net);
    kg_model_destroy(model);
}

static void settings_follow_the_model(void **state) {
    (void)state;
    kg_model *model = read("{\"paper\": \"A3\", \"landscape\": true, \"labels\": \"outside\", "
                           "\"preset\": \"laser\", \"nest\": false, \"grain\": true, \"gap\": 3.5, "
                           "\"margin\": 11}");
    kg_net_options o;
    assert_int_equal(kg_net_settings_options(&model->net, &o, NULL), KG_OK);
    assert_near(o.paper.x, 297, 0);
    assert_true(o.landscape && !o.nest && o.grain && o.text_outlines && !o.frame);
    assert_int_equal(o.labels, KG_LABELS_OUTSIDE);
    assert_near(o.gap, 3.5, 0);
    assert_near(o.margin, 11, 0);
    kg_model_destroy(model);
}

static void wrong_settings_are_refused_by_name(void **state) {
    (void)state;
    static const char *const wrong[] = {
        "{\"labels\": \"above\"}", "{\"labels\": 1}", "{\"preset\": \"plasma\"}",
        "{\"landscape\": 1}",      "{\"gap\": -1}",   "{\"nest\": \"no\"}"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        kg_model *model = read(wrong[i]);
        kg_net_options o;
        kg_error error;
        assert_int_equal(kg_net_settings_options(&model->net, &o, &error), KG_ERR_INPUT);
        char key[32];
        assert_int_equal(sscanf(wrong[i], "{\"%31[a-z]", key), 1);
        assert_non_null(strstr(error.message, key));
        kg_model_destroy(model);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pin_finds_its_piece_of_the_patch),
        cmocka_unit_test(pins_survive_the_file_and_other_keys_too),
        cmocka_unit_test(removing_pins_leaves_no_empty_list),
        cmocka_unit_test(pins_that_make_no_sense_are_ignored),
        cmocka_unit_test(a_removed_patch_leaves_no_pins_or_joins),
        cmocka_unit_test(settings_follow_the_model),
        cmocka_unit_test(wrong_settings_are_refused_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
