/*
 * Triangles of trimmed regions.
 *
 * All vertices lie on the boundary, so neighbours that share boundary points share vertices. On a
 * developable surface nothing is lost by that: a triangle is exact along its rulings, so the
 * triangles only have to follow them.
 */
#include "katagami/trim.h"

#include "base/phrase.h"
#include "trim/chain.h"
#include "trim/triangulation.h"

#include <stdlib.h>

static void fill_vertices(const kg_patch *patch, const kg_region *region, kg_tessellation *t,
                          kg_vec2 *points, kg_vec2 *paper, size_t *ends) {
    for (size_t i = 0; i < region->loop_count; i++) {
        const kg_region_loop *loop = &region->loops[i];
        for (size_t k = 0; k < loop->point_count; k++) {
            const kg_cross_point *q = &loop->points[k];
            points[t->vertex_count] = kg_plane(patch, q->u, q->v);
            paper[t->vertex_count] = kg_patch_unroll(patch, q->u, q->v);
            t->vertices[t->vertex_count++] =
                (kg_vertex){q->x, kg_patch_normal(patch, q->v), q->u, q->v};
        }
        ends[i] = t->vertex_count;
    }
}

/* Counter-clockwise in (u,v) is counter-clockwise seen from the back of an unflipped patch. */
static void turn_over(kg_tessellation *t) {
    for (size_t i = 0; i < t->triangle_count; i++) {
        uint32_t swap = t->triangles[3 * i + 1];
        t->triangles[3 * i + 1] = t->triangles[3 * i + 2];
        t->triangles[3 * i + 2] = swap;
    }
}

kg_status kg_region_tessellate(const kg_patch *patch, const kg_region *region,
                               kg_tessellation *out_tessellation, kg_error *error) {
    kg_polygon polygon = {.loop_count = region->loop_count};
    for (size_t i = 0; i < region->loop_count; i++)
        polygon.count += region->loops[i].point_count;
    if (polygon.count < 3)
        return kg_fail(error, KG_ERR_INPUT, "its outline has no area");
    polygon.snap = KG_NODE_SNAP * patch->size;
    kg_tessellation out = {0};
    out.vertices = calloc(polygon.count, sizeof *out.vertices);
    out.triangles = calloc(kg_triangle_limit(&polygon), 3 * sizeof *out.triangles);
    kg_vec2 *points = calloc(polygon.count, 2 * sizeof *points);
    size_t *ends = calloc(region->loop_count, sizeof *ends);
    kg_status status = out.vertices && out.triangles && points && ends ? KG_OK : KG_ERR_MEMORY;
    if (!status) {
        fill_vertices(patch, region, &out, points, points + polygon.count, ends);
        polygon.points = points;
        polygon.paper = points + polygon.count;
        polygon.ends = ends;
        status = kg_monotone_triangulate(&polygon, out.triangles, &out.triangle_count);
    }
    if (!status)
        status = kg_ruling_flips(&polygon, out.triangles, out.triangle_count);
    free(points);
    free(ends);
    if (status) {
        kg_tessellation_clear(&out);
        return kg_fail(error, status,
                       status == KG_ERR_MEMORY ? N_("out of memory")
                                               : N_("its outline crosses itself and cannot be "
                                                    "divided into triangles"));
    }
    if (!patch->flip)
        turn_over(&out);
    *out_tessellation = out;
    return KG_OK;
}

void kg_tessellation_clear(kg_tessellation *t) {
    free(t->vertices);
    free(t->triangles);
    *t = (kg_tessellation){0};
}
