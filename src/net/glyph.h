/* Captions through Pango, which finds fonts for every script: shown as text, or as outlines. */
#ifndef KG_NET_GLYPH_H
#define KG_NET_GLYPH_H

#include "net/drawing.h"

#include <cairo.h>

/* Pango with fontconfig behind it, which takes some 20 ms to start. */
typedef struct kg_glyphs kg_glyphs;

/* NULL when memory runs out. */
kg_glyphs *kg_glyphs_create(void);
void kg_glyphs_destroy(kg_glyphs *glyphs);

/* True when the machine has a font at all. */
bool kg_glyphs_available(const kg_glyphs *glyphs);

/* Shows the caption on a cairo context whose unit is 1 mm with y down, in its current colour. */
void kg_glyphs_show(const kg_glyphs *glyphs, cairo_t *cr, const kg_caption *caption);

/* Turns all captions of the drawing into filled strokes. Without any font numbers are drawn as
 * plain strokes and other characters are left out. Errors: KG_ERR_MEMORY. */
kg_status kg_glyphs_outline(const kg_glyphs *glyphs, kg_drawing *drawing,
                            kg_error *error) KG_CHECKED;

#endif
