/* Trims by several surfaces, with vertical planes that cut a horizontal one along segments. */
#include "tests/trim/regions.h"

#include <stdlib.h>

static kg_patch wall(kg_vec2 from, kg_vec2 to) {
    kg_vec3 p[4];
    const kg_vec3 up = {0, 0, 1};
    for (int i = 0; i < 4; i++) {
        kg_vec2 q = kg_lerp2(from, to, i / 3.0);
        p[i] = kg_v3(q.x, q.y, 0);
    }
    return make_patch(p, 4, -10, 10, &up);
}

/* Patch 0: z = 0 over [0,100] x [-50,50]. */
static scene floor_scene(void) {
    const kg_vec3 p[4] = {{0, 0, 0}, {100.0 / 3, 0, 0}, {200.0 / 3, 0, 0}, {100, 0, 0}},
                  y = {0, 1, 0};
    scene s = {.count = 1};
    s.patches[0] = make_patch(p, 4, -50, 50, &y);
    return s;
}

static kg_status trim_inside(scene *s, const kg_regions *in, const kg_vec3 *keep, size_t keep_count,
                             kg_trim_notes *notes, kg_regions *out, kg_error *error) {
    kg_cut cuts[SCENE_MAX];
    for (size_t k = 1; k < s->count; k++)
        assert_true(scene_cut(s, 0, k, &cuts[k - 1]));
    kg_trim trim = scene_trim(s, 0, notes);
    kg_status status = kg_trim_inside(&trim, in, cuts, s->count - 1, keep, keep_count, out, error);
    if (!status)
        check_regions(s, 0, out, "inside");
    return status;
}

/* Of the whole rectangle, with what encloses it; has to succeed. */
static kg_regions must_enclose(scene *s, kg_trim_notes *notes, int round) {
    kg_regions all = whole(s, 0), out = {0};
    kg_error error;
    if (trim_inside(s, &all, NULL, 0, notes, &out, &error))
        fail_msg("round %d: %s", round, error.message);
    assert_int_equal(out.count, 1);
    kg_regions_clear(&all);
    return out;
}

static double polygon_area(const kg_vec2 *c, size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += 0.5 * kg_cross2(c[i], c[(i + 1) % n]);
    return fabs(sum);
}

/* A convex polygon around (50, 0). */
static size_t random_corners(kg_random *r, kg_vec2 c[6]) {
    size_t n = 3 + kg_random_bits(r) % 4;
    double turn = kg_random_in(r, 0, 6.28), reach = kg_random_in(r, 5, 25);
    for (size_t i = 0; i < n; i++) {
        double a = turn + 6.283185307 * ((double)i + kg_random_in(r, -0.2, 0.2)) / (double)n;
        c[i] = kg_v2(50 + reach * cos(a), reach * sin(a));
    }
    return n;
}

/* Walls along the sides, longer at each end by a share in [lo, hi] of the side. */
static scene walls_around(kg_random *r, const kg_vec2 *c, size_t n, double lo, double hi) {
    scene s = floor_scene();
    size_t first = kg_random_bits(r) % n;
    for (size_t i = 0; i < n; i++) {
        kg_vec2 a = c[(first + i) % n], b = c[(first + i + 1) % n];
        kg_vec2 from = kg_lerp2(a, b, -kg_random_in(r, lo, hi)),
                to = kg_lerp2(a, b, 1 + kg_random_in(r, lo, hi));
        s.patches[s.count++] = kg_random_bits(r) & 1 ? wall(from, to) : wall(to, from);
    }
    return s;
}

static void tails_beyond_crossings_are_dropped(void **state) {
    (void)state;
    kg_random r = {101};
    for (int round = 0; round < 300; round++) {
        kg_vec2 c[6];
        size_t n = random_corners(&r, c);
        scene s = walls_around(&r, c, n, 0.01, 0.2);
        kg_trim_notes notes = {0};
        kg_regions out = must_enclose(&s, &notes, round);
        assert_int_equal(out.items[0].loop_count, 1);
        assert_int_equal(out.items[0].loops[0].edge_count, n);
        assert_near(total(&s, 0, &out).space_moment, polygon_area(c, n), 1e-6);
        assert_int_equal(notes.count, 0);
        kg_regions_clear(&out);
        scene_clear(&s);
    }
}

static void ends_that_miss_each_other_are_joined(void **state) {
    (void)state;
    kg_random r = {102};
    for (int round = 0; round < 300; round++) {
        kg_vec2 c[6];
        size_t n = random_corners(&r, c);
        scene s = walls_around(&r, c, n, -0.03, -0.001);
        kg_trim_notes notes = {0};
        kg_regions out = must_enclose(&s, &notes, round);
        double area = polygon_area(c, n), got = total(&s, 0, &out).space_moment;
        assert_true(got < area && got > 0.98 * area);
        assert_int_equal(notes.count, n);
        for (size_t i = 0; i < notes.count; i++) {
            assert_int_equal(notes.items[i].kind, KG_NOTE_JOINED);
            assert_true(notes.items[i].length > 0 && notes.items[i].length < 4);
        }
        free(notes.items);
        kg_regions_clear(&out);
        scene_clear(&s);
    }
}

/* Some corners cross with a tail, others miss: the tails must not mislead the joining. */
static void tails_and_gaps_mix(void **state) {
    (void)state;
    kg_random r = {103};
    for (int round = 0; round < 300; round++) {
        kg_vec2 c[6];
        size_t n = random_corners(&r, c);
        scene s = walls_around(&r, c, n, -0.02, 0.08);
        kg_regions out = must_enclose(&s, NULL, round);
        assert_near(total(&s, 0, &out).space_moment, polygon_area(c, n), 0.03 * polygon_area(c, n));
        kg_regions_clear(&out);
        scene_clear(&s);
    }
}

static void several_faces_need_a_keep_point_and_none_is_an_error(void **state) {
    (void)state;
    /* two walls in parallel and three across make two cells, one cell per pair of neighbours;
     * only cells along all cutters count, so a zigzag of two walls that cross twice is used */
    scene s = floor_scene();
    kg_vec3 arc[4] = {{20, -10, 0}, {40, 30, 0}, {60, -30, 0}, {80, 10, 0}};
    s.patches[1] = make_patch(arc, 4, -10, 10, NULL);
    s.patches[2] = wall(kg_v2(10, 0), kg_v2(90, 0));
    s.count = 3;
    kg_regions all = whole(&s, 0), out = {9, NULL};
    kg_error error = {0};
    assert_int_equal(trim_inside(&s, &all, NULL, 0, NULL, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "2 pieces"));
    assert_int_equal(out.count, 9);
    const kg_vec3 left = {36, 3, 0}, right = {64, -3, 5};
    assert_int_equal(trim_inside(&s, &all, &left, 1, NULL, &out, &error), KG_OK);
    assert_int_equal(out.count, 1);
    assert_true(kg_region_contains(&out.items[0], 3, 0.36));
    kg_regions_clear(&out);
    assert_int_equal(trim_inside(&s, &all, &right, 1, NULL, &out, &error), KG_OK);
    assert_true(kg_region_contains(&out.items[0], -3, 0.64));
    kg_regions_clear(&out);

    /* parallel walls from side to side enclose nothing */
    s.patches[1] = wall(kg_v2(30, -60), kg_v2(30, 60));
    s.patches[2] = wall(kg_v2(60, -60), kg_v2(60, 60));
    scene_clear(&s);
    s = floor_scene();
    s.patches[1] = wall(kg_v2(30, -60), kg_v2(30, 60));
    s.patches[2] = wall(kg_v2(60, -60), kg_v2(60, 60));
    s.count = 3;
    assert_int_equal(trim_inside(&s, &all, NULL, 0, NULL, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "do not enclose"));

    /* one that misses is named */
    scene_clear(&s);
    s = floor_scene();
    s.patches[1] = wall(kg_v2(30, -60), kg_v2(30, 60));
    s.patches[2] = wall(kg_v2(200, -60), kg_v2(200, 60));
    s.count = 3;
    assert_int_equal(trim_inside(&s, &all, NULL, 0, NULL, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "patch 3"));
    kg_regions_clear(&all);
    scene_clear(&s);
}

/* The piece a closed branch encloses; one cutter is enough. */
static void a_single_closed_branch_encloses_a_piece(void **state) {
    (void)state;
    /* an arch over x and one upside down over y that reach into each other by a few millimetres */
    const kg_vec3 arch[4] = {{-50, 0, 0}, {-20, 0, 30}, {20, 0, 30}, {50, 0, 0}};
    for (int depth = 1; depth <= 12; depth++) {
        scene s = {.count = 2};
        kg_vec3 other[4];
        for (int i = 0; i < 4; i++)
            other[i] = kg_v3(0.3 * arch[i].x, arch[i].x, 45 - depth - arch[i].z);
        s.patches[0] = make_patch(arch, 4, -50, 50, NULL);
        s.patches[1] = make_patch(other, 4, -60, 60, NULL);
        kg_cut cut;
        assert_true(scene_cut(&s, 0, 1, &cut));
        assert_int_equal(cut.crossings->count, 1);
        assert_true(cut.crossings->branches[0].closed);
        kg_regions all = whole(&s, 0), out, both;
        assert_int_equal(trim_inside(&s, &all, NULL, 0, NULL, &out, NULL), KG_OK);
        assert_int_equal(out.count, 1);
        kg_trim trim = scene_trim(&s, 0, NULL);
        assert_int_equal(kg_trim_by(&trim, &all, &cut, NULL, 0, &both, NULL), KG_OK);
        assert_int_equal(both.count, 2); /* island and the rest with a hole */
        assert_int_equal(both.items[0].loop_count + both.items[1].loop_count, 3);
        assert_near(fmin(plane_area(&s.patches[0], &both.items[0]),
                         plane_area(&s.patches[0], &both.items[1])),
                    plane_area(&s.patches[0], &out.items[0]), 1e-9);
        kg_regions_clear(&all);
        kg_regions_clear(&out);
        kg_regions_clear(&both);
        scene_clear(&s);
    }
}

/* A region that earlier trims left, with a cutter whose curve is its edge already. */
static void earlier_cuts_are_edges_like_any_other(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[1] = wall(kg_v2(30, -60), kg_v2(30, 60));
    s.patches[2] = wall(kg_v2(20, -10), kg_v2(80, -10));
    s.patches[3] = wall(kg_v2(20, 10), kg_v2(80, 10));
    s.patches[4] = wall(kg_v2(70, -20), kg_v2(70, 20));
    s.count = 5;
    kg_regions all = whole(&s, 0), half, out;
    kg_cut cut;
    assert_true(scene_cut(&s, 0, 1, &cut));
    kg_trim trim = scene_trim(&s, 0, NULL);
    const kg_vec3 keep = {60, 0, 0};
    assert_int_equal(kg_trim_by(&trim, &all, &cut, &keep, 1, &half, NULL), KG_OK);
    assert_int_equal(trim_inside(&s, &half, NULL, 0, NULL, &out, NULL), KG_OK);
    assert_near(total(&s, 0, &out).space_moment, 40 * 20, 1e-6);
    for (size_t k = 0; k < 4; k++)
        assert_int_equal(out.items[0].loops[0].edges[k].kind, KG_EDGE_CUT);
    kg_regions_clear(&all);
    kg_regions_clear(&half);
    kg_regions_clear(&out);
    scene_clear(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tails_beyond_crossings_are_dropped),
        cmocka_unit_test(ends_that_miss_each_other_are_joined),
        cmocka_unit_test(tails_and_gaps_mix),
        cmocka_unit_test(several_faces_need_a_keep_point_and_none_is_an_error),
        cmocka_unit_test(a_single_closed_branch_encloses_a_piece),
        cmocka_unit_test(earlier_cuts_are_edges_like_any_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
