/* Pieces of the sheet in space, and what lies between neighbours. */
#include "oa/sheet.h"

/* Over (e1, f, b, s, r): where one cell to the right and one cell up on the sheet go. */
static const int across[KG_OA_CLASS_COUNT][5] = {
    {1, 0, 0, 0, 0}, {1, 0, 0, 0, 0}, {0, 0, 0, 1, 0},
    {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}, {0, 0, 0, 0, 1},
};
static const int upward[KG_OA_CLASS_COUNT][5] = {
    {0, 0, 1, 0, 0},   {0, -1, 0, 0, 0}, {1, 0, 1, -1, 0},
    {-1, -1, 0, 1, 0}, {-1, 0, 1, 0, 1}, {1, -1, 0, 0, -1},
};

/* Three times e1, f, b, s, r of the standing card. */
static const int standing[5][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 2, 2}, {1, -2, -2}};

const kg_oa_outline kg_oa_outlines[3][2] = {
    {{4, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}}, {0, {{0, 0}}}},
    {{3, {{0, 0}, {0, 1}, {1, 0}}}, {3, {{0, 1}, {1, 1}, {1, 0}}}},
    {{3, {{0, 0}, {0, 1}, {1, 1}}}, {3, {{0, 0}, {1, 1}, {1, 0}}}},
};

kg_oa_tuple kg_oa_piece_point(const kg_oa_piece *piece, int dx, int dt) {
    kg_oa_tuple p = piece->corner;
    for (int i = 0; i < 5; i++)
        p.v[i] += dx * across[piece->plane][i] + dt * upward[piece->plane][i];
    return p;
}

kg_oa_shape kg_oa_cell_shape(const kg_oa_sheet *sheet, int x, int row) {
    int32_t bent = kg_oa_bent(sheet, x, row);
    return bent < 0 ? KG_OA_WHOLE : (kg_oa_shape)sheet->shapes[bent];
}

kg_oa_piece kg_oa_cell_piece(const kg_oa_sheet *sheet, int x, int row, int side) {
    int32_t bent = kg_oa_bent(sheet, x, row);
    if (bent >= 0)
        return sheet->pieces[2 * bent + side];
    int32_t place = sheet->place[kg_oa_cell(sheet, x, row)];
    int y = kg_oa_place_upper(place), t = sheet->height - row;
    return (kg_oa_piece){place & 1 ? KG_OA_FLOOR : KG_OA_BACK, {{x, y, t + y, 0, 0}}};
}

kg_oa_voxel kg_oa_faced(const kg_oa_sheet *sheet, int x, int row) {
    int32_t place = sheet->place[kg_oa_cell(sheet, x, row)];
    bool top = place & 1;
    int y = kg_oa_place_upper(place), z = sheet->height - row + y;
    return (kg_oa_voxel){top, x - sheet->margin, top ? y : y - 1, z - 1};
}

/* ---- edges ------------------------------------------------------------------------------ */

/* The side of a plane's vectors on the standing card, in thirds. */
static void stand(const int tuple[5], int out[3]) {
    for (int k = 0; k < 3; k++) {
        out[k] = 0;
        for (int i = 0; i < 5; i++)
            out[k] += tuple[i] * standing[i][k];
    }
}

/* Which way the paper turns from the plane `a`, at an edge from where the sheet goes on in the
 * direction `onward` of the plane behind it: towards the reader is a valley. The printed side of a
 * plane looks along upward x across. */
static kg_oa_edge turn(kg_oa_class a, const int onward[5], int sign) {
    int t[3], x[3], d[3];
    stand(upward[a], t);
    stand(across[a], x);
    stand(onward, d);
    int side = sign * ((t[1] * x[2] - t[2] * x[1]) * d[0] + (t[2] * x[0] - t[0] * x[2]) * d[1] +
                       (t[0] * x[1] - t[1] * x[0]) * d[2]);
    return side > 0 ? KG_OA_VALLEY : side < 0 ? KG_OA_MOUNTAIN : KG_OA_NONE;
}

static bool meet(const kg_oa_piece *a, int ax, int at, const kg_oa_piece *b, int bx, int bt) {
    kg_oa_tuple p = kg_oa_piece_point(a, ax, at), q = kg_oa_piece_point(b, bx, bt);
    return kg_oa_tuple_equal(&p, &q);
}

kg_oa_edge kg_oa_edge_below(const kg_oa_sheet *sheet, int x, int row) {
    if (kg_oa_bent(sheet, x, row) < 0 && kg_oa_bent(sheet, x, row + 1) < 0) {
        int32_t upper = sheet->place[kg_oa_cell(sheet, x, row)];
        int32_t lower = sheet->place[kg_oa_cell(sheet, x, row + 1)];
        if (kg_oa_place_lower(upper) != kg_oa_place_upper(lower))
            return KG_OA_CUT;
        if ((upper & 1) == (lower & 1))
            return KG_OA_NONE;
        return upper & 1 ? KG_OA_MOUNTAIN : KG_OA_VALLEY;
    }
    /* the piece with the lower edge of the upper cell, and with the upper edge of the lower one */
    int above = kg_oa_cell_shape(sheet, x, row) == KG_OA_SLASH;
    int below = kg_oa_cell_shape(sheet, x, row + 1) == KG_OA_BACKSLASH;
    kg_oa_piece a = kg_oa_cell_piece(sheet, x, row, above);
    kg_oa_piece b = kg_oa_cell_piece(sheet, x, row + 1, below);
    if (!meet(&a, 0, -1, &b, 0, 0) || !meet(&a, 1, -1, &b, 1, 0))
        return KG_OA_CUT;
    return a.plane == b.plane ? KG_OA_NONE : turn(a.plane, upward[b.plane], -1);
}

kg_oa_edge kg_oa_edge_right(const kg_oa_sheet *sheet, int x, int row) {
    if (kg_oa_bent(sheet, x, row) < 0 && kg_oa_bent(sheet, x + 1, row) < 0) {
        size_t cell = kg_oa_cell(sheet, x, row);
        return sheet->place[cell] == sheet->place[cell + 1] ? KG_OA_NONE : KG_OA_CUT;
    }
    kg_oa_piece a = kg_oa_cell_piece(sheet, x, row, 1), b = kg_oa_cell_piece(sheet, x + 1, row, 0);
    if (!meet(&a, 1, 0, &b, 0, 0) || !meet(&a, 1, -1, &b, 0, -1))
        return KG_OA_CUT;
    return a.plane == b.plane ? KG_OA_NONE : turn(a.plane, across[b.plane], 1);
}

kg_oa_edge kg_oa_edge_inside(const kg_oa_sheet *sheet, int x, int row) {
    kg_oa_shape shape = kg_oa_cell_shape(sheet, x, row);
    if (shape == KG_OA_WHOLE)
        return KG_OA_NONE;
    int low = shape == KG_OA_SLASH ? -1 : 0; /* dt of the diagonal's left end */
    kg_oa_piece a = kg_oa_cell_piece(sheet, x, row, 0), b = kg_oa_cell_piece(sheet, x, row, 1);
    if (!meet(&a, 0, low, &b, 0, low) || !meet(&a, 1, -1 - low, &b, 1, -1 - low))
        return KG_OA_CUT;
    return a.plane == b.plane ? KG_OA_NONE : turn(a.plane, across[b.plane], 1);
}
