#include "tests/mesh/samples.h"

#include <stdlib.h>
#include <unistd.h>

static void *copy_of(const void *data, size_t size) {
    void *copy = malloc(size + 1);
    assert_non_null(copy);
    if (size)
        memcpy(copy, data, size);
    return copy;
}

kg_mesh *kg_sample_mesh(const kg_vec3 *positions, size_t vertex_count, const uint32_t *corners,
                        const uint32_t *sizes, size_t face_count) {
    kg_mesh *mesh = kg_mesh_create();
    assert_non_null(mesh);
    mesh->vertex_count = vertex_count;
    mesh->positions = copy_of(positions, vertex_count * sizeof *positions);
    mesh->face_count = face_count;
    mesh->face_starts = calloc(face_count + 1, sizeof *mesh->face_starts);
    assert_non_null(mesh->face_starts);
    for (size_t f = 0; f < face_count; f++)
        mesh->face_starts[f + 1] = mesh->face_starts[f] + sizes[f];
    mesh->face_corners = copy_of(corners, mesh->face_starts[face_count] * sizeof *corners);
    return mesh;
}

void kg_sample_group(kg_mesh *mesh, const char *name, size_t first_face, size_t face_count) {
    mesh->groups = realloc(mesh->groups, (mesh->group_count + 1) * sizeof *mesh->groups);
    assert_non_null(mesh->groups);
    mesh->groups[mesh->group_count++] = (kg_mesh_group){
        copy_of(name, strlen(name) + 1), first_face, face_count, {0.5f, 0.25f, 1, 1}};
}

kg_mesh *kg_sample_cube(void) {
    kg_vec3 p[8];
    for (int i = 0; i < 8; i++)
        p[i] = kg_v3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const uint32_t corners[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    const uint32_t sizes[] = {4, 4, 4, 4, 4, 4};
    kg_mesh *mesh = kg_sample_mesh(p, 8, corners, sizes, 6);
    kg_sample_group(mesh, "floor", 0, 1);
    kg_sample_group(mesh, "屋根", 1, 1);
    kg_sample_group(mesh, "walls", 2, 4);
    return mesh;
}

kg_mesh *kg_sample_soup(kg_random *random, size_t n) {
    kg_vec3 *p = malloc(3 * n * sizeof *p);
    uint32_t *corners = malloc(3 * n * sizeof *corners), *sizes = malloc(n * sizeof *sizes);
    assert_true(p && corners && sizes);
    for (size_t f = 0; f < n; f++) {
        kg_vec3 center;
        double size = f % 5 == 4 ? 0 : kg_random_in(random, 0, 0.5); /* every fifth is a point */
        center.x = kg_random_in(random, -1, 1);
        center.y = kg_random_in(random, -1, 1);
        center.z = kg_random_in(random, -1, 1);
        for (size_t i = 3 * f; i < 3 * f + 3; i++) {
            p[i].x = center.x + kg_random_in(random, -1, 1) * size;
            p[i].y = center.y + kg_random_in(random, -1, 1) * size;
            p[i].z = center.z + kg_random_in(random, -1, 1) * size;
            corners[i] = (uint32_t)i;
        }
        sizes[f] = 3;
    }
    kg_mesh *mesh = kg_sample_mesh(p, 3 * n, corners, sizes, n);
    free(p);
    free(corners);
    free(sizes);
    return mesh;
}

kg_mesh *kg_sample_read(const void *data, size_t size, kg_mesh_format format, kg_error *error) {
    kg_mesh *mesh = NULL;
    memset(error, 0, sizeof *error);
    kg_status status = kg_mesh_read_memory(data, size, format, "sample", &mesh, error);
    if (status) {
        assert_null(mesh);
        assert_int_equal(error->status, status);
        assert_memory_equal(error->message, "sample", 6);
        return NULL;
    }
    assert_int_equal(kg_mesh_check(mesh, NULL), KG_OK);
    assert_true(mesh->face_count > 0);
    return mesh;
}

kg_mesh *kg_sample_real(const char *file_name) {
    const char *folder = getenv("KATAGAMI_DATA");
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder ? folder : KG_DATA, file_name);
    if (access(path, R_OK) != 0)
        return NULL;
    kg_mesh *mesh = NULL;
    kg_error error = {0};
    if (kg_mesh_read(path, &mesh, &error))
        fail_msg("%s", error.message);
    return mesh;
}
