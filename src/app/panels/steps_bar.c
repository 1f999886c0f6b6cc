/* Below the view: a slider through all steps, and how layers are drawn. */
#include "app/commands/commands.h"
#include "app/modes/sheet_state.h"
#include "app/panels/panels.h"
#include "app/text.h"

/* Layout units. */
enum { HEIGHT = 42, LAYERS_LEAST = 84, LAYERS_MOST = 112 };

/* Of a fold: the slider rests at whole steps so near. */
#define REST 0.04

static void button(kg_editor *e, const char *id, kg_icon icon, bool on) {
    const kg_app_command *c = kg_command_find(id);
    kg_ui_disabled_begin(!kg_command_is_enabled(c, e));
    if (kg_ui_icon_button(id, icon, on, 0))
        kg_command_do(e, id);
    kg_ui_disabled_end();
    kg_ui_tooltip(_(c->title));
    kg_ui_same_line();
}

/* `layers`: the width of each of the sliders behind it. */
static void steps(kg_editor *e, double layers) {
    const kg_sheets *s = kg_sheets_of(e);
    double shown = kg_sheets_shown(s), most = (double)kg_origami_fold_count(s->origami);
    button(e, "step.first", KG_ICON_FIRST, false);
    button(e, "step.back", KG_ICON_PREVIOUS, false);
    button(e, "step.play", s->playing ? KG_ICON_STOP : KG_ICON_PLAY, s->playing);
    button(e, "step.forth", KG_ICON_NEXT, false);
    button(e, "step.last", KG_ICON_LAST, false);
    kg_ui_width(fmax(kg_ui_available() - 2 * layers - 24, 40));
    kg_ui_disabled_begin(most == 0);
    if (kg_ui_slider("##scrub", &shown, 0, fmax(most, 1), "%.2f") & KG_FIELD_CHANGED)
        kg_sheets_show(e, fabs(shown - round(shown)) < REST ? round(shown) : shown);
    kg_ui_disabled_end();
    kg_ui_tooltip(_("The step that is shown"));
    kg_ui_same_line();
}

static void drawing(kg_editor *e, double width) {
    kg_sheets *s = kg_sheets_of(e);
    double percent = 100 * s->opacity;
    kg_ui_width(width);
    if (kg_ui_slider("##spread", &s->spread, 0, 1, _("spread")) & KG_FIELD_CHANGED)
        kg_sheets_relayer(e);
    kg_ui_tooltip(_("Draws the layers far apart, to look between them, or close again."));
    kg_ui_same_line();
    kg_ui_width(width);
    if (kg_ui_slider("##opacity", &percent, 5, 100, _("paper %.0f%%")) & KG_FIELD_CHANGED)
        s->opacity = percent / 100;
    kg_ui_tooltip(_("Makes paper see-through, or not any more."));
}

void kg_panel_steps_bar(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_area *a = &e->pane.area;
    double height = fmin(HEIGHT * e->pane.scale, a->height - 1);
    a->height -= height;
    kg_ui_panel_begin("steps bar", NULL, (kg_area){a->x, a->y + a->height, a->width, height},
                      KG_PANEL_NO_SCROLL);
    double layers = fmin(fmax(0.13 * kg_ui_available(), LAYERS_LEAST), LAYERS_MOST);
    steps(e, layers);
    drawing(e, layers);
    kg_ui_panel_end();
}
