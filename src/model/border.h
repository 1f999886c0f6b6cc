/* Is a point on the border of a region? */
#ifndef KG_MODEL_BORDER_H
#define KG_MODEL_BORDER_H

#include "katagami/trim.h"

/* Does (u, v) of a patch lie within `near` mm of an edge's polyline? Distances are taken in the
 * plane (u, v L), L the length of the geodesic.
 *   of_cutter  the edge is a cut by that patch: compare with its s, t; else with its u, v */
bool kg_edge_near(const kg_patch *patch, const kg_region_loop *loop, const kg_region_edge *edge,
                  bool of_cutter, double u, double v, double near);

/* The same of all edges of a loop of this patch. */
bool kg_loop_near(const kg_patch *patch, const kg_region_loop *loop, double u, double v,
                  double near);

#endif
