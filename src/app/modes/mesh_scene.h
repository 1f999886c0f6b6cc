/* The picture of a document as the mesh it exports; see kg_mode. */
#ifndef KG_APP_MODES_MESH_SCENE_H
#define KG_APP_MODES_MESH_SCENE_H

#include "app/editor.h"
#include "app/overlay.h"

kg_status kg_mesh_scene_compose(void **cache, const kg_editor *editor, kg_overlay *overlay,
                                kg_error *error) KG_CHECKED;
void kg_mesh_scene_drop(void *cache);
kg_box3 kg_mesh_scene_box(const kg_editor *editor, bool selection);

#endif
