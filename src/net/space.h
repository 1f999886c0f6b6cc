/* What is drawn on a page as short segments, and the room between them where text may stand. */
#ifndef KG_NET_SPACE_H
#define KG_NET_SPACE_H

#include "net/drawing.h"

typedef struct kg_wall {
    kg_vec2 a, b;
    int part;     /* number, 0: of the page */
    bool contour; /* of a closed cut, which bounds paper; a slit does not */
} kg_wall;

typedef struct kg_space {
    kg_box2 room; /* where text may stand */
    struct {
        kg_wall *items;
        size_t count, capacity;
    } walls;
} kg_space;

/* A rectangle turned by `angle`. */
typedef struct kg_block {
    kg_vec2 center, half;
    double angle;
} kg_block;

/* The walls of a page's strokes, flattened to KG_SPACE_SAG. False when memory runs out. */
#define KG_SPACE_SAG 0.1
bool kg_space_create(const kg_page *page, kg_box2 room, kg_space *out_space) KG_CHECKED;
void kg_space_clear(kg_space *space);
bool kg_space_add_wall(kg_space *space, kg_vec2 a, kg_vec2 b, int part) KG_CHECKED;

/* True when p lies on the paper of the part with that number; of any part for number 0. */
bool kg_space_inside(const kg_space *space, int part, kg_vec2 p);

/* True when a wall of that part (0: any wall) runs through the block. */
bool kg_space_blocked(const kg_space *space, int part, const kg_block *block);

/* True when the block lies in the room for text. */
bool kg_space_holds(const kg_space *space, const kg_block *block);

/* True when two blocks overlap (separating axes). */
bool kg_blocks_overlap(const kg_block *a, const kg_block *b);

/*
 * The place within a part that is farthest from its walls, measured in a metric in which a text of
 * `aspect` (width over height) turned by `angle` is a square: a pole of inaccessibility in the
 * text's own shape. Returns the half height of the text whose circumscribed ellipse fits there, 0
 * when the part has no inside.
 */
double kg_space_pole(const kg_space *space, int part, double angle, double aspect,
                     kg_vec2 *out_center);

#endif
