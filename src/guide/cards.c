/* The pages of a pop-up card: what to do, pictures of it on its way, the sheet. */
#include "guide/guide.h"

#include <stdlib.h>

/* Pictures, mm: three beside each other. */
#define GUTTER 4.0
#define PICTURE_HEIGHT 52.0
#define DOTS_PER_MM (200 / 25.4)
/* Height of the sheet's picture. */
#define SHEET_HEIGHT 200.0
/* Faces bent by more have an edge between them. */
#define CREASE 0.02

/* Flat on each other the faces could not be told apart: closed is drawn a little open. */
static const double opens_deg[] = {90, 45, 5};
enum { PICTURES = sizeof opens_deg / sizeof *opens_deg, MAX_ITEMS = 8 };

static const double DEGREE = 0.017453292519943295;

static const kg_text title_text = {KG_BOOK_TITLE, KG_INK, KG_ALIGN_LEFT, 2},
                     heading = {KG_BOOK_HEADING, KG_INK, KG_ALIGN_LEFT, 0},
                     plain = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_LEFT, 0},
                     caption = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_CENTER, 1};

/* ---- pictures --------------------------------------------------------------------------- */

typedef struct scenery {
    kg_shape *shapes[MAX_ITEMS];
    kg_item items[MAX_ITEMS];
    size_t count;
} scenery;

static void add(scenery *s, kg_shape *shape, kg_style style) {
    s->shapes[s->count] = shape;
    s->items[s->count++] = (kg_item){.shape = shape, .style = style};
}

/* The paper's faces and its edges. */
static kg_status add_group(scenery *s, const kg_mesh *mesh, const kg_mesh_group *group,
                           kg_error *error) {
    kg_surface surface;
    kg_shape *shape;
    kg_style line = kg_style_default((kg_color){0.1F, 0.1F, 0.12F, 1});
    kg_status status = kg_surface_from_mesh(mesh, group->first_face, group->face_count, CREASE,
                                            NULL, &surface, error);
    if (status)
        return status;
    if (!(status = kg_shape_from_surface(&surface, &shape, error)))
        add(s, shape, kg_style_default(kg_color_from_linear(group->color)));
    if (!status && !(status = kg_shape_from_edges(&surface, CREASE, &shape, error)))
        add(s, shape, line);
    kg_surface_destroy(&surface);
    return status;
}

static kg_status paint(kg_guide *g, kg_renderer *renderer, const kg_document *document, double open,
                       kg_vec2 at, kg_vec2 size, kg_error *error) {
    kg_mesh *mesh;
    kg_image image = {0};
    scenery s = {.count = 0};
    kg_status status = kg_oa_pose(kg_document_oa(document), kg_document_sheet(document),
                                  kg_document_stability(document), open, &mesh, error);
    if (status)
        return status;
    for (size_t i = 0; i < mesh->group_count && 2 * i + 1 < MAX_ITEMS && !status; i++)
        status = add_group(&s, mesh, &mesh->groups[i], error);
    if (!status) {
        kg_scene scene = kg_scene_default();
        kg_camera camera = kg_camera_default();
        scene.items = s.items;
        scene.item_count = s.count;
        scene.background_top = scene.background_bottom = (kg_color){1, 1, 1, 1};
        kg_camera_look(&camera, KG_VIEW_ISO);
        kg_camera_fit(&camera, kg_scene_box(&scene), size.x / size.y);
        status = kg_renderer_picture(renderer, &scene, &camera, (int)lround(size.x * DOTS_PER_MM),
                                     (int)lround(size.y * DOTS_PER_MM), 2, &image, error);
    }
    if (!status)
        status = kg_book_image(g->paper, &image, at.x, at.y, size.x, error);
    kg_image_destroy(&image);
    for (size_t i = 0; i < s.count; i++)
        kg_shape_destroy(s.shapes[i]);
    kg_mesh_destroy(mesh);
    return status;
}

static kg_status write_pictures(kg_guide *g, const kg_document *d, kg_error *error) {
    kg_offscreen *offscreen;
    kg_renderer *renderer = NULL;
    kg_status status = kg_offscreen_create(&offscreen, error);
    if (status)
        return status;
    status = kg_renderer_create(&renderer, error);
    kg_book_need(g->paper, PICTURE_HEIGHT + 8);
    double width = (kg_book_width(g->paper) - (PICTURES - 1) * GUTTER) / PICTURES;
    for (int i = 0; i < PICTURES && !status; i++) {
        char text[KG_SENTENCE];
        kg_vec2 at = kg_v2(KG_BOOK_MARGIN + i * (width + GUTTER), g->paper->y);
        status =
            paint(g, renderer, d, opens_deg[i] * DEGREE, at, kg_v2(width, PICTURE_HEIGHT), error);
        kg_book_text(g->paper, &caption, at.x, at.y + PICTURE_HEIGHT + 1, width,
                     i + 1 < PICTURES ? kg_words(text, sizeof text, KG_WORD_CARD_AT, opens_deg[i])
                                      : kg_words(text, sizeof text, KG_WORD_CARD_CLOSED));
        if (!status)
            status = kg_guide_tick(g, (i + 1.0) / PICTURES, error);
    }
    g->paper->y += PICTURE_HEIGHT + 8;
    kg_renderer_destroy(renderer);
    kg_offscreen_destroy(offscreen);
    return status;
}

/* ---- pages ------------------------------------------------------------------------------ */

kg_status kg_guide_card(kg_guide *g, const kg_document *d, kg_error *error) {
    static const kg_word steps[] = {KG_WORD_CARD_CUT, KG_WORD_CARD_SCORE, KG_WORD_CARD_OPEN,
                                    KG_WORD_CARD_CLOSE};
    char text[KG_SENTENCE];
    const kg_oa *oa = kg_document_oa(d);
    const kg_oa_sheet *sheet = kg_document_sheet(d);
    double cell = oa->cell_mm * g->layout->scale;
    kg_book_write(g->paper, &title_text,
                  g->title ? g->title : kg_words(text, sizeof text, KG_WORD_CARD_GUIDE));
    g->paper->y += 1;
    kg_book_write(
        g->paper, &plain,
        kg_words(text, sizeof text, KG_WORD_CARD_SHEET, sheet->width * cell, sheet->rows * cell));
    g->paper->y += 4;
    kg_status status = write_pictures(g, d, error);
    if (status)
        return status;
    g->paper->y += 3;
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        kg_book_write(g->paper, &plain, kg_words(text, sizeof text, steps[i]));
        g->paper->y += 3;
    }
    g->paper->y += 3;
    kg_book_need(g->paper, 30);
    kg_book_write(g->paper, &heading, kg_words(text, sizeof text, KG_WORD_SIGNS));
    g->paper->y += 2;
    kg_guide_line_sign(g, KG_WORD_CUT_LINE, KG_NET_CUT);
    kg_guide_line_sign(g, KG_WORD_VALLEY_LINE, KG_NET_VALLEY);
    kg_guide_line_sign(g, KG_WORD_MOUNTAIN_LINE, KG_NET_MOUNTAIN);
    kg_book_turn(g->paper);
    kg_book_write(g->paper, &heading, kg_words(text, sizeof text, KG_WORD_CARD_NET));
    kg_guide_net(g, SHEET_HEIGHT);
    return KG_OK;
}
