/* Is a point on the border of a region? */
#ifndef KG_MODEL_BORDER_H
#define KG_MODEL_BORDER_H

#include "katagami/trim.h"

/* Does (u, v) lie within `near` mm of this run of the loop's chords (a whole edge, or the loop from
 * 0 to point_count)? Distances are taken in the plane (u, v L), L the length of the geodesic. */
bool kg_loop_near(const kg_patch *patch, const kg_region_loop *loop, size_t first, size_t count,
                  double u, double v, double near);

#endif
