/* Drawing the pages of a net onto the canvas. */
#ifndef KG_APP_PANELS_NET_DRAW_H
#define KG_APP_PANELS_NET_DRAW_H

#include "app/net_view.h"

void kg_net_draw_pages(const kg_net_view *view, const kg_editor *editor);

#endif
