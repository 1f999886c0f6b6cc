#include "net/glyph.h"

#include "net/text.h"

#include <pango/pangocairo.h>
#include <stdlib.h>
#include <string.h>

/* Size in which glyphs are laid out before they are scaled to millimetres: cairo keeps paths in
 * steps of 1/256, and no hinting shall show. */
#define DESIGN_SIZE 256.0

bool kg_glyph_available(void) {
    PangoFontFamily **families = NULL;
    int count = 0;
    pango_font_map_list_families(pango_cairo_font_map_get_default(), &families, &count);
    g_free(families);
    return count > 0;
}

static PangoLayout *layout_new(cairo_t *cr, const char *text) {
    PangoLayout *layout = pango_cairo_create_layout(cr);
    PangoFontDescription *font = pango_font_description_from_string(KG_TEXT_FAMILIES);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(pango_layout_get_context(layout), options);
    cairo_font_options_destroy(options);
    pango_font_description_set_absolute_size(font, DESIGN_SIZE * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    pango_layout_set_text(layout, text, -1);
    return layout;
}

/* Moves the origin to where the line's baseline begins, scaled so that the line keeps within the
 * caption's box even where a font is wider than the table of widths supposes. */
static void line_place(cairo_t *cr, PangoLayoutLine *line, const kg_caption *caption) {
    PangoRectangle logical;
    pango_layout_line_get_extents(line, NULL, &logical);
    double width = (double)logical.width / PANGO_SCALE;
    double scale = caption->capital / KG_TEXT_CAPITAL / DESIGN_SIZE;
    double room = 2 * kg_caption_half(caption).x;
    if (width * scale > room)
        scale = room / width;
    kg_vec2 base = kg_caption_baseline(caption);
    cairo_translate(cr, base.x, base.y);
    cairo_rotate(cr, caption->angle);
    cairo_scale(cr, scale, scale);
    cairo_translate(cr, -width / 2, 0);
}

void kg_glyph_show(cairo_t *cr, const kg_caption *caption) {
    PangoLayout *layout = layout_new(cr, caption->text);
    PangoLayoutLine *line = pango_layout_get_line_readonly(layout, 0);
    cairo_save(cr);
    line_place(cr, line, caption);
    cairo_move_to(cr, 0, 0);
    pango_cairo_show_layout_line(cr, line);
    cairo_restore(cr);
    g_object_unref(layout);
}

/* ---- outlines ----------------------------------------------------------------------------------
 */

static bool copy_path(cairo_t *cr, const cairo_path_t *from, kg_path *to) {
    bool done = true;
    for (int i = 0; done && i < from->num_data; i += from->data[i].header.length) {
        const cairo_path_data_t *d = &from->data[i];
        kg_vec2 p[3] = {{0, 0}};
        for (int k = 1; k < d->header.length; k++) {
            double x = d[k].point.x, y = d[k].point.y;
            cairo_user_to_device(cr, &x, &y);
            p[k - 1] = kg_v2(x, y);
        }
        switch (d->header.type) {
        case CAIRO_PATH_MOVE_TO:
            /* cairo ends every closed path with a move of no use. */
            done = i + d->header.length >= from->num_data || kg_path_move(to, p[0]);
            break;
        case CAIRO_PATH_LINE_TO:
            done = kg_path_line(to, p[0]);
            break;
        case CAIRO_PATH_CURVE_TO:
            done = kg_path_curve(to, p[0], p[1], p[2]);
            break;
        case CAIRO_PATH_CLOSE_PATH:
            done = kg_path_close(to);
            break;
        }
    }
    return done;
}

/* The path is taken in the glyphs' own size and mapped afterwards, exactly, by the matrix. */
static bool outline_glyphs(cairo_t *cr, const kg_caption *caption, kg_path *path) {
    PangoLayout *layout = layout_new(cr, caption->text);
    PangoLayoutLine *line = pango_layout_get_line_readonly(layout, 0);
    cairo_new_path(cr);
    cairo_move_to(cr, 0, 0);
    pango_cairo_layout_line_path(cr, line);
    cairo_path_t *outline = cairo_copy_path(cr);
    cairo_save(cr);
    line_place(cr, line, caption);
    bool done = outline->status == CAIRO_STATUS_SUCCESS && copy_path(cr, outline, path);
    cairo_restore(cr);
    cairo_path_destroy(outline);
    g_object_unref(layout);
    return done;
}

/* Digits of seven bars in a box one wide and two high, y down: bits from the top bar round to the
 * upper left, then the middle. */
static bool outline_digits(const kg_caption *caption, kg_path *path) {
    static const unsigned char bars[10] = {63, 6, 91, 79, 102, 109, 125, 7, 127, 111};
    static const double ends[7][4] = {{0, 0, 1, 0}, {1, 0, 1, 1}, {1, 1, 1, 2}, {0, 2, 1, 2},
                                      {0, 1, 0, 2}, {0, 0, 0, 1}, {0, 1, 1, 1}};
    double unit = caption->capital / 2, c = cos(caption->angle), s = sin(caption->angle);
    size_t count = strspn(caption->text, "0123456789");
    for (size_t i = 0; i < count; i++) {
        double left = 1.6 * ((double)i - (double)count / 2) + 0.3;
        for (int k = 0; k < 7; k++) {
            if (!(bars[caption->text[i] - '0'] & 1 << k))
                continue;
            kg_vec2 p[2];
            for (int e = 0; e < 2; e++) {
                double x = (left + ends[k][2 * e]) * unit, y = (ends[k][2 * e + 1] - 1) * unit;
                p[e] = kg_add2(caption->centre, kg_v2(c * x - s * y, s * x + c * y));
            }
            if (!kg_path_move(path, p[0]) || !kg_path_line(path, p[1]))
                return false;
        }
    }
    return true;
}

static bool outline_caption(cairo_t *cr, kg_page *page, const kg_caption *caption) {
    kg_stroke *stroke = kg_page_stroke(page, caption->layer, NULL);
    if (!stroke)
        return false;
    stroke->part = caption->part;
    stroke->source = caption->source;
    stroke->filled = cr != NULL;
    bool done =
        cr ? outline_glyphs(cr, caption, &stroke->path) : outline_digits(caption, &stroke->path);
    if (done && stroke->path.count == 0)
        page->strokes.count--; /* blanks, or nothing that digits can say */
    return done;
}

kg_status kg_glyph_outline(kg_drawing *drawing, kg_error *error) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cr = cairo_create(surface);
    bool fonts = kg_glyph_available(), done = cairo_status(cr) == CAIRO_STATUS_SUCCESS;
    cairo_set_tolerance(cr, 0.01);
    for (size_t i = 0; done && i < drawing->page_count; i++) {
        kg_page *page = &drawing->pages[i];
        for (size_t k = 0; done && k < page->captions.count; k++)
            done = outline_caption(fonts ? cr : NULL, page, &page->captions.items[k]);
        for (size_t k = 0; done && k < page->captions.count; k++)
            free(page->captions.items[k].text);
        if (done)
            page->captions.count = 0;
    }
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    return done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory while outlining text");
}
