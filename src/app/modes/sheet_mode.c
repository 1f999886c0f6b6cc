/* Folded sheets. */
#include "app/expect.h"
#include "app/modes/modes.h"
#include "app/modes/sheet_scene.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/tool.h"

static const char *context_menu(const kg_editor *e) {
    (void)e;
    return "view.frame_all";
}

static void toolbar(kg_app *app) {
    (void)app;
}

static void side(kg_app *app, kg_area area) {
    kg_ui_panel_begin("sheet", _("Fold"), area, 0);
    kg_ui_text(kg_document_title(app->editor.document));
    for (size_t i = 0; i < kg_document_issue_count(app->editor.document); i++)
        kg_ui_text_wrapped(kg_document_issue(app->editor.document, i)->message);
    kg_ui_panel_end();
}

static kg_status expect(const kg_editor *e, const char *words, kg_error *error) {
    (void)e;
    return kg_expect_unknown(words, error);
}

const kg_mode kg_sheet_mode = {
    .kind = KG_DOCUMENT_ORIGAMI,
    .title = N_("folded sheet"),
    .tool = &kg_tool_look,
    .create = kg_sheets_create,
    .destroy = kg_sheets_destroy,
    .follow = kg_sheets_follow,
    .tick = kg_sheets_tick,
    .box = kg_sheets_box,
    .compose = kg_sheet_scene_compose,
    .drop = kg_sheet_scene_drop,
    .menu = {N_("Fold"), "view.frame_all"},
    .context = context_menu,
    .toolbar = toolbar,
    .side = side,
    .expect = expect,
};
