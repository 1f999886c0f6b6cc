/* The picture of a patch model: its patches, the reference, what belongs to the selection. */
#include "app/modes/patch_scene.h"

#include "app/scenery.h"
#include "base/array.h"
#include "model/edit.h"

#include <stdlib.h>

enum { RULING_COUNT = 16, RULING_STEPS = 48, CURVE_SAMPLES = 65 };

typedef struct patch_shapes {
    int64_t id;
    uint64_t revision;
    kg_shape *surface, *outline;
    bool used; /* in the picture being put together */
} patch_shapes;

/* What stays on the graphics card. */
typedef struct stage {
    struct {
        patch_shapes *items;
        size_t count, capacity;
    } patches;
    kg_shape *reference;
    uint64_t reference_revision;
} patch_stage;

/* ---- shapes that stay -------------------------------------------------------------------- */

static void clear_shapes(patch_shapes *s) {
    kg_shape_destroy(s->surface);
    kg_shape_destroy(s->outline);
    s->surface = s->outline = NULL;
}

static kg_status upload_surface(const kg_patch_surface *from, kg_shape **out, kg_error *error) {
    size_t vertices = 0, triangles = 0, v = 0, t = 0;
    for (size_t i = 0; i < from->piece_count; i++) {
        vertices += from->pieces[i].vertex_count;
        triangles += from->pieces[i].triangle_count;
    }
    kg_surface s = {.vertex_count = vertices, .triangle_count = triangles};
    s.positions = calloc(vertices + 1, sizeof *s.positions);
    s.normals = calloc(vertices + 1, sizeof *s.normals);
    s.triangles = calloc(triangles + 1, 3 * sizeof *s.triangles);
    kg_status status = KG_ERR_MEMORY;
    if (s.positions && s.normals && s.triangles) {
        for (size_t i = 0; i < from->piece_count; i++) {
            const kg_tessellation *piece = &from->pieces[i];
            for (size_t k = 0; k < 3 * piece->triangle_count; k++)
                s.triangles[t++] = (uint32_t)v + piece->triangles[k];
            for (size_t k = 0; k < piece->vertex_count; k++, v++) {
                s.positions[v] = piece->vertices[k].position;
                s.normals[v] = piece->vertices[k].normal;
            }
        }
        status = kg_shape_from_surface(&s, out, error);
    }
    kg_surface_destroy(&s);
    return status;
}

static kg_status upload_outline(const kg_regions *regions, kg_shape **out, kg_error *error) {
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } points = {0};
    struct {
        uint32_t *items;
        size_t count, capacity;
    } starts = {0};
    bool ok = kg_push(&starts, 0);
    for (size_t i = 0; i < regions->count; i++)
        for (size_t l = 0; l < regions->items[i].loop_count; l++) {
            const kg_region_loop *loop = &regions->items[i].loops[l];
            for (size_t k = 0; k <= loop->point_count && ok; k++)
                ok = kg_push(&points, loop->points[k % loop->point_count].x);
            ok = ok && kg_push(&starts, (uint32_t)points.count);
        }
    kg_lines lines = {points.items, starts.items, starts.count - 1};
    kg_status status = !ok ? KG_ERR_MEMORY : kg_shape_from_lines(&lines, out, error);
    free(points.items);
    free(starts.items);
    return status;
}

static kg_status follow_patch(patch_stage *stage, const kg_patch_surface *surface,
                              const kg_solved_patch *solved, patch_shapes **out, kg_error *error) {
    patch_shapes *s = NULL;
    for (size_t i = 0; i < stage->patches.count && !s; i++)
        if (stage->patches.items[i].id == surface->id)
            s = &stage->patches.items[i];
    if (!s) {
        patch_shapes fresh = {.id = surface->id};
        if (!kg_push(&stage->patches, fresh))
            return kg_fail(error, KG_ERR_MEMORY, "out of memory");
        s = &stage->patches.items[stage->patches.count - 1];
    }
    s->used = true;
    kg_status status = KG_OK;
    if (s->revision != surface->revision) {
        clear_shapes(s);
        s->revision = surface->revision;
        if (surface->piece_count > 0 && !(status = upload_surface(surface, &s->surface, error)))
            status = upload_outline(&solved->regions, &s->outline, error);
    }
    *out = s;
    return status;
}

static void drop_unused(patch_stage *stage) {
    size_t kept = 0;
    for (size_t i = 0; i < stage->patches.count; i++) {
        patch_shapes *s = &stage->patches.items[i];
        if (s->used) {
            s->used = false;
            stage->patches.items[kept++] = *s;
        } else {
            clear_shapes(s);
        }
    }
    stage->patches.count = kept;
}

static kg_status follow_reference(patch_stage *stage, const kg_backdrop *backdrop,
                                  kg_error *error) {
    if (stage->reference_revision == backdrop->revision)
        return KG_OK;
    kg_shape_destroy(stage->reference);
    stage->reference = NULL;
    stage->reference_revision = backdrop->revision;
    return backdrop->mesh ? kg_shape_from_surface(&backdrop->surface, &stage->reference, error)
                          : KG_OK;
}

/* ---- what belongs to selected patches ----------------------------------------------------- */

static void add_geodesic(kg_overlay *o, const kg_patch *patch, kg_color color) {
    kg_vec3 points[CURVE_SAMPLES];
    for (int i = 0; i < CURVE_SAMPLES; i++)
        points[i] = kg_patch_point(patch, 0, (double)i / (CURVE_SAMPLES - 1));
    kg_style style = kg_line_style(color, 2);
    style.hidden = 0.25F;
    kg_overlay_line(o, points, CURVE_SAMPLES, style);
}

/* A ruling along which the wished extent goes too far, or that runs nearly along the geodesic. */
static bool is_bad_ruling(const kg_patch *patch, double v) {
    double lo, hi;
    kg_patch_regression(patch, v, &lo, &hi);
    return patch->wished_extent[0] < KG_REGRESSION_LIMIT * lo ||
           patch->wished_extent[1] > KG_REGRESSION_LIMIT * hi ||
           fabs(kg_patch_ruling(patch, v).sin_theta) < sin(KG_FLAT_RULING);
}

static bool is_kept(const kg_regions *regions, double u, double v) {
    for (size_t i = 0; i < regions->count; i++)
        if (kg_region_contains(&regions->items[i], u, v))
            return true;
    return false;
}

/* The rulings of what is left of a patch. */
static void add_rulings(kg_overlay *o, const kg_solved_patch *solved, kg_color color) {
    const kg_patch *patch = &solved->patch;
    kg_color warning = {0.95F, 0.25F, 0.75F, 1};
    for (int i = 0; i < RULING_COUNT; i++) {
        double v = (i + 0.5) / RULING_COUNT, from = 0;
        bool bad = is_bad_ruling(patch, v), inside = false;
        kg_style style = kg_line_style(bad ? warning : color, bad ? 2 : 1);
        style.color.a = bad ? 0.9F : 0.55F;
        for (int k = 0; k <= RULING_STEPS; k++) {
            double u =
                patch->extent[0] + (patch->extent[1] - patch->extent[0]) * k / (double)RULING_STEPS;
            bool now = k < RULING_STEPS && (!solved->valid || is_kept(&solved->regions, u, v));
            if (now && !inside)
                from = u;
            if (inside && !now)
                kg_overlay_line(
                    o, (kg_vec3[]){kg_patch_point(patch, from, v), kg_patch_point(patch, u, v)}, 2,
                    style);
            inside = now;
        }
    }
}

void kg_patch_rectangle_draw(kg_overlay *o, const kg_patch *patch, kg_color color) {
    kg_vec3 points[2 * CURVE_SAMPLES + 1];
    for (int i = 0; i < CURVE_SAMPLES; i++) {
        double v = (double)i / (CURVE_SAMPLES - 1);
        points[i] = kg_patch_point(patch, patch->extent[0], v);
        points[2 * CURVE_SAMPLES - 1 - i] = kg_patch_point(patch, patch->extent[1], v);
    }
    points[2 * CURVE_SAMPLES] = points[0];
    kg_style style = kg_line_style(color, 1.5F);
    style.dashes_px[0] = 7, style.dashes_px[1] = 4;
    style.dashes_px[2] = 7, style.dashes_px[3] = 4;
    style.hidden = 0.3F;
    kg_overlay_line(o, points, 2 * CURVE_SAMPLES + 1, style);
}

static void add_points(kg_overlay *o, const kg_editor *e, const kg_model_patch *p) {
    kg_style polygon = kg_line_style((kg_color){0.15F, 0.16F, 0.18F, 1}, 1);
    polygon.hidden = 0.4F;
    kg_overlay_line(o, p->input.points, p->input.point_count, polygon);
    for (size_t i = 0; i < p->input.point_count; i++) {
        kg_point_ref ref = {p->id, i};
        bool on = kg_editor_is_point_selected(e, ref);
        bool hovered = e->hover_point.patch == p->id && e->hover_point.index == i;
        bool end = i == 0 || i + 1 == p->input.point_count;
        kg_style rim = kg_style_default((kg_color){0.1F, 0.1F, 0.12F, 1});
        rim.hidden = 0.8F;
        rim.square = end;
        rim.size_px = hovered ? 13 : 11;
        kg_style dot =
            kg_style_default(on ? (kg_color){1, 0.82F, 0.1F, 1} : (kg_color){1, 1, 1, 1});
        dot.hidden = 0.8F;
        dot.square = end;
        dot.size_px = hovered ? 10 : 8;
        kg_overlay_points(o, &p->input.points[i], 1, rim);
        kg_overlay_points(o, &p->input.points[i], 1, dot);
    }
}

static void add_selected(kg_overlay *o, const kg_editor *e, const kg_model_patch *p,
                         const kg_solved_patch *solved, int rank) {
    if (solved->prepared) {
        add_rulings(o, solved, kg_rank_color(rank));
        add_geodesic(o, &solved->patch, kg_rank_color(rank));
        if (rank > 0 || !solved->valid)
            kg_patch_rectangle_draw(o, &solved->patch, kg_rank_color(rank));
    }
    if (kg_editor_shows_points(e, p->id))
        add_points(o, e, p);
}

/* ---- the picture ------------------------------------------------------------------------- */

static void add_patch(kg_overlay *o, const kg_editor *e, size_t index, const patch_shapes *s) {
    const kg_model_patch *p = &kg_editor_model(e)->patches[index];
    const kg_solved_patch *solved = kg_solution_patch(kg_editor_solution(e), index);
    int rank = kg_editor_selection_rank(e, p->id);
    bool hovered = e->hover_patch == p->id;
    kg_color color = kg_patch_color(p);
    color.a = (float)(p->construction ? fmin(e->patch_opacity, 0.25) : e->patch_opacity);
    kg_style surface = kg_style_default(color);
    if (rank >= 0) {
        surface.highlight = kg_rank_color(rank);
        surface.highlight.a = 0.45F;
    } else if (hovered) {
        surface.highlight = (kg_color){1, 1, 1, 0.25F};
    }
    kg_overlay_item(o, s->surface, surface);
    kg_style outline = kg_line_style((kg_color){0.1F, 0.1F, 0.12F, 1}, 1.3F);
    if (rank >= 0) {
        outline = kg_line_style(kg_rank_color(rank), 3);
        outline.hidden = 0.3F;
        if (rank > 0)
            outline.dashes_px[0] = outline.dashes_px[2] = 10,
            outline.dashes_px[1] = outline.dashes_px[3] = 3;
    } else if (hovered) {
        outline.size_px = 2.2F;
    }
    kg_overlay_item(o, s->outline, outline);
    if (rank >= 0)
        add_selected(o, e, p, solved, rank);
    else if (!s->surface && solved->prepared)
        kg_patch_rectangle_draw(o, &solved->patch, (kg_color){0.8F, 0.25F, 0.1F, 1});
}

static kg_status add_patches(patch_stage *stage, const kg_editor *e, kg_overlay *o,
                             kg_error *error) {
    const kg_model *m = kg_editor_model(e);
    const kg_solution *solution = kg_editor_solution(e);
    kg_status status = KG_OK;
    for (size_t i = 0; i < e->surfaces.count && i < m->patch_count && !status; i++) {
        patch_shapes *shapes = NULL;
        status = follow_patch(stage, &e->surfaces.items[i], kg_solution_patch(solution, i), &shapes,
                              error);
        if (!status && !m->patches[i].hidden)
            add_patch(o, e, i, shapes);
    }
    drop_unused(stage);
    return status;
}

kg_status kg_patch_scene_compose(void **cache, const kg_editor *e, kg_overlay *o, kg_error *error) {
    const kg_reference *reference = &kg_editor_model(e)->reference;
    if (!*cache && !(*cache = calloc(1, sizeof(patch_stage))))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    patch_stage *stage = *cache;
    kg_status status = follow_reference(stage, &e->backdrop, error);
    if (status)
        return status;
    if (reference->visible && reference->opacity > 0)
        kg_overlay_item(
            o, stage->reference,
            kg_style_default((kg_color){0.72F, 0.74F, 0.78F, (float)fmin(reference->opacity, 1)}));
    return add_patches(stage, e, o, error);
}

void kg_patch_scene_drop(void *cache) {
    patch_stage *stage = cache;
    for (size_t i = 0; i < stage->patches.count; i++)
        clear_shapes(&stage->patches.items[i]);
    free(stage->patches.items);
    kg_shape_destroy(stage->reference);
    free(stage);
}
