#include "tests/net/tab_check.h"

#include <geos_c.h>

enum { OUTLINE_MAX = 600, TABS_MAX = 2000 };

void tab_draw(tab_pen *p, double x, double y, bool corner) {
    p->points[p->count] = kg_v2(x, y);
    p->corners[p->count++] = corner;
}

void tab_add_contour(kg_net *net, size_t part, tab_pen *p) {
    assert_int_equal(kg_net_add_loop(net, part, p->points, p->corners, p->count, NULL), KG_OK);
    p->count = 0;
}

size_t tab_add_part(kg_net *net) {
    size_t part;
    assert_int_equal(kg_net_add_part(net, 1, "part", &part, NULL), KG_OK);
    return part;
}

size_t tab_add_polygon(kg_net *net, const kg_vec2 *points, size_t count) {
    size_t part = tab_add_part(net);
    assert_int_equal(kg_net_add_loop(net, part, points, NULL, count, NULL), KG_OK);
    return part;
}

kg_net_side tab_edge(size_t part, int loop, size_t first, size_t count) {
    return (kg_net_side){
        .part = (int)part, .loop = loop, .first = first, .count = count, .line = -1, .length = 1};
}

kg_net_side tab_nothing(void) {
    return (kg_net_side){.part = -1, .loop = -1, .line = -1};
}

kg_net_join *tab_add_join(kg_net *net, kg_net_side a, kg_net_side b) {
    kg_net_join join = {
        .kind = b.part < 0 ? KG_JOIN_CONTACT : KG_JOIN_SEAM, .sides = {a, b}, .fold = {1, -1}};
    size_t index;
    assert_int_equal(kg_net_add_join(net, &join, &index, NULL), KG_OK);
    return &net->joins[index];
}

void tab_draw_circle(tab_pen *p, double radius, double direction) {
    for (int i = 0; i < 120; i++) {
        double t = direction * 2 * KG_PI * i / 120;
        tab_draw(p, radius * cos(t), radius * sin(t), false);
    }
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
    kg_vec2 outline[OUTLINE_MAX];
    assert_true(fold->count + 2 <= OUTLINE_MAX);
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

kg_net *tab_make(const kg_net *net, const kg_tab_options *options, kg_tab_report *report) {
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
size_t tab_count(kg_net *net, kg_tab_report *report) {
    kg_tab_options options = kg_tab_options_default();
    kg_net *made = tab_make(net, &options, report);
    for (size_t i = 0; i < net->join_count; i++)
        check_sides(net, made, i);
    kg_net_destroy(made);
    return report->tab_count;
}

const kg_tab_remark *tab_remark_of(const kg_tab_report *report, kg_tab_trouble trouble,
                                   kg_tab_reason reason) {
    for (size_t i = 0; i < report->remark_count; i++)
        if (report->remarks[i].trouble == trouble && report->remarks[i].reason == reason)
            return &report->remarks[i];
    return NULL;
}
