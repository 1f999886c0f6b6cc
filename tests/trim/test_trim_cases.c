/* Seams, coincident cuts, notes, keep points, bounded cutters. */
#include "tests/trim/regions.h"

#include <stdlib.h>

static kg_regions trim_by(scene *s, size_t a, size_t b, const kg_regions *in, const kg_vec3 *keep,
                          size_t keep_count, kg_trim_notes *notes) {
    kg_cut cut;
    kg_regions out;
    kg_error error;
    assert_true(scene_cut(s, a, b, &cut));
    kg_trim trim = scene_trim(s, a, notes);
    if (kg_trim_by(&trim, in, &cut, keep, keep_count, &out, &error))
        fail_msg("%s", error.message);
    check_regions(s, a, &out, "trim");
    return out;
}

static kg_regions trim_whole(scene *s, size_t a, size_t b, const kg_vec3 *keep, size_t keep_count,
                             kg_trim_notes *notes) {
    kg_regions all = whole(s, a), out = trim_by(s, a, b, &all, keep, keep_count, notes);
    kg_regions_clear(&all);
    return out;
}

/* The first edge that came from a source; NULL if none. */
static const kg_region_edge *edge_of(const kg_regions *r, kg_edge_kind kind, int64_t source,
                                     const kg_region_loop **out_loop) {
    for (size_t i = 0; i < r->count; i++)
        for (size_t k = 0; k < r->items[i].loop_count; k++)
            for (size_t j = 0; j < r->items[i].loops[k].edge_count; j++) {
                *out_loop = &r->items[i].loops[k];
                const kg_region_edge *e = &(*out_loop)->edges[j];
                if (e->kind == kind && e->source == source)
                    return e;
            }
    return NULL;
}

static void both_sides_of_a_seam_are_equally_long_and_share_points(void **state) {
    (void)state;
    kg_random r = {111};
    size_t seams = 0;
    while (seams < 300) {
        scene s = random_scene(&r, 2, kg_v3(10, 0, 0));
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count == 1 &&
            (cut.crossings->branches[0].closed ||
             (cut.crossings->branches[0].ends[0] && cut.crossings->branches[0].ends[1]))) {
            kg_regions a = trim_whole(&s, 0, 1, NULL, 0, NULL),
                       b = trim_whole(&s, 1, 0, NULL, 0, NULL);
            const kg_region_loop *la = NULL, *lb = NULL;
            const kg_region_edge *ea = edge_of(&a, KG_EDGE_CUT, 2, &la),
                                 *eb = edge_of(&b, KG_EDGE_CUT, 1, &lb);
            if (ea && eb && a.count == 2 && b.count == 2) {
                assert_int_equal(ea->count, eb->count);
                kg_measure ma = kg_region_edge_measure(&s.patches[0], la, ea, &s.patches[1], 0,
                                                       (double)ea->count),
                           mb = kg_region_edge_measure(&s.patches[1], lb, eb, &s.patches[0], 0,
                                                       (double)eb->count);
                assert_near(ma.paper_length, mb.paper_length, 1e-6 * ma.paper_length);
                assert_near(ma.space_length, ma.paper_length, 1e-6 * ma.paper_length);
                kg_vec3 start = kg_region_edge_point(la, ea, 0).x;
                bool forward = kg_dist(start, kg_region_edge_point(lb, eb, 0).x) < 1e-4;
                for (size_t i = 0; i <= ea->count; i++) {
                    kg_vec3 x = kg_region_edge_point(la, ea, i).x;
                    kg_vec3 y = kg_region_edge_point(lb, eb, forward ? i : ea->count - i).x;
                    assert_memory_equal(&x, &y, sizeof x);
                }
                seams++;
            }
            kg_regions_clear(&a);
            kg_regions_clear(&b);
        }
        scene_clear(&s);
    }
}

static void cutting_twice_by_the_same_patch_changes_nothing(void **state) {
    (void)state;
    kg_random r = {112};
    for (int done = 0; done < 200;) {
        scene s = random_scene(&r, 2, kg_v3(0, 0, 0));
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count > 0) {
            kg_regions once = trim_whole(&s, 0, 1, NULL, 0, NULL),
                       twice = trim_by(&s, 0, 1, &once, NULL, 0, NULL);
            double x[PIECES_MAX], y[PIECES_MAX];
            assert_int_equal(once.count, twice.count);
            areas_of(&s.patches[0], &once, x);
            areas_of(&s.patches[0], &twice, y);
            for (size_t i = 0; i < once.count; i++)
                assert_near(x[i], y[i], 1e-6 * x[0]);
            kg_regions_clear(&once);
            kg_regions_clear(&twice);
            done++;
        }
        scene_clear(&s);
    }
}

/* A patch, its mirror image about y = 0, and the mirror plane as a patch: all three meet in one
 * curve, so whatever cuts second finds its work done. */
static void three_patches_meet_in_one_curve(void **state) {
    (void)state;
    kg_random r = {113};
    size_t done = 0;
    for (int round = 0; round < 300; round++) {
        kg_vec3 p[6], q[6];
        size_t n = round % 2 ? 6 : 4;
        for (size_t i = 0; i < n; i++) {
            double f = (double)i / (double)(n - 1);
            p[i] = kg_v3(100 * f, 5 + 6 * sin(2 * f) + kg_random_in(&r, -1, 1),
                         30 * f * (1 - f) + kg_random_in(&r, -1, 1));
            q[i] = kg_v3(p[i].x, -p[i].y, p[i].z);
        }
        const kg_vec3 x[4] = {{-250, 0, 0}, {-50, 0, 0}, {150, 0, 0}, {350, 0, 0}}, z = {0, 0, 1};
        scene s = {.count = 3};
        kg_patch_input in = {.point_count = n, .extent = {-30, 30}};
        memcpy(in.points, p, n * sizeof *p);
        if (kg_patch_init(&in, &s.patches[0], NULL))
            continue;
        memcpy(in.points, q, n * sizeof *q);
        in.extent[0] = -s.patches[0].extent[1], in.extent[1] = -s.patches[0].extent[0];
        if (kg_patch_init(&in, &s.patches[1], NULL))
            continue;
        s.patches[2] = make_patch(x, 4, -300, 300, &z);
        kg_cut mirror, plane;
        if (!scene_cut(&s, 0, 1, &mirror) || !scene_cut(&s, 0, 2, &plane) ||
            mirror.crossings->count != 1 || plane.crossings->count != 1 ||
            !(mirror.crossings->branches[0].ends[0] & KG_SIDES_A) ||
            !(mirror.crossings->branches[0].ends[1] & KG_SIDES_A)) {
            scene_clear(&s);
            continue;
        }
        for (int order = 0; order < 2; order++) {
            kg_trim_notes notes = {0};
            kg_regions one = trim_whole(&s, 0, order ? 2 : 1, NULL, 0, NULL),
                       two = trim_by(&s, 0, order ? 1 : 2, &one, NULL, 0, &notes);
            if (two.count != one.count)
                fail_msg("round %d: %zu pieces became %zu", round, one.count, two.count);
            for (size_t i = 0; i < notes.count; i++)
                assert_int_equal(notes.items[i].kind, KG_NOTE_OUTSIDE);
            free(notes.items);
            kg_regions_clear(&one);
            kg_regions_clear(&two);
        }
        done++;
        scene_clear(&s);
    }
    assert_true(done > 30);
}

/* ---- planes ----------------------------------------------------------------------------- */

/* A plane patch from a to b in x and y, z in [lo, hi]. */
static kg_patch wall(double ax, double ay, double bx, double by, double lo, double hi) {
    kg_vec3 p[4];
    const kg_vec3 up = {0, 0, 1};
    for (int i = 0; i < 4; i++)
        p[i] = kg_v3(ax + (bx - ax) * i / 3, ay + (by - ay) * i / 3, 0);
    return make_patch(p, 4, lo, hi, &up);
}

/* z = 0, x in [0, 100], y in [-50, 50]; u runs along y or against it. */
static scene floor_scene(void) {
    const kg_vec3 p[4] = {{0, 0, 0}, {100.0 / 3, 0, 0}, {200.0 / 3, 0, 0}, {100, 0, 0}},
                  y = {0, 1, 0};
    scene s = {.count = 1};
    s.patches[0] = make_patch(p, 4, -50, 50, &y);
    return s;
}

static void a_cut_that_ends_inside_is_prolonged_with_a_note(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 20, -5, 5);
    kg_trim_notes notes = {0};
    kg_regions out = trim_whole(&s, 0, 1, NULL, 0, &notes);
    assert_int_equal(out.count, 2);
    assert_int_equal(notes.count, 1);
    assert_int_equal(notes.items[0].kind, KG_NOTE_PROLONGED);
    assert_int_equal(notes.items[0].source, 2);
    assert_near(notes.items[0].length, 30, 0.01);
    assert_near(kg_dist(notes.items[0].place, kg_v3(30, 20, 0)), 0, 1e-9);
    const kg_region_loop *loop;
    assert_non_null(edge_of(&out, KG_EDGE_TAIL, 2, &loop));
    free(notes.items);
    kg_regions_clear(&out);

    /* a gap that nobody could cut is closed in silence */
    scene_clear(&s);
    s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 50 - 1e-4, -5, 5);
    notes = (kg_trim_notes){0};
    out = trim_whole(&s, 0, 1, NULL, 0, &notes);
    assert_int_equal(out.count, 2);
    assert_int_equal(notes.count, 0);
    kg_regions_clear(&out);
    scene_clear(&s);
}

static void a_cutter_that_misses_is_an_error_and_one_that_comes_too_late_a_note(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 60, -5, 5);
    s.patches[s.count++] = wall(10, -60, 10, 60, -5, 5);
    s.patches[s.count++] = wall(10, -60, 10, 60, 1, 5);
    kg_cut cut;
    kg_regions all = whole(&s, 0), out = {5, NULL};
    kg_trim_notes notes = {0};
    kg_trim trim = scene_trim(&s, 0, &notes);
    kg_error error = {0};
    assert_true(scene_cut(&s, 0, 3, &cut));
    assert_int_equal(kg_trim_by(&trim, &all, &cut, NULL, 0, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "patch 4"));
    assert_int_equal(out.count, 5);
    const kg_vec3 keep = {60, 0, 0};
    kg_regions right = trim_whole(&s, 0, 1, &keep, 1, NULL),
               same = trim_by(&s, 0, 2, &right, NULL, 0, &notes);
    assert_int_equal(right.count, 1);
    assert_int_equal(same.count, 1);
    assert_near(total(&s, 0, &same).space_moment, 7000, 1e-6);
    assert_int_equal(notes.count, 1);
    assert_int_equal(notes.items[0].kind, KG_NOTE_OUTSIDE);
    assert_int_equal(notes.items[0].source, 3);
    free(notes.items);
    kg_regions_clear(&all);
    kg_regions_clear(&right);
    kg_regions_clear(&same);
    scene_clear(&s);
}

static void only_the_trimmed_region_of_a_bounded_cutter_cuts(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 60, -5, 5);
    s.patches[s.count++] = wall(0, 0, 100, 0, -5, 5);
    const kg_vec3 keep = {30, -30, 0};
    kg_regions half = trim_whole(&s, 1, 2, &keep, 1, NULL), all = whole(&s, 0), out;
    kg_cut cut;
    assert_true(scene_cut(&s, 0, 1, &cut));
    cut.bounded = &half;
    kg_trim_notes notes = {0};
    kg_trim trim = scene_trim(&s, 0, &notes);
    assert_int_equal(kg_trim_by(&trim, &all, &cut, NULL, 0, &out, NULL), KG_OK);
    check_regions(&s, 0, &out, "bounded");
    assert_int_equal(out.count, 2); /* from y = -60 to 0, then prolonged */
    assert_int_equal(notes.count, 1);
    assert_near(notes.items[0].length, 50, 0.01);
    assert_near(kg_dist(notes.items[0].place, kg_v3(30, 0, 0)), 0, 1e-6);
    kg_regions_clear(&out);

    /* after a cut along y = 0 it ends on an edge, and only one of the pieces is cut */
    kg_regions two = trim_whole(&s, 0, 2, NULL, 0, NULL);
    free(notes.items);
    notes = (kg_trim_notes){0};
    assert_int_equal(kg_trim_by(&trim, &two, &cut, NULL, 0, &out, NULL), KG_OK);
    assert_int_equal(notes.count, 0);
    double areas[PIECES_MAX];
    assert_int_equal(areas_of(&s.patches[0], &out, areas), 3);
    assert_near(areas[0], 5000, 0.1);
    assert_near(areas[1], 3500, 0.1);
    kg_regions_clear(&all);
    kg_regions_clear(&half);
    kg_regions_clear(&two);
    kg_regions_clear(&out);
    scene_clear(&s);
}

static void a_bounded_cutter_of_which_nothing_is_left_there_is_an_error(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 60, -5, 5);
    s.patches[s.count++] = s.patches[0]; /* the ceiling of what stays of the wall */
    for (int i = 0; i < 4; i++)
        s.patches[2].geodesic.points[i].z = 2;
    s.patches[2] = make_patch(s.patches[2].geodesic.points, 4, -70, 70, &s.patches[0].rulings[0]);
    const kg_vec3 above = {30, 0, 4};
    kg_regions top = trim_whole(&s, 1, 2, &above, 1, NULL), all = whole(&s, 0), out = {5, NULL};
    kg_cut cut;
    kg_trim_notes notes = {0};
    kg_trim trim = scene_trim(&s, 0, &notes);
    kg_error error = {0};
    assert_true(scene_cut(&s, 0, 1, &cut));
    cut.bounded = &top;
    assert_int_equal(kg_trim_by(&trim, &all, &cut, NULL, 0, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "patch 2 does not meet it with what is left of it"));
    assert_int_equal(kg_trim_inside(&trim, &all, &cut, 1, NULL, 0, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "patch 2 does not meet it with what is left of it"));
    assert_int_equal(out.count, 5);
    assert_int_equal(notes.count, 0);

    /* where what is left of it meets the patch, but not what is left of the patch: a note */
    const kg_vec3 below = {30, 0, -4}, right = {60, 0, 0};
    kg_regions bottom = trim_whole(&s, 1, 2, &below, 1, NULL),
               half = trim_whole(&s, 0, 1, &right, 1, NULL);
    cut.bounded = &bottom;
    assert_int_equal(kg_trim_by(&trim, &half, &cut, NULL, 0, &out, &error), KG_OK);
    assert_int_equal(out.count, 1);
    assert_int_equal(notes.count, 1);
    assert_int_equal(notes.items[0].kind, KG_NOTE_OUTSIDE);
    free(notes.items);
    kg_regions_clear(&top);
    kg_regions_clear(&bottom);
    kg_regions_clear(&half);
    kg_regions_clear(&all);
    kg_regions_clear(&out);
    scene_clear(&s);
}

/* A ends on B, then what is left of A cuts B, with its boundary. */
static void a_bounded_cutter_that_ends_on_the_patch_cuts_it(void **state) {
    (void)state;
    kg_random r = {116};
    for (int done = 0; done < 40;) {
        scene s = random_scene(&r, 2, kg_v3(0, 0, 0));
        kg_cut there, back;
        kg_trim_notes notes = {0};
        const kg_vec3 keep = kg_patch_point(&s.patches[0], s.patches[0].extent[0], 0);
        if (scene_cut(&s, 0, 1, &there) && there.crossings->count == 1) {
            kg_regions left = trim_whole(&s, 0, 1, &keep, 1, &notes), all = whole(&s, 1), out;
            kg_regions expected = trim_whole(&s, 1, 0, NULL, 0, NULL);
            kg_trim trim = scene_trim(&s, 1, NULL);
            assert_true(scene_cut(&s, 1, 0, &back));
            back.bounded = &left;
            kg_error error = {0};
            if (kg_trim_by(&trim, &all, &back, NULL, 0, &out, &error))
                fail_msg("%s", error.message);
            if (notes.count == 0) { /* else A ends partly beside B */
                double x[PIECES_MAX], y[PIECES_MAX];
                assert_int_equal(out.count, expected.count);
                areas_of(&s.patches[1], &out, x);
                areas_of(&s.patches[1], &expected, y);
                for (size_t i = 0; i < out.count; i++)
                    assert_near(x[i], y[i], 1e-5 * y[0]);
                done++;
            }
            kg_regions_clear(&left);
            kg_regions_clear(&all);
            kg_regions_clear(&out);
            kg_regions_clear(&expected);
        }
        free(notes.items);
        scene_clear(&s);
    }
}

/* ---- keep points ------------------------------------------------------------------------ */

/* Distance to a region by a fine grid of its patch: never too small, at most `grain` too large. */
static double grid_distance(const kg_patch *p, const kg_region *r, kg_vec3 at, double *out_grain) {
    enum { N = 100 };
    double best = INFINITY, du = (p->extent[1] - p->extent[0]) / N, widest = 0;
    kg_vec3 last = {0, 0, 0};
    for (int j = 0; j <= N; j++)
        for (int i = 0; i <= N; i++) {
            double u = p->extent[0] + du * i, v = (double)j / N;
            kg_vec3 x = kg_patch_point(p, u, v);
            if (i == N && j > 0)
                widest = fmax(widest, kg_dist(x, last));
            if (i == N)
                last = x;
            if (kg_region_contains(r, u, v))
                best = fmin(best, kg_dist(x, at));
        }
    *out_grain = du + 3 * widest;
    return best;
}

static void each_keep_point_keeps_the_piece_nearest_to_it(void **state) {
    (void)state;
    kg_random r = {115};
    for (int done = 0; done < 30;) {
        scene s = random_scene(&r, 2, kg_v3(0, 0, 0));
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count > 0) {
            kg_regions all = trim_whole(&s, 0, 1, NULL, 0, NULL);
            kg_vec3 keep = {kg_random_in(&r, -70, 70), kg_random_in(&r, -70, 70),
                            kg_random_in(&r, -70, 70)};
            kg_regions one = trim_whole(&s, 0, 1, &keep, 1, NULL);
            assert_int_equal(one.count, 1);
            double grain, own = grid_distance(&s.patches[0], &one.items[0], keep, &grain);
            assert_near(kg_region_distance(&s.patches[0], &one.items[0], keep), own, grain);
            for (size_t i = 0; i < all.count; i++)
                assert_true(own <=
                            grid_distance(&s.patches[0], &all.items[i], keep, &grain) + grain);
            kg_regions_clear(&all);
            kg_regions_clear(&one);
            done++;
        }
        scene_clear(&s);
    }
}

static void several_keep_points_keep_several_pieces_and_ties_one(void **state) {
    (void)state;
    scene s = floor_scene();
    s.patches[s.count++] = wall(30, -60, 30, 60, -5, 5);
    const kg_vec3 points[3] = {{10, 0, 3}, {20, 40, -9}, {90, 0, 0}};
    kg_regions out = trim_whole(&s, 0, 1, points, 2, NULL);
    assert_int_equal(out.count, 1);
    assert_near(total(&s, 0, &out).space_moment, 3000, 1e-6);
    kg_regions_clear(&out);
    out = trim_whole(&s, 0, 1, points, 3, NULL);
    assert_int_equal(out.count, 2);
    kg_regions_clear(&out);
    const kg_vec3 tie = {30, 0, 7};
    out = trim_whole(&s, 0, 1, &tie, 1, NULL);
    assert_int_equal(out.count, 1);
    kg_regions_clear(&out);
    scene_clear(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_sides_of_a_seam_are_equally_long_and_share_points),
        cmocka_unit_test(cutting_twice_by_the_same_patch_changes_nothing),
        cmocka_unit_test(three_patches_meet_in_one_curve),
        cmocka_unit_test(a_cut_that_ends_inside_is_prolonged_with_a_note),
        cmocka_unit_test(a_cutter_that_misses_is_an_error_and_one_that_comes_too_late_a_note),
        cmocka_unit_test(only_the_trimmed_region_of_a_bounded_cutter_cuts),
        cmocka_unit_test(a_bounded_cutter_of_which_nothing_is_left_there_is_an_error),
        cmocka_unit_test(a_bounded_cutter_that_ends_on_the_patch_cuts_it),
        cmocka_unit_test(each_keep_point_keeps_the_piece_nearest_to_it),
        cmocka_unit_test(several_keep_points_keep_several_pieces_and_ties_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
