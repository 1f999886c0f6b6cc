/* The menu bar and the tool bar: commands of the table, in groups. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/tool.h"

#include <stdio.h>
#include <string.h>

/* A command as a menu item; NULL is a line between. */
static void item(kg_editor *e, const char *id, bool checked) {
    const kg_app_command *c = id ? kg_command_find(id) : NULL;
    char keys[32];
    if (!c) {
        kg_ui_separator();
        return;
    }
    kg_command_shortcut(c, e->settings.navigation, keys);
    if (kg_ui_menu_item(_(c->title), keys, checked, kg_command_is_enabled(c, e)))
        kg_command_do(e, id);
    kg_ui_tooltip(_(c->help));
}

static void items(kg_editor *e, const char *const *ids, size_t count) {
    for (size_t i = 0; i < count; i++)
        item(e, ids[i], false);
}
#define ITEMS(e, ...)                                                                              \
    items((e), (const char *const[]){__VA_ARGS__},                                                 \
          sizeof(const char *const[]){__VA_ARGS__} / sizeof(const char *))

static void recent_files(kg_app *app) {
    kg_settings *s = &app->editor.settings;
    if (!kg_ui_menu_begin(_("Open recent")))
        return;
    for (int i = 0; i < KG_RECENT_COUNT && s->recent[i]; i++)
        if (kg_ui_menu_item(s->recent[i], "", false, true)) {
            kg_app_open(app, s->recent[i]);
            break;
        }
    if (!s->recent[0])
        kg_ui_menu_item(_("(none yet)"), "", false, false);
    kg_ui_menu_end();
}

static void history_items(kg_editor *e) {
    const kg_steps *undo = &e->history.undo, *redo = &e->history.redo;
    item(e, "edit.undo", false);
    item(e, "edit.redo", false);
    if (undo->count > 0) {
        char text[128];
        snprintf(text, sizeof text, "  %s: %s", _("last step"),
                 _(undo->items[undo->count - 1].label));
        kg_ui_menu_item(text, "", false, false);
    }
    (void)redo;
}

double kg_panel_menu(kg_app *app) {
    kg_editor *e = &app->editor;
    const kg_reference *ref = &kg_editor_model(e)->reference;
    if (!kg_ui_menu_bar_begin())
        return 0;
    if (kg_ui_menu_begin(_("File"))) {
        ITEMS(e, "file.new", "file.open");
        recent_files(app);
        ITEMS(e, NULL, "file.save", "file.save_as", NULL, "reference.set", NULL, "file.export_net",
              "file.export_mesh", NULL, "file.quit");
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("Edit"))) {
        history_items(e);
        ITEMS(e, NULL, "select.all", "select.none", "select.level", NULL, "patch.duplicate",
              "patch.mirror", "patch.delete", NULL, "edit.settings");
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("Patch"))) {
        ITEMS(e, "patch.add", NULL, "patch.move", "patch.rotate", "patch.scale", NULL, "trim.by",
              "trim.inside", "trim.contour", NULL, "patch.refit", "patch.planarize", "patch.narrow",
              NULL, "patch.flip", "patch.construction", "patch.rename", NULL, "patch.hide",
              "patch.isolate", "patch.show_all");
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("View"))) {
        ITEMS(e, "view.front", "view.back", "view.right", "view.left", "view.top", "view.bottom",
              "view.oblique", NULL);
        item(e, "view.ortho", e->pane.camera.ortho);
        ITEMS(e, NULL, "view.frame_selection", "view.frame_all", NULL);
        item(e, "reference.toggle", ref->file && ref->visible);
        item(e, "view.net", e->settings.net_view);
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("Help"))) {
        ITEMS(e, "edit.palette", "edit.help");
        kg_ui_menu_end();
    }
    return kg_ui_menu_bar_end();
}

void kg_panel_context_menu(kg_app *app) {
    kg_editor *e = &app->editor;
    if (app->dialogs.open_menu)
        kg_ui_popup_open("context");
    app->dialogs.open_menu = false;
    if (!kg_ui_popup_begin("context"))
        return;
    if (kg_has_selection(e))
        ITEMS(e, "patch.move", "patch.rotate", "patch.scale", NULL, "trim.by", "trim.inside",
              "trim.contour", "patch.refit", NULL, "patch.flip", "patch.mirror", "patch.duplicate",
              "patch.construction", "patch.rename", NULL, "patch.hide", "patch.isolate",
              "view.frame_selection", NULL, "patch.delete");
    else
        ITEMS(e, "patch.add", "select.all", "patch.show_all", "view.frame_all", "reference.toggle");
    kg_ui_popup_end();
}

/* ---- tool bar ---------------------------------------------------------------------------- */

static void tool_button(kg_editor *e, const char *id, kg_icon icon, bool on) {
    const kg_app_command *c = kg_command_find(id);
    char keys[32], tip[256];
    bool enabled = kg_command_is_enabled(c, e);
    kg_ui_disabled_begin(!enabled);
    if (kg_ui_icon_button(id, icon, on, 32))
        kg_command_do(e, id);
    kg_ui_disabled_end();
    kg_command_shortcut(c, e->settings.navigation, keys);
    snprintf(tip, sizeof tip, "%s  %s\n%s", _(c->title), keys, _(c->help));
    kg_ui_tooltip(tip);
}

void kg_panel_toolbar(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    bool selecting = e->tool == &kg_tool_select;
    kg_ui_panel_begin("tools", NULL, area, KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL);
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
    tool_button(e, "patch.add", KG_ICON_PLACE, e->tool == &kg_tool_place);
    tool_button(e, "patch.move", KG_ICON_MOVE, false);
    tool_button(e, "patch.rotate", KG_ICON_ROTATE, false);
    kg_ui_separator();
    tool_button(e, "trim.by", KG_ICON_TRIM, e->tool == &kg_tool_pieces);
    tool_button(e, "trim.contour", KG_ICON_CONTOUR, e->tool == &kg_tool_contour);
    tool_button(e, "patch.mirror", KG_ICON_MIRROR, false);
    tool_button(e, "patch.flip", KG_ICON_FLIP, false);
    kg_ui_panel_end();
}
