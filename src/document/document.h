/* What a document holds. */
#ifndef KG_DOCUMENT_DOCUMENT_H
#define KG_DOCUMENT_DOCUMENT_H

#include "document/card.h"
#include "document/folded.h"
#include "katagami/document.h"

struct kg_document {
    kg_document_kind kind;
    char *path; /* of the model file; NULL: none yet */
    kg_model *model;
    kg_solution *solution; /* NULL until solved */
    kg_card *card;         /* of a pop-up document, which has no model */
    kg_folded *folded;     /* of an origami document, which has neither */
};

/* The reference's path, relative ones starting at the model's folder; NULL for none, or when memory
 * runs out. free() it. */
char *kg_document_reference_path(const kg_document *document);

/* Adds a copy of a message; `code` is kept as it is. KG_ERR_MEMORY. */
kg_status kg_document_net_remark(kg_document_net *net, int64_t source, const char *code,
                                 const char *message, kg_error *error) KG_CHECKED;

#endif
