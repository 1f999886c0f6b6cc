/*
 * STL, text and binary. The corners of its triangles are points, welded here where they are equal.
 *
 * OpenMesh's reader is not used: it leaves out triangles that it cannot read and thin ones without
 * a word, takes a file that is cut off for a whole one, and rounds text to single precision.
 */
#include "mesh/format.h"
#include "mesh/text.h"

#include <stdlib.h>
#include <string.h>

enum { HEADER_SIZE = 84, TRIANGLE_SIZE = 50 };

/* Open addressing over the positions of the builder; slots hold index + 1. */
typedef struct weld {
    uint32_t *slots;
    size_t slot_count; /* a power of two, 0 at first */
} weld;

static size_t hash_point(kg_vec3 p) {
    double c[3] = {p.x, p.y, p.z};
    uint64_t h = 0;
    for (int i = 0; i < 3; i++) {
        uint64_t bits;
        memcpy(&bits, &c[i], sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
    }
    return (size_t)h;
}

static uint32_t *find_slot(const weld *w, const kg_mesh_builder *b, kg_vec3 p) {
    size_t i = hash_point(p) & (w->slot_count - 1);
    for (; w->slots[i]; i = (i + 1) & (w->slot_count - 1)) {
        kg_vec3 q = b->positions.items[w->slots[i] - 1];
        if (p.x == q.x && p.y == q.y && p.z == q.z)
            break;
    }
    return &w->slots[i];
}

static bool grow(weld *w, const kg_mesh_builder *b) {
    weld larger = {NULL, w->slot_count ? w->slot_count * 2 : 1024};
    larger.slots = calloc(larger.slot_count, sizeof *larger.slots);
    if (!larger.slots)
        return false;
    for (size_t v = 0; v < b->positions.count; v++)
        *find_slot(&larger, b, b->positions.items[v]) = (uint32_t)v + 1;
    free(w->slots);
    *w = larger;
    return true;
}

static kg_status add_corner(weld *w, kg_mesh_builder *b, kg_vec3 p, size_t line, kg_error *error) {
    p = kg_v3(p.x + 0.0, p.y + 0.0, p.z + 0.0); /* -0 and 0 are the same place */
    if (b->positions.count >= w->slot_count / 2 && !grow(w, b))
        return kg_mesh_builder_memory(b, error);
    uint32_t *slot = find_slot(w, b, p);
    if (!*slot) {
        kg_status status = kg_mesh_builder_position(b, p, line, error);
        if (status)
            return status;
        *slot = (uint32_t)b->positions.count;
    }
    return kg_mesh_builder_corner(b, (int64_t)*slot - 1, error);
}

static uint32_t read_u32(const unsigned char *p) {
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static double read_f32(const unsigned char *p) {
    uint32_t bits = read_u32(p);
    float f;
    memcpy(&f, &bits, sizeof f);
    return (double)f;
}

static kg_status read_binary(const unsigned char *data, weld *w, kg_mesh_builder *b,
                             kg_error *error) {
    size_t count = read_u32(data + HEADER_SIZE - 4);
    kg_status status = KG_OK;
    for (size_t f = 0; f < count && !status; f++) {
        const unsigned char *corner = data + HEADER_SIZE + f * TRIANGLE_SIZE + 12;
        for (int i = 0; i < 3 && !status; i++, corner += 12)
            status = add_corner(w, b,
                                kg_v3(read_f32(corner), read_f32(corner + 4), read_f32(corner + 8)),
                                0, error);
        if (!status)
            status = kg_mesh_builder_end_face(b, 0, error);
        if (!status)
            status = kg_mesh_builder_at(b, HEADER_SIZE + (f + 1) * TRIANGLE_SIZE, error);
    }
    return status;
}

static bool same_ignoring_case(kg_word w, const char *lower) {
    if (w.n != strlen(lower))
        return false;
    for (size_t i = 0; i < w.n; i++) {
        if ((w.s[i] | 0x20) != lower[i])
            return false;
    }
    return true;
}

static kg_status read_text(const void *data, size_t size, weld *w, kg_mesh_builder *b,
                           kg_error *error) {
    kg_text t = kg_text_of(data, size, false);
    size_t corners = 0; /* of the open loop */
    bool open = false;
    kg_status status = KG_OK;
    do {
        kg_word word;
        kg_vec3 p;
        status = kg_mesh_builder_at(b, kg_text_offset(&t, data), error);
        if (status || !kg_text_word(&t, &word))
            continue;
        if (same_ignoring_case(word, "outer")) {
            open = true;
            corners = 0;
        } else if (same_ignoring_case(word, "vertex")) {
            if (!open || !kg_text_vec3(&t, &p))
                return kg_fail(error, KG_ERR_PARSE,
                               "%s:%zu: a vertex needs three numbers and stands in a loop", b->name,
                               t.line);
            status = add_corner(w, b, p, t.line, error);
            corners++;
        } else if (same_ignoring_case(word, "endloop")) {
            if (!open || corners != 3)
                return kg_fail(error, KG_ERR_PARSE, "%s:%zu: a loop needs three vertices", b->name,
                               t.line);
            open = false;
            status = kg_mesh_builder_end_face(b, t.line, error);
        }
    } while (!status && kg_text_next_line(&t));
    if (!status && open)
        return kg_fail(error, KG_ERR_PARSE, "%s:%zu: the file ends within a triangle", b->name,
                       t.line);
    return status;
}

kg_status kg_stl_read(const void *data, size_t size, kg_mesh_builder *b, kg_error *error) {
    weld w = {0};
    /* Binary files may start with "solid" as well, so their size decides; some have a tail. */
    bool solid = size >= 5 && same_ignoring_case((kg_word){data, 5}, "solid");
    size_t room = size >= HEADER_SIZE ? (size - HEADER_SIZE) / TRIANGLE_SIZE : 0;
    size_t promised = 0;
    if (size >= HEADER_SIZE)
        promised = read_u32((const unsigned char *)data + HEADER_SIZE - 4);
    bool exact = size >= HEADER_SIZE && promised * TRIANGLE_SIZE == size - HEADER_SIZE;
    kg_status status;
    if (solid && !exact)
        status = read_text(data, size, &w, b, error);
    else if (size >= HEADER_SIZE && promised <= room)
        status = read_binary(data, &w, b, error);
    else
        status = kg_fail(error, KG_ERR_PARSE,
                         "%s: the file ends early: its header counts %zu triangles and there is "
                         "room for %zu",
                         b->name, promised, room);
    free(w.slots);
    return status;
}

void kg_stl_write(const kg_mesh *mesh, const uint32_t *triangles, kg_bytes *out) {
    char header[HEADER_SIZE - 4] = "binary STL by katagami, mm";
    size_t count = kg_mesh_triangle_count(mesh);
    kg_bytes_put(out, header, sizeof header);
    kg_bytes_u32(out, (uint32_t)count);
    for (size_t t = 0; t < count; t++, triangles += 3) {
        kg_vec3 p[4];
        for (int i = 0; i < 3; i++)
            p[i + 1] = mesh->positions[triangles[i]];
        p[0] = kg_unit(kg_cross(kg_sub(p[2], p[1]), kg_sub(p[3], p[1])));
        for (int i = 0; i < 4; i++) {
            kg_bytes_f32(out, p[i].x);
            kg_bytes_f32(out, p[i].y);
            kg_bytes_f32(out, p[i].z);
        }
        kg_bytes_u16(out, 0);
    }
}
