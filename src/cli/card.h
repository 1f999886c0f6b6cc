/* What commands say of pop-up cards. */
#ifndef KG_CLI_CARD_H
#define KG_CLI_CARD_H

#include "katagami/document.h"

#include <jansson.h>

/* Prints the card and its net. */
kg_status kg_card_print(kg_document *document, const kg_document_net *net,
                        kg_error *error) KG_CHECKED;

/* The same as an object; NULL when memory runs out. */
json_t *kg_card_json(kg_document *document, kg_error *error);

/* Says on stderr what makes a card fall apart, so that nobody cuts it unknowingly. Silent for other
 * documents. */
void kg_card_warn(const kg_document *document, const char *command);

#endif
