/*
 * Stanford PLY: text and binary of both byte orders. Of the elements only `vertex` (x y z, nx ny
 * nz) and `face` (vertex_indices or vertex_index) are kept; the others are stepped over.
 *
 * OpenMesh's reader is not used: it reads doubles in text as zeros, fills up faces whose header or
 * count is wrong by repeating the last index, keeps the state of a file in a global object, and
 * prints to the standard error.
 */
#include "mesh/format.h"

#include "base/phrase.h"
#include "mesh/text.h"

#include <stdlib.h>
#include <string.h>

typedef enum scalar { I8, U8, I16, U16, I32, U32, F32, F64, SCALARS } scalar;

static const struct {
    const char *name, *short_name;
    size_t size;
} scalars[SCALARS] = {
    [I8] = {"char", "int8", 1},      [U8] = {"uchar", "uint8", 1},
    [I16] = {"short", "int16", 2},   [U16] = {"ushort", "uint16", 2},
    [I32] = {"int", "int32", 4},     [U32] = {"uint", "uint32", 4},
    [F32] = {"float", "float32", 4}, [F64] = {"double", "float64", 8},
};

enum { NOT_KEPT = -1, NORMAL = 3, INDICES = 6 }; /* 0..2: x y z; 3..5: nx ny nz */

typedef struct property {
    scalar type, count_type;
    bool is_list;
    int role;
} property;

typedef enum kind { OTHER, VERTEX, FACE } kind;

typedef struct element {
    kind kind;
    uint64_t count;
    struct {
        property *items;
        size_t count, capacity;
    } properties;
} element;

typedef enum encoding { TEXT, LITTLE, BIG } encoding;

typedef struct ply {
    kg_mesh_builder *b;
    kg_error *error;
    kg_text t; /* in binary data only `at` and `end` count */
    encoding encoding;
    struct {
        element *items;
        size_t count, capacity;
    } elements;
} ply;

static kg_status fail_at(const ply *p, const char *what) {
    return kg_fail(p->error, KG_ERR_PARSE, "%s:%zu: %s", p->b->name, p->t.line, kg_phrase(what));
}

static kg_status truncated(const ply *p) {
    return kg_fail(p->error, KG_ERR_PARSE,
                   "%s: the file ends, or has something that is not a number, before all that its "
                   "header counts: vertex %zu, face %zu",
                   p->b->name, p->b->positions.count + 1, p->b->face_ends.count + 1);
}

/* ---- header ---------------------------------------------------------------------------- */

static bool scalar_of(kg_word w, scalar *out_type) {
    for (int i = 0; i < SCALARS; i++) {
        if (kg_word_is(w, scalars[i].name) || kg_word_is(w, scalars[i].short_name)) {
            *out_type = (scalar)i;
            return true;
        }
    }
    return false;
}

static int role_of(const element *e, kg_word name, bool is_list) {
    static const char *const coordinates[INDICES] = {"x", "y", "z", "nx", "ny", "nz"};
    for (int i = 0; e->kind == VERTEX && !is_list && i < INDICES; i++) {
        if (kg_word_is(name, coordinates[i]))
            return i;
    }
    bool indices = kg_word_is(name, "vertex_indices") || kg_word_is(name, "vertex_index");
    return e->kind == FACE && is_list && indices ? INDICES : NOT_KEPT;
}

static bool has_role(const element *e, int role) {
    for (size_t i = 0; i < e->properties.count; i++) {
        if (e->properties.items[i].role == role)
            return true;
    }
    return false;
}

static kg_status read_property(ply *p) {
    kg_word w = {0};
    property made = {0};
    if (!p->elements.count)
        return fail_at(p, "a property stands before the first element");
    element *e = &p->elements.items[p->elements.count - 1];
    bool ok = kg_text_word(&p->t, &w);
    made.is_list = ok && kg_word_is(w, "list");
    if (made.is_list)
        ok = kg_text_word(&p->t, &w) && scalar_of(w, &made.count_type) && made.count_type < F32 &&
             kg_text_word(&p->t, &w);
    ok = ok && scalar_of(w, &made.type) && kg_text_word(&p->t, &w);
    if (!ok)
        return fail_at(p, "not a property: it needs a type (char … double, or a list) and a name");
    made.role = role_of(e, w, made.is_list);
    if (made.role != NOT_KEPT && has_role(e, made.role))
        return fail_at(p, "the same property stands twice");
    return kg_push(&e->properties, made) ? KG_OK : kg_mesh_builder_memory(p->b, p->error);
}

static kg_status read_element(ply *p) {
    kg_word name, count;
    int64_t n;
    if (!kg_text_word(&p->t, &name) || !kg_text_word(&p->t, &count) || !kg_word_int(count, &n) ||
        n < 0)
        return fail_at(p, "an element needs a name and a count");
    element e = {.kind = kg_word_is(name, "vertex") ? VERTEX
                         : kg_word_is(name, "face") ? FACE
                                                    : OTHER,
                 .count = (uint64_t)n};
    return kg_push(&p->elements, e) ? KG_OK : kg_mesh_builder_memory(p->b, p->error);
}

static kg_status read_format(ply *p) {
    kg_word w;
    if (!kg_text_word(&p->t, &w))
        return fail_at(p, "the format is missing");
    if (kg_word_is(w, "ascii"))
        p->encoding = TEXT;
    else if (kg_word_is(w, "binary_little_endian"))
        p->encoding = LITTLE;
    else if (kg_word_is(w, "binary_big_endian"))
        p->encoding = BIG;
    else
        return fail_at(p, "unknown format: ascii, binary_little_endian or binary_big_endian");
    return KG_OK;
}

static kg_status check_elements(ply *p) {
    for (size_t i = 0; i < p->elements.count; i++) {
        const element *e = &p->elements.items[i];
        if (e->kind == VERTEX && !(has_role(e, 0) && has_role(e, 1) && has_role(e, 2)))
            return fail_at(p, "the vertices lack x, y or z");
        if (e->kind == FACE && !has_role(e, INDICES))
            return fail_at(p, "the faces lack vertex_indices");
    }
    return KG_OK;
}

static kg_status read_header(ply *p) {
    kg_word w;
    if (!kg_text_word(&p->t, &w) || !kg_word_is(w, "ply"))
        return fail_at(p, "not a PLY file: it starts with \"ply\"");
    bool has_format = false;
    while (kg_text_next_line(&p->t)) {
        kg_status status = KG_OK;
        if (!kg_text_word(&p->t, &w))
            continue;
        if (kg_word_is(w, "format")) {
            status = read_format(p);
            has_format = true;
        } else if (kg_word_is(w, "element")) {
            status = read_element(p);
        } else if (kg_word_is(w, "property")) {
            status = read_property(p);
        } else if (kg_word_is(w, "end_header")) {
            if (!has_format)
                return fail_at(p, "the header has no format line");
            if (!kg_text_next_line(&p->t))
                return truncated(p);
            return check_elements(p);
        }
        if (status)
            return status;
    }
    return fail_at(p, "the header does not end");
}

/* ---- values ---------------------------------------------------------------------------- */

static bool read_binary(ply *p, scalar type, double *out_value) {
    size_t size = scalars[type].size;
    if ((size_t)(p->t.end - p->t.at) < size)
        return false;
    const unsigned char *bytes = (const unsigned char *)p->t.at;
    p->t.at += size;
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++)
        bits = bits << 8 | bytes[p->encoding == BIG ? i : size - 1 - i];
    float f;
    uint32_t low = (uint32_t)bits;
    switch (type) {
    case I8:
        *out_value = (double)(int8_t)bits;
        break;
    case I16:
        *out_value = (double)(int16_t)bits;
        break;
    case I32:
        *out_value = (double)(int32_t)bits;
        break;
    case F32:
        memcpy(&f, &low, sizeof f);
        *out_value = (double)f;
        break;
    case F64:
        memcpy(out_value, &bits, sizeof bits);
        break;
    default:
        *out_value = (double)bits;
        break;
    }
    return true;
}

static bool read_value(ply *p, scalar type, double *out_value) {
    kg_word w;
    if (p->encoding == TEXT)
        return kg_text_word_anywhere(&p->t, &w) && kg_word_double(w, out_value);
    return read_binary(p, type, out_value);
}

/* A count or an index: a whole number of at most 32 bits, -1 standing for anything else. */
static int64_t whole(double value) {
    return value >= 0 && value <= (double)UINT32_MAX && value == floor(value) ? (int64_t)value : -1;
}

static kg_status read_list(ply *p, const property *q, size_t line) {
    double n, value;
    if (!read_value(p, q->count_type, &n) || whole(n) < 0)
        return truncated(p);
    for (int64_t i = 0; i < whole(n); i++) {
        if (!read_value(p, q->type, &value))
            return truncated(p);
        kg_status status = KG_OK;
        if (q->role == INDICES)
            status = kg_mesh_builder_corner(p->b, whole(value), p->error);
        if (status)
            return status;
    }
    return q->role == INDICES ? kg_mesh_builder_end_face(p->b, line, p->error) : KG_OK;
}

static kg_status read_instance(ply *p, const element *e, bool has_normals) {
    double kept[INDICES] = {0};
    size_t line = 0;
    for (size_t i = 0; i < e->properties.count; i++) {
        const property *q = &e->properties.items[i];
        if (p->encoding == TEXT) {
            kg_word w;
            kg_text ahead = p->t;
            if (kg_text_word_anywhere(&ahead, &w))
                line = ahead.line;
        }
        if (q->is_list) {
            kg_status status = read_list(p, q, line);
            if (status)
                return status;
            continue;
        }
        double value;
        if (!read_value(p, q->type, &value))
            return truncated(p);
        if (q->role != NOT_KEPT)
            kept[q->role] = value;
    }
    if (e->kind != VERTEX)
        return KG_OK;
    kg_status status =
        kg_mesh_builder_position(p->b, kg_v3(kept[0], kept[1], kept[2]), line, p->error);
    kg_vec3 n = kg_v3(kept[NORMAL], kept[NORMAL + 1], kept[NORMAL + 2]);
    /* Without a direction a normal is worth nothing; then the builder lacks one and drops all. */
    if (!status && has_normals && isfinite(kg_len(n)) && kg_len(n) > 0)
        status = kg_mesh_builder_normal(p->b, n, p->error);
    return status;
}

kg_status kg_ply_read(const void *data, size_t size, kg_mesh_builder *b, kg_error *error) {
    ply p = {.b = b, .error = error, .t = kg_text_of(data, size, false)};
    kg_status status = read_header(&p);
    for (size_t i = 0; i < p.elements.count && !status; i++) {
        const element *e = &p.elements.items[i];
        bool has_normals =
            has_role(e, NORMAL) && has_role(e, NORMAL + 1) && has_role(e, NORMAL + 2);
        /* An element without properties takes no bytes: nothing to step over. */
        for (uint64_t j = 0; e->properties.count && j < e->count && !status; j++) {
            status = read_instance(&p, e, has_normals);
            if (!status)
                status = kg_mesh_builder_at(b, kg_text_offset(&p.t, data), error);
        }
    }
    for (size_t i = 0; i < p.elements.count; i++)
        free(p.elements.items[i].properties.items);
    free(p.elements.items);
    return status;
}

/* ---- writer ---------------------------------------------------------------------------- */

void kg_ply_write(const kg_mesh *mesh, kg_bytes *out) {
    kg_bytes_print(out,
                   "ply\nformat binary_little_endian 1.0\nelement vertex %zu\n"
                   "property float x\nproperty float y\nproperty float z\n",
                   mesh->vertex_count);
    if (mesh->normals)
        kg_bytes_print(out, "property float nx\nproperty float ny\nproperty float nz\n");
    /* The usual one byte for the number of corners, unless some face has too many. */
    uint32_t most = 0;
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t n = mesh->face_starts[f + 1] - mesh->face_starts[f];
        most = n > most ? n : most;
    }
    bool wide = most > UINT8_MAX;
    kg_bytes_print(out, "element face %zu\nproperty list %s int vertex_indices\nend_header\n",
                   mesh->face_count, wide ? "uint" : "uchar");
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const kg_vec3 *vectors[2] = {mesh->positions + v, mesh->normals ? mesh->normals + v : NULL};
        for (int i = 0; i < 2 && vectors[i]; i++) {
            kg_bytes_f32(out, vectors[i]->x);
            kg_bytes_f32(out, vectors[i]->y);
            kg_bytes_f32(out, vectors[i]->z);
        }
    }
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t begin = mesh->face_starts[f], end = mesh->face_starts[f + 1];
        unsigned char narrow = (unsigned char)(end - begin);
        if (wide)
            kg_bytes_u32(out, end - begin);
        else
            kg_bytes_put(out, &narrow, 1);
        for (uint32_t c = begin; c < end; c++)
            kg_bytes_u32(out, mesh->face_corners[c]);
    }
}
