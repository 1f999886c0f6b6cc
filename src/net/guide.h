/* What is on a page besides parts: frame, page number, 50 mm scale bar, registration marks. */
#ifndef KG_NET_GUIDE_H
#define KG_NET_GUIDE_H

#include "net/drawing.h"

/* Errors: KG_ERR_MEMORY, KG_ERR_INPUT (options). */
kg_status kg_guide_draw(kg_drawing *drawing, const kg_net_options *options,
                        kg_error *error) KG_CHECKED;

#endif
