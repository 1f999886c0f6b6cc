/* What `katagami info` says of folded sheets. */
#ifndef KG_CLI_PAPER_H
#define KG_CLI_PAPER_H

#include "katagami/document.h"

#include <jansson.h>

void kg_paper_print(kg_document *document);

/* The same as an object; NULL when memory runs out. */
json_t *kg_paper_json(kg_document *document);

#endif
