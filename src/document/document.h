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

#endif
