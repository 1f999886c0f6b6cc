#include "app/modes/card_expect.h"

#include "app/modes/card_state.h"
#include "app/modes/card_words.h"

#include <stdio.h>
#include <string.h>

/* X Z, and perhaps a number more, of a place of the card. */
static kg_status read_place(const kg_oa *oa, const char *words, int levels, int out[3],
                            kg_error *error) {
    int n = sscanf(words, "%d %d %d", &out[0], &out[1], &out[2]);
    if (n >= 2 && out[0] >= 0 && out[0] < oa->width && out[1] >= 0 && out[1] < levels)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "X and Z of the card are wanted");
}

/* X Z D */
static kg_status expect_depth(const kg_oa *oa, const char *words, kg_error *error) {
    int v[3] = {0, 0, -1};
    kg_status status = read_place(oa, words, oa->height, v, error);
    if (status)
        return status;
    int is = kg_oa_depth(oa, v[0], v[1]);
    return is == v[2] ? KG_OK : kg_fail(error, KG_ERR_INPUT, "the depth is %d", is);
}

/* X Z [not] of windows, or of omitted tops, whose Z is their height */
static kg_status expect_face(const kg_oa *oa, const char *words, bool top, kg_error *error) {
    int v[3];
    kg_status status = read_place(oa, words, oa->height + top, v, error);
    if (status)
        return status;
    bool is = top ? kg_oa_omitted(oa, v[0], v[1]) : kg_oa_window(oa, v[0], v[1]);
    return kg_expect_yes(is, !strstr(words, "not"), top ? "left out" : "a window", error);
}

static kg_status expect_cursor(const kg_card_state *s, const char *words, kg_error *error) {
    kg_spot c = {-1, -1, -1};
    sscanf(words, "%d %d %d", &c.x, &c.y, &c.z);
    if (c.x == s->cursor.x && c.y == s->cursor.y && c.z == s->cursor.z)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "the cursor is at %d %d %d", s->cursor.x, s->cursor.y,
                   s->cursor.z);
}

/* DEG, to a millionth */
static kg_status expect_open(const kg_card_state *s, const char *words, kg_error *error) {
    double wanted = -1, is = s->open * 180 / KG_PI;
    sscanf(words, "%lf", &wanted);
    return fabs(is - wanted) <= 1e-6 ? KG_OK
                                     : kg_fail(error, KG_ERR_INPUT, "the card is open by %.9g", is);
}

/* W D H */
static kg_status expect_size(const kg_oa *oa, const char *words, kg_error *error) {
    int w = 0, d = 0, h = 0;
    sscanf(words, "%d %d %d", &w, &d, &h);
    return w == oa->width && d == oa->depth_limit && h == oa->height
               ? KG_OK
               : kg_fail(error, KG_ERR_INPUT, "the card has %d x %d x %d cells", oa->width,
                         oa->depth_limit, oa->height);
}

static size_t count_bits(const unsigned char *flags, size_t count) {
    size_t set = 0;
    for (size_t i = 0; i < count; i++)
        set += flags[i] != 0;
    return set;
}

static kg_status expect_content(const kg_editor *e, const char *w, kg_error *error) {
    const kg_oa *oa = kg_editor_oa(e);
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    const kg_oa_stability *stability = kg_document_stability(e->document);
    size_t columns = (size_t)oa->width, levels = (size_t)oa->height;
    if (kg_expect_begins(&w, "depth"))
        return expect_depth(oa, w, error);
    if (kg_expect_begins(&w, "window"))
        return expect_face(oa, w, false, error);
    if (kg_expect_begins(&w, "omitted"))
        return expect_face(oa, w, true, error);
    if (kg_expect_begins(&w, "windows"))
        return kg_expect_count("windows", count_bits(oa->window, columns * levels), w, error);
    if (kg_expect_begins(&w, "omissions"))
        return kg_expect_count("tops left out", count_bits(oa->omitted, columns * (levels + 1)), w,
                               error);
    if (kg_expect_begins(&w, "size"))
        return expect_size(oa, w, error);
    if (kg_expect_begins(&w, "diagonals"))
        return kg_expect_yes(oa->diagonals, strcmp(w, "off") != 0, "folded diagonally", error);
    if (kg_expect_begins(&w, "loose"))
        return kg_expect_count("loose patches", stability->loose_count, w, error);
    if (kg_expect_begins(&w, "remarks"))
        return kg_expect_count("remarks", remarks->count, w, error);
    if (kg_expect_begins(&w, "overhang"))
        return kg_expect_count("cells that stick out",
                               (size_t)kg_oa_overhang(kg_document_sheet(e->document)), w, error);
    if (kg_expect_begins(&w, "margin"))
        return kg_expect_count("cells of margin", (size_t)oa->margin_cells, w, error);
    if (kg_expect_begins(&w, "valid"))
        return kg_expect_yes(remarks->faults == 0, true, "valid", error);
    if (kg_expect_begins(&w, "invalid"))
        return kg_expect_yes(remarks->faults == 0, false, "valid", error);
    return kg_expect_unknown(w, error);
}

kg_status kg_card_expect(const kg_editor *e, const char *w, kg_error *error) {
    const kg_card_state *s = kg_card_state_of(e);
    if (kg_expect_begins(&w, "cursor"))
        return expect_cursor(s, w, error);
    if (kg_expect_begins(&w, "open"))
        return expect_open(s, w, error);
    if (kg_expect_begins(&w, "playing"))
        return kg_expect_yes(s->playing, true, "playing", error);
    if (kg_expect_begins(&w, "plane"))
        return kg_expect_text("plane", s->level ? "horizontal" : "vertical", w, error);
    if (kg_expect_begins(&w, "symmetric"))
        return kg_expect_yes(s->symmetric, strcmp(w, "off") != 0, "symmetric", error);
    if (kg_expect_begins(&w, "boxed"))
        return kg_expect_yes(s->boxed, strcmp(w, "off") != 0, "boxed", error);
    if (kg_expect_begins(&w, "hovered")) {
        char is[32] = "none";
        if (s->hovering)
            snprintf(is, sizeof is, "%d %d", s->hover_x, s->hover_row);
        return kg_expect_text("cell under the pointer", is, w, error);
    }
    if (kg_expect_begins(&w, "chosen remark"))
        return kg_expect_count("remark", (size_t)(s->shown_remark + 1), w, error);
    if (kg_expect_begins(&w, "verdict")) {
        char text[96];
        kg_severity severity;
        kg_card_verdict(e, text, sizeof text, &severity);
        return kg_expect_text("verdict", text, w, error);
    }
    if (kg_expect_begins(&w, "degrees"))
        return kg_expect_count("degrees of freedom", (size_t)kg_card_degrees(e), w, error);
    return expect_content(e, w, error);
}
