/* What new documents hold. */
#ifndef KG_APP_BLANK_H
#define KG_APP_BLANK_H

#include "katagami/document.h"

/* An empty patch model, an empty pop-up card, or a square sheet. */
kg_status kg_blank_document(kg_document_kind kind, kg_document **out_document,
                            kg_error *error) KG_CHECKED;

#endif
