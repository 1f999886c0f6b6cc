/*
 * Dense polylines turned into few cubic Béziers.
 *
 * Between corners the curve is cut into the longest stretches that one cubic can follow. A cubic
 * has the polyline's end points and end tangents, so that stretches meet smoothly (G1); its two
 * handle lengths are found by Gauss-Newton on the distances along the normals at the foot points
 * (tangent distance minimisation: Wang, Pottmann, Liu 2006, "Fitting B-spline curves to point
 * clouds by curvature-based squared distance minimization", section 4; the splitting follows
 * Schneider 1990, "An algorithm for automatically fitting digitized curves"). Where nothing else
 * follows the polyline within the tolerance its own chords are written.
 */
#ifndef KG_NET_FIT_H
#define KG_NET_FIT_H

#include "net/path.h"

/*
 * Appends the curve through points[0..count) to `path`: a move, lines and curves, and a close when
 * `closed`. corners[i] != 0 where the direction breaks (NULL: at every point); the ends of an open
 * line are corners in any case.
 *
 * tolerance: mm, > 0; the greatest distance of the path from the true curve, of which the polyline
 * is off by at most a fifth (the rest is for the fit). Straight stretches become lines. Works for
 * any finite input, points that repeat included; what has no length becomes nothing. Errors:
 * KG_ERR_MEMORY.
 */
kg_status kg_fit(const kg_vec2 *points, const unsigned char *corners, size_t count, bool closed,
                 double tolerance, kg_path *path, kg_error *error) KG_CHECKED;

#endif
