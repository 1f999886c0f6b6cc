/*
 * Faces into triangles by ear clipping: G. H. Meisters, "Polygons have ears", The American
 * Mathematical Monthly 82 (1975), 648-651.
 */
#include "katagami/mesh.h"

#include <stdlib.h>

/* Point-in-ear tests spent on one mesh (about half a second). Ears of n-gons cost n tests each, so
 * only faces of ten thousands of concave corners get there; their last ears are cut untested. */
static const size_t most_tests = (size_t)1 << 26;

typedef struct ring {
    kg_vec2 *points; /* in the plane of projection, counter-clockwise */
    uint32_t *next, *prev;
    bool *reflex;        /* not strictly convex */
    size_t reflex_count; /* among those still there */
    size_t tests;
} ring;

static double turn(const ring *r, uint32_t i) {
    kg_vec2 a = r->points[r->prev[i]], b = r->points[i], c = r->points[r->next[i]];
    return kg_cross2(kg_sub2(b, a), kg_sub2(c, b));
}

static void update_reflex(ring *r, uint32_t i) {
    bool reflex = !(turn(r, i) > 0);
    r->reflex_count += (size_t)reflex;
    r->reflex_count -= (size_t)r->reflex[i];
    r->reflex[i] = reflex;
}

static bool same(kg_vec2 a, kg_vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/* In the closed triangle; a corner in the same place as one of it does not count, so that faces
 * that touch themselves (bridges to holes) have ears. */
static bool is_inside(kg_vec2 a, kg_vec2 b, kg_vec2 c, kg_vec2 p) {
    return !same(p, a) && !same(p, b) && !same(p, c) &&
           kg_cross2(kg_sub2(b, a), kg_sub2(p, a)) >= 0 &&
           kg_cross2(kg_sub2(c, b), kg_sub2(p, b)) >= 0 &&
           kg_cross2(kg_sub2(a, c), kg_sub2(p, c)) >= 0;
}

static bool is_ear(ring *r, uint32_t i) {
    if (r->reflex[i])
        return false;
    if (!r->reflex_count || r->tests >= most_tests)
        return true;
    uint32_t before = r->prev[i], after = r->next[i];
    for (uint32_t j = r->next[after]; j != before; j = r->next[j]) {
        r->tests++;
        if (r->reflex[j] &&
            is_inside(r->points[before], r->points[i], r->points[after], r->points[j]))
            return false;
    }
    return true;
}

/* The next corner to cut off: an ear, else (self-crossing, or rounded flat) a convex corner, else
 * any. */
static uint32_t find_ear(ring *r, uint32_t start) {
    uint32_t convex = start, i = start;
    bool has_convex = false;
    do {
        if (is_ear(r, i))
            return i;
        if (!r->reflex[i] && !has_convex) {
            convex = i;
            has_convex = true;
        }
        i = r->next[i];
    } while (i != start);
    return convex;
}

/* The corners seen along the axis closest to the Newell normal: exact, and it keeps every order. */
static void project(const kg_mesh *mesh, const uint32_t *corners, size_t n, kg_vec2 *points) {
    kg_vec3 normal = kg_v3(0, 0, 0), origin = mesh->positions[corners[0]];
    for (size_t i = 1; i + 1 < n; i++)
        normal = kg_add(normal, kg_cross(kg_sub(mesh->positions[corners[i]], origin),
                                         kg_sub(mesh->positions[corners[i + 1]], origin)));
    double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    for (size_t i = 0; i < n; i++) {
        kg_vec3 p = kg_sub(mesh->positions[corners[i]], origin);
        if (x > y && x > z)
            points[i] = normal.x > 0 ? kg_v2(p.y, p.z) : kg_v2(p.z, p.y);
        else if (y > z)
            points[i] = normal.y > 0 ? kg_v2(p.z, p.x) : kg_v2(p.x, p.z);
        else
            points[i] = normal.z < 0 ? kg_v2(p.y, p.x) : kg_v2(p.x, p.y);
    }
}

static void cut(const kg_mesh *mesh, const uint32_t *corners, size_t n, ring *r, uint32_t *out) {
    project(mesh, corners, n, r->points);
    for (uint32_t i = 0; i < n; i++) {
        r->next[i] = i + 1 < n ? i + 1 : 0;
        r->prev[i] = i ? i - 1 : (uint32_t)n - 1;
        r->reflex[i] = false;
    }
    r->reflex_count = 0;
    for (uint32_t i = 0; i < n; i++)
        update_reflex(r, i);
    uint32_t at = 0;
    for (size_t left = n; left > 3; left--) {
        uint32_t ear = find_ear(r, at), before = r->prev[ear], after = r->next[ear];
        *out++ = corners[before];
        *out++ = corners[ear];
        *out++ = corners[after];
        r->reflex_count -= (size_t)r->reflex[ear];
        r->next[before] = after;
        r->prev[after] = before;
        update_reflex(r, before);
        update_reflex(r, after);
        at = r->next[after]; /* not the neighbour: that would make a fan of slivers */
    }
    *out++ = corners[r->prev[at]];
    *out++ = corners[at];
    *out++ = corners[r->next[at]];
}

size_t kg_mesh_triangle_count(const kg_mesh *mesh) {
    return mesh->face_count ? mesh->face_starts[mesh->face_count] - 2 * mesh->face_count : 0;
}

kg_status kg_mesh_triangulate(const kg_mesh *mesh, uint32_t *out_corners, uint32_t *out_faces,
                              kg_error *error) {
    size_t most = 0;
    for (size_t f = 0; f < mesh->face_count; f++) {
        size_t n = mesh->face_starts[f + 1] - mesh->face_starts[f];
        most = n > most ? n : most;
    }
    ring r = {.points = malloc((most + 1) * sizeof *r.points),
              .next = malloc((most + 1) * sizeof *r.next),
              .prev = malloc((most + 1) * sizeof *r.prev),
              .reflex = malloc((most + 1) * sizeof *r.reflex)};
    bool ok = r.points && r.next && r.prev && r.reflex;
    for (size_t f = 0; ok && f < mesh->face_count; f++) {
        const uint32_t *corners = mesh->face_corners + mesh->face_starts[f];
        size_t n = mesh->face_starts[f + 1] - mesh->face_starts[f];
        if (n == 3) {
            for (int i = 0; i < 3; i++)
                out_corners[i] = corners[i];
        } else {
            cut(mesh, corners, n, &r, out_corners);
        }
        out_corners += 3 * (n - 2);
        for (size_t i = 0; out_faces && i + 2 < n; i++)
            *out_faces++ = (uint32_t)f;
    }
    free(r.points);
    free(r.next);
    free(r.prev);
    free(r.reflex);
    return ok ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for its triangles");
}
