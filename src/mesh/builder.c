#include "mesh/builder.h"

#include "base/progress.h"

#include <stdlib.h>
#include <string.h>

const float kg_mesh_plain_color[4] = {0.8f, 0.8f, 0.8f, 1};

/* Indices of kg_mesh are 32 bits wide. */
static const size_t most_items = UINT32_MAX - 1;

/* Bytes between two words about the progress: a millisecond's work, so that stopping is felt at
 * once and telling costs nothing. */
static const size_t told_step = 1 << 16;

/* Share of the work that reading the bytes is; the rest is checking indices and copying faces. */
#define READING_SHARE 0.9

void kg_mesh_builder_free(kg_mesh_builder *b) {
    free(b->positions.items);
    free(b->normals.items);
    free(b->corners.items);
    free(b->face_ends.items);
    free(b->face_lines.items);
    for (size_t i = 0; i < b->groups.count; i++)
        free(b->groups.items[i].name);
    free(b->groups.items);
    *b = (kg_mesh_builder){.name = b->name};
}

kg_status kg_mesh_builder_tell(kg_mesh_builder *b, size_t done, kg_error *error) {
    b->next_told = done < SIZE_MAX - told_step ? done + told_step : SIZE_MAX;
    double fraction = b->size ? fmin((double)done / (double)b->size, 1) : 0;
    return kg_progress_tell(b->progress, READING_SHARE * fraction, "reading", error);
}

kg_status kg_mesh_builder_memory(const kg_mesh_builder *b, kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory: the mesh is too large", b->name);
}

kg_status kg_mesh_builder_position(kg_mesh_builder *b, kg_vec3 p, size_t line, kg_error *error) {
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) {
        if (line)
            return kg_fail(error, KG_ERR_PARSE,
                           "%s:%zu: a coordinate of vertex %zu is not a finite number", b->name,
                           line, b->positions.count + 1);
        return kg_fail(error, KG_ERR_PARSE,
                       "%s: a coordinate of vertex %zu is not a finite number: export the mesh "
                       "again",
                       b->name, b->positions.count + 1);
    }
    if (b->positions.count >= most_items || !kg_push(&b->positions, p))
        return kg_mesh_builder_memory(b, error);
    return KG_OK;
}

kg_status kg_mesh_builder_normal(kg_mesh_builder *b, kg_vec3 n, kg_error *error) {
    if (!kg_push(&b->normals, kg_unit(n)))
        return kg_mesh_builder_memory(b, error);
    return KG_OK;
}

kg_status kg_mesh_builder_corner(kg_mesh_builder *b, int64_t vertex, kg_error *error) {
    if (b->corners.count >= most_items || !kg_push(&b->corners, vertex))
        return kg_mesh_builder_memory(b, error);
    return KG_OK;
}

kg_status kg_mesh_builder_end_face(kg_mesh_builder *b, size_t line, kg_error *error) {
    if (b->face_ends.count >= most_items || !kg_reserve(&b->face_lines, b->face_ends.count + 1) ||
        !kg_push(&b->face_ends, b->corners.count))
        return kg_mesh_builder_memory(b, error);
    b->face_lines.items[b->face_lines.count++] = line;
    return KG_OK;
}

kg_status kg_mesh_builder_group(kg_mesh_builder *b, const char *name, size_t size,
                                const float color[4], kg_error *error) {
    char *copy = malloc(size + 1);
    if (!copy)
        return kg_mesh_builder_memory(b, error);
    memcpy(copy, name, size);
    copy[size] = '\0';
    kg_mesh_group group = {.name = copy, .first_face = b->face_ends.count};
    memcpy(group.color, color, sizeof group.color);
    if (!kg_push(&b->groups, group)) {
        free(copy);
        return kg_mesh_builder_memory(b, error);
    }
    return KG_OK;
}

static kg_status check_corners(const kg_mesh_builder *b, kg_error *error) {
    size_t corner = 0;
    for (size_t f = 0; f < b->face_ends.count; f++) {
        for (; corner < b->face_ends.items[f]; corner++) {
            int64_t v = b->corners.items[corner];
            if (v >= 0 && (uint64_t)v < b->positions.count)
                continue;
            if (b->face_lines.items[f])
                return kg_fail(error, KG_ERR_PARSE,
                               "%s:%zu: the face names a vertex that does not exist (there are "
                               "%zu)",
                               b->name, b->face_lines.items[f], b->positions.count);
            return kg_fail(error, KG_ERR_PARSE,
                           "%s: face %zu names a vertex that does not exist (there are %zu): "
                           "export the mesh again",
                           b->name, f + 1, b->positions.count);
        }
    }
    return KG_OK;
}

/* Whether the n corners are 3 or more different vertices. last_face[v] is the latest face (from 1)
 * that vertex v was seen in. */
static bool is_face(const int64_t *corners, size_t n, uint32_t face, uint32_t *last_face) {
    bool repeated = false;
    for (size_t i = 0; i < n; i++) {
        repeated |= last_face[corners[i]] == face;
        last_face[corners[i]] = face;
    }
    return n >= 3 && !repeated;
}

/* Copies the usable faces, and closes the groups over them; groups left empty go. */
static void copy_faces(kg_mesh_builder *b, kg_mesh *mesh, uint32_t *last_face) {
    size_t group = 0, kept_groups = 0, begin = 0, corner_count = 0;
    for (size_t f = 0; f < b->face_ends.count; f++) {
        for (; group < b->groups.count && b->groups.items[group].first_face == f; group++)
            mesh->groups[group].first_face = mesh->face_count;
        size_t n = b->face_ends.items[f] - begin;
        const int64_t *corners = n ? b->corners.items + begin : NULL;
        begin += n;
        if (!is_face(corners, n, (uint32_t)f + 1, last_face))
            continue;
        mesh->face_starts[mesh->face_count++] = (uint32_t)corner_count;
        for (size_t i = 0; i < n; i++)
            mesh->face_corners[corner_count++] = (uint32_t)corners[i];
    }
    mesh->face_starts[mesh->face_count] = (uint32_t)corner_count;
    for (; group < b->groups.count; group++)
        mesh->groups[group].first_face = mesh->face_count;
    for (size_t i = 0; i < b->groups.count; i++) {
        kg_mesh_group g = mesh->groups[i];
        size_t end = i + 1 < b->groups.count ? mesh->groups[i + 1].first_face : mesh->face_count;
        g.face_count = end - g.first_face;
        if (g.face_count)
            mesh->groups[kept_groups++] = g;
        else
            free(g.name);
    }
    mesh->group_count = kept_groups;
}

kg_status kg_mesh_builder_finish(kg_mesh_builder *b, kg_mesh **out_mesh, kg_error *error) {
    kg_status status = check_corners(b, error);
    if (!status)
        status = kg_progress_tell(b->progress, READING_SHARE, "reading", error);
    if (status)
        return status;
    if (!b->positions.count || !b->face_ends.count)
        return kg_fail(error, KG_ERR_PARSE, "%s: the mesh has no faces", b->name);
    kg_mesh *mesh = kg_mesh_create();
    uint32_t *last_face = calloc(b->positions.count, sizeof *last_face);
    if (mesh) {
        mesh->face_starts = malloc((b->face_ends.count + 1) * sizeof *mesh->face_starts);
        mesh->face_corners = malloc((b->corners.count + 1) * sizeof *mesh->face_corners);
        mesh->groups = malloc((b->groups.count + 1) * sizeof *mesh->groups);
    }
    if (!mesh || !last_face || !mesh->face_starts || !mesh->face_corners || !mesh->groups) {
        free(last_face);
        kg_mesh_destroy(mesh);
        return kg_mesh_builder_memory(b, error);
    }
    if (b->groups.count)
        memcpy(mesh->groups, b->groups.items, b->groups.count * sizeof *mesh->groups);
    copy_faces(b, mesh, last_face);
    b->groups.count = 0; /* the names belong to the mesh now */
    free(last_face);
    mesh->positions = b->positions.items;
    mesh->vertex_count = b->positions.count;
    b->positions.items = NULL;
    b->positions.count = b->positions.capacity = 0;
    if (b->normals.count == mesh->vertex_count) {
        mesh->normals = b->normals.items;
        b->normals.items = NULL;
        b->normals.count = b->normals.capacity = 0;
    }
    if (!mesh->face_count) {
        kg_mesh_destroy(mesh);
        return kg_fail(error, KG_ERR_PARSE, "%s: no face of the mesh has three different corners",
                       b->name);
    }
    mesh->skipped_faces = b->face_ends.count - mesh->face_count;
    *out_mesh = mesh;
    return KG_OK;
}
