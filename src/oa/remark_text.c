/* Remarks in words. */
#include "katagami/oa.h"

#include "base/phrase.h"

#include <stdarg.h>
#include <string.h>

static const struct {
    const char *code, *reason, *advice;
} texts[KG_OA_TROUBLE_COUNT] = {
    [KG_OA_FLOATING] =
        {"floating",
         N_("a front that nothing holds: no paper leads from it up to the back sheet "
            "or down to the base"),
         N_("close windows around it, fill beside it, or remove it")},
    [KG_OA_NOT_LIFTED] =
        {"not-lifted",
         N_("a front that hangs on nothing above: no paper leads from it up to the "
            "back sheet"),
         N_("close a window or put back a top above it, or remove it")},
    [KG_OA_NOT_CARRIED] =
        {"not-carried",
         N_("a front that stands on nothing below: no paper leads from it down to "
            "the base"),
         N_("close a window below it, make it a window too, or remove it")},
    [KG_OA_BARE_EDGE] = {"edge", N_("the model reaches the edge of the sheet"),
                         N_("give the card a margin of plain cells, or leave its border free")},
    [KG_OA_OVERHANG] = {"overhang", N_("the model sticks out of the card when it is closed"),
                        N_("give the card a larger margin, or keep depth and level together within "
                           "its longer side")},
    [KG_OA_LOOSE] = {"loose", N_("a loose patch: it does not follow from the opening of the card"),
                     N_("join it with a second firm patch in another plane, or glue it")},
    [KG_OA_FLAP] = {"flap", N_("a flap: it hangs on a single patch"),
                    N_("leave it if it is meant to flap, else join it with a second patch")},
    [KG_OA_TINY_FOLD] = {"tiny-fold", N_("a fold so short that the paper tears"),
                         N_("draw the net larger, or use fewer cells")},
    [KG_OA_TINY_NECK] = {"tiny-neck", N_("a strip between cuts so narrow that the paper tears"),
                         N_("draw the net larger, or use fewer cells")},
};

const char *kg_oa_trouble_code(kg_oa_trouble trouble) {
    return texts[trouble].code;
}

const char *kg_oa_trouble_reason(kg_oa_trouble trouble) {
    return kg_phrase(texts[trouble].reason);
}

const char *kg_oa_trouble_advice(kg_oa_trouble trouble) {
    return kg_phrase(texts[trouble].advice);
}

/* Puts a phrase behind those before, with a comma between. */
static void add(char *text, size_t size, const char *format, ...) KG_PRINTF(3, 4);

static void add(char *text, size_t size, const char *format, ...) {
    size_t used = strlen(text);
    va_list args;
    if (used > 0)
        kg_phrase_print(text + used, size - used, ", ");
    used = strlen(text);
    va_start(args, format);
    kg_phrase_vprint(text + used, size - used, format, args);
    va_end(args);
}

/* How a coordinate is said, of one cell and of several. */
static const struct {
    const char *one, *several;
} ranges[3] = {
    {N_("column %d"), N_("columns %d-%d")},
    {N_("depth %d"), N_("depths %d-%d")},
    {N_("level %d"), N_("levels %d-%d")},
};

/* Cells behind the back sheet and below the base are left out. */
static void add_range(char *text, size_t size, int axis, const kg_oa_remark *r) {
    int lo = r->lo[axis], hi = r->hi[axis];
    lo = lo < 0 && hi >= 0 ? 0 : lo;
    if (lo == hi)
        add(text, size, ranges[axis].one, lo);
    else
        add(text, size, ranges[axis].several, lo, hi);
}

void kg_oa_remark_place(const kg_oa_remark *r, char *out_text, size_t size) {
    bool upright = r->plane == KG_OA_BACK && r->lo[1] == r->hi[1];
    bool level = r->plane == KG_OA_FLOOR && r->lo[2] == r->hi[2];
    if (size == 0)
        return;
    out_text[0] = '\0';
    if (upright && r->lo[1] < 0)
        add(out_text, size, N_("back sheet"));
    else if (upright)
        add(out_text, size, N_("front at depth %d"), r->lo[1] + 1);
    else if (level && r->lo[2] < 0)
        add(out_text, size, N_("base"));
    else if (level)
        add(out_text, size, N_("top at height %d"), r->lo[2] + 1);
    add_range(out_text, size, 0, r);
    if (!upright)
        add_range(out_text, size, 1, r);
    if (!level)
        add_range(out_text, size, 2, r);
    if (r->mm > 0)
        add(out_text, size, "%.3g mm", r->mm);
}

void kg_oa_remark_say(const kg_oa_remark *remark, char *out_text, size_t size) {
    char place[160];
    kg_oa_remark_place(remark, place, sizeof place);
    kg_phrase_print(out_text, size, "%s: %s; %s", place, kg_oa_trouble_reason(remark->trouble),
                    kg_oa_trouble_advice(remark->trouble));
}
