/* What of folded sheets lies under the pointer, as drawn. Positions are pixels of the window. */
#ifndef KG_APP_MODES_SHEET_PICK_H
#define KG_APP_MODES_SHEET_PICK_H

#include "app/modes/sheet_state.h"

/* Where a line of sight goes through a layer. */
typedef struct kg_sheet_hit {
    double distance; /* mm from the eye, as drawn; first, see kg_hits_keep */
    int32_t loop;
    bool front;       /* it is seen from the front */
    kg_vec3 drawn;    /* in space, as drawn */
    kg_vec3 position; /* without the thickness of layers */
    kg_vec2 paper;    /* on the sheet */
} kg_sheet_hit;

/* All layers under a pixel, the nearest first, then what lies below; returns how many, at most
 * `most`. */
size_t kg_sheets_hit(const kg_editor *editor, kg_vec2 px, kg_sheet_hit *out_hits, size_t most);

/* A corner of a layer. Layers have corners of their own: several share a vertex. */
typedef struct kg_sheet_corner {
    int32_t vertex;
    int32_t half, loop; /* half-edge that starts there, and its loop */
    kg_vec3 drawn;
    double distance_px; /* from the pointer */
    bool hidden;        /* behind other paper */
} kg_sheet_corner;

/* The corner within `radius_px` of a pixel: one that can be seen rather than a hidden one, the
 * nearest to the pointer of them, and the one nearest to the eye of those in one place. */
bool kg_sheets_nearest_vertex(const kg_editor *editor, kg_vec2 px, double radius_px,
                              kg_sheet_corner *out_corner);

typedef struct kg_sheet_side {
    int32_t edge;
    int32_t half, loop; /* of the layer that it was found in */
    double along;       /* [0, 1] from the origin of `half` to its end */
    kg_vec3 drawn;      /* the nearest point of it */
    kg_vec3 position;   /* without the thickness of layers */
    double distance_px;
    bool hidden;
} kg_sheet_side;

/* The edge, in the same way. */
bool kg_sheets_nearest_edge(const kg_editor *editor, kg_vec2 px, double radius_px,
                            kg_sheet_side *out_side);

#endif
