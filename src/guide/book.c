#include "guide/book.h"

#include "guide/words.h"
#include "net/text.h"

#include <cairo-pdf.h>
#include <pango/pangocairo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double POINT = 72 / 25.4; /* points in a millimetre */

/* Pango lays out in pixels that it may round glyph positions to: a fine grid of them, mm. */
#define GRID 0.02

/* A font map of its own, so that nothing is left in Pango's for the thread. */
typedef struct texts {
    PangoFontMap *map;
    PangoContext *context;
} texts;

static texts *texts_create(void) {
    texts *t = calloc(1, sizeof *t);
    if (!t)
        return NULL;
    t->map = pango_cairo_font_map_new();
    t->context = pango_font_map_create_context(t->map);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(t->context, options);
    cairo_font_options_destroy(options);
    return t;
}

static void texts_destroy(texts *t) {
    if (!t)
        return;
    g_object_unref(t->context);
    g_object_unref(t->map);
    free(t);
}

static PangoLayout *layout_new(const kg_book *paper, const kg_text *style, double width,
                               const char *text) {
    PangoLayout *layout = pango_layout_new(((texts *)paper->texts)->context);
    PangoFontDescription *font = pango_font_description_from_string(KG_TEXT_FAMILIES);
    pango_font_description_set_absolute_size(font, style->size / GRID * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    pango_layout_set_text(layout, text, -1);
    pango_layout_set_alignment(layout, style->align == KG_ALIGN_CENTER ? PANGO_ALIGN_CENTER
                                                                       : PANGO_ALIGN_LEFT);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    if (width > 0)
        pango_layout_set_width(layout, (int)(width / GRID * PANGO_SCALE));
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    if (style->lines > 0) {
        pango_layout_set_height(layout, -style->lines);
        pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    }
    return layout;
}

static kg_vec2 size_of(PangoLayout *layout) {
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    return kg_v2(logical.width * GRID / PANGO_SCALE, logical.height * GRID / PANGO_SCALE);
}

double kg_book_text_height(const kg_book *paper, const kg_text *style, double width,
                           const char *text) {
    PangoLayout *layout = layout_new(paper, style, width, text);
    double height = size_of(layout).y;
    g_object_unref(layout);
    return height;
}

double kg_book_text(kg_book *paper, const kg_text *style, double x, double y, double width,
                    const char *text) {
    PangoLayout *layout = layout_new(paper, style, width, text);
    double height = size_of(layout).y;
    kg_book_color(paper, style->color);
    cairo_save(paper->cr);
    cairo_translate(paper->cr, x, y);
    cairo_scale(paper->cr, GRID, GRID);
    cairo_move_to(paper->cr, 0, 0);
    pango_cairo_show_layout(paper->cr, layout);
    cairo_restore(paper->cr);
    cairo_new_path(paper->cr);
    g_object_unref(layout);
    return height;
}

void kg_book_write(kg_book *paper, const kg_text *style, const char *text) {
    double width = kg_book_width(paper);
    kg_book_need(paper, kg_book_text_height(paper, style, width, text));
    paper->y += kg_book_text(paper, style, KG_BOOK_MARGIN, paper->y, width, text);
}

/* ---- pages ------------------------------------------------------------------------------ */

static cairo_status_t collect(void *bytes, const unsigned char *data, unsigned int size) {
    kg_bytes_add(bytes, data, size);
    return ((kg_bytes *)bytes)->failed ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static bool has_font(const kg_book *paper) {
    PangoLayout *layout = layout_new(paper, &(kg_text){.size = KG_BOOK_TEXT}, 0, "0");
    bool found = pango_layout_get_unknown_glyphs_count(layout) == 0;
    g_object_unref(layout);
    return found;
}

kg_status kg_book_create(kg_vec2 size, const char *title, const char *footer, kg_book **out_paper,
                         kg_error *error) {
    kg_book *paper = calloc(1, sizeof *paper);
    if (paper) {
        paper->texts = texts_create();
        paper->footer = strdup(footer);
    }
    if (!paper || !paper->texts || !paper->footer) {
        kg_book_destroy(paper);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    if (!has_font(paper)) {
        kg_book_destroy(paper);
        return kg_fail(error, KG_ERR_SYSTEM,
                       "there is no font for the guide's text: install fonts-ipaexfont-gothic");
    }
    cairo_surface_t *surface =
        cairo_pdf_surface_create_for_stream(collect, &paper->bytes, size.x * POINT, size.y * POINT);
    /* A date would make every file differ. */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, NULL);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "katagami");
    paper->cr = cairo_create(surface);
    cairo_surface_destroy(surface);
    cairo_scale(paper->cr, POINT, POINT);
    cairo_set_line_join(paper->cr, CAIRO_LINE_JOIN_ROUND);
    paper->size = size;
    paper->page = 1;
    paper->y = KG_BOOK_MARGIN;
    *out_paper = paper;
    return KG_OK;
}

void kg_book_destroy(kg_book *paper) {
    if (!paper)
        return;
    if (paper->cr)
        cairo_destroy(paper->cr);
    texts_destroy(paper->texts);
    free(paper->footer);
    kg_bytes_clear(&paper->bytes);
    free(paper);
}

static void show_page(kg_book *paper) {
    char number[32];
    snprintf(number, sizeof number, "%d", paper->page);
    double y = paper->size.y - KG_BOOK_MARGIN + 2, width = kg_book_width(paper);
    kg_text style = {KG_BOOK_SMALL, KG_FAINT_INK, KG_ALIGN_LEFT, 1};
    kg_book_text(paper, &style, KG_BOOK_MARGIN, y, width - 20, paper->footer);
    style.align = KG_ALIGN_CENTER;
    kg_book_text(paper, &style, KG_BOOK_MARGIN + width - 20, y, 20, number);
    cairo_show_page(paper->cr);
}

void kg_book_turn(kg_book *paper) {
    show_page(paper);
    paper->page++;
    paper->y = KG_BOOK_MARGIN;
}

void kg_book_need(kg_book *paper, double height) {
    if (paper->y + height > kg_book_bottom(paper) && paper->y > KG_BOOK_MARGIN)
        kg_book_turn(paper);
}

kg_status kg_book_finish(kg_book *paper, kg_error *error) {
    show_page(paper);
    cairo_surface_t *surface = cairo_surface_reference(cairo_get_target(paper->cr));
    cairo_status_t status = cairo_status(paper->cr);
    cairo_destroy(paper->cr);
    paper->cr = NULL;
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS || paper->bytes.failed)
        return kg_fail(error, KG_ERR_MEMORY, "cannot write the guide: %s",
                       cairo_status_to_string(status));
    return KG_OK;
}

double kg_book_width(const kg_book *paper) {
    return paper->size.x - 2 * KG_BOOK_MARGIN;
}

double kg_book_bottom(const kg_book *paper) {
    return paper->size.y - KG_BOOK_MARGIN;
}

/* ---- drawing ---------------------------------------------------------------------------- */

void kg_book_color(kg_book *paper, uint32_t color) {
    cairo_set_source_rgb(paper->cr, (color >> 16 & 255) / 255.0, (color >> 8 & 255) / 255.0,
                         (color & 255) / 255.0);
}

kg_status kg_book_image(kg_book *paper, const kg_image *image, double x, double y, double width,
                        kg_error *error) {
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, image->width, image->height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(surface);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    unsigned char *rows = cairo_image_surface_get_data(surface);
    int stride = cairo_image_surface_get_stride(surface);
    const uint8_t *in = image->pixels;
    for (int row = 0; row < image->height; row++)
        for (int column = 0; column < image->width; column++, in += 4) {
            uint32_t rgb = (uint32_t)in[0] << 16 | (uint32_t)in[1] << 8 | in[2];
            memcpy(rows + (ptrdiff_t)row * stride + 4 * column, &rgb, sizeof rgb);
        }
    cairo_surface_mark_dirty(surface);
    cairo_save(paper->cr);
    cairo_translate(paper->cr, x, y);
    cairo_scale(paper->cr, width / image->width, width / image->width);
    cairo_set_source_surface(paper->cr, surface, 0, 0);
    cairo_paint(paper->cr);
    cairo_restore(paper->cr);
    cairo_surface_destroy(surface);
    return KG_OK;
}

static const kg_text badge_text = {3.2, KG_INK, KG_ALIGN_LEFT, 0};

kg_vec2 kg_book_badge_half(int number) {
    int digits = number < 10 ? 1 : number < 100 ? 2 : 3;
    return kg_v2(1.5 + 1.0 * digits, 2.4);
}

/* The digits alone, centred. */
static void badge_number(kg_book *paper, double x, double y, int number, uint32_t color) {
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    kg_text style = badge_text;
    style.color = color;
    PangoLayout *layout = layout_new(paper, &style, 0, text);
    kg_vec2 size = size_of(layout);
    g_object_unref(layout);
    kg_book_text(paper, &style, x - size.x / 2, y - size.y / 2, 0, text);
}

void kg_book_join_badge(kg_book *paper, double x, double y, int number) {
    kg_vec2 half = kg_book_badge_half(number);
    cairo_new_path(paper->cr);
    cairo_arc(paper->cr, x - half.x + half.y, y, half.y, KG_PI / 2, 3 * KG_PI / 2);
    cairo_arc(paper->cr, x + half.x - half.y, y, half.y, -KG_PI / 2, KG_PI / 2);
    cairo_close_path(paper->cr);
    kg_book_color(paper, 0xffffff);
    cairo_fill_preserve(paper->cr);
    kg_book_color(paper, 0xc2185b);
    cairo_set_line_width(paper->cr, 0.45);
    cairo_stroke(paper->cr);
    badge_number(paper, x, y, number, 0xc2185b);
}

void kg_book_part_badge(kg_book *paper, double x, double y, int number, uint32_t color) {
    kg_vec2 half = kg_book_badge_half(number);
    cairo_rectangle(paper->cr, x - half.x, y - half.y, 2 * half.x, 2 * half.y);
    kg_book_color(paper, color);
    cairo_fill_preserve(paper->cr);
    kg_book_color(paper, KG_INK);
    cairo_set_line_width(paper->cr, 0.25);
    cairo_stroke(paper->cr);
    badge_number(paper, x, y, number, KG_INK);
}
