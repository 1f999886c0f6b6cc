/* Small meshes that the mesh tests share. */
#ifndef KG_TESTS_MESH_SAMPLES_H
#define KG_TESTS_MESH_SAMPLES_H

#include "tests/check.h"

#include "katagami/mesh.h"

/* Copies everything. `corners` lists the faces one after the other, `sizes` their lengths. */
kg_mesh *kg_sample_mesh(const kg_vec3 *positions, size_t vertex_count, const uint32_t *corners,
                        const uint32_t *sizes, size_t face_count);

/* Adds a group behind the ones there are. */
void kg_sample_group(kg_mesh *mesh, const char *name, size_t first_face, size_t face_count);

/* The cube [-1,1]³ of six outward quads, with three groups, one of a Japanese name. */
kg_mesh *kg_sample_cube(void);

/* `n` random triangles in the cube [-1,1]³, some of them in one place. */
kg_mesh *kg_sample_soup(kg_random *random, size_t n);

/* Reads a text; the error must name `name` when it fails. NULL when it fails. */
kg_mesh *kg_sample_read(const void *data, size_t size, kg_mesh_format format, kg_error *error);

/* A real mesh, or NULL when it is not there. */
kg_mesh *kg_sample_real(const char *file_name);

#endif
