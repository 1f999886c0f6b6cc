/* What is wrong with a pop-up card, place by place, and what the lines of its picture mean. */
#include "app/modes/card_frame.h"
#include "app/modes/card_scene.h"
#include "app/modes/card_words.h"
#include "app/panels/card_panels.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>

/* So many remarks are listed; what comes after them is counted only. */
enum { LISTED = 100 };

static void show_remark(kg_editor *e, int index) {
    kg_card_state *s = kg_card_state_of(e);
    const kg_oa_remark *r = &kg_document_remarks(e->document)->items[index];
    char place[160], text[512];
    kg_oa_remark_place(r, place, sizeof place);
    kg_ui_id_push(index);
    kg_ui_icon(KG_ICON_WARNING,
               kg_panel_severity_color(e, kg_oa_is_fault(r->trouble) ? KG_FAULT : KG_WARNING));
    kg_ui_same_line();
    snprintf(text, sizeof text, "%d  %s", index + 1, kg_card_trouble_name(r->trouble));
    if (kg_ui_selectable(text, s->shown_remark == index)) {
        s->shown_remark = index;
        kg_pane_fit(&e->pane, kg_editor_box(e, true));
    }
    if (kg_ui_item_hovered())
        s->hover_remark = index;
    kg_oa_remark_say(r, text, sizeof text);
    kg_ui_tooltip(text);
    kg_ui_indent();
    kg_ui_text_wrapped(s->shown_remark == index ? text : place);
    kg_ui_unindent();
    kg_ui_id_pop();
}

static void show_remarks(kg_editor *e) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    char text[64];
    if (!remarks || remarks->count == 0) {
        kg_ui_text_dim(_("Nothing is wrong."));
        return;
    }
    for (int i = 0; i < (int)remarks->count && i < LISTED; i++)
        show_remark(e, i);
    if (remarks->count > LISTED) {
        snprintf(text, sizeof text, _("and %zu more"), remarks->count - LISTED);
        kg_ui_text_dim(text);
    }
}

/* ---- legend ----------------------------------------------------------------------------- */

/* A line as it is drawn in space. */
static void sample_line(const kg_editor *e, kg_area a, kg_card_line line) {
    kg_style style = kg_card_line_style(line, false);
    double s = e->pane.scale, y = a.y + a.height / 2, x = a.x + 3 * s, end = a.x + a.width - 3 * s;
    double width = fmax(style.size_px, 1) * s;
    if (style.dashes_px[0] <= 0) {
        kg_ui_canvas_line(kg_v2(x, y), kg_v2(end, y), style.color, width);
        return;
    }
    for (int k = 0; x < end; k = (k + 1) % 4) {
        double to = fmin(x + (double)style.dashes_px[k] * s, end);
        if (k % 2 == 0)
            kg_ui_canvas_line(kg_v2(x, y), kg_v2(to, y), style.color, width);
        x = to;
    }
}

static void sample_hatch(const kg_editor *e, kg_area a, kg_card_line line) {
    kg_style style = kg_card_line_style(line, false);
    bool falling = line == KG_CARD_HATCH_SHOWN;
    double s = e->pane.scale, step = 8 * s, h = a.height - 4 * s;
    for (double x = a.x + 2 * s; x + h < a.x + a.width; x += step)
        kg_ui_canvas_line(kg_v2(x, a.y + (falling ? 2 * s : 2 * s + h)),
                          kg_v2(x + h, a.y + (falling ? 2 * s + h : 2 * s)), style.color,
                          (double)style.size_px * s);
}

static void legend_row(const kg_editor *e, const char *name, kg_card_line line) {
    static const kg_color grounds[] = {{0.97F, 0.95F, 0.89F, 1},
                                       {0.96F, 0.74F, 0.33F, 1},
                                       {0.93F, 0.42F, 0.38F, 1},
                                       {0.5F, 0.84F, 0.98F, 1}};
    bool hatched = line >= KG_CARD_HATCH_LOOSE;
    kg_area a = kg_ui_canvas_area(name, 56, 18);
    kg_ui_canvas(KG_CANVAS_WINDOW);
    kg_ui_canvas_rect(a, grounds[hatched ? line - KG_CARD_HATCH_LOOSE + 1 : 0], 0);
    if (hatched)
        sample_hatch(e, a, line);
    else
        sample_line(e, a, line);
    kg_ui_same_line();
    kg_ui_text(name);
}

void kg_panel_card_legend(const kg_editor *e) {
    if (!kg_ui_section(_("Legend"), true))
        return;
    legend_row(e, _("mountain fold"), KG_CARD_MOUNTAIN);
    legend_row(e, _("valley fold"), KG_CARD_VALLEY);
    legend_row(e, _("cut or rim"), KG_CARD_EDGE);
    legend_row(e, _("loose: wobbles"), KG_CARD_HATCH_LOOSE);
    legend_row(e, _("not held: falls off"), KG_CARD_HATCH_FAULT);
    legend_row(e, _("remark shown"), KG_CARD_HATCH_SHOWN);
}

void kg_panel_card_remarks(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    if (kg_ui_has_mouse()) /* the row under the pointer will set it */
        kg_card_state_of(e)->hover_remark = -1;
    kg_ui_panel_begin("card remarks", _("Remarks"), area, 0);
    show_remarks(e);
    kg_ui_panel_end();
}
