/* What questions about layers start from: loops as plane polygons, and the orders of each loop. */
#ifndef KG_ORIGAMI_OUTLINE_H
#define KG_ORIGAMI_OUTLINE_H

#include "origami/state.h"

/* Loops in the axes of their groups' planes (kg_plane_axes), counter-clockwise there: reversed
 * where the back shows. */
typedef struct kg_outlines {
    size_t *starts; /* loop count + 1 */
    kg_vec2 *points;
    kg_box2 *boxes;
    kg_vec2 *middles;    /* means of the corners */
    signed char *facing; /* 1: the loop's front is on the side of the group's normal, else -1 */
} kg_outlines;

kg_status kg_outlines_create(const kg_origami_state *state, kg_outlines *out);
void kg_outlines_clear(kg_outlines *outlines);

static inline size_t kg_outline_size(const kg_outlines *o, int32_t loop) {
    return o->starts[loop + 1] - o->starts[loop];
}
static inline const kg_vec2 *kg_outline_points(const kg_outlines *o, int32_t loop) {
    return o->points + o->starts[loop];
}
/* Both in one group: they overlap by more than `tolerance` mm. */
bool kg_outlines_overlap(const kg_outlines *outlines, int32_t a, int32_t b, double tolerance);

/* The orders of each loop: of loop i, entries[starts[i]] … entries[starts[i + 1] - 1], by the other
 * loop. There may be millions, so an entry is one number: twice the other loop, and 1 more when
 * that lies above along the group's normal. */
typedef struct kg_layer_rows {
    size_t *starts;
    int32_t *entries;
} kg_layer_rows;

static inline int32_t kg_row_other(const kg_layer_rows *rows, size_t k) {
    return rows->entries[k] >> 1;
}
/* 1: above, -1: below */
static inline int kg_row_above(const kg_layer_rows *rows, size_t k) {
    return 2 * (rows->entries[k] & 1) - 1;
}

kg_status kg_layer_rows_create(const kg_origami_state *state, const kg_outlines *outlines,
                               kg_layer_rows *out);
void kg_layer_rows_clear(kg_layer_rows *rows);

/* Adds an order of two loops: `above` 1 when b lies above a along the group's normal. To be sorted
 * afterwards. */
kg_status kg_orders_add(kg_origami_state *state, const kg_outlines *outlines, int32_t a, int32_t b,
                        int above);
/* By a, then b; linear in the number of orders. */
kg_status kg_orders_sort(kg_origami_state *state);

#endif
