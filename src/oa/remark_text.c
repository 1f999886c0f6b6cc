/* Remarks in words. */
#include "katagami/oa.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *code, *reason, *advice;
} texts[KG_OA_TROUBLE_COUNT] = {
    [KG_OA_FLOATING] = {"floating",
                        "a front that nothing holds: no paper leads from it up to the back sheet "
                        "or down to the base",
                        "close windows around it, fill beside it, or remove it"},
    [KG_OA_NOT_LIFTED] = {"not-lifted",
                          "a front that hangs on nothing above: no paper leads from it up to the "
                          "back sheet",
                          "close a window or put back a top above it, or remove it"},
    [KG_OA_NOT_CARRIED] = {"not-carried",
                           "a front that stands on nothing below: no paper leads from it down to "
                           "the base",
                           "close a window below it, make it a window too, or remove it"},
    [KG_OA_BARE_EDGE] = {"edge", "the model reaches the edge of the sheet",
                         "give the card a margin of plain cells, or leave its border free"},
    [KG_OA_LOOSE] = {"loose", "a loose patch: it does not follow from the opening of the card",
                     "join it with a second firm patch in another plane, or glue it"},
    [KG_OA_FLAP] = {"flap", "a flap: it hangs on a single patch",
                    "leave it if it is meant to flap, else join it with a second patch"},
    [KG_OA_TINY_FOLD] = {"tiny-fold", "a fold so short that the paper tears",
                         "draw the net larger, or use fewer cells"},
    [KG_OA_TINY_NECK] = {"tiny-neck", "a strip between cuts so narrow that the paper tears",
                         "draw the net larger, or use fewer cells"},
};

const char *kg_oa_trouble_code(kg_oa_trouble trouble) {
    return texts[trouble].code;
}

const char *kg_oa_trouble_reason(kg_oa_trouble trouble) {
    return texts[trouble].reason;
}

const char *kg_oa_trouble_advice(kg_oa_trouble trouble) {
    return texts[trouble].advice;
}

static void add(char *text, size_t size, const char *format, ...) KG_PRINTF(3, 4);

static void add(char *text, size_t size, const char *format, ...) {
    size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, size - used, format, args);
    va_end(args);
}

/* "columns 2-5"; cells behind the back sheet and below the base are left out. */
static void add_range(char *text, size_t size, const char *what, int lo, int hi) {
    lo = lo < 0 && hi >= 0 ? 0 : lo;
    if (lo == hi)
        add(text, size, "%s %d", what, lo);
    else
        add(text, size, "%ss %d-%d", what, lo, hi);
}

void kg_oa_remark_place(const kg_oa_remark *r, char *out_text, size_t size) {
    bool upright = r->plane == KG_OA_BACK && r->lo[1] == r->hi[1];
    bool level = r->plane == KG_OA_FLOOR && r->lo[2] == r->hi[2];
    if (size == 0)
        return;
    out_text[0] = '\0';
    if (upright && r->lo[1] < 0)
        add(out_text, size, "back sheet, ");
    else if (upright)
        add(out_text, size, "front at depth %d, ", r->lo[1] + 1);
    else if (level && r->lo[2] < 0)
        add(out_text, size, "base, ");
    else if (level)
        add(out_text, size, "top at height %d, ", r->lo[2] + 1);
    add_range(out_text, size, "column", r->lo[0], r->hi[0]);
    add(out_text, size, ", ");
    if (!upright)
        add_range(out_text, size, "depth", r->lo[1], r->hi[1]);
    if (!upright && !level)
        add(out_text, size, ", ");
    if (!level)
        add_range(out_text, size, "level", r->lo[2], r->hi[2]);
    if (r->mm > 0)
        add(out_text, size, ", %.3g mm", r->mm);
}

void kg_oa_remark_say(const kg_oa_remark *remark, char *out_text, size_t size) {
    kg_oa_remark_place(remark, out_text, size);
    if (size > 0)
        add(out_text, size, ": %s; %s", texts[remark->trouble].reason,
            texts[remark->trouble].advice);
}
