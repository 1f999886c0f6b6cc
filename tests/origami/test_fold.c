/* Folds: what moves, where it lands, what is refused. */
#include "origami/state.h"
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>

/* ---- single folds ----------------------------------------------------------------------- */

static void test_diagonal(void **user) {
    (void)user;
    kg_origami *o = square_sheet(150);
    must_fold(o, fold_to(kg_v3(0, 0, 0), kg_v3(150, 150, 0), 180));
    const kg_origami_state *s = last(o);
    assert_int_equal(s->loops.count, 2);
    assert_int_equal(kg_origami_pair_count(s), 1);
    assert_sound(s, 1e-9);
    assert_int_equal(kg_origami_order(s, 0, 1), 1); /* the moving part lies on the front */
    must_fold(o, fold_axis(kg_v3(0, 75, 0), kg_v3(150, 75, 0), kg_v3(0, 150, 0), -90));
    assert_sound(last(o), 1e-9);
    assert_int_equal(last(o)->loops.count, 4);
    kg_origami_destroy(o);
}

/* ---- random sequences ------------------------------------------------------------------- */

static kg_vec3 random_vertex(kg_random *r, const kg_origami_state *s) {
    return s->vertices.items[kg_random_bits(r) % s->vertices.count].position;
}

static kg_fold random_fold(kg_random *r, const kg_origami_state *s) {
    static const double angles[] = {180, -180, 180, -180, 180, -180, 90, -60};
    kg_vec3 from = random_vertex(r, s), to = random_vertex(r, s);
    kg_fold f = fold_to(from, to, angles[kg_random_bits(r) % 8]);
    int kind = (int)(kg_random_bits(r) % 4);
    if (kind == 1) { /* to a point that is no vertex */
        f.points[1] = kg_lerp(f.points[0], f.points[1], kg_random_in(r, 0.3, 0.9));
    } else if (kind == 2) {
        f.by_axis = true, f.vertex = random_vertex(r, s);
    } else if (kind == 3) {
        f.by_axis = true, f.vertex = random_vertex(r, s);
        kg_vec3 other = random_vertex(r, s);
        f.points[1] = kg_lerp(f.points[1], other, kg_random_in(r, 0.2, 0.8));
    }
    f.layers = (int32_t)(kg_random_bits(r) % 3);
    return f;
}

/* Every loop lies on the paper within the loop that it was part of at any time before. */
static void assert_cut_from(const kg_origami_state *earlier, const kg_origami_state *s) {
    for (size_t i = 0; i < s->loops.count; i++) {
        kg_vec2 corners[64], whole[64], middle = {0, 0};
        int32_t loop = kg_loop_in(earlier, s, (int32_t)i);
        size_t n = kg_state_polygon(s, (int32_t)i, NULL, NULL, corners),
               m = kg_state_polygon(earlier, loop, NULL, NULL, whole);
        assert_true(n <= 64 && m <= 64);
        for (size_t k = 0; k < n; k++)
            middle = kg_add2(middle, kg_scale2(corners[k], 1 / (double)n));
        for (size_t k = 0; k < m; k++)
            assert_true(
                kg_cross2(kg_sub2(whole[(k + 1) % m], whole[k]), kg_sub2(middle, whole[k])) > 0);
        assert_int_equal(s->loops.items[i].sheet, earlier->loops.items[loop].sheet);
    }
}

static void test_random(void **user) {
    (void)user;
    size_t done = 0, refused = 0, most = 0, flat = 0;
    for (uint64_t seed = 0; seed < 1000; seed++) {
        kg_random r = {seed};
        kg_origami *o = kg_origami_create();
        add_rectangle(o, 0, 0, 100, kg_random_in(&r, 60, 100));
        double x = kg_random_in(&r, -60, 60), y = kg_random_in(&r, -60, 60);
        if (seed % 3 == 0)
            add_rectangle(o, x, y, 80, 80);
        size_t length = 1 + kg_random_bits(&r) % 12;
        for (size_t tries = 0;
             tries < 40 && kg_origami_step(o) < length && last(o)->loops.count < 80; tries++) {
            kg_fold f = random_fold(&r, last(o));
            kg_error error;
            kg_status status = kg_origami_fold(o, &f, &error);
            if (status) {
                assert_int_equal(status, KG_ERR_INPUT);
                refused++;
                continue;
            }
            done++;
            flat += fabs(f.angle_deg) == 180;
            most = last(o)->loops.count > most ? last(o)->loops.count : most;
            const char *wrong = shape_check(last(o), 1e-9);
            if (!wrong && seed < 200)
                wrong = stack_check(last(o));
            if (wrong)
                fail_msg("seed %d, fold %d: %s", (int)seed, (int)kg_origami_step(o), wrong);
        }
        const char *wrong = stack_check(last(o));
        if (wrong)
            fail_msg("seed %d, in the end: %s", (int)seed, wrong);
        /* back to the start and forth again; and a replay */
        size_t steps = kg_origami_step(o);
        for (size_t i = 0; i < steps; i++)
            assert_cut_from(kg_origami_state_at(o, i), last(o));
        kg_origami *again = kg_origami_create();
        for (size_t i = 0; i < kg_origami_sheet_count(o); i++)
            assert_int_equal(kg_origami_add_sheet(again, kg_origami_sheet(o, i), NULL), KG_OK);
        while (kg_origami_undo(o))
            ;
        assert_int_equal(kg_origami_step(o), 0);
        for (size_t i = 0; i < steps; i++) {
            must_fold(again, *kg_origami_fold_at(o, i));
            assert_true(kg_origami_redo(o));
            assert_true(same_state(last(o), last(again)));
        }
        assert_false(kg_origami_redo(o));
        kg_origami_destroy(o);
        kg_origami_destroy(again);
    }
    print_message("%zu folds, %zu flat, %zu refused, up to %zu faces\n", done, flat, refused, most);
    assert_true(done > 4000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_diagonal),
        cmocka_unit_test(test_random),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
