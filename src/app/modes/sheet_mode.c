/* Folded sheets. */
#include "app/modes/modes.h"
#include "app/modes/sheet_expect.h"
#include "app/modes/sheet_scene.h"
#include "app/modes/sheet_thumbs.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/tool.h"

/* Of the height of the side, the part for sheets and steps. */
#define STEPS_SHARE 0.6

static bool tick(kg_editor *e, double seconds) {
    bool drawing = kg_sheet_thumbs_tick(kg_sheets_of(e));
    return kg_sheets_tick(e, seconds) || drawing;
}

static const char *context_menu(const kg_editor *e) {
    (void)e;
    return "step.play step.from_here fold.unfold fold.back - view.turn_over step.xray step.spread "
           "- sheet.add "
           "sheet.arrange sheet.duplicate sheet.remove - view.frame_all";
}

static void toolbar(kg_app *app) {
    kg_editor *e = &app->editor;
    const kg_sheets *s = kg_sheets_of(e);
    kg_panel_fold_buttons(e);
    kg_ui_separator();
    kg_panel_tool_button(e, "sheet.add", KG_ICON_ADD, false);
    kg_panel_tool_button(e, "sheet.arrange", KG_ICON_MOVE, e->tool == &kg_tool_sheets);
    kg_ui_separator();
    kg_panel_tool_button(e, "step.xray", KG_ICON_EYE, s->opacity < 1);
    kg_panel_tool_button(e, "step.spread", KG_ICON_COPY, s->spread > 0);
}

static void side(kg_app *app, kg_area area) {
    const kg_editor *e = &app->editor;
    bool folded = kg_origami_fold_count(kg_editor_origami(e)) > 0;
    double steps = floor(STEPS_SHARE * area.height);
    kg_ui_panel_begin("sheets", NULL, (kg_area){area.x, area.y, area.width, steps}, 0);
    /* two ids: what is of use then is open */
    if (kg_ui_section(folded ? _("Sheets##folded") : _("Sheets##flat"), !folded))
        kg_panel_sheets(app);
    if (kg_ui_section(_("Steps"), true))
        kg_panel_steps(app);
    kg_ui_panel_end();
    kg_panel_fold(app, (kg_area){area.x, area.y + steps, area.width, area.height - steps});
}

static void handles(kg_app *app) {
    kg_panel_fold_label(app);
    kg_panel_steps_bar(app);
}

const kg_mode kg_sheet_mode = {
    .kind = KG_DOCUMENT_ORIGAMI,
    .title = N_("folded sheet"),
    .tool = &kg_tool_fold,
    .create = kg_sheets_create,
    .destroy = kg_sheets_destroy,
    .follow = kg_sheets_follow,
    .tick = tick,
    .box = kg_sheets_box,
    .ground = kg_sheets_ground,
    .compose = kg_sheet_scene_compose,
    .drop = kg_sheet_scene_drop,
    .menu = {N_("Fold"),
             "fold.drag fold.axis fold.bisect fold.square fold.flip - fold.more_layers "
             "fold.fewer_layers fold.next_gap fold.make fold.back - fold.unfold step.from_here - "
             "step.play step.back step.forth step.first step.last - view.turn_over step.xray "
             "step.spread - "
             "sheet.add sheet.arrange sheet.duplicate sheet.remove sheet.raise sheet.lower"},
    .context = context_menu,
    .toolbar = toolbar,
    .side = side,
    .handles = handles,
    .expect = kg_sheet_expect,
};
