#include "app/commands/commands.h"

#include "app/mode.h"
#include "app/text.h"

#include <stdio.h>
#include <string.h>

static const kg_command_table *const tables[] = {
    &kg_fold_commands,     &kg_step_commands, &kg_sheet_commands,  &kg_file_commands,
    &kg_create_commands,   &kg_edit_commands, &kg_select_commands, &kg_reference_commands,
    &kg_patch_commands,    &kg_move_commands, &kg_net_commands,    &kg_part_commands,
    &kg_trim_commands,     &kg_mend_commands, &kg_view_commands,   &kg_card_commands,
    &kg_card_view_commands};
enum { TABLE_COUNT = sizeof tables / sizeof *tables };

size_t kg_command_count(void) {
    size_t count = 0;
    for (size_t i = 0; i < TABLE_COUNT; i++)
        count += tables[i]->count;
    return count;
}

const kg_app_command *kg_command_at(size_t index) {
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        if (index < tables[i]->count)
            return &tables[i]->items[index];
        index -= tables[i]->count;
    }
    return NULL;
}

const kg_app_command *kg_command_find(const char *id) {
    for (size_t i = 0; i < kg_command_count(); i++)
        if (strcmp(kg_command_at(i)->id, id) == 0)
            return kg_command_at(i);
    return NULL;
}

bool kg_command_is_for(const kg_app_command *command, kg_document_kind kind) {
    for (size_t i = 0; i < TABLE_COUNT; i++)
        if (command >= tables[i]->items && command < tables[i]->items + tables[i]->count)
            return tables[i]->kinds == 0 || tables[i]->kinds & KG_FOR_KIND(kind);
    return false;
}

/* ---- keys ------------------------------------------------------------------------------- */

const char *kg_command_keys(const kg_app_command *command, kg_navigation navigation) {
    return navigation == KG_NAVIGATION_BLENDER && command->blender_keys ? command->blender_keys
                                                                        : command->keys;
}

/* Copies the chord at `keys` and returns where the next one begins, NULL at the end. */
static const char *next_chord(const char *keys, char out[32]) {
    size_t n = strcspn(keys, "|");
    snprintf(out, 32, "%.*s", (int)n, keys);
    return keys[n] ? keys + n + 1 : NULL;
}

void kg_command_shortcut(const kg_app_command *command, kg_navigation navigation, char out[32]) {
    const char *keys = kg_command_keys(command, navigation);
    out[0] = '\0';
    if (keys)
        next_chord(keys, out);
}

const kg_app_command *kg_command_of_key(const kg_editor *e, const kg_event *event) {
    for (size_t i = 0; i < kg_command_count(); i++) {
        const kg_app_command *command = kg_command_at(i);
        if (!kg_command_is_for(command, kg_document_get_kind(e->document)))
            continue;
        const char *keys = kg_command_keys(command, e->settings.navigation);
        while (keys) {
            char text[32];
            kg_chord chord;
            keys = next_chord(keys, text);
            if (kg_chord_parse(text, &chord) && chord.key == event->key &&
                chord.mods == event->mods)
                return command;
        }
    }
    return NULL;
}

/* ---- running ---------------------------------------------------------------------------- */

bool kg_command_is_enabled(const kg_app_command *command, const kg_editor *e) {
    return kg_command_is_for(command, kg_document_get_kind(e->document)) &&
           (!command->enabled || command->enabled(e));
}

kg_status kg_command_run(const kg_app_command *command, kg_editor *e, const json_t *arguments,
                         kg_error *error) {
    /* what a tool has begun gives way, but for looking at it from elsewhere */
    if (e->before && strncmp(command->id, "view.", 5) != 0)
        kg_editor_use_default(e);
    kg_editor_update(e);
    kg_status status = kg_command_is_for(command, kg_document_get_kind(e->document))
                           ? command->run(e, arguments, error)
                           : kg_fail(error, KG_ERR_INPUT, _("%s does nothing with a %s"),
                                     command->id, _(e->mode->title));
    if (status)
        kg_editor_say(e, KG_FAULT, "%s", error->message);
    if (status && status != KG_ERR_INPUT) /* a file, or the machine: not seen in the model */
        e->request = KG_REQUEST_ERROR;
    kg_editor_update(e);
    return status;
}

void kg_command_use(const kg_app_command *command, kg_editor *e) {
    kg_error error;
    if (kg_command_is_enabled(command, e)) {
        if (kg_command_run(command, e, NULL, &error))
            return; /* it has been shown */
    } else if (command->enabled == kg_has_selection) {
        kg_editor_say(e, KG_WARNING, _("%s: select a patch first."), _(command->title));
    } else if (command->enabled == kg_has_two_selected) {
        kg_editor_say(e, KG_WARNING,
                      _("%s: select the patch to trim, then with Shift its cutters."),
                      _(command->title));
    }
}

void kg_command_do(kg_editor *e, const char *id) {
    const kg_app_command *command = kg_command_find(id);
    if (command)
        kg_command_use(command, e);
}

bool kg_command_do_with(kg_editor *e, const char *id, json_t *arguments) {
    kg_error error;
    bool done = arguments && !kg_command_run(kg_command_find(id), e, arguments, &error);
    if (!arguments)
        kg_editor_say(e, KG_FAULT, "%s", _("Out of memory."));
    json_decref(arguments);
    return done;
}

bool kg_has_selection(const kg_editor *e) {
    return e->selection.patches.count > 0;
}
bool kg_has_two_selected(const kg_editor *e) {
    return e->selection.patches.count > 1;
}
