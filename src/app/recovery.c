#include "app/recovery.h"

#include "app/text.h"
#include "model/edit.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define AUTOSAVE "autosave.katagami"

/* Where the work belongs, noted in the autosaved file alone. */
#define ORIGIN "autosaved_from"

double kg_recovery_due(const kg_app *app) {
    const kg_editor *e = &app->editor;
    if (e->settings.autosave_minutes <= 0 || !kg_editor_is_modified(e) ||
        e->state == e->autosaved_state)
        return -1;
    return fmax(app->autosaved + 60 * e->settings.autosave_minutes - e->clock, 0);
}

/* A copy of the model that names its file. */
static kg_status write_copy(const kg_editor *e, const char *path, kg_error *error) {
    kg_model *copy = kg_model_copy(kg_editor_model(e));
    kg_document *document = NULL;
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_history_store(&e->history, copy, error);
    if (!status && e->path)
        json_object_set_new(copy->json, ORIGIN, json_string(e->path));
    if (status) {
        kg_model_destroy(copy);
        return status;
    }
    status = kg_document_from_model(copy, kg_document_path(e->document), &document, error);
    if (!status)
        status = kg_document_save(document, path, error);
    kg_document_destroy(document);
    return status;
}

void kg_recovery_tick(kg_app *app) {
    kg_editor *e = &app->editor;
    char path[KG_PATH_SIZE];
    kg_error error;
    if (kg_recovery_due(app) != 0 || e->before)
        return;
    app->autosaved = e->clock;
    e->autosaved_state = e->state;
    if (!kg_state_path(AUTOSAVE, path))
        kg_editor_say(e, KG_WARNING, "%s", _("There is no folder to autosave to."));
    else if (write_copy(e, path, &error))
        kg_editor_say(e, KG_WARNING, _("Autosave failed: %s"), error.message);
}

void kg_recovery_offer(kg_app *app) {
    char path[KG_PATH_SIZE];
    if (!kg_state_path(AUTOSAVE, path) || access(path, R_OK) != 0)
        return;
    snprintf(app->dialogs.recovery, sizeof app->dialogs.recovery, "%s", path);
    app->dialogs.open_recovery = true;
}

void kg_recovery_take(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_error error;
    if (kg_editor_open(e, app->dialogs.recovery, &error)) {
        kg_editor_say(e, KG_FAULT, "%s", error.message);
        return;
    }
    kg_model *m = kg_editor_model(e);
    const char *origin = json_string_value(json_object_get(m->json, ORIGIN));
    free(e->path);
    e->path = origin ? strdup(origin) : NULL;
    if (origin) {
        json_t *rest = json_copy(m->json);
        json_object_del(rest, ORIGIN);
        json_decref(m->json);
        m->json = rest;
    }
    e->saved_state = e->next_state++; /* it is in no file of the user's */
    app->framed = false;
}

void kg_recovery_forget(kg_app *app) {
    char path[KG_PATH_SIZE];
    app->dialogs.recovery[0] = '\0';
    app->autosaved = app->editor.clock;
    if (kg_state_path(AUTOSAVE, path))
        remove(path);
}
