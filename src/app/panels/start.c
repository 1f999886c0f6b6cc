/* What the app begins with: a few ways in, over the empty view. It is gone with the first action.
 */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* Layout units. */
enum { WIDTH = 340, ROW = 25, RIM = 74, MOST_RECENT = 6 };

static bool is_folder(const char *path) {
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* Nothing was begun, opened or drawn yet. */
static bool is_fresh(const kg_app *app) {
    const kg_editor *e = &app->editor;
    const kg_model *m = kg_editor_model(e);
    return m && m->patch_count == 0 && !m->reference.file && !e->path &&
           !kg_editor_is_modified(e) && e->history.redo.count == 0 && !app->load_job;
}

static void command(kg_editor *e, const char *id) {
    const kg_app_command *c = kg_command_find(id);
    if (kg_ui_selectable(_(c->title), false))
        kg_command_do(e, id);
    kg_ui_tooltip(_(c->help));
}

/* Recent files by their names; the whole path is a tooltip. */
static const char *recent(const kg_settings *s, int count) {
    const char *chosen = NULL;
    for (int i = 0; i < count; i++) {
        const char *slash = strrchr(s->recent[i], '/');
        kg_ui_id_push(i);
        if (kg_ui_selectable(slash ? slash + 1 : s->recent[i], false))
            chosen = s->recent[i];
        kg_ui_tooltip(s->recent[i]);
        kg_ui_id_pop();
    }
    return chosen;
}

void kg_panel_start(kg_app *app) {
    kg_editor *e = &app->editor;
    const char *file = NULL;
    if (!app->start)
        return;
    if (!is_fresh(app)) {
        app->start = false;
        return;
    }
    int count = 0;
    while (count < MOST_RECENT && e->settings.recent[count])
        count++;
    bool samples = is_folder(KG_SAMPLES_FOLDER);
    int rows = 5 + samples + (count > 0 ? count + 1 : 0);
    const kg_area *view = &e->pane.area;
    double s = app->scale * e->settings.scale, width = fmin(WIDTH * s, view->width),
           height = fmin((RIM + ROW * rows) * s, view->height);
    kg_ui_panel_begin("start", _("Start"),
                      (kg_area){floor(view->x + (view->width - width) / 2),
                                floor(view->y + (view->height - height) / 2), width, height},
                      0);
    command(e, "file.new");
    command(e, "file.new_card");
    command(e, "file.new_sheets");
    kg_ui_separator();
    command(e, "file.card_from_mesh");
    command(e, "file.open");
    if (samples && kg_ui_selectable(_("Samples…"), false)) {
        snprintf(app->dialogs.folder, sizeof app->dialogs.folder, "%s", KG_SAMPLES_FOLDER);
        kg_dialogs_browse(app, KG_FOR_OPEN);
    }
    if (count > 0) {
        kg_ui_separator();
        kg_ui_text_dim(_("Recent files"));
        file = recent(&e->settings, count);
    }
    kg_ui_panel_end();
    if (file)
        kg_app_open(app, file);
}
