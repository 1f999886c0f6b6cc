/* Dividing a patch that is trimmed, or trims others. */
#ifndef KG_MODEL_DIVIDE_H
#define KG_MODEL_DIVIDE_H

#include "katagami/model.h"

/* What a patch is divided into: two halves, the plane between, and what cuts the three along their
 * common rulings. */
enum { KG_FIRST_HALF, KG_MIDDLE_PLANE, KG_SECOND_HALF, KG_FIRST_CUT, KG_SECOND_CUT, KG_DIVIDED };

/*
 * Divides a patch as kg_patch_divide does; the first half keeps its id, the others are added behind
 * the last patch with the other `names` (UTF-8), and the net holds the three together in one part.
 * Each part takes over the trims that still meet it, with drawn contours laid on it, and keeps what
 * was kept there. What the patch cut is cut by the part that it meets; wishes for joins go to the
 * part at their place.
 *   solution  of the model as it is
 * KG_ERR_INPUT, with a message that goes on after "patch N", the model as it was: as
 * kg_patch_divide; a part of it would be trimmed away; another patch would have to be cut by two
 * of the parts; the parts would have a fault.
 */
kg_status kg_model_divide(kg_model *model, const kg_solution *solution, int64_t id,
                          const char *const names[KG_DIVIDED], int64_t out_ids[KG_DIVIDED],
                          kg_error *error) KG_CHECKED;

#endif
