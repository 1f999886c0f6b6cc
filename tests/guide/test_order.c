/* The order of building, on nets made by hand and at random. */
#include "katagami/guide.h"
#include "tests/check.h"

#include <stdlib.h>

/* A square of edge `size` in a net; edges 0 … 3 from (0,0) on. */
static size_t add_square(kg_net *net, double size) {
    size_t part;
    const kg_vec2 corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    assert_int_equal(kg_net_add_part(net, 1, "", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, corners, NULL, 4, NULL), KG_OK);
    net->parts[part].area = size * size;
    net->parts[part].perimeter = 4 * size;
    return part;
}

static kg_net_side edge_of(const kg_net *net, size_t part, size_t edge) {
    return (kg_net_side){.part = (int)part,
                         .first = edge,
                         .count = 2,
                         .line = -1,
                         .length = net->parts[part].perimeter / 4};
}

static int add_seam(kg_net *net, size_t p, size_t p_edge, size_t q, size_t q_edge) {
    kg_net_join join = {.kind = KG_JOIN_SEAM,
                        .sides = {edge_of(net, p, p_edge), edge_of(net, q, q_edge)}};
    size_t index;
    assert_int_equal(kg_net_add_join(net, &join, &index, NULL), KG_OK);
    return (int)index;
}

/* An edge of p onto a line drawn on q. */
static int add_contact(kg_net *net, size_t p, size_t p_edge, size_t q, kg_vec2 a, kg_vec2 b) {
    kg_vec2 points[] = {a, b};
    kg_net_line line = {.kind = KG_NET_MARK, .count = 2, .points = points, .join = -1};
    size_t mark, index;
    assert_int_equal(kg_net_add_line(net, q, &line, &mark, NULL), KG_OK);
    kg_net_join join = {
        .kind = KG_JOIN_CONTACT,
        .sides = {edge_of(net, p, p_edge),
                  {.part = (int)q, .loop = -1, .line = (int)mark, .length = kg_dist2(a, b)}}};
    assert_int_equal(kg_net_add_join(net, &join, &index, NULL), KG_OK);
    return (int)index;
}

static kg_guide_order *order_of(const kg_net *net, const bool *inside) {
    kg_guide_order_options options = kg_guide_order_options_default();
    options.inside = inside;
    kg_guide_order *order;
    assert_int_equal(kg_guide_order_create(net, &options, &order, NULL), KG_OK);
    return order;
}

/* Index of the step in which a part is started or attached. */
static size_t step_of(const kg_guide_order *order, size_t part) {
    for (size_t i = 0; i < order->step_count; i++)
        if (order->steps[i].part == (int)part &&
            (order->steps[i].kind == KG_STEP_START || order->steps[i].kind == KG_STEP_ATTACH))
            return i;
    fail_msg("part %zu is in no step", part);
    return 0;
}

static size_t count_kind(const kg_guide_order *order, kg_guide_step_kind kind) {
    size_t count = 0;
    for (size_t i = 0; i < order->step_count; i++)
        count += order->steps[i].kind == kind;
    return count;
}

/* What every order must keep to, whatever the net. */
static void assert_buildable(const kg_net *net, const kg_guide_order *order) {
    bool *standing = calloc(net->part_count + 1, sizeof *standing);
    int *glued = calloc(net->join_count + 1, sizeof *glued);
    int component = -1;
    bool placing = false;
    for (size_t i = 0; i < order->step_count; i++) {
        const kg_guide_step *step = &order->steps[i];
        assert_int_equal(step->component, order->components[step->part]);
        placing = placing || step->kind == KG_STEP_PLACE;
        assert_int_equal(placing, step->kind == KG_STEP_PLACE);
        if (step->kind == KG_STEP_START) {
            assert_int_equal(step->component, component + 1);
            component = step->component;
        } else if (!placing) {
            assert_int_equal(step->component, component);
        }
        if (step->kind == KG_STEP_ATTACH || step->kind == KG_STEP_CLOSE)
            assert_true(step->join_count > 0);
        if (step->kind == KG_STEP_START || step->kind == KG_STEP_ATTACH)
            assert_false(standing[step->part]);
        if (step->kind == KG_STEP_CLOSE)
            assert_int_equal(order->steps[i - 1].part, step->part);
        for (size_t k = 0; k < step->join_count; k++) {
            const kg_net_join *join = &net->joins[step->joins[k]];
            int p = join->sides[0].part, q = join->sides[1].part;
            assert_true(p == step->part || q == step->part);
            int other = p == step->part ? q : p;
            if (step->kind == KG_STEP_OWN)
                assert_int_equal(p, q);
            else
                assert_true(standing[other] && other != step->part);
            glued[step->joins[k]]++;
        }
        if (step->kind == KG_STEP_START || step->kind == KG_STEP_ATTACH)
            standing[step->part] = true;
    }
    for (size_t i = 0; i < net->part_count; i++)
        assert_true(standing[i]);
    for (size_t i = 0; i < net->join_count; i++)
        assert_int_equal(glued[i],
                         net->joins[i].sides[0].part >= 0 && net->joins[i].sides[1].part >= 0);
    assert_int_equal(count_kind(order, KG_STEP_START), order->component_count);
    free(standing);
    free(glued);
}

/* ---- by hand ---------------------------------------------------------------------------- */

static void an_empty_net_has_no_steps(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    kg_guide_order *order = order_of(net, NULL);
    assert_int_equal(order->step_count, 0);
    assert_int_equal(order->component_count, 0);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

/* 0 bottom, 1 … 4 walls, 5 lid; seams numbered by edge pairs. */
static kg_net *cube(void) {
    kg_net *net = kg_net_create();
    for (int i = 0; i < 6; i++)
        add_square(net, 50);
    for (size_t i = 0; i < 4; i++) {
        add_seam(net, 0, i, 1 + i, 0);
        add_seam(net, 5, i, 1 + i, 2);
        add_seam(net, 1 + i, 1, 1 + (i + 1) % 4, 3);
    }
    return net;
}

static void a_cube_closes_with_its_last_part(void **state) {
    (void)state;
    kg_net *net = cube();
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    const kg_guide_step *last = &order->steps[order->step_count - 1];
    assert_int_equal(order->step_count, 7);
    assert_int_equal(last->kind, KG_STEP_CLOSE);
    assert_true(last->closing && last->seals);
    assert_int_equal(last->join_count, 3);
    assert_int_equal(last[-1].join_count, 1); /* hinged first */
    for (size_t i = 0; i + 1 < order->step_count; i++)
        assert_false(order->steps[i].closing);
    /* opposite of the hinge comes last: the two edges share no corner */
    int ends[2] = {last[-1].joins[0], last->joins[2]};
    size_t edges[2];
    for (int i = 0; i < 2; i++) {
        const kg_net_join *join = &net->joins[ends[i]];
        edges[i] = join->sides[join->sides[0].part == last->part ? 0 : 1].first;
    }
    assert_int_equal(abs((int)edges[0] - (int)edges[1]), 2);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void a_ring_of_panels_stays_open_at_its_ends(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    for (int i = 0; i < 8; i++)
        add_square(net, 40);
    for (size_t i = 0; i < 8; i++)
        add_seam(net, i, 1, (i + 1) % 8, 3);
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    const kg_guide_step *last = &order->steps[order->step_count - 1];
    assert_int_equal(last->kind, KG_STEP_CLOSE);
    assert_int_equal(last->join_count, 1);
    assert_true(last->closing);
    assert_false(last->seals);
    assert_int_equal(count_kind(order, KG_STEP_CLOSE), 1);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void a_tube_is_closed_before_it_meets_its_cap(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t tube = add_square(net, 80), cap = add_square(net, 30);
    int own = add_seam(net, tube, 1, tube, 3);
    int rim = add_seam(net, tube, 0, cap, 0);
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    assert_int_equal(order->step_count, 3);
    assert_int_equal(order->steps[1].kind, KG_STEP_OWN);
    assert_int_equal(order->steps[1].joins[0], own);
    assert_int_equal(order->steps[2].joins[0], rim);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void fins_go_on_before_the_body_closes(void **state) {
    (void)state;
    kg_net *net = cube();
    size_t fin = add_square(net, 10);
    add_contact(net, fin, 0, 0, kg_v2(20, 25), kg_v2(30, 25));
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    size_t at = step_of(order, fin);
    assert_true(at > step_of(order, 0));
    assert_true(order->steps[order->step_count - 1].seals);
    assert_true(at + 2 < order->step_count);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void a_fin_waits_for_all_it_sits_on(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t a = add_square(net, 50), b = add_square(net, 50), c = add_square(net, 50);
    add_seam(net, a, 1, b, 3);
    add_seam(net, b, 1, c, 3);
    size_t fin = add_square(net, 60);
    net->parts[fin].area = 100;
    add_contact(net, fin, 0, a, kg_v2(10, 25), kg_v2(50, 25));
    add_contact(net, fin, 2, c, kg_v2(0, 25), kg_v2(40, 25));
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    assert_int_equal(step_of(order, fin), 3);
    assert_int_equal(order->steps[3].join_count, 2);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void a_wall_inside_goes_in_while_the_body_is_open(void **state) {
    (void)state;
    kg_net *net = cube();
    size_t wall = add_square(net, 20);
    int contact = add_contact(net, wall, 0, 0, kg_v2(20, 25), kg_v2(40, 25));
    bool inside[16] = {false};
    inside[contact] = true;
    kg_guide_order *order = order_of(net, inside);
    assert_buildable(net, order);
    assert_true(order->steps[order->step_count - 1].closing);
    assert_true(step_of(order, wall) + 2 < order->step_count);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void walls_on_a_lid_close_a_box_as_seams_do(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t lid = add_square(net, 80);
    const kg_vec2 c[] = {{10, 10}, {60, 10}, {60, 60}, {10, 60}};
    bool inside[16] = {false};
    for (int i = 0; i < 5; i++)
        add_square(net, 50);
    for (size_t i = 0; i < 4; i++) {
        inside[add_contact(net, 1 + i, 2, lid, c[i], c[(i + 1) % 4])] = true;
        add_seam(net, 1 + i, 1, 1 + (i + 1) % 4, 3);
        add_seam(net, 5, i, 1 + i, 0);
    }
    kg_guide_order *order = order_of(net, inside);
    assert_buildable(net, order);
    assert_int_equal(order->steps[0].part, lid);
    const kg_guide_step *last = &order->steps[order->step_count - 1];
    assert_int_equal(last->kind, KG_STEP_CLOSE);
    assert_true(last->seals);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void the_largest_group_is_built_first_and_others_are_placed(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t small = add_square(net, 10), a = add_square(net, 50), b = add_square(net, 40);
    add_seam(net, a, 1, b, 3);
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    assert_int_equal(order->component_count, 2);
    assert_int_equal(order->components[small], 1);
    assert_int_equal(order->steps[0].part, a);
    assert_int_equal(order->steps[order->step_count - 1].kind, KG_STEP_PLACE);
    assert_int_equal(order->steps[order->step_count - 1].part, small);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

static void joins_to_no_part_are_left_out(void **state) {
    (void)state;
    kg_net *net = kg_net_create();
    size_t a = add_square(net, 50), b = add_square(net, 40);
    int lost = add_seam(net, a, 1, b, 3);
    net->joins[lost].sides[1].part = -1;
    kg_guide_order *order = order_of(net, NULL);
    assert_buildable(net, order);
    assert_int_equal(order->component_count, 2);
    kg_guide_order_destroy(order);
    kg_net_destroy(net);
}

/* ---- at random -------------------------------------------------------------------------- */

static size_t pick(kg_random *random, size_t count) {
    return (size_t)kg_random_in(random, 0, (double)count);
}

/* Squares joined anyhow: trees, rings, doubled seams, parts joined to themselves, loose parts. */
static kg_net *random_net(kg_random *random, bool *inside, size_t most_joins) {
    kg_net *net = kg_net_create();
    size_t parts = 1 + pick(random, 20), joins = pick(random, most_joins);
    for (size_t i = 0; i < parts; i++)
        add_square(net, kg_random_in(random, 5, 80));
    for (size_t i = 0; i < joins; i++) {
        size_t p = pick(random, parts), q = pick(random, parts);
        if (pick(random, 3) > 0)
            add_seam(net, p, pick(random, 4), q, pick(random, 4));
        else
            add_contact(net, p, pick(random, 4), q, kg_v2(1, 1), kg_v2(4, 3));
        inside[i] = pick(random, 2) == 0;
    }
    return net;
}

static void random_nets_are_buildable(void **state) {
    (void)state;
    enum { NETS = 500, MOST_JOINS = 40 };
    kg_random random = {7};
    bool inside[MOST_JOINS] = {false};
    for (int i = 0; i < NETS; i++) {
        kg_net *net = random_net(&random, inside, MOST_JOINS);
        kg_guide_order *order = order_of(net, inside);
        assert_buildable(net, order);
        kg_guide_order_destroy(order);
        kg_net_destroy(net);
    }
}

static void the_same_net_gives_the_same_order(void **state) {
    (void)state;
    enum { NETS = 100, MOST_JOINS = 40 };
    kg_random random = {11};
    bool inside[MOST_JOINS] = {false};
    for (int i = 0; i < NETS; i++) {
        kg_net *net = random_net(&random, inside, MOST_JOINS);
        kg_guide_order *a = order_of(net, inside), *b = order_of(net, inside);
        assert_int_equal(a->step_count, b->step_count);
        for (size_t k = 0; k < a->step_count; k++) {
            const kg_guide_step *s = &a->steps[k], *t = &b->steps[k];
            assert_true(s->kind == t->kind && s->part == t->part && s->closing == t->closing &&
                        s->join_count == t->join_count);
            assert_memory_equal(s->joins, t->joins, s->join_count * sizeof *s->joins);
        }
        kg_guide_order_destroy(a);
        kg_guide_order_destroy(b);
        kg_net_destroy(net);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_net_has_no_steps),
        cmocka_unit_test(a_cube_closes_with_its_last_part),
        cmocka_unit_test(a_ring_of_panels_stays_open_at_its_ends),
        cmocka_unit_test(a_tube_is_closed_before_it_meets_its_cap),
        cmocka_unit_test(fins_go_on_before_the_body_closes),
        cmocka_unit_test(a_fin_waits_for_all_it_sits_on),
        cmocka_unit_test(a_wall_inside_goes_in_while_the_body_is_open),
        cmocka_unit_test(walls_on_a_lid_close_a_box_as_seams_do),
        cmocka_unit_test(the_largest_group_is_built_first_and_others_are_placed),
        cmocka_unit_test(joins_to_no_part_are_left_out),
        cmocka_unit_test(random_nets_are_buildable),
        cmocka_unit_test(the_same_net_gives_the_same_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
