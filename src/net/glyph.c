#include "net/glyph.h"

#include "net/text.h"

#include <pango/pangocairo.h>
#include <stdlib.h>
#include <string.h>

/* Size in which glyphs are laid out before they are scaled to millimetres: cairo keeps paths in
 * steps of 1/256, and no hinting shall show. */
#define DESIGN_SIZE 256.0

/* A font map of its own, so that nothing is left in Pango's for the thread. */
struct kg_glyphs {
    PangoFontMap *map;
    PangoContext *context;
};

kg_glyphs *kg_glyphs_create(void) {
    kg_glyphs *glyphs = calloc(1, sizeof *glyphs);
    if (!glyphs)
        return NULL;
    glyphs->map = pango_cairo_font_map_new();
    glyphs->context = pango_font_map_create_context(glyphs->map);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(glyphs->context, options);
    cairo_font_options_destroy(options);
    PangoFontDescription *font = pango_font_description_from_string(KG_TEXT_FAMILIES);
    pango_font_description_set_absolute_size(font, DESIGN_SIZE * PANGO_SCALE);
    pango_context_set_font_description(glyphs->context, font);
    pango_font_description_free(font);
    return glyphs;
}

void kg_glyphs_destroy(kg_glyphs *glyphs) {
    if (!glyphs)
        return;
    g_object_unref(glyphs->context);
    g_object_unref(glyphs->map);
    free(glyphs);
}

static PangoLayout *layout_new(const kg_glyphs *glyphs, const char *text) {
    PangoLayout *layout = pango_layout_new(glyphs->context);
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    pango_layout_set_text(layout, text, -1);
    return layout;
}

/* Without fonts Pango draws boxes, so it is asked whether a digit would be one. */
bool kg_glyphs_available(const kg_glyphs *glyphs) {
    PangoLayout *layout = layout_new(glyphs, "0");
    bool available = pango_layout_get_unknown_glyphs_count(layout) == 0;
    g_object_unref(layout);
    return available;
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
    cairo_translate(cr, -width * kg_caption_share(caption), 0);
}

void kg_glyphs_show(const kg_glyphs *glyphs, cairo_t *cr, const kg_caption *caption) {
    PangoLayout *layout = layout_new(glyphs, caption->text);
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
static bool outline_glyphs(const kg_glyphs *glyphs, cairo_t *cr, const kg_caption *caption,
                           kg_path *path) {
    PangoLayout *layout = layout_new(glyphs, caption->text);
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
                p[e] = kg_add2(caption->center, kg_v2(c * x - s * y, s * x + c * y));
            }
            if (!kg_path_move(path, p[0]) || !kg_path_line(path, p[1]))
                return false;
        }
    }
    return true;
}

/* `glyphs` NULL: there is no font. */
static bool outline_caption(const kg_glyphs *glyphs, cairo_t *cr, kg_page *page,
                            const kg_caption *caption) {
    kg_stroke *stroke = kg_page_stroke(page, caption->layer, NULL);
    if (!stroke)
        return false;
    stroke->part = caption->part;
    stroke->source = caption->source;
    stroke->filled = glyphs != NULL;
    bool done = glyphs ? outline_glyphs(glyphs, cr, caption, &stroke->path)
                       : outline_digits(caption, &stroke->path);
    if (done && stroke->path.count == 0)
        page->strokes.count--; /* blanks, or nothing that digits can say */
    return done;
}

static bool outline_page(const kg_glyphs *glyphs, cairo_t *cr, kg_page *page) {
    for (size_t k = 0; k < page->captions.count; k++)
        if (!outline_caption(glyphs, cr, page, &page->captions.items[k]))
            return false;
    for (size_t k = 0; k < page->captions.count; k++)
        free(page->captions.items[k].text);
    page->captions.count = 0;
    return true;
}

kg_status kg_glyphs_outline(const kg_glyphs *glyphs, kg_drawing *drawing, kg_error *error) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cr = cairo_create(surface);
    cairo_set_tolerance(cr, 0.01);
    bool done = cairo_status(cr) == CAIRO_STATUS_SUCCESS;
    const kg_glyphs *fonts = kg_glyphs_available(glyphs) ? glyphs : NULL;
    for (size_t i = 0; done && i < drawing->page_count; i++)
        done = outline_page(fonts, cr, &drawing->pages[i]);
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    return done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory while outlining text");
}
