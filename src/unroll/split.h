/* Regions too large for a page, cut along rulings. */
#ifndef KG_UNROLL_SPLIT_H
#define KG_UNROLL_SPLIT_H

#include "katagami/unroll.h"

/* Cuts a region along rulings until every piece fits the room (mm, in any turn), and adds the
 * pieces to `out`. A region that fits already, or that no ruling makes smaller, adds nothing.
 *   source  number of the next cut; counts up */
kg_status kg_split_to_fit(const kg_trim *trim, const kg_region *region, kg_vec2 room,
                          int64_t *source, kg_regions *out, kg_error *error) KG_CHECKED;

#endif
