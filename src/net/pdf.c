#include "net/writers.h"

#include "net/glyph.h"

#include <cairo-pdf.h>

static const double POINT = 72 / 25.4; /* points in a millimetre */

static cairo_status_t collect(void *bytes, const unsigned char *data, unsigned int size) {
    kg_bytes_add(bytes, data, size);
    return ((kg_bytes *)bytes)->failed ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static void trace(cairo_t *cr, const kg_path *path) {
    for (size_t i = 0; i < path->count; i++) {
        const kg_vec2 *p = path->items[i].p;
        switch (path->items[i].verb) {
        case KG_PATH_MOVE:
            cairo_move_to(cr, p[0].x, p[0].y);
            break;
        case KG_PATH_LINE:
            cairo_line_to(cr, p[0].x, p[0].y);
            break;
        case KG_PATH_CURVE:
            cairo_curve_to(cr, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
            break;
        case KG_PATH_CLOSE:
            cairo_close_path(cr);
            break;
        }
    }
}

static void set_color(cairo_t *cr, uint32_t color) {
    cairo_set_source_rgb(cr, (color >> 16 & 255) / 255.0, (color >> 8 & 255) / 255.0,
                         (color & 255) / 255.0);
}

static void show_stroke(cairo_t *cr, const kg_drawing *drawing, const kg_stroke *stroke) {
    const kg_net_style *style = &drawing->styles[stroke->layer];
    const double *dashes = NULL;
    int count = stroke->dashed ? kg_layer_dashes(stroke->layer, &dashes) : 0;
    set_color(cr, style->color);
    trace(cr, &stroke->path);
    if (stroke->filled) {
        cairo_fill(cr);
        return;
    }
    cairo_set_line_width(cr, style->width);
    cairo_set_dash(cr, dashes, count, 0);
    cairo_stroke(cr);
}

static void show_page(cairo_t *cr, const kg_glyphs *glyphs, const kg_drawing *drawing,
                      const kg_page *page, kg_layers layers) {
    for (size_t i = 0; i < page->strokes.count; i++)
        if (layers & 1u << page->strokes.items[i].layer)
            show_stroke(cr, drawing, &page->strokes.items[i]);
    for (size_t i = 0; i < page->captions.count; i++) {
        const kg_caption *caption = &page->captions.items[i];
        if (!(layers & 1u << caption->layer))
            continue;
        set_color(cr, drawing->styles[caption->layer].color);
        kg_glyphs_show(glyphs, cr, caption);
    }
}

static kg_status write_pages(const kg_glyphs *glyphs, const kg_drawing *drawing, kg_layers layers,
                             kg_bytes *out, kg_error *error) {
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(
        collect, out, drawing->size.x * POINT, drawing->size.y * POINT);
    /* A date would make every file differ. */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, NULL);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, drawing->title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "katagami");
    cairo_t *cr = cairo_create(surface);
    cairo_scale(cr, POINT, POINT);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; i < drawing->page_count; i++) {
        show_page(cr, glyphs, drawing, &drawing->pages[i], layers);
        cairo_show_page(cr);
    }
    cairo_status_t status = cairo_status(cr);
    cairo_destroy(cr);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (status != CAIRO_STATUS_SUCCESS)
        return kg_fail(error, KG_ERR_MEMORY, "cannot write PDF: %s",
                       cairo_status_to_string(status));
    return KG_OK;
}

kg_status kg_pdf_pages(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                       kg_error *error) {
    (void)page;
    kg_glyphs *glyphs = kg_glyphs_create();
    if (!glyphs)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while writing PDF");
    kg_status status = KG_OK;
    if (!kg_glyphs_available(glyphs))
        status = kg_glyphs_outline(glyphs, drawing, error);
    if (status == KG_OK)
        status = write_pages(glyphs, drawing, layers, out, error);
    kg_glyphs_destroy(glyphs);
    return status;
}
