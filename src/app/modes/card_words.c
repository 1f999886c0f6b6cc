#include "app/modes/card_words.h"

#include "app/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name, *reason, *advice;
} troubles[KG_OA_TROUBLE_COUNT] = {
    [KG_OA_FLOATING] = {N_("Held by nothing"),
                        N_("no paper leads from it up to the back sheet or down to the base"),
                        N_("close windows around it, fill beside it, or remove it")},
    [KG_OA_NOT_LIFTED] = {N_("Not lifted"), N_("no paper leads from it up to the back sheet"),
                          N_("close a window or put back a top above it, or remove it")},
    [KG_OA_NOT_CARRIED] = {N_("Not carried"), N_("no paper leads from it down to the base"),
                           N_("close a window below it, make it a window too, or remove it")},
    [KG_OA_BARE_EDGE] = {N_("At the edge"), N_("the model reaches the edge of the sheet"),
                         N_("give the card a margin of plain cells, or leave its border free")},
    [KG_OA_LOOSE] = {N_("Loose"), N_("it does not follow from the opening of the card"),
                     N_("join it with a second firm patch in another plane, or glue it")},
    [KG_OA_FLAP] = {N_("Flap"), N_("it hangs on a single patch"),
                    N_("leave it if it is meant to flap, else join it with a second patch")},
    [KG_OA_TINY_FOLD] = {N_("Tiny fold"), N_("so short that the paper tears"),
                         N_("draw the net larger, or use fewer cells")},
    [KG_OA_TINY_NECK] = {N_("Tiny strip"), N_("so narrow between cuts that the paper tears"),
                         N_("draw the net larger, or use fewer cells")},
};

const char *kg_card_trouble_name(kg_oa_trouble t) {
    return _(troubles[t].name);
}
const char *kg_card_trouble_reason(kg_oa_trouble t) {
    return _(troubles[t].reason);
}
const char *kg_card_trouble_advice(kg_oa_trouble t) {
    return _(troubles[t].advice);
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

/* A number, or two of them. */
static void add_range(char *out, size_t size, const char *one, const char *several, int lo,
                      int hi) {
    char text[64];
    lo = lo < 0 && hi >= 0 ? 0 : lo;
    if (lo == hi)
        snprintf(text, sizeof text, "%s %d", one, lo);
    else
        snprintf(text, sizeof text, "%s %d–%d", several, lo, hi);
    add(out, size, "%s%s", out[0] ? ", " : "", text);
}

void kg_card_say_place(const kg_oa_remark *r, char *out, size_t size) {
    bool upright = r->plane == KG_OA_BACK && r->lo[1] == r->hi[1];
    bool level = r->plane == KG_OA_FLOOR && r->lo[2] == r->hi[2];
    out[0] = '\0';
    if (upright && r->lo[1] < 0)
        add(out, size, "%s", _("back sheet"));
    else if (upright)
        add(out, size, _("front at depth %d"), r->lo[1] + 1);
    else if (level && r->lo[2] < 0)
        add(out, size, "%s", _("base"));
    else if (level)
        add(out, size, _("top at height %d"), r->lo[2] + 1);
    add_range(out, size, _("column"), _("columns"), r->lo[0], r->hi[0]);
    if (!upright)
        add_range(out, size, _("depth"), _("depths"), r->lo[1], r->hi[1]);
    if (!level)
        add_range(out, size, _("level"), _("levels"), r->lo[2], r->hi[2]);
    if (r->mm > 0)
        add(out, size, ", %.3g mm", r->mm);
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
        kg_card_say_place(r, place, sizeof place);
        add(s->hint, size, "   %s %s (%s): %s", kg_oa_is_fault(r->trouble) ? "×" : "!",
            kg_card_trouble_name(r->trouble), place, kg_card_trouble_reason(r->trouble));
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
