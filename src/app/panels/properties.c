/* What the first selected patch is made of, in numbers; without one, the model. */
#include "app/commands/commands.h"
#include "app/commands/mend.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "model/edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FARTHEST 1e6

/* A field whose value is the model's own: begins, follows and ends the step. True when changed. */
static bool follow(kg_editor *e, unsigned result, const char *label) {
    kg_error error;
    if (result & KG_FIELD_CHANGED) {
        if (kg_editor_begin(e, label, &error)) {
            kg_editor_say(e, KG_FAULT, "%s", error.message);
            return false;
        }
        kg_editor_touch(e);
    }
    return result & KG_FIELD_CHANGED;
}

static void end_field(kg_editor *e, unsigned result) {
    if (result & (KG_FIELD_ENDED | KG_FIELD_LEFT))
        kg_editor_commit(e);
}

/* A number of the model: the step begins with the value before the field changed it. */
static void number(kg_editor *e, const char *label, double *value, double speed, double lo,
                   double hi, const char *format, const char *step) {
    double shown = *value;
    unsigned result = kg_ui_number(label, &shown, speed, lo, hi, format);
    if (follow(e, result, step))
        *value = shown;
    end_field(e, result);
}

/* ---- a patch ---------------------------------------------------------------------------- */

static void show_points(kg_editor *e, kg_model_patch *p) {
    static const double widths[] = {18, 0, 0, 0};
    static const char *const axes[] = {"##x", "##y", "##z"};
    if (!kg_ui_section(_("Control points"), true) || !kg_ui_table_begin("points", 4, widths))
        return;
    for (size_t i = 0; i < p->input.point_count; i++) {
        kg_point_ref ref = {p->id, i};
        char name[24];
        kg_ui_id_push((int64_t)i);
        kg_ui_table_row();
        kg_ui_table_next();
        snprintf(name, sizeof name, "%zu", i + 1);
        if (kg_editor_is_point_selected(e, ref))
            kg_ui_text(name);
        else
            kg_ui_text_dim(name);
        double *coordinates[] = {&p->input.points[i].x, &p->input.points[i].y,
                                 &p->input.points[i].z};
        for (int k = 0; k < 3; k++) {
            kg_ui_table_next();
            kg_ui_width(-1);
            number(e, axes[k], coordinates[k], 0.1, -FARTHEST, FARTHEST, "%.2f", N_("Move point"));
        }
        kg_ui_id_pop();
    }
    kg_ui_table_end();
}

static void show_extent(kg_editor *e, kg_model_patch *p, const kg_solved_patch *s) {
    static const double widths[] = {0, 0};
    if (!kg_ui_section(_("Extent"), true) || !kg_ui_table_begin("extent", 2, widths))
        return;
    double lo = p->input.extent[0], hi = p->input.extent[1];
    kg_ui_table_row();
    kg_ui_table_next();
    kg_ui_width(-1);
    number(e, "##lo", &p->input.extent[0], 0.1, -FARTHEST, hi - 0.01, "%.2f mm", N_("Extent"));
    kg_ui_table_next();
    kg_ui_width(-1);
    number(e, "##hi", &p->input.extent[1], 0.1, lo + 0.01, FARTHEST, "%.2f mm", N_("Extent"));
    kg_ui_table_end();
    if (s && s->prepared) {
        char text[160];
        double degree = 180 / KG_PI;
        snprintf(text, sizeof text, _("%.1f mm long, rulings at %.0f°–%.0f°"),
                 kg_patch_length(&s->patch, 1), s->patch.theta[0] * degree,
                 s->patch.theta[1] * degree);
        kg_ui_text_dim(text);
    }
}

/* What a trim does, in a few words. */
static void describe(const kg_model *m, const kg_trim_op *op, char *out, size_t size) {
    if (op->kind == KG_TRIM_CONTOUR) {
        snprintf(out, size, op->outside ? _("hole, %zu corners") : _("contour, %zu corners"),
                 op->contour_count);
        return;
    }
    int n = snprintf(out, size, "%s", op->kind == KG_TRIM_INSIDE ? _("inside") : _("by"));
    for (size_t i = 0; i < op->by_count && n > 0 && (size_t)n < size; i++) {
        const kg_model_patch *cutter = kg_model_find(m, op->by[i]);
        bool named = cutter && cutter->name[0];
        n += snprintf(out + n, size - (size_t)n, "%s %lld%s%s", i > 0 ? "," : "",
                      (long long)op->by[i], named ? " " : "", named ? cutter->name : "");
    }
}

static void show_trim(kg_editor *e, const kg_model_patch *p, size_t index) {
    const kg_trim_op *op = &p->trims[index];
    json_int_t id = p->id, n = (json_int_t)index;
    char text[128], tip[320];
    bool on = !op->off, bounded = op->bounded, is_contour = op->kind == KG_TRIM_CONTOUR;
    size_t count = p->trim_count;
    json_t *change = NULL;
    const char *command = "trim.set";
    kg_ui_id_push((int64_t)index);
    kg_ui_table_row();
    kg_ui_table_next();
    describe(kg_editor_model(e), op, text, sizeof text);
    if (kg_ui_check(text, &on))
        change = json_pack("{s:I,s:I,s:b}", "patch", id, "trim", n, "off", !on);
    snprintf(tip, sizeof tip, "%s\n%s", text,
             _("Switched off, a trim stays in the list but cuts nothing."));
    kg_ui_tooltip(tip);
    kg_ui_table_next();
    if (!is_contour) {
        if (kg_ui_icon_button("bounded", KG_ICON_CONTOUR, bounded, 0))
            change = json_pack("{s:I,s:I,s:b}", "patch", id, "trim", n, "bounded", !bounded);
        kg_ui_tooltip(
            _("Cut only with what is left of the cutters, not with their whole rectangles"));
    }
    kg_ui_table_next();
    kg_ui_disabled_begin(index == 0);
    if (kg_ui_icon_button("earlier", KG_ICON_UP, false, 0)) {
        command = "trim.move";
        change = json_pack("{s:I,s:I,s:I}", "patch", id, "trim", n, "to", n - 1);
    }
    kg_ui_tooltip(_("Trim earlier"));
    kg_ui_disabled_end();
    kg_ui_table_next();
    kg_ui_disabled_begin(index + 1 == count);
    if (kg_ui_icon_button("later", KG_ICON_DOWN, false, 0)) {
        command = "trim.move";
        change = json_pack("{s:I,s:I,s:I}", "patch", id, "trim", n, "to", n + 1);
    }
    kg_ui_tooltip(_("Trim later"));
    kg_ui_disabled_end();
    kg_ui_table_next();
    if (kg_ui_icon_button("remove trim", KG_ICON_REMOVE, false, 0)) {
        command = "trim.remove";
        change = json_pack("{s:I,s:I}", "patch", id, "trim", n);
    }
    kg_ui_tooltip(_("Remove this trim"));
    kg_ui_id_pop();
    if (change)
        kg_command_do_with(e, command, change);
}

static void show_trims(kg_editor *e, int64_t id) {
    static const double widths[] = {0, 24, 24, 24, 24};
    if (!kg_ui_section(_("Trims"), true))
        return;
    kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    if (p->trim_count == 0)
        kg_ui_text_dim(_("none"));
    else if (kg_ui_table_begin("trims", 5, widths)) {
        for (size_t i = 0; (p = kg_model_find(kg_editor_model(e), id)) && i < p->trim_count; i++)
            show_trim(e, p, i);
        kg_ui_table_end();
    }
    kg_ui_check(_("Trim inside also trims the cutters"), &e->trim_cutters);
}

/* What an edit would do, in a few words. */
static void describe_mend(const kg_mend *mend, char *out, size_t size) {
    if (strcmp(mend->command, "patch.narrow") == 0)
        snprintf(out, size, _("to %.1f … %.1f mm"), mend->extent[0], mend->extent[1]);
    else
        snprintf(out, size, _("by %.1f mm"), mend->movement);
}

/* Buttons for the edits that would mend the rulings; returns the command of one that is pressed.
 * None while a gesture goes on: trying them takes longer than a frame. */
static const char *show_mends(kg_editor *e, int64_t patch) {
    const char *pressed = NULL;
    char text[96];
    if (e->before)
        return NULL;
    kg_mend_offer(e, patch);
    for (size_t i = 0; i < e->mends.count; i++) {
        const kg_mend *mend = &e->mends.items[i];
        const kg_app_command *command = kg_command_find(mend->command);
        if (kg_ui_button(_(command->title)))
            pressed = mend->command;
        kg_ui_tooltip(_(command->help));
        kg_ui_same_line();
        describe_mend(mend, text, sizeof text);
        kg_ui_text_dim(text);
    }
    return pressed;
}

static bool is_of_rulings(const kg_issue *issue) {
    return strcmp(issue->code, "extent-clamped") == 0 || strcmp(issue->code, "flat-ruling") == 0 ||
           strcmp(issue->code, "bad-patch") == 0;
}

static void show_issues(kg_editor *e, int64_t patch) {
    const kg_solution *s = kg_editor_solution(e);
    bool bad_rulings = false;
    for (size_t i = 0; i < kg_solution_issue_count(s); i++) {
        const kg_issue *issue = kg_solution_issue(s, i);
        if (issue->patch != patch)
            continue;
        kg_ui_space();
        kg_ui_text_color(kg_panel_severity_color(e, issue->severity),
                         issue->severity == KG_FAULT ? _("Fault") : _("Warning"));
        kg_ui_text_wrapped(issue->message);
        bad_rulings = bad_rulings || is_of_rulings(issue);
    }
    /* run at the end: it solves anew */
    const char *command = bad_rulings ? show_mends(e, patch) : NULL;
    if (command)
        kg_command_do_with(e, command, json_pack("{s:I}", "patch", (json_int_t)patch));
}

static void show_patch(kg_app *app, int64_t id) {
    kg_editor *e = &app->editor;
    char title[320];
    const char *name = kg_model_find(kg_editor_model(e), id)->name;
    if (name[0])
        snprintf(title, sizeof title, "%lld  %s", (long long)id, name);
    else
        snprintf(title, sizeof title, _("patch %lld"), (long long)id);
    kg_ui_text(title);
    kg_ui_id_push(id);
    show_issues(e, id);
    kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), id);
    show_points(e, p);
    show_extent(e, p, s);
    show_trims(e, id);
    kg_ui_id_pop();
}

/* ---- the model -------------------------------------------------------------------------- */

/* As large as the reference is shown: in a file without a size, the mesh has its own. */
static double longest_side(const kg_editor *e, const kg_reference *ref) {
    if (ref->size_mm > 0 || !e->backdrop.mesh)
        return ref->size_mm;
    kg_box3 box = kg_mesh_bounds(e->backdrop.mesh);
    kg_vec3 size = kg_sub(box.hi, box.lo);
    return fmax(size.x, fmax(size.y, size.z));
}

static void show_reference(kg_editor *e) {
    if (!kg_ui_section(_("Reference"), true))
        return;
    kg_reference *ref = &kg_editor_model(e)->reference;
    const char *slash = ref->file ? strrchr(ref->file, '/') : NULL;
    if (kg_ui_button(ref->file ? _("Change…") : _("Choose a mesh…")))
        e->request = KG_REQUEST_REFERENCE;
    if (!ref->file)
        return;
    kg_ui_same_line();
    kg_ui_text_dim(slash ? slash + 1 : ref->file);
    kg_ui_tooltip(ref->file);
    double opacity = ref->opacity, size = longest_side(e, ref);
    kg_ui_width(150);
    unsigned result = kg_ui_slider(_("opacity"), &opacity, 0, 1, "%.2f");
    if (follow(e, result, N_("Reference opacity")))
        kg_editor_model(e)->reference.opacity = opacity;
    end_field(e, result);
    bool up_y = ref->up_y;
    if (kg_ui_check(_("y points up in the mesh"), &up_y))
        kg_command_do_with(e, "reference.set", json_pack("{s:s}", "up", up_y ? "y" : "z"));
    kg_ui_width(150);
    result = kg_ui_number(_("longest side"), &size, 1, 0, 1e5, size < 1 ? "%.3f mm" : "%.1f mm");
    kg_ui_tooltip(_("As large as this the model gets on paper. Double click to type a size; 0: as "
                    "large as the mesh is in its file."));
    if (follow(e, result, N_("Reference size")))
        kg_editor_model(e)->reference.size_mm = size;
    if (result & KG_FIELD_ENDED) {
        kg_editor_commit(e);
        kg_editor_load_reference(e);
    }
}

static void show_mirror(kg_editor *e) {
    static const char *const planes[] = {"x", "y", "z"};
    kg_mirror_plane plane = kg_editor_model(e)->mirror;
    kg_ui_width(150);
    if (kg_ui_choice(_("mirror across"), planes, 3, &plane.axis))
        kg_command_do_with(e, "mirror.set", json_pack("{s:s}", "across", planes[plane.axis]));
    kg_ui_width(150);
    unsigned result = kg_ui_number(_("mirror at"), &plane.at, 0.5, -1e5, 1e5, "%.2f mm");
    kg_ui_tooltip(_("Where the plane of the mirror meets its axis."));
    if (follow(e, result, N_("Mirror plane")))
        kg_editor_model(e)->mirror = plane;
    end_field(e, result);
}

static void show_view(kg_editor *e) {
    if (!kg_ui_section(_("Tools"), true))
        return;
    kg_ui_width(150);
    kg_ui_slider(_("patch opacity"), &e->patch_opacity, 0.1, 1, "%.2f");
    kg_ui_width(150);
    kg_ui_number(_("lift off reference"), &e->settings.lift, 0.05, -100, 100, "%.2f mm");
    kg_ui_tooltip(_("How far new control points lie off the reference."));
    kg_ui_width(150);
    kg_ui_number(_("step with Ctrl"), &e->settings.step, 0.1, 0.01, 100, "%.2f mm");
    kg_ui_tooltip(_("With Ctrl, what is dragged moves by whole steps of this."));
    show_mirror(e);
}

void kg_panel_properties(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    int64_t id = kg_editor_first_selected(e);
    kg_ui_panel_begin("properties", _("Properties"), area, 0);
    kg_ui_subject(id);
    if (id)
        show_patch(app, id);
    show_reference(e);
    show_view(e);
    kg_ui_panel_end();
}
