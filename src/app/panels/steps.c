/* The list of folds, with a picture of what each leads to. */
#include "app/commands/commands.h"
#include "app/modes/sheet_thumbs.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>

/* Layout units. */
enum { ROW_HEIGHT = 58, THUMB_WIDTH = 72, THUMB_HEIGHT = 54, DETAILS_HEIGHT = 66 };

/* ---- rows -------------------------------------------------------------------------------- */

/* Whether a fold, from 1, brings back what the one before it folded. */
static bool unfolds(const kg_sheets *s, size_t step) {
    if (step < 2 || step > kg_origami_step(s->origami))
        return false;
    const kg_origami_state *before = kg_origami_state_at(s->origami, step - 2),
                           *after = kg_origami_state_at(s->origami, step);
    for (size_t i = 0; i < before->vertices.count; i++)
        if (kg_dist(before->vertices.items[i].position, after->vertices.items[i].position) >
            1e-6 * before->size)
            return false;
    return true;
}

static void title_of(const kg_sheets *s, size_t step, char *out, size_t size) {
    if (unfolds(s, step))
        snprintf(out, size, "%zu  %s", step, _("Fold back"));
    else if (step > 0)
        snprintf(out, size, "%zu  %s %.4g°", step, _("Fold"),
                 fabs(kg_origami_fold_at(s->origami, step - 1)->angle_deg));
    else
        snprintf(out, size, "%s",
                 kg_origami_is_pattern(s->origami) ? _("Crease pattern, folded")
                                                   : _("Flat sheets"));
}

static void words_of(const kg_sheets *s, size_t step, char *out, size_t size) {
    const kg_fold *f = step > 0 ? kg_origami_fold_at(s->origami, step - 1) : NULL;
    if (!f) {
        snprintf(out, size, _("sheets: %zu"), kg_origami_sheet_count(s->origami));
        return;
    }
    int n = snprintf(out, size, "%s", f->angle_deg > 0 ? _("valley") : _("mountain"));
    if (f->between[0] >= 0 && n > 0 && (size_t)n < size)
        snprintf(out + n, size - (size_t)n, ", %s", _("between layers"));
    else if (f->layers > 1 && n > 0 && (size_t)n < size)
        snprintf(out + n, size - (size_t)n, _(", %d layers"), (int)f->layers);
}

static void thumb_at(kg_app *app, kg_area area, size_t step, float opacity) {
    uint32_t picture = kg_sheet_thumb(kg_sheets_of(&app->editor), app->stage, step, (int)area.width,
                                      (int)area.height);
    if (picture)
        kg_ui_canvas_picture(area, picture, opacity);
}

static void row(kg_app *app, size_t step) {
    kg_editor *e = &app->editor;
    kg_sheets *s = kg_sheets_of(e);
    double u = e->pane.scale;
    bool on = (size_t)ceil(kg_sheets_shown(s)) == step;
    char label[32], title[96], words[96];
    kg_area area;
    snprintf(label, sizeof label, "##step %zu", step);
    title_of(s, step, title, sizeof title);
    words_of(s, step, words, sizeof words);
    if (kg_ui_row(label, on, ROW_HEIGHT, &area))
        kg_sheets_show(e, (double)step);
    if (on && s->listed != step) {
        kg_ui_scroll_here();
        s->listed = step;
    }
    kg_color ink = kg_ui_text_ink();
    if (step > kg_origami_step(s->origami)) /* taken back */
        ink.a *= 0.45F;
    kg_area picture = {area.x + 3 * u, area.y + 2 * u, THUMB_WIDTH * u, THUMB_HEIGHT * u};
    if (kg_area_contains((kg_area){0, 0, app->width, app->height},
                         kg_v2(area.x, area.y + area.height / 2)))
        thumb_at(app, picture, step, ink.a);
    kg_vec2 at = {picture.x + picture.width + 9 * u, area.y + 9 * u};
    kg_ui_canvas_label(at, ink, title);
    ink.a *= 0.65F;
    kg_ui_canvas_label(kg_v2(at.x, at.y + 20 * u), ink, words);
}

/* ---- the fold that is shown -------------------------------------------------------------- */

typedef struct field {
    const char *key; /* of the command's argument */
    const char *label, *format;
    double speed, lo, hi;
    bool whole;
} field;

static const field fold_fields[] = {
    {"angle_deg", N_("angle##fold"), "%.6g°", 1, -180, 180, false},
    {"layers", N_("layers##fold"), "%.0f", 0.05, 1, 999, true},
};

/* The value is taken over when the user lets go: doing folds again on the way would stop at each
 * that is refused. */
static void number(kg_editor *e, size_t fold, const field *f, double is) {
    kg_sheets *s = kg_sheets_of(e);
    double value = s->edited == f->key ? s->wish : is;
    kg_ui_width(84);
    unsigned result = kg_ui_number(_(f->label), &value, f->speed, f->lo, f->hi, f->format);
    if (result & (KG_FIELD_BEGAN | KG_FIELD_CHANGED)) {
        s->edited = f->key;
        s->wish = value;
    }
    if (result & KG_FIELD_ENDED)
        kg_command_do_with(
            e, "fold.set",
            json_pack("{s:I, s:o}", "step", (json_int_t)fold, f->key,
                      f->whole ? json_integer((json_int_t)value) : json_real(value)));
    if (result & (KG_FIELD_ENDED | KG_FIELD_LEFT))
        s->edited = NULL;
}

static void button(kg_editor *e, const char *id) {
    const kg_app_command *c = kg_command_find(id);
    kg_ui_disabled_begin(!kg_command_is_enabled(c, e));
    if (kg_ui_button(_(c->title)))
        kg_command_do(e, id);
    kg_ui_disabled_end();
    kg_ui_tooltip(_(c->help));
}

static void details(kg_editor *e) {
    const kg_sheets *s = kg_sheets_of(e);
    size_t fold = (size_t)ceil(kg_sheets_shown(s));
    bool done = fold > 0 && fold <= kg_origami_step(s->origami);
    kg_ui_disabled_begin(!done);
    kg_fold none = kg_fold_default();
    const kg_fold *f = done ? kg_origami_fold_at(s->origami, fold - 1) : &none;
    number(e, fold, &fold_fields[0], f->angle_deg);
    kg_ui_same_line();
    number(e, fold, &fold_fields[1], fmax(f->layers, 1));
    kg_ui_disabled_end();
    button(e, "step.from_here");
    kg_ui_same_line();
    button(e, "fold.unfold");
}

/* What is known of the layers of a pattern that was read. */
static void pattern(const kg_editor *e) {
    const kg_layer_report *r = kg_document_layers(e->document);
    char text[160];
    if (!r)
        return;
    snprintf(text, sizeof text,
             r->exact ? _("Its layers can lie in %.6g ways.")
                      : _("Its layers can lie in at least %.6g ways."),
             r->states);
    kg_ui_text_wrapped(text);
}

void kg_panel_steps(kg_app *app) {
    kg_editor *e = &app->editor;
    const kg_sheets *s = kg_sheets_of(e);
    size_t folds = kg_origami_fold_count(s->origami);
    pattern(e);
    if (folds == 0) {
        kg_ui_text_dim(_("No folds yet."));
        return;
    }
    kg_ui_child_begin("steps", -DETAILS_HEIGHT);
    for (size_t i = 0; i <= folds; i++)
        row(app, i);
    kg_ui_child_end();
    details(e);
}
