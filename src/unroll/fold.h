/* How paper meets paper along a stretch: fold angles of tabs, and the bend of the edge. */
#ifndef KG_UNROLL_FOLD_H
#define KG_UNROLL_FOLD_H

#include "unroll/piece.h"

/* The angle by which a tab on a stretch is folded from its part's plane to lie on the other part,
 * positive: valley as seen from the front; the largest along the stretch in absolute value. */
double kg_stretch_fold(const kg_pieces *pieces, size_t stretch);

/* Turning of the edge's tangent in space from the stretch's start to each of its points, in the
 * order of the net; free() it. */
kg_status kg_stretch_bends(const kg_pieces *pieces, size_t stretch, double **out) KG_CHECKED;

#endif
