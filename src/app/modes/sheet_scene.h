/* The picture of folded sheets; see kg_mode. */
#ifndef KG_APP_MODES_SHEET_SCENE_H
#define KG_APP_MODES_SHEET_SCENE_H

#include "app/modes/sheet_state.h"
#include "app/overlay.h"

kg_status kg_sheet_scene_compose(void **cache, const kg_editor *editor, kg_overlay *overlay,
                                 kg_error *error) KG_CHECKED;
void kg_sheet_scene_drop(void *cache);

/* The sheets alone, without marks and shadows, as items of a scene. Clear the overlay after use. */
void kg_sheet_scene_plain(const kg_sheets *sheets, kg_overlay *overlay);

#endif
