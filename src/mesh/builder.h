/*
 * Collects what a mesh file says and turns it into a kg_mesh that keeps the promises of the type:
 * every index checked, unusable faces left out, runs of faces named.
 */
#ifndef KG_MESH_BUILDER_H
#define KG_MESH_BUILDER_H

#include "katagami/mesh.h"

#include "base/array.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct kg_mesh_builder {
    const char *name;            /* of the file, for messages */
    const kg_progress *progress; /* may be NULL */
    size_t size;                 /* of the file, bytes */
    size_t next_told;            /* bytes read when progress is told next */
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } positions, normals; /* normals: none, or one per position */
    struct {
        int64_t *items; /* as the file says, checked at the end: OBJ may point ahead */
        size_t count, capacity;
    } corners;
    struct {
        size_t *items; /* corners.count behind each face */
        size_t count, capacity;
    } face_ends;
    struct {
        size_t *items; /* line of each face, 0 in binary files */
        size_t count, capacity;
    } face_lines;
    struct {
        kg_mesh_group *items;
        size_t count, capacity;
    } groups; /* face_count is set at the end */
} kg_mesh_builder;

void kg_mesh_builder_free(kg_mesh_builder *b);

/* Tells how many bytes of the file are read. Readers do so with every line, vertex or face, by
 * kg_mesh_builder_at. */
kg_status kg_mesh_builder_tell(kg_mesh_builder *b, size_t done, kg_error *error) KG_CHECKED;

KG_CHECKED static inline kg_status kg_mesh_builder_at(kg_mesh_builder *b, size_t done,
                                                      kg_error *error) {
    return done < b->next_told ? KG_OK : kg_mesh_builder_tell(b, done, error);
}

/* KG_ERR_MEMORY, naming the file. */
kg_status kg_mesh_builder_memory(const kg_mesh_builder *b, kg_error *error);

/* `line` is 0 for binary files; KG_ERR_PARSE when a coordinate is not finite. */
kg_status kg_mesh_builder_position(kg_mesh_builder *b, kg_vec3 p, size_t line,
                                   kg_error *error) KG_CHECKED;

/* The normal of the next position without one, made unit. */
kg_status kg_mesh_builder_normal(kg_mesh_builder *b, kg_vec3 n, kg_error *error) KG_CHECKED;

/* Corners are pushed one by one, then the face is closed. */
kg_status kg_mesh_builder_corner(kg_mesh_builder *b, int64_t vertex, kg_error *error) KG_CHECKED;
kg_status kg_mesh_builder_end_face(kg_mesh_builder *b, size_t line, kg_error *error) KG_CHECKED;

/* Starts a group with the next face; a copy of the `size` bytes of `name` is taken. */
kg_status kg_mesh_builder_group(kg_mesh_builder *b, const char *name, size_t size,
                                const float color[4], kg_error *error) KG_CHECKED;

/* Makes the mesh; the builder is left to be freed. */
kg_status kg_mesh_builder_finish(kg_mesh_builder *b, kg_mesh **out_mesh,
                                 kg_error *error) KG_CHECKED;

/* The colour of groups whose file names none. */
extern const float kg_mesh_plain_color[4];

#ifdef __cplusplus
}
#endif
#endif
