/* Writing nets and meshes of what is being edited, from copies solved as finely as is wanted. */
#ifndef KG_APP_EXPORT_H
#define KG_APP_EXPORT_H

#include "app/editor.h"

/* Whether a file name ends as nets do. */
bool kg_export_is_net(const char *path);

/* A copy to be written, folded as it is shown where the file can tell only one pose. */
kg_status kg_export_copy(const kg_editor *editor, const char *path, kg_document **out_copy,
                         kg_error *error) KG_CHECKED;

/* Writes what the name's ending says: .svg .pdf .dxf a net with the model's settings, .obj .ply
 * .stl .off .gltf .glb a mesh, .fold .cp a crease pattern. */
kg_status kg_export_file(const kg_editor *editor, const char *path, kg_error *error) KG_CHECKED;

/* The net of a document (solved here) to pages. */
kg_status kg_export_net(kg_document *document, const kg_net_options *options, double tab_width,
                        const char *path, const kg_progress *progress, kg_error *error) KG_CHECKED;

/* How a document (solved here) is built or folded, as a PDF. */
kg_status kg_export_guide(kg_document *document, const char *path, const kg_progress *progress,
                          kg_error *error) KG_CHECKED;
/* Its surface or its crease pattern. */
kg_status kg_export_mesh(kg_document *document, const char *path, kg_error *error) KG_CHECKED;

#endif
