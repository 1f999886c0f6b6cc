/* Dragging the corners of contours drawn on a patch. */
#ifndef KG_APP_TOOLS_CORNER_H
#define KG_APP_TOOLS_CORNER_H

#include "app/editor.h"
#include "app/overlay.h"

typedef struct kg_corner {
    int64_t patch; /* 0: none */
    size_t trim, corner;
} kg_corner;

/* The corner under a pixel, of the only patch that is selected. */
kg_corner kg_corner_under(const kg_editor *editor, kg_vec2 px);
/* Within a step. The corner goes where the line of sight meets the patch's rectangle; where it
 * misses it stays. */
void kg_corner_move(kg_editor *editor, kg_corner corner, kg_vec2 px);
/* Adds a corner to the edge of a contour that lies under a pixel; patch 0: there is none. */
kg_corner kg_corner_insert(kg_editor *editor, kg_vec2 px);
/* Removes a corner; of a triangle's none can be spared. */
void kg_corner_remove(kg_editor *editor, kg_corner corner);
void kg_corners_draw(const kg_editor *editor, kg_overlay *overlay);

#endif
