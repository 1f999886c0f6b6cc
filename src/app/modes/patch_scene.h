/* The picture of a patch model; see kg_mode. */
#ifndef KG_APP_MODES_PATCH_SCENE_H
#define KG_APP_MODES_PATCH_SCENE_H

#include "app/editor.h"
#include "app/overlay.h"

kg_status kg_patch_scene_compose(void **cache, const kg_editor *editor, kg_overlay *overlay,
                                 kg_error *error) KG_CHECKED;
void kg_patch_scene_drop(void *cache);

/* The whole rectangle of a patch, which cuts others even where the patch itself is trimmed away. */
void kg_patch_rectangle_draw(kg_overlay *overlay, const kg_patch *patch, kg_color color);

#endif
