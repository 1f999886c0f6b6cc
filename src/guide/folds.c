/* The pages of a folding sequence: pictures in two columns, the signs, the crease pattern. */
#include "guide/dimension.h"
#include "guide/guide.h"
#include "net/text.h"

#include <stdio.h>
#include <stdlib.h>

/* Cells, mm: two beside each other. */
#define GUTTER 8.0
#define PICTURE_HEIGHT 62.0
#define CAPTION_HEIGHT 15.0
#define ROW_GAP 4.0
/* Around the drawing, for circles and lengths. */
#define PICTURE_ROOM 7.0
/* All pictures have one scale, but those of small paper may be so much larger. */
#define MOST_ENLARGED 1.4
/* Height of the crease pattern of one sheet. */
#define PATTERN_HEIGHT 140.0

static const kg_text title_text = {KG_BOOK_TITLE, KG_INK, KG_ALIGN_LEFT, 2},
                     heading = {KG_BOOK_HEADING, KG_INK, KG_ALIGN_LEFT, 0},
                     plain = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_LEFT, 0},
                     caption = {KG_BOOK_TEXT, KG_INK, KG_ALIGN_LEFT, 3},
                     faint = {KG_BOOK_TEXT, KG_FAINT_INK, KG_ALIGN_LEFT, 0},
                     small = {KG_BOOK_SMALL, KG_INK, KG_ALIGN_CENTER, 1};

/* ---- opening ---------------------------------------------------------------------------- */

static void write_opening(kg_guide *g, const kg_origami *o) {
    char text[KG_SENTENCE];
    const kg_origami_state *s = kg_origami_state_at(o, 0);
    kg_book_write(g->paper, &title_text,
                  g->title ? g->title : kg_words(text, sizeof text, KG_WORD_SHEETS_GUIDE));
    g->paper->y += 1;
    int32_t sheets = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        sheets = s->loops.items[i].sheet >= sheets ? s->loops.items[i].sheet + 1 : sheets;
    for (int32_t sheet = 0; sheet < sheets; sheet++) {
        kg_box2 box = kg_box2_empty();
        for (size_t i = 0; i < s->vertices.count; i++)
            if (s->vertices.items[i].sheet == sheet)
                kg_box2_add(&box, s->vertices.items[i].paper);
        kg_words(text, sizeof text, KG_WORD_SHEET_SIZE, sheet + 1, box.hi.x - box.lo.x,
                 box.hi.y - box.lo.y);
        kg_book_write(g->paper, &plain, text);
        g->paper->y += 1;
    }
    kg_words(text, sizeof text, KG_WORD_SHEETS_COUNTS, (int)kg_origami_step(o));
    kg_book_write(g->paper, &faint, text);
    g->paper->y += 5;
}

/* ---- pictures --------------------------------------------------------------------------- */

static kg_vec2 cell_size(const kg_book *paper) {
    return kg_v2((kg_book_width(paper) - GUTTER) / 2, PICTURE_HEIGHT);
}

/* The largest at which a drawing fits. */
static double fitting_scale(const kg_diagram *d, kg_vec2 size) {
    kg_vec2 span = kg_sub2(d->box.hi, d->box.lo);
    return fmin((size.x - 2 * PICTURE_ROOM) / fmax(span.x, 1e-9),
                (size.y - 2 * PICTURE_ROOM) / fmax(span.y, 1e-9));
}

typedef struct frame {
    kg_vec2 offset;
    double scale;
} frame;

static kg_vec2 placed(const frame *f, kg_vec2 p) {
    return kg_v2(f->offset.x + f->scale * p.x, f->offset.y - f->scale * p.y);
}

static void paint_dimension(kg_guide *g, const kg_dimension *d, const char *text) {
    cairo_t *cr = g->paper->cr;
    kg_book_color(g->paper, KG_FAINT_INK);
    cairo_set_line_width(cr, 0.15);
    kg_vec2 line[2];
    for (int k = 0; k < 2; k++) {
        kg_vec2 start = kg_dimension_at(d, k, 0.8), end = kg_dimension_at(d, k, d->off + 0.8);
        line[k] = kg_dimension_at(d, k, d->off);
        cairo_move_to(cr, start.x, start.y);
        cairo_line_to(cr, end.x, end.y);
    }
    cairo_move_to(cr, line[0].x, line[0].y);
    cairo_line_to(cr, line[1].x, line[1].y);
    cairo_stroke(cr);
    /* readable where it has to lie on paper */
    kg_vec2 span = kg_sub2(d->label.hi, d->label.lo);
    cairo_rectangle(cr, d->label.lo.x, d->label.lo.y, span.x, span.y);
    cairo_set_source_rgba(cr, 1, 1, 1, 0.85);
    cairo_fill(cr);
    kg_book_text(g->paper, &small, d->label.lo.x - 6, d->label.lo.y, span.x + 12, text);
}

/* All lengths that a picture needs, with as much room as the longest of their labels. */
static void paint_dimensions(kg_guide *g, const kg_diagram *d, const frame *f, const kg_vec2 *arrow,
                             size_t arrow_count) {
    kg_diagram_length lengths[KG_DIAGRAM_MEASURES];
    kg_dimension places[KG_DIAGRAM_MEASURES];
    char text[KG_SENTENCE];
    double width = 0;
    for (size_t i = 0; i < d->measure_count; i++) {
        const kg_diagram_length *m = &d->measures[i];
        lengths[i] =
            (kg_diagram_length){placed(f, m->from), placed(f, m->to),
                                kg_v2(m->outwards.x, -m->outwards.y), round(10 * m->length) / 10};
        kg_words(text, sizeof text, KG_WORD_LENGTH, lengths[i].length);
        width = fmax(width, small.size * kg_text_width(text));
    }
    size_t count =
        kg_dimensions_place(lengths, d->measure_count, arrow, arrow_count, width, places);
    for (size_t i = 0; i < count; i++)
        paint_dimension(g, &places[i],
                        kg_words(text, sizeof text, KG_WORD_LENGTH, places[i].length));
}

static kg_status paint_picture(kg_guide *g, const kg_diagram *d, kg_vec2 at, double scale,
                               kg_error *error) {
    cairo_t *cr = g->paper->cr;
    kg_status status = kg_diagram_paint(d, cr, at, scale, error);
    if (status)
        return status;
    kg_vec2 middle = kg_lerp2(d->box.lo, d->box.hi, 0.5), path[KG_ARROW_POINTS];
    frame f = {kg_v2(at.x - scale * middle.x, at.y + scale * middle.y), scale};
    for (size_t i = 0; i < d->mark_count; i++) {
        kg_vec2 p = placed(&f, d->marks[i]);
        cairo_new_path(cr);
        cairo_arc(cr, p.x, p.y, 1.7, 0, 6.2832);
        kg_book_color(g->paper, KG_INK);
        cairo_set_line_width(cr, 0.3);
        cairo_stroke(cr);
    }
    for (int i = 0; i < KG_ARROW_POINTS; i++)
        path[i] = placed(&f, d->path[i]);
    kg_arrow_paint(cr, d->arrow, d->tucked, path, KG_ARROW_POINTS);
    paint_dimensions(g, d, &f, path, d->folds > 0 ? KG_ARROW_POINTS : 0);
    return KG_OK;
}

/* ---- captions --------------------------------------------------------------------------- */

static void add_sentence(char *out, size_t size, const char *sentence) {
    char before[KG_SENTENCE];
    if (!out[0]) {
        snprintf(out, size, "%s", sentence);
        return;
    }
    snprintf(before, sizeof before, "%s", out);
    kg_words(out, size, KG_WORD_AND, before, sentence);
}

static void describe(const kg_diagram *d, bool first, char *out, size_t size) {
    static const kg_word ways[][2] = {
        [KG_GOAL_NONE] = {KG_WORD_ALONG_LINE, KG_WORD_ALONG_LINE_BEHIND},
        [KG_GOAL_CORNER] = {KG_WORD_TO_CORNER, KG_WORD_TO_CORNER_BEHIND},
        [KG_GOAL_LINE] = {KG_WORD_EDGE_TO_LINE, KG_WORD_EDGE_TO_LINE_BEHIND},
        [KG_GOAL_EDGE] = {KG_WORD_TO_EDGE, KG_WORD_TO_EDGE_BEHIND},
        [KG_GOAL_POINT] = {KG_WORD_TO_POINT, KG_WORD_TO_POINT_BEHIND}};
    char text[KG_SENTENCE];
    out[0] = 0;
    if (d->turned)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_TURN_OVER));
    if (d->folds == 0) {
        kg_words(text, sizeof text, first ? KG_WORD_COLLAPSED : KG_WORD_FINISHED);
        add_sentence(out, size, text);
        return;
    }
    kg_word way = ways[d->goal][d->behind];
    if (d->goal == KG_GOAL_CORNER && d->edge)
        way = d->behind ? KG_WORD_EDGE_TO_EDGE_BEHIND : KG_WORD_EDGE_TO_EDGE;
    add_sentence(out, size, kg_words(text, sizeof text, way));
    if (d->angle_deg < 180)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_BY_ANGLE, d->angle_deg));
    if (d->tucked)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_TUCK));
    if (d->layers > 1 && d->layers < d->stack)
        add_sentence(
            out, size,
            kg_words(text, sizeof text, KG_WORD_TOP_LAYERS, (int)d->layers, (int)d->stack));
    else if (d->layers > 1)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_LAYERS, (int)d->layers));
    else if (d->stack > 1)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_TOP_LAYER, (int)d->stack));
    if (d->folds == 2)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_UNFOLD));
    if (d->oblique)
        add_sentence(out, size, kg_words(text, sizeof text, KG_WORD_SEEN_OBLIQUE));
}

static kg_status write_steps(kg_guide *g, const kg_origami *o, kg_error *error) {
    kg_diagram *diagrams;
    size_t count;
    kg_status status = kg_diagrams_create(o, &diagrams, &count, error);
    if (status)
        return status;
    kg_vec2 size = cell_size(g->paper);
    double common = INFINITY, height = PICTURE_HEIGHT + CAPTION_HEIGHT;
    for (size_t i = 0; i < count; i++)
        common = fmin(common, fitting_scale(&diagrams[i], size));
    for (size_t i = 0; i < count && !status; i++) {
        const kg_diagram *d = &diagrams[i];
        char text[KG_SENTENCE], number[24];
        if (i % 2 == 0)
            kg_book_need(g->paper, height);
        double x = KG_BOOK_MARGIN + (i % 2 ? size.x + GUTTER : 0), y = g->paper->y;
        double scale = fmin(fitting_scale(d, size), MOST_ENLARGED * common);
        status = paint_picture(g, d, kg_v2(x + size.x / 2, y + size.y / 2), scale, error);
        snprintf(number, sizeof number, "%zu", i + 1);
        kg_book_text(g->paper, &heading, x, y, 14, number);
        if (d->turned)
            kg_diagram_turn_symbol(g->paper->cr, kg_v2(x + 17, y + 4));
        describe(d, i == 0, text, sizeof text);
        kg_book_text(g->paper, &caption, x, y + PICTURE_HEIGHT, size.x, text);
        if (i % 2 || i + 1 == count)
            g->paper->y += height + ROW_GAP;
        if (!status)
            status = kg_guide_tick(g, (double)(i + 1) / (double)count, error);
    }
    free(diagrams);
    return status;
}

/* ---- signs and crease pattern ----------------------------------------------------------- */

/* Lines of the net: cuts and marks solid. */
static void set_line(cairo_t *cr, kg_net_kind kind) {
    cairo_set_dash(cr, NULL, 0, 0);
    cairo_set_line_width(cr, kind == KG_NET_CUT ? 0.4 : 0.12);
    if (kind == KG_NET_MOUNTAIN || kind == KG_NET_VALLEY)
        kg_figure_fold_line(cr, kind == KG_NET_MOUNTAIN, 0);
}

void kg_guide_line_sign(kg_guide *g, kg_word word, kg_net_kind kind) {
    char text[KG_SENTENCE];
    cairo_t *cr = g->paper->cr;
    double y = g->paper->y + 2.6;
    kg_book_color(g->paper, KG_INK);
    set_line(cr, kind);
    cairo_move_to(cr, KG_BOOK_MARGIN, y);
    cairo_line_to(cr, KG_BOOK_MARGIN + 20, y);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0);
    kg_book_text(g->paper, &plain, KG_BOOK_MARGIN + 24, g->paper->y, 60,
                 kg_words(text, sizeof text, word));
    g->paper->y += 6.5;
}

static void write_arrow_sign(kg_guide *g, double y, kg_arrow_kind kind, kg_word word) {
    char text[KG_SENTENCE];
    double x = KG_BOOK_MARGIN + kg_book_width(g->paper) / 2;
    kg_vec2 path[KG_ARROW_POINTS];
    for (int i = 0; i < KG_ARROW_POINTS; i++) {
        double t = i / (KG_ARROW_POINTS - 1.0);
        path[i] = kg_v2(x + 16 * t, y + 4 - 12 * t * (1 - t));
    }
    if (kind == KG_ARROW_NONE)
        kg_diagram_turn_symbol(g->paper->cr, kg_v2(x + 8, y + 3.5));
    else
        kg_arrow_paint(g->paper->cr, kind, false, path, KG_ARROW_POINTS);
    kg_book_text(g->paper, &plain, x + 22, y, 60, kg_words(text, sizeof text, word));
}

static void write_signs(kg_guide *g) {
    char text[KG_SENTENCE];
    kg_book_need(g->paper, 45);
    kg_book_write(g->paper, &heading, kg_words(text, sizeof text, KG_WORD_SIGNS));
    g->paper->y += 2;
    double y = g->paper->y;
    write_arrow_sign(g, y, KG_ARROW_VALLEY, KG_WORD_VALLEY_ARROW);
    write_arrow_sign(g, y + 6.5, KG_ARROW_MOUNTAIN, KG_WORD_MOUNTAIN_ARROW);
    write_arrow_sign(g, y + 13, KG_ARROW_UNFOLD, KG_WORD_UNFOLD_ARROW);
    write_arrow_sign(g, y + 19.5, KG_ARROW_NONE, KG_WORD_TURN_SYMBOL);
    kg_guide_line_sign(g, KG_WORD_VALLEY_LINE, KG_NET_VALLEY);
    kg_guide_line_sign(g, KG_WORD_MOUNTAIN_LINE, KG_NET_MOUNTAIN);
    kg_guide_line_sign(g, KG_WORD_OLD_CREASE, KG_NET_MARK);
    g->paper->y += 10;
}

static void trace(cairo_t *cr, const kg_net_line *line, const frame *f) {
    cairo_new_path(cr);
    for (size_t i = 0; i < line->count; i++)
        cairo_line_to(cr, f->offset.x + f->scale * line->points[i].x,
                      f->offset.y + f->scale * line->points[i].y);
    if (line->closed)
        cairo_close_path(cr);
    cairo_stroke(cr);
}

void kg_guide_net(kg_guide *g, double height) {
    cairo_t *cr = g->paper->cr;
    for (size_t i = 0; i < g->net->part_count; i++) {
        const kg_net_part *part = &g->net->parts[i];
        kg_box2 box = kg_box2_empty();
        for (size_t k = 0; k < part->loop_count; k++)
            for (size_t c = 0; c < part->loops[k].line.count; c++)
                kg_box2_add(&box, part->loops[k].line.points[c]);
        kg_vec2 span = kg_sub2(box.hi, box.lo);
        frame f = {.scale = fmin(kg_book_width(g->paper) / fmax(span.x, 1e-9),
                                 height / fmax(span.y, 1e-9))};
        kg_book_need(g->paper, f.scale * span.y + 4);
        f.offset = kg_v2(KG_BOOK_MARGIN + (kg_book_width(g->paper) - f.scale * span.x) / 2 -
                             f.scale * box.lo.x,
                         g->paper->y + 4 - f.scale * box.lo.y);
        kg_book_color(g->paper, KG_INK);
        for (size_t k = 0; k < part->line_count; k++) {
            set_line(cr, part->lines[k].kind);
            trace(cr, &part->lines[k], &f);
        }
        set_line(cr, KG_NET_CUT);
        for (size_t k = 0; k < part->loop_count; k++)
            trace(cr, &part->loops[k].line, &f);
        g->paper->y += f.scale * span.y + 8;
    }
}

static void write_pattern(kg_guide *g) {
    char text[KG_SENTENCE];
    kg_book_need(g->paper, PATTERN_HEIGHT + 20);
    kg_book_write(g->paper, &heading, kg_words(text, sizeof text, KG_WORD_CREASE_PATTERN));
    kg_book_write(g->paper, &faint, kg_words(text, sizeof text, KG_WORD_PATTERN_TEXT));
    kg_guide_net(g, PATTERN_HEIGHT);
}

kg_status kg_guide_folds(kg_guide *g, const kg_origami *o, kg_error *error) {
    write_opening(g, o);
    kg_status status = write_steps(g, o, error);
    if (status)
        return status;
    write_signs(g);
    write_pattern(g);
    return KG_OK;
}
