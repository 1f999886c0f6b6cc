/*
 * katagami: polygon meshes, read as references and written as exports.
 */
#ifndef KATAGAMI_MESH_H
#define KATAGAMI_MESH_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A named run of faces (one per patch on export). */
typedef struct kg_mesh_group {
    char *name;            /* UTF-8 */
    size_t first_face, face_count;
    float color[4];        /* linear RGBA in [0,1] */
} kg_mesh_group;

/* Any set of polygons: open, non-manifold, several components, 3 corners or more. Face f has the
 * corners face_corners[face_starts[f]] … face_corners[face_starts[f + 1] - 1], indices of
 * positions. */
typedef struct kg_mesh {
    size_t vertex_count;
    kg_vec3 *positions;
    kg_vec3 *normals; /* per vertex, unit, or NULL */
    size_t face_count;
    uint32_t *face_starts; /* face_count + 1 */
    uint32_t *face_corners;
    size_t group_count;
    kg_mesh_group *groups; /* may be NULL */
} kg_mesh;

KG_API kg_mesh *kg_mesh_create(void);
KG_API void kg_mesh_destroy(kg_mesh *mesh);

#ifdef __cplusplus
}
#endif
#endif
