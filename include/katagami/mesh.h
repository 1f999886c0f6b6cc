/*
 * katagami: polygon meshes, read as references and written as exports.
 *
 * Positions are in the units of the file (mm once placed by kg_mesh_fit or kg_mesh_transform), z
 * up. glTF is y-up by definition and is turned, (x, y, z) -> (x, -z, y), when read and back when
 * written; every other format is taken as it is.
 */
#ifndef KATAGAMI_MESH_H
#define KATAGAMI_MESH_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A named run of faces (one per patch on export). */
typedef struct kg_mesh_group {
    char *name; /* UTF-8 */
    size_t first_face, face_count;
    float color[4]; /* linear RGBA in [0,1] */
} kg_mesh_group;

/* Any set of polygons: open, non-manifold, several components, 3 corners or more. Face f has the
 * corners face_corners[face_starts[f]] … face_corners[face_starts[f + 1] - 1], indices of
 * positions. */
typedef struct kg_mesh {
    size_t vertex_count;
    kg_vec3 *positions;
    kg_vec3 *normals; /* per vertex, unit, or NULL */
    size_t face_count;
    uint32_t *face_starts; /* face_count + 1; may be NULL without faces */
    uint32_t *face_corners;
    size_t group_count;
    kg_mesh_group *groups; /* may be NULL */
    size_t skipped_faces;  /* of the file it was read from: with fewer than 3 different corners, or
                            * with one of them twice */
} kg_mesh;

/* An empty mesh, or NULL when memory runs out. The arrays are malloc's: whoever fills them gives
 * them to the mesh, kg_mesh_destroy frees them (NULL is fine). */
KG_API kg_mesh *kg_mesh_create(void);
KG_API void kg_mesh_destroy(kg_mesh *mesh);

/* KG_ERR_INPUT with the first reason why `mesh` is not what the type says: faces of fewer than 3 or
 * of repeated corners, indices out of range, coordinates that are not finite, groups that are out
 * of order, overlap or have no name. Groups need not cover all faces. */
KG_API kg_status kg_mesh_check(const kg_mesh *mesh, kg_error *error) KG_CHECKED;

/* ---- files ----------------------------------------------------------------------------- */

typedef enum kg_mesh_format {
    KG_MESH_OBJ,
    KG_MESH_PLY,
    KG_MESH_STL,
    KG_MESH_OFF,
    KG_MESH_GLTF,
    KG_MESH_GLB
} kg_mesh_format;

/* The format a path's extension names, in any case; KG_ERR_INPUT for any other. */
KG_API kg_status kg_mesh_format_of(const char *path, kg_mesh_format *out_format,
                                   kg_error *error) KG_CHECKED;

/* Reads OBJ, PLY (text, binary of both byte orders), STL (text, binary; corners welded where
 * positions are equal), OFF (text), glTF and GLB (all scenes, node transforms applied, one group
 * per primitive). The mesh is taken as it is: polygons of any size, several components, open and
 * non-manifold ones. Normals are kept where every vertex has one and only one. Errors: KG_ERR_IO,
 * KG_ERR_PARSE (naming file and line) also for coordinates that are not finite numbers and for a
 * mesh without faces; KG_ERR_CANCELLED when `progress` says so. `progress` may be NULL. */
KG_API kg_status kg_mesh_read(const char *path, kg_mesh **out_mesh, kg_error *error) KG_CHECKED;
KG_API kg_status kg_mesh_read_reporting(const char *path, const kg_progress *progress,
                                        kg_mesh **out_mesh, kg_error *error) KG_CHECKED;

/* The same from memory; `name` stands for the file in messages. Other files that a glTF text names
 * are not opened. */
KG_API kg_status kg_mesh_read_memory(const void *data, size_t size, kg_mesh_format format,
                                     const char *name, kg_mesh **out_mesh,
                                     kg_error *error) KG_CHECKED;

/* Says how many faces of the file were skipped, and why; false, and an empty text, when none were.
 */
KG_API bool kg_mesh_say_skipped(const kg_mesh *mesh, const char *name, char *out_text, size_t size);

/* Writes the format that the path's extension names; the file appears whole or not at all.
 *   OBJ   one `g` line per group in order, `vn` when there are normals; spaces and control
 *         characters of names become `_`
 *   PLY   binary little endian, single precision, normals
 *   STL   binary, triangulated; group names do not exist in it
 *   OFF   text
 *   glTF  one mesh and node with a double-sided material per group, triangulated; the buffer is
 *         inside the file
 * Errors: KG_ERR_IO; KG_ERR_INPUT for a mesh that kg_mesh_check refuses or with coordinates beyond
 * single precision. */
KG_API kg_status kg_mesh_write(const char *path, const kg_mesh *mesh, kg_error *error) KG_CHECKED;

/* The same bytes in memory, to be freed with free(). */
KG_API kg_status kg_mesh_write_memory(const kg_mesh *mesh, kg_mesh_format format, char **out_data,
                                      size_t *out_size, kg_error *error) KG_CHECKED;

/* A mesh that moves: every vertex at its position plus the weighted sum of its displacements.
 * Weights change evenly between keys. */
typedef struct kg_mesh_motion {
    size_t target_count;
    kg_vec3 **displacements; /* per target: one for each vertex */
    size_t key_count;        /* at least 2 */
    double *times;           /* s, growing, from 0 */
    double *weights;         /* target_count for each key */
} kg_mesh_motion;

/* Arrays of the given sizes, all zero; NULL when memory runs out. Destroying NULL is fine. */
KG_API kg_mesh_motion *kg_mesh_motion_create(size_t target_count, size_t vertex_count,
                                             size_t key_count);
KG_API void kg_mesh_motion_destroy(kg_mesh_motion *motion);

/* Writes glTF or GLB with the motion as an animation of morph targets. Normals are left out, since
 * they would have to move as well: viewers shade flat. KG_ERR_INPUT for other formats, else as
 * kg_mesh_write. */
KG_API kg_status kg_mesh_write_moving(const char *path, const kg_mesh *mesh,
                                      const kg_mesh_motion *motion, kg_error *error) KG_CHECKED;

/* ---- shape ----------------------------------------------------------------------------- */

/* The box around all vertices that faces use (all vertices when there are no faces); empty for an
 * empty mesh. */
KG_API kg_box3 kg_mesh_bounds(const kg_mesh *mesh);

/* Applies a row-major affine 4×4 matrix (last row 0 0 0 1) to points and normals; a mirroring one
 * also reverses the corners of every face, so that fronts stay fronts. KG_ERR_INPUT, with the mesh
 * as it was, when the matrix is not affine or a result would not be finite. */
KG_API kg_status kg_mesh_transform(kg_mesh *mesh, const double matrix[16],
                                   kg_error *error) KG_CHECKED;

/* Scales and moves the mesh so that the longest side of its bounds is `size_mm` and their centre
 * the origin. KG_ERR_INPUT for a mesh that is a single point or a size that is not positive. */
KG_API kg_status kg_mesh_fit(kg_mesh *mesh, double size_mm, kg_error *error) KG_CHECKED;

/* Sets smooth vertex normals: the mean of the faces' normals weighted by area (the sum of their
 * Newell vectors). Vertices without area around them get +z. */
KG_API kg_status kg_mesh_normals(kg_mesh *mesh, kg_error *error) KG_CHECKED;

/* Adds a copy of `other` behind the vertices, faces and groups of `mesh`. Normals stay only when
 * both have them. */
KG_API kg_status kg_mesh_append(kg_mesh *mesh, const kg_mesh *other, kg_error *error) KG_CHECKED;

/* How many triangles kg_mesh_triangulate makes: n - 2 of every n-gon. */
KG_API size_t kg_mesh_triangle_count(const kg_mesh *mesh);

/* Cuts every face into triangles of its own corners and orientation by ear clipping (Meisters 1975)
 * in the plane that its Newell normal is closest to; concave faces come out right, self-crossing
 * and degenerate ones as some n - 2 triangles. `out_corners` holds 3 vertex indices per triangle,
 * `out_faces` (may be NULL) the face of each. Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_mesh_triangulate(const kg_mesh *mesh, uint32_t *out_corners,
                                     uint32_t *out_faces, kg_error *error) KG_CHECKED;

/* ---- questions ------------------------------------------------------------------------- */

/* Rays and closest points on the triangles of a mesh, found by a tree. It keeps its own copy. */
typedef struct kg_mesh_query kg_mesh_query;

typedef struct kg_mesh_hit {
    double distance; /* mm, from the origin of the ray or the asked point */
    size_t face;
    kg_vec3 point;
    kg_vec3 normal; /* unit, of the triangle hit, on the front side of its face; 0 without area */
} kg_mesh_hit;

/* `progress` may be NULL. KG_ERR_INPUT without faces, KG_ERR_MEMORY, KG_ERR_CANCELLED. */
KG_API kg_status kg_mesh_query_create(const kg_mesh *mesh, const kg_progress *progress,
                                      kg_mesh_query **out_query, kg_error *error) KG_CHECKED;
KG_API void kg_mesh_query_destroy(kg_mesh_query *query);

/* The first point of the mesh, from either side, on the ray from `origin` along `direction` (any
 * length but zero); false when there is none. May be called from several threads at once. */
KG_API bool kg_mesh_query_ray(const kg_mesh_query *query, kg_vec3 origin, kg_vec3 direction,
                              kg_mesh_hit *out_hit);

/* The point of the mesh nearest to `point`; false only for a point that is not finite. May be
 * called from several threads at once. */
KG_API bool kg_mesh_query_closest(const kg_mesh_query *query, kg_vec3 point, kg_mesh_hit *out_hit);

#ifdef __cplusplus
}
#endif
#endif
