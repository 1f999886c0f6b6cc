/* Parts that stay where they were put, and what is wrong with where parts lie. */
#include "tests/net/sample.h"

#include "net/clash.h"
#include "net/layout.h"

enum { COUNT = 5 };

/* Squares of 40 mm with the origin in their upper left corner. */
static kg_net *squares(void) {
    static const kg_vec2 points[] = {{0, 0}, {40, 0}, {40, 40}, {0, 40}};
    kg_net *net = kg_net_create();
    assert_non_null(net);
    for (int i = 0; i < COUNT; i++) {
        size_t part;
        assert_int_equal(kg_net_add_part(net, i + 1, NULL, &part, NULL), KG_OK);
        assert_int_equal(kg_net_add_loop(net, part, points, NULL, 4, NULL), KG_OK);
        net->parts[part].area = 1600;
    }
    return net;
}

static void pin(kg_net *net, size_t part, int page, double x, double y, double angle) {
    net->parts[part].pinned = true;
    net->parts[part].pin = (kg_net_placement){page, angle, {x, y}};
}

static kg_net_layout *lay_out(const kg_net *net, const kg_net_options *options,
                              unsigned clashes[COUNT]) {
    kg_net_layout *layout;
    kg_error error;
    if (kg_net_layout_create(net, options, NULL, &layout, &error))
        fail_msg("%s", error.message);
    assert_int_equal(kg_net_clashes(net, layout, options, clashes, &error), KG_OK);
    return layout;
}

static void assert_at_pin(const kg_net *net, const kg_net_layout *layout, size_t part) {
    assert_int_equal(layout->placements[part].page, net->parts[part].pin.page);
    assert_near(layout->placements[part].angle, net->parts[part].pin.angle, 0);
    assert_near(layout->placements[part].offset.x, net->parts[part].pin.offset.x, 0);
    assert_near(layout->placements[part].offset.y, net->parts[part].pin.offset.y, 0);
}

static void the_others_keep_clear_of_pinned_parts(void **state) {
    (void)state;
    for (int nested = 0; nested < 2; nested++) {
        kg_net *net = squares();
        kg_net_options options = kg_net_options_default();
        unsigned clashes[COUNT];
        options.nest = nested;
        pin(net, 1, 0, 80, 60, 0.3);
        pin(net, 4, 1, 20, 20, -2);
        kg_net_layout *layout = lay_out(net, &options, clashes);
        assert_at_pin(net, layout, 1);
        for (size_t i = 0; i < COUNT; i++)
            assert_int_equal(clashes[i], i == 4 ? KG_CLASH_PAGE : 0);
        assert_at_pin(net, layout, 4);
        assert_int_equal(layout->page_count, nested ? 2 : 3);
        kg_net_layout_destroy(layout);
        kg_net_destroy(net);
    }
}

static void pinned_parts_off_the_page_or_on_each_other_are_told(void **state) {
    (void)state;
    kg_net *net = squares();
    kg_net_options options = kg_net_options_default();
    unsigned clashes[COUNT];
    pin(net, 0, 0, -10, 50, 0);
    pin(net, 1, 0, 60, 60, 0);
    pin(net, 2, 0, 99, 99, 0);
    pin(net, 3, 0, 140, 60, 0);
    kg_net_layout *layout = lay_out(net, &options, clashes);
    assert_int_equal(clashes[0], KG_CLASH_PAGE);
    assert_int_equal(clashes[1], KG_CLASH_OVERLAP);
    assert_int_equal(clashes[2], KG_CLASH_OVERLAP);
    assert_int_equal(clashes[3], 0);
    assert_int_equal(clashes[4], 0);
    kg_net_layout_destroy(layout);
    kg_net_destroy(net);
}

static void without_paper_pins_mean_nothing(void **state) {
    (void)state;
    kg_net *net = squares();
    kg_net_options options = kg_net_options_default();
    unsigned clashes[COUNT];
    options.paper = kg_v2(0, 0);
    pin(net, 0, 7, -500, 50, 0);
    kg_net_layout *layout = lay_out(net, &options, clashes);
    assert_int_equal(layout->page_count, 1);
    assert_int_equal(layout->placements[0].page, 0);
    for (size_t i = 0; i < COUNT; i++)
        assert_int_equal(clashes[i], 0);
    kg_net_layout_destroy(layout);
    kg_net_destroy(net);
}

static void pins_that_are_no_place_are_refused(void **state) {
    (void)state;
    const kg_net_placement wrong[] = {{-1, 0, {0, 0}},
                                      {KG_NET_PAGES_MAX, 0, {0, 0}},
                                      {0, NAN, {0, 0}},
                                      {0, 0, {INFINITY, 0}},
                                      {0, 0, {0, NAN}}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        kg_net *net = squares();
        kg_net_options options = kg_net_options_default();
        kg_net_layout *layout;
        net->parts[2].pinned = true;
        net->parts[2].pin = wrong[i];
        assert_int_equal(kg_net_layout_create(net, &options, NULL, &layout, NULL), KG_ERR_INPUT);
        kg_net_destroy(net);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_others_keep_clear_of_pinned_parts),
        cmocka_unit_test(pinned_parts_off_the_page_or_on_each_other_are_told),
        cmocka_unit_test(without_paper_pins_mean_nothing),
        cmocka_unit_test(pins_that_are_no_place_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
