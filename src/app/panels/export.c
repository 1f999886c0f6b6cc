/* What a file is to be exported as, and the progress of writing it. */
#include "app/commands/commands.h"
#include "app/export_job.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "net/settings.h"

#include <stdio.h>
#include <string.h>

enum {
    PATCHES = KG_FOR_KIND(KG_DOCUMENT_PATCHES),
    CARDS = KG_FOR_KIND(KG_DOCUMENT_OA),
    SHEETS = KG_FOR_KIND(KG_DOCUMENT_ORIGAMI),
    ALL = PATCHES | CARDS | SHEETS
};

typedef struct format {
    const char *name, *ending, *what;
    kg_purpose purpose;
    unsigned kinds; /* of documents */
} format;

static const format formats[] = {
    {"svg", "svg", N_("for browsers, Inkscape and most cutters; one file a page"), KG_FOR_NET, ALL},
    {"pdf", "pdf", N_("for printing; all pages in one file"), KG_FOR_NET, ALL},
    {"dxf", "dxf", N_("for laser cutters and CAD; one file a page"), KG_FOR_NET, ALL},
    {"guide", "pdf", N_("instructions: how it is built, step by step"), KG_FOR_GUIDE,
     PATCHES | CARDS},
    {"guide", "pdf", N_("instructions: every fold in the usual notation"), KG_FOR_GUIDE, SHEETS},
    {"fold", "fold", N_("crease pattern for other folding programs"), KG_FOR_MESH, CARDS},
    {"fold", "fold", N_("all steps for other folding programs"), KG_FOR_MESH, SHEETS},
    {"cp", "cp", N_("crease pattern, plain lines"), KG_FOR_MESH, SHEETS},
    {"obj", "obj", N_("mesh, one group a patch"), KG_FOR_MESH, PATCHES},
    {"obj", "obj", N_("mesh, folded as it is shown"), KG_FOR_MESH, CARDS | SHEETS},
    {"ply", "ply", N_("mesh, coloured"), KG_FOR_MESH, PATCHES},
    {"stl", "stl", N_("mesh of triangles"), KG_FOR_MESH, PATCHES},
    {"off", "off", N_("mesh, plain text"), KG_FOR_MESH, PATCHES},
    {"gltf", "gltf", N_("mesh for the web, as text"), KG_FOR_MESH, PATCHES},
    {"gltf", "gltf", N_("the folding as an animation, as text"), KG_FOR_MESH, CARDS | SHEETS},
    {"glb", "glb", N_("mesh for the web, in one file"), KG_FOR_MESH, PATCHES},
    {"glb", "glb", N_("the folding as an animation, in one file"), KG_FOR_MESH, CARDS | SHEETS},
    {"png", "png", N_("picture of the 3D view"), KG_FOR_PICTURE, ALL},
};
enum { FORMAT_COUNT = sizeof formats / sizeof *formats };

static bool is_for(const format *f, const kg_editor *e) {
    return f->kinds & KG_FOR_KIND(kg_document_get_kind(e->document));
}

/* NULL: not for such documents. */
static const format *find_format(const kg_editor *e, const char *name) {
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (is_for(&formats[i], e) && strcmp(formats[i].name, name) == 0)
            return &formats[i];
    return NULL;
}

/* ---- choosing --------------------------------------------------------------------------- */

static void set(kg_editor *e, const char *key, const char *word) {
    kg_command_do_with(e, "net.set", json_pack("{s:s}", key, word));
}

static void net_options(kg_editor *e) {
    kg_export_choice *c = &e->settings.export;
    const char *const presets[] = {_("print"), _("laser cutter"), "Silhouette", "Cricut"};
    int index = (int)kg_net_settings_preset(kg_document_net_settings(e->document));
    kg_ui_width(180);
    if (kg_ui_choice(_("made for"), presets, 4, &index))
        set(e, "preset", kg_net_preset_names[index]);
    kg_ui_check(_("print and cut lines in files of their own"), &c->separate);
    kg_ui_check(_("mirrored, to print on the back of the paper"), &c->mirrored);
    kg_ui_check(_("perforated folds, dashes with real gaps"), &c->perforate);
    if (c->perforate) {
        kg_ui_indent();
        kg_ui_width(100);
        kg_ui_number(_("dash"), &c->dash, 0.05, 0.1, 50, "%.2f mm");
        kg_ui_same_line();
        kg_ui_width(100);
        kg_ui_number(_("gap"), &c->gap, 0.05, 0.1, 50, "%.2f mm");
        kg_ui_unindent();
    }
}

static void picture_options(kg_export_choice *c) {
    kg_ui_width(120);
    kg_ui_number(_("width"), &c->width, 4, 64, 8192, "%.0f px");
}

/* Opens the browser with a name of the chosen format. */
static void choose_file(kg_app *app, const format *f) {
    kg_dialogs *d = &app->dialogs;
    kg_dialogs_browse(app, f->purpose);
    char *dot = strrchr(d->file, '.');
    size_t at = dot ? (size_t)(dot - d->file) : strlen(d->file);
    const char *more = f->purpose == KG_FOR_GUIDE ? "-guide" : ""; /* beside the net's PDF */
    if (at + 1 + strlen(more) + strlen(f->ending) < sizeof d->file)
        snprintf(d->file + at, sizeof d->file - at, "%s.%s", more, f->ending);
}

static void show_choice(kg_app *app) {
    static const double widths[] = {70, 0};
    kg_editor *e = &app->editor;
    kg_export_choice *c = &e->settings.export;
    if (!kg_panel_modal(&app->dialogs.open_export, _("Export"), 560))
        return;
    const format *chosen = find_format(e, c->format);
    if (!chosen)
        chosen = &formats[0];
    if (kg_ui_table_begin("formats", 2, widths)) {
        for (int i = 0; i < FORMAT_COUNT; i++) {
            if (!is_for(&formats[i], e))
                continue;
            kg_ui_table_row();
            kg_ui_table_next();
            if (kg_ui_radio(formats[i].name, chosen == &formats[i]))
                snprintf(c->format, sizeof c->format, "%s", formats[i].name);
            kg_ui_table_next();
            kg_ui_text_dim(_(formats[i].what));
        }
        kg_ui_table_end();
    }
    kg_ui_separator();
    if (chosen->purpose == KG_FOR_NET)
        net_options(e);
    else if (chosen->purpose == KG_FOR_PICTURE)
        picture_options(c);
    kg_ui_space();
    bool go_on = kg_ui_primary_button(_("Choose file…"));
    kg_ui_same_line();
    bool cancel = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (go_on || cancel)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (go_on)
        choose_file(app, chosen);
}

void kg_export_ask(kg_app *app, kg_purpose purpose) {
    kg_export_choice *c = &app->editor.settings.export;
    const format *f = find_format(&app->editor, c->format);
    bool fits =
        f && (f->purpose == purpose || (purpose == KG_FOR_MESH && f->purpose == KG_FOR_PICTURE));
    if (!fits)
        snprintf(c->format, sizeof c->format, "%s",
                 purpose == KG_FOR_NET    ? "svg"
                 : purpose == KG_FOR_MESH ? "obj"
                                          : "guide");
    app->dialogs.open_export = true;
}

/* ---- writing ---------------------------------------------------------------------------- */

/* Drawn at once, since no other thread may draw; written by the job. */
static kg_status start_picture(kg_app *app, const char *path, kg_error *error) {
    const kg_area *a = &app->editor.pane.area;
    int width = (int)app->editor.settings.export.width;
    int height = (int)fmax(width * a->height / fmax(a->width, 1), 1);
    kg_image image;
    kg_status status = kg_scenery_picture(app->stage, &app->editor, width, height, &image, error);
    return status ? status
                  : kg_export_job_picture(&image, path, &app->gate, &app->export_job, error);
}

static void told(kg_app *app, kg_status status, const char *path, const kg_error *error) {
    kg_error ignored;
    if (status == KG_ERR_CANCELLED)
        kg_editor_say(&app->editor, KG_WARNING, "%s", _("Nothing was written."));
    else if (status)
        kg_dialogs_fail(app, error);
    else
        kg_editor_say(&app->editor, KG_WARNING, _("Wrote %s"), path);
    if (!status && kg_settings_write(&app->editor.settings, &ignored))
        return; /* the choices are forgotten, the file is there */
}

void kg_export_to(kg_app *app, kg_purpose purpose, const char *path) {
    kg_error error;
    bool guide = purpose == KG_FOR_GUIDE;
    if (app->export_job)
        return;
    if (purpose == KG_FOR_PICTURE
            ? start_picture(app, path, &error)
            : kg_export_job_start(&app->editor, path, guide, &app->gate, &app->export_job, &error))
        kg_dialogs_fail(app, &error);
    else
        app->dialogs.open_progress = true;
}

static void show_progress(kg_app *app) {
    kg_export_job *job = app->export_job;
    char path[KG_PATH_SIZE];
    kg_error error;
    bool open = kg_panel_modal(&app->dialogs.open_progress, _("Exporting"), 420);
    bool done = job && kg_export_job_is_done(job);
    if (open && job) {
        kg_ui_text_wrapped(kg_export_job_path(job));
        kg_ui_progress(kg_export_job_fraction(job), "");
        if (kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE))
            kg_export_job_cancel(job);
    }
    if (open && (done || !job))
        kg_ui_popup_close();
    if (open)
        kg_ui_popup_end();
    if (done) {
        snprintf(path, sizeof path, "%s", kg_export_job_path(job));
        app->export_job = NULL;
        told(app, kg_export_job_finish(job, &error), path, &error);
        app->redraw = true;
    }
    app->busy = app->busy || app->export_job;
}

void kg_export_stop(kg_app *app) {
    kg_error error;
    if (!app->export_job)
        return;
    kg_export_job_cancel(app->export_job);
    kg_status status = kg_export_job_finish(app->export_job, &error);
    app->export_job = NULL;
    if (status && status != KG_ERR_CANCELLED)
        kg_editor_say(&app->editor, KG_FAULT, "%s", error.message);
}

void kg_panel_export(kg_app *app) {
    show_choice(app);
    show_progress(app);
}
