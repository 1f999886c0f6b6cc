/* Laying a sheet out: shared by the modules' files. */
#ifndef KG_OA_SHEET_H
#define KG_OA_SHEET_H

#include "katagami/oa.h"

/* Row of the front cell at level z of a column without margins. */
static inline int kg_oa_front_row(const kg_oa *oa, int x, int z) {
    return oa->height - 1 - (z - kg_oa_depth(oa, x, z));
}

/* A cell's place as one number, so that neighbours are placed alike when numbers are equal. */
static inline int32_t kg_oa_place(int y, bool horizontal) {
    return 2 * y + horizontal;
}
/* y of a cell's upper and lower edge. */
static inline int kg_oa_place_upper(int32_t place) {
    return place >> 1;
}
static inline int kg_oa_place_lower(int32_t place) {
    return (place >> 1) + (place & 1);
}

static inline size_t kg_oa_cell(const kg_oa_sheet *sheet, int x, int row) {
    return (size_t)row * (size_t)sheet->width + (size_t)x;
}

/* Index of a bent cell, or -1. */
static inline int32_t kg_oa_bent(const kg_oa_sheet *sheet, int x, int row) {
    return sheet->bent ? sheet->bent[kg_oa_cell(sheet, x, row)] : -1;
}

/* The rows [*out_first, *out_last] that the run of windows through level z of column x takes along,
 * and its ends z0 and z1. */
void kg_oa_window_run(const kg_oa *oa, int x, int z, int *out_z0, int *out_z1, int *out_first,
                      int *out_last);

/* Where the k-th cell of such a run, counted from its lower end, is placed. */
static inline int32_t kg_oa_pushed_place(int depth, int k) {
    return k < depth ? kg_oa_place(depth - 1 - k, true) : kg_oa_place(0, false);
}

/* Where the i-th cell of an omitted top at height z, behind which y = `depth`, falls. */
static inline int32_t kg_oa_fallen_place(int depth, int z, int i) {
    return i < z ? kg_oa_place(depth, false) : kg_oa_place(depth + i - z, true);
}

/* Lays out one column of a card, without regard to margins and pyramids: place and marks of its
 * H + D cells from above. */
void kg_oa_lay_column(const kg_oa *oa, int x, int32_t *place, unsigned char *marks);

/* The card with its margins as cells of its own, for kg_oa_destroy; its title and net are empty.
 * NULL when memory runs out. */
kg_oa *kg_oa_with_margins(const kg_oa *oa);

/* Goes on with both floods from the cells that `reached` names; returns how many cells that
 * something must hold one of them misses. */
size_t kg_oa_flood_on(const kg_oa_sheet *sheet, unsigned char *reached);

/* Takes out windows and omissions of a column whose face is gone. */
void kg_oa_clear_faceless(kg_oa *oa, int x);

/* Finds the pyramids of a card without margins and bends the sheet's cells along them. */
kg_status kg_oa_bend(const kg_oa *oa, kg_oa_sheet *sheet, kg_error *error) KG_CHECKED;

/* How far from the fold the farthest corner of a cell lies when the card is closed, cells. */
int kg_oa_closed_reach(const kg_oa_sheet *sheet, int x, int row);
/* How far the card itself reaches then. */
static inline int kg_oa_closed_length(const kg_oa_sheet *sheet) {
    return sheet->height > sheet->depth ? sheet->height : sheet->depth;
}

/* Corners of a piece, as dx and -dt, around its printed side; by kg_oa_shape and side. */
typedef struct kg_oa_outline {
    int count, corners[4][2];
} kg_oa_outline;
extern const kg_oa_outline kg_oa_outlines[3][2];

/* Where a point of the sheet lies in the world of models, mm. */
kg_vec3 kg_oa_place_point(const kg_oa_tuple *point, const kg_vec3 axes[5], int margin, double cell);

static inline bool kg_oa_tuple_equal(const kg_oa_tuple *a, const kg_oa_tuple *b) {
    for (int i = 0; i < 5; i++)
        if (a->v[i] != b->v[i])
            return false;
    return true;
}

#endif
