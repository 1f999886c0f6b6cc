/* Frees what trims and patches hold, for all that builds or changes models. */
#ifndef KG_MODEL_CLEAR_H
#define KG_MODEL_CLEAR_H

#include "katagami/model.h"

/* The trim is empty afterwards. */
void kg_trim_op_clear(kg_trim_op *op);
void kg_model_patch_clear(kg_model_patch *patch);

#endif
