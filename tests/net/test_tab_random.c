#include "tests/net/tab_check.h"

/* ---- random parts ------------------------------------------------------------------------ */

static void draw_blob(tab_pen *p, kg_random *r) {
    double radius = kg_random_in(r, 8, 50), a = kg_random_in(r, 0, 0.25),
           b = kg_random_in(r, 0, 0.1);
    double m = floor(kg_random_in(r, 2, 6)), k = floor(kg_random_in(r, 6, 12));
    for (int i = 0; i < 400; i++) {
        double t = 2 * KG_PI * i / 400, d = radius * (1 + a * sin(m * t) + b * sin(k * t));
        tab_draw(p, d * cos(t), d * sin(t), false);
    }
}

static void draw_leaf(tab_pen *p, kg_random *r) {
    double length = kg_random_in(r, 15, 120), width = kg_random_in(r, 1, 0.3 * length);
    double under = kg_random_in(r, 0.05, 1), bend = kg_random_in(r, -0.2, 0.2) * length;
    for (int i = 0; i < 200; i++) {
        double t = i / 100.0, x = t < 1 ? t : 2 - t;
        double y = t < 1 ? -width * sin(KG_PI * t) : under * width * sin(KG_PI * (t - 1));
        tab_draw(p, x * length, y + bend * sin(KG_PI * x), i == 0 || i == 100);
    }
}

static void draw_crescent(tab_pen *p, kg_random *r) {
    double radius = kg_random_in(r, 8, 60), depth = kg_random_in(r, 0.3, 0.95);
    for (int i = 0; i < 300; i++) {
        double t = KG_PI * (i < 150 ? i : 300 - i) / 150;
        tab_draw(p, radius * cos(t), radius * sin(t) * (i < 150 ? 1 : depth), i == 0 || i == 150);
    }
}

static void draw_sliver(tab_pen *p, kg_random *r) {
    double length = kg_random_in(r, 30, 150), width = kg_random_in(r, 0.2, 2);
    double turn = kg_random_in(r, 0.1, 2);
    for (int i = 0; i < 160; i++) {
        double t = turn * (i < 80 ? i : 159 - i) / 79, d = length / turn + (i < 80 ? width : 0);
        tab_draw(p, d * cos(t), d * sin(t), i % 80 == 0 || i % 80 == 79);
    }
}

static void draw_zigzag(tab_pen *p, kg_random *r) {
    int teeth = (int)kg_random_in(r, 3, 9);
    double length = kg_random_in(r, 4, 20);
    for (int i = 0; i < teeth; i++) {
        tab_draw(p, length * i, 0, true);
        double at = kg_random_in(r, 0.2, 0.8), depth = kg_random_in(r, 2, 15);
        tab_draw(p, length * (i + at), depth, true);
    }
    tab_draw(p, length * teeth, 0, true);
    tab_draw(p, length * teeth, 30, true);
    tab_draw(p, 0, 30, true);
}

static size_t add_random_part(kg_net *net, kg_random *r) {
    static void (*const kinds[])(tab_pen *, kg_random *) = {draw_blob, draw_leaf, draw_crescent,
                                                            draw_sliver, draw_zigzag};
    size_t part = tab_add_part(net), kind = kg_random_bits(r) % 6;
    tab_pen p = {.count = 0};
    if (kind < 5) {
        kinds[kind](&p, r);
        tab_add_contour(net, part, &p);
        return part;
    }
    double radius = kg_random_in(r, 5, 50);
    tab_draw_circle(&p, radius, 1);
    tab_add_contour(net, part, &p);
    tab_draw_circle(&p, radius * kg_random_in(r, 0.05, 0.9), -1);
    tab_add_contour(net, part, &p);
    return part;
}

/* Cuts every contour of a part into a few stretches. */
static size_t random_sides(const kg_net *net, size_t part, kg_random *r, kg_net_side *out) {
    size_t count = 0;
    for (size_t l = 0; l < net->parts[part].loop_count; l++) {
        size_t n = net->parts[part].loops[l].line.count, at = kg_random_bits(r) % n, left = n;
        if (kg_random_bits(r) % 4 == 0) {
            out[count++] = tab_edge(part, (int)l, at, n + 1);
            continue;
        }
        while (left > 0 && count < 12) {
            size_t steps = 1 + kg_random_bits(r) % (n / 2);
            steps = steps < left ? steps : left;
            out[count++] = tab_edge(part, (int)l, at, steps + 1);
            at = (at + steps) % n;
            left -= steps;
        }
    }
    return count;
}

static kg_net *random_net(kg_random *r) {
    kg_net *net = kg_net_create();
    kg_net_side a[40], b[40];
    size_t first = add_random_part(net, r), second = add_random_part(net, r);
    size_t a_count = random_sides(net, first, r, a), b_count = random_sides(net, second, r, b);
    for (size_t i = 0; i < a_count; i++) {
        if (kg_random_bits(r) % 5 == 0)
            continue;
        bool seam = i < b_count && kg_random_bits(r) % 3 != 0;
        kg_net_join *join = tab_add_join(net, a[i], seam ? b[i] : tab_nothing());
        join->tab_side = (kg_net_tab_side)(kg_random_bits(r) % 8);
        if (join->tab_side > KG_TAB_OTHER)
            join->tab_side = KG_TAB_AUTO;
        join->tab_shape = (kg_net_tab_shape)(kg_random_bits(r) % 5);
        if (join->tab_shape > KG_TAB_TEETH)
            join->tab_shape = KG_TAB_SHAPE_AUTO;
        join->tab_width = kg_random_bits(r) % 3 ? 0 : kg_random_in(r, 1, 12);
    }
    return net;
}

static void test_random_curved_parts_get_tabs_that_overlap_nothing(void **state) {
    (void)state;
    kg_random random = {1};
    size_t tabs = 0;
    kg_tab_options options = kg_tab_options_default();
    for (int run = 0; run < 200; run++) {
        kg_tab_report report = {0};
        kg_net *net = random_net(&random);
        kg_net *made = tab_make(net, &options, &report);
        tabs += report.tab_count;
        for (size_t i = 0; i < report.remark_count; i++) {
            char text[200];
            kg_tab_remark_print(net, &report.remarks[i], text, sizeof text);
            assert_true(strlen(text) > 20);
        }
        kg_tab_report_clear(&report);
        kg_net_destroy(made);
        kg_net_destroy(net);
    }
    assert_true(tabs > 4000);
}

static void test_the_same_net_gets_the_same_tabs(void **state) {
    (void)state;
    kg_random random = {2};
    kg_tab_options options = kg_tab_options_default();
    kg_net *net = random_net(&random), *made[2];
    for (int k = 0; k < 2; k++) {
        kg_tab_report report;
        made[k] = tab_make(net, &options, &report);
        kg_tab_report_clear(&report);
    }
    for (size_t p = 0; p < net->part_count; p++) {
        const kg_net_line *a = &made[0]->parts[p].loops[0].line;
        const kg_net_line *b = &made[1]->parts[p].loops[0].line;
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->points, b->points, a->count * sizeof *a->points);
    }
    kg_net_destroy(made[0]);
    kg_net_destroy(made[1]);
    kg_net_destroy(net);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_curved_parts_get_tabs_that_overlap_nothing),
        cmocka_unit_test(test_the_same_net_gets_the_same_tabs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
