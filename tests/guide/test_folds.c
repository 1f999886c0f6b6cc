/* Pictures of folding sequences. */
#include "guide/dimension.h"
#include "tests/check.h"

#include <stdlib.h>

static kg_origami *read(const char *name) {
    char path[512];
    kg_origami *o;
    kg_error error;
    snprintf(path, sizeof path, "%s/data/%s", SOURCE_ROOT, name);
    if (kg_origami_read(path, &o, &error))
        fail_msg("%s", error.message);
    return o;
}

static kg_origami *square(void) {
    kg_vec2 corners[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    kg_paper_sheet sheet = {.count = 4, .polygon = corners, .front = 0xcc3333, .back = 0xffffff};
    kg_origami *o = kg_origami_create();
    assert_int_equal(kg_origami_add_sheet(o, &sheet, NULL), KG_OK);
    return o;
}

static void fold(kg_origami *o, kg_vec3 from, kg_vec3 to, double angle_deg) {
    kg_fold f = kg_fold_default();
    kg_error error;
    f.points[0] = from, f.points[1] = to, f.angle_deg = angle_deg;
    if (kg_origami_fold(o, &f, &error))
        fail_msg("%s", error.message);
}

static kg_diagram *plan(const kg_origami *o, size_t *count) {
    kg_diagram *d;
    kg_error error;
    if (kg_diagrams_create(o, &d, count, &error))
        fail_msg("%s", error.message);
    return d;
}

static void test_every_fold_and_the_finished_model_have_a_picture(void **user) {
    (void)user;
    static const char *const names[] = {"cup.katagami", "boat.katagami", "unit.katagami"};
    for (int i = 0; i < 3; i++) {
        kg_origami *o = read(names[i]);
        size_t count;
        kg_diagram *d = plan(o, &count);
        assert_int_equal(count, kg_origami_step(o) + 1);
        assert_int_equal(d[count - 1].arrow, KG_ARROW_NONE);
        for (size_t k = 0; k + 1 < count; k++)
            assert_true(d[k].arrow == (d[k].behind ? KG_ARROW_MOUNTAIN : KG_ARROW_VALLEY));
        free(d);
        kg_origami_destroy(o);
    }
}

static void test_arrows_lead_from_the_corner_to_its_goal_across_the_line(void **user) {
    (void)user;
    kg_origami *o = square();
    fold(o, kg_v3(0, 0, 0), kg_v3(100, 100, 0), 180);
    size_t count;
    kg_diagram *d = plan(o, &count);
    assert_int_equal(d[0].side, 1);
    assert_int_equal(d[0].arrow, KG_ARROW_VALLEY);
    assert_int_equal(d[0].goal, KG_GOAL_CORNER);
    kg_vec2 tail = d[0].path[0], tip = d[0].path[KG_ARROW_POINTS - 1];
    assert_true(kg_dist2(tail, kg_v2(0, 0)) < 10);
    assert_true(kg_dist2(tip, kg_v2(100, 100)) < 15);
    kg_vec2 along = kg_sub2(d[0].axis[1], d[0].axis[0]);
    assert_near(kg_len2(along), hypot(100, 100), 1e-9); /* corner to corner */
    assert_true(kg_cross2(along, kg_sub2(tail, d[0].axis[0])) *
                    kg_cross2(along, kg_sub2(tip, d[0].axis[0])) <
                0);
    free(d);
    kg_origami_destroy(o);
}

static void test_a_fold_undone_is_one_picture(void **user) {
    (void)user;
    kg_origami *o = square();
    kg_fold f = kg_fold_default();
    f.by_axis = true;
    f.points[0] = kg_v3(50, 0, 0), f.points[1] = kg_v3(50, 100, 0), f.vertex = kg_v3(0, 0, 0);
    assert_int_equal(kg_origami_fold(o, &f, NULL), KG_OK);
    f.vertex = kg_v3(100, 0, 0);
    assert_int_equal(kg_origami_fold(o, &f, NULL), KG_OK);
    size_t count;
    kg_diagram *d = plan(o, &count);
    assert_int_equal(count, 2);
    assert_int_equal(d[0].arrow, KG_ARROW_UNFOLD);
    assert_int_equal(d[0].folds, 2);
    assert_int_equal(d[1].step, 2);
    free(d);
    kg_origami_destroy(o);
}

static void test_many_folds_behind_turn_the_paper_over(void **user) {
    (void)user;
    kg_origami *o = square();
    fold(o, kg_v3(0, 0, 0), kg_v3(30, 30, 0), 180);
    fold(o, kg_v3(100, 0, 0), kg_v3(70, 30, 0), 180);
    fold(o, kg_v3(100, 100, 0), kg_v3(70, 70, 0), -180);
    fold(o, kg_v3(0, 100, 0), kg_v3(30, 70, 0), -180);
    size_t count;
    kg_diagram *d = plan(o, &count);
    int turned = 0, behind = 0;
    for (size_t i = 0; i < count; i++)
        turned += d[i].turned, behind += d[i].behind;
    assert_int_equal(turned, 1);
    assert_int_equal(behind, 0);
    assert_true(d[2].turned);
    /* seen from behind, left and right change places */
    assert_near(d[2].right.x, -1, 1e-12);
    assert_near(d[2].up.y, 1, 1e-12);
    free(d);
    kg_origami_destroy(o);
}

static void test_lengths_say_where_a_line_leaves_the_edges(void **user) {
    (void)user;
    kg_origami *o = square();
    kg_fold f = kg_fold_default();
    f.by_axis = true;
    f.points[0] = kg_v3(20, 0, 0), f.points[1] = kg_v3(70, 100, 0), f.vertex = kg_v3(0, 0, 0);
    assert_int_equal(kg_origami_fold(o, &f, NULL), KG_OK);
    size_t count;
    kg_diagram *d = plan(o, &count);
    assert_int_equal(d[0].measure_count, 2);
    double sum = d[0].measures[0].length + d[0].measures[1].length;
    assert_near(sum, 20 + 30, 1e-6); /* each from the nearer corner */
    for (size_t i = 0; i < 2; i++)   /* away from the paper */
        assert_near(fabs(d[0].measures[i].outwards.y), 1, 1e-9);
    free(d);
    kg_origami_destroy(o);
}

static void fold_along(kg_origami *o, kg_vec3 a, kg_vec3 b, kg_vec3 vertex) {
    kg_fold f = kg_fold_default();
    kg_error error;
    f.by_axis = true;
    f.points[0] = a, f.points[1] = b, f.vertex = vertex;
    if (kg_origami_fold(o, &f, &error))
        fail_msg("%s", error.message);
}

static void test_what_lies_there_already_is_named_before_lengths(void **user) {
    (void)user;
    kg_origami *o = square();
    double t = 100 * tan(KG_PI / 8);
    fold_along(o, kg_v3(50, 0, 0), kg_v3(50, 100, 0), kg_v3(0, 0, 0));   /* edge to edge … */
    fold_along(o, kg_v3(50, 0, 0), kg_v3(50, 100, 0), kg_v3(100, 0, 0)); /* … and back */
    fold_along(o, kg_v3(0, 0, 0), kg_v3(100, 100, 0), kg_v3(100, 0, 0)); /* corner to corner */
    fold_along(o, kg_v3(0, 0, 0), kg_v3(t, 100, 0), kg_v3(0, 100, 0));   /* edge to the crease */
    size_t count;
    kg_diagram *d = plan(o, &count);
    assert_int_equal(count, 4);
    assert_int_equal(d[0].goal, KG_GOAL_CORNER);
    assert_true(d[0].edge);
    assert_int_equal(d[1].goal, KG_GOAL_CORNER);
    assert_false(d[1].edge);
    assert_int_equal(d[2].goal, KG_GOAL_LINE);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(d[i].measure_count, 0);
        assert_int_equal(d[i].mark_count, 0);
    }
    free(d);
    kg_origami_destroy(o);
}

/* ---- lengths on the page ---------------------------------------------------------------- */

static const kg_diagram_length upper = {{0, 0}, {20, 0}, {0, -1}, 20},
                               lower = {{0, 30}, {20, 30}, {0, 1}, 20};

static bool lies_on(const kg_dimension *d, kg_vec2 p) {
    return p.x > d->label.lo.x && p.x < d->label.hi.x && p.y > d->label.lo.y && p.y < d->label.hi.y;
}

static void test_lengths_keep_off_the_arrow(void **user) {
    (void)user;
    kg_dimension free_place[KG_DIAGRAM_MEASURES], place[KG_DIAGRAM_MEASURES];
    kg_vec2 arrow[KG_ARROW_POINTS];
    assert_int_equal(kg_dimensions_place(&upper, 1, NULL, 0, 8, free_place), 1);
    assert_true(free_place[0].label.hi.y < -free_place[0].off); /* beyond its line */
    kg_vec2 middle = kg_lerp2(free_place[0].label.lo, free_place[0].label.hi, 0.5);
    for (int i = 0; i < KG_ARROW_POINTS; i++)
        arrow[i] = kg_v2(i, middle.y);
    assert_int_equal(kg_dimensions_place(&upper, 1, arrow, KG_ARROW_POINTS, 8, place), 1);
    for (int i = 0; i < KG_ARROW_POINTS; i++)
        assert_false(lies_on(&place[0], arrow[i]));
    assert_near(place[0].outwards.y, -1, 0); /* farther out, not on the paper */
}

static void test_of_equal_lengths_the_one_that_hides_nothing_is_shown(void **user) {
    (void)user;
    const kg_diagram_length both[2] = {upper, lower};
    kg_dimension place[KG_DIAGRAM_MEASURES];
    kg_vec2 arrow[KG_ARROW_POINTS];
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < KG_ARROW_POINTS; i++) /* covers all places of one of them */
            arrow[i] = kg_v2(i % 3 * 10, side ? 20 + i * 0.8 : 10 - i * 0.8);
        assert_int_equal(kg_dimensions_place(both, 2, arrow, KG_ARROW_POINTS, 8, place), 1);
        assert_near(place[0].feet[0].y, side ? 0 : 30, 0);
    }
    kg_diagram_length other = lower;
    other.length = 21;
    const kg_diagram_length unlike[2] = {upper, other};
    assert_int_equal(kg_dimensions_place(unlike, 2, NULL, 0, 8, place), 2);
}

/* ---- hidden parts ----------------------------------------------------------------------- */

static int by_depth(const void *user, int32_t id, int32_t other) {
    (void)user, (void)id, (void)other;
    return 0;
}

static void add_strip(kg_figure *f, double turn, double z0, double z1, int32_t id) {
    static const unsigned char looks[4] = {0};
    kg_vec3 p[4] = {kg_v3(-1, -10, z0), kg_v3(1, -10, z0), kg_v3(1, 10, z1), kg_v3(-1, 10, z1)};
    kg_vec2 shift = kg_v2(3 * cos(turn), 3 * sin(turn));
    for (int i = 0; i < 4; i++)
        p[i] = kg_v3(shift.x + p[i].x * cos(turn) - p[i].y * sin(turn),
                     shift.y + p[i].x * sin(turn) + p[i].y * cos(turn), p[i].z);
    assert_int_equal(kg_figure_add(f, p, looks, 4, 0, id), KG_OK);
}

static void test_nearer_facets_are_painted_later(void **user) {
    (void)user;
    kg_figure f = {0};
    add_strip(&f, 0, 5, 5, 0);
    add_strip(&f, 1.5, 1, 1, 1);
    add_strip(&f, 3, 3, 3, 2);
    assert_int_equal(kg_figure_sort(&f, by_depth, NULL), KG_OK);
    for (size_t i = 0; i < 3; i++)
        assert_false(f.facets.items[i].clipped);
    size_t place[3];
    for (size_t i = 0; i < 3; i++)
        place[f.order[i]] = i;
    assert_true(place[1] < place[0] && place[1] < place[2]);
    kg_figure_clear(&f);
}

/* Three strips around a triangle, each above the next: no order of painting is right. */
static void test_facets_in_a_ring_are_clipped_to_what_is_seen(void **user) {
    (void)user;
    kg_figure f = {0};
    for (int32_t i = 0; i < 3; i++)
        add_strip(&f, i * 2.0943951, 2, -2, i);
    assert_int_equal(kg_figure_sort(&f, by_depth, NULL), KG_OK);
    for (size_t i = 0; i < 3; i++) {
        const kg_facet *a = &f.facets.items[i];
        assert_true(a->clipped);
        double area = 0;
        for (size_t k = 0; k < a->piece_count; k++) {
            size_t piece = a->first_piece + k, start = piece ? f.pieces.items[piece - 1] : 0;
            for (size_t c = start; c < f.pieces.items[piece]; c++) {
                size_t next = c + 1 < f.pieces.items[piece] ? c + 1 : start;
                area += kg_cross2(f.corners.items[c], f.corners.items[next]) / 2;
            }
        }
        /* strips 2 wide cross at 60 degrees: of 40, one crossing is hidden */
        assert_near(area, 40 - 4 / sin(1.0471976), 1e-5);
    }
    kg_figure_clear(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_fold_and_the_finished_model_have_a_picture),
        cmocka_unit_test(test_arrows_lead_from_the_corner_to_its_goal_across_the_line),
        cmocka_unit_test(test_a_fold_undone_is_one_picture),
        cmocka_unit_test(test_many_folds_behind_turn_the_paper_over),
        cmocka_unit_test(test_lengths_say_where_a_line_leaves_the_edges),
        cmocka_unit_test(test_what_lies_there_already_is_named_before_lengths),
        cmocka_unit_test(test_lengths_keep_off_the_arrow),
        cmocka_unit_test(test_of_equal_lengths_the_one_that_hides_nothing_is_shown),
        cmocka_unit_test(test_nearer_facets_are_painted_later),
        cmocka_unit_test(test_facets_in_a_ring_are_clipped_to_what_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
