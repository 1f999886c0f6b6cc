/* Handles at the selection: arrows that move, rings that turn, a square that scales. */
#ifndef KG_APP_TOOLS_GIZMO_H
#define KG_APP_TOOLS_GIZMO_H

#include "app/editor.h"
#include "app/tools/tools.h"

typedef struct kg_gizmo_handle {
    bool any;
    kg_transform_kind kind;
    int axis; /* 0 x, 1 y, 2 z; -1: none */
} kg_gizmo_handle;

/* Shown for selected patches at their level, and for several selected points. */
kg_gizmo_handle kg_gizmo_under(const kg_editor *editor, kg_vec2 px);
/* Draws onto the canvas of the widgets. */
void kg_gizmo_draw(const kg_editor *editor);

#endif
