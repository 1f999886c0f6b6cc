/* Commands: trims of patches. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "app/tools/tools.h"
#include "model/edit.h"

#include <stdlib.h>
#include <string.h>

static void clear_op(kg_trim_op *op) {
    free(op->by);
    free(op->keep);
    free(op->contour);
}

/* Adds a trim to a step already open; what the solution finds wrong with it is the error. Takes
 * over the arrays of `op`. */
static kg_status add_and_solve(kg_editor *e, int64_t patch, kg_trim_op *op, kg_error *error) {
    kg_status status = kg_model_add_trim(kg_editor_model(e), patch, op, error);
    if (status)
        return status;
    kg_editor_touch(e);
    kg_editor_update(e);
    const kg_solution *s = kg_editor_solution(e);
    for (size_t i = 0; i < kg_solution_issue_count(s); i++) {
        const kg_issue *issue = kg_solution_issue(s, i);
        if (issue->severity == KG_FAULT && issue->patch == patch)
            return kg_fail(error, KG_ERR_INPUT, "patch %lld: %s", (long long)patch, issue->message);
    }
    return KG_OK;
}

/* ---- by other patches ------------------------------------------------------------------- */

static kg_status read_ids(const json_t *a, kg_trim_op *op, kg_error *error) {
    const json_t *by = json_object_get(a, "by");
    size_t count = json_is_integer(by) ? 1 : json_array_size(by);
    op->by = calloc(count + 1, sizeof *op->by);
    if (!op->by)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    op->by_count = count;
    for (size_t i = 0; i < count; i++)
        op->by[i] = json_integer_value(json_is_integer(by) ? by : json_array_get(by, i));
    return count > 0 ? KG_OK : kg_fail(error, KG_ERR_INPUT, "\"by\" has to name the cutters");
}

static kg_status read_keep(const json_t *a, kg_trim_op *op, kg_error *error) {
    double *numbers;
    size_t count;
    kg_status status = kg_argument_rows(a, "keep", 3, &numbers, &count, error);
    if (status)
        return status;
    free(op->keep);
    op->keep = (kg_vec3 *)numbers; /* three numbers each */
    op->keep_count = count;
    return KG_OK;
}

static kg_status read_op(const json_t *a, kg_trim_op *op, kg_error *error) {
    kg_status status = read_ids(a, op, error);
    if (!status && json_object_get(a, "keep"))
        status = read_keep(a, op, error);
    if (!status)
        status = kg_argument_bool(a, "bounded", &op->bounded, error);
    if (!status)
        status = kg_argument_bool(a, "trim_cutters", &op->trim_cutters, error);
    return status;
}

/* The first selected patch is trimmed, the others trim it. */
static kg_status op_of_selection(const kg_editor *e, kg_trim_op *op, kg_error *error) {
    size_t count = e->selection.patches.count - 1;
    op->by = calloc(count + 1, sizeof *op->by);
    if (!op->by)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    memcpy(op->by, e->selection.patches.items + 1, count * sizeof *op->by);
    op->by_count = count;
    return KG_OK;
}

/* The selected cutters trim the first selected patch, one after the other: a step each, its piece
 * being chosen before the next. Those that cut nothing are passed over, unless they are all. */
static kg_status trim_by_selected(kg_editor *e, kg_error *error) {
    int64_t id = kg_editor_first_selected(e);
    size_t count = e->selection.patches.count;
    kg_status status = KG_OK;
    for (size_t i = 1; i < count; i++) {
        kg_trim_op op = {.kind = KG_TRIM_BY, .by_count = 1, .by = malloc(sizeof *op.by)};
        if (!op.by)
            return kg_fail(error, KG_ERR_MEMORY, "out of memory");
        op.by[0] = e->selection.patches.items[i];
        status = kg_editor_begin(e, N_("Trim"), error);
        if (status) {
            clear_op(&op);
            return status;
        }
        status = add_and_solve(e, id, &op, error);
        if (!status)
            return kg_tool_start_pieces(e, id, e->selection.patches.items + i + 1, count - i - 1,
                                        error);
        status = kg_editor_finish(e, status);
        if (i + 1 < count && error)
            kg_editor_say(e, KG_WARNING, "%s", error->message);
    }
    return status;
}

static kg_status trim_by(kg_editor *e, const json_t *a, kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_BY};
    kg_model_patch *p;
    if (!a)
        return kg_has_two_selected(e) ? trim_by_selected(e, error) : kg_tool_start_cutter(e, error);
    kg_status status = kg_argument_patch(e, a, &p, error);
    if (status)
        return status;
    int64_t id = p->id;
    status = read_op(a, &op, error);
    if (!status && op.by_count != 1)
        status = kg_fail(error, KG_ERR_INPUT,
                         "one patch trims another: \"by\" has to be one (several cutters: "
                         "trim.inside)");
    if (!status)
        status = kg_editor_begin(e, N_("Trim"), error);
    if (status) {
        clear_op(&op);
        return status;
    }
    return kg_editor_finish(e, add_and_solve(e, id, &op, error));
}

static kg_status trim_inside(kg_editor *e, const json_t *a, kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_INSIDE, .trim_cutters = e->trim_cutters && !a};
    kg_model_patch *p;
    kg_status status = kg_argument_patch(e, a, &p, error);
    if (status)
        return status;
    int64_t id = p->id;
    status = a ? read_op(a, &op, error) : op_of_selection(e, &op, error);
    if (!status)
        status = kg_editor_begin(e, N_("Trim inside"), error);
    if (status) {
        clear_op(&op);
        return status;
    }
    status = add_and_solve(e, id, &op, error);
    /* by hand, the face can be shown with a click, if that is what is missing; the message names
     * the file's key for it in every language */
    if (status && !a && strstr(error->message, "keep"))
        return kg_tool_start_face(e, id, error);
    status = kg_editor_finish(e, status);
    if (!status && !a)
        kg_editor_select(e, id, false);
    return status;
}

/* ---- contours --------------------------------------------------------------------------- */

static kg_status trim_contour(kg_editor *e, const json_t *a, kg_error *error) {
    kg_trim_op op = {.kind = KG_TRIM_CONTOUR};
    kg_model_patch *p;
    const char *keep = "inside";
    kg_status status = kg_argument_patch(e, a, &p, error);
    if (status)
        return status;
    int64_t id = p->id;
    if (!a)
        return kg_tool_start_contour(e, id, error);
    double *corners;
    status = kg_argument_rows(a, "contour", 2, &corners, &op.contour_count, error);
    if (status)
        return status;
    op.contour = (kg_vec2 *)corners; /* two numbers each */
    status = kg_argument_text(a, "keep", &keep, error);
    if (!status && strcmp(keep, "inside") != 0 && strcmp(keep, "outside") != 0)
        status = kg_fail(error, KG_ERR_INPUT, "\"keep\" has to be \"inside\" or \"outside\"");
    op.outside = strcmp(keep, "outside") == 0;
    if (!status)
        status = kg_editor_begin(e, N_("Contour"), error);
    if (status) {
        clear_op(&op);
        return status;
    }
    return kg_editor_finish(e, add_and_solve(e, id, &op, error));
}

/* ---- the list --------------------------------------------------------------------------- */

static kg_status find_trim(kg_editor *e, const json_t *a, kg_model_patch **out_patch,
                           size_t *out_index, kg_error *error) {
    size_t index = 0;
    kg_status status = kg_argument_patch(e, a, out_patch, error);
    if (!status)
        status = kg_argument_index(a, "trim", &index, error);
    if (!status && index >= (*out_patch)->trim_count)
        status = kg_fail(error, KG_ERR_INPUT, "patch %lld has %zu trims, counted from 0",
                         (long long)(*out_patch)->id, (*out_patch)->trim_count);
    *out_index = index;
    return status;
}

static kg_status remove_trim(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model_patch *p;
    size_t index;
    kg_status status = find_trim(e, a, &p, &index, error);
    if (!status)
        status = kg_editor_begin(e, N_("Remove trim"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, kg_model_remove_trim(kg_editor_model(e), p->id, index, error));
}

static kg_status move_trim(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model_patch *p;
    size_t index, to = 0;
    kg_status status = find_trim(e, a, &p, &index, error);
    if (!status)
        status = kg_argument_index(a, "to", &to, error);
    if (!status)
        status = kg_editor_begin(e, N_("Reorder trims"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, kg_model_move_trim(kg_editor_model(e), p->id, index, to, error));
}

/* Switches, and the pieces that stay: "off", "bounded", "trim_cutters", "outside", "keep". */
static kg_status set_fields(kg_trim_op *op, const json_t *a, kg_error *error) {
    kg_trim_op changed = *op;
    kg_status status = kg_argument_bool(a, "off", &changed.off, error);
    if (!status)
        status = kg_argument_bool(a, "bounded", &changed.bounded, error);
    if (!status)
        status = kg_argument_bool(a, "trim_cutters", &changed.trim_cutters, error);
    if (!status)
        status = kg_argument_bool(a, "outside", &changed.outside, error);
    bool of_cutters = changed.bounded || changed.trim_cutters;
    if (!status && op->kind == KG_TRIM_CONTOUR && of_cutters)
        status = kg_fail(error, KG_ERR_INPUT, "a contour has no cutters");
    if (!status && json_object_get(a, "keep"))
        status = read_keep(a, &changed, error);
    if (!status)
        *op = changed;
    return status;
}

static kg_status set_trim(kg_editor *e, const json_t *a, kg_error *error) {
    kg_model_patch *p;
    size_t index;
    kg_status status = find_trim(e, a, &p, &index, error);
    if (!status)
        status = kg_editor_begin(e, N_("Change trim"), error);
    if (status)
        return status;
    kg_editor_touch(e);
    return kg_editor_finish(e, set_fields(&p->trims[index], a, error));
}

static const kg_app_command items[] = {
    {"trim.by", N_("Trim"),
     N_("The first selected patch is cut by the second, or by the one that is clicked; another "
        "click "
        "chooses what stays."),
     "T", NULL, trim_by, kg_has_selection, KG_COMMAND_EDIT},
    {"trim.inside", N_("Trim inside"),
     N_("Of the first selected patch stays the piece that the others enclose."), "Shift+T", NULL,
     trim_inside, kg_has_two_selected, KG_COMMAND_EDIT},
    {"trim.contour", N_("Draw contour"), N_("Clicks on the patch draw an outline or a hole."), "E",
     NULL, trim_contour, kg_has_selection, KG_COMMAND_EDIT},
    {"trim.remove", N_("Remove trim"), N_("Removes a trim."), NULL, NULL, remove_trim, NULL,
     KG_COMMAND_ARGUMENTS},
    {"trim.move", N_("Reorder trims"), N_("Gives a trim another place in the list."), NULL, NULL,
     move_trim, NULL, KG_COMMAND_ARGUMENTS},
    {"trim.set", N_("Change trim"), N_("Switches a trim, or what it keeps."), NULL, NULL, set_trim,
     NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_trim_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
