#include "app/overlay.h"

#include "base/array.h"

#include <stdlib.h>

static void keep(kg_overlay *o, kg_shape *shape, kg_style style) {
    if (!kg_push(&o->shapes, shape)) {
        kg_shape_destroy(shape);
        return;
    }
    kg_overlay_item(o, shape, style);
}

void kg_overlay_line(kg_overlay *o, const kg_vec3 *points, size_t count, kg_style style) {
    uint32_t starts[2] = {0, (uint32_t)count};
    kg_lines lines = {points, starts, 1};
    if (count >= 2)
        kg_overlay_lines(o, &lines, style);
}

void kg_overlay_lines(kg_overlay *o, const kg_lines *lines, kg_style style) {
    kg_shape *shape;
    if (!kg_shape_from_lines(lines, &shape, NULL))
        keep(o, shape, style);
}

void kg_overlay_points(kg_overlay *o, const kg_vec3 *points, size_t count, kg_style style) {
    kg_shape *shape;
    if (count > 0 && !kg_shape_from_points(points, count, &shape, NULL))
        keep(o, shape, style);
}

void kg_overlay_surface(kg_overlay *o, const kg_surface *surface, kg_style style) {
    kg_shape *shape;
    if (surface->triangle_count > 0 && !kg_shape_from_surface(surface, &shape, NULL))
        keep(o, shape, style);
}

void kg_overlay_item(kg_overlay *o, const kg_shape *shape, kg_style style) {
    kg_item item = {.shape = shape, .style = style};
    if (shape && !kg_push(&o->items, item))
        return; /* it is left out */
}

void kg_overlay_clear(kg_overlay *o) {
    for (size_t i = 0; i < o->shapes.count; i++)
        kg_shape_destroy(o->shapes.items[i]);
    free(o->shapes.items);
    free(o->items.items);
    *o = (kg_overlay){0};
}
