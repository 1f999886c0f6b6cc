#include "render/renderer.h"

#include "render/camera.h"

#include <stdlib.h>

enum { MOST_RADIUS = 64 }; /* px */

/* What the framebuffer holds: the item's index plus 1, and the element. */
typedef struct texel {
    uint32_t item, element;
} texel;

static kg_status compile(kg_renderer *renderer, kg_error *error) {
    for (int i = 0; i <= KG_SHAPE_POINTS; i++) {
        if (renderer->pickers[i].name)
            continue;
        kg_status status =
            kg_program_create((kg_program_kind)i, true, &renderer->pickers[i], error);
        if (status)
            return status;
    }
    return KG_OK;
}

static void begin(const kg_frame *frame) {
    const GLuint nothing[4] = {0};
    const kg_viewport *v = &frame->viewport;
    glViewport(v->x, v->y, v->width, v->height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
}

static void end(void) {
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(0);
    glUseProgram(0);
}

/* Surfaces, or lines and points in their order, as in the picture. What is seen even where hidden
 * can be picked there too. */
static void draw_ids(const kg_renderer *renderer, const kg_frame *frame, const kg_scene *scene,
                     bool surfaces) {
    for (size_t i = 0; i < scene->item_count; i++) {
        const kg_item *item = &scene->items[i];
        if (item->id == 0 || (item->shape->kind == KG_SHAPE_SURFACE) != surfaces)
            continue;
        glDepthFunc(!surfaces && item->style.hidden > 0 ? GL_ALWAYS : GL_LEQUAL);
        kg_frame_item(renderer, frame, item, KG_PART_ID, (uint32_t)i + 1);
    }
    glDepthFunc(GL_LEQUAL);
}

/* The winning texel of a square of 2 radius + 1: points before lines before the surface in the
 * middle, the nearest first; -1 for none. */
static int winner(const kg_scene *scene, const texel *texels, int radius) {
    int side = 2 * radius + 1, best = -1, best_rank = 0, best_square = 0;
    for (int i = 0; i < side * side; i++) {
        if (texels[i].item == 0)
            continue;
        int dx = i % side - radius, dy = i / side - radius, square = dx * dx + dy * dy;
        int rank = (int)scene->items[texels[i].item - 1].shape->kind;
        if (square > (rank == KG_SHAPE_SURFACE ? 0 : radius * radius))
            continue;
        if (best < 0 || rank > best_rank || (rank == best_rank && square < best_square)) {
            best = i;
            best_rank = rank;
            best_square = square;
        }
    }
    return best;
}

kg_status kg_renderer_pick(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                           kg_viewport viewport, kg_vec2 pixel, double radius_px, kg_pick *out_pick,
                           kg_error *error) {
    kg_pick pick = {0};
    if (!(pixel.x >= 0 && pixel.x < viewport.width && pixel.y >= 0 && pixel.y < viewport.height)) {
        *out_pick = pick;
        return KG_OK;
    }
    kg_status status = compile(renderer, error);
    if (status)
        return status;
    int radius = radius_px > 0 ? (int)fmin(radius_px, MOST_RADIUS) : 0, side = 2 * radius + 1;
    kg_target target;
    status = kg_target_create(side, side, GL_RG32UI, &target, error);
    if (status)
        return status;
    size_t count = (size_t)side * (size_t)side;
    texel *texels = calloc(count, sizeof *texels);
    float *depths = calloc(count, sizeof *depths), depth = 0;
    if (!texels || !depths) {
        status = kg_fail(error, KG_ERR_MEMORY, "no memory to find what is under the pointer");
        goto done;
    }
    /* The small framebuffer lies around the pixel, in the middle of the whole viewport. */
    int x = (int)pixel.x - radius, y = viewport.height - 1 - (int)pixel.y - radius;
    kg_viewport around = viewport;
    around.x = -x;
    around.y = -y;
    kg_frame frame = kg_frame_make(camera, kg_scene_box(scene), around);
    begin(&frame);
    draw_ids(renderer, &frame, scene, true);
    glReadPixels(radius, radius, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    kg_frame_push_depth(renderer, &frame, scene, KG_PART_ID);
    draw_ids(renderer, &frame, scene, false);
    end();
    glReadPixels(0, 0, side, side, GL_RG_INTEGER, GL_UNSIGNED_INT, texels);
    glReadPixels(0, 0, side, side, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    int at = winner(scene, texels, radius);
    if (at >= 0) {
        kg_vec2 center = kg_v2(x + at % side + 0.5, viewport.height - (y + at / side + 0.5));
        pick.id = scene->items[texels[at].item - 1].id;
        pick.element = texels[at].element;
        if (scene->items[texels[at].item - 1].shape->kind != KG_SHAPE_SURFACE)
            depth = depths[at];
        pick.position = kg_camera_unproject(camera, viewport.width, viewport.height, center,
                                            (double)depth, frame.near, frame.far);
    }
    *out_pick = pick;
done:
    free(texels);
    free(depths);
    kg_target_destroy(&target);
    return status;
}
