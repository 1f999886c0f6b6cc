/* Small pictures of all steps, made when they are first shown and kept until a step is another. */
#ifndef KG_APP_MODES_SHEET_THUMBS_H
#define KG_APP_MODES_SHEET_THUMBS_H

#include "app/modes/sheet_state.h"
#include "app/scenery.h"

/* The picture of the sheets after `step` folds, for kg_ui_canvas_picture; 0: not there yet, ask
 * again in the next frame. Only a few are made in one frame. */
uint32_t kg_sheet_thumb(kg_sheets *sheets, kg_scenery *stage, size_t step, int width, int height);
/* Begins a frame; true: pictures were asked for that are not there yet. */
bool kg_sheet_thumbs_tick(kg_sheets *sheets);
/* The origami was changed: drops pictures of states that it no longer has. To be called while the
 * states before are still alive. */
void kg_sheet_thumbs_follow(kg_sheets *sheets);
void kg_sheet_thumbs_destroy(struct kg_sheet_thumbs *thumbs);

#endif
