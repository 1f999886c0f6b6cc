/* Pictures on buttons, drawn with lines so that they are sharp at every scale. */
#ifndef KG_APP_ICONS_H
#define KG_APP_ICONS_H

#include "app/ui/ui.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws into the current canvas; `area` is a square. */
void kg_icon_draw(kg_icon icon, kg_area area, kg_color color);

#ifdef __cplusplus
}
#endif
#endif
