/* Where a line of sight meets triangles and the whole rectangle of a patch, trimmed away or not. */
#ifndef KG_APP_AIM_H
#define KG_APP_AIM_H

#include "app/pane.h"
#include "katagami/patch.h"

typedef struct kg_ray {
    kg_vec3 origin, direction;
} kg_ray;

/* Whether a ray meets the triangle a b c, from either side: at origin + t direction, t > 0, which
 * is a + s (b - a) + r (c - a). */
bool kg_ray_meets(const kg_ray *ray, const kg_vec3 triangle[3], double *out_t, double *out_s,
                  double *out_r);

/* The nearest place, (u, v); false when the line misses. */
bool kg_patch_aim(const kg_patch *patch, kg_vec3 origin, kg_vec3 direction, kg_vec2 *out_uv);

/* The same of a pixel; beside the patch it is the place on the rectangle's edge that is shown
 * nearest to it. False when the patch is out of sight. */
bool kg_patch_aim_px(const kg_patch *patch, const kg_pane *pane, kg_vec2 px, kg_vec2 *out_uv);

#endif
