/*
 * Validity (section 2.6): everything that stands before the back sheet must hang on it from above
 * and be carried by the base from below. Since neither flood ever turns back a row, a row is
 * finished from the one before it. The two pieces of a divided cell are joined along a diagonal,
 * which both floods cross sideways, so they are always reached together.
 */
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

static void spread(const kg_oa_sheet *s, int row, unsigned char flood, unsigned char *reached) {
    unsigned char *cell = reached + kg_oa_cell(s, 0, row);
    for (int x = 1; x < s->width; x++)
        if ((cell[x - 1] & ~cell[x] & flood) && kg_oa_edge_right(s, x - 1, row) != KG_OA_CUT)
            cell[x] |= flood;
    for (int x = s->width - 2; x >= 0; x--)
        if ((cell[x + 1] & ~cell[x] & flood) && kg_oa_edge_right(s, x, row) != KG_OA_CUT)
            cell[x] |= flood;
}

static void flood_rows(const kg_oa_sheet *s, bool down, unsigned char flood,
                       unsigned char *reached) {
    int row = down ? 0 : s->rows - 1, step = down ? 1 : -1;
    reached[kg_oa_cell(s, 0, row)] |= flood;
    spread(s, row, flood, reached);
    for (row += step; row >= 0 && row < s->rows; row += step) {
        const unsigned char *from = reached + kg_oa_cell(s, 0, row - step);
        unsigned char *to = reached + kg_oa_cell(s, 0, row);
        for (int x = 0; x < s->width; x++)
            if ((from[x] & flood) && kg_oa_edge_below(s, x, down ? row - 1 : row) != KG_OA_CUT)
                to[x] |= flood;
        spread(s, row, flood, reached);
    }
}

kg_status kg_oa_flood(const kg_oa_sheet *sheet, unsigned char *out_reached, size_t *out_missing,
                      kg_error *error) {
    size_t cells = (size_t)sheet->width * (size_t)sheet->rows, missing = 0;
    unsigned char *reached = calloc(cells, 1);
    if (!reached)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    flood_rows(sheet, true, KG_OA_FROM_BACK, reached);
    flood_rows(sheet, false, KG_OA_FROM_BASE, reached);
    for (size_t i = 0; i < cells; i++)
        missing += kg_oa_must_hold(sheet, i) && reached[i] != (KG_OA_FROM_BACK | KG_OA_FROM_BASE);
    memcpy(out_reached, reached, cells);
    free(reached);
    *out_missing = missing;
    return KG_OK;
}
