/* How the net is drawn: paper, tabs, labels. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "net/settings.h"

#include <stdio.h>
#include <string.h>

enum { FIELD_WIDTH = 150 };

static void set(kg_editor *e, const char *key, json_t *value) {
    kg_command_do_with(e, "net.set", json_pack("{s:o}", key, value));
}

/* `size`: of the paper in use, whether the model names it or not. */
static void show_paper(kg_editor *e, const kg_net_settings *net, kg_vec2 size) {
    static const char *const sizes[] = {"A4", "A3", "A2", "letter", "legal", "none"};
    enum { SIZE_COUNT = sizeof sizes / sizeof *sizes };
    const char *const names[] = {
        "A4", "A3", "A2", _("letter"), _("legal"), _("no paper"), net->paper ? net->paper : ""};
    int index = net->paper ? SIZE_COUNT : 0;
    for (int i = 0; i < SIZE_COUNT; i++) {
        kg_vec2 own;
        if (net->paper ? strcmp(net->paper, sizes[i]) == 0
                       : !kg_net_paper_parse(sizes[i], &own, NULL) && kg_dist2(own, size) < 1e-6)
            index = i;
    }
    kg_ui_width(FIELD_WIDTH);
    if (kg_ui_choice(_("paper"), names, index == SIZE_COUNT ? SIZE_COUNT + 1 : SIZE_COUNT, &index))
        set(e, "paper", json_string(sizes[index]));
}

static void check(kg_editor *e, const char *label, const char *key, bool value, const char *tip) {
    if (kg_ui_check(label, &value))
        set(e, key, json_boolean(value));
    kg_ui_tooltip(tip);
}

static void choice(kg_editor *e, const char *label, const char *key, const char *const *names,
                   const char *const *words, int count, int index) {
    kg_ui_width(FIELD_WIDTH);
    if (kg_ui_choice(label, names, count, &index))
        set(e, key, json_string(words[index]));
}

/* A number of the model; the net follows while it changes, letting go ends the step. */
static void number(kg_editor *e, const char *label, double *value, double speed, double lo,
                   double hi, const char *format) {
    double shown = *value;
    kg_error error;
    kg_ui_width(FIELD_WIDTH);
    unsigned result = kg_ui_number(label, &shown, speed, lo, hi, format);
    if (result & KG_FIELD_CHANGED && !kg_editor_begin(e, N_("Net settings"), &error)) {
        *value = shown;
        kg_editor_touch(e);
    }
    if (result & (KG_FIELD_ENDED | KG_FIELD_LEFT))
        kg_editor_commit(e);
}

/* What concerns parts that are glued and placed together: cards and sheets are one part. */
static void show_parts(kg_editor *e, const kg_net_options *o) {
    check(e, _("use the paper well"), "nest", o->nest,
          _("Places the parts by their true outlines; else in rows."));
    check(e, _("keep the paper's grain"), "grain", o->grain,
          _("Turns parts by half turns only, so that all bend alike."));
    check(e, _("merge parts where possible"), "merge",
          json_is_true(json_object_get(kg_document_net_settings(e->document)->json, "merge")),
          _("Neighbours that can be folded from one sheet become one part."));
}

void kg_panel_net_settings(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_net_options o = kg_net_options_default();
    bool patches = kg_editor_is(e, KG_DOCUMENT_PATCHES);
    double tab_width;
    kg_error error;
    if (!kg_ui_popup_begin("net settings"))
        return;
    if (kg_document_net_options(e->document, &o, &tab_width, &error))
        kg_ui_text_wrapped(error.message);
    const char *const labels[] = {_("none"), _("inside the parts"), _("outside the parts")};
    const char *const presets[] = {_("print"), _("laser cutter"), "Silhouette", "Cricut"};
    show_paper(e, kg_document_net_settings(e->document), o.paper);
    check(e, _("landscape"), "landscape", o.landscape, "");
    /* asked for anew each time: a change may have moved them */
    number(e, _("margin"), &kg_document_net_settings(e->document)->margin, 0.2, 0, 100, "%.1f mm");
    number(e, _("scale"), &kg_document_net_settings(e->document)->scale, 0.005, 0.01, 100, "%.3f");
    if (patches) {
        number(e, _("tab width"), &kg_document_net_settings(e->document)->tab_width, 0.1, 0, 50,
               "%.1f mm");
        kg_ui_tooltip(_("0: no tabs"));
        choice(e, _("labels"), "labels", labels, kg_net_label_names, 3, (int)o.labels);
    }
    choice(e, _("made for"), "preset", presets, kg_net_preset_names, 4,
           (int)kg_net_settings_preset(kg_document_net_settings(e->document)));
    if (patches)
        show_parts(e, &o);
    kg_ui_popup_end();
}
