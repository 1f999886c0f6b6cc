/* Documents that are begun and not opened. */
#ifndef KG_APP_COMMANDS_CREATE_H
#define KG_APP_COMMANDS_CREATE_H

#include "app/editor.h"

/* Shows a new document in the place of the one there is, and takes it over, also on failure;
 * `work`: something was made that is worth saving. */
kg_status kg_create_take(kg_editor *editor, kg_document *document, bool work,
                         kg_error *error) KG_CHECKED;

#endif
