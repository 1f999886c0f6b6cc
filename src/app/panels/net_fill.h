/*
 * Filling outlines that are no convex polygons, on the canvas: even-odd, row by row, so holes and
 * outlines that cross themselves need no triangles.
 */
#ifndef KG_APP_PANELS_NET_FILL_H
#define KG_APP_PANELS_NET_FILL_H

#include "app/net_view.h"

typedef struct kg_polyline {
    kg_vec2 *items; /* pixels */
    size_t count, capacity;
} kg_polyline;

/* Outlines to fill together. */
typedef struct kg_fill {
    kg_polyline points;
    struct {
        size_t *items;
        size_t count, capacity;
    } ends; /* of each outline in points */
} kg_fill;

void kg_fill_begin(kg_fill *fill);
/* Adds a closed outline; its last point may repeat the first. Without memory it is left out. */
void kg_fill_add(kg_fill *fill, const kg_polyline *outline);
void kg_fill_end(kg_fill *fill);

/* Only within `clip`. */
void kg_fill_rows(const kg_fill *fill, kg_color color, const kg_area *clip);
/* Slanted lines, `spacing` pixels apart. */
void kg_fill_hatch(const kg_fill *fill, kg_color color, double spacing, double width,
                   const kg_area *clip);

/* A pixel well inside a part: the middle of the longest of some rows through it. */
bool kg_fill_inside(const kg_net_view *view, size_t part, kg_vec2 *out);

#endif
