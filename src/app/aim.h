/* Where a line of sight meets the whole rectangle of a patch, trimmed away or not. */
#ifndef KG_APP_AIM_H
#define KG_APP_AIM_H

#include "katagami/patch.h"

/* The nearest place, (u, v); false when the line misses. */
bool kg_patch_aim(const kg_patch *patch, kg_vec3 origin, kg_vec3 direction, kg_vec2 *out_uv);

#endif
