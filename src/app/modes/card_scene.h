/* The picture of a pop-up card: its paper, its folds by kind, what is wrong with it; see kg_mode.
 */
#ifndef KG_APP_MODES_CARD_SCENE_H
#define KG_APP_MODES_CARD_SCENE_H

#include "app/editor.h"
#include "app/modes/card_frame.h"
#include "app/overlay.h"

kg_status kg_card_scene_compose(void **cache, const kg_editor *editor, kg_overlay *overlay,
                                kg_error *error) KG_CHECKED;
void kg_card_scene_drop(void *cache);
/* Bounds of the card as it stands; of the selection: the remark shown, else the selected box, else
 * nothing. */
kg_box3 kg_card_scene_box(const kg_editor *editor, bool selection);

/* How lines of a kind are drawn, here and in the legend. */
kg_style kg_card_line_style(kg_card_line line, bool dark);

#endif
