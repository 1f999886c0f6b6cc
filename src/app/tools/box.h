/* Selecting by a box drawn in the 3D view. */
#ifndef KG_APP_TOOLS_BOX_H
#define KG_APP_TOOLS_BOX_H

#include "app/editor.h"

/* Points in the box of the patches that show theirs, at that level; else patches by what is seen of
 * them, their control points where nothing is. Drawn to the right, a box takes what lies wholly in
 * it, to the left also what it touches. `add`: to what is selected already. */
void kg_select_in_box(kg_editor *editor, kg_vec2 from, kg_vec2 to, bool add);

/* Whether such a box takes what it touches. */
static inline bool kg_box_touches(kg_vec2 from, kg_vec2 to) {
    return to.x < from.x;
}

#endif
