/* Folded sheets as documents. */
#ifndef KG_DOCUMENT_FOLDED_H
#define KG_DOCUMENT_FOLDED_H

#include "katagami/document.h"

typedef struct kg_folded {
    kg_origami *origami;
    size_t step;            /* shown in meshes and pictures */
    double fraction;        /* of the fold after it, in [0, 1] */
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

/* The mesh with all folds before it as a motion: three targets for a fold that are weighted by the
 * cosine and the sine of its angle and by the layers' way to their new heights, keys every
 * KG_FOLDING_KEY_DEG. At the keys all is exact; between them weights change evenly, so that a point
 * r mm from the axis is off its arc by at most r (1 - cos(KG_FOLDING_KEY_DEG / 2)), 0.1 % of r. The
 * last key is the mesh itself. `*out_motion` is NULL where nothing was folded. */
#define KG_FOLDING_KEY_DEG 5.0
kg_status kg_folded_motion(const kg_folded *folded, kg_mesh **out_mesh, kg_mesh_motion **out_motion,
                           kg_error *error) KG_CHECKED;

#endif
