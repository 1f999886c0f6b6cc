/* Stretches: where the cut edges of pieces lie on other pieces. */
#ifndef KG_UNROLL_STRETCH_H
#define KG_UNROLL_STRETCH_H

#include "unroll/piece.h"

/*
 * Finds all stretches and what each is glued to. An edge of A made by B lies
 *   on an edge of B that A made: both cut each other, a seam;
 *   inside B: a contact;
 *   on an edge that B made of a third piece: B only separates the two, a seam of theirs. So is a
 *   patch split by a construction plane, or two that meet on one;
 *   nowhere: free.
 */
kg_status kg_pieces_find_stretches(kg_pieces *pieces) KG_CHECKED;

/* The length of a stretch's chords, mm. */
double kg_stretch_chords(const kg_pieces *pieces, const kg_stretch *stretch);

/* Positions on the edge that divide a stretch into `count` > 0 equal lengths: count - 1 of them.
 * Lengths of chords do: both sides of a seam have the same chords. */
void kg_stretch_divide(const kg_pieces *pieces, const kg_stretch *stretch, int count,
                       double *out_positions);

#endif
