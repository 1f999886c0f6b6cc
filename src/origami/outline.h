/* What questions about layers start from: loops as plane polygons. */
#ifndef KG_ORIGAMI_OUTLINE_H
#define KG_ORIGAMI_OUTLINE_H

#include "origami/state.h"

/* A side of a loop as the half-plane that holds it: a point p is dot(inward, p) - offset mm inside.
 * Sides no longer than the state's touch have no direction to speak of and hold everything. */
typedef struct kg_outline_side {
    kg_vec2 inward;
    double offset;
} kg_outline_side;

/* Loops in the axes of their groups' planes (kg_plane_axes), counter-clockwise there: reversed
 * where the back shows. */
typedef struct kg_outlines {
    size_t *starts; /* loop count + 1 */
    kg_vec2 *points;
    kg_outline_side *sides; /* one from each point to the next */
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
/* How far a point is inside, mm; negative outside. */
static inline double kg_outline_depth(const kg_outline_side *side, kg_vec2 p) {
    return kg_dot2(side->inward, p) - side->offset;
}

/* The same for loops whose boxes overlap. */
bool kg_outlines_meet(const kg_outlines *outlines, int32_t a, int32_t b, double tolerance);
/* Both in one group: they overlap by more than `tolerance` mm, the state's touch, in any direction
 * normal to a side. */
static inline bool kg_outlines_overlap(const kg_outlines *o, int32_t a, int32_t b,
                                       double tolerance) {
    const kg_box2 *x = &o->boxes[a], *y = &o->boxes[b];
    return x->lo.x + tolerance < y->hi.x && y->lo.x + tolerance < x->hi.x &&
           x->lo.y + tolerance < y->hi.y && y->lo.y + tolerance < x->hi.y &&
           kg_outlines_meet(o, a, b, tolerance);
}

#endif
