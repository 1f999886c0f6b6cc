#include "guide/stage.h"

#include <stdlib.h>

/* Edges bent by more than this (radians) are drawn: folds inside parts of several pieces. Parts of
 * one piece are smooth, whatever their triangles are. */
#define CREASE 0.3
#define NO_CREASE 3.2

enum { SUPERSAMPLING = 2 };

struct kg_stage {
    const kg_assembly *assembly;
    kg_offscreen *offscreen;
    kg_renderer *renderer;
    kg_shape **surfaces, **edges; /* per part */
    kg_shape **joins;             /* per join */
    kg_shape **moved;             /* shapes of one picture */
    size_t moved_count;
    kg_item *items;
    size_t item_count;
};

/* ---- shapes ----------------------------------------------------------------------------- */

static kg_status join_shape(const kg_assembly_join *join, kg_vec3 offset, kg_shape **out,
                            kg_error *error) {
    kg_vec3 *points = calloc(join->count, sizeof *points);
    if (!points)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < join->count; i++)
        points[i] = kg_add(join->points[i], offset);
    uint32_t starts[2] = {0, (uint32_t)join->count};
    kg_status status = kg_shape_from_lines(&(kg_lines){points, starts, 1}, out, error);
    free(points);
    return status;
}

static kg_status part_shapes(const kg_assembly_part *part, kg_vec3 offset, kg_shape **out_surface,
                             kg_shape **out_edges, kg_error *error) {
    kg_surface moved = part->surface;
    moved.positions = calloc(moved.vertex_count + 1, sizeof *moved.positions);
    if (!moved.positions)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < moved.vertex_count; i++)
        moved.positions[i] = kg_add(part->surface.positions[i], offset);
    kg_status status = kg_shape_from_surface(&moved, out_surface, error);
    if (!status)
        status = kg_shape_from_edges(&moved, part->piece_count > 1 ? CREASE : NO_CREASE, out_edges,
                                     error);
    free(moved.positions);
    return status;
}

static kg_status make_shapes(kg_stage *s, kg_error *error) {
    kg_status status = KG_OK;
    const kg_assembly *a = s->assembly;
    for (size_t i = 0; i < a->net->part_count && !status; i++)
        if (a->parts[i].surface.triangle_count > 0)
            status =
                part_shapes(&a->parts[i], kg_v3(0, 0, 0), &s->surfaces[i], &s->edges[i], error);
    for (size_t i = 0; i < a->net->join_count && !status; i++)
        if (a->joins[i].count > 1)
            status = join_shape(&a->joins[i], kg_v3(0, 0, 0), &s->joins[i], error);
    return status;
}

kg_status kg_stage_create(const kg_assembly *assembly, kg_stage **out_stage, kg_error *error) {
    size_t parts = assembly->net->part_count + 1, joins = assembly->net->join_count + 1;
    kg_stage *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    s->assembly = assembly;
    s->surfaces = calloc(parts, sizeof *s->surfaces);
    s->edges = calloc(parts, sizeof *s->edges);
    s->joins = calloc(joins, sizeof *s->joins);
    s->moved = calloc(2 * parts + joins, sizeof *s->moved);
    s->items = calloc(2 * parts + 2 * joins, sizeof *s->items);
    kg_status status = KG_OK;
    if (!s->surfaces || !s->edges || !s->joins || !s->moved || !s->items)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_offscreen_create(&s->offscreen, error);
    if (!status)
        status = kg_renderer_create(&s->renderer, error);
    if (!status)
        status = make_shapes(s, error);
    if (status) {
        kg_stage_destroy(s);
        return status;
    }
    *out_stage = s;
    return KG_OK;
}

static void drop_moved(kg_stage *s) {
    for (size_t i = 0; i < s->moved_count; i++) {
        kg_shape_destroy(s->moved[i]);
        s->moved[i] = NULL;
    }
    s->moved_count = 0;
}

void kg_stage_destroy(kg_stage *s) {
    if (!s)
        return;
    drop_moved(s);
    for (size_t i = 0; s->surfaces && s->edges && i < s->assembly->net->part_count; i++) {
        kg_shape_destroy(s->surfaces[i]);
        kg_shape_destroy(s->edges[i]);
    }
    for (size_t i = 0; s->joins && i < s->assembly->net->join_count; i++)
        kg_shape_destroy(s->joins[i]);
    kg_renderer_destroy(s->renderer);
    kg_offscreen_destroy(s->offscreen);
    free(s->surfaces);
    free(s->edges);
    free(s->joins);
    free(s->moved);
    free(s->items);
    free(s);
}

/* ---- pictures --------------------------------------------------------------------------- */

static void add_item(kg_stage *s, const kg_shape *shape, kg_style style) {
    if (shape)
        s->items[s->item_count++] = (kg_item){.shape = shape, .style = style};
}

static kg_status add_part(kg_stage *s, const kg_view_of *view, size_t i, kg_stage_look look,
                          kg_error *error) {
    bool new = view->roles[i] == KG_ROLE_NEW;
    kg_shape *surface = s->surfaces[i], *edges = s->edges[i];
    if (new &&surface && kg_len(view->offset) > 0) {
        kg_shape **moved = &s->moved[s->moved_count];
        kg_status status =
            part_shapes(&s->assembly->parts[i], view->offset, &moved[0], &moved[1], error);
        s->moved_count += moved[1] ? 2 : moved[0] ? 1 : 0;
        if (status)
            return status;
        surface = moved[0];
        edges = moved[1];
    }
    kg_style style = kg_style_default(look == KG_LOOK_COLORS ? s->assembly->parts[i].color
                                      : new                  ? kg_color_from_rgb(KG_STAGE_NEW)
                                            : kg_color_from_rgb(KG_STAGE_STANDING));
    if (look == KG_LOOK_STEP)
        style.back = kg_color_from_rgb(new ? KG_STAGE_NEW_BACK : KG_STAGE_STANDING_BACK);
    kg_style line = kg_style_default(kg_color_from_rgb(new ? 0x40300au : 0x4a525au));
    line.size_px = 1.6F;
    add_item(s, surface, style);
    add_item(s, edges, line);
    return KG_OK;
}

static kg_status add_join(kg_stage *s, const kg_view_of *view, int join, kg_error *error) {
    kg_style style = kg_style_default(kg_color_from_rgb(KG_STAGE_JOIN));
    style.size_px = 5;
    style.hidden = 0.35F;
    add_item(s, s->joins[join], style);
    if (!s->joins[join] || kg_len(view->offset) == 0)
        return KG_OK;
    kg_shape **moved = &s->moved[s->moved_count];
    kg_status status = join_shape(&s->assembly->joins[join], view->offset, moved, error);
    if (status)
        return status;
    s->moved_count++;
    style.size_px = 3.5F;
    add_item(s, *moved, style);
    return KG_OK;
}

kg_status kg_stage_picture(kg_stage *s, const kg_view_of *view, kg_stage_look look,
                           const kg_camera *camera, int width, int height, kg_image *out_image,
                           kg_error *error) {
    kg_status status = KG_OK;
    s->item_count = 0;
    for (size_t i = 0; i < s->assembly->net->part_count && !status; i++)
        if (view->roles[i] != KG_ROLE_ABSENT)
            status = add_part(s, view, i, look, error);
    for (size_t i = 0; i < view->join_count && !status; i++)
        status = add_join(s, view, view->joins[i], error);
    if (!status) {
        kg_scene scene = kg_scene_default();
        scene.background_top = scene.background_bottom = (kg_color){1, 1, 1, 1};
        scene.items = s->items;
        scene.item_count = s->item_count;
        status = kg_renderer_picture(s->renderer, &scene, camera, width, height, SUPERSAMPLING,
                                     out_image, error);
    }
    drop_moved(s);
    return status;
}
