#include "base/file.h"
#include "mesh/format.h"

#include <float.h>
#include <locale.h>
#include <stdlib.h>

static kg_status check_writable(const kg_mesh *mesh, kg_error *error) {
    kg_status status = kg_mesh_check(mesh, error);
    if (status)
        return status;
    if (!mesh->face_count)
        return kg_fail(error, KG_ERR_INPUT, "mesh: there are no faces to write");
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        kg_vec3 p = mesh->positions[v];
        if (fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))) > (double)FLT_MAX)
            return kg_fail(error, KG_ERR_INPUT, "mesh: vertex %zu is too far away for a mesh file",
                           v);
    }
    return KG_OK;
}

static kg_status write_triangles(const kg_mesh *mesh, const kg_mesh_motion *motion,
                                 kg_mesh_format format, kg_bytes *out, kg_error *error) {
    uint32_t *triangles = malloc((kg_mesh_triangle_count(mesh) + 1) * 3 * sizeof *triangles);
    if (!triangles)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for its triangles");
    kg_status status = kg_mesh_triangulate(mesh, triangles, NULL, error);
    if (!status && format == KG_MESH_STL)
        kg_stl_write(mesh, triangles, out);
    else if (!status)
        status = kg_gltf_write(mesh, triangles, motion, format == KG_MESH_GLB, out, error);
    free(triangles);
    return status;
}

static kg_status write_format(const kg_mesh *mesh, const kg_mesh_motion *motion,
                              kg_mesh_format format, kg_bytes *out, kg_error *error) {
    switch (format) {
    case KG_MESH_OBJ:
        kg_obj_write(mesh, out);
        break;
    case KG_MESH_PLY:
        kg_ply_write(mesh, out);
        break;
    case KG_MESH_OFF:
        kg_off_write(mesh, out);
        break;
    default:
        return write_triangles(mesh, motion, format, out, error);
    }
    return KG_OK;
}

static kg_status write_bytes(const kg_mesh *mesh, const kg_mesh_motion *motion,
                             kg_mesh_format format, char **out_data, size_t *out_size,
                             kg_error *error) {
    kg_status status = check_writable(mesh, error);
    if (status)
        return status;
    locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c_locale)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory");
    locale_t callers = uselocale(c_locale);
    kg_bytes out = {0};
    status = write_format(mesh, motion, format, &out, error);
    uselocale(callers);
    freelocale(c_locale);
    if (!status && out.failed)
        status = kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for the file");
    if (status) {
        free(out.items);
        return status;
    }
    *out_data = out.items;
    *out_size = out.count;
    return KG_OK;
}

kg_status kg_mesh_write_memory(const kg_mesh *mesh, kg_mesh_format format, char **out_data,
                               size_t *out_size, kg_error *error) {
    return write_bytes(mesh, NULL, format, out_data, out_size, error);
}

static kg_status write_file(const char *path, const kg_mesh *mesh, const kg_mesh_motion *motion,
                            kg_mesh_format format, kg_error *error) {
    char *data;
    size_t size;
    kg_status status = write_bytes(mesh, motion, format, &data, &size, error);
    if (status)
        return kg_fail_in(error, status, "%s: ", path);
    status = kg_file_write(path, data, size, error);
    free(data);
    return status;
}

kg_status kg_mesh_write(const char *path, const kg_mesh *mesh, kg_error *error) {
    kg_mesh_format format;
    kg_status status = kg_mesh_format_of(path, &format, error);
    return status ? status : write_file(path, mesh, NULL, format, error);
}

kg_status kg_mesh_write_moving(const char *path, const kg_mesh *mesh, const kg_mesh_motion *motion,
                               kg_error *error) {
    kg_mesh_format format;
    kg_status status = kg_mesh_format_of(path, &format, error);
    if (status)
        return status;
    if (format != KG_MESH_GLTF && format != KG_MESH_GLB)
        return kg_fail(error, KG_ERR_INPUT, "%s: only glTF and GLB hold motions", path);
    return write_file(path, mesh, motion, format, error);
}
