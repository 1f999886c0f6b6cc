/* Frees what trims and patches hold, for all that builds or changes models. */
#ifndef KG_MODEL_CLEAR_H
#define KG_MODEL_CLEAR_H

#include "katagami/model.h"

/* The trim is empty afterwards. */
void kg_trim_op_clear(kg_trim_op *op);
/* Also to be cleared where it fails, for lack of memory. */
bool kg_trim_op_copy(const kg_trim_op *from, kg_trim_op *to) KG_CHECKED;
void kg_model_patch_clear(kg_model_patch *patch);

#endif
