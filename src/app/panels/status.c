/* The status bar: what the tool expects, messages, what is wrong with the model. */
#include "app/mode.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "app/tools/tool.h"

#include <stdio.h>

/* Colours of messages that can be read on the bar: contrasts of 4.5 and more. */
static const struct shades {
    kg_color fault, warning, note;
} shades[] = {
    [KG_UI_DARK] = {{0.95F, 0.4F, 0.3F, 1}, {0.9F, 0.65F, 0.15F, 1}, {0.45F, 0.7F, 0.95F, 1}},
    [KG_UI_LIGHT] = {{0.7F, 0.1F, 0.05F, 1}, {0.5F, 0.31F, 0, 1}, {0.05F, 0.32F, 0.63F, 1}},
};

/* As much of a text as there is room for. */
static const char *cut(const char *text, double room, char *out, size_t size) {
    size_t n = (size_t)snprintf(out, size, "%s", text);
    n = n < size ? n : size - 1;
    if (kg_ui_text_width(out) <= room)
        return out;
    while (n > 0 && kg_ui_text_width(out) > room) {
        while (n > 0 && ((unsigned char)out[--n] & 0xC0) == 0x80) /* within a character */
            ;
        snprintf(out + n, size - n, "…");
    }
    return out;
}

kg_color kg_panel_severity_color(const kg_editor *e, kg_severity severity) {
    const struct shades *shade = &shades[e->settings.theme];
    return severity == KG_FAULT ? shade->fault : shade->warning;
}

/* The issue that a click leads to: the first, or the one after those of the selected patch, so that
 * clicks lead through all. */
static const kg_issue *next_issue(const kg_editor *e) {
    size_t count = kg_document_issue_count(e->document), next = 0;
    int64_t selected = kg_editor_first_selected(e);
    for (size_t i = 0; i < count; i++)
        if (selected && kg_document_issue(e->document, i)->patch == selected)
            next = i + 1;
    return kg_document_issue(e->document, next % count);
}

/* How much is wrong; a click selects what it is about. */
static void show_count(kg_editor *e, kg_color color, const char *text) {
    const kg_issue *issue = next_issue(e);
    const kg_model_patch *p = issue->patch ? kg_model_find(kg_editor_model(e), issue->patch) : NULL;
    char tip[KG_ERROR_SIZE];
    snprintf(tip, sizeof tip, "%s%s%s", p ? p->name : "", p && p->name[0] ? ": " : "",
             issue->message);
    if (kg_ui_link(color, text) && p)
        kg_editor_select(e, p->id, false);
    kg_ui_tooltip(tip);
}

/* How many faults and warnings there are, of documents whose mode has no better word. */
static bool count_issues(const kg_editor *e, char *out, size_t size, kg_severity *out_severity) {
    size_t faults = 0, count = kg_document_issue_count(e->document);
    for (size_t i = 0; i < count; i++)
        faults += kg_document_issue(e->document, i)->severity == KG_FAULT;
    if (faults > 0)
        snprintf(out, size, _("Faults: %zu, warnings: %zu"), faults, count - faults);
    else if (count > 0)
        snprintf(out, size, _("Warnings: %zu"), count);
    else
        snprintf(out, size, "%s", _("No faults"));
    *out_severity = faults > 0 ? KG_FAULT : KG_WARNING;
    return count > 0;
}

void kg_panel_status(kg_app *app, kg_area area) {
    kg_editor *e = &app->editor;
    const struct shades *shade = &shades[e->settings.theme];
    kg_ui_panel_begin("status", NULL, area, KG_PANEL_PLAIN | KG_PANEL_NO_SCROLL);
    const char *now = e->tool->hint_now ? e->tool->hint_now(e) : NULL;
    kg_ui_indent();
    char text[128], shown[KG_ERROR_SIZE];
    kg_severity severity;
    bool wrong =
        (e->mode->verdict ? e->mode->verdict : count_issues)(e, text, sizeof text, &severity);
    double room = kg_ui_available() - kg_ui_text_width(text) - 24;
    if (e->message[0])
        kg_ui_text_color(e->severity == KG_FAULT ? shade->fault : shade->note,
                         cut(e->message, room, shown, sizeof shown));
    else
        kg_ui_text_dim(cut(now ? now : _(e->tool->hint), room, shown, sizeof shown));
    kg_ui_right(kg_ui_text_width(text) + 10);
    if (wrong)
        show_count(e, severity == KG_FAULT ? shade->fault : shade->warning, text);
    else
        kg_ui_text_dim(text);
    kg_ui_panel_end();
}
