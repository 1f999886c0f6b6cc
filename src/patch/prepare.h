/* The steps of kg_patch_init, each of which fills its fields of the patch. */
#ifndef KG_PATCH_PREPARE_H
#define KG_PATCH_PREPARE_H

#include "katagami/patch.h"

/* Samples of v when extremes over a patch are looked for: a degree-18 polynomial has fewer wiggles
 * than this by far. */
enum { KG_PATCH_SCAN = 64 };

/* rulings, ruling_degree; wants geodesic and shape. */
kg_status kg_patch_init_rulings(const kg_patch_input *input, kg_patch *patch,
                                kg_error *error) KG_CHECKED;

/* extent, wished_extent, clamped, regression, regression_v, theta, flattest_v; wants rulings. */
kg_status kg_patch_init_extent(const kg_patch_input *input, kg_patch *patch,
                               kg_error *error) KG_CHECKED;

#endif
