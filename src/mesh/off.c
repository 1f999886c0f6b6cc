/*
 * Geomview OFF, text: [ST][C][N]OFF with three-dimensional points; colours and texture coordinates
 * are passed over.
 *
 * OpenMesh's reader is not used: from a file that ends early it makes faces of uninitialised
 * memory, and it believes every index and corner count.
 */
#include "mesh/format.h"
#include "mesh/text.h"

#include <string.h>

/* What the letters before "OFF" say of a vertex line: x y z, then a normal if has_normals. */
static bool parse_keyword(kg_word w, bool *out_has_normals) {
    const char *s = w.s, *end = w.s + w.n;
    if (end - s >= 2 && s[0] == 'S' && s[1] == 'T')
        s += 2;
    if (s < end && *s == 'C')
        s++;
    *out_has_normals = s < end && *s == 'N';
    s += *out_has_normals;
    return end - s == 3 && memcmp(s, "OFF", 3) == 0;
}

static kg_status truncated(const kg_mesh_builder *b, const kg_text *t, kg_error *error) {
    return kg_fail(error, KG_ERR_PARSE,
                   "%s:%zu: the file ends before all the vertices and faces that its header counts",
                   b->name, t->line);
}

/* To the next line that has a word, which is not consumed. */
static bool next_content(kg_text *t) {
    while (kg_text_next_line(t)) {
        kg_text ahead = *t;
        kg_word w;
        if (kg_text_word(&ahead, &w))
            return true;
    }
    return false;
}

static kg_status read_vertex(kg_text *t, kg_mesh_builder *b, bool has_normals, kg_error *error) {
    kg_vec3 p, n;
    if (!kg_text_vec3(t, &p))
        return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a vertex needs three numbers", b->name,
                       t->line);
    kg_status status = kg_mesh_builder_position(b, p, t->line, error);
    if (status || !has_normals)
        return status;
    if (!kg_text_vec3(t, &n) || !isfinite(kg_len(n)))
        return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a normal needs three numbers", b->name,
                       t->line);
    return kg_mesh_builder_normal(b, n, error);
}

static kg_status read_face(kg_text *t, kg_mesh_builder *b, kg_error *error) {
    kg_word w;
    int64_t n, vertex;
    if (!kg_text_word(t, &w) || !kg_word_int(w, &n) || n < 0)
        return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a face starts with its number of corners",
                       b->name, t->line);
    for (int64_t i = 0; i < n; i++) {
        if (!kg_text_word(t, &w) || !kg_word_int(w, &vertex))
            return kg_fail(error, KG_ERR_PARSE,
                           "%s:%zu: the face has fewer vertex numbers than the %lld it counts",
                           b->name, t->line, (long long)n);
        kg_status status = kg_mesh_builder_corner(b, vertex, error);
        if (status)
            return status;
    }
    return kg_mesh_builder_end_face(b, t->line, error);
}

/* The keyword, which may be absent, and the three counts, in any lines. */
static kg_status read_header(kg_text *t, const char *name, int64_t *out_vertices,
                             int64_t *out_faces, bool *out_has_normals, kg_error *error) {
    kg_word w, faces;
    *out_has_normals = false;
    bool found = kg_text_word_anywhere(t, &w);
    if (found && parse_keyword(w, out_has_normals))
        found = kg_text_word_anywhere(t, &w);
    if (found && kg_word_is(w, "BINARY"))
        return kg_fail(error, KG_ERR_PARSE, "%s: binary OFF is not supported: save it as text",
                       name);
    /* The third number counts edges; some writers leave it out, nobody needs it. */
    if (!found || !kg_word_int(w, out_vertices) || *out_vertices < 0 ||
        !kg_text_word_anywhere(t, &faces) || !kg_word_int(faces, out_faces) || *out_faces < 0)
        return kg_fail(error, KG_ERR_PARSE,
                       "%s:%zu: not an OFF file: it starts with \"OFF\" and the numbers of "
                       "vertices, faces and edges",
                       name, t->line);
    return KG_OK;
}

kg_status kg_off_read(const void *data, size_t size, kg_mesh_builder *b, kg_error *error) {
    kg_text t = kg_text_of(data, size, false);
    int64_t vertices, faces;
    bool has_normals;
    kg_status status = read_header(&t, b->name, &vertices, &faces, &has_normals, error);
    for (int64_t i = 0; i < vertices && !status; i++) {
        status =
            next_content(&t) ? read_vertex(&t, b, has_normals, error) : truncated(b, &t, error);
        if (!status)
            status = kg_mesh_builder_at(b, kg_text_offset(&t, data), error);
    }
    for (int64_t i = 0; i < faces && !status; i++) {
        status = next_content(&t) ? read_face(&t, b, error) : truncated(b, &t, error);
        if (!status)
            status = kg_mesh_builder_at(b, kg_text_offset(&t, data), error);
    }
    return status;
}

void kg_off_write(const kg_mesh *mesh, kg_bytes *out) {
    kg_bytes_print(out, "OFF\n%zu %zu 0\n", mesh->vertex_count, mesh->face_count);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        kg_vec3 p = mesh->positions[v];
        kg_bytes_print(out, "%.9g %.9g %.9g\n", p.x, p.y, p.z);
    }
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t begin = mesh->face_starts[f], end = mesh->face_starts[f + 1];
        kg_bytes_print(out, "%lu", (unsigned long)(end - begin));
        for (uint32_t c = begin; c < end; c++)
            kg_bytes_print(out, " %lu", (unsigned long)mesh->face_corners[c]);
        kg_bytes_put(out, "\n", 1);
    }
}
