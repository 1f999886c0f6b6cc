#include "guide/guide.h"

#include "net/drawing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const kg_text title_text = {KG_BOOK_TITLE, KG_INK, KG_ALIGN_LEFT, 3};
static const kg_text heading = {KG_BOOK_HEADING, KG_INK, KG_ALIGN_LEFT, 0};
static const kg_text plain = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_LEFT, 0};
static const kg_text faint = {KG_BOOK_TEXT, KG_FAINT_INK, KG_ALIGN_LEFT, 0};
static const kg_text entry = {KG_BOOK_SMALL, KG_INK, KG_ALIGN_LEFT, 2};

/* ---- cover ------------------------------------------------------------------------------ */

static double length_of(const kg_net_line *line) {
    double length = line->closed && line->count > 0
                        ? kg_dist2(line->points[line->count - 1], line->points[0])
                        : 0;
    for (size_t i = 1; i < line->count; i++)
        length += kg_dist2(line->points[i - 1], line->points[i]);
    return length;
}

/* What a patient hand does, written sizes: 100 mm of cut and 40 mm of glued edge a minute, a minute
 * more for each join to fit it and two for each part to fold and roll it. */
static void print_work(const kg_guide *g, char *out, size_t size) {
    double cut = 0, glue = 0;
    char time[64];
    for (size_t i = 0; i < g->net->part_count; i++)
        for (size_t k = 0; k < g->net->parts[i].loop_count; k++)
            cut += length_of(&g->net->parts[i].loops[k].line) * g->layout->scale;
    for (size_t i = 0; i < g->net->join_count; i++)
        glue += g->net->joins[i].sides[0].length * g->layout->scale;
    double minutes =
        cut / 100 + glue / 40 + (double)g->net->join_count + 2 * (double)g->net->part_count;
    int quarters = (int)fmin(fmax(ceil(minutes / 15), 1), 1e6);
    if (quarters < 4)
        kg_words(time, sizeof time, KG_WORD_MINUTES, 15 * quarters);
    else
        kg_words(time, sizeof time, KG_WORD_HOURS, quarters / 4, 15 * (quarters % 4));
    kg_words(out, size, KG_WORD_WORK, cut / 10, glue / 10, time);
}

static kg_status add_cover(kg_guide *g, kg_error *error) {
    char text[KG_SENTENCE];
    kg_book *paper = g->paper;
    unsigned char *roles = malloc(g->net->part_count + 1);
    if (!roles)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    memset(roles, KG_ROLE_STANDING, g->net->part_count + 1);
    kg_book_write(paper, &title_text,
                  g->title ? g->title : kg_words(text, sizeof text, KG_WORD_UNTITLED));
    kg_book_write(paper, &faint, kg_words(text, sizeof text, KG_WORD_GUIDE));
    paper->y += 6;

    kg_view_of view = {.roles = roles};
    kg_vec2 size = kg_v2(kg_book_width(paper), 0.75 * kg_book_width(paper));
    kg_camera camera = kg_camera_default();
    kg_camera_fit(&camera, g->assembly->box, size.x / size.y);
    kg_status status = kg_guide_picture(g, &view, KG_LOOK_COLORS, &camera,
                                        kg_v2(KG_BOOK_MARGIN, paper->y), size, error);
    free(roles);
    paper->y += size.y + 6;
    kg_vec3 extent = kg_scale(kg_sub(g->assembly->box.hi, g->assembly->box.lo), g->layout->scale);
    kg_book_write(paper, &plain,
                  kg_words(text, sizeof text, KG_WORD_SIZE, extent.x, extent.y, extent.z));
    kg_book_write(paper, &plain,
                  kg_words(text, sizeof text, KG_WORD_COUNTS, (int)g->net->part_count,
                           (int)g->layout->page_count, (int)g->net->join_count));
    print_work(g, text, sizeof text);
    kg_book_write(paper, &plain, text);
    return status;
}

/* ---- parts ------------------------------------------------------------------------------ */

enum { COLUMNS = 5 };

#define CELL_HEIGHT 60.0
#define CELL_TEXT 11.0
#define LEAST_DRAWN 16.0 /* mm, smaller parts are drawn larger than the others */

/* A part as it lies on its page, turned like there. */
typedef struct thumbnail {
    double angle;
    kg_box2 box; /* turned */
} thumbnail;

static kg_vec2 turned(kg_vec2 p, double angle) {
    return kg_v2(cos(angle) * p.x - sin(angle) * p.y, sin(angle) * p.x + cos(angle) * p.y);
}

static thumbnail thumbnail_of(const kg_guide *g, size_t part) {
    thumbnail t = {g->layout->placements[part].angle, kg_box2_empty()};
    const kg_net_line *outline = &g->net->parts[part].loops[0].line;
    for (size_t i = 0; i < outline->count; i++)
        kg_box2_add(&t.box, turned(outline->points[i], t.angle));
    return t;
}

static kg_vec2 extent_of(const thumbnail *t) {
    return kg_sub2(t->box.hi, t->box.lo);
}

static void trace(cairo_t *cr, const thumbnail *t, const kg_vec2 *points, size_t count,
                  bool closed) {
    for (size_t i = 0; i < count; i++) {
        kg_vec2 p = turned(points[i], t->angle);
        if (i == 0)
            cairo_move_to(cr, p.x, p.y);
        else
            cairo_line_to(cr, p.x, p.y);
    }
    if (closed)
        cairo_close_path(cr);
}

/* A stroke of `width` mm on paper, whatever the scale of the drawing. */
static void stroke(kg_book *paper, uint32_t color, double width, double scale) {
    kg_book_color(paper, color);
    cairo_set_line_width(paper->cr, width / scale);
    cairo_stroke(paper->cr);
}

static void show_thumbnail(kg_guide *g, size_t index, const thumbnail *t, kg_vec2 center,
                           double scale) {
    kg_book *paper = g->paper;
    const kg_net_part *part = &g->net->parts[index];
    const kg_assembly_part *shape = &g->assembly->parts[index];
    kg_color c = shape->color;
    cairo_save(paper->cr);
    cairo_translate(paper->cr, center.x, center.y);
    cairo_scale(paper->cr, scale, scale);
    kg_vec2 middle = kg_lerp2(t->box.lo, t->box.hi, 0.5);
    cairo_translate(paper->cr, -middle.x, -middle.y);
    for (size_t i = 0; i < part->loop_count; i++)
        trace(paper->cr, t, part->loops[i].line.points, part->loops[i].line.count, true);
    cairo_set_source_rgb(paper->cr, 0.6 + 0.4 * (double)c.r, 0.6 + 0.4 * (double)c.g,
                         0.6 + 0.4 * (double)c.b);
    cairo_fill_preserve(paper->cr);
    stroke(paper, KG_INK, 0.25, scale);
    for (size_t i = 0; i < shape->ruling_count; i++)
        trace(paper->cr, t, shape->rulings[i], 2, false);
    stroke(paper, 0x8a949c, 0.12, scale);
    for (size_t i = 0; i < part->line_count; i++)
        trace(paper->cr, t, part->lines[i].points, part->lines[i].count, part->lines[i].closed);
    stroke(paper, 0x4a525a, 0.12, scale);
    cairo_restore(paper->cr);
}

static void add_parts(kg_guide *g) {
    char text[KG_SENTENCE];
    kg_book *paper = g->paper;
    double width = kg_book_width(paper) / COLUMNS, scale = INFINITY;
    kg_vec2 room = kg_v2(width - 6, CELL_HEIGHT - CELL_TEXT - 4);
    for (size_t i = 0; i < g->net->part_count; i++) {
        thumbnail t = thumbnail_of(g, i);
        scale = fmin(scale, fmin(room.x / extent_of(&t).x, room.y / extent_of(&t).y));
    }
    kg_book_write(paper, &heading, kg_words(text, sizeof text, KG_WORD_PARTS));
    paper->y += 2;
    for (size_t i = 0; i < g->net->part_count; i++) {
        size_t column = i % COLUMNS;
        if (column == 0)
            kg_book_need(paper, CELL_HEIGHT);
        double x = KG_BOOK_MARGIN + (double)column * width;
        thumbnail t = thumbnail_of(g, i);
        kg_vec2 extent = extent_of(&t);
        double own = fmin(fmax(scale, LEAST_DRAWN / fmax(extent.x, extent.y)),
                          fmin(room.x / extent.x, room.y / extent.y));
        show_thumbnail(g, i, &t, kg_v2(x + width / 2, paper->y + room.y / 2 + 1), own);
        int number = g->net->parts[i].number;
        double half = kg_book_badge_half(number).x, y = paper->y + CELL_HEIGHT - CELL_TEXT;
        kg_book_part_badge(paper, x + half + 1, y + 2.6, number, 0xffffff);
        double left = x + 2 * half + 2.5, wide = width - 2 * half - 4;
        const char *name = g->net->parts[i].name;
        if (name && name[0])
            y += kg_book_text(paper, &entry, left, y, wide, name);
        kg_words(text, sizeof text, KG_WORD_PAGE, g->layout->placements[i].page + 1);
        kg_book_text(paper, &entry, left, y, wide, text);
        if (column == COLUMNS - 1 || i + 1 == g->net->part_count)
            paper->y += CELL_HEIGHT;
    }
}

/* ---- legend ----------------------------------------------------------------------------- */

#define SAMPLE_WIDTH 26.0

static void show_sample(kg_guide *g, kg_net_layer layer, double x, double y) {
    kg_book *paper = g->paper;
    const double *dashes = NULL;
    int count = g->options->dashes ? kg_layer_dashes(layer, &dashes) : 0;
    cairo_set_dash(paper->cr, dashes, count, 0);
    cairo_move_to(paper->cr, x, y);
    cairo_line_to(paper->cr, x + SAMPLE_WIDTH, y);
    stroke(paper, g->options->styles[layer].color, fmax(g->options->styles[layer].width, 0.25), 1);
    cairo_set_dash(paper->cr, NULL, 0, 0);
}

static void show_tab(kg_guide *g, double x, double y) {
    kg_book *paper = g->paper;
    cairo_move_to(paper->cr, x + 3, y + 2);
    cairo_line_to(paper->cr, x + 6, y - 2);
    cairo_line_to(paper->cr, x + 20, y - 2);
    cairo_line_to(paper->cr, x + 23, y + 2);
    stroke(paper, g->options->styles[KG_LAYER_CUT].color, 0.25, 1);
    show_sample(g, KG_LAYER_MOUNTAIN, x, y + 2);
}

typedef enum sample { SAMPLE_LINE, SAMPLE_TAB, SAMPLE_NUMBER, SAMPLE_PART, SAMPLE_NONE } sample;

typedef struct legend_row {
    sample sample;
    kg_net_layer layer;
    kg_word word;
} legend_row;

static const legend_row legend[] = {
    {SAMPLE_LINE, KG_LAYER_CUT, KG_WORD_CUT},
    {SAMPLE_LINE, KG_LAYER_MOUNTAIN, KG_WORD_MOUNTAIN},
    {SAMPLE_LINE, KG_LAYER_VALLEY, KG_WORD_VALLEY},
    {SAMPLE_LINE, KG_LAYER_MARK, KG_WORD_MARK},
    {SAMPLE_TAB, KG_LAYER_CUT, KG_WORD_TAB},
    {SAMPLE_NUMBER, KG_LAYER_LABEL, KG_WORD_NUMBERS},
    {SAMPLE_NONE, KG_LAYER_LABEL, KG_WORD_RULINGS},
    {SAMPLE_PART, KG_LAYER_LABEL, KG_WORD_PICTURES},
    {SAMPLE_NONE, KG_LAYER_LABEL, KG_WORD_GLUING},
};

static void add_legend(kg_guide *g) {
    char text[KG_SENTENCE];
    kg_book *paper = g->paper;
    double x = KG_BOOK_MARGIN, column = x + SAMPLE_WIDTH + 6,
           width = kg_book_width(paper) - SAMPLE_WIDTH - 6;
    kg_book_need(paper, 95);
    paper->y += 4;
    kg_book_write(paper, &heading, kg_words(text, sizeof text, KG_WORD_LEGEND));
    paper->y += 2;
    for (size_t i = 0; i < sizeof legend / sizeof *legend; i++) {
        kg_words(text, sizeof text, legend[i].word);
        double height = kg_book_text_height(paper, &plain, width, text), y = paper->y + 2.6;
        kg_book_need(paper, height);
        if (legend[i].sample == SAMPLE_LINE)
            show_sample(g, legend[i].layer, x, y);
        else if (legend[i].sample == SAMPLE_TAB)
            show_tab(g, x, y);
        else if (legend[i].sample == SAMPLE_NUMBER)
            kg_book_join_badge(paper, x + SAMPLE_WIDTH / 2, y, 7);
        else if (legend[i].sample == SAMPLE_PART)
            kg_book_part_badge(paper, x + SAMPLE_WIDTH / 2, y, 4, KG_STAGE_NEW);
        paper->y += kg_book_text(paper, &plain, column, paper->y, width, text) + 2.2;
    }
}

kg_status kg_guide_opening(kg_guide *g, kg_error *error) {
    kg_status status = add_cover(g, error);
    if (status)
        return status;
    kg_book_turn(g->paper);
    add_parts(g);
    add_legend(g);
    return KG_OK;
}
