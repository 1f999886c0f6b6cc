/* What questions about layers start from: loops as plane polygons, and the orders of each loop. */
#ifndef KG_ORIGAMI_OUTLINE_H
#define KG_ORIGAMI_OUTLINE_H

#include "origami/state.h"

/* A side of a loop as the half-plane that holds it: a point p is dot(inward, p) - offset mm inside.
 * Sides no longer than the state's touch have no direction to speak of and hold everything. */
typedef struct kg_outline_side {
    kg_vec2 inward;
    double offset;
} kg_outline_side;

/* Which of a few points, the same for all loops, are inside a loop, farther than the state's touch
 * from every side. Two loops of one group that hold the same point overlap, which settles most
 * pairs of a stack. */
enum { KG_PROBES = 128 };
typedef struct kg_probe_bits {
    uint64_t words[KG_PROBES / 64];
} kg_probe_bits;

/* Loops in the axes of their groups' planes (kg_plane_axes), counter-clockwise there: reversed
 * where the back shows. */
typedef struct kg_outlines {
    size_t *starts; /* loop count + 1 */
    kg_vec2 *points;
    kg_outline_side *sides; /* one from each point to the next */
    kg_box2 *boxes;
    kg_vec2 *middles; /* means of the corners */
    kg_probe_bits *probes;
    signed char *facing; /* 1: the loop's front is on the side of the group's normal, else -1 */
} kg_outlines;

kg_status kg_outlines_create(const kg_origami_state *state, kg_outlines *out);
/* Fills in the probes, which are empty until then: worth it before many pairs are looked at. */
void kg_outlines_probe(kg_outlines *outlines, const kg_origami_state *state);
void kg_outlines_clear(kg_outlines *outlines);

static inline size_t kg_outline_size(const kg_outlines *o, int32_t loop) {
    return o->starts[loop + 1] - o->starts[loop];
}
static inline const kg_vec2 *kg_outline_points(const kg_outlines *o, int32_t loop) {
    return o->points + o->starts[loop];
}
/* The same for loops whose boxes overlap and that hold no probe together. */
bool kg_outlines_meet(const kg_outlines *outlines, int32_t a, int32_t b, double tolerance);
/* Both in one group: they overlap by more than `tolerance` mm, the state's touch, in any direction
 * normal to a side. */
static inline bool kg_outlines_overlap(const kg_outlines *o, int32_t a, int32_t b,
                                       double tolerance) {
    uint64_t common = 0;
    for (int i = 0; i < KG_PROBES / 64; i++)
        common |= o->probes[a].words[i] & o->probes[b].words[i];
    if (common != 0)
        return true;
    const kg_box2 *x = &o->boxes[a], *y = &o->boxes[b];
    return x->lo.x + tolerance < y->hi.x && y->lo.x + tolerance < x->hi.x &&
           x->lo.y + tolerance < y->hi.y && y->lo.y + tolerance < x->hi.y &&
           kg_outlines_meet(o, a, b, tolerance);
}

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
