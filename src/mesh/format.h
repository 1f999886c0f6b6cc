/*
 * The readers and writers of the formats. Readers fill a builder and check what the builder
 * cannot: syntax, sizes that a header promises. Writers get a mesh that kg_mesh_check accepts.
 * Both run under the C locale.
 */
#ifndef KG_MESH_FORMAT_H
#define KG_MESH_FORMAT_H

#include "mesh/builder.h"
#include "mesh/bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

kg_status kg_obj_read(const void *data, size_t size, kg_mesh_builder *b,
                      kg_error *error) KG_CHECKED;
kg_status kg_ply_read(const void *data, size_t size, kg_mesh_builder *b,
                      kg_error *error) KG_CHECKED;
kg_status kg_stl_read(const void *data, size_t size, kg_mesh_builder *b,
                      kg_error *error) KG_CHECKED;
kg_status kg_off_read(const void *data, size_t size, kg_mesh_builder *b,
                      kg_error *error) KG_CHECKED;

/* glTF text or GLB. `folder`, where the buffers that are files of their own are looked for, may be
 * NULL: then there are none. */
kg_status kg_gltf_read(const void *data, size_t size, const char *folder, kg_mesh_builder *b,
                       kg_error *error) KG_CHECKED;

void kg_obj_write(const kg_mesh *mesh, kg_bytes *out);
void kg_ply_write(const kg_mesh *mesh, kg_bytes *out);
void kg_off_write(const kg_mesh *mesh, kg_bytes *out);
/* `triangles` are those of kg_mesh_triangulate. */
void kg_stl_write(const kg_mesh *mesh, const uint32_t *triangles, kg_bytes *out);
/* `motion` may be NULL. */
kg_status kg_gltf_write(const kg_mesh *mesh, const uint32_t *triangles,
                        const kg_mesh_motion *motion, bool binary, kg_bytes *out,
                        kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
