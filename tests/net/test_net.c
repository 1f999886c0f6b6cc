#include "tests/check.h"

#include "katagami/net.h"

static const kg_vec2 square[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
static const kg_vec2 hole[] = {{2, 2}, {2, 4}, {4, 4}, {4, 2}};

static kg_net *square_net(void) {
    kg_net *net = kg_net_create();
    size_t part;
    assert_int_equal(kg_net_add_part(net, 7, "四角", &part, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, square, NULL, 4, NULL), KG_OK);
    assert_int_equal(kg_net_add_loop(net, part, hole, NULL, 4, NULL), KG_OK);
    return net;
}

static void parts_are_numbered_and_copied(void **state) {
    (void)state;
    kg_net *net = square_net();
    size_t part;
    assert_int_equal(kg_net_add_part(net, 8, NULL, &part, NULL), KG_OK);
    assert_int_equal(part, 1);
    assert_int_equal(net->parts[1].number, 2);
    assert_string_equal(net->parts[0].name, "四角");
    assert_string_equal(net->parts[1].name, "");
    assert_ptr_not_equal(net->parts[0].loops[0].line.points, square);
    assert_int_equal(net->parts[0].loops[1].line.corners[3], 1);
    kg_net_destroy(net);
}

static void check_names_the_wrong_contour(void **state) {
    (void)state;
    kg_net *net = square_net();
    kg_error error;
    assert_int_equal(kg_net_check(net, &error), KG_OK);
    net->parts[0].loops[1].line.points[1] = kg_v2(4, 2);
    net->parts[0].loops[1].line.points[3] = kg_v2(2, 4);
    assert_int_equal(kg_net_check(net, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "contour 1"));
    net->parts[0].loops[1].line.points[1] = kg_v2(NAN, 2);
    assert_int_equal(kg_net_check(net, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "not a number"));
    kg_net_destroy(net);
}

static void check_refuses_sides_outside_the_net(void **state) {
    (void)state;
    kg_net *net = square_net();
    kg_net_join join = {.sides = {{.part = 0, .loop = 0, .first = 3, .count = 2}, {.part = -1}}};
    size_t index;
    assert_int_equal(kg_net_add_join(net, &join, &index, NULL), KG_OK);
    assert_int_equal(net->joins[index].number, 1);
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    net->joins[0].sides[0].first = 4;
    assert_int_equal(kg_net_check(net, NULL), KG_ERR_INPUT);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_numbered_and_copied),
        cmocka_unit_test(check_names_the_wrong_contour),
        cmocka_unit_test(check_refuses_sides_outside_the_net),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
