/* One function per format: a drawing to the bytes of its file or files. */
#ifndef KG_NET_WRITERS_H
#define KG_NET_WRITERS_H

#include "net/bytes.h"
#include "net/drawing.h"

/* Layers a file holds, one bit per kg_net_layer. */
typedef unsigned kg_layers;
#define KG_LAYERS_ALL ((1u << KG_LAYER_COUNT) - 1)

/* One page as SVG. Errors: KG_ERR_MEMORY. */
kg_status kg_svg_page(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                      kg_error *error) KG_CHECKED;

/* All pages as one PDF; `page` is not looked at. Without fonts the drawing's captions become
 * strokes. Errors: KG_ERR_MEMORY. */
kg_status kg_pdf_pages(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                       kg_error *error) KG_CHECKED;

/* One page as DXF of AutoCAD 2000. Errors: KG_ERR_MEMORY. */
kg_status kg_dxf_page(kg_drawing *drawing, size_t page, kg_layers layers, kg_bytes *out,
                      kg_error *error) KG_CHECKED;

#endif
