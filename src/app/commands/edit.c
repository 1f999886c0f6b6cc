/* Commands: history, and the windows that help. */
#include "app/commands/commands.h"
#include "app/text.h"

static kg_status undo(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_editor_undo(e);
    return KG_OK;
}

static kg_status redo(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_editor_redo(e);
    return KG_OK;
}

static bool can_undo(const kg_editor *e) {
    return !e->before && e->history.undo.count > 0;
}
static bool can_redo(const kg_editor *e) {
    return !e->before && e->history.redo.count > 0;
}

static kg_status cancel(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_editor_use_default(e);
    return KG_OK;
}

static kg_status palette(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->request = KG_REQUEST_PALETTE;
    return KG_OK;
}

static kg_status help(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->request = KG_REQUEST_HELP;
    return KG_OK;
}

static kg_status preferences(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->request = KG_REQUEST_SETTINGS;
    return KG_OK;
}

static const kg_app_command items[] = {
    {"edit.undo", N_("Undo"), N_("Takes back the last step."), "Ctrl+Z", NULL, undo, can_undo, 0},
    {"edit.redo", N_("Redo"), N_("Does again what was taken back."), "Ctrl+Y|Ctrl+Shift+Z", NULL,
     redo, can_redo, 0},
    {"edit.cancel", N_("Cancel"), N_("Ends what the tool is doing."), "Esc", NULL, cancel, NULL, 0},
    {"edit.palette", N_("Commands…"), N_("Finds a command by its name."), "Ctrl+P", "Ctrl+P|F3",
     palette, NULL, 0},
    {"edit.settings", N_("Preferences…"), N_("Language, navigation, theme and more."), "Ctrl+,",
     NULL, preferences, NULL, 0},
    {"edit.help", N_("Keys and mouse…"), N_("Shows what keys and mouse do."), "F1", NULL, help,
     NULL, 0},
};
const kg_command_table kg_edit_commands = {items, sizeof items / sizeof *items, 0};
