/* Captions through Pango, which finds fonts for every script: shown as text, or as outlines. */
#ifndef KG_NET_GLYPH_H
#define KG_NET_GLYPH_H

#include "net/drawing.h"

#include <cairo.h>

/* True when the machine has a font at all; Pango may end the program where there is none. */
bool kg_glyph_available(void);

/* Shows the caption on a cairo context whose unit is 1 mm with y down, in its current colour. */
void kg_glyph_show(cairo_t *cr, const kg_caption *caption);

/* Turns all captions of the drawing into filled strokes. Without any font numbers are drawn as
 * plain strokes and other characters are left out. Errors: KG_ERR_MEMORY. */
kg_status kg_glyph_outline(kg_drawing *drawing, kg_error *error) KG_CHECKED;

#endif
