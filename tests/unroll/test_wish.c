/* Wishes for single joins of two patches that have several: each is for the nearest, however the
 * model moves. */
#include "katagami/unroll.h"
#include "model/edit.h"
#include "model/refit.h"
#include "tests/model/random_model.h"

enum { ARCH = 1, GROUND = 2, LEFT = 0, RIGHT = 1 };

/* An arch on the ground: they cut each other at x = -24 and at x = 24, with a seam at each foot. */
static kg_model *tunnel(void) {
    kg_model *m = checked(kg_model_create());
    kg_patch_input arch = {.point_count = 4, .extent = {-20, 20}};
    const kg_vec3 points[4] = {{-30, 0, -10}, {-15, 0, 30}, {15, 0, 30}, {30, 0, -10}};
    memcpy(arch.points, points, sizeof points);
    kg_model_patch *p = add_patch(m, ARCH, arch);
    insert_trim(p, 0, trim_by(GROUND));
    keep_near(&p->trims[0], kg_v3(0, 0, 20));
    p = add_patch(m, GROUND,
                  flat_input(kg_v3(-60, 0, 0), kg_v3(60, 0, 0), kg_v3(0, 1, 0), -15, 15));
    insert_trim(p, 0, trim_by(ARCH));
    keep_near(&p->trims[0], kg_v3(0, 0, 0));
    return m;
}

static void add_wish(kg_model *m, int64_t a, int64_t b, const kg_vec2 *at, kg_net_tab_side tab) {
    kg_model_join *more = checked(realloc(m->joins, (m->join_count + 1) * sizeof *more));
    m->joins = more;
    more[m->join_count] = (kg_model_join){.patches = {a, b}, .tab = tab};
    if (at) {
        more[m->join_count].has_at = true;
        more[m->join_count].at = *at;
    }
    m->join_count++;
}

/* A place of a patch beside a foot. */
static kg_vec2 place(int64_t patch, int side) {
    double v = patch == ARCH ? 0.12 : 0.3;
    return kg_v2(5, side == LEFT ? v : 1 - v);
}

/* ---- what became of them ----------------------------------------------------------------- */

typedef struct made {
    kg_solution *solution;
    kg_unrolled *unrolled;
} made;

static made make(const kg_model *m) {
    made out;
    kg_error error;
    if (kg_solution_create(m, 0.002, NULL, &out.solution, &error) ||
        kg_solution_check(out.solution, &error) ||
        kg_unroll(m, out.solution, &out.unrolled, &error))
        fail_msg("%s", error.message);
    return out;
}

static void unmake(made *m) {
    kg_unrolled_destroy(m->unrolled);
    kg_solution_destroy(m->solution);
}

/* The two feet by the direction they lie in, which `out` gets in the order left, right. */
static void find_feet(const made *m, kg_vec3 right, const kg_net_join *out[2]) {
    const kg_net *net = m->unrolled->net;
    assert_int_equal(net->join_count, 2);
    double x[2];
    for (int i = 0; i < 2; i++) {
        const kg_net_join *j = &net->joins[i];
        for (int side = 0; side < 2; side++)
            for (int k = 0; k < KG_JOIN_PLACES; k++) { /* both courses are the same curve */
                const kg_patch *p = &kg_solution_find(m->solution, j->sources[side])->patch;
                kg_vec2 at = j->course[side][k];
                double here = kg_dot(kg_patch_point(p, at.x, at.y), right);
                assert_true((side == 0 && k == 0) || fabs(here - x[i]) < 1e-6);
                x[i] = here;
            }
    }
    out[LEFT] = &net->joins[x[0] < x[1] ? 0 : 1];
    out[RIGHT] = &net->joins[x[0] < x[1] ? 1 : 0];
}

static kg_net_tab_side tab_of(const kg_model *m, int side, kg_vec3 right) {
    const kg_net_join *feet[2];
    made all = make(m);
    find_feet(&all, right, feet);
    kg_net_tab_side tab = feet[side]->tab_side;
    unmake(&all);
    return tab;
}

static const kg_vec3 along_x = {1, 0, 0};

/* ---- tests ------------------------------------------------------------------------------- */

static void a_wish_holds_for_its_seam_only(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        int64_t first = kind & 1 ? ARCH : GROUND;
        int side = kind & 2 ? LEFT : RIGHT;
        kg_vec2 at = place(first, side);
        kg_model *m = tunnel();
        add_wish(m, first, ARCH + GROUND - first, &at, KG_TAB_THIS);
        made all = make(m);
        const kg_net_join *feet[2];
        find_feet(&all, along_x, feet);
        const kg_net_join *wished = feet[side], *other = feet[1 - side];
        assert_int_equal(wished->tab_side,
                         wished->sources[0] == first ? KG_TAB_THIS : KG_TAB_OTHER);
        assert_int_equal(other->tab_side, KG_TAB_AUTO);
        /* the one is named as the wish names it, the other by its middle */
        assert_true(wished->at.x == at.x && wished->at.y == at.y);
        assert_int_equal(wished->sources[wished->at_side], first);
        assert_near(other->at.y, other->course[0][KG_JOIN_PLACES / 2].y, 1e-4);
        unmake(&all);
        kg_model_destroy(m);
    }
}

static void a_wish_for_one_comes_before_that_for_all(void **state) {
    (void)state;
    for (int order = 0; order < 2; order++) {
        kg_model *m = tunnel();
        kg_vec2 at = place(ARCH, LEFT);
        if (order)
            add_wish(m, ARCH, GROUND, &at, KG_TAB_AUTO);
        add_wish(m, GROUND, ARCH, NULL, KG_TAB_NONE);
        if (!order)
            add_wish(m, ARCH, GROUND, &at, KG_TAB_AUTO);
        assert_int_equal(tab_of(m, LEFT, along_x), KG_TAB_AUTO);
        assert_int_equal(tab_of(m, RIGHT, along_x), KG_TAB_NONE);
        kg_model_destroy(m);
    }
}

static void of_two_wishes_for_a_seam_the_nearer_holds(void **state) {
    (void)state;
    for (int order = 0; order < 2; order++) {
        kg_model *m = tunnel();
        kg_vec2 far = kg_v2(0, 0.3), near = place(ARCH, LEFT);
        add_wish(m, ARCH, GROUND, order ? &far : &near, order ? KG_TAB_OTHER : KG_TAB_NONE);
        add_wish(m, ARCH, GROUND, order ? &near : &far, order ? KG_TAB_NONE : KG_TAB_OTHER);
        made all = make(m);
        const kg_net_join *feet[2];
        find_feet(&all, along_x, feet);
        assert_int_equal(feet[LEFT]->tab_side, KG_TAB_NONE);
        assert_int_equal(feet[RIGHT]->tab_side, KG_TAB_AUTO); /* not the second choice */
        size_t idle = order ? 0 : 1;
        for (int i = 0; i < 2; i++)
            assert_true(all.unrolled->wishes[i] != idle);
        unmake(&all);
        kg_model_destroy(m);
    }
}

static void wishes_go_along_with_their_patches(void **state) {
    (void)state;
    kg_random r = {77};
    for (int round = 0; round < 24; round++) {
        kg_model *m = tunnel();
        int side = round % 2;
        int64_t first = round / 2 % 2 ? ARCH : GROUND;
        kg_vec2 at = place(first, side);
        add_wish(m, first, ARCH + GROUND - first, &at, KG_TAB_NONE);
        kg_vec3 axis, right = along_x;
        axis.x = kg_random_in(&r, -1, 1);
        axis.y = kg_random_in(&r, -1, 1);
        axis.z = kg_random_in(&r, 0.1, 1);
        kg_similarity map = kg_similarity_turn(kg_v3(9, 0, 0), kg_unit(axis), round);
        if (round % 3 == 0)
            map = kg_similarity_mirror(kg_v3(40, 0, 0), kg_unit(axis));
        map.scale = kg_random_in(&r, 0.3, 3);
        for (int64_t id = ARCH; id <= GROUND; id++)
            assert_int_equal(kg_model_transform_patch(m, id, &map, NULL), KG_OK);
        right = kg_sub(kg_similarity_apply(&map, right), kg_similarity_apply(&map, kg_v3(0, 0, 0)));
        assert_int_equal(tab_of(m, side, right), KG_TAB_NONE);
        assert_int_equal(tab_of(m, 1 - side, right), KG_TAB_AUTO);
        kg_model_destroy(m);
    }
}

static void wishes_survive_dragged_points_and_refits(void **state) {
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        int side = kind % 2;
        int64_t first = kind / 2 ? ARCH : GROUND;
        kg_vec2 at = place(first, side);
        kg_model *m = tunnel();
        add_wish(m, first, ARCH + GROUND - first, &at, KG_TAB_NONE);
        kg_model_patch *arch = kg_model_find(m, ARCH);
        for (int i = 0; i < 4; i++) /* the feet come nearer, and all moves aside */
            arch->input.points[i].x = 0.7 * arch->input.points[i].x + 8;
        arch->trims[0].keep[0].x = 8;
        kg_model_find(m, GROUND)->trims[0].keep[0].x = 8;
        assert_int_equal(tab_of(m, side, along_x), KG_TAB_NONE);
        made all = make(m);
        assert_int_equal(kg_model_refit(m, all.solution, GROUND, NULL), KG_OK);
        unmake(&all);
        assert_int_equal(tab_of(m, side, along_x), KG_TAB_NONE);
        assert_int_equal(tab_of(m, 1 - side, along_x), KG_TAB_AUTO);
        kg_model_destroy(m);
    }
}

static void wishes_without_a_join_hold_for_none(void **state) {
    (void)state;
    kg_model *m = tunnel();
    kg_vec2 at = kg_v2(0, 0.5), wild = kg_v2(1e6, -1e6);
    add_wish(m, ARCH, ARCH, &at, KG_TAB_NONE);
    add_wish(m, 7, ARCH, &at, KG_TAB_NONE);
    add_wish(m, ARCH, 7, NULL, KG_TAB_NONE);
    add_wish(m, ARCH, GROUND, &wild, KG_TAB_NONE);
    made all = make(m);
    size_t used = 0;
    for (size_t i = 0; i < all.unrolled->net->join_count; i++) {
        assert_true(all.unrolled->wishes[i] == SIZE_MAX || all.unrolled->wishes[i] == 3);
        used += all.unrolled->wishes[i] == 3;
    }
    assert_int_equal(used, 1);
    unmake(&all);
    kg_model_destroy(m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wish_holds_for_its_seam_only),
        cmocka_unit_test(a_wish_for_one_comes_before_that_for_all),
        cmocka_unit_test(of_two_wishes_for_a_seam_the_nearer_holds),
        cmocka_unit_test(wishes_go_along_with_their_patches),
        cmocka_unit_test(wishes_survive_dragged_points_and_refits),
        cmocka_unit_test(wishes_without_a_join_hold_for_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
