/* Folded sheets as documents. */
#ifndef KG_DOCUMENT_PAPER_H
#define KG_DOCUMENT_PAPER_H

#include "katagami/document.h"

typedef struct kg_paper {
    kg_origami *origami;
    size_t step;            /* shown in meshes and pictures */
    bool imported;          /* from a crease pattern: the report holds */
    kg_layer_report report; /* of its layers */
} kg_paper;

/* Takes the origami over. NULL, with it destroyed, when memory runs out. */
kg_paper *kg_paper_create(kg_origami *origami);
void kg_paper_destroy(kg_paper *paper);

/* The crease pattern of all folds. */
kg_status kg_paper_net(const kg_paper *paper, kg_document_net *out_net, kg_error *error) KG_CHECKED;

/* The sheets as they lie at the step, layers drawn apart by a paper thickness: one group per
 * sheet, in the colours of their fronts. */
kg_status kg_paper_mesh(const kg_paper *paper, kg_mesh **out_mesh, kg_error *error) KG_CHECKED;

#endif
