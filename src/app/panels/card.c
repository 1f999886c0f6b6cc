/* The panel of a pop-up card: does it work, how far is it open, the cursor, size and counts. */
#include "app/commands/commands.h"
#include "app/modes/card_edit.h"
#include "app/modes/card_words.h"
#include "app/panels/card_panels.h"
#include "app/text.h"
#include "app/ui/icons.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE (KG_PI / 180)

/* Layout units: width of fields, height of the banner, size of the strip over the view. */
enum { FIELD = 110, BANNER = 34, STRIP_WIDTH = 420, STRIP_HEIGHT = 36 };

static const kg_color white = {1, 1, 1, 1};

/* ---- does it work? ---------------------------------------------------------------------- */

static void show_banner(const kg_editor *e) {
    static const kg_color green = {0.1F, 0.5F, 0.3F, 1}, red = {0.75F, 0.14F, 0.12F, 1},
                          amber = {0.68F, 0.44F, 0.05F, 1};
    char text[96];
    kg_severity severity;
    bool wrong = kg_card_verdict(e, text, sizeof text, &severity);
    kg_color color = !wrong ? green : severity == KG_FAULT ? red : amber;
    kg_area a = kg_ui_canvas_area("validity", kg_ui_available(), BANNER);
    double s = e->pane.scale, side = a.height - 12 * s;
    kg_ui_canvas(KG_CANVAS_WINDOW);
    kg_ui_canvas_rect(a, color, 4 * s);
    kg_icon_draw(wrong ? KG_ICON_WARNING : KG_ICON_CHECK,
                 (kg_area){a.x + 6 * s, a.y + 6 * s, side, side}, white);
    kg_ui_canvas_text(kg_v2(a.x + (a.width + side) / 2, a.y + a.height / 2), white, text);
}

/* ---- opening ---------------------------------------------------------------------------- */

static void show_slider(kg_editor *e, const char *label, double width) {
    kg_card_state *s = kg_card_state_of(e);
    double degrees = s->open / DEGREE;
    kg_ui_width(width);
    if (kg_ui_slider(label, &degrees, 0, 180, "%.1f°") & KG_FIELD_CHANGED) {
        kg_card_play(e, false);
        kg_card_open(e, degrees * DEGREE);
    }
}

static void show_play(kg_editor *e) {
    const kg_card_state *s = kg_card_state_of(e);
    if (kg_ui_icon_button("play", s->playing ? KG_ICON_STOP : KG_ICON_PLAY, s->playing, 0))
        kg_command_do(e, "card.play");
    kg_ui_tooltip(_("Closes and opens the card once, or stops."));
}

static void show_opening(kg_editor *e) {
    static const double stops[] = {0, 45, 90, 180};
    if (!kg_ui_section(_("Opening"), true))
        return;
    double degrees = kg_card_state_of(e)->open / DEGREE;
    kg_ui_width(FIELD);
    if (kg_ui_number(_("angle"), &degrees, 0.5, 0, 180, "%.2f°") & KG_FIELD_CHANGED) {
        kg_card_play(e, false);
        kg_card_open(e, degrees * DEGREE);
    }
    kg_ui_tooltip(_("Between the sheets: 0° closed, 90° standing, 180° flat. Keys: [ and ]"));
    for (size_t i = 0; i < sizeof stops / sizeof *stops; i++) {
        char label[16];
        snprintf(label, sizeof label, "%.0f°", stops[i]);
        if (kg_ui_small_button(label))
            kg_command_do_with(e, "card.open", json_pack("{s:f}", "degrees", stops[i]));
        kg_ui_same_line();
    }
    show_play(e);
}

void kg_panel_card_opening(kg_app *app) {
    kg_editor *e = &app->editor;
    const kg_area *pane = &e->pane.area;
    double s = e->pane.scale, width = fmin(STRIP_WIDTH * s, pane->width - 20 * s);
    if (width < 120 * s)
        return;
    kg_ui_panel_begin("opening strip", NULL,
                      (kg_area){floor(pane->x + (pane->width - width) / 2),
                                floor(pane->y + pane->height - (STRIP_HEIGHT + 8) * s), width,
                                STRIP_HEIGHT * s},
                      KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL | KG_PANEL_SEE_THROUGH);
    show_play(e);
    kg_ui_same_line();
    show_slider(e, "##opening strip", -1);
    kg_ui_tooltip(_("How far the card stands open: 0° closed, 90° standing, 180° flat"));
    kg_ui_panel_end();
}

/* ---- cursor ----------------------------------------------------------------------------- */

static void show_coordinate(kg_editor *e, const char *name, int *value, int limit) {
    double number = *value;
    char label[24];
    snprintf(label, sizeof label, "%s##cursor %s", name, name);
    kg_ui_width(52);
    if (kg_ui_number(label, &number, 0.1, 0, limit - 1, "%.0f") & KG_FIELD_CHANGED) {
        *value = (int)lround(number);
        kg_card_move_cursor(e, kg_card_state_of(e)->cursor);
    }
}

static void show_face(kg_editor *e, const char *label, bool top) {
    const kg_oa *oa = kg_editor_oa(e);
    kg_spot c = kg_card_state_of(e)->cursor;
    bool there = top ? kg_oa_top(oa, c.x, c.z + 1) > 0 : kg_oa_depth(oa, c.x, c.z) > 0;
    bool on = there && kg_card_face_is_set(e, (kg_face){top, c.x, c.z + top});
    kg_ui_disabled_begin(!there);
    if (kg_ui_check(label, &on))
        kg_command_do_with(e, top ? "card.top" : "card.window",
                           json_pack("{s:i,s:i,s:b}", "x", c.x, "z", c.z + top, "on", on));
    kg_ui_disabled_end();
}

static void show_cursor(kg_editor *e) {
    static const char *const planes[] = {N_("vertical"), N_("horizontal")};
    const kg_oa *oa = kg_editor_oa(e);
    kg_card_state *s = kg_card_state_of(e);
    char text[128];
    if (!kg_ui_section(_("Cursor"), true))
        return;
    show_coordinate(e, "x", &s->cursor.x, oa->width);
    kg_ui_same_line();
    show_coordinate(e, "y", &s->cursor.y, oa->depth_limit);
    kg_ui_same_line();
    show_coordinate(e, "z", &s->cursor.z, oa->height);
    snprintf(text, sizeof text, _("depth %d here, brush: %s"),
             kg_oa_depth(oa, s->cursor.x, s->cursor.z), kg_card_brush_name(s->brush));
    kg_ui_text_dim(text);
    show_face(e, _("Window"), false);
    kg_ui_same_line();
    show_face(e, _("Top left out"), true);
    int plane = s->level;
    const char *const names[] = {_(planes[0]), _(planes[1])};
    kg_ui_width(FIELD);
    if (kg_ui_choice(_("plane"), names, 2, &plane))
        s->level = plane == 1;
    kg_ui_check(_("Mirror symmetry"), &s->symmetric);
}

/* ---- size ------------------------------------------------------------------------------- */

/* A resized copy of the card as it was before the gesture: what was cut off comes back. */
static void resize(kg_editor *e, int width, int depth, int height) {
    kg_oa *oa = kg_editor_oa(e), *copy = kg_oa_copy(kg_document_oa(e->before));
    kg_error error;
    if (!copy || kg_oa_resize(copy, width, depth, height, &error)) {
        kg_editor_say(e, KG_FAULT, "%s", copy ? error.message : _("Out of memory."));
    } else {
        kg_oa kept = *oa;
        *oa = *copy;
        *copy = kept;
        kg_editor_touch(e);
        kg_editor_update(e); /* at once: the cursor may be outside now */
    }
    kg_oa_destroy(copy);
}

/* Opens a step when a field is taken hold of, closes it at the end. True: its value is another. */
static bool follow(kg_editor *e, unsigned result, const char *label) {
    kg_error error;
    bool changed = result & KG_FIELD_CHANGED;
    if (changed && kg_editor_begin(e, label, &error)) {
        kg_editor_say(e, KG_FAULT, "%s", error.message);
        return false;
    }
    return changed;
}

static void end_field(kg_editor *e, unsigned result) {
    if (result & (KG_FIELD_ENDED | KG_FIELD_LEFT))
        kg_editor_commit(e);
}

static void show_size(kg_editor *e) {
    const char *const names[] = {_("columns"), _("depth"), _("levels")};
    const kg_oa *oa = kg_editor_oa(e);
    int size[3] = {oa->width, oa->depth_limit, oa->height};
    for (int i = 0; i < 3; i++) {
        double value = size[i];
        char label[64];
        snprintf(label, sizeof label, "%s##size", names[i]);
        kg_ui_width(FIELD);
        unsigned result = kg_ui_number(label, &value, 0.1, 1, KG_OA_MAX_SIZE, "%.0f");
        if (follow(e, result, N_("Size of the card"))) {
            size[i] = (int)lround(value);
            resize(e, size[0], size[1], size[2]);
        }
        end_field(e, result);
    }
}

static void show_title(kg_editor *e) {
    char title[256], *copy = NULL;
    snprintf(title, sizeof title, "%s", kg_editor_oa(e)->title);
    kg_ui_width(FIELD + 60);
    unsigned result = kg_ui_text_field(_("title"), title, sizeof title, NULL, false);
    if (follow(e, result, N_("Title")) && (copy = strdup(title))) {
        free(kg_editor_oa(e)->title);
        kg_editor_oa(e)->title = copy;
        kg_editor_touch(e);
    }
    end_field(e, result);
}

static void show_sheet(kg_editor *e) {
    if (!kg_ui_section(_("Sheet"), true))
        return;
    show_title(e);
    show_size(e);
    const kg_oa *oa = kg_editor_oa(e);
    double cell = oa->cell_mm, margin = oa->margin_cells;
    kg_ui_width(FIELD);
    unsigned result = kg_ui_number(_("cell"), &cell, 0.02, 0.1, KG_OA_MAX_CELL, "%.2f mm");
    if (follow(e, result, N_("Size of cells"))) {
        kg_editor_oa(e)->cell_mm = cell;
        kg_editor_touch(e);
    }
    end_field(e, result);
    kg_ui_width(FIELD);
    result = kg_ui_number(_("margin"), &margin, 0.05, 0, KG_OA_MAX_MARGIN, _("%.0f cells"));
    if (follow(e, result, N_("Margin"))) {
        kg_editor_oa(e)->margin_cells = (int)lround(margin);
        kg_editor_touch(e);
    }
    end_field(e, result);
    char text[160];
    snprintf(text, sizeof text, _("paper %.4g × %.4g mm"),
             (oa->width + 2 * oa->margin_cells) * oa->cell_mm,
             (oa->height + oa->depth_limit + 2 * oa->margin_cells) * oa->cell_mm);
    kg_ui_text_dim(text);
    bool diagonals = oa->diagonals;
    if (kg_ui_check(_("45° folds"), &diagonals))
        kg_command_do_with(e, "card.diagonals", json_pack("{s:b}", "on", diagonals));
}

/* ---- counts ----------------------------------------------------------------------------- */

static void row(const char *name, const char *value) {
    kg_ui_table_row();
    kg_ui_table_next();
    kg_ui_text_dim(name);
    kg_ui_table_next();
    kg_ui_text(value);
}

static void count_row(const char *name, size_t count) {
    char text[32];
    snprintf(text, sizeof text, "%zu", count);
    row(name, text);
}

static void show_counts(const kg_editor *e) {
    static const double widths[] = {170, 0};
    const kg_oa *oa = kg_editor_oa(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    const kg_oa_stability *stability = kg_document_stability(e->document);
    if (!kg_ui_section(_("Counts"), true) || !sheet || !stability ||
        !kg_ui_table_begin("counts", 2, widths))
        return;
    size_t voxels = 0, windows = 0, tops = 0;
    for (int x = 0; x < oa->width; x++)
        for (int z = 0; z <= oa->height; z++) {
            voxels += z < oa->height ? (size_t)kg_oa_depth(oa, x, z) : 0;
            windows += z < oa->height && kg_oa_window(oa, x, z);
            tops += kg_oa_omitted(oa, x, z);
        }
    count_row(_("voxels"), voxels);
    count_row(_("windows"), windows);
    count_row(_("tops left out"), tops);
    count_row(_("pyramids"), sheet->pyramid_count);
    count_row(_("patches"), stability->patch_count);
    count_row(_("folds between them"), stability->hinge_count);
    count_row(_("loose patches"), stability->loose_count);
    int degrees = kg_card_degrees(e);
    if (degrees >= 0)
        count_row(_("degrees of freedom"), (size_t)degrees);
    else
        row(_("degrees of freedom"), _("too many folds to count"));
    kg_ui_table_end();
}

void kg_panel_card(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    kg_ui_panel_begin("card", _("Card"), area, 0);
    show_banner(e);
    show_opening(e);
    show_cursor(e);
    show_sheet(e);
    kg_panel_card_legend(e);
    show_counts(e);
    kg_ui_panel_end();
}
