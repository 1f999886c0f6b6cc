/*
 * Shapes: vertex arrays on the graphics card.
 */
#ifndef KG_RENDER_SHAPE_H
#define KG_RENDER_SHAPE_H

#include "katagami/render.h"

#include <epoxy/gl.h>

typedef enum kg_shape_kind { KG_SHAPE_SURFACE, KG_SHAPE_LINES, KG_SHAPE_POINTS } kg_shape_kind;

struct kg_shape {
    kg_shape_kind kind;
    GLuint array, vertices, indices; /* indices: surfaces only */
    GLsizei count;                   /* indices, segments or points */
    kg_vec3 origin;                  /* vertices are floats relative to it */
    kg_box3 box;
};

/* A piece of a line: xyz relative to the shape's origin and the line's arc length up to there. */
typedef struct kg_segment {
    float start[4], end[4];
    float normal_a[3], normal_b[3]; /* of the surfaces on both sides: drawn only where one faces
                                       the eye and the other does not; 0: drawn always */
} kg_segment;

/* `box` holds all of the segments; its center is their origin. */
kg_status kg_shape_from_segments(const kg_segment *segments, size_t count, kg_box3 box,
                                 kg_shape **out_shape, kg_error *error) KG_CHECKED;

/* Bounds of `points`; KG_ERR_INPUT unless all are finite. */
kg_status kg_shape_bounds(const kg_vec3 *points, size_t count, kg_box3 *out_box,
                          kg_error *error) KG_CHECKED;
/* The same for a surface, whose indices must be in range. */
kg_status kg_shape_check(const kg_surface *surface, kg_box3 *out_box, kg_error *error) KG_CHECKED;
/* The origin of a shape with these bounds. */
kg_vec3 kg_shape_center(kg_box3 box);
void kg_shape_store(kg_vec3 p, float out[3]);

/* Draws all of it with the bound program. */
void kg_shape_draw(const kg_shape *shape);

#endif
