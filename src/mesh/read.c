#include "base/file.h"
#include "base/phrase.h"
#include "base/progress.h"
#include "mesh/format.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

kg_status kg_mesh_format_of(const char *path, kg_mesh_format *out_format, kg_error *error) {
    static const char *const extensions[] = {
        [KG_MESH_OBJ] = ".obj", [KG_MESH_PLY] = ".ply",   [KG_MESH_STL] = ".stl",
        [KG_MESH_OFF] = ".off", [KG_MESH_GLTF] = ".gltf", [KG_MESH_GLB] = ".glb",
    };
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof extensions / sizeof *extensions; i++) {
        size_t n = 0;
        while (dot[n] && (n ? (dot[n] | 0x20) : dot[n]) == extensions[i][n])
            n++;
        if (!dot[n] && !extensions[i][n]) {
            *out_format = (kg_mesh_format)i;
            return KG_OK;
        }
    }
    return kg_fail(error, KG_ERR_INPUT,
                   "%s: not a mesh file by its name: use .obj, .ply, .stl, .off, .gltf or .glb",
                   path);
}

static kg_status read_format(const void *data, size_t size, kg_mesh_format format,
                             const char *folder, kg_mesh_builder *b, kg_error *error) {
    switch (format) {
    case KG_MESH_OBJ:
        return kg_obj_read(data, size, b, error);
    case KG_MESH_PLY:
        return kg_ply_read(data, size, b, error);
    case KG_MESH_STL:
        return kg_stl_read(data, size, b, error);
    case KG_MESH_OFF:
        return kg_off_read(data, size, b, error);
    default:
        return kg_gltf_read(data, size, folder, b, error);
    }
}

static kg_status read_data(const void *data, size_t size, kg_mesh_format format, const char *name,
                           const char *folder, const kg_progress *progress, kg_mesh **out_mesh,
                           kg_error *error) {
    locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c_locale)
        return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", name);
    locale_t callers = uselocale(c_locale);
    kg_mesh_builder b = {.name = name, .progress = progress, .size = size};
    kg_status status = read_format(data, size, format, folder, &b, error);
    if (!status)
        status = kg_mesh_builder_finish(&b, out_mesh, error);
    kg_mesh_builder_free(&b);
    uselocale(callers);
    freelocale(c_locale);
    return status;
}

kg_status kg_mesh_read_memory(const void *data, size_t size, kg_mesh_format format,
                              const char *name, kg_mesh **out_mesh, kg_error *error) {
    return read_data(data, size, format, name, NULL, NULL, out_mesh, error);
}

/* Share of the work that fetching the bytes is, where they are at hand; a slow disk takes longer.
 */
#define FETCHING_SHARE 0.1

kg_status kg_mesh_read_reporting(const char *path, const kg_progress *progress, kg_mesh **out_mesh,
                                 kg_error *error) {
    kg_progress_share fetching = {progress, 0, FETCHING_SHARE},
                      reading = {progress, FETCHING_SHARE, 1};
    kg_progress of_fetching = kg_progress_of_share(&fetching),
                of_reading = kg_progress_of_share(&reading);
    kg_mesh_format format;
    kg_status status = kg_mesh_format_of(path, &format, error);
    if (status)
        return status;
    const char *slash = strrchr(path, '/');
    char *data, *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    size_t size;
    if (!folder)
        return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", path);
    status = kg_file_read_telling(path, &of_fetching, &data, &size, error);
    if (!status) {
        status = read_data(data, size, format, path, folder, &of_reading, out_mesh, error);
        free(data);
    }
    free(folder);
    return status;
}

kg_status kg_mesh_read(const char *path, kg_mesh **out_mesh, kg_error *error) {
    return kg_mesh_read_reporting(path, NULL, out_mesh, error);
}

bool kg_mesh_say_skipped(const kg_mesh *mesh, const char *name, char *out, size_t size) {
    out[0] = '\0';
    if (mesh->skipped_faces)
        kg_phrase_print(out, size,
                        "%s: faces that were skipped: %zu; they have fewer than three different "
                        "corners, or one of them twice",
                        name, mesh->skipped_faces);
    return mesh->skipped_faces > 0;
}
