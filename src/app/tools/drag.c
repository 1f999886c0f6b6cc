#include "app/tools/drag.h"

#include "app/text.h"

enum { HANDLE_DISTANCE = 9, BAND_SAMPLES = 97 };

/* Of the movement of the pointer, with Shift. */
#define FINE 0.1

/* The legal band is drawn this many times as far out as the patch itself reaches. */
#define BAND_REACH 3

#define FARTHEST 1e6

double kg_round_to_step(const kg_editor *e, double x) {
    return e->settings.step > 0 ? round(x / e->settings.step) * e->settings.step : x;
}

/* Takes a movement of the pointer in: with Shift, a tenth of it. Nothing jumps when Shift comes or
 * goes. */
static void follow(kg_vec2 *aim, kg_vec2 *last, kg_vec2 px, unsigned mods) {
    *aim = kg_add2(*aim, kg_scale2(kg_sub2(px, *last), mods & KG_MOD_SHIFT ? FINE : 1));
    *last = px;
}

/* ---- points ----------------------------------------------------------------------------- */

kg_status kg_point_drag_start(kg_point_drag *d, kg_editor *e, kg_point_ref held, kg_vec2 px,
                              kg_error *error) {
    kg_status status = kg_editor_begin(e, N_("Move point"), error);
    if (status)
        return status;
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), held.patch);
    kg_mesh_hit hit;
    *d = (kg_point_drag){.held = held, .start = p->input.points[held.index], .axis = -1};
    d->pressed = d->aim = d->last = px;
    if (e->backdrop.query && kg_editor_model(e)->reference.visible &&
        kg_mesh_query_closest(e->backdrop.query, d->start, &hit)) {
        d->on_surface = kg_len(hit.normal) > 0;
        d->foot = hit.point;
        d->lift = kg_dot(kg_sub(d->start, hit.point), hit.normal);
    }
    return KG_OK;
}

/* Where the held point goes when the pointer is at `px`. The ray aims at the foot of the point on
 * the reference, moved as the pointer moved, so that nothing jumps when the drag begins. */
static bool slide(const kg_point_drag *d, const kg_editor *e, kg_vec2 px, kg_vec3 *out) {
    kg_vec2 foot;
    kg_vec3 origin, direction;
    kg_mesh_hit hit;
    if (!d->on_surface || !kg_pane_project(&e->pane, d->foot, &foot))
        return false;
    kg_pane_ray(&e->pane, kg_add2(foot, kg_sub2(px, d->pressed)), &origin, &direction);
    if (!kg_mesh_query_ray(e->backdrop.query, origin, direction, &hit) || !(kg_len(hit.normal) > 0))
        return false;
    *out = kg_madd(hit.point, d->lift, hit.normal);
    return true;
}

static kg_vec3 along_axis(const kg_point_drag *d, const kg_editor *e, kg_vec2 px) {
    kg_vec3 axis = kg_v3(d->axis == 0, d->axis == 1, d->axis == 2);
    double from, to;
    return kg_pane_along_axis(&e->pane, d->pressed, d->start, axis, &from) &&
                   kg_pane_along_axis(&e->pane, px, d->start, axis, &to)
               ? kg_madd(d->start, to - from, axis)
               : d->start;
}

static kg_vec3 rounded(const kg_editor *e, kg_vec3 by) {
    return kg_v3(kg_round_to_step(e, by.x), kg_round_to_step(e, by.y), kg_round_to_step(e, by.z));
}

void kg_point_drag_move(kg_point_drag *d, kg_editor *e, kg_vec2 px, unsigned mods) {
    kg_model *m = kg_editor_model(e);
    kg_vec3 to;
    follow(&d->aim, &d->last, px, mods);
    d->mods = mods;
    if (d->axis >= 0) {
        to = along_axis(d, e, d->aim);
    } else if (mods & KG_MOD_ALT || !slide(d, e, d->aim, &to)) {
        kg_vec3 a = kg_pane_on_screen_plane(&e->pane, d->pressed, d->start);
        to = kg_add(d->start, kg_sub(kg_pane_on_screen_plane(&e->pane, d->aim, d->start), a));
    }
    kg_vec3 by = kg_sub(to, d->start);
    if (!e->before) /* something else ended the step */
        return;
    if (mods & KG_MOD_CTRL)
        by = rounded(e, by);
    if (!isfinite(kg_len(by)))
        return;
    for (size_t i = 0; i < e->selection.points.count; i++) {
        kg_point_ref r = e->selection.points.items[i];
        kg_model_patch *p = kg_model_find(m, r.patch);
        const kg_model_patch *before = kg_model_find(kg_document_model(e->before), r.patch);
        if (!p || !before)
            continue;
        kg_vec3 moved = kg_add(before->input.points[r.index], by);
        if (fabs(moved.x) <= FARTHEST && fabs(moved.y) <= FARTHEST && fabs(moved.z) <= FARTHEST)
            p->input.points[r.index] = moved;
    }
    kg_editor_touch(e);
}

void kg_point_drag_lock(kg_point_drag *d, kg_editor *e, int axis) {
    d->axis = d->axis == axis ? -1 : axis;
    kg_point_drag_move(d, e, e->pointer, d->mods);
}

void kg_axis_draw(const kg_editor *e, kg_vec3 through, int axis, kg_overlay *overlay) {
    static const kg_color colors[] = {
        {0.84F, 0.30F, 0.28F, 1}, {0.35F, 0.66F, 0.30F, 1}, {0.28F, 0.52F, 0.88F, 1}};
    kg_vec3 along = kg_v3(axis == 0, axis == 1, axis == 2);
    double far = 20 * e->pane.camera.distance;
    kg_vec3 line[2] = {kg_madd(through, -far, along), kg_madd(through, far, along)};
    kg_style style = kg_style_default(colors[axis]);
    style.hidden = 0.5F;
    kg_overlay_line(overlay, line, 2, style);
}

/* ---- extents ---------------------------------------------------------------------------- */

/* The patch whose handles are shown: the only one that is selected. */
static const kg_solved_patch *with_handles(const kg_editor *e) {
    if (e->selection.patches.count != 1)
        return NULL;
    int64_t id = e->selection.patches.items[0];
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), id);
    return p && s && !p->hidden && s->prepared ? s : NULL;
}

static int handle_under(const kg_editor *e, kg_vec2 px) {
    const kg_solved_patch *s = with_handles(e);
    for (int side = 0; s && side < 2; side++) {
        kg_vec2 at;
        if (kg_pane_project(&e->pane, kg_patch_point(&s->patch, s->patch.extent[side], 0.5), &at) &&
            kg_dist2(at, px) < HANDLE_DISTANCE * e->pane.scale)
            return side;
    }
    return -1;
}

void kg_extent_drag_hover(kg_editor *e, kg_vec2 px) {
    if (!e->hover_point.patch && handle_under(e, px) >= 0)
        e->hover_patch = 0;
}

bool kg_extent_is_hovered(const kg_editor *e) {
    return !e->hover_point.patch && handle_under(e, e->pointer) >= 0;
}

bool kg_extent_drag_start(kg_extent_drag *d, kg_editor *e, kg_vec2 px) {
    const kg_solved_patch *s = with_handles(e);
    int side = e->hover_point.patch ? -1 : handle_under(e, px);
    kg_vec2 a, b;
    if (side < 0)
        return false;
    kg_vec3 edge = kg_patch_point(&s->patch, s->patch.extent[side], 0.5);
    if (!kg_pane_project(&e->pane, edge, &a) ||
        !kg_pane_project(&e->pane, kg_add(edge, kg_patch_ruling(&s->patch, 0.5).d), &b) ||
        kg_editor_begin(e, N_("Extent"), NULL))
        return false;
    *d = (kg_extent_drag){s->id, side, px, px, px, s->patch.extent[side], kg_sub2(b, a)};
    return true;
}

void kg_extent_drag_move(kg_extent_drag *d, kg_editor *e, kg_vec2 px, unsigned mods) {
    kg_model_patch *p = kg_model_find(kg_editor_model(e), d->patch);
    double square = kg_dot2(d->along, d->along);
    if (!p || square < 1e-6) /* the ruling is seen end-on */
        return;
    follow(&d->aim, &d->last, px, mods);
    double to = d->start + kg_dot2(kg_sub2(d->aim, d->pressed), d->along) / square;
    if (mods & KG_MOD_CTRL)
        to = kg_round_to_step(e, to);
    double other = p->input.extent[1 - d->side], least = 0.01;
    if (fabs(to) > FARTHEST)
        return;
    p->input.extent[d->side] = d->side == 0 ? fmin(to, other - least) : fmax(to, other + least);
    kg_editor_touch(e);
}

/* The middle ruling up to the handles, which otherwise float beside what trims have left. */
static void draw_stem(const kg_patch *patch, kg_overlay *overlay) {
    const kg_vec3 ends[] = {kg_patch_point(patch, patch->extent[0], 0.5),
                            kg_patch_point(patch, patch->extent[1], 0.5)};
    kg_style style = kg_style_default((kg_color){0.95F, 0.6F, 0.2F, 1});
    style.size_px = 1;
    style.dashes_px[0] = style.dashes_px[2] = 4;
    style.dashes_px[1] = style.dashes_px[3] = 4;
    style.hidden = 0.3F;
    kg_overlay_line(overlay, ends, 2, style);
}

void kg_extent_drag_draw(const kg_editor *e, kg_overlay *overlay) {
    const kg_solved_patch *s = with_handles(e);
    int hovered = s ? handle_under(e, e->pointer) : -1;
    if (s)
        draw_stem(&s->patch, overlay);
    for (int side = 0; s && side < 2; side++) {
        kg_vec3 at = kg_patch_point(&s->patch, s->patch.extent[side], 0.5);
        kg_style style = kg_style_default(side == hovered ? (kg_color){1, 0.82F, 0.1F, 1}
                                                          : (kg_color){0.95F, 0.6F, 0.2F, 1});
        style.size_px = side == hovered ? 11 : 8;
        style.hidden = 0.7F;
        kg_overlay_points(overlay, &at, 1, style);
    }
}

/* ---- the legal band --------------------------------------------------------------------- */

static void draw_band(const kg_patch *patch, int side, kg_overlay *overlay) {
    kg_vec3 run[BAND_SAMPLES];
    size_t count = 0;
    double reach = BAND_REACH * fmax(fabs(patch->wished_extent[0]), fabs(patch->wished_extent[1]));
    kg_style style = kg_style_default((kg_color){0.95F, 0.25F, 0.55F, 1});
    style.size_px = 2.5F;
    style.dashes_px[0] = 3, style.dashes_px[1] = 3;
    style.dashes_px[2] = 3, style.dashes_px[3] = 3;
    style.hidden = 0.4F;
    for (int i = 0; i <= BAND_SAMPLES; i++) {
        double v = (double)i / (BAND_SAMPLES - 1), bounds[2] = {0, 0};
        if (i < BAND_SAMPLES)
            kg_patch_regression(patch, v, &bounds[0], &bounds[1]);
        bool near = i < BAND_SAMPLES && fabs(bounds[side]) <= reach;
        if (near)
            run[count++] = kg_patch_point(patch, bounds[side], v);
        if (near)
            continue;
        kg_overlay_line(overlay, run, count, style);
        count = 0;
    }
}

void kg_legal_band_draw(const kg_editor *e, kg_overlay *overlay) {
    for (size_t i = 0; i < e->selection.patches.count; i++) {
        const kg_solved_patch *s =
            kg_solution_find(kg_editor_solution(e), e->selection.patches.items[i]);
        for (int side = 0; s && s->prepared && side < 2; side++)
            draw_band(&s->patch, side, overlay);
    }
}
