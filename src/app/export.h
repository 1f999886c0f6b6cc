/* Writing nets and meshes of what is being edited, from copies solved as finely as is wanted. */
#ifndef KG_APP_EXPORT_H
#define KG_APP_EXPORT_H

#include "app/editor.h"

/* Writes what the name's ending says: .svg .pdf .dxf a net with the model's settings, .obj .ply
 * .stl .off .gltf .glb a mesh. */
kg_status kg_export_file(const kg_editor *editor, const char *path, kg_error *error) KG_CHECKED;

/* The net of a document (solved here) to pages. */
kg_status kg_export_net(kg_document *document, const kg_net_options *options, double tab_width,
                        const char *path, const kg_progress *progress, kg_error *error) KG_CHECKED;

#endif
