/* Parts too large for the page, cut in two along rulings. */
#include "katagami/unroll.h"
#include "tests/model/random_model.h"

typedef struct nets {
    kg_unrolled *whole, *cut;
} nets;

static nets unroll_both(const kg_model *model, kg_vec2 room) {
    kg_solution *solution;
    nets n;
    assert_int_equal(kg_solution_create(model, 0.002, NULL, &solution, NULL), KG_OK);
    assert_int_equal(kg_unroll(model, solution, &n.whole, NULL), KG_OK);
    assert_int_equal(kg_unroll_to_fit(model, solution, room, &n.cut, NULL), KG_OK);
    assert_int_equal(kg_net_check(n.cut->net, NULL), KG_OK);
    kg_solution_destroy(solution);
    return n;
}

static void clear(nets *n) {
    kg_unrolled_destroy(n->whole);
    kg_unrolled_destroy(n->cut);
}

static double total_area(const kg_net *net) {
    double sum = 0;
    for (size_t i = 0; i < net->part_count; i++)
        sum += net->parts[i].area;
    return sum;
}

/* Does the outline fit at some angle? In finer steps than the splitting tries. */
static bool fits(const kg_net_part *part, kg_vec2 room) {
    const kg_net_line *l = &part->loops[0].line;
    for (int k = 0; k < 1800; k++) {
        double angle = KG_PI * k / 1800, c = cos(angle), s = sin(angle);
        kg_box2 box = kg_box2_empty();
        for (size_t i = 0; i < l->count; i++)
            kg_box2_add(&box, kg_v2(c * l->points[i].x - s * l->points[i].y,
                                    s * l->points[i].x + c * l->points[i].y));
        if (box.hi.x - box.lo.x <= room.x + 1e-6 && box.hi.y - box.lo.y <= room.y + 1e-6)
            return true;
    }
    return false;
}

/* A long strip over a planar arc, with a hole. */
static kg_model *long_strip(bool flip) {
    kg_model *model = checked(kg_model_create());
    kg_patch_input in = {.points = {{0, 0, 0}, {120, 0, 60}, {260, 0, 60}, {400, 0, 0}},
                         .point_count = 4,
                         .extent = {-30, 30},
                         .flip = flip};
    kg_model_patch *p = add_patch(model, 1, in);
    kg_vec2 hole[4] = {{-8, 0.48}, {8, 0.48}, {8, 0.55}, {-8, 0.55}};
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR,
                     .outside = true,
                     .contour_count = 4,
                     .contour = checked(malloc(sizeof hole))};
    memcpy(op.contour, hole, sizeof hole);
    insert_trim(p, 0, op);
    return model;
}

static void long_parts_become_pieces_that_fit_and_are_joined(void **state) {
    (void)state;
    for (int flip = 0; flip < 2; flip++) {
        kg_model *model = long_strip(flip);
        kg_vec2 room = kg_v2(190, 120);
        nets n = unroll_both(model, room);
        assert_int_equal(n.whole->net->part_count, 1);
        size_t parts = n.cut->net->part_count;
        assert_in_range(parts, 3, 5);
        for (size_t i = 0; i < parts; i++)
            assert_true(fits(&n.cut->net->parts[i], room));
        assert_near(total_area(n.cut->net), total_area(n.whole->net), 1e-6);
        /* one seam fewer than pieces, each as long on both sides, and flat */
        assert_int_equal(n.cut->net->join_count, parts - 1);
        for (size_t i = 0; i < n.cut->net->join_count; i++) {
            const kg_net_join *j = &n.cut->net->joins[i];
            assert_int_equal(j->kind, KG_JOIN_SEAM);
            assert_true(j->sides[0].part != j->sides[1].part);
            assert_true(j->sides[1].reversed);
            assert_near(j->sides[0].length, 60, 1e-9);
            assert_near(j->sides[1].length, 60, 1e-9);
            assert_near(j->fold[0], 0, 1e-9);
        }
        clear(&n);
        kg_model_destroy(model);
    }
}

static void cuts_keep_clear_of_holes(void **state) {
    (void)state;
    kg_model *model = long_strip(false);
    nets n = unroll_both(model, kg_v2(260, 120));
    size_t holes = 0;
    for (size_t i = 0; i < n.cut->net->part_count; i++)
        holes += n.cut->net->parts[i].loop_count - 1;
    assert_int_equal(n.cut->net->part_count, 2);
    assert_int_equal(holes, 1);
    clear(&n);
    kg_model_destroy(model);
}

static void parts_that_fit_are_left_alone(void **state) {
    (void)state;
    kg_model *model = long_strip(false);
    nets n = unroll_both(model, kg_v2(500, 100));
    assert_int_equal(n.cut->net->part_count, 1);
    assert_int_equal(n.cut->net->join_count, 0);
    clear(&n);
    kg_model_destroy(model);
}

static void rulings_longer_than_the_page_are_no_endless_loop(void **state) {
    (void)state;
    kg_model *model = long_strip(false);
    nets n = unroll_both(model, kg_v2(20, 20));
    assert_near(total_area(n.cut->net), total_area(n.whole->net), 1e-6);
    assert_in_range(n.cut->net->part_count, 1, 64);
    clear(&n);
    kg_model_destroy(model);
}

/* Where two patches cut each other and all pieces stay, four edges meet in one curve, and which is
 * joined to which is a matter of choice. */
static bool keeps_all_pieces(const kg_net *net) {
    for (size_t i = 1; i < net->part_count; i++)
        if (net->parts[i].source == net->parts[i - 1].source)
            return true;
    return false;
}

/* Whatever a model is like, cutting its parts up loses no paper and no join. */
static void random_models_keep_area_and_joined_length(void **state) {
    (void)state;
    kg_random r = {11};
    size_t more = 0;
    for (int round = 0; round < 120; round++) {
        kg_model *model = random_model(&r, 5);
        nets n = unroll_both(model, kg_v2(90, 70));
        double joined[2] = {0, 0};
        more += n.cut->net->part_count - n.whole->net->part_count;
        for (int k = 0; k < 2; k++) {
            const kg_net *net = k ? n.cut->net : n.whole->net;
            for (size_t i = 0; i < net->join_count; i++) {
                bool own = net->joins[i].sources[0] == net->joins[i].sources[1];
                joined[k] += own ? 0 : net->joins[i].sides[0].length;
            }
        }
        assert_near(total_area(n.cut->net), total_area(n.whole->net), 1e-5);
        /* ends of joins are found to chord errors, and cuts make more ends */
        double slack = 0.2 * (double)(n.cut->net->join_count + 1);
        if (!keeps_all_pieces(n.whole->net))
            assert_near(joined[0], joined[1], slack);
        clear(&n);
        kg_model_destroy(model);
    }
    assert_true(more > 40);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_parts_become_pieces_that_fit_and_are_joined),
        cmocka_unit_test(cuts_keep_clear_of_holes),
        cmocka_unit_test(parts_that_fit_are_left_alone),
        cmocka_unit_test(rulings_longer_than_the_page_are_no_endless_loop),
        cmocka_unit_test(random_models_keep_area_and_joined_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
