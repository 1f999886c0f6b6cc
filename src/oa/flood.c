/*
 * Validity (section 2.6): everything that stands before the back sheet must hang on it from above
 * and be carried by the base from below. Since neither flood ever turns back a row, a row is
 * finished from the one before it. The two pieces of a divided cell are joined along a diagonal,
 * which both floods cross sideways, so they are always reached together.
 */
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

static inline bool joined_right(const kg_oa_sheet *s, int x, int row) {
    const int32_t *place = s->place + kg_oa_cell(s, x, row);
    return s->bent ? kg_oa_edge_right(s, x, row) != KG_OA_CUT : place[0] == place[1];
}

static inline bool joined_below(const kg_oa_sheet *s, int x, int row) {
    const int32_t *place = s->place + kg_oa_cell(s, x, row);
    return s->bent ? kg_oa_edge_below(s, x, row) != KG_OA_CUT
                   : kg_oa_place_lower(place[0]) == kg_oa_place_upper(place[s->width]);
}

static void spread(const kg_oa_sheet *s, int row, unsigned char flood, unsigned char *reached) {
    unsigned char *cell = reached + kg_oa_cell(s, 0, row);
    for (int x = 1; x < s->width; x++)
        if ((cell[x - 1] & ~cell[x] & flood) && joined_right(s, x - 1, row))
            cell[x] |= flood;
    for (int x = s->width - 2; x >= 0; x--)
        if ((cell[x + 1] & ~cell[x] & flood) && joined_right(s, x, row))
            cell[x] |= flood;
}

static void flood_rows(const kg_oa_sheet *s, bool down, unsigned char flood,
                       unsigned char *reached) {
    int row = down ? 0 : s->rows - 1, step = down ? 1 : -1;
    spread(s, row, flood, reached);
    for (row += step; row >= 0 && row < s->rows; row += step) {
        const unsigned char *from = reached + kg_oa_cell(s, 0, row - step);
        unsigned char *to = reached + kg_oa_cell(s, 0, row);
        for (int x = 0; x < s->width; x++)
            if ((from[x] & flood) && joined_below(s, x, down ? row - 1 : row))
                to[x] |= flood;
        spread(s, row, flood, reached);
    }
}

size_t kg_oa_flood_on(const kg_oa_sheet *sheet, unsigned char *reached) {
    size_t cells = (size_t)sheet->width * (size_t)sheet->rows, missing = 0;
    flood_rows(sheet, true, KG_OA_FROM_BACK, reached);
    flood_rows(sheet, false, KG_OA_FROM_BASE, reached);
    for (size_t i = 0; i < cells; i++)
        missing += kg_oa_must_hold(sheet, i) && reached[i] != (KG_OA_FROM_BACK | KG_OA_FROM_BASE);
    return missing;
}

kg_status kg_oa_flood(const kg_oa_sheet *sheet, unsigned char *out_reached, size_t *out_missing,
                      kg_error *error) {
    size_t cells = (size_t)sheet->width * (size_t)sheet->rows;
    unsigned char *reached = calloc(cells, 1);
    if (!reached)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    reached[kg_oa_cell(sheet, 0, 0)] = KG_OA_FROM_BACK;
    reached[kg_oa_cell(sheet, 0, sheet->rows - 1)] |= KG_OA_FROM_BASE;
    *out_missing = kg_oa_flood_on(sheet, reached);
    memcpy(out_reached, reached, cells);
    free(reached);
    return KG_OK;
}
