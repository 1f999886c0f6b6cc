/* What regions and trims share. */
#ifndef KG_TRIM_REGION_H
#define KG_TRIM_REGION_H

#include "trim/arrangement.h"

/* Points of the straight (u,v) segment from a to b, a included, b not, dense enough that chords
 * keep to the tolerance in space and on paper. Appends to `points`. */
typedef struct kg_points {
    kg_cross_point *items;
    size_t count, capacity;
} kg_points;
kg_status kg_sample_straight(const kg_patch *patch, kg_vec2 a, kg_vec2 b, double tolerance,
                             kg_points *points) KG_CHECKED;

/* The same of both u sides of a patch in the order of its outline: the low one from v = 1 down, the
 * high one from v = 0 up. They share their rulings, which cost the most. Fills empty lists, which
 * are the caller's also on failure. */
kg_status kg_sample_sides(const kg_patch *patch, double tolerance, kg_points points[2]) KG_CHECKED;

/* The region of one face of an arrangement. */
kg_status kg_region_from_face(const kg_arrangement *a, size_t face,
                              kg_region *out_region) KG_CHECKED;

/* The loops of a region as chains that carry KG_LABEL_REGION. The finder gives cutters. */
kg_status kg_region_chains(const kg_region *region, kg_patch_finder finder,
                           kg_chains *chains) KG_CHECKED;

void kg_region_clear(kg_region *region);

/* Takes over `region`, also on failure. */
kg_status kg_regions_add(kg_regions *regions, kg_region region) KG_CHECKED;

/* Adds the faces of what was left before that `wanted` (NULL: all) accepts; slivers are left out.
 */
typedef bool (*kg_face_filter)(const kg_arrangement *a, size_t face, const void *user);
kg_status kg_regions_from_faces(const kg_arrangement *a, kg_face_filter wanted, const void *user,
                                kg_regions *regions) KG_CHECKED;

/* Where perpendiculars from a point meet rulings, in rows dense enough to tell one piece of a patch
 * from another: where a piece comes nearest that does not hold the patch's own nearest point, and
 * not on its boundary. */
enum { KG_FEET_ROWS = 128 };
typedef struct kg_feet {
    kg_vec3 point;
    double u[KG_FEET_ROWS + 1], distance2[KG_FEET_ROWS + 1];
} kg_feet;
void kg_feet_find(const kg_patch *patch, kg_vec3 point, kg_feet *out);

/* Squared distance from the point to its feet in a region and to the boundary, `most` if it is
 * not less. */
double kg_feet_distance2(const kg_feet *feet, const kg_region *region, double most);

/* The end of every trim: hands the pieces out, or clears them and says what failed. */
kg_status kg_trim_finish(kg_status status, kg_regions *pieces, kg_regions *out_regions,
                         kg_error *error) KG_CHECKED;

#endif
