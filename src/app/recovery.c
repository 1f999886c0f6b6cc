#include "app/recovery.h"

#include "app/text.h"

#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NAME_FORMAT "autosave-%ld.katagami"

/* Where the work belongs, noted in the autosaved file alone. */
#define ORIGIN "autosaved_from"

static bool own_path(char out[KG_PATH_SIZE]) {
    char name[64];
    snprintf(name, sizeof name, NAME_FORMAT, (long)getpid());
    return kg_state_path(name, out);
}

double kg_recovery_due(const kg_app *app) {
    const kg_editor *e = &app->editor;
    if (e->settings.autosave_minutes <= 0 || !kg_editor_is_modified(e) ||
        e->state == e->autosaved_state)
        return -1;
    return fmax(app->autosaved + 60 * e->settings.autosave_minutes - e->clock, 0);
}

/* A copy of the document that names its file. */
static kg_status write_copy(kg_editor *e, const char *path, kg_error *error) {
    kg_document *copy;
    kg_status status = kg_document_copy(e->document, &copy, error);
    if (status)
        return status;
    status = kg_history_store(&e->history, copy, error);
    if (!status && e->path)
        json_object_set_new(*kg_document_json(copy), ORIGIN, json_string(e->path));
    if (!status)
        status = kg_document_save(copy, path, error);
    kg_document_destroy(copy);
    return status;
}

void kg_recovery_tick(kg_app *app) {
    kg_editor *e = &app->editor;
    char path[KG_PATH_SIZE];
    kg_error error;
    if (app->has_autosave && !kg_editor_is_modified(e))
        kg_recovery_forget(app);
    if (kg_recovery_due(app) != 0 || e->before)
        return;
    app->autosaved = e->clock;
    e->autosaved_state = e->state;
    if (!own_path(path))
        kg_editor_say(e, KG_WARNING, "%s", _("There is no folder to autosave to."));
    else if (write_copy(e, path, &error))
        kg_editor_say(e, KG_WARNING, _("Autosave failed: %s"), error.message);
    else
        app->has_autosave = true;
}

/* Is this the name of a file that a process left which is no more? */
static bool is_left_behind(const char *name) {
    long process;
    int end = 0;
    return sscanf(name, NAME_FORMAT "%n", &process, &end) == 1 && end > 0 && name[end] == '\0' &&
           process > 0 && process != (long)getpid() && kill((pid_t)process, 0) != 0 &&
           errno == ESRCH;
}

void kg_recovery_offer(kg_app *app) {
    char folder[KG_PATH_SIZE];
    if (!kg_state_path("", folder))
        return;
    DIR *files = opendir(folder);
    for (struct dirent *entry; files && (entry = readdir(files));)
        if (is_left_behind(entry->d_name) && kg_state_path(entry->d_name, app->dialogs.recovery)) {
            app->dialogs.open_recovery = true;
            break;
        }
    if (files)
        closedir(files);
}

/* The file the work belongs to; the note of it is taken out of the document. */
static char *take_origin(kg_document *d) {
    json_t **file = kg_document_json(d);
    const char *origin = json_string_value(json_object_get(*file, ORIGIN));
    char *copy = origin ? strdup(origin) : NULL;
    json_t *rest = origin ? json_copy(*file) : NULL;
    if (rest) {
        json_object_del(rest, ORIGIN);
        json_decref(*file);
        *file = rest;
    }
    return copy;
}

void kg_recovery_take(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_error error;
    char own[KG_PATH_SIZE];
    if (kg_editor_open(e, app->dialogs.recovery, &error)) {
        kg_editor_say(e, KG_FAULT, "%s", error.message);
        return;
    }
    free(e->path);
    e->path = take_origin(e->document);
    e->saved_state = e->next_state++; /* it is in no file of the user's */
    app->autosaved = e->clock;
    app->framed = false;
    app->has_autosave = own_path(own) && rename(app->dialogs.recovery, own) == 0;
    if (!app->has_autosave)
        kg_editor_say(e, KG_WARNING, "%s", _("The recovered work cannot be autosaved."));
}

void kg_recovery_drop(kg_app *app) {
    remove(app->dialogs.recovery);
}

void kg_recovery_forget(kg_app *app) {
    char path[KG_PATH_SIZE];
    app->autosaved = app->editor.clock;
    if (app->has_autosave && own_path(path))
        remove(path);
    app->has_autosave = false;
}
