/* Files that end early or have wrong bytes: an error or a valid mesh, never a crash. */
#include "tests/mesh/samples.h"

#include <stdlib.h>

static const kg_mesh_format all_formats[] = {KG_MESH_OBJ, KG_MESH_PLY,  KG_MESH_STL,
                                             KG_MESH_OFF, KG_MESH_GLTF, KG_MESH_GLB};

static void every_cut_gives_an_error_or_a_valid_mesh(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_normals(cube, NULL), KG_OK);
    kg_error error;
    for (size_t i = 0; i < 6; i++) {
        char *data;
        size_t size;
        assert_int_equal(kg_mesh_write_memory(cube, all_formats[i], &data, &size, NULL), KG_OK);
        for (size_t cut = 0; cut < size; cut++) {
            char *part = malloc(cut + 1); /* of its own, so that sanitizers see one byte more */
            memcpy(part, data, cut);
            kg_mesh *mesh = kg_sample_read(part, cut, all_formats[i], &error);
            if (mesh)
                assert_true(kg_mesh_triangle_count(mesh) <= 12);
            kg_mesh_destroy(mesh);
            free(part);
        }
        free(data);
    }
    kg_mesh_destroy(cube);
}

static void flipped_bytes_give_an_error_or_a_valid_mesh(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    kg_random random = {1};
    kg_error error;
    for (size_t i = 0; i < 6; i++) {
        char *data;
        size_t size;
        assert_int_equal(kg_mesh_write_memory(cube, all_formats[i], &data, &size, NULL), KG_OK);
        char *bad = malloc(size);
        for (int round = 0; round < 2000; round++) {
            memcpy(bad, data, size);
            for (int flips = 1 + round % 4; flips > 0; flips--)
                bad[kg_random_bits(&random) % size] = (char)kg_random_bits(&random);
            kg_mesh_destroy(kg_sample_read(bad, size, all_formats[i], &error));
        }
        free(bad);
        free(data);
    }
    kg_mesh_destroy(cube);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_cut_gives_an_error_or_a_valid_mesh),
        cmocka_unit_test(flipped_bytes_give_an_error_or_a_valid_mesh),
    };
    return cmocka_run_group_tests_name("mesh damage", tests, NULL, NULL);
}
