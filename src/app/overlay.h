/*
 * What tools show in the 3D view for the moment: lines, points and surfaces made anew each frame.
 */
#ifndef KG_APP_OVERLAY_H
#define KG_APP_OVERLAY_H

#include "katagami/render.h"

typedef struct kg_overlay {
    struct {
        kg_shape **items;
        size_t count, capacity;
    } shapes; /* owned */
    struct {
        kg_item *items;
        size_t count, capacity;
    } items;
} kg_overlay;

/* What cannot be shown for want of memory is left out. */
void kg_overlay_line(kg_overlay *overlay, const kg_vec3 *points, size_t count, kg_style style);
void kg_overlay_lines(kg_overlay *overlay, const kg_lines *lines, kg_style style);
void kg_overlay_points(kg_overlay *overlay, const kg_vec3 *points, size_t count, kg_style style);
void kg_overlay_surface(kg_overlay *overlay, const kg_surface *surface, kg_style style);
/* A shape that somebody else owns. */
void kg_overlay_item(kg_overlay *overlay, const kg_shape *shape, kg_style style);
void kg_overlay_clear(kg_overlay *overlay);

#endif
