/*
 * Where patches meet, lit in the model and in the net at once: editor->hover_seam names the two,
 * whichever view the pointer is in, and a place of theirs which of their seams is meant.
 */
#ifndef KG_APP_TOOLS_SEAM_H
#define KG_APP_TOOLS_SEAM_H

#include "app/editor.h"
#include "app/overlay.h"

/* Notes the cut edge under a pixel of the 3D view, and one of its patches as hovered; without one
 * only forgets the seam. */
void kg_seam_hover(kg_editor *editor, kg_vec2 px);
/* Whether two patches are the pair whose seam is hovered. It counts only while one of them is. */
bool kg_seam_is_hovered(const kg_editor *editor, int64_t a, int64_t b);
void kg_seam_draw(const kg_editor *editor, kg_overlay *overlay);

#endif
