/*
 * A card as surfaces and lines whose points are multiples of the five vectors of kg_oa_axes: made
 * once for a sheet, put into any pose by a sum of five products for each point.
 */
#ifndef KG_APP_MODES_CARD_FRAME_H
#define KG_APP_MODES_CARD_FRAME_H

#include "katagami/oa.h"
#include "katagami/render.h"

/* Surfaces: cells that are firm, loose, held by nothing, or in the remark that is shown. */
typedef enum kg_card_area {
    KG_AREA_FIRM,
    KG_AREA_LOOSE,
    KG_AREA_FAULT,
    KG_AREA_SHOWN,
    KG_AREA_COUNT
} kg_card_area;

typedef enum kg_card_line {
    KG_CARD_GRID,
    KG_CARD_EDGE, /* cuts and outline */
    KG_CARD_MOUNTAIN,
    KG_CARD_VALLEY,
    KG_CARD_HATCH_LOOSE,
    KG_CARD_HATCH_FAULT,
    KG_CARD_HATCH_SHOWN,
    KG_CARD_LINE_COUNT
} kg_card_line;

/* Multiples of a quarter of each vector. */
typedef struct kg_card_points {
    kg_oa_tuple *items;
    size_t count, capacity;
} kg_card_points;

typedef struct kg_card_frame {
    kg_card_points
        surfaces[KG_AREA_COUNT]; /* four for each face, the last two alike in triangles */
    kg_card_points lines[KG_CARD_LINE_COUNT]; /* two for each line */
    int margin;
    double cell_mm;
} kg_card_frame;

/* `shown`: a remark, -1 for none. */
kg_status kg_card_frame_make(const kg_oa *oa, const kg_oa_sheet *sheet,
                             const kg_oa_stability *stability, const kg_oa_remarks *remarks,
                             int shown, kg_card_frame *out_frame, kg_error *error) KG_CHECKED;
void kg_card_frame_clear(kg_card_frame *frame);

/* Points at one opening, world mm; `out` has room for all of them. */
void kg_card_frame_pose(const kg_card_frame *frame, const kg_card_points *points, double open,
                        kg_vec3 *out);

/* The corners of a piece of a cell at one opening, around its printed side; returns how many. */
int kg_card_cell_corners(const kg_oa *oa, const kg_oa_sheet *sheet, int x, int row, int side,
                         double open, kg_vec3 out[4]);

#endif
