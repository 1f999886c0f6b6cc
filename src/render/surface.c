#include "katagami/render.h"

#include "base/progress.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A side of a face at which it may meet another. */
typedef struct edge {
    uint32_t low, high;    /* its vertices */
    uint32_t corner, next; /* the face's corners at the edge's start and end */
    uint32_t face;
} edge;

/* Everything between a mesh and a surface. Corners of one vertex that share a normal form a class
 * (a union-find forest in `parents`); a class becomes a vertex of the surface. */
typedef struct splitter {
    kg_mesh mesh;          /* a view of the wanted faces */
    uint32_t first, count; /* their corners in mesh.face_corners */
    uint32_t *parents;     /* by corner - first */
    kg_vec3 *face_normals; /* Newell: twice the area long */
    uint32_t *vertices;    /* by corner - first: index of a root's vertex in the surface */
    uint32_t *corner_at;   /* by mesh vertex: a corner of the face at hand */
    uint32_t *triangles, *faces;
} splitter;

static void release(splitter *s) {
    free(s->parents);
    free(s->face_normals);
    free(s->vertices);
    free(s->corner_at);
    free(s->triangles);
    free(s->faces);
}

static uint32_t root_of(uint32_t *parents, uint32_t c) {
    while (parents[c] != c) {
        parents[c] = parents[parents[c]];
        c = parents[c];
    }
    return c;
}

static void join(uint32_t *parents, uint32_t a, uint32_t b) {
    a = root_of(parents, a);
    b = root_of(parents, b);
    /* The lower index leads, whatever the order of the joins. */
    if (a < b)
        parents[b] = a;
    else
        parents[a] = b;
}

static void find_face_normals(splitter *s) {
    const kg_mesh *m = &s->mesh;
    for (size_t f = 0; f < m->face_count; f++) {
        uint32_t begin = m->face_starts[f], end = m->face_starts[f + 1];
        kg_vec3 o = m->positions[m->face_corners[begin]], sum = kg_v3(0, 0, 0);
        for (uint32_t c = begin + 1; c + 1 < end; c++) {
            kg_vec3 a = kg_sub(m->positions[m->face_corners[c]], o);
            kg_vec3 b = kg_sub(m->positions[m->face_corners[c + 1]], o);
            sum = kg_add(sum, kg_cross(a, b));
        }
        s->face_normals[f] = sum;
    }
}

static int compare_edges(const void *a, const void *b) {
    const edge *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return p->corner < q->corner ? -1 : p->corner > q->corner;
}

/* Joins corners across every edge bent by less than `crease`. */
static bool join_smooth(splitter *s, double crease) {
    const kg_mesh *m = &s->mesh;
    edge *edges = calloc((size_t)s->count + 1, sizeof *edges);
    if (!edges)
        return false;
    for (uint32_t f = 0; f < m->face_count; f++) {
        uint32_t begin = m->face_starts[f], end = m->face_starts[f + 1];
        for (uint32_t c = begin; c < end; c++) {
            uint32_t next = c + 1 < end ? c + 1 : begin;
            uint32_t a = m->face_corners[c], b = m->face_corners[next];
            edges[c - s->first] =
                (edge){a < b ? a : b, a < b ? b : a, c - s->first, next - s->first, f};
        }
    }
    qsort(edges, s->count, sizeof *edges, compare_edges);
    double least = cos(crease);
    for (uint32_t i = 0; i + 1 < s->count; i++) {
        const edge *p = &edges[i], *q = &edges[i + 1];
        if (p->low != q->low || p->high != q->high)
            continue;
        const uint32_t *vertex = m->face_corners + s->first;
        if (vertex[p->corner] == vertex[q->corner])
            continue; /* turned against each other: no common side to be smooth on */
        kg_vec3 n = kg_unit(s->face_normals[p->face]), o = kg_unit(s->face_normals[q->face]);
        if (kg_dot(n, o) > least) {
            join(s->parents, p->corner, q->next);
            join(s->parents, p->next, q->corner);
        }
    }
    free(edges);
    return true;
}

/* Joins all corners of each vertex. */
static void join_vertices(splitter *s) {
    const uint32_t *vertex = s->mesh.face_corners + s->first;
    memset(s->corner_at, 0xff, s->mesh.vertex_count * sizeof *s->corner_at);
    for (uint32_t c = 0; c < s->count; c++) {
        if (s->corner_at[vertex[c]] == UINT32_MAX)
            s->corner_at[vertex[c]] = c;
        else
            join(s->parents, c, s->corner_at[vertex[c]]);
    }
}

static kg_status triangulate(splitter *s, size_t *out_count, kg_error *error) {
    const kg_mesh *m = &s->mesh;
    size_t count = s->count - 2 * m->face_count; /* n - 2 of every n-gon */
    s->triangles = calloc(count + 1, 3 * sizeof *s->triangles);
    s->faces = calloc(count + 1, sizeof *s->faces);
    if (!s->triangles || !s->faces)
        return kg_fail(error, KG_ERR_MEMORY, "no memory for %zu triangles", count);
    *out_count = count;
    return kg_mesh_triangulate(m, s->triangles, s->faces, error);
}

/* Fills the surface's vertices, one per class, with the mean of its faces' normals by area. */
static void fill_vertices(splitter *s, bool own_normals, kg_surface *surface) {
    const kg_mesh *m = &s->mesh;
    size_t n = 0;
    for (uint32_t f = 0; f < m->face_count; f++) {
        for (uint32_t c = m->face_starts[f] - s->first; c < m->face_starts[f + 1] - s->first; c++) {
            uint32_t root = root_of(s->parents, c), vertex = m->face_corners[s->first + c];
            if (root == c) {
                s->vertices[c] = (uint32_t)n;
                surface->positions[n] = m->positions[vertex];
                surface->normals[n++] = own_normals ? m->normals[vertex] : kg_v3(0, 0, 0);
            }
            kg_vec3 *normal = &surface->normals[s->vertices[root]];
            if (!own_normals)
                *normal = kg_add(*normal, s->face_normals[f]);
        }
    }
    for (size_t i = 0; i < n; i++)
        surface->normals[i] = kg_unit(surface->normals[i]);
    surface->vertex_count = n;
}

static void fill_triangles(splitter *s, kg_surface *surface) {
    const kg_mesh *m = &s->mesh;
    uint32_t at_hand = UINT32_MAX;
    for (size_t t = 0; t < surface->triangle_count; t++) {
        if (s->faces[t] != at_hand) {
            at_hand = s->faces[t];
            for (uint32_t c = m->face_starts[at_hand]; c < m->face_starts[at_hand + 1]; c++)
                s->corner_at[m->face_corners[c]] = c - s->first;
        }
        for (size_t k = 3 * t; k < 3 * t + 3; k++) {
            uint32_t corner = s->corner_at[s->triangles[k]];
            surface->triangles[k] = s->vertices[root_of(s->parents, corner)];
        }
    }
}

kg_status kg_surface_from_mesh(const kg_mesh *mesh, size_t first_face, size_t face_count,
                               double crease, const kg_progress *progress, kg_surface *out_surface,
                               kg_error *error) {
    assert(first_face <= mesh->face_count && face_count <= mesh->face_count - first_face);
    splitter s = {.mesh = *mesh};
    kg_surface surface = {0};
    s.mesh.face_count = face_count;
    if (face_count > 0) {
        s.mesh.face_starts = mesh->face_starts + first_face;
        s.first = s.mesh.face_starts[0];
        s.count = s.mesh.face_starts[face_count] - s.first;
    }
    size_t corners = (size_t)s.count + 1; /* never nothing to allocate */
    s.parents = calloc(corners, sizeof *s.parents);
    s.vertices = calloc(corners, sizeof *s.vertices);
    s.face_normals = calloc(face_count + 1, sizeof *s.face_normals);
    s.corner_at = calloc(mesh->vertex_count + 1, sizeof *s.corner_at);
    surface.positions = calloc(corners, sizeof *surface.positions);
    surface.normals = calloc(corners, sizeof *surface.normals);
    kg_status status = KG_ERR_MEMORY;
    if (!s.parents || !s.vertices || !s.face_normals || !s.corner_at || !surface.positions ||
        !surface.normals)
        goto done;
    for (uint32_t c = 0; c < s.count; c++)
        s.parents[c] = c;
    find_face_normals(&s);
    if ((status = kg_progress_tell(progress, 0.1, "surface", error)))
        goto done;
    bool own_normals = mesh->normals && crease > 0;
    if (own_normals)
        join_vertices(&s);
    else if (crease > 0 && !join_smooth(&s, crease))
        status = KG_ERR_MEMORY;
    if (!status)
        status = kg_progress_tell(progress, 0.8, "surface", error);
    if (!status)
        status = triangulate(&s, &surface.triangle_count, error);
    if (!status)
        status = kg_progress_tell(progress, 0.9, "surface", error);
    if (status)
        goto done;
    surface.triangles = calloc(surface.triangle_count + 1, 3 * sizeof *surface.triangles);
    if (!surface.triangles) {
        status = KG_ERR_MEMORY;
        goto done;
    }
    fill_vertices(&s, own_normals, &surface);
    fill_triangles(&s, &surface);
done:
    release(&s);
    if (status) {
        kg_surface_destroy(&surface);
        return status == KG_ERR_MEMORY
                   ? kg_fail(error, status, "no memory to draw a mesh of %zu faces", face_count)
                   : status;
    }
    *out_surface = surface;
    return KG_OK;
}

void kg_surface_destroy(kg_surface *surface) {
    if (!surface)
        return;
    free(surface->positions);
    free(surface->normals);
    free(surface->triangles);
    *surface = (kg_surface){0};
}
