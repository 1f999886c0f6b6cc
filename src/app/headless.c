#include "app/headless.h"

#include "app/app.h"
#include "app/script.h"
#include "render/target.h"

#include <stdlib.h>

typedef struct canvas {
    kg_app *app;
    kg_target target; /* of this size; 0 × 0: none yet */
    int width, height;
} canvas;

static void release(canvas *c) {
    if (c->width > 0)
        kg_target_destroy(&c->target);
    c->width = c->height = 0;
}

/* A framebuffer of the app's present size. */
static kg_status fit(canvas *c, kg_error *error) {
    if (c->width == c->app->width && c->height == c->app->height)
        return KG_OK;
    release(c);
    kg_status status = kg_target_create(c->app->width, c->app->height, GL_RGBA8, &c->target, error);
    if (!status) {
        c->width = c->app->width;
        c->height = c->app->height;
    }
    return status;
}

static kg_status shoot(void *user, const char *path, kg_error *error) {
    canvas *c = user;
    kg_status status = fit(c, error);
    if (status)
        return status;
    glBindFramebuffer(GL_FRAMEBUFFER, c->target.framebuffer);
    if ((status = kg_app_draw(c->app, error)))
        return status;
    size_t row = 4 * (size_t)c->width, size = row * (size_t)c->height;
    uint8_t *up = malloc(size), *down = malloc(size);
    if (up && down) {
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, c->width, c->height, GL_RGBA, GL_UNSIGNED_BYTE, up);
        for (size_t y = 0; y < (size_t)c->height; y++)
            for (size_t x = 0; x < row; x++) {
                size_t from = ((size_t)c->height - 1 - y) * row + x;
                down[y * row + x] = x % 4 == 3 ? 255 : up[from];
            }
        kg_image image = {c->width, c->height, down};
        status = kg_image_write_png(&image, path, error);
    } else {
        status = kg_fail(error, KG_ERR_MEMORY, "no memory for a picture");
    }
    free(up);
    free(down);
    return status;
}

static kg_status run(kg_app *app, const kg_run_options *o, kg_error *error) {
    kg_status status = KG_OK;
    canvas c = {.app = app};
    app->editor.settings.net_view = false; /* until a script asks for it */
    if (o->model)
        status = kg_editor_open(&app->editor, o->model, error);
    kg_app_run_events(app, 0);
    if (!status && o->script)
        status = kg_script_run(app, o->script, shoot, &c, error);
    if (!status && o->shot)
        status = shoot(&c, o->shot, error);
    release(&c);
    return status;
}

kg_status kg_headless_run(const kg_run_options *o, kg_error *error) {
    kg_offscreen *offscreen;
    kg_settings settings; /* the same whoever runs the script */
    kg_app app;
    kg_settings_default(&settings);
    settings.transient = true;
    settings.autosave_minutes = 0;
    kg_status status = kg_offscreen_create(&offscreen, error);
    if (status)
        return status;
    status = kg_app_init(&app, (int)(o->width * o->scale), (int)(o->height * o->scale), o->scale,
                         &settings, error);
    if (!status) {
        status = run(&app, o, error);
        kg_app_clear(&app);
    }
    kg_offscreen_destroy(offscreen);
    return status;
}
