/*
 * Edits that mend bad rulings, and what each of them would do to a patch.
 */
#ifndef KG_APP_COMMANDS_MEND_H
#define KG_APP_COMMANDS_MEND_H

#include "app/editor.h"

/* Within a step: the patch becomes a half, and the other half, the plane between and two
 * construction patches that cut them are added and selected with it. KG_ERR_INPUT, with a message
 * that goes on after "patch N": as kg_model_divide. */
kg_status kg_mend_split(kg_editor *editor, int64_t patch, kg_error *error) KG_CHECKED;

/* Tries every edit on copies of a patch, and keeps in editor->mends those that would leave it
 * sound; again only when the model was solved again. */
void kg_mend_offer(kg_editor *editor, int64_t patch);

#endif
