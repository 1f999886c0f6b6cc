#include "app/recovery.h"

#include "app/panels/panels.h"
#include "app/text.h"
#include "base/array.h"

#include <dirent.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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
    bool is_kept = e->state == e->autosaved_state && !e->before;
    if (e->settings.autosave_minutes <= 0 || !kg_editor_is_modified(e) || is_kept)
        return -1;
    return fmax(app->autosaved + 60 * e->settings.autosave_minutes - e->clock, 0);
}

/* The history as it would be if the gesture that goes on ended now. */
static kg_status store_history(kg_editor *e, kg_document *copy, kg_error *error) {
    kg_history *h = &e->history;
    if (!e->before)
        return kg_history_store(h, copy, error);
    kg_step step = {.content = e->before, .label = e->gesture}; /* only lent */
    if (!kg_push(&h->undo, step))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_history ended = {.undo = h->undo};
    kg_status status = kg_history_store(&ended, copy, error);
    json_decref(h->undo.items[--h->undo.count].stored);
    return status;
}

/* A copy of the document that names its file. */
static kg_status write_copy(kg_editor *e, const char *path, kg_error *error) {
    kg_document *copy;
    kg_status status = kg_document_copy(e->document, &copy, error);
    if (status)
        return status;
    status = store_history(e, copy, error);
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
    if (kg_recovery_due(app) != 0)
        return;
    app->autosaved = e->clock;
    e->autosaved_state = e->before ? 0 : e->state; /* a gesture may go on, or be taken back */
    if (!own_path(path))
        kg_editor_say(e, KG_WARNING, "%s", _("There is no folder to autosave to."));
    else if (write_copy(e, path, &error))
        kg_editor_say(e, KG_WARNING, _("Autosave failed: %s"), error.message);
    else
        app->has_autosave = true;
}

/* ---- what others left behind -------------------------------------------------------------- */

/* What program a process runs; NULL: it is no more, or somebody else's. */
static const char *program_of(long process, char out[KG_PATH_SIZE]) {
    char link[64];
    snprintf(link, sizeof link, "/proc/%ld/exe", process);
    ssize_t n = readlink(link, out, KG_PATH_SIZE - 1);
    if (n <= 0)
        return NULL;
    out[n] = '\0';
    char *replaced = strstr(out, " (deleted)"); /* by a newer version */
    if (replaced)
        *replaced = '\0';
    const char *slash = strrchr(out, '/');
    return slash ? slash + 1 : out;
}

/* Whether a process is katagami: numbers of processes are used again. */
static bool is_running(long process) {
    char its[KG_PATH_SIZE], own[KG_PATH_SIZE];
    const char *a = program_of(process, its), *b = program_of((long)getpid(), own);
    return a && b && strcmp(a, b) == 0;
}

/* Did a process that is no more leave this file? The name of one that it was writing when it ended
 * goes on behind NAME_FORMAT, which `out_whole` tells. */
static bool is_left_behind(const kg_app *app, const char *name, bool *out_whole) {
    long process;
    int end = 0;
    bool is_ours = sscanf(name, NAME_FORMAT "%n", &process, &end) == 1 && end > 0;
    *out_whole = is_ours && name[end] == '\0';
    if (!is_ours || (!*out_whole && name[end] != '.') || process <= 0)
        return false;
    return process == (long)getpid() ? !app->has_autosave : !is_running(process);
}

void kg_recovery_offer(kg_app *app) {
    char folder[KG_PATH_SIZE], path[KG_PATH_SIZE];
    struct timespec newest = {0};
    bool found = false, whole;
    if (!kg_state_path("", folder))
        return;
    DIR *files = opendir(folder);
    for (struct dirent *entry; files && (entry = readdir(files));) {
        struct stat info;
        if (!is_left_behind(app, entry->d_name, &whole) || !kg_state_path(entry->d_name, path) ||
            stat(path, &info) != 0)
            continue;
        bool newer = info.st_mtim.tv_sec > newest.tv_sec || (info.st_mtim.tv_sec == newest.tv_sec &&
                                                             info.st_mtim.tv_nsec > newest.tv_nsec);
        if (!whole) {
            remove(path);
        } else if (!found || newer) {
            found = true;
            newest = info.st_mtim;
            strcpy(app->dialogs.recovery, path);
        }
    }
    if (files)
        closedir(files);
    app->dialogs.open_recovery = found;
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
        kg_dialogs_fail(app, &error);
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
    if (remove(app->dialogs.recovery) == 0)
        kg_recovery_offer(app); /* an older one */
}

void kg_recovery_forget(kg_app *app) {
    char path[KG_PATH_SIZE];
    app->autosaved = app->editor.clock;
    if (app->has_autosave && own_path(path))
        remove(path);
    app->has_autosave = false;
}
