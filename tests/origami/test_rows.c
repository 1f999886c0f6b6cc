/* Rows of bits: overlaps found at once, and the check of layers, against pair by pair. */
#include "origami/condition.h"
#include "origami/overlap.h"
#include "tests/check.h"
#include "tests/origami/samples.h"
#include "tests/origami/stack.h"

#include <stdlib.h>

/* A rectangle, or two, folded flat now and then and otherwise at angles. */
static kg_origami *random_paper(kg_random *r, size_t faces) {
    kg_origami *o = kg_origami_create();
    add_rectangle(o, 0, 0, 100, 80);
    if (kg_random_bits(r) % 3 == 0)
        add_rectangle(o, 20, 10, 90, 60);
    for (int tries = 0; tries < 80 && last(o)->loops.count < faces; tries++) {
        const kg_origami_state *s = last(o);
        kg_vec3 from = s->vertices.items[kg_random_bits(r) % s->vertices.count].position,
                to = s->vertices.items[kg_random_bits(r) % s->vertices.count].position;
        static const double angles[] = {180, -180, 180, -180, 180, 90};
        kg_fold f = fold_to(from, to, angles[kg_random_bits(r) % 6]);
        f.points[1] = kg_lerp(from, to, kg_random_in(r, 0.3, 1));
        f.layers = (int32_t)(kg_random_bits(r) % 3);
        if (kg_origami_fold(o, &f, NULL)) /* paper cannot do it: another one */
            continue;
    }
    return o;
}

static void test_overlaps_are_those_of_all_pairs(void **user) {
    (void)user;
    size_t pairs = 0;
    for (uint64_t seed = 0; seed < 60; seed++) {
        kg_random r = {seed};
        kg_origami *o = random_paper(&r, 40 + 3 * seed); /* one word of a row, two, three … */
        kg_origami_state *s = kg_state_copy(last(o));
        kg_outlines outlines;
        assert_int_equal(kg_outlines_create(s, &outlines), KG_OK);
        assert_int_equal(kg_overlaps_fill(s, &outlines), KG_OK);
        int32_t loops = (int32_t)s->loops.count;
        for (int32_t a = 0; a < loops; a++)
            for (int32_t b = 0; b < loops; b++) {
                bool overlap = a != b && s->loops.items[a].group == s->loops.items[b].group &&
                               kg_outlines_overlap(&outlines, a, b, s->touch);
                int above = kg_origami_order(s, a, b) * outlines.facing[a];
                assert_int_equal(above, overlap ? (a < b ? 1 : -1) : 0);
                /* and so it was when it was folded */
                assert_int_equal(kg_origami_order(last(o), a, b) != 0, overlap);
            }
        pairs += kg_origami_pair_count(s);
        kg_outlines_clear(&outlines);
        kg_state_destroy(s);
        kg_origami_destroy(o);
    }
    assert_true(pairs > 10000);
}

/* ---- the check of layers ---------------------------------------------------------------- */

static bool is_met(const kg_origami_state *s, const kg_outlines *o, const kg_condition *c) {
    int32_t a[4] = {c->a, c->b, c->a, c->b}, b[4] = {c->c, c->c, c->d, c->d};
    int product = 1;
    if (c->kind == KG_CONDITION_SAME)
        a[0] = c->a, b[0] = c->b, a[1] = c->c, b[1] = c->d;
    for (int k = 0; k < (c->kind == KG_CONDITION_SAME ? 2 : 4); k++)
        product *= kg_origami_order(s, a[k], b[k]) * o->facing[a[k]];
    return product >= 0;
}

static bool all_met(const kg_origami_state *s, const kg_outlines *o) {
    kg_conditions found = {0};
    assert_int_equal(kg_conditions_find(s, o, NULL, &found, NULL), KG_OK);
    bool met = true;
    for (size_t i = 0; i < found.count; i++)
        met &= is_met(s, o, &found.items[i]);
    free(found.items);
    return met;
}

/* The other way round, for two loops. */
static void turn(kg_origami_state *s, int32_t a, int32_t b) {
    for (int side = -1; side <= 1; side += 2) {
        kg_layer_row(s, a, side)[b >> 6] ^= (uint64_t)1 << (b & 63);
        kg_layer_row(s, b, side)[a >> 6] ^= (uint64_t)1 << (a & 63);
    }
}

/* Of valid layers one loop is turned over with some of those on it: what is wrong then is found by
 * looking at that loop alone, and it is what looking at all conditions finds. */
static void test_the_check_finds_what_all_conditions_do(void **user) {
    (void)user;
    size_t right = 0, wrong = 0;
    for (uint64_t seed = 0; seed < 150; seed++) {
        kg_random r = {seed};
        kg_origami *o = random_paper(&r, 20 + seed);
        kg_origami_state *s = kg_state_copy(last(o));
        kg_outlines outlines;
        uint64_t moved[16] = {0};
        assert_int_equal(kg_layers_create(s), KG_OK);
        memcpy(s->layers.bits, last(o)->layers.bits,
               2 * s->loops.count * s->layers.words * sizeof(uint64_t));
        assert_true(s->layers.words <= 16);
        assert_int_equal(kg_outlines_create(s, &outlines), KG_OK);
        assert_true(all_met(s, &outlines));
        assert_int_equal(kg_layers_check(s, &outlines, NULL, NULL), KG_OK);
        int32_t loop = (int32_t)(kg_random_bits(&r) % s->loops.count);
        uint64_t some = kg_random_bits(&r) % 8;
        for (int32_t b = 0; b < (int32_t)s->loops.count; b++)
            if (kg_origami_order(s, loop, b) != 0 && kg_random_bits(&r) % 8 <= some)
                turn(s, loop, b);
        kg_bit_set(moved, loop);
        kg_status expected = all_met(s, &outlines) ? KG_OK : KG_ERR_INPUT;
        assert_int_equal(kg_layers_check(s, &outlines, NULL, NULL), expected);
        assert_int_equal(kg_layers_check(s, &outlines, moved, NULL), expected);
        *(expected ? &wrong : &right) += 1;
        kg_outlines_clear(&outlines);
        kg_state_destroy(s);
        kg_origami_destroy(o);
    }
    assert_true(right > 10 && wrong > 60);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlaps_are_those_of_all_pairs),
        cmocka_unit_test(test_the_check_finds_what_all_conditions_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
