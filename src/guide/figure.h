/* Line drawings of flat convex facets in space, with what is hidden left out. */
#ifndef KG_GUIDE_FIGURE_H
#define KG_GUIDE_FIGURE_H

#include "base/array.h"
#include "katagami/base.h"

#include <cairo.h>

/* How a side of a facet is drawn. */
typedef enum kg_side_look {
    KG_SIDE_NONE,
    KG_SIDE_OUTLINE,
    KG_SIDE_CREASE, /* folded once and flat again */
    KG_SIDE_VALLEY, /* to be folded, as seen */
    KG_SIDE_MOUNTAIN
} kg_side_look;

/* Points are as seen: x to the right, y up, z towards the eye; sides run to the next point. */
typedef struct kg_facet {
    size_t first, count; /* counter-clockwise as seen */
    uint32_t color;
    int32_t id;
    double plane[3]; /* z = plane[0] x + plane[1] y + plane[2] */
    kg_box2 box;
    bool clipped; /* seen through its `pieces` only */
    size_t first_piece, piece_count;
} kg_facet;

typedef struct kg_figure {
    struct {
        kg_facet *items;
        size_t count, capacity;
    } facets;
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } points;
    struct {
        unsigned char *items; /* kg_side_look */
        size_t count, capacity;
    } looks;
    struct {
        kg_vec2 *items;
        size_t count, capacity;
    } corners; /* of pieces */
    struct {
        size_t *items; /* the end of each piece in `corners` */
        size_t count, capacity;
    } pieces;
    kg_vec2 shear;  /* by which points were moved, times their height above what they lie on */
    int32_t *order; /* of painting, from the back; after kg_figure_sort */
} kg_figure;

/* Adds a facet; `looks` has one look for each side. Facets seen from their edge are left out. */
kg_status kg_figure_add(kg_figure *figure, const kg_vec3 *points, const unsigned char *looks,
                        size_t count, uint32_t color, int32_t id);
void kg_figure_clear(kg_figure *figure);

/* 1 when the facet with the first id is nearer to the eye than the other where both lie, -1 when it
 * is farther, 0: as their depths say. */
typedef int (*kg_figure_order)(const void *user, int32_t id, int32_t other);

/* Finds the order of painting: a facet comes after all that it covers. Where facets cover each
 * other in a ring, they get clipped to what is seen of them. Facets may touch, but not pass through
 * each other. KG_ERR_MEMORY. */
kg_status kg_figure_sort(kg_figure *figure, kg_figure_order order, const void *user) KG_CHECKED;

/* Paints; a point lies at offset + scale (x, -y), mm. Dashes of folds are measured from `origin`
 * along the line. */
void kg_figure_paint(const kg_figure *figure, cairo_t *cr, double scale, kg_vec2 offset,
                     kg_vec2 origin);

/* Dashes and width of a fold's line on the page, mm. */
void kg_figure_fold_line(cairo_t *cr, bool mountain, double phase);

#endif
