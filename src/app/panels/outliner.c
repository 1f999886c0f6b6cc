/* The list of patches. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "model/edit.h"

#include <stdio.h>

/* A display name: the patch's own, or its number. */
static void label_of(const kg_model_patch *p, char *out, size_t size) {
    if (p->name[0])
        snprintf(out, size, "%s##%lld", p->name, (long long)p->id);
    else
        snprintf(out, size, "%s %lld##%lld", _("patch"), (long long)p->id, (long long)p->id);
}

/* Runs a command on one patch, whatever is selected. */
static void run_on(kg_editor *e, const char *id, int64_t patch) {
    kg_command_do_with(e, id, json_pack("{s:I}", "patch", (json_int_t)patch));
}

static void set_color(kg_editor *e, int64_t patch, kg_color color) {
    char text[8];
    kg_error error;
    kg_color_print(color, text);
    kg_model_patch *p = kg_model_find(kg_editor_model(e), patch);
    if (kg_model_set_patch_color(p, text, &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
}

/* The colour follows the picker live; letting go ends the step. */
static void color_cell(kg_editor *e, kg_model_patch *p) {
    kg_color color = kg_patch_color(p);
    kg_error error;
    unsigned result = kg_ui_color_field("##color", &color);
    if (result & KG_FIELD_CHANGED && !kg_editor_begin(e, N_("Colour"), &error))
        set_color(e, p->id, color);
    if (result & KG_FIELD_ENDED)
        kg_editor_commit(e);
}

/* The worst that is wrong with a patch; NULL: nothing. */
static const kg_issue *issue_of(const kg_editor *e, int64_t patch) {
    const kg_solution *s = kg_editor_solution(e);
    for (size_t i = 0; i < kg_solution_issue_count(s); i++)
        if (kg_solution_issue(s, i)->patch == patch)
            return kg_solution_issue(s, i);
    return NULL;
}

/* `warns`: some patch has a warning, so there is a column for them. */
static void row(kg_app *app, size_t index, bool warns) {
    kg_editor *e = &app->editor;
    kg_model_patch *p = &kg_editor_model(e)->patches[index];
    int64_t id = p->id;
    const char *command = NULL; /* run at the end: it may put back a copy of the model */
    const kg_issue *issue = issue_of(e, id);
    char label[300], number[24];
    int rank = kg_editor_selection_rank(e, id);
    kg_ui_id_push(id);
    kg_ui_table_row();
    kg_ui_table_next();
    if (kg_ui_icon_button("visible", p->hidden ? KG_ICON_EYE_OFF : KG_ICON_EYE, false, 0))
        command = "patch.hide";
    kg_ui_tooltip(_("Show or hide"));
    kg_ui_table_next();
    color_cell(e, p);
    kg_ui_table_next();
    snprintf(number, sizeof number, "%lld", (long long)id);
    kg_ui_text_dim(number);
    kg_ui_table_next();
    label_of(p, label, sizeof label);
    if (rank >= 0)
        kg_ui_mark(kg_rank_color(rank));
    double room = kg_ui_available();
    if (kg_ui_selectable(label, rank >= 0))
        kg_editor_select(e, id, e->mods & (KG_MOD_SHIFT | KG_MOD_CTRL));
    if (kg_ui_item_hovered())
        e->hover_patch = id;
    if (kg_ui_item_double_clicked()) {
        kg_editor_select(e, id, false);
        e->request = KG_REQUEST_RENAME;
    }
    if (issue)
        kg_ui_tooltip(issue->message);
    else if (kg_ui_text_width(p->name) > room)
        kg_ui_tooltip(p->name);
    if (warns)
        kg_ui_table_next();
    if (issue) {
        kg_ui_icon(KG_ICON_WARNING, kg_panel_severity_color(e, issue->severity));
        kg_ui_tooltip(issue->message);
    }
    kg_ui_table_next();
    if (kg_ui_icon_button("construction", KG_ICON_GUIDE, p->construction, 0))
        command = "patch.construction";
    kg_ui_tooltip(_("Construction: cuts others but is in no net"));
    kg_ui_table_next();
    if (kg_ui_icon_button("flip", KG_ICON_FLIP, false, 0))
        command = "patch.flip";
    kg_ui_tooltip(_("Flip side"));
    kg_ui_id_pop();
    if (command)
        run_on(e, command, id);
}

void kg_panel_outliner(kg_app *app, kg_area area) {
    static const double widths[] = {22, 24, 22, 0, 24, 24, 24};
    const kg_model *m = kg_editor_model(&app->editor);
    bool warns = false;
    for (size_t i = 0; i < m->patch_count && !warns; i++)
        warns = issue_of(&app->editor, m->patches[i].id);
    char title[64];
    snprintf(title, sizeof title, _("Patches (%zu)"), m->patch_count);
    kg_ui_panel_begin("outliner", title, area, 0);
    if (m->patch_count == 0)
        kg_ui_text_wrapped(_("No patches yet. Press A and click four times to place one."));
    if (m->patch_count > 0 && kg_ui_table_begin("patches", warns ? 7 : 6, widths)) {
        for (size_t i = 0; i < m->patch_count; i++)
            row(app, i, warns);
        kg_ui_table_end();
    }
    kg_ui_panel_end();
}
