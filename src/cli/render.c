/* katagami render: an off-screen picture of the model and its reference. */
#include "katagami/render.h"
#include "cli/card.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "katagami/document.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_option options[] = {
    {"output", 'o', true, "FILE.png", "picture to write; required"},
    {"size", 0, true, "WxH", "size in pixels (1200x800)"},
    {"view", 0, true, "NAME", "front, back, left, right, top, bottom or iso (iso)"},
    {"open", 0, true, "DEG", "how far a card is open: 0 closed, 90 standing, 180 flat (90)"},
    {"step", 0, true, "N", "sheets after so many folds (all of them)"},
    {"fraction", 0, true, "F", "sheets in the middle of the fold after these, 0 to 1 (0)"},
    {"reference", 0, true, "OPACITY", "how opaque the reference is, 0 to 1 (the model's own)"},
    {"samples", 0, true, "N", "N x N samples for each pixel (2)"},
};

/* Items besides those of the patches. */
enum { MAX_ITEMS = 4 };

/* Triangles bent by less are one smooth surface: all those of patches, none of cards. */
#define PATCH_CREASE 3.2
#define CARD_CREASE 0.02

/* A closed card is drawn open by this much, rad: sheets that lie on each other would be drawn
 * through each other. No corner moves by more than a three-hundredth of the card. */
#define AJAR 0.003

typedef struct picture {
    int width, height, samples;
    kg_view view;
    double opacity; /* of the reference; below 0: the model's own */
    double open_deg;
    double step; /* below 0: the last */
    double fraction;
} picture;

/* What is drawn: shapes to be destroyed afterwards, and the items that show them. */
typedef struct stage {
    kg_shape **shapes;
    kg_item *items;
    size_t count, capacity;
} stage;

static kg_status stage_add(stage *s, kg_shape *shape, kg_style style, kg_error *error) {
    if (s->count == s->capacity) {
        kg_shape_destroy(shape);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    s->shapes[s->count] = shape;
    s->items[s->count++] = (kg_item){.shape = shape, .style = style};
    return KG_OK;
}

static void stage_clear(stage *s) {
    for (size_t i = 0; i < s->count; i++)
        kg_shape_destroy(s->shapes[i]);
    free(s->shapes);
    free(s->items);
}

/* Sheets have two colours. */
static kg_style style_of(kg_document *d, const kg_mesh *mesh, size_t group) {
    const kg_origami *origami = kg_document_origami(d);
    if (!origami)
        return kg_style_default(kg_color_from_linear(mesh->groups[group].color));
    uint32_t front, back;
    kg_origami_colors(origami, (int32_t)group, &front, &back);
    kg_style style = kg_style_default(kg_color_from_linear(mesh->groups[group].color));
    style.back = (kg_color){(float)(back >> 16 & 0xff) / 255.0F, (float)(back >> 8 & 0xff) / 255.0F,
                            (float)(back & 0xff) / 255.0F, 1};
    return style;
}

/* One group of a mesh as a surface and its outlines. */
static kg_status add_group(stage *s, const kg_mesh *mesh, size_t first, size_t count, double crease,
                           kg_style style, bool outlines, kg_error *error) {
    kg_surface surface;
    kg_shape *shape;
    kg_status status = kg_surface_from_mesh(mesh, first, count, crease, NULL, &surface, error);
    if (status)
        return status;
    if (!(status = kg_shape_from_surface(&surface, &shape, error)))
        status = stage_add(s, shape, style, error);
    if (!status && outlines && !(status = kg_shape_from_edges(&surface, crease, &shape, error))) {
        kg_style line = kg_style_default((kg_color){0.1F, 0.1F, 0.12F, 1});
        status = stage_add(s, shape, line, error);
    }
    kg_surface_destroy(&surface);
    return status;
}

static kg_status add_model(stage *s, kg_document *d, kg_error *error) {
    kg_mesh *mesh;
    kg_status status =
        kg_document_mesh(d, kg_document_model(d) ? kg_palette_linear : NULL, &mesh, error);
    if (status)
        return status;
    double crease = kg_document_model(d) ? PATCH_CREASE : CARD_CREASE;
    for (size_t i = 0; i < mesh->group_count && !status; i++) {
        const kg_mesh_group *g = &mesh->groups[i];
        if (g->face_count > 0)
            status = add_group(s, mesh, g->first_face, g->face_count, crease, style_of(d, mesh, i),
                               true, error);
    }
    kg_mesh_destroy(mesh);
    return status;
}

/* Construction patches are no part of the surface: a faint sheet shows where they cut. */
static kg_status add_construction(stage *s, const kg_solved_patch *p, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < p->regions.count && !status; i++) {
        kg_tessellation t;
        kg_shape *shape;
        status = kg_region_tessellate(&p->patch, &p->regions.items[i], &t, error);
        if (status)
            break;
        kg_vec3 *points = malloc((t.vertex_count + 1) * sizeof *points);
        for (size_t k = 0; k < t.vertex_count && points; k++)
            points[k] = t.vertices[k].position;
        kg_surface surface = {t.vertex_count, points, NULL, t.triangle_count, t.triangles};
        status = points ? kg_shape_from_surface(&surface, &shape, error)
                        : kg_fail(error, KG_ERR_MEMORY, "out of memory");
        if (!status)
            status =
                stage_add(s, shape, kg_style_default((kg_color){0.5F, 0.5F, 0.55F, 0.2F}), error);
        free(points);
        kg_tessellation_clear(&t);
    }
    return status;
}

static kg_status add_constructions(stage *s, const kg_document *d, kg_error *error) {
    const kg_solution *solution = kg_document_solution(d);
    kg_status status = KG_OK;
    for (size_t i = 0; solution && i < kg_solution_count(solution) && !status; i++)
        if (kg_solution_patch(solution, i)->construction)
            status = add_construction(s, kg_solution_patch(solution, i), error);
    return status;
}

static kg_status add_reference(stage *s, kg_document *d, double opacity, kg_error *error) {
    if (!kg_document_model(d))
        return KG_OK;
    const kg_reference *ref = &kg_document_model(d)->reference;
    double shown = opacity >= 0 ? opacity : ref->visible ? ref->opacity : 0;
    if (!ref->file || shown <= 0)
        return KG_OK;
    kg_mesh *mesh;
    kg_status status = kg_document_reference(d, NULL, &mesh, error);
    if (status)
        return status;
    /* edges bent by more than 35 degrees are edges of the object, not of its triangles */
    status = add_group(s, mesh, 0, mesh->face_count, 0.61,
                       kg_style_default((kg_color){0.72F, 0.74F, 0.78F, (float)fmin(shown, 1)}),
                       false, error);
    kg_mesh_destroy(mesh);
    return status;
}

static kg_status draw(kg_document *d, const picture *p, const char *path, kg_error *error) {
    kg_offscreen *offscreen;
    kg_renderer *renderer = NULL;
    kg_image image = {0};
    kg_status status = kg_offscreen_create(&offscreen, error);
    if (status)
        return status;
    const kg_solution *solution = kg_document_solution(d);
    const kg_origami *origami = kg_document_origami(d);
    size_t groups = solution  ? kg_solution_count(solution)
                    : origami ? kg_origami_state_at(origami, 0)->loops.count
                              : 0;
    for (size_t i = 0; solution && i < kg_solution_count(solution); i++)
        groups += kg_solution_patch(solution, i)->regions.count;
    stage s = {.capacity = 2 * groups + MAX_ITEMS};
    s.shapes = calloc(s.capacity, sizeof *s.shapes);
    s.items = calloc(s.capacity, sizeof *s.items);
    if (!s.shapes || !s.items)
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status)
        status = kg_renderer_create(&renderer, error);
    if (!status)
        status = add_model(&s, d, error);
    if (!status)
        status = add_constructions(&s, d, error);
    if (!status)
        status = add_reference(&s, d, p->opacity, error);
    if (!status) {
        kg_scene scene = kg_scene_default();
        kg_camera camera = kg_camera_default();
        scene.items = s.items;
        scene.item_count = s.count;
        camera.ortho = p->view != KG_VIEW_ISO;
        kg_camera_look(&camera, p->view);
        kg_camera_fit(&camera, kg_scene_box(&scene), (double)p->width / p->height);
        status = kg_renderer_picture(renderer, &scene, &camera, p->width, p->height, p->samples,
                                     &image, error);
    }
    if (!status)
        status = kg_image_write_png(&image, path, error);
    kg_image_destroy(&image);
    stage_clear(&s);
    kg_renderer_destroy(renderer);
    kg_offscreen_destroy(offscreen);
    return status;
}

static int read_picture(const kg_arguments *a, picture *out) {
    const char *size = kg_arguments_get(a, "size"), *view = kg_arguments_get(a, "view");
    double samples = 2;
    char rest;
    *out = (picture){1200, 800, 2, KG_VIEW_ISO, -1, 90, -1, 0};
    if (size && (sscanf(size, "%dx%d%c", &out->width, &out->height, &rest) != 2 || out->width < 1 ||
                 out->height < 1 || out->width > 16384 || out->height > 16384))
        return kg_command_misuse("render", "--size is WxH in pixels, not %s", size);
    if (view && !kg_view_parse(view, &out->view))
        return kg_command_misuse("render", "there is no view called %s", view);
    if (!kg_arguments_number(a, "reference", 0, 1, &out->opacity) ||
        !kg_arguments_number(a, "open", 0, 180, &out->open_deg) ||
        !kg_arguments_number(a, "step", 0, 1e6, &out->step) ||
        !kg_arguments_number(a, "fraction", 0, 1, &out->fraction) ||
        !kg_arguments_number(a, "samples", 1, 8, &samples))
        return KG_EXIT_USAGE;
    out->samples = (int)samples;
    return -1;
}

int kg_command_render(int argc, char **argv) {
    kg_arguments a;
    int code = kg_arguments_parse(argc, argv, "katagami render MODEL -o FILE.png [OPTION…]",
                                  options, sizeof options / sizeof *options, &a);
    if (code >= 0)
        return code;
    const char *path = kg_arguments_get(&a, "output");
    picture wanted;
    if (a.count != 1 || !path)
        return kg_command_misuse("render", "a model and an output (-o) are wanted");
    if ((code = read_picture(&a, &wanted)) >= 0)
        return code;
    kg_error error;
    kg_document *document = NULL;
    kg_status status = kg_document_read(a.words[0], &document, &error);
    if (!status)
        status = kg_document_solve(document, KG_MESH_CHORD, &error);
    if (!status && wanted.step >= 0)
        status = kg_document_set_step(document, (size_t)wanted.step, &error);
    if (!status) {
        kg_document_set_fraction(document, wanted.fraction);
        kg_document_set_open(document, fmax(wanted.open_deg * KG_PI / 180, AJAR));
        kg_card_warn(document, "render");
        status = draw(document, &wanted, path, &error);
    }
    kg_document_destroy(document);
    return status ? kg_command_fail("render", &error) : KG_EXIT_DONE;
}
