/*
 * What the files of the renderer share: its programs, and one frame's view of a scene.
 */
#ifndef KG_RENDER_RENDERER_H
#define KG_RENDER_RENDERER_H

#include "katagami/render.h"
#include "render/program.h"
#include "render/shape.h"

struct kg_renderer {
    kg_program programs[KG_PROGRAM_COUNT];
    GLuint no_vertices; /* the vertex array of the background */
};

/* A camera and the framebuffer pixels it fills. */
typedef struct kg_frame {
    const kg_camera *camera;
    kg_viewport viewport;
    double near, far; /* mm */
    float projection[16];
} kg_frame;

/* Pixels of the framebuffer, from its lower left corner. */
typedef struct kg_rect {
    int x, y, width, height;
} kg_rect;

kg_frame kg_frame_make(const kg_camera *camera, kg_box3 box, kg_viewport viewport);

/* A line or point is drawn in two parts: its core and its soft rim (see line.frag). */
typedef enum kg_part { KG_PART_CORE, KG_PART_RIM } kg_part;

/* Draws one item under the current depth, blend and cull settings. */
void kg_frame_item(const kg_renderer *renderer, const kg_frame *frame, const kg_item *item,
                   kg_part part);

/* kg_renderer_draw() into a part `clip` of the framebuffer: pictures larger than one framebuffer
 * are drawn tile by tile. */
void kg_renderer_draw_clipped(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                              kg_viewport viewport, kg_rect clip);

/* The directions of x, y and z in the lower left corner, over what is there. */
void kg_frame_axes(const kg_renderer *renderer, const kg_frame *frame);

#endif
