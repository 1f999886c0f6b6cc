#include "app/scenery.h"

#include "app/mode.h"
#include "app/tools/tool.h"
#include "model/edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PICTURE_SAMPLES = 2 };

struct kg_scenery {
    kg_renderer *renderer;
    const kg_mode *mode; /* that made the cache */
    void *cache;
    kg_shape *grid;
    double grid_spacing, grid_z;
};

/* ---- colours ---------------------------------------------------------------------------- */

void kg_color_print(kg_color c, char out[8]) {
    snprintf(out, 8, "#%06x", (unsigned)kg_color_to_rgb(c));
}

kg_color kg_rank_color(int rank) {
    return rank == 0 ? (kg_color){0.84F, 0.16F, 0.05F, 1} : (kg_color){0.0F, 0.35F, 0.80F, 1};
}

kg_style kg_line_style(kg_color color, float width) {
    kg_style s = kg_style_default(color);
    s.size_px = width;
    return s;
}

/* ---- the picture ------------------------------------------------------------------------- */

/* A grid of 1, 10, 100 … mm, some twenty lines across the picture. */
static kg_status follow_grid(kg_scenery *stage, const kg_pane *pane, double z, kg_error *error) {
    double across = kg_camera_pixel_size(&pane->camera, pane->area.height) * pane->area.width;
    double spacing = pow(10, floor(log10(fmax(across, 1e-6) / 5)));
    if (stage->grid && spacing == stage->grid_spacing && z == stage->grid_z)
        return KG_OK;
    kg_shape_destroy(stage->grid);
    stage->grid = NULL;
    stage->grid_spacing = spacing;
    stage->grid_z = z;
    return kg_shape_grid(kg_v3(0, 0, z), spacing, 20, &stage->grid, error);
}

static kg_status add_grid(kg_scenery *stage, const kg_editor *e, kg_overlay *overlay,
                          kg_error *error) {
    double z = 0;
    float shade = e->settings.theme == KG_UI_DARK ? 0.62F : 0.45F;
    if (e->mode->ground && !e->mode->ground(e, &z))
        return KG_OK;
    kg_status status = follow_grid(stage, &e->pane, z, error);
    kg_overlay_item(overlay, stage->grid, kg_line_style((kg_color){shade, shade, shade, 0.35F}, 1));
    return status;
}

static kg_scene scene_of(const kg_editor *e) {
    kg_scene scene = kg_scene_default();
    if (e->settings.theme == KG_UI_DARK) {
        scene.background_top = (kg_color){0.36F, 0.38F, 0.41F, 1};
        scene.background_bottom = (kg_color){0.24F, 0.25F, 0.275F, 1};
    }
    return scene;
}

/* What one mode keeps is of no use to another. */
static void drop_cache(kg_scenery *stage) {
    if (stage->cache)
        stage->mode->drop(stage->cache);
    stage->cache = NULL;
}

/* Everything to be seen; the overlay is to be cleared, also on failure. */
static kg_status compose(kg_scenery *stage, const kg_editor *e, kg_overlay *overlay,
                         kg_error *error) {
    kg_status status = add_grid(stage, e, overlay, error);
    if (stage->mode != e->mode)
        drop_cache(stage);
    stage->mode = e->mode;
    if (!status)
        status = e->mode->compose(&stage->cache, e, overlay, error);
    if (!status && e->tool->draw)
        e->tool->draw(e, overlay);
    return status;
}

kg_status kg_scenery_draw(kg_scenery *stage, const kg_editor *e, int height_px, kg_error *error) {
    kg_overlay overlay = {0};
    kg_status status = compose(stage, e, &overlay, error);
    if (!status) {
        kg_scene scene = scene_of(e);
        scene.items = overlay.items.items;
        scene.item_count = overlay.items.count;
        const kg_area *a = &e->pane.area;
        kg_viewport viewport = {(int)a->x, height_px - (int)(a->y + a->height), (int)a->width,
                                (int)a->height, e->pane.scale};
        kg_renderer_draw(stage->renderer, &scene, &e->pane.camera, viewport);
    }
    kg_overlay_clear(&overlay);
    return status;
}

kg_status kg_scenery_picture(kg_scenery *stage, const kg_editor *e, int width, int height,
                             kg_image *out_image, kg_error *error) {
    kg_overlay overlay = {0};
    kg_status status = compose(stage, e, &overlay, error);
    if (!status) {
        kg_scene scene = scene_of(e);
        scene.items = overlay.items.items;
        scene.item_count = overlay.items.count;
        status = kg_renderer_picture(stage->renderer, &scene, &e->pane.camera, width, height,
                                     PICTURE_SAMPLES, out_image, error);
    }
    kg_overlay_clear(&overlay);
    return status;
}

kg_status kg_scenery_thumbnail(kg_scenery *stage, const kg_overlay *overlay,
                               const kg_camera *camera, int width, int height, kg_image *out_image,
                               kg_error *error) {
    kg_scene scene = {.items = overlay->items.items, .item_count = overlay->items.count};
    return kg_renderer_picture(stage->renderer, &scene, camera, width, height, PICTURE_SAMPLES,
                               out_image, error);
}

kg_status kg_scenery_create(kg_scenery **out_stage, kg_error *error) {
    kg_scenery *stage = calloc(1, sizeof *stage);
    if (!stage)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = kg_renderer_create(&stage->renderer, error);
    if (status) {
        free(stage);
        return status;
    }
    *out_stage = stage;
    return KG_OK;
}

void kg_scenery_destroy(kg_scenery *stage) {
    if (!stage)
        return;
    drop_cache(stage);
    kg_shape_destroy(stage->grid);
    kg_renderer_destroy(stage->renderer);
    free(stage);
}
