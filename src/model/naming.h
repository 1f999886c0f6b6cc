/* Names of copies: parts are told apart by them on paper. */
#ifndef KG_MODEL_NAMING_H
#define KG_MODEL_NAMING_H

#include "katagami/model.h"

/* Gives a patch that is a copy of another a name that no other patch has. A mirrored one changes
 * sides where its name ends in one ("ear L", "flank left", "耳左") or begins with 左 or 右; else,
 * and where that name is taken, it gets the next number ("ear 2", "ear 3"). Patches without a name
 * stay so. Errors: KG_ERR_INPUT (no such patch), KG_ERR_MEMORY. */
kg_status kg_model_name_copy(kg_model *model, int64_t id, bool mirrored,
                             kg_error *error) KG_CHECKED;

#endif
