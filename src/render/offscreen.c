#include "katagami/render.h"

#include "base/phrase.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <stdlib.h>

struct kg_offscreen {
    EGLDisplay display;
    EGLContext context;
};

#define ADVICE kg_phrase("install libegl1, libegl-mesa0 and libgl1-mesa-dri")

/* epoxy ends the program when it cannot load a library, so that is tried first. */
static bool loads(const char *library) {
    void *handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle)
        dlclose(handle);
    return handle != NULL;
}

static kg_status open_context(kg_offscreen *o, kg_error *error) {
    /* The extension's own function: epoxy aborts at plain eglGetPlatformDisplay, since it cannot
     * know EGL's version before there is a display. */
    o->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (o->display == EGL_NO_DISPLAY || !eglInitialize(o->display, NULL, NULL))
        return kg_fail(error, KG_ERR_SYSTEM, "EGL finds no driver to draw with; %s", ADVICE);
    static const EGLint config_wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    static const EGLint context_wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(o->display, config_wanted, &config, 1, &count))
        return kg_fail(error, KG_ERR_SYSTEM, "EGL has no OpenGL on this machine; %s", ADVICE);
    o->context = eglCreateContext(o->display, count ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                  context_wanted);
    if (o->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(o->display, EGL_NO_SURFACE, EGL_NO_SURFACE, o->context))
        return kg_fail(error, KG_ERR_SYSTEM,
                       "this machine's driver has no OpenGL 3.3 without a window (EGL error "
                       "0x%x); set LIBGL_ALWAYS_SOFTWARE=1 or %s",
                       (unsigned)eglGetError(), ADVICE);
    return KG_OK;
}

kg_status kg_offscreen_create(kg_offscreen **out_offscreen, kg_error *error) {
    if (!loads("libEGL.so.1") || !(loads("libOpenGL.so.0") || loads("libGL.so.1")))
        return kg_fail(error, KG_ERR_SYSTEM,
                       "pictures need EGL and OpenGL, whose libraries are missing; %s and libgl1",
                       ADVICE);
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        return kg_fail(error, KG_ERR_SYSTEM,
                       "this machine's EGL cannot draw without a display "
                       "(EGL_MESA_platform_surfaceless is missing); %s",
                       ADVICE);
    kg_offscreen *o = calloc(1, sizeof *o);
    if (!o)
        return kg_fail(error, KG_ERR_MEMORY, "no memory for an off-screen context");
    o->display = EGL_NO_DISPLAY;
    o->context = EGL_NO_CONTEXT;
    kg_status status = open_context(o, error);
    if (status) {
        kg_offscreen_destroy(o);
        return status;
    }
    *out_offscreen = o;
    return KG_OK;
}

void kg_offscreen_destroy(kg_offscreen *offscreen) {
    if (!offscreen)
        return;
    if (offscreen->context != EGL_NO_CONTEXT) {
        eglMakeCurrent(offscreen->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(offscreen->display, offscreen->context);
    }
    /* The display stays: it is the process's, and other off-screen contexts share it. */
    free(offscreen);
}
