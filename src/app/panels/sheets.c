/* The sheets: what is folded, and where each lies before the first fold. */
#include "app/commands/commands.h"
#include "app/modes/sheet_edit.h"
#include "app/panels/panels.h"
#include "app/scenery.h"
#include "app/text.h"

#include <stdio.h>

/* ---- rows -------------------------------------------------------------------------------- */

/* The colour follows the picker live; letting go ends the step. */
static void color_cell(kg_editor *e, size_t sheet, bool is_front) {
    kg_origami *o = kg_editor_origami(e);
    uint32_t sides[2];
    kg_error error;
    kg_origami_colors(o, (int32_t)sheet, &sides[0], &sides[1]);
    kg_color color = kg_color_from_rgb(sides[!is_front]);
    unsigned result = kg_ui_color_field(is_front ? "##front" : "##back", &color);
    kg_ui_tooltip(is_front ? _("Front") : _("Back"));
    if (result & KG_FIELD_CHANGED && !kg_editor_begin(e, N_("Colour"), &error)) {
        sides[!is_front] = kg_color_to_rgb(color);
        if (kg_origami_set_colors(o, sheet, sides[0], sides[1], &error))
            kg_editor_say(e, KG_FAULT, "%s", error.message);
        kg_editor_touch(e);
    }
    if (result & KG_FIELD_ENDED)
        kg_editor_commit(e);
}

static const char *button(const char *id, kg_icon icon, const char *tip) {
    bool pressed = kg_ui_icon_button(id, icon, false, 0);
    kg_ui_tooltip(tip);
    return pressed ? id : NULL;
}

static void row(kg_editor *e, size_t sheet) {
    kg_sheets *s = kg_sheets_of(e);
    const char *pressed = NULL, *command = NULL;
    bool fixed = kg_sheets_why_fixed(e) != NULL, on = s->sheet == (int32_t)sheet;
    char label[64];
    kg_ui_id_push((int64_t)sheet);
    kg_ui_table_row();
    kg_ui_table_next();
    color_cell(e, sheet, true);
    kg_ui_table_next();
    color_cell(e, sheet, false);
    kg_ui_table_next();
    snprintf(label, sizeof label, "%s %zu", _("sheet"), sheet + 1);
    if (kg_ui_selectable(label, on))
        s->sheet = on ? -1 : (int32_t)sheet;
    kg_vec2 span = kg_sheet_span(kg_editor_origami(e), sheet);
    snprintf(label, sizeof label, "%.4g × %.4g mm", span.x, span.y);
    kg_ui_tooltip(label);
    kg_ui_disabled_begin(fixed);
    kg_ui_table_next();
    if ((pressed = button("raise", KG_ICON_UP, _("Raise sheet"))))
        command = "sheet.raise";
    kg_ui_table_next();
    if ((pressed = button("lower", KG_ICON_DOWN, _("Lower sheet"))))
        command = "sheet.lower";
    kg_ui_table_next();
    if ((pressed = button("duplicate", KG_ICON_COPY, _("Duplicate sheet"))))
        command = "sheet.duplicate";
    kg_ui_table_next();
    if ((pressed = button("remove", KG_ICON_REMOVE, _("Delete sheet"))))
        command = "sheet.remove";
    kg_ui_disabled_end();
    kg_ui_id_pop();
    if (command)
        kg_command_do_with(e, command, json_pack("{s:I}", "sheet", (json_int_t)sheet + 1));
}

/* ---- where the selected one lies --------------------------------------------------------- */

/* Of its first side. */
static double angle_of(const kg_paper_sheet *sheet) {
    kg_vec2 d = kg_sub2(sheet->polygon[1], sheet->polygon[0]);
    return atan2(d.y, d.x) * 180 / KG_PI;
}

static void place(kg_editor *e) {
    const kg_sheets *s = kg_sheets_of(e);
    const kg_origami *o = kg_editor_origami(e);
    if (s->sheet < 0 || (size_t)s->sheet >= kg_origami_sheet_count(o) || kg_sheets_why_fixed(e))
        return;
    size_t index = (size_t)s->sheet;
    const kg_paper_sheet *sheet = kg_origami_sheet(o, index);
    kg_vec2 middle = kg_sheet_middle(sheet), to = middle;
    double angle = angle_of(sheet), wanted = angle;
    kg_error error;
    to = kg_v2(fabs(to.x) < 1e-9 ? 0 : to.x, fabs(to.y) < 1e-9 ? 0 : to.y); /* no "-0.00" */
    kg_ui_width(78);
    unsigned result = kg_ui_number("x##sheet", &to.x, 0.5, -1e5, 1e5, "%.2f");
    kg_ui_same_line();
    kg_ui_width(78);
    result |= kg_ui_number("y##sheet", &to.y, 0.5, -1e5, 1e5, "%.2f");
    kg_ui_same_line();
    kg_ui_width(64);
    result |= kg_ui_number("##angle", &wanted, 0.5, -180, 180, "%.1f°");
    kg_ui_tooltip(_("Direction of its first side"));
    if (result & KG_FIELD_CHANGED && !kg_editor_begin(e, N_("Move sheet"), &error) &&
        kg_sheets_place(e, index, NULL, middle, (wanted - angle) * KG_PI / 180, kg_sub2(to, middle),
                        &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
    if (result & KG_FIELD_ENDED)
        kg_editor_commit(e);
}

/* ---- adding ------------------------------------------------------------------------------ */

static void fields(kg_sheet_size *size) {
    if (size->shape != KG_SHEET_A4) {
        kg_ui_width(110);
        kg_ui_number(size->shape == KG_SHEET_POLYGON ? _("across##sheet") : _("side##sheet"),
                     &size->width, 1, 1, 10000, "%.6g mm");
    }
    if (size->shape == KG_SHEET_RECTANGLE) {
        kg_ui_width(110);
        kg_ui_number(_("height##sheet"), &size->height, 1, 1, 10000, "%.6g mm");
    }
    if (size->shape == KG_SHEET_POLYGON) {
        double sides = size->sides;
        kg_ui_width(110);
        kg_ui_number(_("sides##sheet"), &sides, 0.1, 3, KG_SHEET_MOST_SIDES, "%.0f");
        size->sides = (int)lround(sides);
    }
}

static void add_sheet(kg_editor *e, const kg_sheet_size *size) {
    static const char *const names[KG_SHEET_SHAPE_COUNT] = {"square", "rectangle", "a4", "triangle",
                                                            "polygon"};
    kg_command_do_with(e, "sheet.add",
                       json_pack("{s:s, s:f, s:f, s:i}", "shape", names[size->shape], "width",
                                 size->width, "height", size->height, "sides", size->sides));
}

static void add_popup(kg_editor *e) {
    const char *const shapes[KG_SHEET_SHAPE_COUNT] = {_("Square"), _("Rectangle"), _("A4"),
                                                      _("Triangle"), _("Polygon")};
    kg_sheet_size *size = &kg_sheets_of(e)->next_sheet;
    if (kg_ui_button(_("Add sheet…")))
        kg_ui_popup_open("add sheet");
    if (!kg_ui_popup_begin("add sheet"))
        return;
    for (int i = 0; i < KG_SHEET_SHAPE_COUNT; i++)
        if (kg_ui_radio(shapes[i], size->shape == (kg_sheet_shape)i))
            size->shape = (kg_sheet_shape)i;
    fields(size);
    bool add = kg_ui_primary_button(_("Add"));
    if (add)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (add)
        add_sheet(e, size);
}

void kg_panel_sheets(kg_app *app) {
    static const double widths[] = {24, 24, 0, 22, 22, 22, 22};
    kg_editor *e = &app->editor;
    size_t count = kg_sheets_count(kg_sheets_of(e));
    const char *fixed = kg_sheets_why_fixed(e);
    if (count > 0 && kg_ui_table_begin("sheets", 7, widths)) {
        for (size_t i = count; i-- > 0;) /* the topmost first */
            if (i < kg_sheets_count(kg_sheets_of(e)))
                row(e, i);
        kg_ui_table_end();
    }
    place(e);
    kg_ui_disabled_begin(fixed != NULL);
    add_popup(e);
    kg_ui_disabled_end();
    kg_ui_tooltip(fixed);
    if (fixed)
        kg_ui_text_wrapped(fixed);
}
