/* How a part is bent: how tightly, which way, and around which lines. */
#ifndef KG_GUIDE_BEND_H
#define KG_GUIDE_BEND_H

#include "guide/assembly.h"

typedef struct kg_bend {
    double radius_in, radius_out; /* mm, least where the front is hollow, bulges; infinite: never */
} kg_bend;

/* From the vertices of a piece. The surface bends only across its rulings, by 1/r = |n'| / |X_v x
 * d|; along one ruling r changes linearly, so its least value is on the boundary. */
kg_bend kg_bend_of(const kg_patch *patch, const kg_tessellation *piece);

/* Fills the part's rulings: the stretches of some, evenly spread, that lie in the region. A flat
 * patch has none. KG_ERR_MEMORY. */
kg_status kg_bend_rulings(const kg_patch *patch, const kg_region *region,
                          kg_assembly_part *part) KG_CHECKED;

#endif
