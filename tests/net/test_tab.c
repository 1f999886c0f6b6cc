#include "tests/check.h"

#include "net/tab.h"

#include <geos_c.h>
#include <stdlib.h>

enum { POINTS_MAX = 600, TABS_MAX = 2000 };

static const double PI = 3.14159265358979323846;

/* A contour being drawn. */
typedef struct pen {
    kg_vec2 points[POINTS_MAX];
    unsigned char corners[POINTS_MAX];
    size_t count;
} pen;

static void draw(pen *p, double x, double y, bool corner) {
    p->points[p->count] = kg_v2(x, y);
    p->corners[p->count++] = corner;
}

static void add_contour(kg_net *net, size_t part, pen *p) {
    assert_int_equal(kg_net_add_loop(net, part, p->points, p->corners, p->count, NULL), KG_OK);
    p->count = 0;
}

static size_t add_part(kg_net *net) {
    size_t part;
    assert_int_equal(kg_net_add_part(net, 1, "part", &part, NULL), KG_OK);
    return part;
}

static size_t add_polygon(kg_net *net, const kg_vec2 *points, size_t count) {
    size_t part = add_part(net);
    assert_int_equal(kg_net_add_loop(net, part, points, NULL, count, NULL), KG_OK);
    return part;
}

static kg_net_side edge(size_t part, int loop, size_t first, size_t count) {
    return (kg_net_side){
        .part = (int)part, .loop = loop, .first = first, .count = count, .line = -1, .length = 1};
}

static kg_net_side nothing(void) {
    return (kg_net_side){.part = -1, .loop = -1, .line = -1};
}

static kg_net_join *add_join(kg_net *net, kg_net_side a, kg_net_side b) {
    kg_net_join join = {
        .kind = b.part < 0 ? KG_JOIN_CONTACT : KG_JOIN_SEAM, .sides = {a, b}, .fold = {1, -1}};
    size_t index;
    assert_int_equal(kg_net_add_join(net, &join, &index, NULL), KG_OK);
    return &net->joins[index];
}

/* ---- what every net with tabs must be ---------------------------------------------------- */

static GEOSGeometry *ring_of(GEOSContextHandle_t geos, const kg_vec2 *points, size_t count) {
    GEOSCoordSequence *seq = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    for (unsigned i = 0; i <= count; i++)
        GEOSCoordSeq_setXY_r(geos, seq, i, points[i % count].x, points[i % count].y);
    return GEOSGeom_createLinearRing_r(geos, seq);
}

static GEOSGeometry *part_of(GEOSContextHandle_t geos, const kg_net_part *part) {
    GEOSGeometry *rings[4];
    assert_true(part->loop_count <= 4);
    for (size_t i = 0; i < part->loop_count; i++)
        rings[i] = ring_of(geos, part->loops[i].line.points, part->loops[i].line.count);
    return GEOSGeom_createPolygon_r(geos, rings[0], rings + 1, (unsigned)part->loop_count - 1);
}

static double area_of(GEOSContextHandle_t geos, const GEOSGeometry *g) {
    double area = 0;
    assert_int_equal(GEOSArea_r(geos, g, &area), 1);
    return area;
}

static double common_area(GEOSContextHandle_t geos, const GEOSGeometry *a, const GEOSGeometry *b) {
    GEOSGeometry *common = GEOSIntersection_r(geos, a, b);
    assert_non_null(common);
    double area = area_of(geos, common);
    GEOSGeom_destroy_r(geos, common);
    return area;
}

static bool same(kg_vec2 a, kg_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

static double length_of(const kg_net_line *line, size_t first, size_t count) {
    double sum = 0;
    for (size_t i = 0; i + 1 < count; i++)
        sum += kg_dist2(line->points[(first + i) % line->count],
                        line->points[(first + i + 1) % line->count]);
    return sum;
}

/* The tab over a fold as a polygon: the contour goes from one end of the fold over two points to
 * the other, all of them corners. */
static GEOSGeometry *tab_over(GEOSContextHandle_t geos, const kg_net_part *part,
                              const kg_net_line *fold) {
    kg_vec2 outline[POINTS_MAX];
    assert_true(fold->count + 2 <= POINTS_MAX);
    for (size_t l = 0; l < part->loop_count; l++) {
        const kg_net_line *line = &part->loops[l].line;
        for (size_t i = 0; i < line->count; i++) {
            size_t at[4];
            for (size_t k = 0; k < 4; k++)
                at[k] = (i + k) % line->count;
            if (!same(line->points[i], fold->points[0]) ||
                !same(line->points[at[3]], fold->points[fold->count - 1]))
                continue;
            for (size_t k = 0; k < 4; k++)
                assert_true(line->corners[at[k]]);
            size_t n = 0;
            outline[n++] = line->points[at[1]];
            outline[n++] = line->points[at[2]];
            for (size_t k = fold->count; k > 0; k--)
                outline[n++] = fold->points[k - 1];
            GEOSGeometry *ring = ring_of(geos, outline, n);
            return GEOSGeom_createPolygon_r(geos, ring, NULL, 0);
        }
    }
    fail_msg("a fold has no tab");
    return NULL;
}

/* Every point of the old contours is in the new ones or in a fold. */
static void check_points_kept(const kg_net_part *old, const kg_net_part *made) {
    for (size_t l = 0; l < old->loop_count; l++) {
        const kg_net_line *before = &old->loops[l].line, *after = &made->loops[l].line;
        for (size_t i = 0; i < before->count; i++) {
            bool found = false;
            for (size_t k = 0; k < after->count && !found; k++) {
                found = kg_dist2(before->points[i], after->points[k]) < 2e-6;
                if (found && before->corners[i])
                    assert_true(after->corners[k]);
            }
            for (size_t f = old->line_count; f < made->line_count && !found; f++)
                for (size_t k = 0; k < made->lines[f].count && !found; k++)
                    found = same(before->points[i], made->lines[f].points[k]);
            assert_true(found);
        }
    }
}

static size_t check_part(const kg_net *old_net, const kg_net *net, size_t index) {
    const kg_net_part *old = &old_net->parts[index], *part = &net->parts[index];
    GEOSContextHandle_t geos = GEOS_init_r();
    GEOSGeometry *before = part_of(geos, old), *after = part_of(geos, part);
    static GEOSGeometry *tabs[TABS_MAX];
    size_t count = 0;
    double area = area_of(geos, before);
    assert_int_equal(GEOSisValid_r(geos, before), 1);
    assert_int_equal(GEOSisValid_r(geos, after), 1);
    for (size_t i = old->line_count; i < part->line_count; i++) {
        const kg_net_line *fold = &part->lines[i];
        assert_int_equal(fold->tab, count + 1);
        assert_in_range(fold->join, 0, net->join_count - 1);
        assert_true(fold->kind == KG_NET_MOUNTAIN || fold->kind == KG_NET_VALLEY);
        tabs[count] = tab_over(geos, part, fold);
        assert_true(area_of(geos, tabs[count]) > 0);
        area += area_of(geos, tabs[count]);
        assert_true(common_area(geos, tabs[count], before) < 1e-6);
        for (size_t k = 0; k < count; k++)
            if (GEOSIntersects_r(geos, tabs[count], tabs[k]))
                assert_true(common_area(geos, tabs[count], tabs[k]) < 1e-6);
        count++;
    }
    assert_near(area_of(geos, after), area, 1e-5 * (1 + area));
    check_points_kept(old, part);
    for (size_t k = 0; k < count; k++)
        GEOSGeom_destroy_r(geos, tabs[k]);
    GEOSGeom_destroy_r(geos, before);
    GEOSGeom_destroy_r(geos, after);
    GEOS_finish_r(geos);
    return count;
}

/* Folds and missing stretches add up to the whole side that carries the tabs. */
static void check_accounts(const kg_net *old, const kg_net *net, const kg_tab_report *report,
                           size_t join) {
    double length = 0, slack = 1e-3;
    int side = -1;
    for (size_t p = 0; p < net->part_count; p++)
        for (size_t i = old->parts[p].line_count; i < net->parts[p].line_count; i++) {
            const kg_net_line *fold = &net->parts[p].lines[i];
            if (fold->join != (int)join)
                continue;
            bool first = old->joins[join].sides[0].part == (int)p;
            length += length_of(fold, 0, fold->count);
            slack += 0.1;
            side = first ? 0 : 1;
        }
    for (size_t i = 0; i < report->remark_count; i++) {
        const kg_tab_remark *r = &report->remarks[i];
        if (r->join != (int)join)
            continue;
        side = r->side;
        length += r->trouble == KG_TAB_MISSING ? r->length : 0;
    }
    if (old->joins[join].tab_side == KG_TAB_NONE) {
        assert_near(length, 0, 0);
        return;
    }
    assert_in_range(side, 0, 1);
    kg_net_side s = old->joins[join].sides[side];
    const kg_net_line *line = &old->parts[s.part].loops[s.loop].line;
    assert_near(length, length_of(line, s.first, s.count), slack);
}

/* A side counted on the new contour goes from the same point to the same point, where no other
 * join's tab covers them. */
static void check_sides(const kg_net *old, const kg_net *net, size_t join) {
    for (int k = 0; k < 2; k++) {
        kg_net_side a = old->joins[join].sides[k], b = net->joins[join].sides[k];
        if (a.part < 0)
            continue;
        const kg_net_line *before = &old->parts[a.part].loops[a.loop].line;
        const kg_net_line *after = &net->parts[b.part].loops[b.loop].line;
        kg_vec2 first = before->points[a.first];
        assert_true(b.count <= after->count + 1);
        assert_int_equal(a.count > before->count, b.count > after->count);
        assert_near(kg_dist2(first, after->points[b.first]), 0, 2e-6);
    }
}

static kg_net *with_tabs(const kg_net *net, const kg_tab_options *options, kg_tab_report *report) {
    kg_net *made = NULL;
    kg_error error;
    kg_status status = kg_net_tabs(net, options, &made, report, &error);
    if (status != KG_OK)
        print_error("%s\n", error.message);
    assert_int_equal(status, KG_OK);
    assert_int_equal(kg_net_check(made, &error), KG_OK);
    size_t tabs = 0;
    for (size_t i = 0; i < net->part_count; i++)
        tabs += check_part(net, made, i);
    assert_int_equal(tabs, report->tab_count);
    for (size_t i = 0; i < net->join_count; i++)
        check_accounts(net, made, report, i);
    return made;
}

/* Adds tabs to a net of one part, checks all of the above, and counts them. */
static size_t count_tabs(kg_net *net, kg_tab_report *report) {
    kg_tab_options options = kg_tab_options_default();
    kg_net *made = with_tabs(net, &options, report);
    for (size_t i = 0; i < net->join_count; i++)
        check_sides(net, made, i);
    kg_net_destroy(made);
    return report->tab_count;
}

static const kg_tab_remark *remark_of(const kg_tab_report *report, kg_tab_trouble trouble,
                                      kg_tab_reason reason) {
    for (size_t i = 0; i < report->remark_count; i++)
        if (report->remarks[i].trouble == trouble && report->remarks[i].reason == reason)
            return &report->remarks[i];
    return NULL;
}

static int setup(void **state) {
    return (*state = kg_net_create()) ? 0 : -1;
}

static int teardown(void **state) {
    kg_net_destroy(*state);
    return 0;
}

/* ---- random parts ------------------------------------------------------------------------ */

static void draw_blob(pen *p, kg_random *r) {
    double radius = kg_random_in(r, 8, 50), a = kg_random_in(r, 0, 0.25),
           b = kg_random_in(r, 0, 0.1);
    double m = floor(kg_random_in(r, 2, 6)), k = floor(kg_random_in(r, 6, 12));
    for (int i = 0; i < 400; i++) {
        double t = 2 * PI * i / 400, d = radius * (1 + a * sin(m * t) + b * sin(k * t));
        draw(p, d * cos(t), d * sin(t), false);
    }
}

static void draw_leaf(pen *p, kg_random *r) {
    double length = kg_random_in(r, 15, 120), width = kg_random_in(r, 1, 0.3 * length);
    double under = kg_random_in(r, 0.05, 1), bend = kg_random_in(r, -0.2, 0.2) * length;
    for (int i = 0; i < 200; i++) {
        double t = i / 100.0, x = t < 1 ? t : 2 - t;
        double y = t < 1 ? -width * sin(PI * t) : under * width * sin(PI * (t - 1));
        draw(p, x * length, y + bend * sin(PI * x), i == 0 || i == 100);
    }
}

static void draw_crescent(pen *p, kg_random *r) {
    double radius = kg_random_in(r, 8, 60), depth = kg_random_in(r, 0.3, 0.95);
    for (int i = 0; i < 300; i++) {
        double t = PI * (i < 150 ? i : 300 - i) / 150;
        draw(p, radius * cos(t), radius * sin(t) * (i < 150 ? 1 : depth), i == 0 || i == 150);
    }
}

static void draw_circle(pen *p, double radius, double direction) {
    for (int i = 0; i < 120; i++) {
        double t = direction * 2 * PI * i / 120;
        draw(p, radius * cos(t), radius * sin(t), false);
    }
}

static void draw_sliver(pen *p, kg_random *r) {
    double length = kg_random_in(r, 30, 150), width = kg_random_in(r, 0.2, 2);
    double turn = kg_random_in(r, 0.1, 2);
    for (int i = 0; i < 160; i++) {
        double t = turn * (i < 80 ? i : 159 - i) / 79, d = length / turn + (i < 80 ? width : 0);
        draw(p, d * cos(t), d * sin(t), i % 80 == 0 || i % 80 == 79);
    }
}

static void draw_zigzag(pen *p, kg_random *r) {
    int teeth = (int)kg_random_in(r, 3, 9);
    double length = kg_random_in(r, 4, 20);
    for (int i = 0; i < teeth; i++) {
        draw(p, length * i, 0, true);
        draw(p, length * (i + kg_random_in(r, 0.2, 0.8)), kg_random_in(r, 2, 15), true);
    }
    draw(p, length * teeth, 0, true);
    draw(p, length * teeth, 30, true);
    draw(p, 0, 30, true);
}

static size_t add_random_part(kg_net *net, kg_random *r) {
    static void (*const kinds[])(pen *, kg_random *) = {draw_blob, draw_leaf, draw_crescent,
                                                        draw_sliver, draw_zigzag};
    size_t part = add_part(net), kind = kg_random_bits(r) % 6;
    pen p = {.count = 0};
    if (kind < 5) {
        kinds[kind](&p, r);
        add_contour(net, part, &p);
        return part;
    }
    double radius = kg_random_in(r, 5, 50);
    draw_circle(&p, radius, 1);
    add_contour(net, part, &p);
    draw_circle(&p, radius * kg_random_in(r, 0.05, 0.9), -1);
    add_contour(net, part, &p);
    return part;
}

/* Cuts every contour of a part into a few stretches. */
static size_t random_sides(const kg_net *net, size_t part, kg_random *r, kg_net_side *out) {
    size_t count = 0;
    for (size_t l = 0; l < net->parts[part].loop_count; l++) {
        size_t n = net->parts[part].loops[l].line.count, at = kg_random_bits(r) % n, left = n;
        if (kg_random_bits(r) % 4 == 0) {
            out[count++] = edge(part, (int)l, at, n + 1);
            continue;
        }
        while (left > 0 && count < 12) {
            size_t steps = 1 + kg_random_bits(r) % (n / 2);
            steps = steps < left ? steps : left;
            out[count++] = edge(part, (int)l, at, steps + 1);
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
        kg_net_join *join = add_join(net, a[i], seam ? b[i] : nothing());
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
        kg_net *made = with_tabs(net, &options, &report);
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
        made[k] = with_tabs(net, &options, &report);
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

/* ---- cases ------------------------------------------------------------------------------- */

static const kg_vec2 BOX[4] = {{0, 0}, {80, 0}, {80, 60}, {0, 60}};

static void test_a_straight_edge_gets_one_trapezoid(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    add_join(net, edge(add_polygon(net, BOX, 4), 0, 0, 2), nothing());
    made = with_tabs(net, &options, &report);
    assert_int_equal(report.tab_count, 1);
    assert_int_equal(report.remark_count, 0);
    const kg_net_line *line = &made->parts[0].loops[0].line;
    const kg_vec2 expected[6] = {{0, 0}, {5, -5}, {75, -5}, {80, 0}, {80, 60}, {0, 60}};
    assert_int_equal(line->count, 6);
    for (size_t i = 0; i < 6; i++)
        assert_near(kg_dist2(line->points[i], expected[i]), 0, 0.01);
    assert_int_equal(made->parts[0].line_count, 1);
    assert_int_equal(made->parts[0].lines[0].kind, KG_NET_VALLEY);
    assert_int_equal(made->joins[0].sides[0].count, 4);
    kg_net_destroy(made);
}

static void test_collinear_points_flagged_as_corners_do_not_split_a_tab(void **state) {
    const kg_vec2 points[] = {{0, 0}, {10, 0}, {25, 0}, {26, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    add_join(net, edge(add_polygon(net, points, 7), 0, 0, 5), nothing());
    assert_int_equal(count_tabs(net, &report), 1);
    assert_int_equal(report.remark_count, 0);
}

static void test_duplicate_points_do_no_harm(void **state) {
    const kg_vec2 points[] = {{0, 0},  {0, 0},  {40, 0},  {40, 0},
                              {80, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    add_join(net, edge(add_polygon(net, points, 8), 0, 0, 6), nothing());
    assert_int_equal(count_tabs(net, &report), 1);
    net->joins[0].sides[0] = edge(0, 0, 2, 2); /* of no length: nothing to glue */
    kg_tab_options options = kg_tab_options_default();
    kg_net *made;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, NULL), KG_OK);
    assert_int_equal(report.tab_count, 0);
    assert_int_equal(report.remark_count, 0);
    kg_net_destroy(made);
}

static void test_an_edge_shorter_than_the_tab_is_wide_gets_a_lower_one(void **state) {
    const kg_vec2 points[] = {{0, 0}, {38, 0}, {40, 1}, {42, 0}, {80, 0}, {80, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = add_polygon(net, points, 7);
    kg_net_join *join = add_join(net, edge(part, 0, 0, 2), nothing());
    join->sides[0] = edge(part, 0, 5, 2);
    net->parts[0].loops[0].line.points[6] = kg_v2(77, 60);
    join->sides[0].count = 2;
    assert_int_equal(count_tabs(net, &report), 1);
    const kg_tab_remark *remark = remark_of(&report, KG_TAB_LOWERED, KG_TAB_SHORT);
    assert_non_null(remark);
    assert_near(remark->length, 3, 1e-9);
    assert_true(remark->height > 2 && remark->height < 5);
    kg_tab_report_clear(&report);
}

static void test_a_tiny_stretch_is_named_or_has_a_tiny_tab(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    const kg_vec2 points[] = {{0, 0}, {80, 0}, {80, 60}, {0.05, 60}, {0, 60}};
    add_join(net, edge(add_polygon(net, points, 5), 0, 3, 2), nothing());
    count_tabs(net, &report);
    assert_int_equal(report.remark_count, 1);
    assert_near(report.remarks[0].length, 0.05, 1e-6);
    kg_tab_report_clear(&report);
}

static void test_two_joins_at_a_narrow_corner_share_it(void **state) {
    const kg_vec2 points[] = {{0, 0}, {80, 0}, {80, 60}, {46, 60}, {40, 20}, {34, 60}, {0, 60}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = add_polygon(net, points, 7);
    add_join(net, edge(part, 0, 3, 2), nothing());
    add_join(net, edge(part, 0, 4, 2), nothing());
    assert_true(count_tabs(net, &report) >= 2);
    assert_true(report.remark_count > 0);
    double missing[2] = {0, 0};
    for (size_t i = 0; i < report.remark_count; i++)
        if (report.remarks[i].trouble == KG_TAB_MISSING)
            missing[report.remarks[i].join] += report.remarks[i].length;
    assert_true(missing[0] < 30 && missing[1] < 30);
    kg_tab_report_clear(&report);
}

static void test_facing_edges_of_a_narrow_slot_give_way_together(void **state) {
    const kg_vec2 points[] = {{0, 0},   {70, 0},  {70, 50}, {38, 50},
                              {38, 10}, {32, 10}, {32, 50}, {0, 50}};
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    size_t part = add_polygon(net, points, 8);
    add_join(net, edge(part, 0, 3, 2), nothing());
    add_join(net, edge(part, 0, 5, 2), nothing());
    made = with_tabs(net, &options, &report);
    assert_int_equal(report.tab_count, 2);
    assert_int_equal(report.remark_count, 2);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(report.remarks[i].join, i);
        assert_int_equal(report.remarks[i].trouble, KG_TAB_LOWERED);
        assert_int_equal(report.remarks[i].reason, KG_TAB_NEIGHBOUR);
        assert_true(report.remarks[i].height > 2 && report.remarks[i].height < 3);
    }
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_slot_narrower_than_the_tab_lowers_it(void **state) {
    const kg_vec2 points[] = {{0, 0},   {70, 0},  {70, 50}, {37, 50},
                              {37, 10}, {33, 10}, {33, 50}, {0, 50}};
    kg_net *net = *state;
    kg_tab_report report;
    add_join(net, edge(add_polygon(net, points, 8), 0, 3, 2), nothing());
    count_tabs(net, &report);
    const kg_tab_remark *remark = remark_of(&report, KG_TAB_LOWERED, KG_TAB_NO_ROOM);
    assert_non_null(remark);
    assert_true(remark->height > 2.5 && remark->height < 4);
    kg_tab_report_clear(&report);
}

static void test_an_acute_part_keeps_its_tabs_outside(void **state) {
    const kg_vec2 points[] = {{0, 0}, {60, 0}, {60, 3}};
    kg_net *net = *state;
    kg_tab_report report;
    size_t part = add_polygon(net, points, 3);
    for (size_t i = 0; i < 3; i++)
        add_join(net, edge(part, 0, i, 2), nothing());
    assert_int_equal(count_tabs(net, &report), 3);
    kg_tab_report_clear(&report);
}

static void add_ring(kg_net *net, double radius, double hole) {
    size_t part = add_part(net);
    pen p = {.count = 0};
    draw_circle(&p, radius, 1);
    add_contour(net, part, &p);
    draw_circle(&p, hole, -1);
    add_contour(net, part, &p);
}

static void test_a_whole_hole_gets_teeth_inside_it(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    add_ring(net, 40, 18);
    add_join(net, edge(0, 1, 70, 121), nothing());
    made = with_tabs(net, &options, &report);
    assert_in_range(report.tab_count, 16, 30);
    const kg_net_line *line = &made->parts[0].loops[1].line;
    assert_int_equal(made->joins[0].sides[0].count, line->count + 1);
    for (size_t i = 0; i < line->count; i++)
        assert_true(kg_len2(line->points[i]) < 18 + 1e-9);
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_hole_too_small_for_tabs_is_named(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    add_ring(net, 40, 0.3);
    add_join(net, edge(0, 1, 0, 121), nothing());
    count_tabs(net, &report);
    assert_true(report.remark_count > 0);
    kg_tab_report_clear(&report);
}

static void test_a_stretch_may_cross_the_start_of_its_contour(void **state) {
    kg_net *net = *state;
    kg_tab_report first, second;
    add_ring(net, 40, 18);
    add_join(net, edge(0, 0, 100, 41), nothing());
    size_t across = count_tabs(net, &first);
    net->joins[0].sides[0] = edge(0, 0, 20, 41);
    assert_int_equal(count_tabs(net, &second), across);
    assert_true(across > 5);
    kg_tab_report_clear(&first);
    kg_tab_report_clear(&second);
}

static void test_teeth_bases_are_nearly_straight(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    add_ring(net, 40, 12);
    add_join(net, edge(0, 0, 0, 121), nothing());
    add_join(net, edge(0, 1, 0, 121), nothing());
    made = with_tabs(net, &options, &report);
    const kg_net_part *part = &made->parts[0];
    for (size_t i = 0; i < part->line_count; i++) {
        kg_vec2 a = part->lines[i].points[0];
        kg_vec2 b = part->lines[i].points[part->lines[i].count - 1];
        for (size_t k = 0; k < part->lines[i].count; k++) {
            kg_vec2 p = part->lines[i].points[k];
            double off = fabs(kg_cross2(kg_sub2(b, a), kg_sub2(p, a))) / kg_dist2(a, b);
            assert_true(off < 0.35);
        }
    }
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_a_straight_edge_that_bends_in_space_gets_teeth(void **state) {
    /* The rim of a cylinder of radius 20 mm: 80 mm of it turn by 4 radians. */
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    const double turned[2] = {0, 4};
    const double *bends[2] = {turned, NULL};
    options.bends = bends;
    add_join(net, edge(add_polygon(net, BOX, 4), 0, 0, 2), nothing());
    made = with_tabs(net, &options, &report);
    assert_in_range(report.tab_count, 11, 16);
    kg_tab_report_clear(&report);
    kg_net_destroy(made);
}

static void test_tabs_go_to_the_side_that_is_asked_for(void **state) {
    kg_net *net = *state;
    kg_tab_options options = kg_tab_options_default();
    size_t a = add_polygon(net, BOX, 4), b = add_polygon(net, BOX, 4);
    kg_net_join *join = add_join(net, edge(a, 0, 0, 2), edge(b, 0, 0, 2));
    static const size_t expected[4][2] = {{1, 0}, {0, 0}, {1, 0}, {0, 1}};
    for (int wish = KG_TAB_AUTO; wish <= KG_TAB_OTHER; wish++) {
        kg_tab_report report;
        join->tab_side = (kg_net_tab_side)wish;
        kg_net *made = with_tabs(net, &options, &report);
        assert_int_equal(made->parts[0].line_count, expected[wish][0]);
        assert_int_equal(made->parts[1].line_count, expected[wish][1]);
        if (wish == KG_TAB_OTHER)
            assert_int_equal(made->parts[1].lines[0].kind, KG_NET_MOUNTAIN);
        assert_int_equal(report.remark_count, 0);
        kg_net_destroy(made);
    }
}

static void test_a_seam_prefers_the_side_with_room(void **state) {
    /* Side 0 is the wall of a slot, side 1 free. */
    const kg_vec2 slot[] = {{0, 0},   {70, 0},  {70, 50}, {36, 50},
                            {36, 10}, {34, 10}, {34, 50}, {0, 50}};
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    size_t a = add_polygon(net, slot, 8), b = add_polygon(net, BOX, 4);
    add_join(net, edge(a, 0, 3, 2), edge(b, 0, 0, 2));
    made = with_tabs(net, &options, &report);
    assert_int_equal(made->parts[0].line_count, 0);
    assert_int_equal(made->parts[1].line_count, 1);
    assert_int_equal(report.remark_count, 0);
    kg_net_destroy(made);
}

static void test_a_wish_that_cannot_be_met_is_named(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    kg_net_join *join = add_join(net, edge(add_polygon(net, BOX, 4), 0, 0, 2), nothing());
    join->tab_side = KG_TAB_OTHER;
    assert_int_equal(count_tabs(net, &report), 1);
    assert_non_null(remark_of(&report, KG_TAB_MOVED, KG_TAB_NO_EDGE));
    kg_tab_report_clear(&report);
}

static void test_one_edge_in_two_joins_has_one_row_of_tabs(void **state) {
    kg_net *net = *state;
    kg_tab_report report;
    size_t a = add_polygon(net, BOX, 4);
    add_join(net, edge(a, 0, 0, 2), nothing());
    add_join(net, edge(a, 0, 0, 2), nothing());
    assert_int_equal(count_tabs(net, &report), 1);
    const kg_tab_remark *remark = remark_of(&report, KG_TAB_MISSING, KG_TAB_TAKEN);
    assert_non_null(remark);
    assert_int_equal(remark->join, 1);
    assert_near(remark->length, 80, 1e-9);
    kg_tab_report_clear(&report);
}

static void test_shape_and_width_of_a_join_are_kept(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_net_join *join = add_join(net, edge(add_polygon(net, BOX, 4), 0, 0, 2), nothing());
    join->tab_width = 8;
    made = with_tabs(net, &options, &report);
    assert_near(made->parts[0].loops[0].line.points[1].y, -8, 1e-9);
    kg_net_destroy(made);
    join->tab_shape = KG_TAB_TEETH;
    made = with_tabs(net, &options, &report);
    assert_in_range(report.tab_count, 10, 11);
    kg_net_destroy(made);
}

static void test_no_tabs_leave_the_net_as_it_was(void **state) {
    kg_net *net = *state, *made;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_error error;
    add_ring(net, 40, 18);
    net->parts[0].area = 123;
    add_join(net, edge(0, 0, 110, 41), nothing());
    options.none = true;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_OK);
    assert_int_equal(report.tab_count, 0);
    assert_int_equal(report.remark_count, 0);
    assert_int_equal(made->joins[0].sides[0].first, 110);
    assert_int_equal(made->joins[0].sides[0].count, 41);
    assert_near(made->parts[0].area, 123, 0);
    for (size_t l = 0; l < 2; l++) {
        const kg_net_line *a = &net->parts[0].loops[l].line, *b = &made->parts[0].loops[l].line;
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->points, b->points, a->count * sizeof *a->points);
        assert_memory_equal(a->corners, b->corners, a->count);
    }
    kg_net_destroy(made);
}

static void test_senseless_widths_are_refused(void **state) {
    kg_net *net = *state, *made = NULL;
    kg_tab_options options = kg_tab_options_default();
    kg_tab_report report;
    kg_error error;
    kg_net_join *join = add_join(net, edge(add_polygon(net, BOX, 4), 0, 0, 2), nothing());
    options.width = NAN;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    options = kg_tab_options_default();
    options.least = 6;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    options = kg_tab_options_default();
    join->tab_width = -1;
    assert_int_equal(kg_net_tabs(net, &options, &made, &report, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "join 1"));
    assert_null(made);
}

#define tab_test(f) cmocka_unit_test_setup_teardown(f, setup, teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_curved_parts_get_tabs_that_overlap_nothing),
        cmocka_unit_test(test_the_same_net_gets_the_same_tabs),
        tab_test(test_a_straight_edge_gets_one_trapezoid),
        tab_test(test_collinear_points_flagged_as_corners_do_not_split_a_tab),
        tab_test(test_duplicate_points_do_no_harm),
        tab_test(test_an_edge_shorter_than_the_tab_is_wide_gets_a_lower_one),
        tab_test(test_a_tiny_stretch_is_named_or_has_a_tiny_tab),
        tab_test(test_two_joins_at_a_narrow_corner_share_it),
        tab_test(test_facing_edges_of_a_narrow_slot_give_way_together),
        tab_test(test_a_slot_narrower_than_the_tab_lowers_it),
        tab_test(test_an_acute_part_keeps_its_tabs_outside),
        tab_test(test_a_whole_hole_gets_teeth_inside_it),
        tab_test(test_a_hole_too_small_for_tabs_is_named),
        tab_test(test_a_stretch_may_cross_the_start_of_its_contour),
        tab_test(test_teeth_bases_are_nearly_straight),
        tab_test(test_a_straight_edge_that_bends_in_space_gets_teeth),
        tab_test(test_tabs_go_to_the_side_that_is_asked_for),
        tab_test(test_a_seam_prefers_the_side_with_room),
        tab_test(test_a_wish_that_cannot_be_met_is_named),
        tab_test(test_one_edge_in_two_joins_has_one_row_of_tabs),
        tab_test(test_shape_and_width_of_a_join_are_kept),
        tab_test(test_no_tabs_leave_the_net_as_it_was),
        tab_test(test_senseless_widths_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
