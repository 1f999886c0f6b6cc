#include "render/target.h"

static GLuint attach(GLenum attachment, GLenum format, int width, int height) {
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return buffer;
}

kg_status kg_target_create(int width, int height, GLenum format, kg_target *out_target,
                           kg_error *error) {
    kg_target t = {0};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &t.previous);
    glGenFramebuffers(1, &t.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    t.color = attach(GL_COLOR_ATTACHMENT0, format, width, height);
    t.depth = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        kg_target_destroy(&t);
        return kg_fail(error, KG_ERR_SYSTEM,
                       "the OpenGL driver cannot make a picture buffer of %d x %d pixels", width,
                       height);
    }
    *out_target = t;
    return KG_OK;
}

void kg_target_destroy(kg_target *target) {
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)target->previous);
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteRenderbuffers(1, &target->color);
    glDeleteRenderbuffers(1, &target->depth);
}
