/* Solutions of models: what they say, and that solving anew what changed gives the same as solving
 * everything. */
#include "tests/model/random_model.h"

#include <time.h>

static kg_solution *solve(const kg_model *m, double tolerance, kg_solution *previous) {
    kg_solution *s = NULL;
    kg_error error;
    if (kg_solution_create(m, tolerance, previous, &s, &error))
        fail_msg("%s", error.message);
    return s;
}

static const kg_issue *find_issue(const kg_solution *s, const char *code, int64_t patch) {
    for (size_t i = 0; i < kg_solution_issue_count(s); i++) {
        const kg_issue *issue = kg_solution_issue(s, i);
        if (strcmp(issue->code, code) == 0 && issue->patch == patch)
            return issue;
    }
    return NULL;
}

static double area_of(const kg_solution *s, int64_t id) {
    const kg_solved_patch *p = kg_solution_find(s, id);
    double sum = 0;
    for (size_t i = 0; i < p->regions.count; i++)
        sum +=
            kg_region_measure(&p->patch, &p->regions.items[i], kg_solution_finder(s)).paper_moment;
    return sum;
}

static void remove_trim(kg_model_patch *p, size_t at) {
    free(p->trims[at].by);
    free(p->trims[at].keep);
    free(p->trims[at].contour);
    memmove(p->trims + at, p->trims + at + 1, (p->trim_count - 1 - at) * sizeof *p->trims);
    p->trim_count--;
}

/* ---- incremental ------------------------------------------------------------------------ */

static void assert_same_loop(const kg_region_loop *a, const kg_region_loop *b) {
    assert_int_equal(a->point_count, b->point_count);
    assert_memory_equal(a->points, b->points, a->point_count * sizeof *a->points);
    assert_int_equal(a->edge_count, b->edge_count);
    assert_memory_equal(a->ends, b->ends, a->edge_count * sizeof *a->ends);
    for (size_t i = 0; i < a->edge_count; i++) {
        assert_int_equal(a->edges[i].kind, b->edges[i].kind);
        assert_int_equal(a->edges[i].source, b->edges[i].source);
        assert_int_equal(a->edges[i].first, b->edges[i].first);
        assert_int_equal(a->edges[i].count, b->edges[i].count);
    }
}

static void assert_same(const kg_solution *a, const kg_solution *b) {
    assert_int_equal(kg_solution_count(a), kg_solution_count(b));
    for (size_t i = 0; i < kg_solution_count(a); i++) {
        const kg_solved_patch *p = kg_solution_patch(a, i), *q = kg_solution_patch(b, i);
        assert_int_equal(p->id, q->id);
        assert_int_equal(p->valid, q->valid);
        assert_int_equal(p->prepared, q->prepared);
        assert_int_equal(p->regions.count, q->regions.count);
        for (size_t k = 0; k < p->regions.count; k++) {
            assert_int_equal(p->regions.items[k].loop_count, q->regions.items[k].loop_count);
            for (size_t l = 0; l < p->regions.items[k].loop_count; l++)
                assert_same_loop(&p->regions.items[k].loops[l], &q->regions.items[k].loops[l]);
        }
    }
    assert_int_equal(kg_solution_issue_count(a), kg_solution_issue_count(b));
    for (size_t i = 0; i < kg_solution_issue_count(a); i++) {
        const kg_issue *x = kg_solution_issue(a, i), *y = kg_solution_issue(b, i);
        assert_int_equal(x->severity, y->severity);
        assert_int_equal(x->patch, y->patch);
        assert_string_equal(x->code, y->code);
        assert_string_equal(x->message, y->message);
    }
}

/* Takes a patch out of the model and every trim that names it. */
static void delete_patch(kg_model *m, size_t at) {
    int64_t id = m->patches[at].id;
    while (m->patches[at].trim_count > 0)
        remove_trim(&m->patches[at], 0);
    free(m->patches[at].trims);
    free(m->patches[at].name);
    memmove(m->patches + at, m->patches + at + 1, (m->patch_count - 1 - at) * sizeof *m->patches);
    m->patch_count--;
    for (size_t i = 0; i < m->patch_count; i++)
        for (size_t n = m->patches[i].trim_count; n-- > 0;) {
            const kg_trim_op *op = &m->patches[i].trims[n];
            bool named = false;
            for (size_t b = 0; b < op->by_count; b++)
                named = named || op->by[b] == id;
            if (named)
                remove_trim(&m->patches[i], n);
        }
}

static void edit(kg_random *r, kg_model *m, double *tolerance) {
    kg_model_patch *p = &m->patches[kg_random_bits(r) % m->patch_count];
    size_t n = p->trim_count, at = n ? kg_random_bits(r) % n : 0;
    switch (kg_random_bits(r) % 9) {
    case 0:
        p->input.points[kg_random_bits(r) % 4].z += kg_random_in(r, -3, 3);
        break;
    case 1:
        p->input.extent[1] += kg_random_in(r, 0, 3);
        break;
    case 2:
        insert_trim(p, at, random_trim(r, m, p->id));
        break;
    case 3:
        if (n > 0)
            remove_trim(p, at);
        break;
    case 4:
        if (n > 1) {
            kg_trim_op op = p->trims[0];
            p->trims[0] = p->trims[n - 1];
            p->trims[n - 1] = op;
        }
        break;
    case 5:
        if (n > 0)
            p->trims[at].off = !p->trims[at].off;
        break;
    case 6:
        if (m->patch_count > 4)
            delete_patch(m, kg_random_bits(r) % m->patch_count);
        break;
    case 7:
        p->input.flip = !p->input.flip;
        break;
    default:
        *tolerance = *tolerance == 0.01 ? 0.02 : 0.01;
    }
}

static void solving_what_changed_gives_what_solving_all_gives(void **state) {
    (void)state;
    kg_random r = {7};
    size_t regions = 0, faults = 0;
    for (int model = 0; model < 30; model++) {
        kg_model *m = random_model(&r, 8);
        double tolerance = 0.01;
        kg_solution *kept = solve(m, tolerance, NULL);
        for (int step = 0; step < 15; step++) {
            edit(&r, m, &tolerance);
            kept = solve(m, tolerance, kept);
            kg_solution *fresh = solve(m, tolerance, NULL);
            assert_same(kept, fresh);
            for (size_t i = 0; i < kg_solution_count(fresh); i++)
                regions += kg_solution_patch(fresh, i)->regions.count;
            faults += kg_solution_check(fresh, NULL) != KG_OK;
            kg_solution_destroy(fresh);
        }
        kg_solution_destroy(kept);
        kg_model_destroy(m);
    }
    assert_true(regions > 1000 && faults > 20); /* the models are worth the test */
}

/* ---- faults ----------------------------------------------------------------------------- */

/* Patch 1 the ground, patch 2 a wall through it, patch 3 far away from both. */
static kg_model *ground_and_wall(void) {
    kg_model *m = checked(kg_model_create());
    add_patch(m, 1, flat_input(kg_v3(0, 0, 0), kg_v3(100, 0, 0), kg_v3(0, 1, 0), -50, 50));
    add_patch(m, 2, flat_input(kg_v3(50, 0, -20), kg_v3(50, 0, 60), kg_v3(0, 1, 0), -30, 30));
    add_patch(m, 3, flat_input(kg_v3(500, 0, 0), kg_v3(600, 0, 0), kg_v3(0, 1, 0), -9, 9));
    return m;
}

static void a_fault_loses_no_other_patch(void **state) {
    (void)state;
    kg_model *m = ground_and_wall();
    insert_trim(&m->patches[0], 0, trim_by(3)); /* misses */
    insert_trim(&m->patches[1], 0, trim_by(1));
    keep_near(&m->patches[1].trims[0], kg_v3(50, 0, 40));
    kg_solution *s = solve(m, 0.001, NULL);
    kg_error error;
    assert_int_equal(kg_solution_check(s, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "patch 1: "));
    assert_non_null(find_issue(s, "bad-trim", 1));
    assert_int_equal(kg_solution_find(s, 1)->regions.count, 0);
    assert_near(area_of(s, 2), 60 * 60, 1e-9); /* cut by the whole rectangle of the faulty one */
    assert_near(area_of(s, 3), 100 * 18, 1e-9);
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void a_patch_that_cannot_be_made_is_named_by_those_it_cuts(void **state) {
    (void)state;
    kg_model *m = ground_and_wall();
    for (int i = 0; i < 4; i++)
        m->patches[0].input.points[i] = kg_v3(0, 0, 0);
    insert_trim(&m->patches[1], 0, trim_by(1));
    kg_solution *s = solve(m, 0.001, NULL);
    assert_non_null(find_issue(s, "bad-patch", 1));
    const kg_issue *issue = find_issue(s, "bad-trim", 2);
    assert_non_null(issue);
    assert_non_null(strstr(issue->message, "patch 1"));
    assert_null(find_issue(s, "bad-trim", 3));
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void circles_of_trimmed_regions_are_faults(void **state) {
    (void)state;
    kg_model *m = ground_and_wall();
    kg_trim_op by_wall = trim_by(2), by_ground = trim_by(1);
    by_wall.bounded = by_ground.bounded = true;
    insert_trim(&m->patches[0], 0, by_wall);
    insert_trim(&m->patches[1], 0, by_ground);
    kg_solution *s = solve(m, 0.001, NULL);
    const kg_issue *issue = find_issue(s, "bad-trim", 2);
    assert_non_null(issue);
    assert_non_null(strstr(issue->message, "bounded"));
    assert_non_null(find_issue(s, "bad-trim", 1));
    assert_true(kg_solution_find(s, 3)->valid);
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void long_chains_of_trimmed_regions_are_refused_without_a_crash(void **state) {
    (void)state;
    kg_model *m = checked(kg_model_create());
    enum { COUNT = 3000 };
    for (int i = 0; i < COUNT; i++) {
        kg_patch_input in = flat_input(kg_v3(0, 0, 0), kg_v3(9, 0, 0), kg_v3(0, 1, 0), -1, 1);
        kg_model_patch *p = add_patch(m, i + 1, in);
        kg_trim_op op = trim_by((i + 1) % COUNT + 1);
        op.bounded = true;
        insert_trim(p, 0, op);
    }
    kg_solution *s = solve(m, 0.001, NULL);
    assert_int_equal(kg_solution_check(s, NULL), KG_ERR_INPUT);
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void a_bounded_cut_reaches_only_as_far_as_the_cutter_is_left(void **state) {
    (void)state;
    /* the wall ends above the ground after its own trim by patch 4, so that it cuts nothing */
    kg_model *m = ground_and_wall();
    add_patch(m, 4, flat_input(kg_v3(0, 0, 10), kg_v3(100, 0, 10), kg_v3(0, 1, 0), -50, 50));
    insert_trim(&m->patches[1], 0, trim_by(4));
    keep_near(&m->patches[1].trims[0], kg_v3(50, 0, 40));
    kg_trim_op op = trim_by(2);
    insert_trim(&m->patches[0], 0, op);
    kg_solution *s = solve(m, 0.001, NULL);
    assert_true(kg_solution_find(s, 1)->valid); /* the whole wall cuts, prolonged to both sides */
    assert_int_equal(kg_solution_find(s, 1)->regions.count, 2);
    assert_non_null(find_issue(s, "cut-prolonged", 1));
    m->patches[0].trims[0].bounded = true;
    s = solve(m, 0.001, s);
    assert_false(kg_solution_find(s, 1)->valid);
    const kg_issue *issue = find_issue(s, "bad-trim", 1);
    assert_non_null(issue);
    assert_non_null(strstr(issue->message, "with what is left of it"));
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

/* A box of four walls, 60 x 40, from z = 0 to 50, and a lid at z = 30 cut out by them. */
static kg_model *box_with_lid(bool trim_walls) {
    kg_model *m = checked(kg_model_create());
    const kg_vec3 corner[4] = {{30, 20, 0}, {-30, 20, 0}, {-30, -20, 0}, {30, -20, 0}};
    for (int i = 0; i < 4; i++) {
        kg_vec3 a = corner[i], b = corner[(i + 1) % 4], d = kg_unit(kg_sub(b, a));
        add_patch(m, i + 1, flat_input(kg_madd(a, -5, d), kg_madd(b, 5, d), kg_v3(0, 0, 1), 0, 50));
    }
    kg_model_patch *lid =
        add_patch(m, 9, flat_input(kg_v3(-50, 0, 30), kg_v3(50, 0, 30), kg_v3(0, 1, 0), -45, 45));
    kg_trim_op op = {.kind = KG_TRIM_INSIDE,
                     .trim_cutters = trim_walls,
                     .by_count = 4,
                     .by = checked(malloc(4 * sizeof *op.by))};
    for (int i = 0; i < 4; i++)
        op.by[i] = i + 1;
    insert_trim(lid, 0, op);
    return m;
}

static void a_lid_is_cut_out_by_its_walls_and_cuts_them(void **state) {
    (void)state;
    kg_model *m = box_with_lid(false);
    kg_solution *s = solve(m, 0.001, NULL);
    assert_near(area_of(s, 9), 60 * 40, 1e-6);
    assert_near(area_of(s, 1), 70 * 50, 1e-6);
    m->patches[4].trims[0].trim_cutters = true;
    s = solve(m, 0.001, s);
    kg_error error = {0};
    if (kg_solution_check(s, &error))
        fail_msg("%s", error.message);
    assert_near(area_of(s, 9), 60 * 40, 1e-6);
    for (int i = 1; i <= 4; i++) { /* the larger piece along the lid is the one below */
        assert_int_equal(kg_solution_find(s, i)->regions.count, 1);
        assert_near(area_of(s, i), (i & 1 ? 70 : 50) * 30, 1e-6);
    }
    m->patches[4].trims[0].off = true;
    s = solve(m, 0.001, s);
    assert_near(area_of(s, 1), 70 * 50, 1e-6);
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void a_cutter_trimmed_away_from_the_face_is_a_fault(void **state) {
    (void)state;
    kg_model *m = box_with_lid(true);
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR,
                     .contour_count = 4,
                     .contour = checked(malloc(4 * sizeof *op.contour))};
    const kg_vec2 low[4] = {{1, 0.1}, {10, 0.1}, {10, 0.9}, {1, 0.9}};
    memcpy(op.contour, low, sizeof low);
    insert_trim(&m->patches[0], 0, op);
    kg_solution *s = solve(m, 0.001, NULL);
    assert_false(kg_solution_find(s, 1)->valid);
    assert_true(kg_solution_find(s, 2)->valid && kg_solution_find(s, 9)->valid);
    kg_solution_destroy(s);
    kg_model_destroy(m);
}

static void faults_come_first_and_keep_the_order_of_the_model(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 8; round++) {
        kg_model *m = random_model(&r, 10);
        kg_solution *s = solve(m, 0.02, NULL);
        for (size_t i = 1; i < kg_solution_issue_count(s); i++) {
            const kg_issue *a = kg_solution_issue(s, i - 1), *b = kg_solution_issue(s, i);
            assert_true(a->severity >= b->severity);
            assert_true(a->severity > b->severity || a->patch <= b->patch);
        }
        kg_solution_destroy(s);
        kg_model_destroy(m);
    }
}

/* ---- growth ----------------------------------------------------------------------------- */

/* `count` pairs of a ground and a wall, each wall trimmed by its ground. */
static double seconds_for(size_t count) {
    kg_model *m = checked(kg_model_create());
    for (size_t i = 0; i < count; i++) {
        double x = 200 * (double)i;
        add_patch(m, (int64_t)(2 * i + 1),
                  flat_input(kg_v3(x, 0, 0), kg_v3(x + 100, 0, 0), kg_v3(0, 1, 0), -50, 50));
        kg_model_patch *wall = add_patch(
            m, (int64_t)(2 * i + 2),
            flat_input(kg_v3(x + 50, 0, -20), kg_v3(x + 50, 0, 60), kg_v3(0, 1, 0), -30, 30));
        insert_trim(wall, 0, trim_by((int64_t)(2 * i + 1)));
    }
    struct timespec t0, t1;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t0);
    kg_solution *s = solve(m, 0.001, NULL);
    s = solve(m, 0.001, s);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t1);
    assert_int_equal(kg_solution_issue_count(s), 0);
    kg_solution_destroy(s);
    kg_model_destroy(m);
    return (double)(t1.tv_sec - t0.tv_sec) + 1e-9 * (double)(t1.tv_nsec - t0.tv_nsec);
}

static void time_grows_with_the_number_of_patches_not_its_square(void **state) {
    (void)state;
    /* Linear: 8; quadratic: 64. What else the machine does only ever adds, so the least counts. */
    double few = INFINITY, many = INFINITY;
    for (int i = 0; i < 20 && !(many < 24 * few && i > 0); i++) {
        few = fmin(few, seconds_for(500));
        many = fmin(many, seconds_for(4000));
    }
    print_message("1000 patches %.1f ms, 8000 patches %.1f ms\n", 1e3 * few, 1e3 * many);
    assert_true(many < 24 * few);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solving_what_changed_gives_what_solving_all_gives),
        cmocka_unit_test(a_fault_loses_no_other_patch),
        cmocka_unit_test(a_patch_that_cannot_be_made_is_named_by_those_it_cuts),
        cmocka_unit_test(circles_of_trimmed_regions_are_faults),
        cmocka_unit_test(long_chains_of_trimmed_regions_are_refused_without_a_crash),
        cmocka_unit_test(a_bounded_cut_reaches_only_as_far_as_the_cutter_is_left),
        cmocka_unit_test(a_lid_is_cut_out_by_its_walls_and_cuts_them),
        cmocka_unit_test(a_cutter_trimmed_away_from_the_face_is_a_fault),
        cmocka_unit_test(faults_come_first_and_keep_the_order_of_the_model),
        cmocka_unit_test(time_grows_with_the_number_of_patches_not_its_square),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
