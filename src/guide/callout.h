/* Numbers and arrows over a picture: joins in rings, parts in boxes, where the new part goes. */
#ifndef KG_GUIDE_CALLOUT_H
#define KG_GUIDE_CALLOUT_H

#include "guide/guide.h"

/* Draws the callouts of a view whose picture has its upper left corner at `at` and `size` mm. */
void kg_callouts_draw(kg_guide *guide, const kg_view_of *view, const kg_sight *sight,
                      const kg_camera *camera, kg_vec2 at, kg_vec2 size);

#endif
