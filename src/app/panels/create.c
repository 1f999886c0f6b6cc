/* What a new card or a new sheet is to be. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>

enum {
    FIELD_WIDTH = 130,
    CHOICE_WIDTH = 220,
    SKETCH_WIDTH = 190,
    SKETCH_HEIGHT = 210,
    LEFT_WIDTH = 290
};

/* mm kept free around nets that do not say otherwise, on each side. */
#define MARGIN 8.0

static const kg_new_card usual_cards[] = {
    {{12, 12, 12}, 10}, {{24, 24, 24}, 5}, {{80, 40, 40}, 2.4}};
static const kg_vec2 usual_sheets[] = {{150, 150}, {240, 240}, {210, 297}};
enum { USUAL_COUNT = 3 };

kg_creation kg_creation_default(void) {
    kg_oa_options conversion = kg_oa_options_default();
    conversion.cell_mm =
        kg_document_card_cell((int[]){conversion.width, conversion.depth, conversion.height});
    conversion.covering = true;
    return (kg_creation){
        usual_cards[0],
        {usual_sheets[0], kg_color_from_rgb(KG_SHEET_FRONT), kg_color_from_rgb(KG_SHEET_BACK)},
        conversion};
}

/* ---- the sketch: the sheet on the paper it fits ------------------------------------------- */

/* A rectangle of `size` in the middle of an area, `k` pixels a millimetre. */
static kg_area centerd(const kg_area *a, kg_vec2 size, double k) {
    return (kg_area){a->x + (a->width - k * size.x) / 2, a->y + (a->height - k * size.y) / 2,
                     k * size.x, k * size.y};
}

/* `fold`: share of the height above the fold of a card; 0: it has none. */
static void sketch(kg_vec2 size, double fold, kg_color color) {
    kg_color ink = kg_ui_text_ink(), faint = ink;
    bool across = false;
    kg_vec2 page = size;
    bool holds = kg_net_paper_for(size, MARGIN, &page, &across) != NULL;
    page = across ? kg_v2(page.y, page.x) : page;
    kg_area area = kg_ui_canvas_area("##sketch", SKETCH_WIDTH, SKETCH_HEIGHT);
    double k = 0.94 * fmin(area.width / page.x, area.height / page.y);
    kg_area sheet = centerd(&area, size, k), outer = centerd(&area, page, k);
    faint.a *= 0.4F;
    kg_ui_canvas(KG_CANVAS_WINDOW);
    if (holds)
        kg_ui_canvas_frame(outer, faint, 1, 0);
    kg_ui_canvas_rect(sheet, color, 0);
    kg_ui_canvas_frame(sheet, ink, 1, 0);
    if (fold > 0) {
        static const kg_color valley = {0, 0.34F, 0.72F, 1};
        double y = sheet.y + fold * sheet.height, dash = sheet.width / 19;
        for (int i = 0; i < 19; i += 2)
            kg_ui_canvas_line(kg_v2(sheet.x + i * dash, y), kg_v2(sheet.x + (i + 1) * dash, y),
                              valley, 1.5);
    }
}

static void tell_fit(kg_vec2 size) {
    char text[128];
    bool across;
    kg_vec2 page;
    const char *paper = kg_net_paper_for(size, MARGIN, &page, &across);
    snprintf(text, sizeof text, _("Sheet: %.4g × %.4g mm"), size.x, size.y);
    kg_ui_text(text);
    if (paper)
        snprintf(text, sizeof text, across ? _("The net fits %s, landscape") : _("The net fits %s"),
                 paper);
    else
        snprintf(text, sizeof text, "%s", _("The net is larger than A2: print it at a scale"));
    kg_ui_text_wrapped(text);
}

/* ---- both dialogs ------------------------------------------------------------------------ */

/* The buttons below; true: make it. The dialog closes by both. */
static bool decide(void) {
    kg_ui_space();
    bool done = kg_ui_primary_button(_("Create"));
    kg_ui_same_line();
    if (kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE) || done)
        kg_ui_popup_close();
    return done;
}

static void create(kg_app *app, const char *id, json_t *arguments) {
    kg_error error;
    if (!arguments)
        snprintf(error.message, sizeof error.message, "%s", _("out of memory"));
    if (!arguments || kg_command_run(kg_command_find(id), &app->editor, arguments, &error))
        kg_dialogs_fail(app, &error);
    else
        app->framed = false;
    json_decref(arguments);
}

static bool is_card(const kg_new_card *a, const kg_new_card *b) {
    return a->size[0] == b->size[0] && a->size[1] == b->size[1] && a->size[2] == b->size[2] &&
           a->cell == b->cell;
}

/* A whole number of cells. */
static void cells(const char *label, double *value) {
    kg_ui_width(FIELD_WIDTH);
    kg_ui_number(label, value, 0.1, 1, KG_OA_MAX_SIZE, "%.0f");
    *value = floor(fmin(fmax(*value, 1), KG_OA_MAX_SIZE) + 0.5);
}

static void card_fields(kg_new_card *c) {
    const char *const names[] = {_("coarse: 12 cells of 10 mm"), _("medium: 24 cells of 5 mm"),
                                 _("fine: 80 cells of 2.4 mm"), _("other")};
    int usual = 0;
    while (usual < USUAL_COUNT && !is_card(c, &usual_cards[usual]))
        usual++;
    kg_ui_width(CHOICE_WIDTH);
    if (kg_ui_choice(_("size##card"), names, usual == USUAL_COUNT ? USUAL_COUNT + 1 : USUAL_COUNT,
                     &usual) &&
        usual < USUAL_COUNT)
        *c = usual_cards[usual];
    cells(_("width, cells"), &c->size[0]);
    cells(_("depth, cells"), &c->size[1]);
    cells(_("height, cells"), &c->size[2]);
    kg_ui_width(FIELD_WIDTH);
    kg_ui_number(_("cell##mm"), &c->cell, 0.05, 0.1, KG_OA_MAX_CELL, "%.2f mm");
    c->cell = fmin(fmax(c->cell, 0.1), KG_OA_MAX_CELL);
}

static void show_card(kg_app *app) {
    static const double widths[] = {LEFT_WIDTH, 0};
    kg_new_card *c = &app->dialogs.creation.card;
    if (!kg_panel_modal(&app->dialogs.open_new_card, _("New pop-up card"), 540))
        return;
    if (kg_ui_table_begin("new card", 2, widths)) {
        kg_ui_table_row();
        kg_ui_table_next();
        card_fields(c);
        kg_vec2 size = kg_v2(c->size[0] * c->cell, (c->size[1] + c->size[2]) * c->cell);
        kg_ui_space();
        tell_fit(size);
        kg_ui_table_next();
        sketch(size, c->size[2] / (c->size[1] + c->size[2]), (kg_color){0.93F, 0.92F, 0.88F, 1});
        kg_ui_table_end();
    }
    bool done = decide();
    kg_ui_popup_end();
    if (done)
        create(app, "file.new_card",
               json_pack("{s:[i,i,i], s:f}", "size", (int)c->size[0], (int)c->size[1],
                         (int)c->size[2], "cell_mm", c->cell));
}

static void sheet_fields(kg_new_sheet *s) {
    const char *const names[] = {_("square, 150 mm"), _("square, 240 mm"), "A4", _("other")};
    int usual = 0;
    while (usual < USUAL_COUNT &&
           !(s->size.x == usual_sheets[usual].x && s->size.y == usual_sheets[usual].y))
        usual++;
    kg_ui_width(CHOICE_WIDTH);
    if (kg_ui_choice(_("size##sheet"), names, usual == USUAL_COUNT ? USUAL_COUNT + 1 : USUAL_COUNT,
                     &usual) &&
        usual < USUAL_COUNT)
        s->size = usual_sheets[usual];
    kg_ui_width(FIELD_WIDTH);
    kg_ui_number(_("width"), &s->size.x, 0.5, KG_SHEET_LEAST, KG_SHEET_MOST, "%.1f mm");
    kg_ui_width(FIELD_WIDTH);
    kg_ui_number(_("height"), &s->size.y, 0.5, KG_SHEET_LEAST, KG_SHEET_MOST, "%.1f mm");
    s->size.x = fmin(fmax(s->size.x, KG_SHEET_LEAST), KG_SHEET_MOST);
    s->size.y = fmin(fmax(s->size.y, KG_SHEET_LEAST), KG_SHEET_MOST);
    kg_ui_color_field(_("front##colour"), &s->front);
    kg_ui_color_field(_("back##colour"), &s->back);
}

static void show_sheet(kg_app *app) {
    static const double widths[] = {LEFT_WIDTH, 0};
    kg_new_sheet *s = &app->dialogs.creation.sheet;
    char front[8], back[8];
    if (!kg_panel_modal(&app->dialogs.open_new_sheets, _("New folding"), 540))
        return;
    if (kg_ui_table_begin("new sheet", 2, widths)) {
        kg_ui_table_row();
        kg_ui_table_next();
        sheet_fields(s);
        kg_ui_space();
        tell_fit(s->size);
        kg_ui_table_next();
        sketch(s->size, 0, s->front);
        kg_ui_table_end();
    }
    bool done = decide();
    kg_ui_popup_end();
    kg_color_print(s->front, front);
    kg_color_print(s->back, back);
    if (done)
        create(app, "file.new_sheets",
               json_pack("{s:[f,f], s:s, s:s}", "size", s->size.x, s->size.y, "front", front,
                         "back", back));
}

void kg_panel_create(kg_app *app) {
    show_card(app);
    show_sheet(app);
}
