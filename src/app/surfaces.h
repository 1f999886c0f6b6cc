/*
 * The patches as triangles, for drawing them and for finding what lies under the pointer. Only
 * patches that changed are cut into triangles again.
 */
#ifndef KG_APP_SURFACES_H
#define KG_APP_SURFACES_H

#include "katagami/model.h"

typedef struct kg_patch_surface {
    int64_t id;
    uint64_t signature; /* of the solved patch */
    uint64_t revision;  /* another number whenever the triangles changed */
    size_t piece_count; /* 0: the patch is not valid */
    kg_tessellation *pieces;
} kg_patch_surface;

typedef struct kg_surfaces {
    kg_patch_surface *items; /* in the order of the solution */
    size_t count, capacity;
    uint64_t last_revision;
} kg_surfaces;

/* Where a line of sight meets a patch. */
typedef struct kg_hit {
    double distance; /* mm from the ray's origin; first, see kg_hits_keep */
    int64_t patch;
    size_t piece;
    kg_vec3 point;
} kg_hit;

/* Follows a solution. KG_ERR_MEMORY leaves out what there was no room for. */
kg_status kg_surfaces_update(kg_surfaces *surfaces, const kg_solution *solution) KG_CHECKED;
const kg_patch_surface *kg_surfaces_find(const kg_surfaces *surfaces, int64_t id);
/* The nearest hit of one patch. */
bool kg_surface_hit(const kg_patch_surface *surface, kg_vec3 origin, kg_vec3 direction,
                    kg_hit *out_hit);
void kg_surfaces_clear(kg_surfaces *surfaces);

#endif
