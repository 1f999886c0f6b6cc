#include "katagami/mesh.h"

#include <stdlib.h>
#include <string.h>

kg_mesh *kg_mesh_create(void) {
    return calloc(1, sizeof(kg_mesh));
}

void kg_mesh_destroy(kg_mesh *mesh) {
    if (!mesh)
        return;
    for (size_t i = 0; i < mesh->group_count; i++)
        free(mesh->groups[i].name);
    free(mesh->groups);
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->face_starts);
    free(mesh->face_corners);
    free(mesh);
}

/* An empty mesh need not have face_starts. */
static uint32_t corner_count_of(const kg_mesh *mesh) {
    return mesh->face_count ? mesh->face_starts[mesh->face_count] : 0;
}

static bool is_finite(kg_vec3 p) {
    return isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
}

static kg_status check_faces(const kg_mesh *mesh, uint32_t *last_face, kg_error *error) {
    if (mesh->face_count >= UINT32_MAX || (mesh->face_count && mesh->face_starts[0] != 0))
        return kg_fail(error, KG_ERR_INPUT, "mesh: the faces do not start at corner 0");
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t begin = mesh->face_starts[f], end = mesh->face_starts[f + 1];
        if (end < begin || end - begin < 3)
            return kg_fail(error, KG_ERR_INPUT, "mesh: face %zu has fewer than 3 corners", f);
        for (uint32_t c = begin; c < end; c++) {
            uint32_t v = mesh->face_corners[c];
            if (v >= mesh->vertex_count)
                return kg_fail(error, KG_ERR_INPUT,
                               "mesh: face %zu has the corner %lu, there are %zu vertices", f,
                               (unsigned long)v, mesh->vertex_count);
            if (last_face[v] == f + 1)
                return kg_fail(error, KG_ERR_INPUT, "mesh: face %zu has vertex %lu twice", f,
                               (unsigned long)v);
            last_face[v] = (uint32_t)f + 1;
        }
    }
    return KG_OK;
}

kg_status kg_mesh_check(const kg_mesh *mesh, kg_error *error) {
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        if (!is_finite(mesh->positions[v]) || (mesh->normals && !is_finite(mesh->normals[v])))
            return kg_fail(error, KG_ERR_INPUT, "mesh: vertex %zu is not finite", v);
    }
    size_t end = 0;
    for (size_t i = 0; i < mesh->group_count; i++) {
        const kg_mesh_group *g = &mesh->groups[i];
        if (!g->name || g->first_face < end || g->first_face > mesh->face_count ||
            g->face_count > mesh->face_count - g->first_face)
            return kg_fail(error, KG_ERR_INPUT,
                           "mesh: group %zu has no name or does not follow the one before", i);
        end = g->first_face + g->face_count;
    }
    uint32_t *last_face = calloc(mesh->vertex_count + 1, sizeof *last_face);
    if (!last_face)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory");
    kg_status status = check_faces(mesh, last_face, error);
    free(last_face);
    return status;
}

kg_box3 kg_mesh_bounds(const kg_mesh *mesh) {
    kg_box3 box = kg_box3_empty();
    size_t corner_count = corner_count_of(mesh);
    for (size_t c = 0; c < corner_count; c++)
        kg_box3_add(&box, mesh->positions[mesh->face_corners[c]]);
    for (size_t v = 0; !corner_count && v < mesh->vertex_count; v++)
        kg_box3_add(&box, mesh->positions[v]);
    return box;
}

/* ---- moving ---------------------------------------------------------------------------- */

static kg_vec3 apply(const double m[16], kg_vec3 p) {
    return kg_v3(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
                 m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                 m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]);
}

static void reverse_faces(kg_mesh *mesh) {
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t *a = mesh->face_corners + mesh->face_starts[f];
        uint32_t *z = mesh->face_corners + mesh->face_starts[f + 1];
        while (a < --z) {
            uint32_t swapped = *a;
            *a++ = *z;
            *z = swapped;
        }
    }
}

kg_status kg_mesh_transform(kg_mesh *mesh, const double matrix[16], kg_error *error) {
    const double *m = matrix;
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
        return kg_fail(error, KG_ERR_INPUT, "the last row of the matrix is not 0 0 0 1");
    for (int i = 0; i < 12; i++) {
        if (!isfinite(m[i]))
            return kg_fail(error, KG_ERR_INPUT, "the matrix has a number that is not finite");
    }
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        if (!is_finite(apply(m, mesh->positions[v])))
            return kg_fail(error, KG_ERR_INPUT, "the matrix moves vertex %zu out of all numbers",
                           v);
    }
    for (size_t v = 0; v < mesh->vertex_count; v++)
        mesh->positions[v] = apply(m, mesh->positions[v]);
    /* Normals turn by the cofactor matrix, det M times the inverse transpose of M, whose rows are
     * the cross products of the rows of M; the sign of det M is taken out again, so that the
     * normals of a mirrored mesh still point outwards. */
    kg_vec3 r0 = kg_v3(m[0], m[1], m[2]), r1 = kg_v3(m[4], m[5], m[6]),
            r2 = kg_v3(m[8], m[9], m[10]);
    bool mirrored = kg_det(kg_unit(r0), kg_unit(r1), kg_unit(r2)) < 0;
    /* Rows of length one at most, so that the products neither overflow nor vanish. */
    double longest = fmax(kg_len(r0), fmax(kg_len(r1), kg_len(r2)));
    double s = longest > 0 && isfinite(longest) ? 1 / longest : 1;
    r0 = kg_scale(r0, s), r1 = kg_scale(r1, s), r2 = kg_scale(r2, s);
    kg_vec3 c0 = kg_cross(r1, r2), c1 = kg_cross(r2, r0), c2 = kg_cross(r0, r1);
    for (size_t v = 0; mesh->normals && v < mesh->vertex_count; v++) {
        kg_vec3 n = mesh->normals[v];
        n = kg_unit(kg_v3(kg_dot(c0, n), kg_dot(c1, n), kg_dot(c2, n)));
        mesh->normals[v] = mirrored ? kg_neg(n) : n;
    }
    if (mirrored)
        reverse_faces(mesh);
    return KG_OK;
}

kg_status kg_mesh_fit(kg_mesh *mesh, double size_mm, kg_error *error) {
    kg_box3 box = kg_mesh_bounds(mesh);
    kg_vec3 sides = kg_sub(box.hi, box.lo);
    double longest = fmax(sides.x, fmax(sides.y, sides.z));
    if (!(size_mm > 0) || !isfinite(size_mm))
        return kg_fail(error, KG_ERR_INPUT, "a mesh cannot be made %g mm long", size_mm);
    if (!(longest > 0) || !isfinite(longest) || !isfinite(size_mm / longest))
        return kg_fail(error, KG_ERR_INPUT,
                       "the mesh has no size (all its points are in one place), so it cannot be "
                       "made %g mm long",
                       size_mm);
    double s = size_mm / longest;
    kg_vec3 center = kg_lerp(box.lo, box.hi, 0.5);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        mesh->positions[v] = kg_scale(kg_sub(mesh->positions[v], center), s);
    return KG_OK;
}

/* ---- normals --------------------------------------------------------------------------- */

/* Twice the area vector of face f: Newell's sum, taken about the first corner against rounding. */
static kg_vec3 face_area2(const kg_mesh *mesh, size_t f) {
    const uint32_t *c = mesh->face_corners + mesh->face_starts[f];
    size_t n = mesh->face_starts[f + 1] - mesh->face_starts[f];
    kg_vec3 sum = kg_v3(0, 0, 0), origin = mesh->positions[c[0]];
    for (size_t i = 1; i + 1 < n; i++)
        sum = kg_add(sum, kg_cross(kg_sub(mesh->positions[c[i]], origin),
                                   kg_sub(mesh->positions[c[i + 1]], origin)));
    return sum;
}

kg_status kg_mesh_normals(kg_mesh *mesh, kg_error *error) {
    kg_vec3 *normals = calloc(mesh->vertex_count + 1, sizeof *normals);
    if (!normals)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for its normals");
    for (size_t f = 0; f < mesh->face_count; f++) {
        kg_vec3 area2 = face_area2(mesh, f);
        for (uint32_t c = mesh->face_starts[f]; c < mesh->face_starts[f + 1]; c++)
            normals[mesh->face_corners[c]] = kg_add(normals[mesh->face_corners[c]], area2);
    }
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double length = kg_len(normals[v]);
        normals[v] =
            length > 0 && isfinite(length) ? kg_scale(normals[v], 1 / length) : kg_v3(0, 0, 1);
    }
    free(mesh->normals);
    mesh->normals = normals;
    return KG_OK;
}

/* ---- joining --------------------------------------------------------------------------- */

static bool append_groups(kg_mesh *joined, const kg_mesh *part) {
    for (size_t i = 0; i < part->group_count; i++) {
        kg_mesh_group g = part->groups[i];
        size_t size = strlen(g.name) + 1;
        g.name = malloc(size);
        if (!g.name)
            return false;
        memcpy(g.name, part->groups[i].name, size);
        g.first_face += joined->face_count;
        joined->groups[joined->group_count++] = g;
    }
    return true;
}

/* Into arrays that are large enough. */
static bool append_part(kg_mesh *joined, const kg_mesh *part) {
    if (!append_groups(joined, part))
        return false;
    uint32_t first_corner = corner_count_of(joined), corner_count = corner_count_of(part);
    for (uint32_t c = 0; c < corner_count; c++)
        joined->face_corners[first_corner + c] =
            part->face_corners[c] + (uint32_t)joined->vertex_count;
    for (size_t f = 1; f <= part->face_count; f++)
        joined->face_starts[joined->face_count + f] = first_corner + part->face_starts[f];
    joined->face_count += part->face_count;
    for (size_t v = 0; v < part->vertex_count; v++) {
        joined->positions[joined->vertex_count + v] = part->positions[v];
        if (joined->normals)
            joined->normals[joined->vertex_count + v] = part->normals[v];
    }
    joined->vertex_count += part->vertex_count;
    return true;
}

kg_status kg_mesh_append(kg_mesh *mesh, const kg_mesh *other, kg_error *error) {
    uint64_t corner_count = (uint64_t)corner_count_of(mesh) + corner_count_of(other);
    uint64_t vertex_count = (uint64_t)mesh->vertex_count + other->vertex_count;
    if (corner_count >= UINT32_MAX || vertex_count >= UINT32_MAX)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: the joined meshes are too large");
    kg_mesh *joined = kg_mesh_create();
    bool ok = joined != NULL;
    if (ok) {
        joined->face_starts =
            calloc(mesh->face_count + other->face_count + 1, sizeof *joined->face_starts);
        joined->face_corners = calloc((size_t)corner_count + 1, sizeof *joined->face_corners);
        joined->positions = calloc((size_t)vertex_count + 1, sizeof *joined->positions);
        joined->groups = calloc(mesh->group_count + other->group_count + 1, sizeof *joined->groups);
        bool has_normals =
            (mesh->normals || !mesh->vertex_count) && (other->normals || !other->vertex_count);
        if (has_normals)
            joined->normals = calloc((size_t)vertex_count + 1, sizeof *joined->normals);
        ok = joined->face_starts && joined->face_corners && joined->positions && joined->groups &&
             (joined->normals || !has_normals) && append_part(joined, mesh) &&
             append_part(joined, other);
    }
    if (!ok) {
        kg_mesh_destroy(joined);
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for the joined meshes");
    }
    kg_mesh old = *mesh;
    *mesh = *joined;
    *joined = old;
    kg_mesh_destroy(joined);
    return KG_OK;
}
