/* Pieces: the regions that become parts, and the stretches of their edges that lie on others. */
#ifndef KG_UNROLL_PIECE_H
#define KG_UNROLL_PIECE_H

#include "katagami/unroll.h"

/* A stretch of a cut edge that lies on another piece. Positions are those of
 * kg_region_edge_measure. */
typedef struct kg_stretch {
    size_t piece, loop, edge;
    double from, to;
    size_t partner; /* piece */
    bool on_edge;   /* on the partner's boundary: a seam; else inside: a contact */
    kg_cross_point ends[2];
    size_t first, count; /* points of the part's loop, set when the part is built */
    size_t mate;         /* the stretch of the partner's edge it is glued to, or itself */
    bool mate_reversed;
} kg_stretch;

typedef struct kg_piece {
    const kg_solved_patch *patch;
    const kg_model_patch *model;
    const kg_region *region;
    size_t index; /* of the region in its patch */
} kg_piece;

typedef struct kg_pieces {
    const kg_solution *solution;
    size_t count;
    kg_piece *items;
    size_t stretch_count, stretch_capacity;
    kg_stretch *stretches;
} kg_pieces;

kg_status kg_pieces_create(const kg_model *model, const kg_solution *solution,
                           kg_pieces *out) KG_CHECKED;
void kg_pieces_clear(kg_pieces *pieces);

/* Finds all stretches, in the order of pieces, loops, edges, and mates those of seams. */
kg_status kg_pieces_find_stretches(kg_pieces *pieces) KG_CHECKED;

/* The exact point of a piece's edge at a position. */
kg_cross_point kg_piece_point(const kg_pieces *pieces, size_t piece, size_t loop, size_t edge,
                              double position, kg_cross_point *out_slope);

/* The patch that made a cut edge; NULL for other edges. */
const kg_patch *kg_piece_cutter(const kg_pieces *pieces, const kg_region_edge *edge);

#endif
