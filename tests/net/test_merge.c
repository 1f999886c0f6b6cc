#include "katagami/net.h"
#include "net/merge.h"
#include "tests/check.h"

#include <stdlib.h>

enum { STEPS = 3, MAX_FACES = 16, MAX_CORNERS = 12 };

/* A polyhedron as flat faces: corner ids, and where the corners lie on each face's own paper. */
typedef struct solid {
    int faces;
    int sizes[MAX_FACES];
    int corners[MAX_FACES][MAX_CORNERS];
    kg_vec2 flat[MAX_FACES][MAX_CORNERS];
} solid;

static kg_net *net_of(const solid *s, double fold) {
    kg_net *net = kg_net_create();
    assert_non_null(net);
    for (int f = 0; f < s->faces; f++) {
        kg_vec2 points[MAX_CORNERS * STEPS];
        unsigned char corners[MAX_CORNERS * STEPS] = {0};
        size_t part, n = 0;
        for (int i = 0; i < s->sizes[f]; i++)
            for (int k = 0; k < STEPS; k++) {
                corners[n] = k == 0;
                points[n++] =
                    kg_lerp2(s->flat[f][i], s->flat[f][(i + 1) % s->sizes[f]], (double)k / STEPS);
            }
        assert_int_equal(kg_net_add_part(net, f + 1, "face", &part, NULL), KG_OK);
        assert_int_equal(kg_net_add_loop(net, part, points, corners, n, NULL), KG_OK);
        double area = 0;
        for (size_t i = 0; i < n; i++)
            area += 0.5 * kg_cross2(points[i], points[(i + 1) % n]);
        net->parts[part].area = area;
    }
    for (int f = 0; f < s->faces; f++)
        for (int i = 0; i < s->sizes[f]; i++)
            for (int g = f + 1; g < s->faces; g++)
                for (int j = 0; j < s->sizes[g]; j++) {
                    if (s->corners[f][i] != s->corners[g][(j + 1) % s->sizes[g]] ||
                        s->corners[g][j] != s->corners[f][(i + 1) % s->sizes[f]])
                        continue;
                    double length = kg_dist2(s->flat[f][i], s->flat[f][(i + 1) % s->sizes[f]]);
                    kg_net_join join = {
                        .kind = KG_JOIN_SEAM,
                        .sources = {f + 1, g + 1},
                        .fold = {fold, fold},
                        .sides = {{f, 0, (size_t)(i * STEPS), STEPS + 1, -1, length, false},
                                  {g, 0, (size_t)(j * STEPS), STEPS + 1, -1, length, true}}};
                    assert_int_equal(kg_net_add_join(net, &join, NULL, NULL), KG_OK);
                }
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    return net;
}

static solid cube(double a) {
    solid s = {
        .faces = 6,
        .sizes = {4, 4, 4, 4, 4, 4},
        .corners = {
            {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    for (int f = 0; f < 6; f++) {
        kg_vec2 square[4] = {{0, 0}, {a, 0}, {a, a}, {0, a}};
        memcpy(s.flat[f], square, sizeof square);
    }
    return s;
}

static kg_merge_report merge_all(kg_net *net, kg_vec2 room) {
    kg_merge_report report;
    kg_merge_options options = {.all = true, .room = room};
    assert_int_equal(kg_net_merge(net, &options, &report, NULL), KG_OK);
    return report;
}

/* Every join's stretches are as long as they say and every fold line lies across its part. */
static void check_joins(const kg_net *net) {
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    for (size_t i = 0; i < net->join_count; i++)
        for (int k = 0; k < 2; k++) {
            const kg_net_side *s = &net->joins[i].sides[k];
            const kg_net_line *l = &net->parts[s->part].loops[s->loop].line;
            double sum = 0;
            for (size_t p = 1; p < s->count; p++)
                sum += kg_dist2(l->points[(s->first + p - 1) % l->count],
                                l->points[(s->first + p) % l->count]);
            assert_near(sum, s->length, 1e-9);
        }
}

static double shoelace(const kg_net_line *l) {
    double area = 0;
    for (size_t i = 0; i < l->count; i++)
        area += 0.5 * kg_cross2(l->points[i], l->points[(i + 1) % l->count]);
    return area;
}

static void cube_becomes_one_part_with_five_folds(void **state) {
    (void)state;
    solid s = cube(30);
    kg_net *net = net_of(&s, -1.5);
    assert_int_equal(net->join_count, 12);
    kg_merge_report report = merge_all(net, kg_v2(0, 0));
    assert_int_equal(report.merged, 5);
    assert_int_equal(net->part_count, 1);
    assert_int_equal(net->join_count, 7);
    assert_int_equal(net->parts[0].line_count, 5);
    for (size_t i = 0; i < 5; i++) {
        const kg_net_line *l = &net->parts[0].lines[i];
        assert_int_equal(l->kind, KG_NET_MOUNTAIN);
        assert_near(kg_dist2(l->points[0], l->points[1]), 30, 1e-9);
    }
    assert_near(shoelace(&net->parts[0].loops[0].line), 6 * 900, 1e-6);
    assert_near(net->parts[0].area, 6 * 900, 1e-6);
    check_joins(net);
    kg_net_destroy(net);
}

static void page_limits_how_much_is_merged(void **state) {
    (void)state;
    solid s = cube(30);
    kg_net *net = net_of(&s, 1.5);
    merge_all(net, kg_v2(65, 65));
    assert_in_range(net->part_count, 2, 5);
    for (size_t i = 0; i < net->part_count; i++) {
        kg_box2 box = kg_box2_empty();
        const kg_net_line *l = &net->parts[i].loops[0].line;
        for (size_t k = 0; k < l->count; k++)
            kg_box2_add(&box, l->points[k]);
        assert_true(box.hi.x - box.lo.x <= 65.001 && box.hi.y - box.lo.y <= 65.001);
    }
    check_joins(net);
    kg_net_destroy(net);
}

static void flat_seams_vanish_without_a_fold(void **state) {
    (void)state;
    solid s = cube(10);
    s.faces = 2;
    s.sizes[0] = s.sizes[1] = 4;
    int other[4] = {3, 0, 8, 9};
    memcpy(s.corners[1], other, sizeof other);
    kg_net *net = net_of(&s, 0.001);
    assert_int_equal(net->join_count, 1);
    merge_all(net, kg_v2(0, 0));
    assert_int_equal(net->part_count, 1);
    assert_int_equal(net->parts[0].line_count, 0);
    kg_net_destroy(net);
}

static void refusals_name_their_reason(void **state) {
    (void)state;
    solid s = cube(10);
    s.faces = 2;
    int other[4] = {3, 0, 8, 9};
    memcpy(s.corners[1], other, sizeof other);
    bool wanted[1] = {true};
    kg_merge_options options = {.wanted = wanted};
    kg_merge_report report;

    kg_net *net = net_of(&s, 1);
    net->joins[0].sides[1].reversed = false;
    assert_int_equal(kg_net_merge(net, &options, &report, NULL), KG_OK);
    assert_int_equal(report.remark_count, 1);
    assert_int_equal(report.remarks[0].refusal, KG_MERGE_SIDES);
    free(report.remarks);
    kg_net_destroy(net);

    net = net_of(&s, 1);
    kg_net_line *l = &net->parts[0].loops[0].line;
    l->points[net->joins[0].sides[0].first + 1].y += 0.3;
    l->points[net->joins[0].sides[0].first + 1].x += 0.3;
    assert_int_equal(kg_net_merge(net, &options, &report, NULL), KG_OK);
    assert_int_equal(report.remarks[0].refusal, KG_MERGE_BENT);
    assert_int_equal(net->part_count, 2);
    free(report.remarks);
    kg_net_destroy(net);

    net = net_of(&s, 1);
    options.room = kg_v2(12, 12);
    assert_int_equal(kg_net_merge(net, &options, &report, NULL), KG_OK);
    assert_int_equal(report.remarks[0].refusal, KG_MERGE_TOO_BIG);
    free(report.remarks);
    kg_net_destroy(net);
}

/* Prisms over random polygons: sides are rectangles of the polygon's edges, top and bottom the
 * polygon itself. Whatever merges, no part overlaps itself and nothing is lost. */
static void random_prisms_keep_their_area_and_joins(void **state) {
    (void)state;
    kg_random r = {5};
    for (int round = 0; round < 100; round++) {
        int n = 3 + (int)kg_random_in(&r, 0, 8);
        double height = kg_random_in(&r, 5, 60);
        solid s = {.faces = n + 2};
        kg_vec2 ring[MAX_CORNERS];
        double turn = 0;
        for (int i = 0; i < n; i++)
            turn += kg_random_in(&r, 0.5, 1.5), ring[i].x = turn;
        for (int i = 0; i < n; i++) {
            double angle = 6.283185307179586 * ring[i].x / turn;
            ring[i] = kg_v2(30 * cos(angle), 30 * sin(angle));
        }
        for (int i = 0; i < n; i++) {
            double w = kg_dist2(ring[i], ring[(i + 1) % n]);
            int corners[4] = {i, (i + 1) % n, n + (i + 1) % n, n + i};
            kg_vec2 flat[4] = {{0, 0}, {w, 0}, {w, height}, {0, height}};
            s.sizes[i] = 4;
            memcpy(s.corners[i], corners, sizeof corners);
            memcpy(s.flat[i], flat, sizeof flat);
            s.corners[n][i] = n + i;
            s.flat[n][i] = ring[i];
            s.corners[n + 1][i] = n - 1 - i;
            s.flat[n + 1][i] = kg_v2(ring[n - 1 - i].x, -ring[n - 1 - i].y);
        }
        s.sizes[n] = s.sizes[n + 1] = n;
        kg_net *net = net_of(&s, 1.2);
        size_t joins = net->join_count;
        double before = 0, after = 0;
        for (size_t i = 0; i < net->part_count; i++)
            before += net->parts[i].area;
        kg_merge_report report = merge_all(net, kg_v2(0, 0));
        for (size_t i = 0; i < net->part_count; i++) {
            assert_near(shoelace(&net->parts[i].loops[0].line), net->parts[i].area, 1e-6);
            after += net->parts[i].area;
        }
        assert_near(before, after, 1e-6);
        assert_int_equal(net->join_count, joins - report.merged);
        assert_int_equal(net->part_count, (size_t)n + 2 - report.merged);
        assert_true(report.merged >= (size_t)n);
        check_joins(net);
        kg_net_destroy(net);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube_becomes_one_part_with_five_folds),
        cmocka_unit_test(page_limits_how_much_is_merged),
        cmocka_unit_test(flat_seams_vanish_without_a_fold),
        cmocka_unit_test(refusals_name_their_reason),
        cmocka_unit_test(random_prisms_keep_their_area_and_joins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
