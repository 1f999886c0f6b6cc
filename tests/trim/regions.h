/* Scenes of patches to be trimmed, what every region must fulfil, and pieces by GEOS. */
#ifndef KG_TESTS_TRIM_REGIONS_H
#define KG_TESTS_TRIM_REGIONS_H

#include "katagami/trim.h"
#include "tests/trim/pairs.h"

#define TOLERANCE 0.001

enum { SCENE_MAX = 8, PIECES_MAX = 64 };

/* Patch i has the id i + 1. */
typedef struct scene {
    size_t count;
    kg_patch patches[SCENE_MAX];
    kg_crossings crossings[SCENE_MAX][SCENE_MAX]; /* found on demand */
    bool known[SCENE_MAX][SCENE_MAX], coincide[SCENE_MAX][SCENE_MAX];
} scene;

/* Patches of any kind, each anywhere within `spread` of the origin along each axis. */
scene random_scene(kg_random *r, size_t count, kg_vec3 spread);
void scene_clear(scene *s);
kg_patch_finder scene_finder(const scene *s);

/* A cut of patch a by patch b; false where the two coincide. */
bool scene_cut(scene *s, size_t a, size_t b, kg_cut *out);

/* A trim of patch a. */
kg_trim scene_trim(const scene *s, size_t a, kg_trim_notes *notes);

/* The whole rectangle of patch a. */
kg_regions whole(const scene *s, size_t a);

/* Loops are simple and rightly oriented, edges follow each other, every point lies on what its
 * edge says, exactly. */
void check_regions(const scene *s, size_t a, const kg_regions *regions, const char *name);

/* Sum over all regions. */
kg_measure total(const scene *s, size_t a, const kg_regions *regions);

/* Area in the plane (u, v L) of one region's polyline. */
double plane_area(const kg_patch *patch, const kg_region *region);

/* Areas, descending, of the pieces into which GEOS divides the regions along polylines. */
typedef struct lines {
    size_t count;
    struct {
        size_t count;
        const kg_cross_point *points;
    } items[256];
} lines;
void lines_add(lines *l, size_t count, const kg_cross_point *points);
size_t pieces_by_geos(const kg_patch *patch, const kg_regions *regions, const lines *cuts,
                      double out_areas[PIECES_MAX]);
/* The same of regions themselves. */
size_t areas_of(const kg_patch *patch, const kg_regions *regions, double out_areas[PIECES_MAX]);

#endif
