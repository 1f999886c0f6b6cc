/* Opening documents and references: small ones at once, large ones while a dialog shows. */
#include "app/commands/reference.h"
#include "app/load_job.h"
#include "app/mode.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "base/array.h"
#include "base/file.h"
#include "document/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Files up to these sizes, bytes, are read within a few frames, without a dialog that flashes. */
enum { SMALL_DOCUMENT = 32 << 10, SMALL_PATTERN = 4 << 10, SMALL_MESH = 1 << 20 };

static bool is_small(const char *path, off_t limit) {
    struct stat info;
    return !path || stat(path, &info) != 0 || info.st_size <= limit;
}

/* ---- what comes of it -------------------------------------------------------------------- */

static kg_status take_document(kg_app *app, kg_document *document, const char *path,
                               kg_error *error) {
    kg_status status =
        kg_editor_take(&app->editor, document, kg_editor_home(path) ? path : NULL, error);
    if (!status) {
        app->framed = false;
        kg_dialogs_remember(app);
    }
    return status;
}

/* Makes a mesh that was read the model's reference. */
static kg_status set_reference(kg_app *app, const char *path, kg_error *error) {
    kg_editor *e = &app->editor;
    const kg_model *model = kg_editor_model(e);
    if (!model)
        return kg_fail(error, KG_ERR_INPUT, _("%s does nothing with a %s"), "reference.set",
                       _(e->mode->title));
    bool had = model->reference.file;
    if (e->before) /* what a tool has begun gives way */
        kg_editor_use_default(e);
    kg_status status = kg_reference_set(e, path, error);
    app->framed = app->framed && (had || status);
    return status;
}

static void cannot_show(kg_editor *e, const kg_error *error) {
    kg_editor_say(e, KG_WARNING, _("The reference cannot be shown: %s"), error->message);
}

/* A pattern that had no size of its own was given one. */
static void say_size(kg_editor *e) {
    const kg_layer_report *r = kg_document_layers(e->document);
    if (r && r->mm_per_unit > 0)
        kg_editor_say(e, KG_WARNING,
                      _("The file names no unit: it was made %g mm long, 1 became %.6g mm."),
                      KG_SHEET_SIZE, r->mm_per_unit);
}

static void say_skipped(kg_editor *e) {
    char text[KG_ERROR_SIZE];
    if (e->backdrop.mesh &&
        kg_mesh_say_skipped(e->backdrop.mesh, kg_editor_model(e)->reference.file, text,
                            sizeof text))
        kg_editor_say(e, KG_WARNING, "%s", text);
}

static void finish(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_load_job *job = app->load_job;
    kg_document *document = NULL;
    kg_backdrop backdrop = {0};
    kg_error reference_error, error;
    bool is_document = kg_load_job_is_document(job), is_asked = kg_load_job_path(job) != NULL;
    char path[KG_PATH_SIZE];
    snprintf(path, sizeof path, "%s", is_asked ? kg_load_job_path(job) : "");
    app->load_job = NULL;
    app->redraw = true;
    kg_status status = kg_load_job_finish(job, &document, &backdrop, &reference_error, &error);
    if (status && !is_asked) {
        cannot_show(e, &error);
        return;
    }
    if (!status && is_document)
        status = take_document(app, document, path, &error);
    else if (!status && is_asked)
        status = set_reference(app, path, &error);
    if (status) {
        kg_dialogs_fail(app, &error);
    } else if (is_asked || app->reference_loaded == e->reference_asked) {
        app->reference_loaded = e->reference_asked;
        kg_backdrop_take(&e->backdrop, &backdrop);
        app->framed = app->framed && is_asked; /* of another size or another way up */
        if (reference_error.message[0])
            cannot_show(e, &reference_error);
        say_skipped(e);
        if (is_document)
            say_size(e);
    }
    kg_backdrop_clear(&backdrop);
}

/* Lets the thread end by itself. */
static void give_up(kg_app *app) {
    kg_load_job_cancel(app->load_job);
    if (!kg_push(&app->given_up, app->load_job))
        kg_load_job_destroy(app->load_job);
    app->load_job = NULL;
    kg_editor_say(&app->editor, KG_WARNING, "%s", _("Nothing was loaded."));
}

static void drop_ended(kg_app *app) {
    size_t kept = 0;
    for (size_t i = 0; i < app->given_up.count; i++)
        if (kg_load_job_is_done(app->given_up.items[i]))
            kg_load_job_destroy(app->given_up.items[i]);
        else
            app->given_up.items[kept++] = app->given_up.items[i];
    app->given_up.count = kept;
}

void kg_loading_stop(kg_app *app) {
    kg_load_job_destroy(app->load_job);
    for (size_t i = 0; i < app->given_up.count; i++)
        kg_load_job_destroy(app->given_up.items[i]);
    free(app->given_up.items);
    app->load_job = NULL;
    app->given_up.items = NULL;
    app->given_up.count = app->given_up.capacity = 0;
}

/* ---- beginning --------------------------------------------------------------------------- */

static void began(kg_app *app, kg_status status, bool at_once, const kg_error *error) {
    if (status)
        kg_dialogs_fail(app, error);
    else if (at_once)
        finish(app);
    else
        app->dialogs.open_loading = true;
}

void kg_loading_open(kg_app *app, const char *path) {
    kg_error error;
    if (app->load_job)
        give_up(app);
    kg_status status =
        kg_load_job_document(path, KG_EDITOR_CHORD, &app->gate, &app->load_job, &error);
    bool pattern = kg_file_ends_in(path, ".fold") || kg_file_ends_in(path, ".cp");
    began(app, status, is_small(path, pattern ? SMALL_PATTERN : SMALL_DOCUMENT), &error);
}

void kg_loading_reference(kg_app *app, const char *path) {
    kg_error error;
    if (app->load_job)
        give_up(app);
    if (!kg_editor_model(&app->editor)) {
        if (set_reference(app, path, &error)) /* which says why not */
            kg_dialogs_fail(app, &error);
        return;
    }
    kg_status status =
        kg_load_job_reference(app->editor.document, path, &app->gate, &app->load_job, &error);
    began(app, status, is_small(path, SMALL_MESH), &error);
}

/* Loads the reference of a model that was opened, or that a step gave another one. */
static void follow_model(kg_app *app) {
    const kg_editor *e = &app->editor;
    const kg_model *model = kg_editor_model(e);
    kg_error error;
    if (app->load_job || app->reference_loaded == e->reference_asked)
        return;
    app->reference_loaded = e->reference_asked;
    if (!model || !model->reference.file)
        return;
    char *path = kg_document_reference_path(e->document);
    kg_status status = kg_load_job_reference(e->document, NULL, &app->gate, &app->load_job, &error);
    began(app, status, is_small(path, SMALL_MESH), &error);
    free(path);
}

/* ---- the dialog -------------------------------------------------------------------------- */

static void show(kg_app *app) {
    const char *const steps[] = {_("Reading"), _("Working out the patches"),
                                 _("Reading the reference")};
    kg_load_job *job = app->load_job;
    if (!kg_panel_modal(&app->dialogs.open_loading, _("Loading"), 420))
        return;
    if (job) {
        if (kg_load_job_path(job))
            kg_ui_text_wrapped(kg_load_job_path(job));
        kg_ui_progress(kg_load_job_fraction(job), steps[kg_load_job_step(job)]);
        if (kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE))
            give_up(app);
    }
    if (!app->load_job)
        kg_ui_popup_close();
    kg_ui_popup_end();
}

void kg_panel_loading(kg_app *app) {
    drop_ended(app);
    if (app->load_job && kg_load_job_is_done(app->load_job))
        finish(app);
    follow_model(app);
    show(app);
    app->busy = app->busy || app->load_job;
}
