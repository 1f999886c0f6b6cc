#include "app/modes/card_words.h"

#include "app/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *kg_card_trouble_name(kg_oa_trouble trouble) {
    static const char *const names[KG_OA_TROUBLE_COUNT] = {
        [KG_OA_FLOATING] = N_("Held by nothing"),
        [KG_OA_NOT_LIFTED] = N_("Not lifted"),
        [KG_OA_NOT_CARRIED] = N_("Not carried"),
        [KG_OA_BARE_EDGE] = N_("At the edge"),
        [KG_OA_OVERHANG] = N_("Sticks out closed"),
        [KG_OA_LOOSE] = N_("Loose"),
        [KG_OA_FLAP] = N_("Flap"),
        [KG_OA_TINY_FOLD] = N_("Tiny fold"),
        [KG_OA_TINY_NECK] = N_("Tiny strip"),
    };
    return _(names[trouble]);
}

const char *kg_card_brush_name(kg_brush brush) {
    static const char *const names[KG_BRUSH_COUNT] = {N_("Add"), N_("Remove"), N_("Pull"),
                                                      N_("Window"), N_("Leave out top")};
    return _(names[brush]);
}

static void add(char *out, size_t size, const char *format, ...) KG_PRINTF(3, 4);

static void add(char *out, size_t size, const char *format, ...) {
    size_t used = strlen(out);
    va_list args;
    va_start(args, format);
    vsnprintf(out + used, size - used, format, args);
    va_end(args);
}

void kg_card_say_cursor(const kg_editor *e, char *out, size_t size) {
    const kg_card_state *s = kg_card_state_of(e);
    const kg_oa *oa = kg_editor_oa(e);
    kg_spot c = s->cursor;
    snprintf(out, size, _("x %d  y %d  z %d   depth %d"), c.x, c.y, c.z, kg_oa_depth(oa, c.x, c.z));
    if (kg_oa_window(oa, c.x, c.z))
        add(out, size, ", %s", _("window"));
    if (kg_oa_omitted(oa, c.x, c.z + 1))
        add(out, size, ", %s", _("top left out"));
}

bool kg_card_verdict(const kg_editor *e, char *out, size_t size, kg_severity *out_severity) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    size_t faults = remarks ? remarks->faults : 0, loose = 0;
    for (size_t i = faults; remarks && i < remarks->count; i++)
        loose += remarks->items[i].trouble == KG_OA_LOOSE;
    if (faults > 0)
        snprintf(out, size, _("Does not work: %zu faults"), faults);
    else if (loose > 0)
        snprintf(out, size, _("Works, but %zu patches are loose"), loose);
    else if (remarks && remarks->count > 0)
        snprintf(out, size, _("Works, with %zu warnings"), remarks->count);
    else
        snprintf(out, size, "%s", _("Works: one sheet that pops up"));
    *out_severity = faults > 0 ? KG_FAULT : KG_WARNING;
    return remarks && remarks->count > 0;
}

/* The remark shown, else the first fault; -1: none. */
static int remark_to_say(const kg_editor *e) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    int now = kg_card_remark_now(e);
    return now >= 0 ? now : remarks && remarks->faults > 0 ? 0 : -1;
}

const char *kg_card_hint(const kg_editor *e) {
    kg_card_state *s = kg_card_state_of(e);
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    int remark = remark_to_say(e);
    size_t size = sizeof s->hint;
    char place[160];
    if (s->playing)
        return _("P or Esc: stop");
    kg_card_say_cursor(e, s->hint, size);
    if (remark >= 0) {
        const kg_oa_remark *r = &remarks->items[remark];
        kg_oa_remark_place(r, place, sizeof place);
        add(s->hint, size, "   %s %s (%s): %s", kg_oa_is_fault(r->trouble) ? "×" : "!",
            kg_card_trouble_name(r->trouble), place, kg_oa_trouble_reason(r->trouble));
    } else {
        add(s->hint, size, "   %s",
            s->brush == KG_BRUSH_PULL     ? _("Drag a face out or in")
            : s->brush == KG_BRUSH_WINDOW ? _("Drag over fronts: windows")
            : s->brush == KG_BRUSH_TOP    ? _("Drag over tops: left out")
            : s->brush == KG_BRUSH_REMOVE
                ? _("Drag: remove   Ctrl+drag: a box   Esc: add again")
                : _("Click: add   Shift: remove   Ctrl+drag: a box   Alt+drag: select"));
    }
    return s->hint;
}
