#include "tests/net/tab_check.h"

static int setup(void **state) {
    return (*state = kg_net_create()) ? 0 : -1;
}

static int teardown(void **state) {
    kg_net_destroy(*state);
    return 0;
}

/* ---- cases ------------------------------------------------------------------------------- */

static const kg_vec2 BOX[4] = {{0, 0}, {80, 0}, {80, 60}, {0, 60}};

static void test_a_straight_edge_gets_one_trapezoid(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    tab_add_join(net, tab_edge(tab_add_polygon(net, BOX, 4), 0, 0, 2), tab_nothing());
    made = tab_make(net, &options, &report);
    assert_int_equal(report.tab_count, 1);
    assert_int_equal(report.remark_count, 0);
    const kg_net_line *line = &made->parts[0].loops[0].line;
    const kg_vec2 expected[6] = {{0, 0}, {5, -5}, {75, -5}, {80, 0}, {80, 60}, {0, 60}};
    assert_int_equal(line->count, 6);
    for (size_t i = 0; i < 6; i++)
        assert_near(kg_dist2(line->points[i], expected[i]), 0, 0.01);
    assert_int_equal(made->parts[0].line_count, 1);
    assert_int_equal(made->parts[0].lines[0].kind, KG_NET_VALLEY);
    assert_int_equal(made->joins[0].sides[0].count, 4);
    kg_net_destroy(made);
}

static void test_collinear_points_flagged_as_corners_do_not_split_a_tab(void **state) {
    const kg_vec2 points[] = {{0, 0}, {10, 0}, {25, 0}, {26, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    tab_add_join(net, tab_edge(tab_add_polygon(net, points, 7), 0, 0, 5), tab_nothing());
    assert_int_equal(tab_count(net, &report), 1);
    assert_int_equal(report.remark_count, 0);
}

static void test_duplicate_points_do_no_harm(void **state) {
    const kg_vec2 points[] = {{0, 0},  {0, 0},  {40, 0},  {40, 0},
                              {80, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    tab_add_join(net, tab_edge(tab_add_polygon(net, points, 8), 0, 0, 6), tab_nothing());
    assert_int_equal(tab_count(net, &report), 1);
    net->joins[0].sides[0] = tab_edge(0, 0, 2, 2); /* of no length: nothing to glue */
    kg_tab_options options = kg_tab_options_default();
    kg_net *made;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, NULL), KG_OK);
    assert_int_equal(report.tab_count, 0);
    assert_int_equal(report.remark_count, 0);
    kg_net_destroy(made);
}

static void test_an_edge_shorter_than_the_tab_is_wide_gets_a_lower_one(void **state) {
    const kg_vec2 points[] = {{0, 0}, {38, 0}, {40, 1}, {42, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = tab_add_polygon(net, points, 7);
    kg_net_join *join = tab_add_join(net, tab_edge(part, 0, 0, 2), tab_nothing());
    join->sides[0] = tab_edge(part, 0, 5, 2);
    net->parts[0].loops[0].line.points[6] = kg_v2(77, 60);
    join->sides[0].count = 2;
    assert_int_equal(tab_count(net, &report), 1);
    const kg_tab_remark *remark = tab_remark_of(&report, KG_TAB_LOWERED, KG_TAB_SHORT);
    assert_non_null(remark);
    assert_near(remark->length, 3, 1e-9);
    assert_true(remark->height > 2 && remark->height < 5);
    kg_tab_report_clear(&report);
}

static void test_a_tiny_stretch_is_named_or_has_a_tiny_tab(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    const kg_vec2 points[] = {{0, 0}, {80, 0}, {80, 60}, {0.05, 60}, {0, 60}};
    tab_add_join(net, tab_edge(tab_add_polygon(net, points, 5), 0, 3, 2), tab_nothing());
    tab_count(net, &report);
    assert_int_equal(report.remark_count, 1);
    assert_near(report.remarks[0].length, 0.05, 1e-6);
    kg_tab_report_clear(&report);
}

static void test_two_joins_at_a_narrow_corner_share_it(void **state) {
    const kg_vec2 points[] = {{0, 0}, {80, 0}, {80, 60}, {46, 60}, {40, 20}, {34, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = tab_add_polygon(net, points, 7);
    tab_add_join(net, tab_edge(part, 0, 3, 2), tab_nothing());
    tab_add_join(net, tab_edge(part, 0, 4, 2), tab_nothing());
    assert_true(tab_count(net, &report) >= 2);
    assert_true(report.remark_count > 0);
    double missing[2] = {0, 0};
    for (size_t i = 0; i < report.remark_count; i++)
        if (report.remarks[i].trouble == KG_TAB_MISSING)
            missing[report.remarks[i].join] += report.remarks[i].length;
    assert_true(missing[0] < 30 && missing[1] < 30);
    kg_tab_report_clear(&report);
}

static void test_facing_edges_of_a_narrow_slot_give_way_together(void **state) {
    const kg_vec2 points[] = {{0, 0},   {70, 0},  {70, 50}, {38, 50},
                              {38, 10}, {32, 10}, {32, 50}, {0, 50}};
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    size_t part = tab_add_polygon(net, points, 8);
    tab_add_join(net, tab_edge(part, 0, 3, 2), tab_nothing());
    tab_add_join(net, tab_edge(part, 0, 5, 2), tab_nothing());
    made = tab_make(net, &options, &report);
    assert_int_equal(report.tab_count, 2);
    assert_int_equal(report.remark_count, 2);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(report.remarks[i].join, i);
        assert_int_equal(report.remarks[i].trouble, KG_TAB_LOWERED);
        assert_int_equal(report.remarks[i].reason, KG_TAB_NEIGHBOUR);
        assert_true(report.remarks[i].height > 2 && report.remarks[i].height < 3);
    }
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_slot_narrower_than_the_tab_lowers_it(void **state) {
    const kg_vec2 points[] = {{0, 0},   {70, 0},  {70, 50}, {37, 50},
                              {37, 10}, {33, 10}, {33, 50}, {0, 50}};
    kg_net *net = *state;
    kg_tab_report report;
    tab_add_join(net, tab_edge(tab_add_polygon(net, points, 8), 0, 3, 2), tab_nothing());
    tab_count(net, &report);
    const kg_tab_remark *remark = tab_remark_of(&report, KG_TAB_LOWERED, KG_TAB_NO_ROOM);
    assert_non_null(remark);
    assert_true(remark->height > 2.5 && remark->height < 4);
    kg_tab_report_clear(&report);
}

static void test_an_acute_part_keeps_its_tabs_outside(void **state) {
    const kg_vec2 points[] = {{0, 0}, {60, 0}, {60, 3}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = tab_add_polygon(net, points, 3);
    for (size_t i = 0; i < 3; i++)
        tab_add_join(net, tab_edge(part, 0, i, 2), tab_nothing());
    assert_int_equal(tab_count(net, &report), 3);
    kg_tab_report_clear(&report);
}

static void add_ring(kg_net *net, double radius, double hole) {
    size_t part = tab_add_part(net);
    tab_pen p = {.count = 0};
    tab_draw_circle(&p, radius, 1);
    tab_add_contour(net, part, &p);
    tab_draw_circle(&p, hole, -1);
    tab_add_contour(net, part, &p);
}

static void test_a_whole_hole_gets_teeth_inside_it(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    add_ring(net, 40, 18);
    tab_add_join(net, tab_edge(0, 1, 70, 121), tab_nothing());
    made = tab_make(net, &options, &report);
    assert_in_range(report.tab_count, 16, 30);
    const kg_net_line *line = &made->parts[0].loops[1].line;
    assert_int_equal(made->joins[0].sides[0].count, line->count + 1);
    for (size_t i = 0; i < line->count; i++)
        assert_true(kg_len2(line->points[i]) < 18 + 1e-9);
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_hole_too_small_for_tabs_is_named(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    add_ring(net, 40, 0.3);
    tab_add_join(net, tab_edge(0, 1, 0, 121), tab_nothing());
    tab_count(net, &report);
    assert_true(report.remark_count > 0);
    kg_tab_report_clear(&report);
}

static void test_a_stretch_may_cross_the_start_of_its_contour(void **state) {
    kg_net *net = *state;
    kg_tab_report first, second;
    add_ring(net, 40, 18);
    tab_add_join(net, tab_edge(0, 0, 100, 41), tab_nothing());
    size_t across = tab_count(net, &first);
    net->joins[0].sides[0] = tab_edge(0, 0, 20, 41);
    assert_int_equal(tab_count(net, &second), across);
    assert_true(across > 5);
    kg_tab_report_clear(&first);
    kg_tab_report_clear(&second);
}

static void test_teeth_bases_are_nearly_straight(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    add_ring(net, 40, 12);
    tab_add_join(net, tab_edge(0, 0, 0, 121), tab_nothing());
    tab_add_join(net, tab_edge(0, 1, 0, 121), tab_nothing());
    made = tab_make(net, &options, &report);
    const kg_net_part *part = &made->parts[0];
    for (size_t i = 0; i < part->line_count; i++) {
        kg_vec2 a = part->lines[i].points[0];
        kg_vec2 b = part->lines[i].points[part->lines[i].count - 1];
        for (size_t k = 0; k < part->lines[i].count; k++) {
            kg_vec2 p = part->lines[i].points[k];
            double off = fabs(kg_cross2(kg_sub2(b, a), kg_sub2(p, a))) / kg_dist2(a, b);
            assert_true(off < 0.35);
        }
    }
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_straight_edge_that_bends_in_space_gets_teeth(void **state) {
    /* The rim of a cylinder of radius 20 mm: 80 mm of it turn by 4 radians. */
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    const double turned[2] = {0, 4};
    const double *bends[2] = {turned, NULL};
    options.bends = bends;
    tab_add_join(net, tab_edge(tab_add_polygon(net, BOX, 4), 0, 0, 2), tab_nothing());
    made = tab_make(net, &options, &report);
    assert_in_range(report.tab_count, 11, 16);
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_tabs_go_to_the_side_that_is_asked_for(void **state) {
    kg_net *net = *state;
    kg_tab_options options = kg_tab_options_default();
    size_t a = tab_add_polygon(net, BOX, 4), b = tab_add_polygon(net, BOX, 4);
    kg_net_join *join = tab_add_join(net, tab_edge(a, 0, 0, 2), tab_edge(b, 0, 0, 2));
    static const size_t expected[4][2] = {{1, 0}, {0, 0}, {1, 0}, {0, 1}};
    for (int wish = KG_TAB_AUTO; wish <= KG_TAB_OTHER; wish++) {
        kg_tab_report report;
        join->tab_side = (kg_net_tab_side)wish;
        kg_net *made = tab_make(net, &options, &report);
        assert_int_equal(made->parts[0].line_count, expected[wish][0]);
        assert_int_equal(made->parts[1].line_count, expected[wish][1]);
        if (wish == KG_TAB_OTHER)
            assert_int_equal(made->parts[1].lines[0].kind, KG_NET_MOUNTAIN);
        assert_int_equal(report.remark_count, 0);
        kg_net_destroy(made);
    }
}

static void test_a_seam_prefers_the_side_with_room(void **state) {
    /* Side 0 is the wall of a slot, side 1 free. */
    const kg_vec2 slot[] = {{0, 0},   {70, 0},  {70, 50}, {36, 50},
                            {36, 10}, {34, 10}, {34, 50}, {0, 50}};
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    size_t a = tab_add_polygon(net, slot, 8), b = tab_add_polygon(net, BOX, 4);
    tab_add_join(net, tab_edge(a, 0, 3, 2), tab_edge(b, 0, 0, 2));
    made = tab_make(net, &options, &report);
    assert_int_equal(made->parts[0].line_count, 0);
    assert_int_equal(made->parts[1].line_count, 1);
    assert_int_equal(report.remark_count, 0);
    kg_net_destroy(made);
}

static void test_a_wish_that_cannot_be_met_is_named(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    kg_net_join *join =
        tab_add_join(net, tab_edge(tab_add_polygon(net, BOX, 4), 0, 0, 2), tab_nothing());
    join->tab_side = KG_TAB_OTHER;
    assert_int_equal(tab_count(net, &report), 1);
    assert_non_null(tab_remark_of(&report, KG_TAB_MOVED, KG_TAB_NO_EDGE));
    kg_tab_report_clear(&report);
}

static void test_one_edge_in_two_joins_has_one_row_of_tabs(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    size_t a = tab_add_polygon(net, BOX, 4);
    tab_add_join(net, tab_edge(a, 0, 0, 2), tab_nothing());
    tab_add_join(net, tab_edge(a, 0, 0, 2), tab_nothing());
    assert_int_equal(tab_count(net, &report), 1);
    const kg_tab_remark *remark = tab_remark_of(&report, KG_TAB_MISSING, KG_TAB_TAKEN);
    assert_non_null(remark);
    assert_int_equal(remark->join, 1);
    assert_near(remark->length, 80, 1e-9);
    kg_tab_report_clear(&report);
}

static void test_shape_and_width_of_a_join_are_kept(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_net_join *join =
        tab_add_join(net, tab_edge(tab_add_polygon(net, BOX, 4), 0, 0, 2), tab_nothing());
    join->tab_width = 8;
    made = tab_make(net, &options, &report);
    assert_near(made->parts[0].loops[0].line.points[1].y, -8, 1e-9);
    kg_net_destroy(made);
    join->tab_shape = KG_TAB_TEETH;
    made = tab_make(net, &options, &report);
    assert_in_range(report.tab_count, 10, 11);
    kg_net_destroy(made);
}

static void test_no_tabs_leave_the_net_as_it_was(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_error error;
    add_ring(net, 40, 18);
    net->parts[0].area = 123;
    tab_add_join(net, tab_edge(0, 0, 110, 41), tab_nothing());
    options.none = true;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_OK);
    assert_int_equal(report.tab_count, 0);
    assert_int_equal(report.remark_count, 0);
    assert_int_equal(made->joins[0].sides[0].first, 110);
    assert_int_equal(made->joins[0].sides[0].count, 41);
    assert_near(made->parts[0].area, 123, 0);
    for (size_t l = 0; l < 2; l++) {
        const kg_net_line *a = &net->parts[0].loops[l].line, *b = &made->parts[0].loops[l].line;
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->points, b->points, a->count * sizeof *a->points);
        assert_memory_equal(a->corners, b->corners, a->count);
    }
    kg_net_destroy(made);
}

static void test_senseless_widths_are_refused(void **state) {
    kg_net *net = *state, *made = NULL;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_error error;
    kg_net_join *join =
        tab_add_join(net, tab_edge(tab_add_polygon(net, BOX, 4), 0, 0, 2), tab_nothing());
    options.width = NAN;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    options = kg_tab_options_default();
    options.least = 6;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    options = kg_tab_options_default();
    join->tab_width = -1;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "join 1"));
    assert_null(made);
}

#define tab_test(f) cmocka_unit_test_setup_teardown(f, setup, teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        tab_test(test_a_straight_edge_gets_one_trapezoid),
        tab_test(test_collinear_points_flagged_as_corners_do_not_split_a_tab),
        tab_test(test_duplicate_points_do_no_harm),
        tab_test(test_an_edge_shorter_than_the_tab_is_wide_gets_a_lower_one),
        tab_test(test_a_tiny_stretch_is_named_or_has_a_tiny_tab),
        tab_test(test_two_joins_at_a_narrow_corner_share_it),
        tab_test(test_facing_edges_of_a_narrow_slot_give_way_together),
        tab_test(test_a_slot_narrower_than_the_tab_lowers_it),
        tab_test(test_an_acute_part_keeps_its_tabs_outside),
        tab_test(test_a_whole_hole_gets_teeth_inside_it),
        tab_test(test_a_hole_too_small_for_tabs_is_named),
        tab_test(test_a_stretch_may_cross_the_start_of_its_contour),
        tab_test(test_teeth_bases_are_nearly_straight),
        tab_test(test_a_straight_edge_that_bends_in_space_gets_teeth),
        tab_test(test_tabs_go_to_the_side_that_is_asked_for),
        tab_test(test_a_seam_prefers_the_side_with_room),
        tab_test(test_a_wish_that_cannot_be_met_is_named),
        tab_test(test_one_edge_in_two_joins_has_one_row_of_tabs),
        tab_test(test_shape_and_width_of_a_join_are_kept),
        tab_test(test_no_tabs_leave_the_net_as_it_was),
        tab_test(test_senseless_widths_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
