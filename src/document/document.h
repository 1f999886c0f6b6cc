/* What a document holds. */
#ifndef KG_DOCUMENT_DOCUMENT_H
#define KG_DOCUMENT_DOCUMENT_H

#include "katagami/document.h"

struct kg_document {
    kg_document_kind kind;
    char *path; /* of the model file; NULL: none yet */
    kg_model *model;
    kg_solution *solution; /* NULL until solved */
};

#endif
