/*
 * Triangles of trimmed regions.
 *
 * All vertices lie on the boundary, so neighbours that share boundary points share vertices. On a
 * developable surface nothing is lost by that: a triangle is exact along its rulings, so the
 * triangles only have to follow them. A constrained Delaunay triangulation in a plane where u is
 * shrunk joins points of nearly the same v: its edges are nearly rulings.
 */
#include "katagami/trim.h"

#include <geos_c.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How much shorter u counts than v L: a ruling as long as the geodesic then counts as a hundredth
 * of it, less than a sample step where the surface bends. */
#define SHRINK 0.01

typedef struct vertex {
    double x, y;
    uint32_t index;
} vertex;

typedef struct triangulation {
    GEOSContextHandle_t geos;
    const kg_patch *patch;
    char message[256];
    size_t count;
    vertex *sorted; /* by x, then y */
} triangulation;

static void on_error(const char *message, void *user) {
    triangulation *t = user;
    snprintf(t->message, sizeof t->message, "%s", message);
}

static kg_vec2 flat(const kg_patch *p, const kg_cross_point *q) {
    return kg_v2(SHRINK * q->u, q->v * p->length_at[KG_PATCH_CELLS]);
}

static int compare_vertices(const void *x, const void *y) {
    const vertex *a = x, *b = y;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return a->y < b->y ? -1 : a->y > b->y;
}

static GEOSGeometry *make_ring(triangulation *t, const kg_region_loop *loop) {
    GEOSCoordSequence *s = GEOSCoordSeq_create_r(t->geos, (unsigned)loop->point_count + 1, 2);
    for (size_t i = 0; s && i <= loop->point_count; i++) {
        kg_vec2 q = flat(t->patch, &loop->points[i % loop->point_count]);
        GEOSCoordSeq_setXY_r(t->geos, s, (unsigned)i, q.x, q.y);
    }
    return s ? GEOSGeom_createLinearRing_r(t->geos, s) : NULL;
}

static GEOSGeometry *make_polygon(triangulation *t, const kg_region *region) {
    size_t holes = region->loop_count - 1;
    GEOSGeometry **rings = calloc(region->loop_count, sizeof *rings);
    bool ok = rings != NULL;
    for (size_t i = 0; i < region->loop_count && ok; i++)
        ok = (rings[i] = make_ring(t, &region->loops[i])) != NULL;
    GEOSGeometry *polygon =
        ok ? GEOSGeom_createPolygon_r(t->geos, rings[0], rings + 1, (unsigned)holes) : NULL;
    for (size_t i = 0; i < region->loop_count && rings && !ok; i++)
        if (rings[i])
            GEOSGeom_destroy_r(t->geos, rings[i]);
    free(rings);
    return polygon;
}

/* Index of the boundary point at a place of the flat plane; false for a place that is none. */
static bool find_vertex(const triangulation *t, double x, double y, uint32_t *out) {
    vertex key = {x, y, 0};
    const vertex *v = bsearch(&key, t->sorted, t->count, sizeof key, compare_vertices);
    if (v)
        *out = v->index;
    return v != NULL;
}

static bool add_triangle(const triangulation *t, const GEOSGeometry *triangle, uint32_t *out) {
    const GEOSGeometry *ring = GEOSGetExteriorRing_r(t->geos, triangle);
    const GEOSCoordSequence *s = ring ? GEOSGeom_getCoordSeq_r(t->geos, ring) : NULL;
    kg_vec2 corner[3];
    for (unsigned i = 0; i < 3; i++)
        if (!s || !GEOSCoordSeq_getXY_r(t->geos, s, i, &corner[i].x, &corner[i].y) ||
            !find_vertex(t, corner[i].x, corner[i].y, &out[i]))
            return false;
    double area = kg_cross2(kg_sub2(corner[1], corner[0]), kg_sub2(corner[2], corner[0]));
    /* counter-clockwise in (u,v) is counter-clockwise seen from the back of an unflipped patch */
    if ((area > 0) != t->patch->flip) {
        uint32_t swap = out[1];
        out[1] = out[2];
        out[2] = swap;
    }
    return true;
}

static kg_status triangulate(triangulation *t, const kg_region *region, kg_tessellation *out) {
    GEOSGeometry *polygon = make_polygon(t, region);
    GEOSGeometry *all = polygon ? GEOSConstrainedDelaunayTriangulation_r(t->geos, polygon) : NULL;
    kg_status status = all ? KG_OK : KG_ERR_INPUT;
    int count = all ? GEOSGetNumGeometries_r(t->geos, all) : 0;
    out->triangles = calloc((size_t)(count > 0 ? count : 1), 3 * sizeof *out->triangles);
    if (!out->triangles)
        status = KG_ERR_MEMORY;
    for (int i = 0; i < count && !status; i++) {
        if (!add_triangle(t, GEOSGetGeometryN_r(t->geos, all, i),
                          out->triangles + 3 * out->triangle_count))
            status = KG_ERR_INPUT;
        else
            out->triangle_count++;
    }
    if (all)
        GEOSGeom_destroy_r(t->geos, all);
    if (polygon)
        GEOSGeom_destroy_r(t->geos, polygon);
    return status;
}

kg_status kg_region_tessellate(const kg_patch *patch, const kg_region *region,
                               kg_tessellation *out_tessellation, kg_error *error) {
    kg_tessellation out = {0};
    triangulation t = {.patch = patch};
    for (size_t i = 0; i < region->loop_count; i++)
        t.count += region->loops[i].point_count;
    out.vertices = calloc(t.count + 1, sizeof *out.vertices);
    t.sorted = calloc(t.count + 1, sizeof *t.sorted);
    t.geos = GEOS_init_r();
    kg_status status = out.vertices && t.sorted && t.geos ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < region->loop_count && !status; i++)
        for (size_t k = 0; k < region->loops[i].point_count; k++) {
            const kg_cross_point *q = &region->loops[i].points[k];
            kg_vec2 at = flat(patch, q);
            t.sorted[out.vertex_count] = (vertex){at.x, at.y, (uint32_t)out.vertex_count};
            out.vertices[out.vertex_count++] =
                (kg_vertex){q->x, kg_patch_normal(patch, q->v), q->u, q->v};
        }
    if (!status) {
        GEOSContext_setErrorMessageHandler_r(t.geos, on_error, &t);
        qsort(t.sorted, t.count, sizeof *t.sorted, compare_vertices);
        status = triangulate(&t, region, &out);
    }
    if (t.geos)
        GEOS_finish_r(t.geos);
    free(t.sorted);
    if (status) {
        kg_tessellation_clear(&out);
        return kg_fail(error, status,
                       status == KG_ERR_MEMORY ? "out of memory"
                                               : "its outline cannot be triangulated (%s)",
                       t.message[0] ? t.message : "it touches itself");
    }
    *out_tessellation = out;
    return KG_OK;
}

void kg_tessellation_clear(kg_tessellation *t) {
    free(t->vertices);
    free(t->triangles);
    *t = (kg_tessellation){0};
}
