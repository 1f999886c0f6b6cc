/* Commands: folding sheets. */
#include "app/tools/fold.h"
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/modes/sheet_edit.h"
#include "app/text.h"

#include <stdlib.h>

/* ---- folds from arguments ------------------------------------------------------------------ */

/* A whole number from `least` up. */
static kg_status read_whole(const json_t *a, const char *name, int32_t least, int32_t *value,
                            kg_error *error) {
    double x = *value;
    kg_status status = kg_argument_number(a, name, &x, error);
    if (!status && json_object_get(a, name) && !(x == floor(x) && x >= least && x <= 1e9))
        status =
            kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be a whole number from %d", name, least);
    if (!status)
        *value = (int32_t)x;
    return status;
}

static kg_status read_axis(const json_t *a, kg_fold *fold, kg_error *error) {
    double *numbers;
    size_t count;
    kg_status status = kg_argument_rows(a, "axis", 3, &numbers, &count, error);
    if (status)
        return status;
    if (count != 2)
        status = kg_fail(error, KG_ERR_INPUT, "\"axis\" has to be two points");
    for (size_t i = 0; i < 2 && !status; i++)
        fold->points[i] = kg_v3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    free(numbers);
    return status ? status : kg_argument_vec3(a, "vertex", &fold->vertex, error);
}

static kg_status read_where(const json_t *a, kg_fold *fold, kg_error *error) {
    bool axis = json_object_get(a, "axis") && json_object_get(a, "vertex"),
         drag = json_object_get(a, "from") && json_object_get(a, "to");
    if (axis == drag)
        return kg_fail(error, KG_ERR_INPUT,
                       "a fold has \"from\" and \"to\", or an \"axis\" and a \"vertex\"");
    fold->by_axis = axis;
    if (axis)
        return read_axis(a, fold, error);
    kg_status status = kg_argument_vec3(a, "from", &fold->points[0], error);
    return status ? status : kg_argument_vec3(a, "to", &fold->points[1], error);
}

static kg_status read_between(const json_t *a, kg_fold *fold, kg_error *error) {
    const json_t *list = json_object_get(a, "between");
    if (!list)
        return KG_OK;
    for (size_t i = 0; i < 2; i++) {
        const json_t *face = json_array_get(list, i);
        json_int_t number = json_integer_value(face);
        if (json_array_size(list) != 2 || !json_is_integer(face) || number < 0 ||
            number > INT32_MAX)
            return kg_fail(error, KG_ERR_INPUT, "\"between\" has to be two faces");
        fold->between[i] = (int32_t)number;
    }
    return KG_OK;
}

static kg_status make(kg_editor *e, const json_t *a, kg_error *error) {
    if (!a)
        return kg_fold_done(e, error);
    kg_fold fold = kg_fold_default();
    kg_status status = read_where(a, &fold, error);
    if (!status)
        status = kg_argument_number(a, "angle_deg", &fold.angle_deg, error);
    if (!status)
        status = read_whole(a, "face", 0, &fold.face, error);
    if (!status)
        status = read_whole(a, "layers", 1, &fold.layers, error);
    if (!status)
        status = read_between(a, &fold, error);
    return status ? status : kg_fold_add(e, &fold, error);
}

/* ---- the fold being made ------------------------------------------------------------------- */

static kg_status use(kg_editor *e, kg_fold_way way) {
    kg_fold_use_way(e, way);
    return KG_OK;
}
static kg_status use_drag(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return use(e, KG_WAY_DRAG);
}
static kg_status use_axis(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return use(e, KG_WAY_AXIS);
}
static kg_status use_bisect(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return use(e, KG_WAY_BISECT);
}
static kg_status use_square(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return use(e, KG_WAY_SQUARE);
}

static kg_fold_tool *folding(kg_editor *e) {
    if (e->tool != &kg_tool_fold)
        kg_editor_use(e, &kg_tool_fold, NULL);
    return kg_fold_tool_of(e);
}

/* Mountain or valley; with arguments the angle of folds to come. */
static kg_status flip(kg_editor *e, const json_t *a, kg_error *error) {
    kg_fold_tool *t = folding(e);
    double angle = t ? -t->angle_deg : 180;
    kg_status status = a ? kg_argument_number(a, "angle_deg", &angle, error) : KG_OK;
    if (!status && !(fabs(angle) <= 180 && angle != 0))
        status = kg_fail(error, KG_ERR_INPUT, "%g degrees: folds turn by up to 180, and not by 0",
                         angle);
    if (!status)
        kg_fold_set_angle(e, angle);
    return status;
}

static kg_status step_layers(kg_editor *e, int by) {
    kg_fold_tool *t = folding(e);
    int32_t count, now = t ? kg_fold_layers_now(t, &count) : 0;
    if (t && now + by >= 1 && now + by <= count)
        kg_fold_set_layers(e, now + by);
    return KG_OK;
}
static kg_status more_layers(kg_editor *e, const json_t *a, kg_error *error) {
    int32_t layers = 0;
    kg_status status = a ? read_whole(a, "layers", 1, &layers, error) : KG_OK;
    if (status || layers == 0)
        return status ? status : step_layers(e, 1);
    if (folding(e))
        kg_fold_set_layers(e, layers);
    return KG_OK;
}
static kg_status fewer_layers(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    return step_layers(e, -1);
}

static kg_status next_gap(kg_editor *e, const json_t *a, kg_error *error) {
    kg_fold_tool *t = folding(e);
    (void)a, (void)error;
    kg_fold_find_gaps(e);
    if (t)
        kg_fold_set_gap(e, (kg_fold_gap_now(t) + 1) % (t->gap_count + 1));
    return KG_OK;
}

static kg_status back(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a;
    return kg_fold_back(e, error);
}

static bool is_given(const kg_editor *e) {
    const kg_fold_tool *t = kg_fold_tool_seen(e);
    return t && t->given;
}
static bool has_fold(const kg_editor *e) {
    return kg_origami_step(kg_editor_origami(e)) > 0;
}
static bool has_layers(const kg_editor *e) {
    const kg_fold_tool *t = kg_fold_tool_seen(e);
    return t && (t->given || t->vertex >= 0);
}

static const kg_app_command items[] = {
    {"fold.drag", N_("Drag corners"), N_("Folds a corner to where it is dragged."), "D", NULL,
     use_drag, NULL, 0},
    {"fold.axis", N_("Fold by an axis"),
     N_("Folds along an edge, or a line through two points; then a click says which side moves."),
     "A", NULL, use_axis, NULL, 0},
    {"fold.bisect", N_("Fold edge onto edge"), N_("Folds one edge onto another."), "B", NULL,
     use_bisect, NULL, 0},
    {"fold.square", N_("Fold at a right angle"),
     N_("Folds at right angles to an edge, through a point."), "R", NULL, use_square, NULL, 0},
    {"fold.flip", N_("Mountain or valley"),
     N_("Folds away from you instead of towards you, and the other way round."), "V", NULL, flip,
     NULL, 0},
    {"fold.more_layers", N_("One layer more"), N_("Moves one layer more at the corner."), "Page Up",
     NULL, more_layers, has_layers, 0},
    {"fold.fewer_layers", N_("One layer less"), N_("Moves one layer less at the corner."),
     "Page Down", NULL, fewer_layers, has_layers, 0},
    {"fold.next_gap", N_("Between other layers"),
     N_("Ends the fold between the next two layers, or outside."), "Shift+Page Down", NULL,
     next_gap, is_given, 0},
    {"fold.back", N_("Unfold, keep the crease"),
     N_("Folds the last fold back; its crease stays in the paper."), "U", NULL, back, has_fold,
     KG_COMMAND_EDIT},
    {"fold.make", N_("Fold"), N_("Makes the fold that is shown."), NULL, NULL, make, is_given,
     KG_COMMAND_EDIT},
};
const kg_command_table kg_fold_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)};
