/* What the fuzz targets of all mesh formats do. */
#ifndef KG_TESTS_FUZZ_MESH_H
#define KG_TESTS_FUZZ_MESH_H

#include "katagami/mesh.h"

#include "tests/fuzz/fuzz.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* What is accepted keeps the promises of kg_mesh, and what is written of it is accepted again with
 * the same faces (or as many triangles). */
static inline int kg_fuzz_mesh(const uint8_t *data, size_t size, kg_mesh_format format) {
    kg_mesh *mesh, *again;
    kg_error error = {0};
    kg_status status = kg_mesh_read_memory(data, size, format, "fuzz", &mesh, &error);
    if (status) {
        assert(error.status == status && strstr(error.message, "fuzz"));
        return 0;
    }
    assert(mesh->face_count > 0 && kg_mesh_check(mesh, NULL) == KG_OK);
    char *written;
    size_t written_size;
    status = kg_mesh_write_memory(mesh, format, &written, &written_size, &error);
    /* Doubles beyond single precision, names that are not UTF-8. */
    assert(status == KG_OK || status == KG_ERR_INPUT);
    if (!status) {
        status = kg_mesh_read_memory(written, written_size, format, "fuzz", &again, &error);
        /* Corners that single precision makes equal are welded in STL, which can take all faces. */
        assert(status == KG_OK || format == KG_MESH_STL);
        if (!status) {
            assert(kg_mesh_triangle_count(again) + again->skipped_faces ==
                   kg_mesh_triangle_count(mesh));
            kg_mesh_destroy(again);
        }
        free(written);
    }
    kg_mesh_destroy(mesh);
    return 0;
}

#endif
