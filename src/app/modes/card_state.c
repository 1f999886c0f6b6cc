#include "app/modes/card_state.h"

#include "oa/sheet.h"

#include <stdlib.h>

/* A whole motion, s. */
#define CYCLE 4

/* Hinges up to which the degrees of freedom are counted while the user waits: some 10 ms. */
enum { COUNTED_HINGES = 300 };

kg_card_state *kg_card_state_of(const kg_editor *e) {
    return kg_editor_is(e, KG_DOCUMENT_OA) ? e->mode_state : NULL;
}

kg_status kg_card_state_create(const kg_document *document, void **out_state, kg_error *error) {
    kg_card_state *s = calloc(1, sizeof *s);
    (void)document;
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *s = (kg_card_state){.open = KG_PI / 2, .shown_remark = -1, .hover_remark = -1, .degrees = -1};
    *out_state = s;
    return KG_OK;
}

/* ---- places ----------------------------------------------------------------------------- */

static int clamp(int x, int limit) {
    return x < 0 ? 0 : x >= limit ? limit - 1 : x;
}

static kg_spot clamped(const kg_oa *oa, kg_spot s) {
    return (kg_spot){clamp(s.x, oa->width), clamp(s.y, oa->depth_limit), clamp(s.z, oa->height)};
}

bool kg_card_has(const kg_oa *oa, kg_spot s) {
    return s.x >= 0 && s.x < oa->width && s.y >= 0 && s.y < oa->depth_limit && s.z >= 0 &&
           s.z < oa->height;
}

bool kg_card_filled(const kg_oa *oa, kg_spot s) {
    return kg_card_has(oa, s) && s.y < kg_oa_depth(oa, s.x, s.z);
}

void kg_card_move_cursor(kg_editor *e, kg_spot to) {
    kg_card_state *s = kg_card_state_of(e);
    s->cursor = clamped(kg_editor_oa(e), to);
}

static void order(int a, int b, int *lo, int *hi) {
    *lo = a < b ? a : b;
    *hi = a < b ? b : a;
}

kg_spots kg_spots_between(kg_spot a, kg_spot b) {
    kg_spots box;
    order(a.x, b.x, &box.lo.x, &box.hi.x);
    order(a.y, b.y, &box.lo.y, &box.hi.y);
    order(a.z, b.z, &box.lo.z, &box.hi.z);
    return box;
}

kg_spots kg_card_selected(const kg_editor *e) {
    const kg_card_state *s = kg_card_state_of(e);
    return s->boxed ? s->box : (kg_spots){s->cursor, s->cursor};
}

/* ---- remarks and faces ------------------------------------------------------------------ */

int kg_card_remark_at(const kg_editor *e, int x, int row) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    if (!remarks || !sheet)
        return -1;
    int32_t cell = (int32_t)kg_oa_cell(sheet, x, row);
    for (size_t i = 0; i < remarks->count; i++) {
        const kg_oa_remark *r = &remarks->items[i];
        if (x < r->x0 || x >= r->x1 || row < r->row0 || row >= r->row1)
            continue;
        for (size_t k = 0; k < r->cells; k++)
            if (remarks->cells[r->first_cell + k] == cell)
                return (int)i;
    }
    return -1;
}

int kg_card_remark_now(const kg_editor *e) {
    const kg_card_state *s = kg_card_state_of(e);
    return s->hover_remark >= 0 ? s->hover_remark : s->shown_remark;
}

bool kg_card_face_at(const kg_editor *e, int x, int row, kg_face *out_face) {
    const kg_oa *oa = kg_editor_oa(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    x -= sheet->margin;
    row -= sheet->margin;
    if (x < 0 || x >= oa->width)
        return false;
    for (int z = 0; z <= oa->height; z++) {
        if (z < oa->height && kg_oa_depth(oa, x, z) > 0 && kg_oa_front_row(oa, x, z) == row) {
            *out_face = (kg_face){false, x, z};
            return true;
        }
        int cells = z > 0 ? kg_oa_top(oa, x, z) : 0;
        int first = oa->height - z + (z < oa->height ? kg_oa_depth(oa, x, z) : 0);
        if (row >= first && row < first + cells) {
            *out_face = (kg_face){true, x, z};
            return true;
        }
    }
    return false;
}

int kg_card_degrees(const kg_editor *e) {
    kg_card_state *s = kg_card_state_of(e);
    const kg_oa_stability *stability = kg_document_stability(e->document);
    kg_error error;
    if (s->counted == e->solved || e->before || !stability)
        return s->degrees;
    s->counted = e->solved;
    if (stability->hinge_count > COUNTED_HINGES || kg_oa_mobility(stability, &s->degrees, &error))
        s->degrees = -1;
    return s->degrees;
}

/* ---- opening and closing ---------------------------------------------------------------- */

void kg_card_open(kg_editor *e, double open) {
    kg_card_state *s = kg_card_state_of(e);
    s->open = fmin(fmax(open, 0), KG_PI);
    kg_document_set_open(e->document, s->open);
}

void kg_card_play(kg_editor *e, bool on) {
    kg_card_state *s = kg_card_state_of(e);
    s->playing = on;
    s->phase = acos(fmin(fmax(2 * s->open / KG_PI - 1, -1), 1));
    s->played = 0;
}

bool kg_card_tick(kg_editor *e, double seconds) {
    kg_card_state *s = kg_card_state_of(e);
    if (!s->playing)
        return false;
    s->played = fmin(s->played + seconds, CYCLE);
    s->playing = s->played < CYCLE;
    kg_card_open(e, KG_PI / 2 * (1 + cos(s->phase + 2 * KG_PI * s->played / CYCLE)));
    return true; /* the last moment is shown, too */
}

/* ---- another solution ------------------------------------------------------------------- */

void kg_card_follow(kg_editor *e) {
    kg_card_state *s = kg_card_state_of(e);
    const kg_oa *oa = kg_editor_oa(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    int count = remarks ? (int)remarks->count : 0;
    kg_document_set_open(e->document, s->open);
    s->cursor = clamped(oa, s->cursor);
    s->anchor = clamped(oa, s->anchor);
    s->box = kg_spots_between(clamped(oa, s->box.lo), clamped(oa, s->box.hi));
    s->hovering = s->hovering && sheet && s->hover_x < sheet->width && s->hover_row < sheet->rows;
    s->hover_remark = s->hovering ? kg_card_remark_at(e, s->hover_x, s->hover_row) : -1;
    if (s->shown_remark >= count)
        s->shown_remark = -1;
}
