/* A turned shape as runs of grid cells; every cell the shape touches is in a run. */
#ifndef KG_NET_NEST_RASTER_H
#define KG_NET_NEST_RASTER_H

#include "katagami/base.h"

/* Cells lo..hi of one row; cell (0,0) has the origin as its lower corner. */
typedef struct kg_nest_run {
    int row, lo, hi;
} kg_nest_run;

typedef struct kg_nest_raster {
    kg_nest_run *runs;
    size_t count;
} kg_nest_raster;

/* A simplified polygon with holes: loops one after the other, loop k being
 * points[ends[k-1] .. ends[k]-1]. */
typedef struct kg_nest_shape {
    kg_vec2 *points;
    size_t *ends;
    size_t loop_count;
} kg_nest_shape;

/* The shape turned by `angle` and moved so that its bounding box begins at (0,0); out_size is that
 * box's size, out_offset what was added after turning. `out_points` has room for every point. */
void kg_nest_shape_turn(const kg_nest_shape *shape, double angle, kg_vec2 *out_points,
                        kg_vec2 *out_offset, kg_vec2 *out_size);

/* All cells (of edge `cell` mm) of `window` within `reach` mm of the polygon `points`, which has
 * the loops of `shape`; window NULL: wherever they are. Runs are sorted longest first, where a
 * collision shows soonest. The caller frees out->runs. */
kg_status kg_nest_raster_make(const kg_nest_shape *shape, const kg_vec2 *points, double cell,
                              double reach, const kg_box2 *window, kg_nest_raster *out) KG_CHECKED;

#endif
