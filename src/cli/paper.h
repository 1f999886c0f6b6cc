/* What `katagami info` says of folded sheets. */
#ifndef KG_CLI_PAPER_H
#define KG_CLI_PAPER_H

#include "katagami/document.h"

#include <jansson.h>

/* Tells on standard error of a pattern that got a size because it has none. */
void kg_paper_warn(const kg_document *document, const char *command);
void kg_paper_print(kg_document *document);

/* The same as an object; NULL when memory runs out. */
json_t *kg_paper_json(kg_document *document);

#endif
