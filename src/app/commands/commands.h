/*
 * Everything the app can do, in one table that the menu, the palette, the keys, scripts and
 * `katagami apply` share.
 *
 * A command takes a JSON object of arguments, or NULL when it was chosen by hand; then it works on
 * the selection. docs/app.md lists the arguments of each.
 */
#ifndef KG_APP_COMMANDS_COMMANDS_H
#define KG_APP_COMMANDS_COMMANDS_H

#include "app/editor.h"

#include <jansson.h>

enum {
    KG_COMMAND_EDIT = 1,   /* changes the model and nothing else: `katagami apply` may run it */
    KG_COMMAND_HIDDEN = 2, /* has to have arguments: not in the palette */
    KG_COMMAND_ARGUMENTS = KG_COMMAND_EDIT | KG_COMMAND_HIDDEN
};

typedef struct kg_app_command {
    const char *id;
    const char *title;        /* marked for translation */
    const char *help;         /* a sentence, marked for translation */
    const char *keys;         /* chords separated by "|"; NULL: none */
    const char *blender_keys; /* NULL: the same */
    kg_status (*run)(kg_editor *editor, const json_t *arguments, kg_error *error);
    bool (*enabled)(const kg_editor *editor); /* by hand; NULL: always */
    unsigned flags;
} kg_app_command;

size_t kg_command_count(void);
const kg_app_command *kg_command_at(size_t index);
const kg_app_command *kg_command_find(const char *id); /* NULL: none */
/* Whether it can do something with such documents. */
bool kg_command_is_for(const kg_app_command *command, kg_document_kind kind);
/* The command of a key; NULL: none that is for the document. */
const kg_app_command *kg_command_of_key(const kg_editor *editor, const kg_event *event);
const char *kg_command_keys(const kg_app_command *command, kg_navigation navigation);
/* Its first chord, as menus show it; "" for none. */
void kg_command_shortcut(const kg_app_command *command, kg_navigation navigation, char out[32]);
bool kg_command_is_enabled(const kg_app_command *command, const kg_editor *editor);

/* Runs a command; a failure is also shown as a message. */
kg_status kg_command_run(const kg_app_command *command, kg_editor *editor, const json_t *arguments,
                         kg_error *error) KG_CHECKED;
/* By hand; what goes wrong is shown, and when it is not enabled what has to be selected for it. */
void kg_command_use(const kg_app_command *command, kg_editor *editor);
void kg_command_do(kg_editor *editor, const char *id);
/* With arguments, which it takes over (NULL: memory ran out); what goes wrong is shown. Whether it
 * was done. */
bool kg_command_do_with(kg_editor *editor, const char *id, json_t *arguments);

/* Tables, one per file. */
typedef struct kg_command_table {
    const kg_app_command *items;
    size_t count;
    unsigned kinds; /* of documents they are for, KG_FOR_KIND of each; 0: all */
} kg_command_table;
#define KG_FOR_KIND(kind) (1u << (kind))
extern const kg_command_table kg_fold_commands, kg_file_commands, kg_create_commands,
    kg_edit_commands, kg_select_commands, kg_reference_commands, kg_patch_commands,
    kg_move_commands, kg_net_commands, kg_part_commands, kg_trim_commands, kg_mend_commands,
    kg_view_commands, kg_sheet_commands, kg_step_commands, kg_card_commands, kg_card_view_commands;

/* What several tables ask for as `enabled`. */
bool kg_has_selection(const kg_editor *editor);
bool kg_has_two_selected(const kg_editor *editor);

#endif
