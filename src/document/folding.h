/* Sheets on their way from one fold to the next, with their layers drawn apart. */
#ifndef KG_DOCUMENT_FOLDING_H
#define KG_DOCUMENT_FOLDING_H

#include "katagami/origami.h"

/* Where the corners of the loops of one state are at each moment of a fold, in the order of the
 * loops and around each: at first, plus (cos t - 1) radius + sin t across + fraction settle, t the
 * angle turned so far. `settle` takes the layers from their old heights to the new. */
typedef struct kg_turning {
    double angle; /* of the whole fold, signed */
    size_t count;
    kg_vec3 *start, *radius, *across, *settle; /* the last three are 0 for what rests */
} kg_turning;

/* Fold `step`, for the corners of the state after `topology` folds (more than `step`). Layers are
 * `thickness` mm apart. */
kg_status kg_turning_create(const kg_origami *origami, size_t topology, size_t step,
                            double thickness, kg_turning *out, kg_error *error) KG_CHECKED;
void kg_turning_clear(kg_turning *turning);

/* Weights of radius, across and settle at a fraction of the fold. */
void kg_turning_weights(const kg_turning *turning, double fraction, double out[3]);

#endif
