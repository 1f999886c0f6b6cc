/*
 * Shader programs, compiled from the texts that the build embeds.
 */
#ifndef KG_RENDER_PROGRAM_H
#define KG_RENDER_PROGRAM_H

#include "katagami/base.h"

#include <epoxy/gl.h>

/* Every uniform of every shader, once; program.c has their names. */
typedef enum kg_uniform {
    KG_UNIFORM_MODEL_VIEW,
    KG_UNIFORM_PROJECTION,
    KG_UNIFORM_VIEWPORT,
    KG_UNIFORM_WIDTH,
    KG_UNIFORM_MM_PER_PX,
    KG_UNIFORM_PX_PER_MM,
    KG_UNIFORM_NEAR,
    KG_UNIFORM_ORTHO,
    KG_UNIFORM_FRONT,
    KG_UNIFORM_BACK,
    KG_UNIFORM_HIGHLIGHT,
    KG_UNIFORM_LIT,
    KG_UNIFORM_EVEN,
    KG_UNIFORM_UP,
    KG_UNIFORM_COLOR_IN,
    KG_UNIFORM_DASHES,
    KG_UNIFORM_SQUARE,
    KG_UNIFORM_RAISE,
    KG_UNIFORM_PART,
    KG_UNIFORM_TOP,
    KG_UNIFORM_BOTTOM,
    KG_UNIFORM_COUNT
} kg_uniform;

typedef struct kg_program {
    GLuint name;
    GLint at[KG_UNIFORM_COUNT]; /* -1 where the program has no such uniform */
} kg_program;

typedef enum kg_program_kind {
    KG_PROGRAM_SURFACE, /* the first three as in kg_shape_kind */
    KG_PROGRAM_LINES,
    KG_PROGRAM_POINTS,
    KG_PROGRAM_BACKGROUND,
    KG_PROGRAM_COUNT
} kg_program_kind;

/* One that fails to compile is a driver's fault: KG_ERR_SYSTEM with its log. */
kg_status kg_program_create(kg_program_kind kind, kg_program *out_program,
                            kg_error *error) KG_CHECKED;

#endif
