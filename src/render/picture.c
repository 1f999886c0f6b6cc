#include "render/renderer.h"

#include "base/array.h"
#include "base/file.h"
#include "render/target.h"

#include <cairo.h>
#include <stdlib.h>
#include <string.h>

enum {
    TILE_PX = 2048, /* framebuffers up to this size: 16 MB of colour, 16 MB of depth */
    MOST_SUPERSAMPLING = 8
};

static kg_status check_size(int width, int height, int supersampling, kg_error *error) {
    GLint most[2] = {0}, texture = 0;
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &texture);
    if (supersampling < 1 || supersampling > MOST_SUPERSAMPLING)
        return kg_fail(error, KG_ERR_INPUT, "supersampling is %d; it must be 1 to %d",
                       supersampling, MOST_SUPERSAMPLING);
    if (width < 1 || height < 1 || width > most[0] / supersampling ||
        height > most[1] / supersampling)
        return kg_fail(error, KG_ERR_INPUT,
                       "a picture of %d x %d pixels cannot be drawn; this machine draws 1 x 1 to "
                       "%d x %d at supersampling %d",
                       width, height, most[0] / supersampling, most[1] / supersampling,
                       supersampling);
    return KG_OK;
}

/* Means of s × s samples from a tile (rows upwards) into the image (rows downwards); `x`, `y` is
 * the tile's lower left pixel in the image. */
static void reduce(const uint8_t *tile, kg_rect area, int s, kg_image *image) {
    size_t stride = (size_t)(area.width * s) * 4;
    unsigned samples = (unsigned)(s * s);
    for (int y = 0; y < area.height; y++) {
        uint8_t *out =
            image->pixels +
            ((size_t)(image->height - 1 - area.y - y) * (size_t)image->width + (size_t)area.x) * 4;
        for (int x = 0; x < area.width; x++) {
            unsigned sum[4] = {0};
            for (int row = 0; row < s; row++) {
                const uint8_t *in = tile + (size_t)(y * s + row) * stride + (size_t)(x * s) * 4;
                for (int k = 0; k < s; k++, in += 4) {
                    for (int c = 0; c < 4; c++)
                        sum[c] += in[c];
                }
            }
            for (int c = 0; c < 4; c++)
                *out++ = (uint8_t)((sum[c] + samples / 2) / samples);
        }
    }
}

kg_status kg_renderer_picture(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                              int width, int height, int supersampling, kg_image *out_image,
                              kg_error *error) {
    kg_status status = check_size(width, height, supersampling, error);
    if (status)
        return status;
    const int s = supersampling, step = TILE_PX / s;
    int tile_width = width < step ? width : step, tile_height = height < step ? height : step;
    kg_target target;
    status = kg_target_create(tile_width * s, tile_height * s, GL_RGBA8, &target, error);
    if (status)
        return status;
    kg_image image = {width, height, malloc((size_t)width * (size_t)height * 4)};
    uint8_t *tile = malloc((size_t)(tile_width * s) * (size_t)(tile_height * s) * 4);
    if (!image.pixels || !tile) {
        status = kg_fail(error, KG_ERR_MEMORY, "no memory for a picture of %d x %d pixels", width,
                         height);
        goto done;
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    (void)glGetError(); /* an earlier caller's */
    for (int y = 0; y < height; y += step) {
        for (int x = 0; x < width; x += step) {
            kg_rect area = {x, y, width - x < step ? width - x : step,
                            height - y < step ? height - y : step};
            kg_viewport viewport = {-x * s, -y * s, width * s, height * s, s};
            kg_rect clip = {0, 0, area.width * s, area.height * s};
            kg_renderer_draw_clipped(renderer, scene, camera, viewport, clip);
            glReadPixels(0, 0, clip.width, clip.height, GL_RGBA, GL_UNSIGNED_BYTE, tile);
            reduce(tile, area, s, &image);
        }
    }
    if (glGetError() != GL_NO_ERROR) {
        status = kg_fail(error, KG_ERR_SYSTEM,
                         "the OpenGL driver failed to draw %d x %d pixels; try a smaller picture",
                         width, height);
        goto done;
    }
    *out_image = image;
    image.pixels = NULL;
done:
    free(tile);
    free(image.pixels);
    kg_target_destroy(&target);
    return status;
}

void kg_image_destroy(kg_image *image) {
    if (image) {
        free(image->pixels);
        *image = (kg_image){0};
    }
}

/* ---- PNG -------------------------------------------------------------------------------- */

typedef struct bytes {
    unsigned char *items;
    size_t count, capacity;
} bytes;

static cairo_status_t append(void *user, const unsigned char *data, unsigned length) {
    bytes *b = user;
    if (length > SIZE_MAX / 2 - b->count || !kg_reserve(b, b->count + length))
        return CAIRO_STATUS_NO_MEMORY;
    memcpy(b->items + b->count, data, length);
    b->count += length;
    return CAIRO_STATUS_SUCCESS;
}

kg_status kg_image_write_png(const kg_image *image, const char *path, kg_error *error) {
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image->width, image->height);
    bytes png = {0};
    kg_status status = KG_OK;
    if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS) {
        cairo_surface_flush(surface);
        unsigned char *rows = cairo_image_surface_get_data(surface);
        int stride = cairo_image_surface_get_stride(surface);
        const uint8_t *in = image->pixels;
        for (int y = 0; y < image->height; y++) {
            unsigned char *row = rows + (ptrdiff_t)y * stride;
            for (int x = 0; x < image->width; x++, in += 4) {
                uint32_t argb =
                    (uint32_t)in[3] << 24 | (uint32_t)in[0] << 16 | (uint32_t)in[1] << 8 | in[2];
                memcpy(row + 4 * x, &argb, sizeof argb);
            }
        }
        cairo_surface_mark_dirty(surface);
    }
    cairo_status_t written = cairo_surface_write_to_png_stream(surface, append, &png);
    if (written == CAIRO_STATUS_SUCCESS)
        status = kg_file_write(path, png.items, png.count, error);
    else
        status = kg_fail(error, KG_ERR_MEMORY, "%s: the picture cannot be encoded: %s", path,
                         cairo_status_to_string(written));
    cairo_surface_destroy(surface);
    free(png.items);
    return status;
}
