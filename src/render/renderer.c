#include "render/renderer.h"

#include "render/camera.h"

#include <stdlib.h>

static const kg_color black = {0, 0, 0, 1}, white = {1, 1, 1, 1};

kg_status kg_renderer_create(kg_renderer **out_renderer, kg_error *error) {
    int version = epoxy_gl_version();
    if (version < 33 || !epoxy_is_desktop_gl())
        return kg_fail(error, KG_ERR_SYSTEM,
                       "drawing needs OpenGL 3.3, but this machine's driver has %d.%d; install "
                       "libgl1-mesa-dri or set LIBGL_ALWAYS_SOFTWARE=1",
                       version / 10, version % 10);
    kg_renderer *r = calloc(1, sizeof *r);
    if (!r)
        return kg_fail(error, KG_ERR_MEMORY, "no memory for a renderer");
    kg_status status = KG_OK;
    for (int i = 0; !status && i < KG_PROGRAM_COUNT; i++)
        status = kg_program_create((kg_program_kind)i, &r->programs[i], error);
    if (status) {
        kg_renderer_destroy(r);
        return status;
    }
    glGenVertexArrays(1, &r->no_vertices);
    *out_renderer = r;
    return KG_OK;
}

void kg_renderer_destroy(kg_renderer *renderer) {
    if (!renderer)
        return;
    for (int i = 0; i < KG_PROGRAM_COUNT; i++)
        glDeleteProgram(renderer->programs[i].name);
    glDeleteVertexArrays(1, &renderer->no_vertices);
    free(renderer);
}

kg_style kg_style_default(kg_color color) {
    kg_style s = {.color = color};
    const float tint = 0.6f;
    s.back.r = color.r + (1 - color.r) * tint;
    s.back.g = color.g + (1 - color.g) * tint;
    s.back.b = color.b + (1 - color.b) * tint;
    s.back.a = 1;
    return s;
}

kg_scene kg_scene_default(void) {
    kg_scene s = {0};
    s.background_top = (kg_color){0.96f, 0.965f, 0.97f, 1};
    s.background_bottom = (kg_color){0.82f, 0.835f, 0.85f, 1};
    return s;
}

kg_box3 kg_scene_box(const kg_scene *scene) {
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < scene->item_count; i++) {
        kg_box3 b = kg_shape_box(scene->items[i].shape);
        if (b.lo.x <= b.hi.x) {
            kg_box3_add(&box, b.lo);
            kg_box3_add(&box, b.hi);
        }
    }
    return box;
}

/* ---- one item --------------------------------------------------------------------------- */

static void set_color(const kg_program *p, kg_uniform u, kg_color c) {
    glUniform4f(p->at[u], c.r, c.g, c.b, c.a);
}

static kg_color highlighted(kg_color c, kg_color h) {
    kg_color r = {c.r + (h.r - c.r) * h.a, c.g + (h.g - c.g) * h.a, c.b + (h.b - c.b) * h.a, c.a};
    return r;
}

kg_frame kg_frame_make(const kg_camera *camera, kg_box3 box, kg_viewport viewport) {
    kg_frame f = {.camera = camera, .viewport = viewport};
    kg_camera_range(camera, box, &f.near, &f.far);
    kg_camera_projection(camera, (double)viewport.width / viewport.height, f.near, f.far,
                         f.projection);
    return f;
}

static void use_surface(const kg_program *p, const kg_frame *frame, const kg_style *style) {
    kg_vec3 right, up, back;
    kg_camera_axes(frame->camera, &right, &up, &back);
    glUniform3f(p->at[KG_UNIFORM_UP], (float)right.z, (float)up.z, (float)back.z);
    set_color(p, KG_UNIFORM_FRONT, style->color);
    set_color(p, KG_UNIFORM_BACK, style->back);
    set_color(p, KG_UNIFORM_HIGHLIGHT, style->highlight);
    glUniform1i(p->at[KG_UNIFORM_LIT], !style->unlit);
    glUniform1i(p->at[KG_UNIFORM_EVEN], style->even);
}

static void use_lines_or_points(const kg_program *p, const kg_frame *frame, const kg_style *style,
                                float default_px) {
    const kg_viewport *v = &frame->viewport;
    float scale = (float)v->pixel_ratio;
    double mm = kg_camera_pixel_size(frame->camera, v->height);
    bool ortho = frame->camera->ortho;
    set_color(p, KG_UNIFORM_COLOR_IN, highlighted(style->color, style->highlight));
    glUniform1f(p->at[KG_UNIFORM_WIDTH],
                scale * (style->size_px > 0 ? style->size_px : default_px));
    glUniform2f(p->at[KG_UNIFORM_VIEWPORT], (float)v->width, (float)v->height);
    glUniform2f(p->at[KG_UNIFORM_MM_PER_PX], ortho ? (float)mm : 0,
                ortho ? 0 : (float)(mm / frame->camera->distance));
    glUniform1f(p->at[KG_UNIFORM_PX_PER_MM], (float)(1 / mm));
    glUniform1f(p->at[KG_UNIFORM_NEAR], (float)frame->near);
    glUniform4f(p->at[KG_UNIFORM_DASHES], scale * style->dashes_px[0], scale * style->dashes_px[1],
                scale * style->dashes_px[2], scale * style->dashes_px[3]);
    glUniform1i(p->at[KG_UNIFORM_SQUARE], style->square);
    glUniform1f(p->at[KG_UNIFORM_RAISE], style->exact ? 0 : 0.75F);
}

void kg_frame_item(const kg_renderer *renderer, const kg_frame *frame, const kg_item *item,
                   kg_part part) {
    const kg_shape *shape = item->shape;
    const kg_program *p = &renderer->programs[shape->kind];
    float model_view[16];
    kg_camera_view(frame->camera, shape->origin, model_view);
    glUseProgram(p->name);
    glUniformMatrix4fv(p->at[KG_UNIFORM_MODEL_VIEW], 1, GL_FALSE, model_view);
    glUniformMatrix4fv(p->at[KG_UNIFORM_PROJECTION], 1, GL_FALSE, frame->projection);
    glUniform1i(p->at[KG_UNIFORM_ORTHO], frame->camera->ortho);
    glUniform1i(p->at[KG_UNIFORM_PART], part == KG_PART_RIM);
    if (shape->kind == KG_SHAPE_SURFACE)
        use_surface(p, frame, &item->style);
    else
        use_lines_or_points(p, frame, &item->style, shape->kind == KG_SHAPE_LINES ? 1.5f : 7);
    kg_shape_draw(shape);
}

/* ---- a scene ---------------------------------------------------------------------------- */

static bool is_surface(const kg_item *item) {
    return item->shape->kind == KG_SHAPE_SURFACE;
}
static bool is_opaque(const kg_item *item) {
    return item->style.color.a >= 1;
}
static bool is_exact(const kg_item *item) {
    return item->style.exact && is_surface(item) != is_opaque(item);
}

static void draw_background(const kg_renderer *renderer, const kg_scene *scene) {
    const kg_program *p = &renderer->programs[KG_PROGRAM_BACKGROUND];
    glUseProgram(p->name);
    set_color(p, KG_UNIFORM_TOP, scene->silhouette ? white : scene->background_top);
    set_color(p, KG_UNIFORM_BOTTOM, scene->silhouette ? white : scene->background_bottom);
    glBindVertexArray(renderer->no_vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Lines and points: where hidden first, then the core with depth, then its soft rim. */
static void draw_thin(const kg_renderer *renderer, const kg_frame *frame, const kg_item *item) {
    glEnable(GL_BLEND);
    if (item->style.hidden > 0) {
        kg_item faint = *item;
        faint.style.color.a *= item->style.hidden;
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_GREATER);
        kg_frame_item(renderer, frame, &faint, KG_PART_CORE);
        kg_frame_item(renderer, frame, &faint, KG_PART_RIM);
        glDepthFunc(GL_LEQUAL);
    }
    glDepthMask(is_opaque(item));
    kg_frame_item(renderer, frame, item, KG_PART_CORE);
    glDepthMask(GL_FALSE);
    kg_frame_item(renderer, frame, item, KG_PART_RIM);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/* Its far side first, seen through its near side. */
static void draw_see_through(const kg_renderer *renderer, const kg_frame *frame,
                             const kg_item *item) {
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glCullFace(GL_FRONT);
    kg_frame_item(renderer, frame, item, KG_PART_CORE);
    glCullFace(GL_BACK);
    kg_frame_item(renderer, frame, item, KG_PART_CORE);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

/* The see-through item, a surface or not, to draw after `last` (NULL: the first): the farthest of
 * those nearer than it, in list order where equally far. NULL after the nearest. A scan each time,
 * without a list to sort: scenes have few of them. */
static const kg_item *next_see_through(const kg_scene *scene, const kg_camera *camera,
                                       bool surfaces, const kg_item *last) {
    kg_vec3 right, up, back;
    kg_camera_axes(camera, &right, &up, &back);
    const kg_item *best = NULL;
    double best_depth = 0;
    double last_depth = last ? kg_dot(last->shape->origin, back) : (double)-INFINITY;
    for (size_t i = 0; i < scene->item_count; i++) {
        const kg_item *item = &scene->items[i];
        double depth = kg_dot(item->shape->origin, back);
        if (is_opaque(item) || is_exact(item) || is_surface(item) != surfaces ||
            depth < last_depth || (last && depth == last_depth && item <= last))
            continue;
        if (!best || depth < best_depth) {
            best = item;
            best_depth = depth;
        }
    }
    return best;
}

/* Draws the depth of surfaces once more, pushed back, for lines to be tested against. Their lift
 * (see line.vert) is not enough on steep surfaces, where half a line's width across is far in
 * depth. Two pixels' worth keeps outlines of 3 px whole up to 80°; what lies behind a round shape
 * of any size shines through only within half a pixel of its rim. The surfaces among themselves are
 * drawn unpushed, or the far side of a steep one would win over its near side at their common edge.
 */
static void push_depth(const kg_renderer *renderer, const kg_frame *frame, const kg_scene *scene) {
    glClear(GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2 * (float)frame->viewport.pixel_ratio, 1);
    for (size_t i = 0; i < scene->item_count; i++) {
        const kg_item *item = &scene->items[i];
        if (is_surface(item) && is_opaque(item))
            kg_frame_item(renderer, frame, item, KG_PART_CORE);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

static bool has_thin_items(const kg_scene *scene) {
    for (size_t i = 0; i < scene->item_count; i++) {
        if (!is_surface(&scene->items[i]))
            return true;
    }
    return false;
}

static void draw_items(const kg_renderer *renderer, const kg_frame *frame, const kg_scene *scene) {
    for (size_t i = 0; i < scene->item_count; i++) {
        const kg_item *item = &scene->items[i];
        if (is_surface(item) && is_opaque(item))
            kg_frame_item(renderer, frame, item, KG_PART_CORE);
    }
    for (size_t i = 0; i < scene->item_count; i++)
        if (is_exact(&scene->items[i]) && is_surface(&scene->items[i]))
            draw_see_through(renderer, frame, &scene->items[i]);
    for (size_t i = 0; i < scene->item_count; i++)
        if (is_exact(&scene->items[i]) && !is_surface(&scene->items[i]))
            draw_thin(renderer, frame, &scene->items[i]);
    if (has_thin_items(scene))
        push_depth(renderer, frame, scene);
    for (size_t i = 0; i < scene->item_count; i++) {
        const kg_item *item = &scene->items[i];
        if (!is_surface(item) && is_opaque(item) && !is_exact(item))
            draw_thin(renderer, frame, item);
    }
    const kg_item *item = NULL;
    while ((item = next_see_through(scene, frame->camera, true, item)) != NULL)
        draw_see_through(renderer, frame, item);
    while ((item = next_see_through(scene, frame->camera, false, item)) != NULL)
        draw_thin(renderer, frame, item);
}

static void draw_silhouette(const kg_renderer *renderer, const kg_frame *frame,
                            const kg_scene *scene) {
    for (size_t i = 0; i < scene->item_count; i++) {
        kg_item item = scene->items[i];
        if (!is_surface(&item))
            continue;
        item.style = (kg_style){.color = black, .back = black, .unlit = true};
        kg_frame_item(renderer, frame, &item, KG_PART_CORE);
    }
}

void kg_renderer_draw_clipped(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                              kg_viewport viewport, kg_rect clip) {
    if (viewport.width <= 0 || viewport.height <= 0)
        return;
    kg_frame frame = kg_frame_make(camera, kg_scene_box(scene), viewport);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(clip.x, clip.y, clip.width, clip.height);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
    draw_background(renderer, scene);

    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (scene->silhouette)
        draw_silhouette(renderer, &frame, scene);
    else
        draw_items(renderer, &frame, scene);
    glDisable(GL_DEPTH_TEST);
    if (scene->axes && !scene->silhouette)
        kg_frame_axes(renderer, &frame);
    glDisable(GL_SCISSOR_TEST);
    glBindVertexArray(0);
    glUseProgram(0);
}

void kg_renderer_draw(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                      kg_viewport viewport) {
    kg_rect all = {viewport.x, viewport.y, viewport.width, viewport.height};
    kg_renderer_draw_clipped(renderer, scene, camera, viewport, all);
}
