/* Questions and error messages, and what goes on after them. */
#include "app/commands/commands.h"
#include "app/export.h"
#include "app/panels/panels.h"
#include "app/recovery.h"
#include "app/text.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void kg_dialogs_fail(kg_app *app, const kg_error *error) {
    snprintf(app->dialogs.error, sizeof app->dialogs.error, "%s", error->message);
    app->dialogs.open_error = true;
}

/* ---- going on ---------------------------------------------------------------------------- */

static void write_settings(kg_app *app) {
    kg_error error;
    if (kg_settings_write(&app->editor.settings, &error))
        kg_editor_say(&app->editor, KG_WARNING, "%s", error.message);
}

void kg_dialogs_remember(kg_app *app) {
    char whole[KG_PATH_SIZE], folder[KG_PATH_SIZE / 2];
    const char *path = app->editor.path;
    int n = !path || path[0] == '/'         ? 0
            : getcwd(folder, sizeof folder) ? snprintf(whole, sizeof whole, "%s/%s", folder, path)
                                            : -1;
    if (!path || n < 0 || n >= KG_PATH_SIZE)
        return;
    kg_settings_add_recent(&app->editor.settings, n > 0 ? whole : path);
    write_settings(app);
}

static void go_on(kg_app *app, kg_purpose purpose) {
    kg_error error;
    switch (purpose) {
    case KG_FOR_NEW:
        if (kg_editor_new(&app->editor, &error))
            kg_dialogs_fail(app, &error);
        app->framed = false;
        break;
    case KG_FOR_NEW_CARD:
        app->dialogs.open_new_card = true;
        break;
    case KG_FOR_NEW_SHEETS:
        app->dialogs.open_new_sheets = true;
        break;
    case KG_FOR_CONVERSION:
        kg_dialogs_browse(app, KG_FOR_CARD_OF_MESH);
        break;
    case KG_FOR_CARD_OF_PATH:
        kg_conversion_ask(app, app->dialogs.path);
        break;
    case KG_FOR_OPEN:
        kg_dialogs_browse(app, KG_FOR_OPEN);
        break;
    case KG_FOR_OPEN_PATH:
        kg_loading_open(app, app->dialogs.path);
        break;
    case KG_FOR_QUIT:
        kg_recovery_forget(app);
        write_settings(app);
        app->quit = true;
        break;
    default:
        break;
    }
}

void kg_dialogs_go_on(kg_app *app, kg_purpose purpose) {
    app->dialogs.after_unsaved = purpose;
    if (kg_editor_is_modified(&app->editor))
        app->dialogs.open_unsaved = true;
    else
        go_on(app, purpose);
}

void kg_dialogs_use_file(kg_app *app, kg_purpose purpose, const char *path) {
    kg_error error;
    kg_status status = KG_OK;
    switch (purpose) {
    case KG_FOR_OPEN:
        snprintf(app->dialogs.path, sizeof app->dialogs.path, "%s", path);
        app->dialogs.open_mesh = kg_dialogs_is_mesh(path);
        if (!app->dialogs.open_mesh)
            go_on(app, KG_FOR_OPEN_PATH);
        return;
    case KG_FOR_CARD_OF_MESH:
        kg_conversion_ask(app, path);
        return;
    case KG_FOR_NEW_REFERENCE:
        go_on(app, KG_FOR_NEW);
        kg_loading_reference(app, path);
        return;
    case KG_FOR_SAVE:
        status = kg_editor_save(&app->editor, path, &error);
        if (!status) {
            kg_dialogs_remember(app);
            kg_recovery_forget(app);
            /* `path` may have been the editor's own, which is another text now */
            kg_editor_say(&app->editor, KG_WARNING, _("Saved %s"), app->editor.path);
            if (app->dialogs.after_unsaved != KG_FOR_NOTHING)
                go_on(app, app->dialogs.after_unsaved);
        }
        app->dialogs.after_unsaved = KG_FOR_NOTHING;
        break;
    case KG_FOR_REFERENCE:
        kg_loading_reference(app, path);
        return;
    default:
        kg_export_to(app, purpose, path);
        break;
    }
    if (status)
        kg_dialogs_fail(app, &error);
}

/* ---- prompts ----------------------------------------------------------------------------- */

static void show_error(kg_app *app) {
    if (!kg_panel_modal(&app->dialogs.open_error, _("That did not work"), 460))
        return;
    kg_ui_text_wrapped(app->dialogs.error);
    kg_ui_space();
    if (kg_ui_primary_button(_("Close")) || kg_ui_key_pressed(KG_KEY_ESCAPE))
        kg_ui_popup_close();
    kg_ui_popup_end();
}

static void show_unsaved(kg_app *app) {
    kg_dialogs *d = &app->dialogs;
    if (!kg_panel_modal(&d->open_unsaved, _("Unsaved changes"), 420))
        return;
    bool save = false, discard = false, cancel = false;
    kg_ui_text_wrapped(_("The model was changed since it was saved. What is to become of the "
                         "changes?"));
    kg_ui_space();
    save = kg_ui_primary_button(_("Save"));
    kg_ui_same_line();
    discard = kg_ui_button(_("Discard"));
    kg_ui_same_line();
    cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (save || discard || cancel)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (save && app->editor.path)
        kg_dialogs_use_file(app, KG_FOR_SAVE, app->editor.path);
    else if (save)
        kg_dialogs_browse(app, KG_FOR_SAVE);
    else if (discard)
        go_on(app, d->after_unsaved);
    if (discard || cancel)
        d->after_unsaved = KG_FOR_NOTHING;
}

/* A mesh was opened as if it were a model. */
static void show_mesh(kg_app *app) {
    char path[KG_PATH_SIZE];
    if (!kg_panel_modal(&app->dialogs.open_mesh, _("Open a mesh"), 460))
        return;
    kg_ui_text_wrapped(_("A mesh is no model. It can be what a new patch model is sculpted over, "
                         "or become a pop-up card."));
    kg_ui_space();
    bool patches = kg_ui_primary_button(_("Sculpt over it"));
    kg_ui_same_line();
    bool card = kg_ui_button(_("Make a card…"));
    kg_ui_same_line();
    bool cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (patches || card || cancel)
        kg_ui_popup_close();
    kg_ui_popup_end();
    memcpy(path, app->dialogs.path, sizeof path);
    if (card)
        kg_dialogs_use_file(app, KG_FOR_CARD_OF_MESH, path);
    else if (patches)
        kg_dialogs_use_file(app, KG_FOR_NEW_REFERENCE, path);
}

static void show_overwrite(kg_app *app) {
    kg_dialogs *d = &app->dialogs;
    char text[KG_PATH_SIZE + 64];
    if (!kg_panel_modal(&d->open_overwrite, _("Replace file"), 420))
        return;
    snprintf(text, sizeof text, _("%s exists. Replace it?"), d->path);
    kg_ui_text_wrapped(text);
    kg_ui_space();
    bool replace = kg_ui_primary_button(_("Replace"));
    kg_ui_same_line();
    bool cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (replace || cancel)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (replace) {
        char path[KG_PATH_SIZE];
        memcpy(path, d->path, sizeof path);
        kg_dialogs_use_file(app, d->purpose, path);
    }
}

static void show_rename(kg_app *app) {
    kg_dialogs *d = &app->dialogs;
    kg_editor *e = &app->editor;
    int64_t id = kg_editor_first_selected(e);
    const kg_model_patch *p = id ? kg_model_find(kg_editor_model(e), id) : NULL;
    d->open_rename = d->open_rename && p;
    if (d->open_rename) {
        snprintf(d->name, sizeof d->name, "%s", p->name);
        d->focus = true;
    }
    if (!kg_panel_modal(&d->open_rename, _("Rename"), 360))
        return;
    kg_ui_width(-1);
    kg_ui_text_field("##name", d->name, sizeof d->name, _("Name"), d->focus);
    bool done = kg_ui_field_entered();
    d->focus = false;
    kg_ui_space();
    done = kg_ui_primary_button(_("Rename")) || done;
    kg_ui_same_line();
    bool cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (done || cancel)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (done && !cancel && p)
        kg_command_do_with(e, "patch.rename",
                           json_pack("{s:I,s:s}", "patch", (json_int_t)id, "name", d->name));
}

static void show_recovery(kg_app *app) {
    kg_dialogs *d = &app->dialogs;
    if (!kg_panel_modal(&d->open_recovery, _("Recover work"), 420))
        return;
    kg_ui_text_wrapped(_("katagami ended without saving. The work of that time was kept and can "
                         "be opened again."));
    kg_ui_space();
    bool take = kg_ui_primary_button(_("Recover"));
    kg_ui_same_line();
    bool drop = kg_ui_button(_("Discard"));
    if (take || drop)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (take)
        kg_recovery_take(app);
    if (drop)
        kg_recovery_drop(app);
}

void kg_panel_prompts(kg_app *app) {
    show_unsaved(app);
    show_mesh(app);
    show_overwrite(app);
    show_rename(app);
    show_recovery(app);
    show_error(app);
}
