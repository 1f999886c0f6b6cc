/* Framebuffers to draw into, beside a window's. */
#ifndef KG_RENDER_TARGET_H
#define KG_RENDER_TARGET_H

#include "katagami/base.h"

#include <epoxy/gl.h>

/* A framebuffer of its own with depth, bound until it is destroyed. */
typedef struct kg_target {
    GLuint framebuffer, color, depth;
    GLint previous;
} kg_target;
kg_status kg_target_create(int width, int height, GLenum format, kg_target *out_target,
                           kg_error *error) KG_CHECKED;
void kg_target_destroy(kg_target *target);

#endif
