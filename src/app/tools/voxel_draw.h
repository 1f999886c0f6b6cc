/* What the voxel tool shows: boxes of voxels, the active plane. */
#ifndef KG_APP_TOOLS_VOXEL_DRAW_H
#define KG_APP_TOOLS_VOXEL_DRAW_H

#include "app/modes/card_state.h"
#include "app/overlay.h"

typedef enum kg_voxel_look { KG_VOXEL_ADDED, KG_VOXEL_REMOVED, KG_VOXEL_SELECTED } kg_voxel_look;

void kg_voxel_draw_box(const kg_editor *editor, kg_overlay *overlay, const kg_spots *box,
                       kg_voxel_look look);
/* The plane through the cursor in which keys and strokes move, as a grid. */
void kg_voxel_draw_plane(const kg_editor *editor, kg_overlay *overlay);

#endif
