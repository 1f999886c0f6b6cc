/* The menu bar and the tool bar: commands of the table, in groups. */
#include "app/commands/commands.h"
#include "app/mode.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>
#include <string.h>

/* A command as a menu item. */
static void item(kg_editor *e, const char *id, bool checked) {
    const kg_app_command *c = kg_command_find(id);
    char keys[32];
    kg_command_shortcut(c, e->settings.navigation, keys);
    if (kg_ui_menu_item(_(c->title), keys, checked, kg_command_is_enabled(c, e)))
        kg_command_do(e, id);
    kg_ui_tooltip(_(c->help));
}

/* The ids that are for the document's kind; "-" is a line between. */
static void items(kg_editor *e, const char *ids) {
    bool any = false, line = false;
    char id[64];
    for (size_t n; *ids; ids += n, ids += *ids == ' ') {
        n = strcspn(ids, " ");
        snprintf(id, sizeof id, "%.*s", (int)n, ids);
        line = line || strcmp(id, "-") == 0;
        const kg_app_command *c = kg_command_find(id);
        if (!c || !kg_command_is_for(c, kg_document_get_kind(e->document)))
            continue;
        if (any && line)
            kg_ui_separator();
        item(e, id, false);
        any = true;
        line = false;
    }
}

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
    const kg_steps *undo = &e->history.undo;
    item(e, "edit.undo", false);
    item(e, "edit.redo", false);
    if (undo->count > 0) {
        char text[128];
        snprintf(text, sizeof text, "  %s: %s", _("last step"),
                 _(undo->items[undo->count - 1].label));
        kg_ui_menu_item(text, "", false, false);
    }
}

double kg_panel_menu(kg_app *app) {
    static const char start[] =
        "file.new file.new_card file.new_sheets file.card_from_mesh - file.open";
    static const char file[] = "file.save file.save_as - reference.set - file.export_net "
                               "file.export_mesh file.export_guide - "
                               "file.quit";
    static const char edit[] =
        "select.all select.none select.level - patch.duplicate patch.mirror patch.delete "
        "- edit.settings";
    static const char views[] =
        "view.front view.back view.right view.left view.top view.bottom view.oblique";
    static const char frames[] = "view.frame_selection view.frame_all";
    static const char help[] = "edit.palette edit.help";
    kg_editor *e = &app->editor;
    const kg_model *m = kg_editor_model(e);
    if (!kg_ui_menu_bar_begin())
        return 0;
    if (kg_ui_menu_begin(_("File"))) {
        items(e, start);
        recent_files(app);
        kg_ui_separator();
        items(e, file);
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("Edit"))) {
        history_items(e);
        kg_ui_separator();
        items(e, edit);
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_(e->mode->menu.title))) {
        items(e, e->mode->menu.ids);
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("View"))) {
        items(e, views);
        kg_ui_separator();
        item(e, "view.ortho", e->pane.camera.ortho);
        kg_ui_separator();
        items(e, frames);
        kg_ui_separator();
        if (m)
            item(e, "reference.toggle", m->reference.file && m->reference.visible);
        item(e, "view.net", e->settings.net_view);
        kg_ui_menu_end();
    }
    if (kg_ui_menu_begin(_("Help"))) {
        items(e, help);
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
    items(e, e->mode->context(e));
    kg_ui_popup_end();
}

/* ---- tool bar ---------------------------------------------------------------------------- */

void kg_panel_tool_button(kg_editor *e, const char *id, kg_icon icon, bool on) {
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
    kg_ui_panel_begin("tools", NULL, area, KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL);
    app->editor.mode->toolbar(app);
    kg_ui_panel_end();
}
