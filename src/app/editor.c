#include "app/editor.h"

#include "app/mode.h"
#include "app/text.h"
#include "app/tools/tool.h"
#include "base/array.h"
#include "base/file.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How long a message that is no fault is shown. */
#define MESSAGE_SECONDS 8

kg_model *kg_editor_model(const kg_editor *e) {
    return kg_document_model(e->document);
}

const kg_solution *kg_editor_solution(const kg_editor *e) {
    return kg_document_solution(e->document);
}

kg_oa *kg_editor_oa(const kg_editor *e) {
    return kg_document_oa(e->document);
}

kg_origami *kg_editor_origami(const kg_editor *e) {
    return kg_document_origami(e->document);
}

bool kg_editor_is(const kg_editor *e, kg_document_kind kind) {
    return kg_document_get_kind(e->document) == kind;
}

void kg_editor_say(kg_editor *e, kg_severity severity, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(e->message, sizeof e->message, format, args);
    va_end(args);
    e->severity = severity;
    e->message_number++;
    e->message_clock = e->clock;
}

double kg_editor_message_due(const kg_editor *e) {
    bool goes = e->message[0] && e->severity != KG_FAULT;
    return goes ? fmax(e->message_clock + MESSAGE_SECONDS - e->clock, 0) : -1;
}

/* ---- selection -------------------------------------------------------------------------- */

int kg_editor_selection_rank(const kg_editor *e, int64_t patch) {
    for (size_t i = 0; i < e->selection.patches.count; i++)
        if (e->selection.patches.items[i] == patch)
            return (int)i;
    return -1;
}

bool kg_editor_is_selected(const kg_editor *e, int64_t patch) {
    return kg_editor_selection_rank(e, patch) >= 0;
}

static void deselect(kg_editor *e, int64_t patch) {
    kg_selection *s = &e->selection;
    size_t kept = 0;
    for (size_t i = 0; i < s->patches.count; i++)
        if (s->patches.items[i] != patch)
            s->patches.items[kept++] = s->patches.items[i];
    s->patches.count = kept;
    kept = 0;
    for (size_t i = 0; i < s->points.count; i++)
        if (s->points.items[i].patch != patch)
            s->points.items[kept++] = s->points.items[i];
    s->points.count = kept;
}

void kg_editor_select_none(kg_editor *e) {
    e->selection.patches.count = e->selection.points.count = 0;
}

void kg_editor_select(kg_editor *e, int64_t patch, bool toggle) {
    if (!toggle)
        kg_editor_select_none(e);
    if (kg_editor_is_selected(e, patch))
        deselect(e, patch);
    else if (!kg_push(&e->selection.patches, patch))
        return; /* not selected, as the user will see */
}

static bool same_point(kg_point_ref a, kg_point_ref b) {
    return a.patch == b.patch && a.index == b.index;
}

bool kg_editor_is_point_selected(const kg_editor *e, kg_point_ref point) {
    for (size_t i = 0; i < e->selection.points.count; i++)
        if (same_point(e->selection.points.items[i], point))
            return true;
    return false;
}

void kg_editor_select_point(kg_editor *e, kg_point_ref point, bool toggle) {
    kg_selection *s = &e->selection;
    bool was = kg_editor_is_point_selected(e, point);
    size_t kept = 0;
    for (size_t i = 0; i < s->points.count; i++)
        if (toggle && !same_point(s->points.items[i], point))
            s->points.items[kept++] = s->points.items[i];
    s->points.count = kept;
    if (!(toggle && was) && !kg_push(&s->points, point))
        return;
}

int64_t kg_editor_first_selected(const kg_editor *e) {
    return e->selection.patches.count > 0 ? e->selection.patches.items[0] : 0;
}

bool kg_editor_shows_points(const kg_editor *e, int64_t patch) {
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), patch);
    return e->level == KG_LEVEL_POINTS && p && !p->hidden && kg_editor_is_selected(e, patch);
}

static void follow_solution(kg_editor *e) {
    e->solved++;
    if (e->mode->follow)
        e->mode->follow(e);
}

kg_box3 kg_editor_box(const kg_editor *e, bool selection) {
    return e->mode->box(e, selection);
}

/* ---- tools ------------------------------------------------------------------------------ */

void kg_editor_use(kg_editor *e, const kg_tool *tool, void *state) {
    if (e->tool && e->tool->end)
        e->tool->end(e);
    if (e->before)
        kg_editor_cancel(e);
    free(e->tool_state);
    e->tool = tool;
    e->tool_state = state;
}

void kg_editor_use_default(kg_editor *e) {
    kg_editor_use(e, e->mode->tool, NULL);
}

/* ---- changes ---------------------------------------------------------------------------- */

kg_status kg_editor_begin(kg_editor *e, const char *label, kg_error *error) {
    if (e->before)
        return KG_OK;
    kg_document *before;
    kg_status status = kg_document_copy(e->document, &before, error);
    if (status)
        return status;
    e->before = before;
    snprintf(e->gesture, sizeof e->gesture, "%s", label);
    return KG_OK;
}

void kg_editor_touch(kg_editor *e) {
    e->stale = true;
}

void kg_editor_commit(kg_editor *e) {
    kg_error error;
    kg_document *before = e->before;
    e->before = NULL;
    if (!before)
        return;
    if (kg_document_equal(before, e->document)) {
        kg_document_destroy(before);
        return;
    }
    uint64_t state = e->state;
    e->state = e->next_state++;
    kg_editor_touch(e);
    if (kg_history_push(&e->history, before, state, e->gesture, &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
}

void kg_editor_cancel(kg_editor *e) {
    if (!e->before)
        return;
    kg_document_swap(e->document, e->before);
    kg_document_destroy(e->before);
    e->before = NULL;
    kg_editor_touch(e);
}

kg_status kg_editor_finish(kg_editor *e, kg_status status) {
    if (status)
        kg_editor_cancel(e);
    else
        kg_editor_commit(e);
    return status;
}

/* Whether a step left the reference as it was. */
static bool same_reference(kg_document *from, kg_document *to) {
    const kg_model *a = kg_document_model(from), *b = kg_document_model(to);
    if (!a)
        return true;
    const kg_reference *r = &a->reference, *s = &b->reference;
    bool same_file = r->file && s->file ? strcmp(r->file, s->file) == 0 : r->file == s->file;
    return same_file && r->size_mm == s->size_mm && r->up_y == s->up_y &&
           r->has_matrix == s->has_matrix &&
           (!r->has_matrix || memcmp(r->matrix, s->matrix, sizeof r->matrix) == 0);
}

static bool step_back_or_forth(kg_editor *e, bool back) {
    if (e->before ||
        !(back ? kg_history_undo : kg_history_redo)(&e->history, e->document, &e->state))
        return false;
    const kg_steps *to = back ? &e->history.redo : &e->history.undo;
    kg_editor_touch(e);
    kg_editor_update(e);
    if (!same_reference(to->items[to->count - 1].content, e->document))
        kg_editor_load_reference(e);
    return true;
}

bool kg_editor_undo(kg_editor *e) {
    return step_back_or_forth(e, true);
}

bool kg_editor_redo(kg_editor *e) {
    return step_back_or_forth(e, false);
}

void kg_editor_update(kg_editor *e) {
    kg_error error;
    if (!e->stale)
        return;
    if (kg_document_solve(e->document, KG_EDITOR_CHORD, &error)) {
        kg_editor_say(e, KG_FAULT, "%s", error.message);
        return;
    }
    e->stale = false;
    follow_solution(e);
}

/* ---- files ------------------------------------------------------------------------------ */

void kg_editor_load_reference(kg_editor *e) {
    kg_backdrop_clear(&e->backdrop);
    e->reference_asked++;
}

kg_status kg_editor_take(kg_editor *e, kg_document *document, const char *path, kg_error *error) {
    const kg_mode *mode = kg_mode_of(kg_document_get_kind(document));
    void *state = NULL;
    char *copy = path ? strdup(path) : NULL;
    kg_status status = path && !copy ? kg_fail(error, KG_ERR_MEMORY, "out of memory") : KG_OK;
    if (!status)
        status = kg_document_solve(document, KG_EDITOR_CHORD, error);
    if (!status && mode->create)
        status = mode->create(document, &state, error);
    if (status) {
        kg_document_destroy(document);
        free(copy);
        return status;
    }
    if (e->document)
        kg_editor_use_default(e);
    if (e->mode_state)
        e->mode->destroy(e->mode_state);
    kg_history_clear(&e->history);
    kg_document_destroy(e->document);
    free(e->path);
    e->document = document;
    e->mode = mode;
    e->mode_state = state;
    e->path = copy;
    kg_editor_use_default(e);
    kg_history_restore(document, &e->next_state, &e->history);
    e->state = e->saved_state = e->autosaved_state = e->next_state++;
    kg_editor_select_none(e);
    e->hover_point = (kg_point_ref){0};
    e->hover_patch = 0;
    e->stale = false;
    follow_solution(e);
    e->message[0] = '\0';
    kg_editor_load_reference(e);
    return KG_OK;
}

kg_status kg_editor_new(kg_editor *e, kg_error *error) {
    kg_document *document;
    kg_model *model = kg_model_create();
    if (!model)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_document_from_model(model, NULL, &document, error);
    return status ? status : kg_editor_take(e, document, NULL, error);
}

const char *kg_editor_home(const char *path) {
    return kg_file_ends_in(path, ".fold") || kg_file_ends_in(path, ".cp") ? NULL : path;
}

kg_status kg_editor_open(kg_editor *e, const char *path, kg_error *error) {
    kg_document *document;
    kg_status status = kg_document_read(path, &document, error);
    return status ? status : kg_editor_take(e, document, kg_editor_home(path), error);
}

kg_status kg_editor_save(kg_editor *e, const char *path, kg_error *error) {
    char *copy = strdup(path ? path : e->path ? e->path : "");
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (e->before)
        kg_editor_commit(e);
    kg_status status = kg_history_store(&e->history, e->document, error);
    if (!status)
        status = kg_document_save(e->document, copy, error);
    /* the history is the file's alone: within the document it would be part of every step */
    kg_history none = {0};
    kg_error ignored;
    if (kg_history_store(&none, e->document, &ignored))
        kg_editor_say(e, KG_WARNING, "%s", ignored.message);
    if (status) {
        free(copy);
        return status;
    }
    free(e->path);
    e->path = copy;
    e->saved_state = e->autosaved_state = e->state;
    return KG_OK;
}

bool kg_editor_is_modified(const kg_editor *e) {
    return e->state != e->saved_state || e->before;
}

/* ---- life ------------------------------------------------------------------------------- */

kg_status kg_editor_init(kg_editor *e, const kg_settings *settings, kg_error *error) {
    *e = (kg_editor){.next_state = 1, .patch_opacity = 1};
    e->pane.camera = kg_camera_default();
    e->pane.area = (kg_area){0, 0, 1, 1};
    e->pane.scale = 1;
    if (kg_settings_copy(settings, &e->settings))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_editor_new(e, error);
    if (status)
        kg_editor_clear(e);
    return status;
}

void kg_editor_clear(kg_editor *e) {
    if (e->tool && e->tool->end && e->document)
        e->tool->end(e);
    kg_document_destroy(e->before);
    if (e->mode_state)
        e->mode->destroy(e->mode_state);
    kg_history_clear(&e->history);
    kg_backdrop_clear(&e->backdrop);
    kg_surfaces_clear(&e->surfaces);
    kg_document_destroy(e->document);
    kg_settings_clear(&e->settings);
    free(e->selection.patches.items);
    free(e->selection.points.items);
    free(e->tool_state);
    free(e->path);
    *e = (kg_editor){0};
}
