/*
 * What sticks out of the closed card. With open = 0 the vectors of kg_oa_axes are f = b = s = -r =
 * (0, 1, 0): all that counts is how far a point is from the fold, y + z of ordinary cells. The
 * multiple of e1 never leaves a pyramid's columns, so nothing sticks out sideways.
 */
#include "oa/sheet.h"

static int piece_reach(const kg_oa_piece *piece, const kg_oa_outline *outline) {
    int reach = 0;
    for (int i = 0; i < outline->count; i++) {
        kg_oa_tuple p = kg_oa_piece_point(piece, outline->corners[i][0], -outline->corners[i][1]);
        int away = p.v[1] + p.v[2] + p.v[3] - p.v[4];
        reach = away > reach ? away : reach;
    }
    return reach;
}

/* A cell's upper edge is at z = t + y on its diagonal t. A vertical one reaches y + z = t + 2 y, a
 * horizontal one, whose lower edge is one farther out, one more: that is what kg_oa_place adds. */
int kg_oa_closed_reach(const kg_oa_sheet *sheet, int x, int row) {
    int32_t bent = kg_oa_bent(sheet, x, row);
    if (bent < 0)
        return sheet->height - row + sheet->place[kg_oa_cell(sheet, x, row)];
    const kg_oa_outline *outlines = kg_oa_outlines[sheet->shapes[bent]];
    int left = piece_reach(&sheet->pieces[2 * bent], &outlines[0]);
    int right = piece_reach(&sheet->pieces[2 * bent + 1], &outlines[1]);
    return left > right ? left : right;
}

int kg_oa_overhang(const kg_oa_sheet *sheet) {
    int most = 0;
    for (int row = 0; row < sheet->rows; row++)
        for (int x = 0; x < sheet->width; x++) {
            int out = kg_oa_closed_reach(sheet, x, row) - kg_oa_closed_length(sheet);
            most = out > most ? out : most;
        }
    return most;
}
