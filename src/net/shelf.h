/*
 * Parts on pages in rows: each part is turned to its smallest bounding box, lying; the parts go
 * from the highest to the lowest into rows from left to right, and a row goes to the first page
 * with room for it.
 */
#ifndef KG_NET_SHELF_H
#define KG_NET_SHELF_H

#include "net/sheet.h"

/* Sets the layout's placements and page_count, and page_size of an endless sheet. Errors:
 * KG_ERR_INPUT (a part larger than the page), KG_ERR_MEMORY. */
kg_status kg_shelf_place(const kg_net *net, const kg_net_options *options, const kg_sheet *sheet,
                         kg_net_layout *layout, kg_error *error) KG_CHECKED;

#endif
