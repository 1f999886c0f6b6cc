/* The fold being made: its way, angle, layers, where it ends, why it is refused. */
#include "app/tools/fold.h"
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>

/* Layout units. */
enum { FIELD_WIDTH = 170, LABEL_ABOVE = 26, LABEL_MARGIN = 6 };
/* Rows of layers and gaps; more are reached by the number above them. */
enum { MOST_ROWS = 24 };
/* Faces of a layer that fit a row. */
enum { MOST_NAMED = 6 };

static const char *const way_ids[KG_WAY_COUNT] = {"fold.drag", "fold.axis", "fold.bisect",
                                                  "fold.square"};

static void show_way(kg_editor *e, const kg_fold_tool *t) {
    const char *names[KG_WAY_COUNT];
    int way = t ? (int)t->way : KG_WAY_DRAG;
    for (int i = 0; i < KG_WAY_COUNT; i++)
        names[i] = _(kg_command_find(way_ids[i])->title);
    kg_ui_width(-1);
    if (kg_ui_choice("##way", names, KG_WAY_COUNT, &way))
        kg_command_do(e, way_ids[way]);
    kg_ui_tooltip(_(kg_command_find(way_ids[way])->help));
}

static void show_angle(kg_editor *e, kg_fold_tool *t) {
    double angle = t->angle_deg;
    kg_ui_width(FIELD_WIDTH);
    if (kg_ui_slider(_("angle"), &angle, -180, 180, "%.1f°") & KG_FIELD_CHANGED)
        kg_fold_set_angle(e, angle);
    kg_ui_tooltip(_("180: flat. Positive towards you (valley), negative away from you (mountain). "
                    "While folding, just type it. After the fold it is 180 again."));
    kg_ui_same_line();
    kg_ui_check(_("keep"), &t->keeps_angle);
    kg_ui_tooltip(_("The next folds turn as far; else they are flat again."));
    if (kg_ui_radio(_("valley"), t->angle_deg > 0) && t->angle_deg < 0)
        kg_fold_set_angle(e, -t->angle_deg);
    kg_ui_same_line();
    if (kg_ui_radio(_("mountain"), t->angle_deg < 0) && t->angle_deg > 0)
        kg_fold_set_angle(e, -t->angle_deg);
    kg_ui_same_line();
    if (kg_ui_small_button("90°"))
        kg_fold_set_angle(e, copysign(90, t->angle_deg));
    kg_ui_same_line();
    if (kg_ui_small_button("180°"))
        kg_fold_set_angle(e, copysign(180, t->angle_deg));
}

/* ---- layers ------------------------------------------------------------------------------ */

/* "2: face 3, 5"; of many faces how many they are. */
static void name_layer(const kg_editor *e, const int32_t *layers, int32_t layer, char *out,
                       size_t size) {
    const kg_origami_state *s = kg_sheets_of(e)->state;
    size_t count = 0, named = 0, at;
    for (size_t i = 0; i < s->loops.count; i++)
        count += layers[i] == layer;
    if (count > MOST_NAMED) {
        snprintf(out, size, _("%d: %zu faces"), layer, count);
        return;
    }
    at = (size_t)snprintf(out, size, _("%d: face"), layer);
    for (size_t i = 0; i < s->loops.count && at < size; i++)
        if (layers[i] == layer)
            at += (size_t)snprintf(out + at, size - at, named++ > 0 ? ", %zu" : " %zu", i);
}

static void show_layers(kg_editor *e, kg_fold_tool *t) {
    int32_t count, now = kg_fold_layers_now(t, &count), shown = 0;
    const int32_t *layers = t->given ? t->preview.layers : t->pile;
    char text[96];
    if (count < 1 || !layers || !kg_ui_section(_("Layers"), true))
        return;
    snprintf(text, sizeof text, _("%d of %d move"), now, count);
    kg_ui_text(text);
    kg_ui_same_line();
    kg_ui_disabled_begin(now <= 1);
    if (kg_ui_small_button("−##layers"))
        kg_fold_set_layers(e, now - 1);
    kg_ui_disabled_end();
    kg_ui_same_line();
    kg_ui_disabled_begin(now >= count);
    if (kg_ui_small_button("+##layers"))
        kg_fold_set_layers(e, now + 1);
    kg_ui_same_line();
    if (kg_ui_small_button(_("all")))
        kg_fold_set_layers(e, KG_ALL_LAYERS);
    kg_ui_disabled_end();
    for (int32_t i = 1; i <= count && i <= MOST_ROWS; i++) {
        layers = t->given ? t->preview.layers : t->pile; /* a click makes them anew */
        if (!layers)
            break;
        name_layer(e, layers, i, text, sizeof text);
        kg_ui_id_push(i);
        if (kg_ui_selectable(text, i <= now))
            kg_fold_set_layers(e, i);
        if (kg_ui_item_hovered())
            shown = i;
        kg_ui_id_pop();
    }
    t->shown_layer = shown;
}

static void show_gaps(kg_editor *e, const kg_fold_tool *t) {
    if (!t->given || t->gap_count == 0 || !kg_ui_section(_("Ends"), true))
        return;
    size_t now = kg_fold_gap_now(t);
    if (kg_ui_radio(_("outside"), now == 0))
        kg_fold_set_gap(e, 0);
    for (size_t i = 0; i < t->gap_count && i < MOST_ROWS; i++) {
        char text[96];
        snprintf(text, sizeof text, _("between faces %d and %d"), t->gaps[i].upper,
                 t->gaps[i].lower);
        if (kg_ui_radio(text, now == i + 1))
            kg_fold_set_gap(e, i + 1);
    }
}

/* ---- the panel --------------------------------------------------------------------------- */

static void show_end(kg_editor *e, const kg_fold_tool *t) {
    if (t->given && t->refused) {
        kg_ui_space();
        kg_ui_text_color(kg_panel_severity_color(e, KG_FAULT), _("Refused"));
        kg_ui_text_wrapped(t->reason);
        if (kg_fold_advice(t))
            kg_ui_text_wrapped(kg_fold_advice(t));
    }
    if (t->phase != KG_PHASE_HELD)
        return;
    kg_ui_space();
    kg_ui_disabled_begin(t->refused);
    bool fold = kg_ui_button(_("Fold##make"));
    kg_ui_disabled_end();
    kg_ui_tooltip(_("Makes the fold  Enter"));
    kg_ui_same_line();
    bool drop = kg_ui_button(_("Cancel##fold"));
    kg_ui_tooltip(_("Drops it  Esc"));
    if (fold)
        kg_command_do(e, "fold.make");
    else if (drop)
        kg_fold_drop(e);
}

void kg_panel_fold_buttons(kg_editor *e) {
    static const kg_icon icons[KG_WAY_COUNT] = {KG_ICON_FOLD_CORNER, KG_ICON_FOLD_AXIS,
                                                KG_ICON_FOLD_BISECT, KG_ICON_FOLD_SQUARE};
    const kg_fold_tool *t = e->tool == &kg_tool_fold ? e->tool_state : NULL;
    for (int i = 0; i < KG_WAY_COUNT; i++)
        kg_panel_tool_button(e, way_ids[i], icons[i], t && t->way == (kg_fold_way)i);
    kg_panel_tool_button(e, "fold.flip", t && t->angle_deg < 0 ? KG_ICON_MOUNTAIN : KG_ICON_VALLEY,
                         false);
}

void kg_panel_fold(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    kg_ui_panel_begin("fold", _("Fold"), area, 0);
    kg_fold_tool *t = kg_sheets_of(e)->state ? kg_fold_tool_of(e) : NULL;
    show_way(e, t);
    t = kg_sheets_of(e)->state ? kg_fold_tool_of(e) : NULL; /* a click starts the tool */
    if (t) {
        const char *why = t->phase == KG_PHASE_READY ? kg_sheets_why_not(e) : NULL;
        kg_ui_space();
        show_angle(e, t);
        show_end(e, t);
        show_gaps(e, t);
        show_layers(e, t);
        if (why && !kg_sheets_of(e)->playing) {
            kg_ui_space();
            kg_ui_text_wrapped(why);
        }
    }
    kg_ui_panel_end();
}

/* ---- beside the pointer -------------------------------------------------------------------- */

static void label_text(const kg_fold_tool *t, char *out, size_t size) {
    int32_t count, now = kg_fold_layers_now(t, &count);
    if (t->given && t->refused)
        snprintf(out, size, "%s", t->reason);
    else if (t->given && count > 1)
        snprintf(out, size, _("%.4g°, %d of %d layers"), t->angle_deg, now, count);
    else if (t->given)
        snprintf(out, size, _("%.4g°"), t->angle_deg);
    else if (t->layers > 1 && t->vertex >= 0)
        snprintf(out, size, _("%d of %d layers"), now, count);
    else
        out[0] = '\0';
}

void kg_panel_fold_label(kg_app *app) {
    const kg_editor *e = &app->editor;
    const kg_fold_tool *t = kg_fold_tool_seen(e);
    char text[KG_ERROR_SIZE];
    if (!t || !kg_sheets_of(e)->state || t->phase == KG_PHASE_HELD || !kg_sheets_can_fold(e))
        return;
    label_text(t, text, sizeof text);
    if (!text[0])
        return;
    const kg_area *pane = &e->pane.area;
    double scale = e->pane.scale, margin = LABEL_MARGIN * scale;
    double width = kg_ui_text_width(text) * scale + 2 * margin,
           height = kg_ui_line_height_px() + margin;
    double x = fmin(fmax(e->pointer.x - width / 2, pane->x), pane->x + pane->width - width),
           y = fmax(e->pointer.y - LABEL_ABOVE * scale - height, pane->y);
    bool refused = t->given && t->refused;
    kg_ui_name(refused ? "refused" : "fold label", (kg_area){x, y, width, height});
    kg_color color =
        refused ? (kg_color){0.62F, 0.08F, 0.06F, 0.92F} : (kg_color){0.08F, 0.10F, 0.13F, 0.85F};
    kg_ui_canvas_rect((kg_area){x, y, width, height}, color, 4 * scale);
    kg_ui_canvas_text(kg_v2(x + width / 2, y + height / 2), (kg_color){1, 1, 1, 1}, text);
}
