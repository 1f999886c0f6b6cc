/* Patch models: sculpting developable patches over a reference. */
#include "app/commands/commands.h"
#include "app/modes/modes.h"
#include "app/modes/patch_expect.h"
#include "app/modes/patch_scene.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/box.h"
#include "app/tools/drag.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool.h"

/* The list of patches is as high as they need, of the side at most this share. */
#define OUTLINER_SHARE 0.38
enum { LEAST_ROWS = 4, ROW_HEIGHT = 28, TITLE_HEIGHT = 48 }; /* heights: layout units */

/* Drops what the model no longer has. */
static void prune_selection(kg_editor *e) {
    const kg_model *m = kg_editor_model(e);
    for (size_t i = e->selection.patches.count; i-- > 0;)
        if (!kg_model_find(m, e->selection.patches.items[i]))
            kg_editor_select(e, e->selection.patches.items[i], true);
    size_t kept = 0;
    for (size_t i = 0; i < e->selection.points.count; i++) {
        kg_point_ref r = e->selection.points.items[i];
        const kg_model_patch *p = kg_model_find(m, r.patch);
        if (p && r.index < p->input.point_count)
            e->selection.points.items[kept++] = r;
    }
    e->selection.points.count = kept;
    if (!kg_model_find(m, e->hover_point.patch))
        e->hover_point.patch = 0;
    if (!kg_model_find(m, e->hover_patch))
        e->hover_patch = 0;
}

/* Brings what is kept beside the solution up to it. */
static void follow(kg_editor *e) {
    if (kg_surfaces_update(&e->surfaces, kg_editor_solution(e)))
        kg_editor_say(e, KG_FAULT, "%s", _("Out of memory: some patches are not shown."));
    prune_selection(e);
}

static void add_patch_box(const kg_editor *e, const kg_model_patch *p, kg_box3 *box) {
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), p->id);
    bool any = false;
    for (size_t i = 0; s && i < s->regions.count; i++)
        for (size_t k = 0; k < s->regions.items[i].loops[0].point_count; k++, any = true)
            kg_box3_add(box, s->regions.items[i].loops[0].points[k].x);
    for (size_t i = 0; !any && i < p->input.point_count; i++)
        kg_box3_add(box, p->input.points[i]);
}

static kg_box3 box_of(const kg_editor *e, bool selection) {
    const kg_model *m = kg_editor_model(e);
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < m->patch_count; i++)
        if (!m->patches[i].hidden && (!selection || kg_editor_is_selected(e, m->patches[i].id)))
            add_patch_box(e, &m->patches[i], &box);
    if (!selection && e->backdrop.mesh && m->reference.visible) {
        kg_box3 b = kg_mesh_bounds(e->backdrop.mesh);
        kg_box3_add(&box, b.lo);
        kg_box3_add(&box, b.hi);
    }
    return box;
}

/* ---- panels ------------------------------------------------------------------------------ */

static const char *context_menu(const kg_editor *e) {
    return kg_has_selection(e)
               ? "patch.move patch.rotate patch.scale - trim.by trim.inside trim.contour "
                 "patch.refit - patch.flip patch.mirror patch.duplicate patch.construction "
                 "patch.rename - patch.hide patch.isolate view.frame_selection - patch.delete"
               : "patch.add select.all patch.show_all view.frame_all reference.toggle";
}

static void toolbar(kg_app *app) {
    kg_editor *e = &app->editor;
    bool selecting = e->tool == &kg_tool_select;
    if (kg_ui_icon_button("tool.points", KG_ICON_SELECT, selecting && e->level == KG_LEVEL_POINTS,
                          32)) {
        kg_editor_use_default(e);
        e->level = KG_LEVEL_POINTS;
    }
    kg_ui_tooltip(_("Points  Tab\nSelect patches and drag their control points."));
    if (kg_ui_icon_button("tool.patches", KG_ICON_SCALE, selecting && e->level == KG_LEVEL_PATCHES,
                          32)) {
        kg_editor_use_default(e);
        e->level = KG_LEVEL_PATCHES;
    }
    kg_ui_tooltip(_("Patches  Tab\nSelect patches and move them whole."));
    kg_ui_separator();
    kg_panel_tool_button(e, "patch.add", KG_ICON_PLACE, e->tool == &kg_tool_place);
    kg_panel_tool_button(e, "patch.move", KG_ICON_MOVE, false);
    kg_panel_tool_button(e, "patch.rotate", KG_ICON_ROTATE, false);
    kg_ui_separator();
    kg_panel_tool_button(e, "trim.by", KG_ICON_TRIM,
                         e->tool == &kg_tool_cutter || e->tool == &kg_tool_pieces);
    kg_panel_tool_button(e, "trim.contour", KG_ICON_CONTOUR, e->tool == &kg_tool_contour);
    kg_panel_tool_button(e, "patch.mirror", KG_ICON_MIRROR, false);
    kg_panel_tool_button(e, "patch.flip", KG_ICON_FLIP, false);
}

static void side(kg_app *app, kg_area area) {
    size_t count = kg_editor_model(&app->editor)->patch_count;
    double rows = count < LEAST_ROWS ? LEAST_ROWS : (double)count;
    double list = floor(fmin((TITLE_HEIGHT + rows * ROW_HEIGHT) * app->editor.pane.scale,
                             OUTLINER_SHARE * area.height));
    kg_panel_outliner(app, (kg_area){area.x, area.y, area.width, list});
    kg_panel_properties(app, (kg_area){area.x, area.y + list, area.width, area.height - list});
}

static void handles(kg_app *app) {
    const kg_editor *e = &app->editor;
    kg_vec2 from;
    kg_gizmo_draw(e);
    if (!kg_select_box_now(e, &from))
        return;
    kg_area box = {fmin(from.x, e->pointer.x), fmin(from.y, e->pointer.y),
                   fabs(e->pointer.x - from.x), fabs(e->pointer.y - from.y)};
    /* taking what it touches, the box is green, and its frame thinner for eyes that see no green */
    bool touches = kg_box_touches(from, e->pointer);
    kg_ui_canvas_rect(
        box, touches ? (kg_color){0.3F, 0.85F, 0.5F, 0.12F} : (kg_color){0.3F, 0.6F, 0.95F, 0.15F},
        0);
    kg_ui_canvas_frame(
        box, touches ? (kg_color){0.4F, 0.9F, 0.6F, 0.9F} : (kg_color){0.4F, 0.7F, 1, 0.9F},
        (touches ? 1 : 2) * e->pane.scale, 0);
}

const kg_mode kg_patch_mode = {
    .kind = KG_DOCUMENT_PATCHES,
    .title = N_("patch model"),
    .tool = &kg_tool_select,
    .follow = follow,
    .box = box_of,
    .compose = kg_patch_scene_compose,
    .drop = kg_patch_scene_drop,
    .menu = {N_("Patch"), "patch.add - patch.move patch.rotate patch.scale - trim.by trim.inside "
                          "trim.contour - patch.refit patch.planarize patch.equalise patch.split "
                          "patch.narrow - patch.flip "
                          "patch.construction patch.rename - patch.hide patch.isolate "
                          "patch.show_all"},
    .context = context_menu,
    .toolbar = toolbar,
    .side = side,
    .handles = handles,
    .expect = kg_patch_expect,
};
