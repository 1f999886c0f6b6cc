/* Convex polygons in the plane, counter-clockwise. */
#ifndef KG_ORIGAMI_CONVEX_H
#define KG_ORIGAMI_CONVEX_H

#include "katagami/base.h"

/* The interiors overlap, and not by less than `tolerance` in any direction normal to a side
 * (separating axes: sides of both). */
bool kg_convex_overlap(const kg_vec2 *p, size_t p_count, const kg_vec2 *q, size_t q_count,
                       double tolerance);

/* The point is inside, farther than `tolerance` from every side. */
bool kg_convex_holds(const kg_vec2 *p, size_t p_count, kg_vec2 point, double tolerance);

/* The part of `p` where  dot(m, x) >= offset;  `out` holds p_count + 2. Returns its count, 0 when
 * nothing is left (Sutherland and Hodgman 1974). */
size_t kg_convex_clip(const kg_vec2 *p, size_t p_count, kg_vec2 m, double offset, kg_vec2 *out);

/* The common part of two; `out` and `scratch` hold p_count + q_count + 2
 * each. Returns its count. */
size_t kg_convex_common(const kg_vec2 *p, size_t p_count, const kg_vec2 *q, size_t q_count,
                        kg_vec2 *out, kg_vec2 *scratch);

double kg_polygon_area(const kg_vec2 *p, size_t count);

/* Right-handed axes of the plane with unit normal `n`; x and y themselves when n is z. */
void kg_plane_axes(kg_vec3 n, kg_vec3 *out_u, kg_vec3 *out_v);

#endif
