#include "tests/check.h"

#include "net/nest.h"

#include <geos_c.h>
#include <stdlib.h>

enum { PARTS_MAX = 200, LOOPS_MAX = 2, POINTS_MAX = 240 };

/* Parts with room for their points. */
typedef struct shelf {
    kg_nest_part parts[PARTS_MAX];
    kg_nest_loop loops[PARTS_MAX][LOOPS_MAX];
    kg_vec2 points[PARTS_MAX][LOOPS_MAX][POINTS_MAX];
    kg_nest_place places[PARTS_MAX];
    size_t count;
} shelf;

static kg_vec2 *add_loop(shelf *s, size_t count) {
    kg_nest_part *part = &s->parts[s->count];
    size_t k = part->loop_count++;
    part->loops = s->loops[s->count];
    s->loops[s->count][k] = (kg_nest_loop){s->points[s->count][k], count};
    return s->points[s->count][k];
}

static void add_leaf(shelf *s, double length, double width, double bend) {
    kg_vec2 *p = add_loop(s, 120);
    for (int i = 0; i < 120; i++) {
        double t = i / 60.0, x = t < 1 ? t : 2 - t;
        double y = t < 1 ? -width * sin(KG_PI * t) : 0.6 * width * sin(KG_PI * (t - 1));
        p[i] = kg_v2(x * length, y + bend * sin(KG_PI * x));
    }
    s->count++;
}

static void add_band(shelf *s, double radius, double width, double angle) {
    kg_vec2 *p = add_loop(s, 120);
    for (int i = 0; i < 120; i++) {
        double a = angle * (i < 60 ? i : 119 - i) / 59, r = i < 60 ? radius : radius + width;
        p[i] = kg_v2(r * cos(a), r * sin(a));
    }
    s->count++;
}

static void add_circle(shelf *s, double radius, double direction) {
    kg_vec2 *p = add_loop(s, 90);
    for (int i = 0; i < 90; i++)
        p[i] = kg_v2(radius * cos(direction * 2 * KG_PI * i / 90),
                     radius * sin(direction * 2 * KG_PI * i / 90));
}

static void add_box(shelf *s, double width, double height) {
    kg_vec2 *p = add_loop(s, 4);
    p[0] = kg_v2(0, 0);
    p[1] = kg_v2(width, 0);
    p[2] = kg_v2(width, height);
    p[3] = kg_v2(0, height);
    s->count++;
}

static void add_random(shelf *s, kg_random *r, double scale) {
    /* Drawn one by one: the order in which arguments are evaluated is the compiler's choice. */
    double kind = kg_random_in(r, 0, 1), a = kg_random_in(r, 0, 1);
    double b = kg_random_in(r, 0, 1), c = kg_random_in(r, 0, 1);
    if (kind < 0.5) {
        add_leaf(s, scale * (60 + 120 * a), scale * (8 + 20 * b), scale * (35 * c - 10));
    } else if (kind < 0.92) {
        add_band(s, scale * (40 + 110 * a), scale * (12 + 23 * b), 0.4 + 1.2 * c);
    } else {
        add_circle(s, scale * (20 + 25 * a), 1);
        add_circle(s, scale * (8 + 10 * b), -1);
        s->count++;
    }
}

static GEOSGeometry *ring_of(GEOSContextHandle_t geos, kg_nest_loop loop, kg_nest_place place) {
    GEOSCoordSequence *seq = GEOSCoordSeq_create_r(geos, (unsigned)loop.count + 1, 2);
    for (unsigned i = 0; i <= loop.count; i++) {
        kg_vec2 p = loop.points[i % loop.count];
        double c = cos(place.angle), s = sin(place.angle);
        GEOSCoordSeq_setXY_r(geos, seq, i, c * p.x - s * p.y + place.offset.x,
                             s * p.x + c * p.y + place.offset.y);
    }
    return GEOSGeom_createLinearRing_r(geos, seq);
}

static GEOSGeometry *polygon_of(GEOSContextHandle_t geos, const kg_nest_part *part,
                                kg_nest_place place) {
    GEOSGeometry *rings[LOOPS_MAX];
    for (size_t k = 0; k < part->loop_count; k++)
        rings[k] = ring_of(geos, part->loops[k], place);
    return GEOSGeom_createPolygon_r(geos, rings[0], rings + 1, (unsigned)part->loop_count - 1);
}

/* Distances by plain GEOS, pair by pair, on outlines turned here; returns the pages used and the
 * fill of the first one. */
static int check_places(const shelf *s, const kg_nest_options *options, double *out_fill) {
    GEOSContextHandle_t geos = GEOS_init_r();
    GEOSGeometry *made[PARTS_MAX];
    int pages = 0;
    *out_fill = 0;
    for (size_t i = 0; i < s->count; i++) {
        made[i] = polygon_of(geos, &s->parts[i], s->places[i]);
        int page = s->places[i].page;
        if (page < 0)
            continue;
        assert_true(page < options->max_pages);
        pages = page >= pages ? page + 1 : pages;
        double x0, y0, x1, y1, area;
        GEOSGeom_getExtent_r(geos, made[i], &x0, &y0, &x1, &y1);
        GEOSArea_r(geos, made[i], &area);
        *out_fill += page == 0 ? area / (options->width * options->height) : 0;
        assert_true(x0 > -1e-6 && y0 > -1e-6);
        assert_true(x1 < options->width + 1e-6 && y1 < options->height + 1e-6);
        for (size_t k = 0; k < i; k++) {
            if (s->places[k].page != page)
                continue;
            if (options->spacing > 0) {
                double spacing = options->spacing - 1e-5;
                assert_int_equal(GEOSDistanceWithin_r(geos, made[i], made[k], spacing), 0);
            } else {
                GEOSGeometry *common = GEOSIntersection_r(geos, made[i], made[k]);
                assert_true(GEOSArea_r(geos, common, &area) && area < 1e-6);
                GEOSGeom_destroy_r(geos, common);
            }
        }
        for (size_t k = 0; k < options->forbidden_count; k++) {
            kg_box2 b = options->forbidden[k];
            double distance = 0;
            GEOSGeometry *box = GEOSGeom_createRectangle_r(geos, b.lo.x, b.lo.y, b.hi.x, b.hi.y);
            GEOSDistance_r(geos, made[i], box, &distance);
            GEOSGeom_destroy_r(geos, box);
            assert_true(distance > options->spacing - 1e-5);
        }
    }
    for (size_t i = 0; i < s->count; i++)
        GEOSGeom_destroy_r(geos, made[i]);
    GEOS_finish_r(geos);
    return pages;
}

static void nest(shelf *s, const kg_nest_options *options) {
    kg_error error;
    assert_int_equal(kg_nest(s->parts, s->count, options, NULL, s->places, &error), KG_OK);
}

static int setup(void **state) {
    return (*state = calloc(1, sizeof(shelf))) ? 0 : -1;
}

static int teardown(void **state) {
    free(*state);
    return 0;
}

static void test_curved_parts_fill_most_of_a_page(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {3};
    double total = 0;
    enum { RUNS = 4 };
    for (int run = 0; run < RUNS; run++) {
        memset(s, 0, sizeof *s);
        while (s->count < 18)
            add_random(s, &random, 1);
        nest(s, &options);
        double fill;
        int pages = check_places(s, &options, &fill);
        for (size_t i = 0; i < s->count; i++)
            assert_true(s->places[i].page >= 0);
        assert_in_range(pages, 2, 3);
        assert_true(fill > 0.57);
        total += fill;
    }
    assert_true(total / RUNS > 0.62);
}

static void test_the_same_parts_get_the_same_places(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {5};
    while (s->count < 18)
        add_random(s, &random, 1);
    nest(s, &options);
    kg_nest_place first[PARTS_MAX];
    memcpy(first, s->places, sizeof first);
    nest(s, &options);
    for (size_t i = 0; i < s->count; i++) {
        assert_int_equal(first[i].page, s->places[i].page);
        assert_near(first[i].angle, s->places[i].angle, 0);
        assert_near(first[i].offset.x, s->places[i].offset.x, 0);
        assert_near(first[i].offset.y, s->places[i].offset.y, 0);
    }
}

static void test_grain_allows_half_turns_only(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {6};
    double fill;
    while (s->count < 12)
        add_random(s, &random, 1);
    options.turn = KG_NEST_HALF_TURN;
    nest(s, &options);
    check_places(s, &options, &fill);
    for (size_t i = 0; i < s->count; i++)
        assert_near(sin(s->places[i].angle), 0, 1e-12);
    options.turn = KG_NEST_FIXED;
    nest(s, &options);
    check_places(s, &options, &fill);
    for (size_t i = 0; i < s->count; i++)
        assert_near(s->places[i].angle, 0, 0);
}

static void test_pinned_parts_stay_and_others_keep_clear(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {7};
    while (s->count < 13)
        add_random(s, &random, 1);
    add_box(s, 60, 40);
    s->parts[13].pinned = true;
    s->parts[13].pin = (kg_nest_place){.page = 1, .angle = 0.3, .offset = {70, 100}};
    nest(s, &options);
    const kg_nest_place *p = &s->places[13];
    double fill;
    assert_int_equal(p->page, 1);
    assert_near(p->angle, 0.3, 0);
    assert_near(p->offset.x, 70, 0);
    assert_near(p->offset.y, 100, 0);
    assert_false(p->clash);
    check_places(s, &options, &fill);
}

static void test_pinned_parts_that_clash_are_flagged(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    for (int i = 0; i < 4; i++)
        add_box(s, 40, 30);
    for (int i = 0; i < 3; i++) {
        s->parts[i].pinned = true;
        s->parts[i].pin.offset = kg_v2(10 + 39 * i, 50 + 31 * i);
    }
    s->parts[2].pin.offset = kg_v2(170, 0); /* leaves the page */
    nest(s, &options);
    assert_true(s->places[0].clash);
    assert_true(s->places[1].clash);
    assert_true(s->places[2].clash);
    assert_false(s->places[3].clash);
    assert_int_equal(s->places[3].page, 0);
    s->parts[1].pin.page = 3;
    nest(s, &options);
    assert_false(s->places[0].clash);
    assert_false(s->places[1].clash);
}

static void test_forbidden_corners_stay_empty(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_box2 marks[3] = {{{0, 0}, {22, 22}}, {{174, 0}, {194, 20}}, {{-5, 260}, {20, 290}}};
    kg_random random = {8};
    double fill;
    options.forbidden = marks;
    options.forbidden_count = 3;
    while (s->count < 14)
        add_random(s, &random, 1);
    nest(s, &options);
    for (size_t i = 0; i < s->count; i++)
        assert_true(s->places[i].page >= 0);
    check_places(s, &options, &fill);
}

static void test_a_part_larger_than_the_page_is_left_out_alone(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    double fill;
    add_box(s, 60, 40);
    add_box(s, 250, 200);
    add_box(s, 60, 40);
    nest(s, &options);
    assert_int_equal(s->places[0].page, 0);
    assert_int_equal(s->places[1].page, -1);
    assert_int_equal(s->places[2].page, 0);
    check_places(s, &options, &fill);
}

static void test_a_part_that_fits_only_turned_is_turned(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    double fill;
    add_box(s, 275, 30);  /* along the page */
    add_box(s, 330, 1.5); /* along its diagonal */
    nest(s, &options);
    assert_int_equal(s->places[0].page, 0);
    assert_int_equal(s->places[1].page, -1); /* no turn of 15 degrees is near enough */
    s->loops[1][0].points = s->points[1][0];
    s->points[1][0][1].x = s->points[1][0][2].x = 280;
    nest(s, &options);
    assert_int_equal(s->places[1].page, 0);
    check_places(s, &options, &fill);
}

static void test_full_pages_leave_the_rest_out(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    double fill;
    int placed = 0;
    options.max_pages = 2;
    for (int i = 0; i < 5; i++)
        add_box(s, 150, 250);
    nest(s, &options);
    for (size_t i = 0; i < s->count; i++)
        placed += s->places[i].page >= 0;
    assert_int_equal(placed, 2);
    assert_int_equal(check_places(s, &options, &fill), 2);
}

static void test_small_parts_go_into_a_hole(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    double fill;
    options.width = options.height = 150;
    add_circle(s, 74, 1);
    add_circle(s, 60, -1);
    s->count++;
    for (int i = 0; i < 4; i++)
        add_box(s, 45, 30);
    nest(s, &options);
    assert_int_equal(check_places(s, &options, &fill), 1);
}

static void test_no_spacing_lets_boxes_share_a_page_edge_to_edge(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    double fill;
    options.spacing = 0;
    for (int i = 0; i < 8; i++)
        add_box(s, 90, 66);
    nest(s, &options);
    assert_int_equal(check_places(s, &options, &fill), 1);
    assert_true(fill > 0.85);
}

static void test_200_parts_are_placed(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {9};
    double fill;
    while (s->count < PARTS_MAX)
        add_random(s, &random, 0.5);
    nest(s, &options);
    for (size_t i = 0; i < s->count; i++)
        assert_true(s->places[i].page >= 0);
    check_places(s, &options, &fill);
    assert_true(fill > 0.55);
}

static void test_outlines_that_cross_themselves_are_placed(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    for (int i = 0; i < 3; i++) {
        add_box(s, 60, 40);
        kg_vec2 *p = s->points[i][0], swapped = p[1];
        p[1] = p[2];
        p[2] = swapped;
    }
    nest(s, &options);
    for (size_t i = 0; i < s->count; i++)
        assert_int_equal(s->places[i].page, 0);
}

static bool stop_at_once(void *user, double fraction, const char *what) {
    (void)user;
    assert_true(fraction >= 0 && fraction <= 1);
    assert_non_null(what);
    return false;
}

static void test_cancelling_leaves_the_places_alone(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_random random = {10};
    kg_progress progress = {stop_at_once, NULL};
    kg_error error;
    while (s->count < 30)
        add_random(s, &random, 1);
    s->places[0].page = 77;
    assert_int_equal(kg_nest(s->parts, s->count, &options, &progress, s->places, &error),
                     KG_ERR_CANCELLED);
    assert_int_equal(s->places[0].page, 77);
}

static void test_senseless_input_is_refused(void **state) {
    shelf *s = *state;
    kg_nest_options options = kg_nest_options_default();
    kg_error error;
    add_box(s, 60, 40);
    add_box(s, 60, 40);
    nest(s, &options);
    s->points[1][0][2].y = NAN;
    assert_int_equal(kg_nest(s->parts, 2, &options, NULL, s->places, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "part 2"));
    s->points[1][0][2].y = s->points[1][0][3].y = 0;
    assert_int_equal(kg_nest(s->parts, 2, &options, NULL, s->places, &error), KG_ERR_INPUT);
    s->loops[1][0].count = 2;
    assert_int_equal(kg_nest(s->parts, 2, &options, NULL, s->places, &error), KG_ERR_INPUT);
    s->parts[0].pinned = true;
    s->parts[0].pin.page = -1;
    assert_int_equal(kg_nest(s->parts, 1, &options, NULL, s->places, &error), KG_ERR_INPUT);
    s->parts[0].pinned = false;
    options.width = 0;
    assert_int_equal(kg_nest(s->parts, 1, &options, NULL, s->places, &error), KG_ERR_INPUT);
    options = kg_nest_options_default();
    options.spacing = NAN;
    assert_int_equal(kg_nest(s->parts, 1, &options, NULL, s->places, &error), KG_ERR_INPUT);
    options = kg_nest_options_default();
    assert_int_equal(kg_nest(s->parts, 0, &options, NULL, s->places, &error), KG_OK);
}

#define nest_test(f) cmocka_unit_test_setup_teardown(f, setup, teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        nest_test(test_curved_parts_fill_most_of_a_page),
        nest_test(test_the_same_parts_get_the_same_places),
        nest_test(test_grain_allows_half_turns_only),
        nest_test(test_pinned_parts_stay_and_others_keep_clear),
        nest_test(test_pinned_parts_that_clash_are_flagged),
        nest_test(test_forbidden_corners_stay_empty),
        nest_test(test_a_part_larger_than_the_page_is_left_out_alone),
        nest_test(test_a_part_that_fits_only_turned_is_turned),
        nest_test(test_full_pages_leave_the_rest_out),
        nest_test(test_small_parts_go_into_a_hole),
        nest_test(test_no_spacing_lets_boxes_share_a_page_edge_to_edge),
        nest_test(test_200_parts_are_placed),
        nest_test(test_outlines_that_cross_themselves_are_placed),
        nest_test(test_cancelling_leaves_the_places_alone),
        nest_test(test_senseless_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
