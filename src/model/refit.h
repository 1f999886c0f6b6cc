/* Geodesics cut back to what is left of their patches. */
#ifndef KG_MODEL_REFIT_H
#define KG_MODEL_REFIT_H

#include "katagami/model.h"

/* Cuts the geodesic of a patch back to the interval of v that its regions and the trims of other
 * patches use, with a margin of 1 % (de Casteljau: the surface stays the same). Extent in force, v
 * of contours and, where an inflection was cut off and the rulings run the other way now, the signs
 * of u and the side follow. Nothing changes where nothing can be cut off. `solution`: the model's
 * own, current. KG_ERR_INPUT: no such patch; it or what trims it is not valid; the result would
 * not be the same (the model is untouched). */
kg_status kg_model_refit(kg_model *model, const kg_solution *solution, int64_t id,
                         kg_error *error) KG_CHECKED;

#endif
