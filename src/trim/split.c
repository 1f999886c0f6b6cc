/* Regions cut in two along a ruling, where a part is too large for its page. */
#include "katagami/trim.h"

#include "trim/region.h"

#include <stdlib.h>

static kg_status ruling_chain(const kg_patch *p, double v, int64_t source, kg_chains *chains) {
    /* a little longer than the rectangle, so that it crosses its sides */
    double over = 0.01 * p->size;
    kg_cross_point *points = calloc(2, sizeof *points);
    if (!points)
        return KG_ERR_MEMORY;
    for (int k = 0; k < 2; k++) {
        double u = k ? p->extent[1] + over : p->extent[0] - over;
        points[k] = (kg_cross_point){.u = u, .v = v, .x = kg_patch_point(p, u, v)};
    }
    return kg_chains_add(
        chains, (kg_chain){.kind = KG_EDGE_SPLIT, .source = source, .count = 2, .points = points});
}

kg_status kg_region_split(const kg_trim *trim, const kg_region *region, double v, int64_t source,
                          kg_regions *out_regions, kg_error *error) {
    kg_chains chains = {0};
    kg_arrangement a = {0};
    kg_regions pieces = {0};
    kg_status status = kg_region_chains(region, trim->finder, &chains);
    if (!status)
        status = ruling_chain(trim->patch, v, source, &chains);
    if (!status)
        status = kg_arrangement_build(trim->patch, &chains, &a);
    if (!status)
        status = kg_regions_from_faces(&a, NULL, NULL, &pieces);
    kg_arrangement_clear(&a);
    kg_chains_clear(&chains);
    return kg_trim_finish(status, &pieces, out_regions, error);
}
