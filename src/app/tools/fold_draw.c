/* How the fold being made is shown: its crease, the moving part where it will be, what is in the
 * way. */
#include "app/scenery.h"
#include "app/tools/fold.h"

#include <stdlib.h>

enum { TRACK = 17 }; /* points of the way of a corner */

/* How far lines are drawn beyond the paper, over its size. */
#define BEYOND 0.1
/* The folded part is drawn clear of the layers below, in layers. */
#define CLEAR 1.5
/* Between stripes, over the size of the sheets. */
#define STRIPES 0.04

static const kg_color accent = {0.98F, 0.72F, 0.10F, 1}, moving = {0.20F, 0.55F, 0.95F, 1},
                      refused = {0.92F, 0.20F, 0.15F, 1}, guide = {0.10F, 0.72F, 0.55F, 1};

static kg_style line_style(kg_color color, float width) {
    kg_style s = kg_line_style(color, width);
    s.hidden = 0.55F;
    return s;
}

static void dash(kg_style *s, float on, float off, float dot) {
    s->dashes_px[0] = on, s->dashes_px[1] = off;
    s->dashes_px[2] = dot > 0 ? dot : on, s->dashes_px[3] = off;
}

/* A mountain is dashed with dots, a valley dashed, as in diagrams. */
static kg_style crease_style(const kg_fold_tool *t) {
    kg_style s = line_style(t->refused ? refused : accent, 3);
    if (t->angle_deg < 0)
        dash(&s, 10, 4, 2);
    else
        dash(&s, 8, 5, 0);
    return s;
}

/* ---- planes ------------------------------------------------------------------------------ */

/* How high the layers of the group are drawn, at most, above its plane on the side it folds to. */
static double stack_height(const kg_sheets *s, const kg_fold_tool *t, kg_vec3 up) {
    double most = 0;
    for (size_t h = 0; h < s->state->halves.count; h++) {
        int32_t loop = s->state->halves.items[h].loop;
        if (loop < 0 || s->state->loops.items[loop].group != t->group)
            continue;
        kg_vec3 p = s->state->vertices.items[s->state->halves.items[h].origin].position;
        most = fmax(most, kg_dot(kg_sub(s->drawn[h], p), up));
    }
    return most;
}

/* Convex polygons, seen from both sides: polygon i from starts[i] up to starts[i + 1]. */
static void draw_polygons(const kg_vec3 *p, const size_t *starts, size_t count, kg_color color,
                          kg_overlay *o) {
    kg_surface surface = {.vertex_count = starts[count]};
    uint32_t *triangles = malloc((3 * starts[count] + 1) * sizeof *triangles);
    kg_style style = kg_style_default(color);
    if (!triangles)
        return;
    for (size_t i = 0; i < count; i++)
        for (size_t k = starts[i] + 2; k < starts[i + 1]; k++) {
            uint32_t *t = triangles + 3 * surface.triangle_count++;
            t[0] = (uint32_t)starts[i];
            t[1] = (uint32_t)k - 1;
            t[2] = (uint32_t)k;
        }
    surface.positions = (kg_vec3 *)(uintptr_t)p; /* read only */
    surface.triangles = triangles;
    style.back = color;
    style.unlit = true;
    kg_overlay_surface(o, &surface, style);
    free(triangles);
}

/* Their outlines, of all or of those that `which` tells (NULL: all). */
static void draw_outlines(const kg_vec3 *p, const size_t *starts, size_t count, const bool *which,
                          kg_style style, kg_overlay *o) {
    kg_vec3 *points = malloc((starts[count] + count + 1) * sizeof *points);
    uint32_t *begins = malloc((count + 1) * sizeof *begins);
    kg_lines lines = {points, begins, 0};
    uint32_t n = 0;
    for (size_t i = 0; i < count && points && begins; i++) {
        if (which && !which[i])
            continue;
        begins[lines.line_count++] = n;
        for (size_t k = starts[i]; k < starts[i + 1]; k++)
            points[n++] = p[k];
        points[n++] = p[starts[i]];
    }
    if (lines.line_count > 0) {
        begins[lines.line_count] = n;
        kg_overlay_lines(o, &lines, style);
    }
    free(points);
    free(begins);
}

/* ---- the fold ---------------------------------------------------------------------------- */

/* How high a face is drawn above its plane. */
static double face_height(const kg_sheets *s, int32_t loop, kg_vec3 up) {
    int32_t h = s->state->loops.items[loop].first;
    return kg_dot(kg_sub(s->drawn[h], s->positions[s->state->halves.items[h].origin]), up);
}

/* Where the folded part is drawn: on all layers, or between the two chosen. */
static double landing_height(const kg_sheets *s, const kg_fold_tool *t, kg_vec3 up) {
    const int32_t *b = t->fold.between;
    if (b[0] >= 0 && !t->refused)
        return (face_height(s, b[0], up) + face_height(s, b[1], up)) / 2;
    return stack_height(s, t, up) + CLEAR * s->layer;
}

static void draw_parts(const kg_sheets *s, const kg_fold_tool *t, kg_overlay *o) {
    const kg_fold_preview *p = &t->preview;
    kg_vec3 up = kg_scale(p->normal, p->angle > 0 ? 1 : -1);
    bool flat = fabs(t->angle_deg) == 180;
    kg_vec3 above = kg_scale(up, stack_height(s, t, up) + CLEAR * s->layer),
            landing = kg_scale(up, landing_height(s, t, up));
    kg_color color = t->refused ? refused : moving;
    size_t count = p->part_count > 0 ? p->starts[p->part_count] : 0;
    kg_vec3 *points = malloc((count + 1) * sizeof *points);
    bool *lit = calloc(p->part_count + 1, sizeof *lit);
    if (count > 0 && points && lit) {
        for (size_t i = 0; i < p->part_count; i++)
            lit[i] = p->layers[p->loops[i]] == t->shown_layer;
        for (size_t i = 0; i < count; i++)
            points[i] = kg_add(p->points[i], above);
        draw_outlines(points, p->starts, p->part_count, NULL, line_style(color, 1.5F), o);
        if (t->shown_layer > 0)
            draw_outlines(points, p->starts, p->part_count, lit, line_style(accent, 3.5F), o);
        for (size_t i = 0; i < count; i++)
            points[i] = flat ? kg_add(kg_fold_preview_turn(p, p->points[i], 1), landing)
                             : kg_fold_preview_turn(p, kg_add(p->points[i], above), 1);
        draw_polygons(points, p->starts, p->part_count,
                      (kg_color){color.r, color.g, color.b, 0.38F}, o);
        draw_outlines(points, p->starts, p->part_count, NULL, line_style(color, 2), o);
    }
    free(points);
    free(lit);
}

static void draw_crease(const kg_sheets *s, const kg_fold_tool *t, kg_overlay *o) {
    const kg_fold_preview *p = &t->preview;
    kg_vec3 up = kg_scale(p->normal, p->angle > 0 ? 1 : -1);
    kg_vec3 lift = kg_scale(up, stack_height(s, t, up) + CLEAR * s->layer);
    double lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < 2 * p->crease_count; i++) {
        double along = kg_dot(kg_sub(p->creases[i], p->origin), p->axis);
        lo = fmin(lo, along), hi = fmax(hi, along);
    }
    /* the cuts of all layers lie on one line */
    kg_vec3 crease[2] = {kg_add(kg_madd(p->origin, lo, p->axis), lift),
                         kg_add(kg_madd(p->origin, hi, p->axis), lift)};
    if (lo < hi)
        kg_overlay_line(o, crease, 2, crease_style(t));
    else /* it folds at an edge that is there: the axis across the paper */
        lo = -s->state->size, hi = s->state->size;
    double more = BEYOND * s->state->size;
    kg_vec3 axis[2] = {kg_add(kg_madd(p->origin, lo - more, p->axis), lift),
                       kg_add(kg_madd(p->origin, hi + more, p->axis), lift)};
    kg_style thin = line_style(t->refused ? refused : accent, 1);
    dash(&thin, 2, 3, 0);
    kg_overlay_line(o, axis, 2, thin);
}

/* Stripes over a convex polygon, so that not the colour alone tells. */
static void draw_stripes(const kg_vec3 *p, size_t count, kg_vec3 normal, double spacing,
                         kg_style style, kg_overlay *o) {
    kg_vec3 u = kg_unit(kg_sub(p[1], p[0])), v = kg_cross(normal, u);
    kg_vec3 across = kg_unit(kg_add(u, v));
    double lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        lo = fmin(lo, kg_dot(p[i], across));
        hi = fmax(hi, kg_dot(p[i], across));
    }
    for (double at = spacing * ceil(lo / spacing); at < hi; at += spacing) {
        kg_vec3 ends[2];
        size_t found = 0;
        for (size_t i = 0; i < count && found < 2; i++) {
            kg_vec3 a = p[i], b = p[i + 1 < count ? i + 1 : 0];
            double x = kg_dot(a, across) - at, y = kg_dot(b, across) - at;
            if ((x < 0) != (y < 0))
                ends[found++] = kg_lerp(a, b, x / (x - y));
        }
        if (found == 2)
            kg_overlay_line(o, ends, 2, style);
    }
}

/* A face as it is drawn, a little nearer to the eye on either side. */
static void light_face(const kg_sheets *s, int32_t loop, kg_color color, bool striped,
                       kg_overlay *o) {
    const kg_origami_state *state = s->state;
    int32_t first = state->loops.items[loop].first, h = first;
    size_t count = 0;
    do
        count++;
    while ((h = state->halves.items[h].next) != first);
    kg_vec3 *points = malloc((count + 1) * sizeof *points);
    for (int side = -1; side <= 1 && points; side += 2) {
        size_t n = 0;
        do
            points[n++] = kg_madd(s->drawn[h], 0.3 * side * s->layer, s->normals[loop]);
        while ((h = state->halves.items[h].next) != first);
        draw_polygons(points, (const size_t[]){0, n}, 1,
                      (kg_color){color.r, color.g, color.b, 0.45F}, o);
        if (striped) {
            kg_style stripes = line_style((kg_color){0.1F, 0, 0, 0.8F}, 1.5F);
            stripes.hidden = 0;
            draw_stripes(points, n, s->normals[loop], STRIPES * state->size, stripes, o);
        }
        if (side > 0)
            draw_outlines(points, (const size_t[]){0, n}, 1, NULL, line_style(color, 2.5F), o);
    }
    free(points);
}

/* The way of a dragged corner through the air. */
static void draw_track(const kg_fold_tool *t, kg_overlay *o) {
    kg_vec3 from = t->fold.by_axis ? t->fold.vertex : t->fold.points[0], way[TRACK];
    for (int i = 0; i < TRACK; i++)
        way[i] = kg_fold_preview_turn(&t->preview, from, (double)i / (TRACK - 1));
    kg_style style = line_style(t->refused ? refused : moving, 1.2F), dot = style;
    style.hidden = 0.8F;
    dash(&style, 3, 3, 0);
    kg_overlay_line(o, way, TRACK, style);
    dot.size_px = 9;
    dot.hidden = 0.8F;
    kg_overlay_points(o, &way[TRACK - 1], 1, dot);
}

static void draw_fold(const kg_sheets *s, const kg_fold_tool *t, kg_overlay *o) {
    const kg_fold_preview *p = &t->preview;
    if (!p->has_axis)
        return;
    for (int i = 0; i < 2 && t->refused; i++)
        if (p->faces[i] >= 0)
            light_face(s, p->faces[i], refused, true, o);
    for (int i = 0; i < 2 && !t->refused; i++)
        if (t->fold.between[i] >= 0)
            light_face(s, t->fold.between[i], guide, false, o);
    draw_parts(s, t, o);
    draw_crease(s, t, o);
    draw_track(t, o);
}

/* ---- what is being chosen ---------------------------------------------------------------- */

static void draw_snap(const kg_fold_tool *t, kg_overlay *o) {
    static const float sizes[] = {7, 7, 7, 7, 11, 11, 11, 13};
    kg_style dot = line_style(t->snap.kind >= KG_SNAP_LINE ? guide : accent, sizes[t->snap.kind]);
    dot.hidden = 1;
    dot.square = t->snap.kind == KG_SNAP_MIDDLE || t->snap.kind == KG_SNAP_GRID;
    if (kg_dist(t->snap.guide[0], t->snap.guide[1]) > 0) {
        kg_style line = line_style(guide, 1.2F);
        dash(&line, 5, 3, 0);
        kg_overlay_line(o, t->snap.guide, 2, line);
    }
    kg_overlay_points(o, &t->snap.point, 1, dot);
}

static void draw_axis(const kg_sheets *s, kg_vec3 a, kg_vec3 b, kg_overlay *o) {
    kg_vec3 d = kg_sub(b, a);
    if (!(kg_len(d) > 0))
        return;
    double reach = s->state->size;
    kg_vec3 ends[2] = {kg_madd(a, -reach, kg_unit(d)), kg_madd(b, reach, kg_unit(d))};
    kg_style style = line_style(accent, 1.5F);
    style.hidden = 0.9F;
    dash(&style, 6, 4, 0);
    kg_overlay_line(o, ends, 2, style);
}

static void draw_choice(const kg_sheets *s, const kg_fold_tool *t, kg_overlay *o) {
    bool second = t->phase == KG_PHASE_SECOND;
    kg_style chosen = line_style(moving, 4);
    chosen.hidden = 1;
    if (second && t->way != KG_WAY_AXIS)
        kg_overlay_line(o, t->edge.ends, 2, chosen);
    if (second && t->way == KG_WAY_AXIS) {
        chosen.size_px = 11;
        kg_overlay_points(o, &t->first, 1, chosen);
        if (t->aimed)
            draw_axis(s, t->first, t->snap.point, o);
    }
    if ((second && t->way == KG_WAY_SQUARE && t->aimed) || (t->phase == KG_PHASE_SIDE && !t->given))
        draw_axis(s, t->axis[0], t->axis[1], o);
}

/* The layers at the vertex that a drag would take. */
static void draw_pile(const kg_sheets *s, const kg_fold_tool *t, kg_overlay *o) {
    for (size_t i = 0; i < s->state->loops.count; i++)
        if (t->pile[i] > 0 && (t->shown_layer > 0 ? t->pile[i] == t->shown_layer
                                                  : t->layers > 1 && t->pile[i] <= t->layers))
            light_face(s, (int32_t)i, moving, false, o);
}

void kg_fold_draw(const kg_editor *e, kg_overlay *o) {
    const kg_fold_tool *t = kg_fold_tool_seen(e);
    const kg_sheets *s = kg_sheets_of(e);
    if (!t || !s->state || !kg_sheets_can_fold(e))
        return;
    if (t->phase == KG_PHASE_READY && t->vertex >= 0 && t->pile && t->pile_count > 0)
        draw_pile(s, t, o);
    draw_choice(s, t, o);
    if (t->given)
        draw_fold(s, t, o);
    if (t->aimed && t->phase != KG_PHASE_SIDE && t->phase != KG_PHASE_HELD)
        draw_snap(t, o);
}
