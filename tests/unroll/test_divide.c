/* Patches with trims, divided: every part keeps what was kept there, what they cut stays cut, and
 * the seams are closed. */
#include "katagami/unroll.h"
#include "model/divide.h"
#include "model/edit.h"
#include "tests/model/random_model.h"
#include "tests/patch/bad_patch.h"

enum { STRIP = 1, START_WALL, SIDE_WALL, FIN };

static const char *const names[KG_DIVIDED] = {NULL, "plane", "half", "cut 1", "cut 2"};

static void cut_by(kg_model_patch *p, int64_t by, kg_vec3 keep) {
    kg_trim_op op = trim_by(by);
    keep_near(&op, keep);
    insert_trim(p, p->trim_count, op);
}

/* A strip along x that its rulings make unsound; `kind`: bits say which trims there are. */
static kg_model *strip(kg_random *r, unsigned kind) {
    kg_model *m = checked(kg_model_create());
    kg_patch_input in;
    kg_patch patch;
    double width;
    do { /* along the wall at its side, where there is one, and not cut back to a thread */
        in = random_bad(r, !(kind & 4));
        for (int i = 1; i < 3 && kind & 4; i++)
            in.points[i].y *= 0.1;
        width = kg_patch_init(&in, &patch, NULL)
                    ? 0
                    : (patch.extent[1] - patch.extent[0]) / (in.extent[1] - in.extent[0]);
    } while (kg_patch_is_sound(&in) || width < (kind & 4 ? 0.3 : 0));
    kg_vec3 middle = kg_patch_point(&patch, 0, 0.5), end = kg_patch_point(&patch, 0, 0.9);
    kg_vec3 y = kg_v3(0, 1, 0), z = kg_v3(0, 0, 1);
    add_patch(m, STRIP, in);
    add_patch(m, START_WALL, flat_input(kg_v3(6, 0, -90), kg_v3(6, 0, 90), y, -90, 90))
        ->construction = true;
    double side = kg_patch_point(&patch, 0.4 * patch.extent[1], 0.5).y;
    add_patch(m, SIDE_WALL, flat_input(kg_v3(-60, side, 0), kg_v3(160, side, 0), z, -120, 120))
        ->construction = true;
    if (kind & 1) {
        kg_trim_op hole = {.kind = KG_TRIM_CONTOUR, .outside = true, .contour_count = 3};
        hole.contour = checked(malloc(3 * sizeof *hole.contour));
        for (int i = 0; i < 3; i++)
            hole.contour[i] = kg_v2(0.3 * patch.extent[i % 2], 0.75 + 0.05 * i);
        insert_trim(kg_model_find(m, STRIP), 0, hole);
    }
    if (kind & 2)
        cut_by(kg_model_find(m, STRIP), START_WALL, middle);
    if (kind & 4)
        cut_by(kg_model_find(m, STRIP), SIDE_WALL,
               kg_patch_point(&patch, 0.8 * patch.extent[0], 0.5));
    if (kind & 8) {
        kg_vec3 low = kg_v3(end.x, end.y, -90), high = kg_v3(end.x, end.y, 90);
        kg_model_patch *fin = add_patch(m, FIN, flat_input(low, high, kg_v3(1, 0.2, 0), -2, 2));
        cut_by(fin, STRIP, high);
    }
    return m;
}

static kg_solution *solve(const kg_model *m) {
    kg_solution *s;
    assert_int_equal(kg_solution_create(m, 0.002, NULL, &s, NULL), KG_OK);
    return s;
}

static size_t holes(const kg_solution *s, int64_t id) {
    const kg_solved_patch *p = kg_solution_find(s, id);
    size_t count = 0;
    for (size_t i = 0; i < p->regions.count; i++)
        count += p->regions.items[i].loop_count - 1;
    return count;
}

/* Both seams of the plane are closed, and as long on both sides. */
static void assert_seams(const kg_model *m, const kg_solution *s, const int64_t ids[KG_DIVIDED]) {
    kg_unrolled *net;
    double length[2] = {0, 0};
    assert_int_equal(kg_unroll(m, s, &net, NULL), KG_OK);
    for (size_t i = 0; i < net->net->join_count; i++) {
        const kg_net_join *j = &net->net->joins[i];
        for (int half = 0; half < 2; half++) {
            int64_t a = ids[KG_MIDDLE_PLANE], b = ids[half ? KG_SECOND_HALF : KG_FIRST_HALF];
            if (!(j->sources[0] == a && j->sources[1] == b) &&
                !(j->sources[0] == b && j->sources[1] == a))
                continue;
            assert_int_equal(j->kind, KG_JOIN_SEAM);
            assert_near(j->sides[0].length, j->sides[1].length, 1e-6 * j->sides[0].length);
            length[half] += j->sides[0].length;
        }
    }
    assert_true(length[0] > 1 && length[1] > 1);
    kg_unrolled_destroy(net);
}

static void trimmed_patches_are_divided(void **state) {
    (void)state;
    kg_random r = {5};
    enum { ROUNDS = 32 };
    int divided = 0, walled = 0;
    for (unsigned round = 0; round < ROUNDS; round++) {
        kg_model *m = strip(&r, round), *copy = kg_model_copy(m);
        kg_solution *s = solve(m);
        int64_t ids[KG_DIVIDED];
        kg_error error;
        if (kg_model_divide(m, s, STRIP, names, ids, &error)) {
            print_message("%u: %s\n", round, error.message);
            assert_int_equal(error.status, KG_ERR_INPUT);
            assert_true(kg_model_equal(m, copy));
        } else {
            kg_solution *after = solve(m);
            divided++;
            walled += (round & 4) != 0;
            assert_int_equal(ids[0], STRIP);
            if (kg_solution_check(after, &error))
                fail_msg("%u: %s", round, error.message);
            assert_seams(m, after, ids);
            if ((round & 5) == 1)
                assert_int_equal(holes(after, ids[0]) + holes(after, ids[1]) + holes(after, ids[2]),
                                 holes(s, STRIP));
            if (round & 8)
                assert_int_equal(kg_model_find(m, FIN)->trims[0].by[0], ids[KG_SECOND_HALF]);
            kg_solution_destroy(after);
        }
        kg_solution_destroy(s);
        kg_model_destroy(copy);
        kg_model_destroy(m);
    }
    print_message("divided %d of %d\n", divided, ROUNDS);
    assert_true(divided > 0.6 * ROUNDS && walled > 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(trimmed_patches_are_divided),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
