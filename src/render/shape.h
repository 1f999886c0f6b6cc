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

/* Draws all of it with the bound program. */
void kg_shape_draw(const kg_shape *shape);

#endif
