/* The net view: its pages, what they hold, and what is wrong with them. */
#include "app/commands/commands.h"
#include "app/panels/net_draw.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "document/pin.h"
#include "net/clash.h"
#include "net/settings.h"

#include <stdio.h>
#include <string.h>

/* Layout units. */
enum { HEADER_HEIGHT = 34, ROW_HEIGHT = 24, MOST_ROWS = 5, LEAST_WIDTH = 400 };

static const char *part_name(const kg_net_part *part, char out[], size_t size) {
    if (part->name[0])
        snprintf(out, size, "%d %s", part->number, part->name);
    else
        snprintf(out, size, _("part %d"), part->number);
    return out;
}

static void patch_label(const kg_editor *e, int64_t id, char *out, size_t size) {
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    if (p && p->name[0])
        snprintf(out, size, "%s", p->name);
    else
        snprintf(out, size, _("patch %lld"), (long long)id);
}

/* ---- header ----------------------------------------------------------------------------- */

/* While parts are being placed, over the pages. */
static void show_progress(kg_net_view *v, kg_area pages) {
    char text[64];
    double fraction, s = v->scale;
    if (!kg_net_state_busy(v->state, &fraction) || fraction <= 0)
        return;
    kg_ui_panel_begin("net progress", NULL,
                      (kg_area){pages.x, pages.y, pages.width, HEADER_HEIGHT * s},
                      KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL | KG_PANEL_SEE_THROUGH);
    if (kg_ui_button(_("Stop")))
        kg_net_state_cancel(v->state);
    kg_ui_tooltip(_("Puts the parts in rows instead of looking for better places."));
    kg_ui_same_line();
    snprintf(text, sizeof text, _("placing the parts… %.0f %%"), 100 * fraction);
    kg_ui_progress(fraction, text);
    kg_ui_panel_end();
}

/* As much as there is room for. */
static void describe(const kg_net_picture *p, double room, char *out, size_t size) {
    snprintf(out, size, "%s", _("Net"));
    if (!p)
        return;
    snprintf(out, size, _("Parts: %zu   Pages: %zu   Filled: %.0f %%"), p->net.net->part_count,
             p->layout->page_count, 100 * p->layout->fill);
    if (kg_ui_text_width(out) > room)
        snprintf(out, size, _("Parts: %zu   Pages: %zu"), p->net.net->part_count,
                 p->layout->page_count);
    if (kg_ui_text_width(out) > room)
        snprintf(out, size, _("Parts: %zu"), p->net.net->part_count);
}

static void show_header(kg_app *app, kg_area area) {
    kg_net_view *v = &app->net_view;
    const kg_net_picture *p = kg_net_state_picture(v->state);
    char text[128];
    double width = kg_ui_text_width(_("Fit")) + kg_ui_text_width(_("Settings")) +
                   kg_ui_text_width(_("Export…")) + 64;
    kg_ui_panel_begin("net header", NULL, area, KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL);
    describe(p, kg_ui_available() - width, text, sizeof text);
    kg_ui_text(text);
    kg_ui_right(width);
    if (kg_ui_button(_("Fit")))
        kg_net_view_fit(v);
    kg_ui_tooltip(_("Shows all pages  Home"));
    kg_ui_same_line();
    if (kg_ui_button(_("Settings")))
        kg_ui_popup_open("net settings");
    kg_ui_tooltip(_("Paper, tabs and labels"));
    kg_panel_net_settings(app);
    kg_ui_same_line();
    if (kg_ui_button(_("Export…")))
        kg_command_do(&app->editor, "file.export_net");
    kg_ui_panel_end();
}

/* ---- what is wrong ---------------------------------------------------------------------- */

/* The first part made of a patch, -1 for none. */
static int part_of_patch(const kg_net_picture *p, int64_t patch) {
    for (size_t i = 0; i < p->net.net->part_count; i++)
        if (p->net.net->parts[i].source == patch)
            return (int)i;
    return -1;
}

/* What the net is warned of: of itself, a part (-1: none), a patch (0: none). */
typedef struct warning {
    kg_severity severity;
    const char *text;
    int part;
    int64_t patch;
} warning;

/* Lines of text that it takes in the list. */
static size_t measure_warning(kg_app *app, const warning *w) {
    const double beside = 72; /* icon, bar, padding; layout units */
    return kg_ui_line_count(w->text, app->net_view.area.width / app->net_view.scale - beside);
}

/* A click shows what it is about. */
static size_t show_warning(kg_app *app, const warning *w) {
    kg_ui_icon(KG_ICON_WARNING, kg_panel_severity_color(&app->editor, w->severity));
    kg_ui_same_line();
    if (kg_ui_selectable_lines(w->text, false)) {
        if (w->patch)
            kg_editor_select(&app->editor, w->patch, false);
        if (w->part >= 0)
            kg_net_view_show_part(&app->net_view, (size_t)w->part);
    }
    if (kg_ui_item_hovered() && w->patch)
        app->editor.hover_patch = w->patch;
    return 1;
}

/* The sum of what `act` returns of each. */
static size_t each_warning(kg_app *app, size_t (*act)(kg_app *app, const warning *w)) {
    const kg_net_view *v = &app->net_view;
    const kg_net_picture *p = kg_net_state_picture(v->state);
    const char *error = kg_net_state_error(v->state);
    char name[128], text[KG_ERROR_SIZE];
    size_t sum = error[0] ? act(app, &(warning){KG_FAULT, error, -1, 0}) : 0;
    for (size_t i = 0; p && i < p->net.net->part_count; i++) {
        const kg_net_part *part = &p->net.net->parts[i];
        unsigned clash = kg_net_view_clash(v, i);
        if (!clash)
            continue;
        snprintf(text, sizeof text,
                 clash & KG_CLASH_OVERLAP ? _("%s lies on another part") : _("%s leaves the page"),
                 part_name(part, name, sizeof name));
        kg_ui_id_push((int64_t)i);
        sum += act(app, &(warning){KG_FAULT, text, (int)i, part->source});
        kg_ui_id_pop();
    }
    for (size_t i = 0; p && i < p->net.remark_count; i++) {
        const kg_net_warning *r = &p->net.remarks[i];
        if (r->source)
            patch_label(&app->editor, r->source, name, sizeof name);
        snprintf(text, sizeof text, "%s%s%s", r->source ? name : "", r->source ? ": " : "",
                 r->message);
        kg_ui_id_push((int64_t)i);
        sum += act(app, &(warning){KG_WARNING, text, part_of_patch(p, r->source), r->source});
        kg_ui_id_pop();
    }
    return sum;
}

static void show_warnings(kg_app *app, kg_area area) {
    kg_ui_panel_begin("net warnings", NULL, area, 0);
    each_warning(app, show_warning);
    kg_ui_panel_end();
}

/* ---- context menu ------------------------------------------------------------------------ */

static json_t *pin_of(const kg_net_view *v, size_t part, double turn) {
    const kg_net *net = kg_net_state_picture(v->state)->net.net;
    kg_net_placement at = kg_net_view_turned(v, part, turn);
    return json_pack("{s:I, s:I, s:i, s:f, s:f, s:f}", "patch", (json_int_t)net->parts[part].source,
                     "piece", (json_int_t)kg_pin_piece(net, part), "page", at.page, "x",
                     at.offset.x, "y", at.offset.y, "angle_deg", at.angle * 180 / KG_PI);
}

static void part_menu(kg_app *app, size_t index) {
    kg_net_view *v = &app->net_view;
    kg_editor *e = &app->editor;
    const kg_net_picture *p = kg_net_state_picture(v->state);
    const kg_net_part *part = &p->net.net->parts[index];
    char name[128];
    bool has_pages = p->options.paper.x > 0;
    kg_ui_text_dim(part_name(part, name, sizeof name));
    if (kg_ui_menu_item(_("Select its patch"), "", false, true))
        kg_editor_select(e, part->source, false);
    if (kg_ui_menu_item(_("Turn by 90°"), "", false, has_pages))
        kg_command_do_with(e, "net.pin", pin_of(v, index, KG_PI / 2));
    if (kg_ui_menu_item(_("Pin to this place"), "", part->pinned, has_pages)) {
        if (part->pinned)
            kg_command_do_with(e, "net.unpin",
                               json_pack("{s:I, s:I}", "patch", (json_int_t)part->source, "piece",
                                         (json_int_t)kg_pin_piece(p->net.net, index)));
        else
            kg_command_do_with(e, "net.pin", pin_of(v, index, 0));
    }
    kg_ui_tooltip(_("Pinned parts stay where they are; the others are placed around them."));
}

/* The patches of a join, the one first that the place naming it is on. */
static void patches_of(const kg_net_join *join, int64_t out[2]) {
    for (int i = 0; i < 2; i++)
        out[i] = join->sources[i ^ join->at_side];
}

/* Whether the menu is about this join alone. Where it is the only one nothing is said of its place,
 * unless it is the last of several. */
static bool is_alone_meant(const kg_net_view *v, const kg_editor *e, const kg_net_join *join) {
    int64_t patches[2];
    patches_of(join, patches);
    return !v->menu_all &&
           (kg_net_joins_beside(kg_net_state_picture(v->state)->net.net, join) > 1 ||
            kg_model_find_join_at(kg_editor_model(e), patches, join->at));
}

/* `tab` etc. are meant as seen from the join's first patch. */
static void set_join(kg_app *app, const kg_net_join *join, const char *key, json_t *value) {
    int64_t patches[2];
    patches_of(join, patches);
    json_t *a = json_pack("{s:[I,I], s:o}", "patches", (json_int_t)patches[0],
                          (json_int_t)patches[1], key, value);
    if (a && is_alone_meant(&app->net_view, &app->editor, join))
        json_object_set_new(a, "at", json_pack("[f,f]", join->at.x, join->at.y));
    kg_command_do_with(&app->editor, "net.join", a);
}

/* What the model wishes for a join, or for all of its patches, seen from the first of these. */
static kg_model_join wish_of(const kg_net_view *v, const kg_editor *e, const kg_net_join *join) {
    const kg_model *m = kg_editor_model(e);
    int64_t patches[2];
    patches_of(join, patches);
    const kg_model_join *found =
        is_alone_meant(v, e, join) ? kg_model_find_join_at(m, patches, join->at) : NULL;
    if (!found)
        found = kg_model_find_join(m, patches[0], patches[1]);
    kg_model_join wish = found ? *found : (kg_model_join){0};
    if (found && found->patches[0] != patches[0])
        wish.tab = kg_net_tab_turned(wish.tab);
    return wish;
}

static void join_menu(kg_app *app, const kg_net_join *join) {
    const char *const shape_names[] = {_("shape: automatic"), _("shape: trapezoids"),
                                       _("shape: teeth")};
    kg_net_view *v = &app->net_view;
    kg_editor *e = &app->editor;
    kg_model_join wish = wish_of(v, e, join);
    size_t count = kg_net_joins_beside(kg_net_state_picture(v->state)->net.net, join);
    int64_t patches[2];
    patches_of(join, patches);
    char names[2][128], text[2][192], title[320];
    for (int i = 0; i < 2; i++) {
        patch_label(e, patches[i], names[i], sizeof names[i]);
        snprintf(text[i], sizeof text[i], _("tabs on %s"), names[i]);
    }
    snprintf(title, sizeof title, _("Join %d: %s and %s"), join->number, names[0], names[1]);
    kg_ui_text_dim(title);
    if (count > 1) {
        char all[64];
        snprintf(all, sizeof all, _("all %zu joins of the two"), count);
        kg_ui_check(all, &v->menu_all);
        kg_ui_tooltip(_("What is chosen here is for all of them, or for this one alone."));
    }
    const char *const tab_names[] = {_("tabs: automatic"), _("no tabs"), text[0], text[1]};
    bool is_contact = join->kind == KG_JOIN_CONTACT;
    for (int i = 0; i < 4; i++)
        if (kg_ui_menu_item(tab_names[i], "", (int)wish.tab == i,
                            !(is_contact && i == (join->at_side ? 2 : 3))))
            set_join(app, join, "tab", json_string(kg_net_tab_side_names[i]));
    kg_ui_separator();
    for (int i = 0; i < 3; i++)
        if (kg_ui_menu_item(shape_names[i], "", (int)wish.shape == i, true))
            set_join(app, join, "shape", json_string(kg_net_tab_shape_names[i]));
    kg_ui_separator();
    if (kg_ui_menu_item(_("merge the parts here"), "", wish.merge, !is_contact))
        set_join(app, join, "merge", json_boolean(!wish.merge));
    kg_ui_tooltip(_("One part with a fold instead of two, where the seam is straight on both."));
    kg_ui_width(120);
    unsigned result = kg_ui_number(_("tab width"), &v->menu_width, 0.1, 0, 100, "%.1f mm");
    if (result & KG_FIELD_ENDED) /* one step, not one a pixel */
        set_join(app, join, "width", json_real(v->menu_width));
    kg_ui_tooltip(_("0: as the net's"));
}

static void show_menu(kg_app *app) {
    kg_net_view *v = &app->net_view;
    const kg_net_picture *p = kg_net_state_picture(v->state);
    if (v->open_menu) {
        kg_ui_popup_open("net menu");
        v->menu_all = false;
        if (p && v->menu_join >= 0)
            v->menu_width = wish_of(v, &app->editor, &p->net.net->joins[v->menu_join]).width;
    }
    v->open_menu = false;
    if (!kg_ui_popup_begin("net menu"))
        return;
    if (p && v->menu_join >= 0) {
        join_menu(app, &p->net.net->joins[v->menu_join]);
        kg_ui_separator();
    }
    if (p && v->menu_part >= 0) {
        part_menu(app, (size_t)v->menu_part);
        kg_ui_separator();
    }
    const kg_app_command *unpin = kg_command_find("net.unpin");
    if (kg_ui_menu_item(_(unpin->title), "", false, kg_command_is_enabled(unpin, &app->editor)))
        kg_command_do(&app->editor, "net.unpin");
    if (kg_ui_menu_item(_("Fit"), "Home", false, true))
        kg_net_view_fit(v);
    kg_ui_popup_end();
}

/* ---- the view --------------------------------------------------------------------------- */

static void show(kg_app *app, kg_area area) {
    kg_net_view *v = &app->net_view;
    kg_editor *e = &app->editor;
    double s = e->pane.scale, header = HEADER_HEIGHT * s;
    if (v->gesture == KG_NET_IDLE) /* else the pages stay in place under the pointer */
        v->listed = each_warning(app, measure_warning);
    size_t rows = v->listed < MOST_ROWS ? v->listed : MOST_ROWS;
    double below = rows > 0 ? ((double)rows * ROW_HEIGHT + 22) * s : 0;
    kg_area pages = {area.x, area.y + header, area.width, fmax(area.height - header - below, 1)};
    if (kg_net_view_follow(v, e, pages, s))
        app->redraw = true;
    kg_net_draw_pages(v, e);
    if (!kg_net_state_picture(v->state)) {
        kg_ui_canvas(KG_CANVAS_BEHIND);
        kg_ui_canvas_text(kg_v2(pages.x + pages.width / 2, pages.y + pages.height / 2),
                          (kg_color){0.5F, 0.52F, 0.55F, 1},
                          kg_net_state_busy(v->state, NULL)
                              ? _("The net is being made.")
                              : _("The parts of the model will lie here."));
    }
    if (v->on_divider || v->gesture == KG_NET_DIVIDING) {
        kg_ui_canvas(KG_CANVAS_BEHIND);
        kg_ui_canvas_rect((kg_area){area.x, area.y, 4 * s, area.height},
                          (kg_color){0.25F, 0.5F, 0.8F, 1}, 0);
    }
    kg_ui_name("divider", (kg_area){area.x, pages.y + pages.height / 2, 2, 2});
    show_header(app, (kg_area){area.x, area.y, area.width, header});
    show_progress(v, pages);
    if (rows > 0)
        show_warnings(app, (kg_area){area.x, area.y + area.height - below, area.width, below});
    show_menu(app);
}

void kg_panel_net(kg_app *app) {
    kg_net_view *v = &app->net_view;
    kg_editor *e = &app->editor;
    kg_area *pane = &e->pane.area, net = *pane;
    bool shown = e->settings.net_view && pane->width > LEAST_WIDTH * e->pane.scale;
    if (shown) {
        net.width = floor(e->settings.net_share * pane->width);
        pane->width -= net.width;
        net.x += pane->width;
        show(app, net);
    } else {
        v->area = (kg_area){0};
        v->hover_part = v->hover_join = -1;
    }
    app->busy = shown && kg_net_state_busy(v->state, NULL);
}
