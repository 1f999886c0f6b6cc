#include "net/tab_place.h"

#include "base/array.h"

#include <stdlib.h>

/* What an edge may do along one tab: with teeth, what a fold still follows; with trapezoids only,
 * what the user asks for. */
static const kg_tab_limits TEETH = {HUGE_VAL, 0.35, 0.3}, TRAPEZOIDS = {HUGE_VAL, 1.2, 2.0};
/* Flanks rise at 45 degrees where bases are long enough, up to 75 where they are short; the top
 * keeps 0.3 of the base. */
static const double FLANK_GENTLE = 0.785, FLANK_STEEP = 1.309, FLANKS_SHARE = 0.7;
/* A tab is at most this much higher than its base is long: higher ones tear off. */
static const double SLENDER = 1.3;
/* Share of the free sector at a foot that one tab takes: the other half is for the neighbour. */
static const double SECTOR_SHARE = 0.45;
/* Below this angle a flank makes a sliver; the foot moves to where it rises at SHORT_END. */
static const double SLIVER = 0.35, SHORT_END = 0.52;
/* mm kept between a tab and what it must not touch, and from where on a flank is looked at. */
static const double CLEARANCE = KG_TAB_CLEARANCE, LIFT = 0.02;
/* mm a tab is high at least, whatever the options allow. */
static const double LEAST_HEIGHT = 0.1;
/* Factor of one step lower, and where splitting is tried before going lower. */
static const double STEP_DOWN = KG_TAB_STEP_DOWN, SPLIT_BELOW = 0.6;
/* Bases (mm) are not split below this. */
static const double SPLIT_LEAST = 1.5;
enum { SPLITS_MAX = 5 };

/* ---- the part --------------------------------------------------------------------------- */

static GEOSGeometry *make_polygon(GEOSContextHandle_t geos, const kg_net_line *contours,
                                  size_t count) {
    GEOSGeometry **rings = calloc(count, sizeof *rings), *polygon = NULL;
    size_t made = 0;
    for (; rings && made < count; made++) {
        const kg_net_line *line = &contours[made];
        GEOSCoordSequence *seq = GEOSCoordSeq_create_r(geos, (unsigned)line->count + 1, 2);
        for (size_t i = 0; seq && i <= line->count; i++) {
            kg_vec2 p = line->points[i % line->count];
            GEOSCoordSeq_setXY_r(geos, seq, (unsigned)i, p.x, p.y);
        }
        rings[made] = seq ? GEOSGeom_createLinearRing_r(geos, seq) : NULL;
        if (!rings[made])
            break;
    }
    if (rings && made == count)
        polygon = GEOSGeom_createPolygon_r(geos, rings[0], rings + 1, (unsigned)count - 1);
    else
        while (made > 0)
            GEOSGeom_destroy_r(geos, rings[--made]);
    free(rings);
    return polygon;
}

bool kg_tab_contours_valid(GEOSContextHandle_t geos, const kg_net_line *contours, size_t count,
                           kg_vec2 *out_at) {
    GEOSGeometry *polygon = make_polygon(geos, contours, count), *where = NULL;
    char *reason = NULL;
    char valid = polygon ? GEOSisValidDetail_r(geos, polygon, 0, &reason, &where) : 0;
    if (where && valid != 1) {
        GEOSGeomGetX_r(geos, where, &out_at->x);
        GEOSGeomGetY_r(geos, where, &out_at->y);
    }
    if (reason)
        GEOSFree_r(geos, reason);
    if (where)
        GEOSGeom_destroy_r(geos, where);
    if (polygon)
        GEOSGeom_destroy_r(geos, polygon);
    return valid == 1;
}

kg_status kg_tab_ground_create(GEOSContextHandle_t geos, const kg_net_part *part,
                               kg_tab_ground *out) {
    kg_tab_ground ground = {.geos = geos};
    kg_net_line *contours = calloc(part->loop_count, sizeof *contours);
    ground.loops = calloc(part->loop_count, sizeof *ground.loops);
    kg_status status = contours && ground.loops ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < part->loop_count && status == KG_OK; i++) {
        contours[i] = part->loops[i].line;
        status = kg_tab_loop_create(&part->loops[i].line, i > 0, &ground.loops[i]);
        ground.loop_count += status == KG_OK;
    }
    if (status == KG_OK) {
        ground.polygon = make_polygon(geos, contours, part->loop_count);
        ground.prepared = ground.polygon ? GEOSPrepare_r(geos, ground.polygon) : NULL;
        status = ground.prepared ? KG_OK : KG_ERR_MEMORY;
    }
    free(contours);
    if (status != KG_OK)
        kg_tab_ground_destroy(&ground);
    else
        *out = ground;
    return status;
}

void kg_tab_ground_destroy(kg_tab_ground *ground) {
    for (size_t i = 0; i < ground->loop_count; i++)
        kg_tab_loop_destroy(&ground->loops[i]);
    if (ground->prepared)
        GEOSPreparedGeom_destroy_r(ground->geos, ground->prepared);
    if (ground->polygon)
        GEOSGeom_destroy_r(ground->geos, ground->polygon);
    free(ground->loops);
    *ground = (kg_tab_ground){0};
}

/* ---- one tab ---------------------------------------------------------------------------- */

double kg_tab_least(const kg_tab *tab, const kg_tab_options *options) {
    return fmin(fmax(options->least, LEAST_HEIGHT), 0.5 * tab->wanted);
}

void kg_tab_drop(kg_tab *tab, kg_tab_reason reason) {
    tab->height = 0;
    tab->reason = reason;
}

/* Angle by which the edge leaves the base's chord to the outside at one end. */
static double rise_at(const kg_tab_loop *loop, double from, double to, kg_vec2 chord, int end) {
    double near = fmin(0.5, (to - from) / 4);
    kg_vec2 leg = end == 0 ? kg_sub2(kg_tab_loop_at(loop, from + near), kg_tab_loop_at(loop, from))
                           : kg_sub2(kg_tab_loop_at(loop, to), kg_tab_loop_at(loop, to - near));
    double turn = atan2(kg_cross2(chord, leg), kg_dot2(chord, leg)) * -loop->outward;
    return end == 0 ? turn : -turn;
}

/*
 * Outline of a tab of the given height, or as near to it as its flanks allow.
 *
 * With flanks at angles a and b to the chord and height h, they take h (cot a + cot b) of it. Both
 * cotangents go from their greatest (45 degrees, or what the sector at the foot allows) towards
 * their least until that is FLANKS_SHARE of the base; then h gives way.
 */
static void shape(const kg_tab_loop *loop, kg_tab *tab, double height) {
    kg_vec2 a = kg_tab_loop_at(loop, tab->base[0]), b = kg_tab_loop_at(loop, tab->base[1]);
    kg_vec2 chord = kg_sub2(b, a);
    double length = kg_len2(chord), gentle[2], steep[2];
    if (!(length > 1e-3 * CLEARANCE)) {
        kg_tab_drop(tab, KG_TAB_SHORT);
        return;
    }
    kg_vec2 along = kg_scale2(chord, 1 / length);
    kg_vec2 out = kg_scale2(kg_v2(along.y, -along.x), loop->outward);
    for (int end = 0; end < 2; end++) {
        double gap = kg_tab_loop_gap(loop, tab->base[end]);
        double limit = SECTOR_SHARE * gap + rise_at(loop, tab->base[0], tab->base[1], along, end);
        if (!(limit > 0.02)) {
            kg_tab_drop(tab, KG_TAB_NO_ROOM);
            return;
        }
        gentle[end] = 1 / tan(fmin(FLANK_GENTLE, limit));
        steep[end] = 1 / tan(fmin(FLANK_STEEP, limit));
    }
    double room = FLANKS_SHARE * length, most = height * (gentle[0] + gentle[1]);
    double least = height * (steep[0] + steep[1]), mix = 0;
    if (least > room) {
        height *= room / least;
        mix = 1;
        if (tab->height > 0)
            tab->reason = KG_TAB_NO_ROOM;
    } else if (most > room) {
        mix = (most - room) / (most - least);
    }
    kg_vec2 top[2];
    for (int end = 0; end < 2; end++) {
        double cot = gentle[end] + mix * (steep[end] - gentle[end]), inset = height * cot, cut = 0;
        if (cot > 1 / tan(SLIVER))
            cut = inset - height / tan(SHORT_END);
        double sign = end == 0 ? 1 : -1;
        tab->foot[end] = tab->base[end] + sign * cut * (tab->base[1] - tab->base[0]) / length;
        kg_vec2 corner = end == 0 ? a : b;
        top[end] = kg_add2(corner, kg_add2(kg_scale2(along, sign * inset), kg_scale2(out, height)));
    }
    tab->height = height;
    tab->path[0] = kg_tab_loop_at(loop, tab->foot[0]);
    tab->path[1] = top[0];
    tab->path[2] = top[1];
    tab->path[3] = kg_tab_loop_at(loop, tab->foot[1]);
}

/* The foot of a flank, a little up towards its top. */
static kg_vec2 lifted(kg_vec2 foot, kg_vec2 top) {
    return kg_lerp2(foot, top, fmin(LIFT / kg_dist2(foot, top), 0.1));
}

void kg_tab_guard(const kg_tab *tab, kg_vec2 out[4]) {
    const kg_vec2 *p = tab->path;
    kg_vec2 top = kg_sub2(p[2], p[1]);
    double length = kg_len2(top), base = kg_dist2(p[0], p[3]);
    double clear = fmin(CLEARANCE, 0.15 * fmin(tab->height, base));
    kg_vec2 along = length > 0 ? kg_scale2(top, clear / length) : kg_v2(0, 0);
    /* The middle of the top lies straight out of the middle of the base, more or less. */
    kg_vec2 up = kg_sub2(kg_lerp2(p[1], p[2], 0.5), kg_lerp2(p[0], p[3], 0.5));
    double side = kg_cross2(along, up) >= 0 ? 1 : -1;
    kg_vec2 outward = kg_scale2(kg_v2(-along.y, along.x), side);
    out[1] = kg_add2(kg_sub2(p[1], along), outward);
    out[2] = kg_add2(kg_add2(p[2], along), outward);
    out[0] = lifted(p[0], out[1]);
    out[3] = lifted(p[3], out[2]);
}

static bool meets_part(const kg_tab_ground *ground, const kg_vec2 path[4]) {
    GEOSCoordSequence *seq = GEOSCoordSeq_copyFromBuffer_r(ground->geos, &path[0].x, 4, 0, 0);
    GEOSGeometry *line = seq ? GEOSGeom_createLineString_r(ground->geos, seq) : NULL;
    bool meets = !line || GEOSPreparedIntersects_r(ground->geos, ground->prepared, line) != 0;
    if (line)
        GEOSGeom_destroy_r(ground->geos, line);
    return meets;
}

/* Whether a tab runs into its part: its lifted outline meets paper, as it is (where its own edge
 * bulges out) or with its clearance (everywhere else). */
static bool runs_into_part(const kg_tab_ground *ground, const kg_tab *tab) {
    kg_vec2 wide[4], path[4] = {{0, 0}, tab->path[1], tab->path[2], {0, 0}};
    kg_tab_guard(tab, wide);
    path[0] = lifted(tab->path[0], path[1]);
    path[3] = lifted(tab->path[3], path[2]);
    return meets_part(ground, path) || meets_part(ground, wide);
}

void kg_tab_fit(const kg_tab_ground *ground, const kg_tab_options *options, kg_tab *tab,
                double height) {
    const kg_tab_loop *loop = &ground->loops[tab->loop];
    double least = kg_tab_least(tab, options);
    tab->height = height;
    shape(loop, tab, height);
    while (tab->height > 0 && tab->height >= least && runs_into_part(ground, tab)) {
        tab->reason = KG_TAB_NO_ROOM;
        shape(loop, tab, tab->height * STEP_DOWN);
    }
    if (!(tab->height > 0) || tab->height < least)
        kg_tab_drop(tab, tab->height > 0 ? KG_TAB_NO_ROOM : tab->reason);
}

kg_tab kg_tab_half(const kg_tab *tab, int half, double width) {
    kg_tab part = *tab;
    part.base[1 - half] = (tab->base[0] + tab->base[1]) / 2;
    part.wanted = fmin(width, SLENDER * (part.base[1] - part.base[0]));
    return part;
}

/* Adds a tab, or two halves of it where only one of them is in the way of something. */
static kg_status add(const kg_tab_ground *ground, const kg_tab_options *options, double width,
                     kg_tab tab, int splits, kg_tab_list *tabs) {
    kg_tab_fit(ground, options, &tab, tab.wanted);
    if (tab.height < SPLIT_BELOW * tab.wanted && splits < SPLITS_MAX &&
        tab.base[1] - tab.base[0] >= 2 * SPLIT_LEAST) {
        kg_status status =
            add(ground, options, width, kg_tab_half(&tab, 0, width), splits + 1, tabs);
        return status != KG_OK
                   ? status
                   : add(ground, options, width, kg_tab_half(&tab, 1, width), splits + 1, tabs);
    }
    return kg_push(tabs, tab) ? KG_OK : KG_ERR_MEMORY;
}

kg_status kg_tab_place(const kg_tab_ground *ground, const kg_net_join *join, int index, int side,
                       const double *bend, const kg_tab_options *options, kg_tab_list *tabs) {
    kg_net_side s = join->sides[side];
    kg_tab_edge edge = kg_tab_edge_of(&ground->loops[s.loop], s, bend);
    double width = join->tab_width > 0 ? join->tab_width : options->width, *ends;
    size_t count;
    kg_tab_limits limits = join->tab_shape == KG_TAB_TRAPEZOID ? TRAPEZOIDS : TEETH;
    if (join->tab_shape == KG_TAB_TEETH)
        limits.length = width;
    kg_status status = kg_tab_edge_divide(&edge, limits, &ends, &count);
    if (status != KG_OK)
        return status;
    for (size_t i = 0; i < count && status == KG_OK; i++) {
        double length = ends[i + 1] - ends[i];
        kg_tab tab = {.join = index,
                      .side = side,
                      .part = s.part,
                      .loop = s.loop,
                      .piece = i,
                      .base = {ends[i], ends[i + 1]},
                      .wanted = fmin(width, SLENDER * length),
                      .reason = KG_TAB_SHORT};
        status = add(ground, options, width, tab, 0, tabs);
    }
    free(ends);
    return status;
}
