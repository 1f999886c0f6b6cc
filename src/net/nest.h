/*
 * Nesting: parts with holes and hollows placed on pages by their true outlines.
 *
 * Shapes are rasterised once per rotation, one raster widened by the spacing and one not; both
 * cover every cell the shape touches, so two rasters without a common cell prove that the distance
 * is kept. Parts go one by one to the place nearest the top of the first page that has room
 * (bottom-left filling, upside down), over all rotations; orders are improved by a seeded local
 * search with a fixed amount of work. The result is then confirmed on the exact outlines.
 */
#ifndef KG_NET_NEST_H
#define KG_NET_NEST_H

#include "katagami/base.h"

typedef struct kg_nest_loop {
    const kg_vec2 *points; /* mm, closed without repeating the first point */
    size_t count;
} kg_nest_loop;

/* Where a part goes: a point p of it lands at R(angle) p + offset, from the upper left corner of
 * the usable area of that page. R turns x towards y. */
typedef struct kg_nest_place {
    int page; /* from 0; -1: does not fit on any page */
    double angle;
    kg_vec2 offset;
    bool clash; /* a pinned part that leaves its page or comes too near to another pinned part or a
                   forbidden rectangle */
} kg_nest_place;

typedef struct kg_nest_part {
    const kg_nest_loop *loops; /* outer contour first, then holes, in any orientation */
    size_t loop_count;
    bool pinned;
    kg_nest_place pin; /* when pinned */
} kg_nest_part;

typedef enum kg_nest_turn {
    KG_NEST_FREE,      /* any rotation that helps */
    KG_NEST_HALF_TURN, /* keeps the paper's grain: 0 or 180 degrees */
    KG_NEST_FIXED      /* as the parts are */
} kg_nest_turn;

typedef struct kg_nest_options {
    double width, height; /* mm, the usable area of a page */
    double spacing;       /* mm between parts, and between parts and forbidden rectangles */
    int max_pages;
    kg_nest_turn turn;
    size_t forbidden_count; /* rectangles of every page that stay empty */
    const kg_box2 *forbidden;
} kg_nest_options;

/* A4 without a margin of 8 mm, 2 mm between parts, free rotation, 1000 pages at most. */
kg_nest_options kg_nest_options_default(void);

/*
 * Places `count` parts on as few pages as it finds, filling the first ones most.
 *
 * out_places: `count` places; page -1 marks a part that is larger than a page or came after
 * max_pages were full. Pinned parts stay where they are said to be; the others keep clear of them.
 * The same input gives the same places.
 *
 * Errors: KG_ERR_INPUT (coordinates that are no numbers, a page or part without area, a pin outside
 * max_pages), KG_ERR_MEMORY, KG_ERR_CANCELLED.
 */
kg_status kg_nest(const kg_nest_part *parts, size_t count, const kg_nest_options *options,
                  const kg_progress *progress, kg_nest_place *out_places,
                  kg_error *error) KG_CHECKED;

#endif
