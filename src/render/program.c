#include "render/program.h"

#include "render/shaders.h"

static const char *const uniform_names[KG_UNIFORM_COUNT] = {
    [KG_UNIFORM_MODEL_VIEW] = "model_view",
    [KG_UNIFORM_PROJECTION] = "projection",
    [KG_UNIFORM_VIEWPORT] = "viewport",
    [KG_UNIFORM_WIDTH] = "width",
    [KG_UNIFORM_MM_PER_PX] = "mm_per_px",
    [KG_UNIFORM_PX_PER_MM] = "px_per_mm",
    [KG_UNIFORM_NEAR] = "near",
    [KG_UNIFORM_ORTHO] = "ortho",
    [KG_UNIFORM_FRONT] = "front",
    [KG_UNIFORM_BACK] = "back",
    [KG_UNIFORM_HIGHLIGHT] = "highlight",
    [KG_UNIFORM_LIT] = "lit",
    [KG_UNIFORM_EVEN] = "even",
    [KG_UNIFORM_UP] = "up",
    [KG_UNIFORM_COLOR_IN] = "color_in",
    [KG_UNIFORM_DASHES] = "dashes",
    [KG_UNIFORM_SQUARE] = "square",
    [KG_UNIFORM_RAISE] = "raise",
    [KG_UNIFORM_PART] = "part",
    [KG_UNIFORM_TOP] = "top",
    [KG_UNIFORM_BOTTOM] = "bottom",
};

static const struct {
    const char *name, *vertex, *fragment;
} sources[KG_PROGRAM_COUNT] = {
    [KG_PROGRAM_SURFACE] = {"surface", kg_shader_surface_vert, kg_shader_surface_frag},
    [KG_PROGRAM_LINES] = {"line", kg_shader_line_vert, kg_shader_line_frag},
    [KG_PROGRAM_POINTS] = {"point", kg_shader_point_vert, kg_shader_point_frag},
    [KG_PROGRAM_BACKGROUND] = {"background", kg_shader_background_vert, kg_shader_background_frag},
};

static bool attach(GLuint program, GLenum stage, const char *text, char *log, GLsizei log_size) {
    GLuint shader = glCreateShader(stage);
    const char *parts[] = {"#version 330 core\n", "#line 1\n", text};
    glShaderSource(shader, 3, parts, NULL);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        glAttachShader(program, shader);
    else
        glGetShaderInfoLog(shader, log_size, NULL, log);
    glDeleteShader(shader); /* stays alive while attached */
    return compiled;
}

kg_status kg_program_create(kg_program_kind kind, kg_program *out_program, kg_error *error) {
    char log[512] = "";
    kg_program p = {glCreateProgram(), {0}};
    GLint linked = GL_FALSE;
    if (attach(p.name, GL_VERTEX_SHADER, sources[kind].vertex, log, sizeof log) &&
        attach(p.name, GL_FRAGMENT_SHADER, sources[kind].fragment, log, sizeof log)) {
        glLinkProgram(p.name);
        glGetProgramiv(p.name, GL_LINK_STATUS, &linked);
        if (!linked)
            glGetProgramInfoLog(p.name, sizeof log, NULL, log);
    }
    if (!linked) {
        glDeleteProgram(p.name);
        return kg_fail(error, KG_ERR_SYSTEM,
                       "the OpenGL driver refuses the %s shader: %s; try another driver, for "
                       "example with LIBGL_ALWAYS_SOFTWARE=1",
                       sources[kind].name, log);
    }
    for (int i = 0; i < KG_UNIFORM_COUNT; i++)
        p.at[i] = glGetUniformLocation(p.name, uniform_names[i]);
    *out_program = p;
    return KG_OK;
}
