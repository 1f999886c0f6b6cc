#include "app/window.h"

#include "app/app.h"
#include "app/recovery.h"
#include "app/script.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <assert.h>
#include <stdlib.h>
#include <string.h>

static_assert(KG_KEY_ESCAPE == GLFW_KEY_ESCAPE && KG_KEY_END == GLFW_KEY_END &&
                  KG_KEY_F1 == GLFW_KEY_F1 && KG_KEY_PAD_0 == GLFW_KEY_KP_0 &&
                  KG_KEY_PAD_DECIMAL == GLFW_KEY_KP_DECIMAL &&
                  KG_KEY_PAD_ENTER == GLFW_KEY_KP_ENTER && KG_KEY_COUNT > GLFW_KEY_LAST,
              "keys are numbered as GLFW numbers them");

/* How often a waiting script or job is looked at, s. */
#define TICK 0.05

typedef struct window {
    GLFWwindow *handle;
    kg_app *app;
    kg_vec2 pointer; /* pixels */
    unsigned mods;
} window;

/* ---- callbacks: everything becomes an event ----------------------------------------------- */

static window *window_of(GLFWwindow *handle) {
    return glfwGetWindowUserPointer(handle);
}

static unsigned mods_of(int mods) {
    return (mods & GLFW_MOD_SHIFT ? KG_MOD_SHIFT : 0u) |
           (mods & GLFW_MOD_CONTROL ? KG_MOD_CTRL : 0u) | (mods & GLFW_MOD_ALT ? KG_MOD_ALT : 0u);
}

static void push(window *w, kg_event event) {
    event.mods = w->mods;
    event.position = w->pointer;
    kg_events_push(&w->app->events, event);
}

/* Keys of modifiers are told before they count as held (or let go). */
static unsigned mod_of_key(int key) {
    switch (key) {
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT:
        return KG_MOD_SHIFT;
    case GLFW_KEY_LEFT_CONTROL:
    case GLFW_KEY_RIGHT_CONTROL:
        return KG_MOD_CTRL;
    case GLFW_KEY_LEFT_ALT:
    case GLFW_KEY_RIGHT_ALT:
        return KG_MOD_ALT;
    default:
        return 0;
    }
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int mods) {
    window *w = window_of(handle);
    (void)scancode;
    if (key < 0)
        return;
    unsigned held = mod_of_key(key);
    w->mods = mods_of(mods);
    w->mods = action == GLFW_RELEASE ? w->mods & ~held : w->mods | held;
    push(w, (kg_event){.type = action == GLFW_RELEASE ? KG_EVENT_KEY_UP : KG_EVENT_KEY,
                       .key = key,
                       .repeat = action == GLFW_REPEAT});
}

static void on_text(GLFWwindow *handle, unsigned codepoint) {
    push(window_of(handle), (kg_event){.type = KG_EVENT_TEXT, .codepoint = codepoint});
}

/* Pixels per unit of the window's own coordinates. */
static double pixels_per_unit(GLFWwindow *handle) {
    int width, height, pixels, rows;
    glfwGetWindowSize(handle, &width, &height);
    glfwGetFramebufferSize(handle, &pixels, &rows);
    return width > 0 ? (double)pixels / width : 1;
}

static void on_move(GLFWwindow *handle, double x, double y) {
    window *w = window_of(handle);
    double k = pixels_per_unit(handle);
    w->pointer = kg_v2(k * x, k * y);
    push(w, (kg_event){.type = KG_EVENT_MOVE});
}

static void on_button(GLFWwindow *handle, int button, int action, int mods) {
    window *w = window_of(handle);
    w->mods = mods_of(mods);
    if (button < KG_MOUSE_COUNT)
        push(w, (kg_event){.type = action == GLFW_PRESS ? KG_EVENT_PRESS : KG_EVENT_RELEASE,
                           .button = button});
}

static void on_wheel(GLFWwindow *handle, double dx, double dy) {
    (void)dx;
    push(window_of(handle), (kg_event){.type = KG_EVENT_WHEEL, .wheel = dy});
}

static void on_drop(GLFWwindow *handle, int count, const char **paths) {
    if (count > 0)
        push(window_of(handle), (kg_event){.type = KG_EVENT_DROP, .path = strdup(paths[0])});
}

static void on_resize(GLFWwindow *handle, int width, int height) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(handle, &x, &y);
    if (width > 0 && height > 0)
        push(window_of(handle),
             (kg_event){
                 .type = KG_EVENT_RESIZE, .width = width, .height = height, .scale = (double)x});
}

static void on_refresh(GLFWwindow *handle) {
    window_of(handle)->app->redraw = true;
}

static void on_close(GLFWwindow *handle) {
    glfwSetWindowShouldClose(handle, GLFW_FALSE);
    push(window_of(handle), (kg_event){.type = KG_EVENT_CLOSE});
}

static const char *get_clipboard(void *user) {
    return glfwGetClipboardString(user);
}
static void set_clipboard(void *user, const char *text) {
    glfwSetClipboardString(user, text);
}

/* ---- the loop ---------------------------------------------------------------------------- */

static void show_cursor(GLFWwindow *handle, GLFWcursor *const cursors[]) {
    glfwSetCursor(handle, cursors[kg_ui_get_cursor()]);
}

static kg_status draw(window *w, kg_error *error) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    kg_status status = kg_app_draw(w->app, error);
    glfwSwapBuffers(w->handle);
    return status;
}

/* Waits for the next event, or until an autosave is due or a message has been shown long enough. An
 * idle window costs nothing. */
static void wait(const kg_app *app) {
    double due = kg_recovery_due(app), message = kg_editor_message_due(&app->editor);
    if (message >= 0)
        due = due < 0 ? message : fmin(due, message);
    if (app->busy)
        glfwWaitEventsTimeout(TICK);
    else if (due >= 0)
        glfwWaitEventsTimeout(fmax(due, TICK));
    else
        glfwWaitEvents();
}

static kg_status loop(window *w, kg_error *error) {
    static const int shapes[] = {GLFW_ARROW_CURSOR,   GLFW_IBEAM_CURSOR,   GLFW_CROSSHAIR_CURSOR,
                                 GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR, GLFW_HAND_CURSOR};
    GLFWcursor *cursors[sizeof shapes / sizeof *shapes];
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        cursors[i] = glfwCreateStandardCursor(shapes[i]);
    char title[512], shown[512] = "";
    double last = glfwGetTime();
    kg_status status = KG_OK;
    while (!w->app->quit && !status) {
        double now = glfwGetTime();
        kg_app_run_events(w->app, now - last);
        last = now;
        kg_app_title(w->app, title, sizeof title);
        if (strcmp(title, shown) != 0)
            glfwSetWindowTitle(w->handle, strcpy(shown, title));
        show_cursor(w->handle, cursors);
        if (w->app->redraw)
            status = draw(w, error);
        if (!w->app->quit && w->app->events.count == 0)
            wait(w->app);
    }
    return status;
}

static kg_status shoot(void *user, const char *path, kg_error *error) {
    (void)user, (void)path;
    return kg_fail(error, KG_ERR_INPUT, "pictures are made with --headless");
}

static kg_status run(window *w, const kg_run_options *o, kg_error *error) {
    int width, height;
    float x = 1, y = 1;
    kg_app app;
    glfwGetFramebufferSize(w->handle, &width, &height);
    glfwGetWindowContentScale(w->handle, &x, &y);
    kg_settings settings;
    kg_settings_default(&settings);
    kg_settings_read(&settings);
    kg_status status = kg_app_init(&app, width, height, (double)x, &settings, error);
    kg_settings_clear(&settings);
    if (status)
        return status;
    w->app = &app;
    glfwSetWindowUserPointer(w->handle, w);
    glfwSetKeyCallback(w->handle, on_key);
    glfwSetCharCallback(w->handle, on_text);
    glfwSetCursorPosCallback(w->handle, on_move);
    glfwSetMouseButtonCallback(w->handle, on_button);
    glfwSetScrollCallback(w->handle, on_wheel);
    glfwSetDropCallback(w->handle, on_drop);
    glfwSetFramebufferSizeCallback(w->handle, on_resize);
    glfwSetWindowRefreshCallback(w->handle, on_refresh);
    glfwSetWindowCloseCallback(w->handle, on_close);
    kg_ui_set_clipboard(w->handle, get_clipboard, set_clipboard);
    kg_recovery_offer(&app);
    if (o->model)
        kg_app_open(&app, o->model);
    if (o->script)
        status = kg_script_run(&app, o->script, shoot, NULL, error);
    else
        app.start = !o->model;
    if (!status)
        status = loop(w, error);
    kg_app_clear(&app);
    return status;
}

kg_status kg_window_run(const kg_run_options *o, kg_error *error) {
    window w = {0};
    if (!glfwInit())
        return kg_fail(error, KG_ERR_SYSTEM,
                       "no display can be opened; start katagami from a desktop, or run scripts "
                       "with --headless");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "katagami");
    w.handle = glfwCreateWindow(o->width, o->height, "katagami", NULL, NULL);
    kg_status status;
    if (w.handle) {
        glfwMakeContextCurrent(w.handle);
        glfwSwapInterval(1);
        status = run(&w, o, error);
        glfwDestroyWindow(w.handle);
    } else {
        status = kg_fail(error, KG_ERR_SYSTEM,
                         "no window with OpenGL 3.3 can be opened; install libgl1-mesa-dri or set "
                         "LIBGL_ALWAYS_SOFTWARE=1");
    }
    glfwTerminate();
    return status;
}
