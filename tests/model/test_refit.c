/* Refitted patches are the same surfaces, trimmed to the same regions. */
#include "model/refit.h"
#include "tests/model/random_model.h"

static kg_solution *solve(const kg_model *m) {
    kg_solution *s;
    assert_int_equal(kg_solution_create(m, 0.002, NULL, &s, NULL), KG_OK);
    return s;
}

/* The corner of the regions nearest to a place. */
static double corner_distance(const kg_regions *regions, kg_vec3 x) {
    double best = INFINITY;
    for (size_t i = 0; i < regions->count; i++)
        for (size_t k = 0; k < regions->items[i].loop_count; k++) {
            const kg_region_loop *loop = &regions->items[i].loops[k];
            for (size_t j = 0; j < loop->edge_count; j++)
                best = fmin(best, kg_dist(x, loop->points[loop->edges[j].first].x));
        }
    return best;
}

static void assert_same_in_space(const kg_solution *sa, const kg_solved_patch *a,
                                 const kg_solution *sb, const kg_solved_patch *b) {
    assert_int_equal(a->valid, b->valid);
    assert_int_equal(a->regions.count, b->regions.count);
    for (size_t i = 0; i < a->regions.count; i++) {
        const kg_region *r = &a->regions.items[i];
        kg_measure x = kg_region_measure(&a->patch, r, kg_solution_finder(sa));
        kg_measure y = kg_region_measure(&b->patch, &b->regions.items[i], kg_solution_finder(sb));
        assert_near(x.space_moment, y.space_moment, 1e-6 * x.space_moment);
        assert_near(x.paper_length, y.paper_length, 1e-6 * x.paper_length);
        for (size_t k = 0; k < r->loop_count; k++) {
            if (r->loops[k].edge_count < 2)
                continue; /* a closed curve may begin anywhere */
            for (size_t j = 0; j < r->loops[k].edge_count; j++) {
                kg_vec3 corner = r->loops[k].points[r->loops[k].edges[j].first].x;
                assert_near(corner_distance(&b->regions, corner), 0, 3e-9 * a->patch.size);
            }
        }
    }
}

static void assert_same_surface(const kg_patch *old, const kg_patch *fresh) {
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 4; j++) {
            double v = i / 8.0,
                   u = fresh->extent[0] + (fresh->extent[1] - fresh->extent[0]) * j / 4.0;
            kg_vec3 x = kg_patch_point(fresh, u, v);
            double a, b;
            assert_near(kg_patch_closest(old, x, &a, &b), 0, 1e-9 * old->size);
            assert_near(kg_dist(kg_patch_normal(fresh, v), kg_patch_normal(old, b)), 0, 1e-6);
        }
}

static void refitted_random_models_stay_the_same(void **state) {
    (void)state;
    kg_random r = {131};
    size_t cut_back = 0, refused = 0;
    for (int round = 0; round < 40; round++) {
        kg_model *m = random_model(&r, 6);
        for (size_t i = 0; i < m->patch_count; i++) {
            kg_solution *before = solve(m);
            const kg_solved_patch *p = kg_solution_patch(before, i);
            kg_error error;
            kg_status status = kg_model_refit(m, before, p->id, &error);
            if (!p->valid || p->regions.count == 0) {
                assert_int_equal(status, KG_ERR_INPUT);
            } else if (status) {
                assert_int_equal(status, KG_ERR_INPUT);
                refused++;
            } else {
                kg_solution *after = solve(m);
                assert_same_surface(&p->patch, &kg_solution_patch(after, i)->patch);
                for (size_t k = 0; k < m->patch_count; k++)
                    assert_same_in_space(before, kg_solution_patch(before, k), after,
                                         kg_solution_patch(after, k));
                cut_back += kg_solution_patch(after, i)->patch.length_at[KG_PATCH_CELLS] <
                            0.999 * p->patch.length_at[KG_PATCH_CELLS];
                kg_solution_destroy(after);
            }
            kg_solution_destroy(before);
        }
        kg_model_destroy(m);
    }
    print_message("%zu cut back, %zu refused\n", cut_back, refused);
    assert_true(cut_back > 10 && refused < 10);
}

static void the_interval_keeps_one_percent_and_what_others_use(void **state) {
    (void)state;
    const kg_vec3 y = {0, 1, 0}, z = {0, 0, 1};
    for (int used = 0; used < 2; used++) {
        kg_model *m = checked(kg_model_create());
        add_patch(m, 1, flat_input(kg_v3(0, 0, 0), kg_v3(100, 0, 0), y, -20, 20));
        add_patch(m, 2, flat_input(kg_v3(40, -50, 0), kg_v3(40, 50, 0), z, -20, 20));
        add_patch(m, 3, flat_input(kg_v3(90, -50, 0), kg_v3(90, 50, 0), z, -20, 20));
        kg_trim_op op = trim_by(2);
        keep_near(&op, kg_v3(10, 0, 0));
        insert_trim(&m->patches[0], 0, op);
        kg_trim_op hole = {.kind = KG_TRIM_CONTOUR,
                           .outside = true,
                           .contour_count = 3,
                           .contour = checked(malloc(3 * sizeof *hole.contour))};
        hole.contour[0] = kg_v2(0, 0.1);
        hole.contour[1] = kg_v2(5, 0.1);
        hole.contour[2] = kg_v2(0, 0.2);
        insert_trim(&m->patches[0], 1, hole);
        if (used)
            insert_trim(&m->patches[2], 0, trim_by(1));
        kg_solution *s = solve(m);
        assert_int_equal(kg_solution_check(s, NULL), KG_OK);
        assert_int_equal(kg_model_refit(m, s, 1, NULL), KG_OK);
        double end = used ? 90.9 : 40.4;
        assert_near(m->patches[0].input.points[0].x, 0, 1e-12);
        assert_near(m->patches[0].input.points[3].x, end, 1e-9);
        assert_near(m->patches[0].trims[1].contour[2].y, 20 / end, 1e-12);
        assert_near(m->patches[0].trims[1].contour[1].x, 5, 0);
        /* again: nothing is left to cut off but the margin's own percent */
        kg_solution_destroy(s);
        s = solve(m);
        assert_int_equal(kg_model_refit(m, s, 1, NULL), KG_OK);
        assert_near(m->patches[0].input.points[3].x, end, 1e-9);
        assert_int_equal(kg_model_refit(m, s, 9, NULL), KG_ERR_INPUT);
        kg_solution_destroy(s);
        kg_model_destroy(m);
    }
}

/* The bend before a planar inflection gives the rulings their direction; cut off, they turn round,
 * and extent, contour and side with them. */
static void rulings_that_turn_round_take_extent_and_contours_with_them(void **state) {
    (void)state;
    kg_model *m = checked(kg_model_create());
    kg_patch_input in = {.point_count = 4, .extent = {-10, 30}};
    in.points[0] = kg_v3(0, 0, 0), in.points[1] = kg_v3(30, 0, 20);
    in.points[2] = kg_v3(70, 0, -20), in.points[3] = kg_v3(100, 0, 0);
    add_patch(m, 1, in);
    add_patch(m, 2, flat_input(kg_v3(60, -50, 0), kg_v3(60, 50, 0), kg_v3(0, 0, 1), -40, 40));
    kg_trim_op op = trim_by(2), hole = {.kind = KG_TRIM_CONTOUR,
                                        .outside = true,
                                        .contour_count = 3,
                                        .contour = checked(malloc(3 * sizeof *hole.contour))};
    keep_near(&op, kg_v3(90, 0, 0));
    insert_trim(&m->patches[0], 0, op);
    hole.contour[0] = kg_v2(5, 0.8);
    hole.contour[1] = kg_v2(25, 0.8);
    hole.contour[2] = kg_v2(5, 0.9);
    insert_trim(&m->patches[0], 1, hole);
    kg_solution *before = solve(m);
    assert_int_equal(kg_solution_check(before, NULL), KG_OK);
    assert_int_equal(kg_model_refit(m, before, 1, NULL), KG_OK);
    kg_solution *after = solve(m);
    assert_near(m->patches[0].input.extent[0], -30, 0);
    assert_near(m->patches[0].input.extent[1], 10, 0);
    assert_true(m->patches[0].input.flip);
    assert_near(m->patches[0].trims[1].contour[1].x, -25, 0);
    assert_same_surface(&kg_solution_patch(before, 0)->patch, &kg_solution_patch(after, 0)->patch);
    assert_same_in_space(before, kg_solution_patch(before, 0), after, kg_solution_patch(after, 0));
    kg_solution_destroy(before);
    kg_solution_destroy(after);
    kg_model_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refitted_random_models_stay_the_same),
        cmocka_unit_test(the_interval_keeps_one_percent_and_what_others_use),
        cmocka_unit_test(rulings_that_turn_round_take_extent_and_contours_with_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
