/* Commands: steps of folding, which is shown and what they do. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/modes/sheet_edit.h"
#include "app/text.h"

/* ---- what is shown ----------------------------------------------------------------------- */

static double last(const kg_editor *e) {
    return (double)kg_origami_fold_count(kg_editor_origami(e));
}
static double shown(const kg_editor *e) {
    return kg_sheets_shown(kg_sheets_of(e));
}

static kg_status go(kg_editor *e, const json_t *a, kg_error *error) {
    double step = shown(e);
    kg_status status = kg_argument_number(a, "step", &step, error);
    if (!status && !(step >= 0 && step <= last(e)))
        status = kg_fail(error, KG_ERR_INPUT, "there are %.0f steps", last(e));
    if (!status)
        kg_sheets_show(e, step);
    return status;
}

static kg_status go_first(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_sheets_show(e, 0);
    return KG_OK;
}

static kg_status go_last(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_sheets_show(e, last(e));
    return KG_OK;
}

static kg_status go_back(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_sheets_show(e, ceil(shown(e)) - 1);
    return KG_OK;
}

static kg_status go_forth(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_sheets_show(e, floor(shown(e)) + 1);
    return KG_OK;
}

static kg_status play(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    if (kg_sheets_of(e)->playing)
        kg_sheets_stop(e);
    else
        kg_sheets_play(e, shown(e) < last(e) ? shown(e) : 0, last(e));
    return KG_OK;
}

/* Esc also ends what a tool does. */
static kg_status stop(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    if (kg_sheets_of(e)->playing)
        kg_sheets_stop(e);
    else
        kg_editor_use_default(e);
    return KG_OK;
}

static kg_status xray(kg_editor *e, const json_t *a, kg_error *error) {
    kg_sheets *s = kg_sheets_of(e);
    double opacity = s->opacity < 1 ? 1 : 0.5;
    kg_status status = kg_argument_number(a, "opacity", &opacity, error);
    if (!status && !(opacity >= 0 && opacity <= 1))
        status = kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be from 0 to 1", "opacity");
    if (!status)
        s->opacity = opacity;
    return status;
}

static kg_status spread(kg_editor *e, const json_t *a, kg_error *error) {
    kg_sheets *s = kg_sheets_of(e);
    double by = s->spread > 0 ? 0 : 0.5;
    kg_status status = kg_argument_number(a, "by", &by, error);
    if (!status && !(by >= 0 && by <= 1))
        status = kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be from 0 to 1", "by");
    if (status)
        return status;
    s->spread = by;
    kg_sheets_relayer(e);
    return KG_OK;
}

/* About the vertical of the screen: left and right change places, as with paper in hands. */
static kg_status turn_over(kg_editor *e, const json_t *a, kg_error *error) {
    (void)a, (void)error;
    kg_camera *camera = &e->pane.camera;
    camera->yaw += camera->yaw > 0 ? -KG_PI : KG_PI;
    camera->pitch = -camera->pitch;
    return KG_OK;
}

/* ---- what is done ------------------------------------------------------------------------ */

/* "step": of the fold, from 1; without it the one that led to what is shown. Gives its index. */
static kg_status read_fold(const kg_editor *e, const json_t *a, size_t *out, kg_error *error) {
    size_t step = (size_t)ceil(shown(e)), done = kg_origami_step(kg_editor_origami(e));
    kg_status status = kg_argument_index(a, "step", &step, error);
    if (!status && (step < 1 || step > done))
        status = kg_fail(error, KG_ERR_INPUT, "there is no fold %zu: %zu are done", step, done);
    *out = step - 1;
    return status;
}

static kg_status take_out(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index;
    kg_status status = read_fold(e, a, &index, error);
    if (!status)
        status = kg_editor_begin(e, N_("Unfold"), error);
    if (status)
        return status;
    status = kg_origami_unfold(kg_editor_origami(e), index, error);
    kg_editor_touch(e);
    if (kg_editor_finish(e, status))
        return status;
    kg_editor_update(e);
    kg_sheets_show(e, (double)index);
    return KG_OK;
}

static kg_status set(kg_editor *e, const json_t *a, kg_error *error) {
    size_t index, layers;
    kg_status status = read_fold(e, a, &index, error);
    if (status)
        return status;
    kg_fold fold = *kg_origami_fold_at(kg_editor_origami(e), index);
    layers = (size_t)fold.layers;
    status = kg_argument_number(a, "angle_deg", &fold.angle_deg, error);
    if (!status)
        status = kg_argument_index(a, "layers", &layers, error);
    fold.layers = layers < INT32_MAX ? (int32_t)layers : INT32_MAX;
    if (!status)
        status = kg_editor_begin(e, N_("Change fold"), error);
    if (status || (status = kg_editor_finish(e, kg_sheets_refold(e, index, &fold, error))))
        return status;
    kg_editor_update(e);
    kg_sheets_show(e, (double)index + 1);
    return KG_OK;
}

static kg_status from_here(kg_editor *e, const json_t *a, kg_error *error) {
    kg_status status = go(e, a, error);
    return status ? status : kg_sheets_fold_from_here(e, error);
}

/* ---- when -------------------------------------------------------------------------------- */

static bool has_folds(const kg_editor *e) {
    return last(e) > 0;
}
static bool shows_fold(const kg_editor *e) {
    double n = ceil(shown(e));
    return n > 0 && n <= (double)kg_origami_step(kg_editor_origami(e));
}
static bool is_elsewhere(const kg_editor *e) {
    return kg_sheets_of(e)->step != kg_origami_step(kg_editor_origami(e));
}

static const kg_app_command items[] = {
    {"step.play", N_("Play"), N_("Plays the folds from what is shown to the end."), "P", NULL, play,
     has_folds, 0},
    {"step.stop", N_("Stop"), N_("Stops the playing of folds, or ends what the tool is doing."),
     "Esc", NULL, stop, NULL, KG_COMMAND_HIDDEN},
    {"step.back", N_("Step back"), N_("Shows the step before."), "Left", NULL, go_back, has_folds,
     0},
    {"step.forth", N_("Step forth"), N_("Shows the next step."), "Right", NULL, go_forth, has_folds,
     0},
    {"step.first", N_("First step"), N_("Shows the flat sheets."), "Ctrl+Left|Ctrl+Home", NULL,
     go_first, has_folds, 0},
    {"step.last", N_("Last step"), N_("Shows the sheets after all folds."),
     "Ctrl+Right|End|Ctrl+End", NULL, go_last, has_folds, 0},
    {"step.go", N_("Go to step"), "", NULL, NULL, go, NULL, KG_COMMAND_HIDDEN},
    {"view.turn_over", N_("Turn over"), N_("Shows the other side of the paper."), "T", NULL,
     turn_over, NULL, 0},
    {"step.xray", N_("X-ray"), N_("Makes paper see-through, or not any more."), "X", "Alt+Z", xray,
     NULL, 0},
    {"step.spread", N_("Spread layers"),
     N_("Draws the layers far apart, to look between them, or close again."), "L", NULL, spread,
     NULL, 0},
    {"step.from_here", N_("Fold from here"),
     N_("Takes back the folds after the step shown; they can be done again until another is made."),
     NULL, NULL, from_here, is_elsewhere, KG_COMMAND_EDIT},
    {"fold.unfold", N_("Unfold"),
     N_("Takes the fold that led to the step shown out, and does the later ones again."), NULL,
     NULL, take_out, shows_fold, KG_COMMAND_EDIT},
    {"fold.set", N_("Change fold"), "", NULL, NULL, set, NULL, KG_COMMAND_ARGUMENTS},
};
const kg_command_table kg_step_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)};
