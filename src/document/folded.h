/* Folded sheets as documents. */
#ifndef KG_DOCUMENT_FOLDED_H
#define KG_DOCUMENT_FOLDED_H

#include "katagami/document.h"

typedef struct kg_folded {
    kg_origami *origami;
    size_t step;            /* shown in meshes and pictures */
    bool imported;          /* from a crease pattern: the report holds */
    kg_layer_report report; /* of its layers */
} kg_folded;

/* Takes the origami over. NULL, with it destroyed, when memory runs out. */
kg_folded *kg_folded_create(kg_origami *origami);
void kg_folded_destroy(kg_folded *folded);

/* The crease pattern of all folds. */
kg_status kg_folded_net(const kg_folded *folded, kg_document_net *out_net,
                        kg_error *error) KG_CHECKED;

/* The sheets as they lie at the step, layers drawn apart by a paper thickness: one group per
 * sheet, in the colours of their fronts. */
kg_status kg_folded_mesh(const kg_folded *folded, kg_mesh **out_mesh, kg_error *error) KG_CHECKED;

#endif
