#include "app/run.h"

#include "app/commands/commands.h"
#include "app/headless.h"
#include "app/window.h"
#include "base/file.h"

#include <stdlib.h>

kg_run_options kg_run_options_default(void) {
    return (kg_run_options){.width = 1280, .height = 800, .scale = 1};
}

kg_status kg_run(const kg_run_options *o, kg_error *error) {
    return o->headless ? kg_headless_run(o, error) : kg_window_run(o, error);
}

/* ---- edits from a file ------------------------------------------------------------------ */

static kg_status apply_one(kg_editor *e, const json_t *edit, kg_error *error) {
    const char *id = json_string_value(json_object_get(edit, "command"));
    const kg_app_command *command = id ? kg_command_find(id) : NULL;
    if (!id)
        return kg_fail(error, KG_ERR_INPUT, "an edit is an object with a \"command\"");
    if (!command || !(command->flags & KG_COMMAND_EDIT))
        return kg_fail(error, KG_ERR_INPUT, "\"%s\" is no command that edits models", id);
    kg_status status = kg_command_run(command, e, edit, error);
    return status ? kg_fail_in(error, status, "%s: ", id) : KG_OK;
}

static kg_status apply_all(kg_editor *e, const json_t *list, const char *name, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        status = apply_one(e, json_array_get(list, i), error);
        if (status)
            kg_fail_in(error, status, "%s: edit %zu: ", name, i + 1);
    }
    return status;
}

static kg_status read_edits(const char *path, json_t **out_list, kg_error *error) {
    char *text;
    size_t size;
    json_error_t wrong;
    kg_status status = kg_file_read(path, &text, &size, error);
    if (status)
        return status;
    json_t *list = json_loadb(text, size, JSON_REJECT_DUPLICATES, &wrong);
    free(text);
    if (!list)
        return kg_fail(error, KG_ERR_PARSE, "%s:%d: %s", path, wrong.line, wrong.text);
    if (!json_is_array(list)) {
        json_decref(list);
        return kg_fail(error, KG_ERR_PARSE, "%s: a list of edits is wanted: [{\"command\": …}, …]",
                       path);
    }
    *out_list = list;
    return KG_OK;
}

kg_status kg_apply(const char *model, const char *edits, const char *output, kg_error *error) {
    kg_settings settings;
    kg_editor editor;
    json_t *list = NULL;
    kg_settings_default(&settings);
    kg_status status = kg_editor_init(&editor, &settings, error);
    if (status)
        return status;
    status = kg_editor_open(&editor, model, error);
    if (!status)
        status = read_edits(edits, &list, error);
    if (!status)
        status = apply_all(&editor, list, edits, error);
    if (!status)
        status = kg_editor_save(&editor, output, error);
    json_decref(list);
    kg_editor_clear(&editor);
    return status;
}
