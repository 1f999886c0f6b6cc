/*
 * Wavefront OBJ: v, vn, f, g, o; everything else (curves, materials, texture coordinates) is passed
 * over.
 *
 * OpenMesh's reader is not used: it leaves out faces that continue on the next line and vertices
 * it cannot read (which shifts all later indices), rounds positions to single precision, hands out
 * indices unchecked, opens files that `mtllib` names and prints to the standard error.
 */
#include "mesh/format.h"
#include "mesh/text.h"

#include <stdlib.h>
#include <string.h>

/* Normals belong to corners in OBJ and to vertices here: kept when each vertex has just one. */
typedef struct normal_table {
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } values;
    struct {
        int64_t *items; /* per corner of the builder, -1 for none */
        size_t count, capacity;
    } of_corner;
} normal_table;

/* OBJ counts from 1, and backwards from the latest with negative numbers. */
static int64_t resolve(int64_t index, size_t count) {
    return index > 0 ? index - 1 : (int64_t)count + index;
}

/* "v", "v/t", "v//n" or "v/t/n". */
static bool parse_corner(kg_word w, int64_t *out_vertex, int64_t *out_normal) {
    *out_normal = 0;
    const char *slash = memchr(w.s, '/', w.n);
    kg_word vertex = {w.s, slash ? (size_t)(slash - w.s) : w.n};
    if (!kg_word_int(vertex, out_vertex) || *out_vertex == 0)
        return false;
    if (!slash)
        return true;
    const char *end = w.s + w.n;
    slash = memchr(slash + 1, '/', (size_t)(end - slash - 1));
    if (!slash || slash + 1 == end)
        return true;
    kg_word normal = {slash + 1, (size_t)(end - slash - 1)};
    return kg_word_int(normal, out_normal);
}

static kg_status read_face(kg_text *t, kg_mesh_builder *b, normal_table *normals, kg_error *error) {
    size_t line = t->line;
    kg_word w;
    while (kg_text_word(t, &w)) {
        int64_t vertex, normal;
        if (!parse_corner(w, &vertex, &normal))
            return kg_fail(error, KG_ERR_PARSE,
                           "%s:%zu: \"%.*s\" is not a corner of a face (vertex, vertex/texture or "
                           "vertex/texture/normal, counted from 1)",
                           b->name, t->line, (int)(w.n < 40 ? w.n : 40), w.s);
        kg_status status = kg_mesh_builder_corner(b, resolve(vertex, b->positions.count), error);
        if (status)
            return status;
        int64_t n = normal ? resolve(normal, normals->values.count) : -1;
        if (!kg_push(&normals->of_corner, n))
            return kg_mesh_builder_memory(b, error);
    }
    return kg_mesh_builder_end_face(b, line, error);
}

static kg_status read_statement(kg_text *t, kg_word keyword, kg_mesh_builder *b,
                                normal_table *normals, bool *has_groups, kg_error *error) {
    kg_vec3 p;
    if (kg_word_is(keyword, "v")) {
        if (!kg_text_vec3(t, &p))
            return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a vertex needs three numbers", b->name,
                           t->line);
        return kg_mesh_builder_position(b, p, t->line, error);
    }
    if (kg_word_is(keyword, "vn")) {
        if (!kg_text_vec3(t, &p))
            return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a normal needs three numbers", b->name,
                           t->line);
        return kg_push(&normals->values, p) ? KG_OK : kg_mesh_builder_memory(b, error);
    }
    if (kg_word_is(keyword, "f"))
        return read_face(t, b, normals, error);
    bool is_group = kg_word_is(keyword, "g");
    if (is_group || (kg_word_is(keyword, "o") && !*has_groups)) {
        *has_groups |= is_group;
        kg_word name = kg_text_rest(t);
        if (!name.n)
            name = (kg_word){"default", 7}; /* what the format calls the group without a name */
        return kg_mesh_builder_group(b, name.s, name.n, kg_mesh_plain_color, error);
    }
    return KG_OK;
}

/* Gives the builder one normal per vertex, if the corners agree on one. */
static kg_status settle_normals(kg_mesh_builder *b, const normal_table *normals, kg_error *error) {
    if (!normals->values.count)
        return KG_OK;
    struct {
        int64_t *items;
        size_t count, capacity;
    } of_vertex = {0};
    bool agreed = true;
    kg_status status = KG_OK;
    if (!kg_reserve(&of_vertex, b->positions.count + 1))
        return kg_mesh_builder_memory(b, error);
    for (size_t v = 0; v < b->positions.count; v++)
        of_vertex.items[v] = -1;
    for (size_t c = 0; c < b->corners.count && agreed; c++) {
        int64_t v = b->corners.items[c], n = normals->of_corner.items[c];
        if (v < 0 || (uint64_t)v >= b->positions.count)
            break; /* refused by the builder at the end */
        agreed = n >= 0 && (uint64_t)n < normals->values.count &&
                 (of_vertex.items[v] < 0 || of_vertex.items[v] == n);
        of_vertex.items[v] = n;
    }
    for (size_t v = 0; v < b->positions.count && agreed; v++) {
        kg_vec3 n =
            of_vertex.items[v] < 0 ? kg_v3(0, 0, 1) : normals->values.items[of_vertex.items[v]];
        agreed = isfinite(kg_len(n)) && kg_len(n) > 0;
        if (agreed && (status = kg_mesh_builder_normal(b, n, error)))
            break;
    }
    free(of_vertex.items);
    return status;
}

kg_status kg_obj_read(const void *data, size_t size, kg_mesh_builder *b, kg_error *error) {
    kg_text t = kg_text_of(data, size, true);
    normal_table normals = {0};
    bool has_groups = false;
    kg_status status = KG_OK;
    do {
        kg_word keyword;
        status = kg_mesh_builder_at(b, kg_text_offset(&t, data), error);
        if (!status && kg_text_word(&t, &keyword))
            status = read_statement(&t, keyword, b, &normals, &has_groups, error);
    } while (!status && kg_text_next_line(&t));
    if (!status)
        status = settle_normals(b, &normals, error);
    free(normals.values.items);
    free(normals.of_corner.items);
    return status;
}

/* A name is one word of its line; any UTF-8 beyond ASCII is part of a word. */
static void write_name(kg_bytes *out, const char *name) {
    size_t n = strlen(name);
    if (!n)
        kg_bytes_put(out, "_", 1);
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)name[i];
        bool plain = c > ' ' && c != 0x7f && c != '#' && c != '\\';
        kg_bytes_put(out, plain ? name + i : "_", 1);
    }
}

void kg_obj_write(const kg_mesh *mesh, kg_bytes *out) {
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        kg_vec3 p = mesh->positions[v];
        kg_bytes_print(out, "v %.9g %.9g %.9g\n", p.x, p.y, p.z);
    }
    for (size_t v = 0; mesh->normals && v < mesh->vertex_count; v++) {
        kg_vec3 n = mesh->normals[v];
        kg_bytes_print(out, "vn %.9g %.9g %.9g\n", n.x, n.y, n.z);
    }
    size_t group = 0, group_end = SIZE_MAX; /* the next to begin; the end of the open one */
    for (size_t f = 0; f < mesh->face_count; f++) {
        if (group < mesh->group_count && mesh->groups[group].first_face == f) {
            const kg_mesh_group *g = &mesh->groups[group++];
            group_end = g->first_face + g->face_count;
            kg_bytes_put(out, "g ", 2);
            write_name(out, g->name);
            kg_bytes_put(out, "\n", 1);
        } else if (f == group_end) {
            kg_bytes_print(out, "g default\n");
        }
        kg_bytes_put(out, "f", 1);
        for (uint32_t c = mesh->face_starts[f]; c < mesh->face_starts[f + 1]; c++) {
            unsigned long v = mesh->face_corners[c] + 1ul;
            if (mesh->normals)
                kg_bytes_print(out, " %lu//%lu", v, v);
            else
                kg_bytes_print(out, " %lu", v);
        }
        kg_bytes_put(out, "\n", 1);
    }
}
