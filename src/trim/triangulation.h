/* Triangles of plane polygons with holes, without points of their own. */
#ifndef KG_TRIM_TRIANGULATION_H
#define KG_TRIM_TRIANGULATION_H

#include "katagami/base.h"

/* A region of a patch: loops one after the other, the outer one counter-clockwise, holes
 * clockwise. Rulings, the lines y = const of the plane, are straight on paper too. */
typedef struct kg_polygon {
    const kg_vec2 *points; /* in the plane (u, v L), where the sweep goes */
    const kg_vec2 *paper;  /* unrolled, where triangles must not turn over */
    size_t count;
    const size_t *ends; /* per loop: index after its last point */
    size_t loop_count;
    double snap; /* points of two loops nearer than this are one */
} kg_polygon;

/* The most triangles there can be. */
static inline size_t kg_triangle_limit(const kg_polygon *p) {
    return p->count + 2 * p->loop_count - 4;
}

/* Divides a polygon into triangles by a sweep in y (de Berg et al., "Computational Geometry",
 * chapter 3: monotone pieces, then their triangles). Loops may touch each other in points. `out`:
 * room for 3 kg_triangle_limit indices; triangles are counter-clockwise. KG_ERR_INPUT: loops that
 * cross. */
kg_status kg_monotone_triangulate(const kg_polygon *polygon, uint32_t *out,
                                  size_t *out_count) KG_CHECKED;

/* Flips edges until they follow the lines y = const as nearly as the points allow: until the
 * triangles are the lower hull of (x, y, y²), the best triangulation of a surface that bends along
 * y alone. That is the limit of constrained Delaunay triangulations where x is shrunk to nothing.
 */
kg_status kg_ruling_flips(const kg_polygon *polygon, uint32_t *triangles,
                          size_t triangle_count) KG_CHECKED;

#endif
