/* Commands: selecting patches and their points. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"

#include <stdlib.h>

static kg_status select_all(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_editor_select_none(e);
    const kg_model *m = kg_editor_model(e);
    for (size_t i = 0; i < m->patch_count; i++)
        if (!m->patches[i].hidden)
            kg_editor_select(e, m->patches[i].id, true);
    return KG_OK;
}

static kg_status select_none(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_editor_select_none(e);
    return KG_OK;
}

static kg_status select_patches(kg_editor *e, const json_t *a, kg_error *error) {
    int64_t *ids;
    size_t count;
    kg_status status = kg_argument_patches(e, a, &ids, &count, error);
    if (status)
        return status;
    kg_editor_select_none(e);
    for (size_t i = 0; i < count; i++)
        if (!kg_editor_is_selected(e, ids[i]))
            kg_editor_select(e, ids[i], true);
    free(ids);
    return KG_OK;
}

static kg_status select_point(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model_patch *p;
    size_t index = 0;
    kg_status status = kg_argument_patch(e, a, &p, error);
    if (!status)
        status = kg_argument_index(a, "point", &index, error);
    if (!status && index >= p->input.point_count)
        status =
            kg_fail(error, KG_ERR_INPUT, "patch %lld has no point %zu", (long long)p->id, index);
    if (status)
        return status;
    e->level = KG_LEVEL_POINTS;
    if (!kg_editor_is_selected(e, p->id))
        kg_editor_select(e, p->id, false);
    kg_editor_select_point(e, (kg_point_ref){p->id, index}, false);
    return KG_OK;
}

static kg_status toggle_level(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    e->level = e->level == KG_LEVEL_POINTS ? KG_LEVEL_PATCHES : KG_LEVEL_POINTS;
    e->selection.points.count = 0;
    return KG_OK;
}

static const kg_app_command items[] = {
    {"select.all", N_("Select all"), N_("Selects all patches that are shown."), "Ctrl+A", NULL,
     select_all, NULL, 0},
    {"select.none", N_("Select none"), N_("Selects nothing."), "Ctrl+Shift+A", "Alt+A", select_none,
     kg_has_selection, 0},
    {"select.patches", N_("Select patches"), N_("Selects the patches named."), NULL, NULL,
     select_patches, NULL, KG_COMMAND_ARGUMENTS},
    {"select.point", N_("Select point"), N_("Selects one control point."), NULL, NULL, select_point,
     NULL, KG_COMMAND_ARGUMENTS},
    {"select.level", N_("Points or patches"),
     N_("Changes between moving control points and moving whole patches."), "Tab", NULL,
     toggle_level, NULL, 0},
};
const kg_command_table kg_select_commands = {items, sizeof items / sizeof *items,
                                             KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
