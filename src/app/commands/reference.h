/*
 * The reference of a model, for who has read it already.
 */
#ifndef KG_APP_COMMANDS_REFERENCE_H
#define KG_APP_COMMANDS_REFERENCE_H

#include "app/editor.h"

/* Makes a mesh, known to be readable, the reference of a patch model, as one step. KG_ERR_MEMORY.
 */
kg_status kg_reference_set(kg_editor *editor, const char *path, kg_error *error) KG_CHECKED;

#endif
