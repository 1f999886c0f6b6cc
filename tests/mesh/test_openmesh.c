/* Files that katagami writes, read by OpenMesh, written by it and read again by katagami. */
#include "tests/mesh/openmesh.h"
#include "tests/mesh/samples.h"

#include <stdlib.h>

static const struct form {
    kg_mesh_format format;
    const char *extension;
    bool binary; /* as katagami writes it */
} forms[] = {{KG_MESH_OBJ, ".obj", false},
             {KG_MESH_PLY, ".ply", true},
             {KG_MESH_STL, ".stl", true},
             {KG_MESH_OFF, ".off", false}};

/* Each face has the same points in the same order, from any of its corners on. */
static void assert_same_faces(const kg_mesh *a, const kg_mesh *b, double tolerance) {
    assert_int_equal(a->face_count, b->face_count);
    for (size_t f = 0; f < a->face_count; f++) {
        const uint32_t *p = a->face_corners + a->face_starts[f];
        const uint32_t *q = b->face_corners + b->face_starts[f];
        size_t n = a->face_starts[f + 1] - a->face_starts[f];
        assert_int_equal(n, b->face_starts[f + 1] - b->face_starts[f]);
        double worst = INFINITY;
        for (size_t turn = 0; turn < n; turn++) {
            double here = 0;
            for (size_t i = 0; i < n; i++)
                here = fmax(here, kg_dist(a->positions[p[i]], b->positions[q[(i + turn) % n]]));
            worst = fmin(worst, here);
        }
        assert_near(worst, 0, tolerance);
    }
}

static kg_mesh *through_openmesh(const kg_mesh *mesh, const struct form *from,
                                 const struct form *to, bool to_binary) {
    char *data, *converted;
    size_t size, converted_size;
    kg_error error;
    assert_int_equal(kg_mesh_write_memory(mesh, from->format, &data, &size, &error), KG_OK);
    if (!kg_openmesh_convert(data, size, from->extension, from->binary, to->extension, to_binary,
                             &converted, &converted_size))
        fail_msg("OpenMesh does not take %s to %s", from->extension, to->extension);
    kg_mesh *again = kg_sample_read(converted, converted_size, to->format, &error);
    if (!again)
        fail_msg("%s to %s: %s", from->extension, to->extension, error.message);
    free(data);
    free(converted);
    return again;
}

static void check_all_ways(const kg_mesh *mesh, const kg_mesh *triangles, double tolerance) {
    for (size_t i = 0; i < 4; i++) {
        for (size_t j = 0; j < 4; j++) {
            for (int binary = 0; binary < 2; binary++) {
                bool text_only = forms[j].format == KG_MESH_OBJ || forms[j].format == KG_MESH_OFF;
                if (binary && text_only)
                    continue;
                bool cut = forms[i].format == KG_MESH_STL;
                /* OpenMesh leaves faces that are no triangles out of STL files. */
                if (forms[j].format == KG_MESH_STL && !cut && mesh != triangles)
                    continue;
                kg_mesh *again = through_openmesh(mesh, &forms[i], &forms[j], binary);
                assert_same_faces(cut ? triangles : mesh, again, tolerance);
                kg_mesh_destroy(again);
            }
        }
    }
}

static kg_mesh *triangulated(const kg_mesh *mesh) {
    char *data;
    size_t size;
    kg_error error;
    assert_int_equal(kg_mesh_write_memory(mesh, KG_MESH_STL, &data, &size, &error), KG_OK);
    kg_mesh *made = kg_sample_read(data, size, KG_MESH_STL, &error);
    assert_non_null(made);
    free(data);
    return made;
}

static void a_cube_goes_through_openmesh_in_all_formats(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube(), *triangles = triangulated(cube);
    check_all_ways(cube, triangles, 0);
    kg_mesh_destroy(cube);
    kg_mesh_destroy(triangles);
}

static void the_dolphin_goes_through_openmesh_in_all_formats(void **state) {
    (void)state;
    kg_mesh *dolphin = kg_sample_real("dolphin.obj");
    if (!dolphin)
        skip();
    check_all_ways(dolphin, dolphin, 300 * 1e-6);
    kg_mesh_destroy(dolphin);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_goes_through_openmesh_in_all_formats),
        cmocka_unit_test(the_dolphin_goes_through_openmesh_in_all_formats),
    };
    return cmocka_run_group_tests_name("mesh and OpenMesh", tests, NULL, NULL);
}
