/* Pieces: the regions that become parts. */
#ifndef KG_UNROLL_PIECE_H
#define KG_UNROLL_PIECE_H

#include "katagami/unroll.h"

typedef struct kg_piece {
    const kg_solved_patch *patch;
    const kg_model_patch *model;
    const kg_region *region;
    size_t first_sum; /* in kg_pieces.sums */
} kg_piece;

/* An edge of a piece. */
typedef struct kg_edge_ref {
    size_t piece, loop, edge;
} kg_edge_ref;

/* A stretch of a cut edge that lies on another piece. Positions are those of
 * kg_region_edge_measure; on an edge that is a whole loop they go on around it beyond `count`. */
typedef struct kg_stretch {
    kg_edge_ref edge;
    double from, to;
    kg_edge_ref partner; /* of a contact only the piece counts */
    bool seam;           /* on an edge of the partner, not inside it */
    size_t mate;         /* seam: the stretch of the partner's edge it is glued to */
    bool mate_reversed;
    bool single; /* seems a seam, but nothing runs along all of it: no join */
    kg_measure measure;
    size_t first, count; /* points of the part's loop, set when the part is built */
} kg_stretch;

typedef struct kg_pieces {
    const kg_solution *solution;
    size_t count;
    kg_piece *items;        /* those of a patch together, in the order of the model */
    size_t *first_of_patch; /* by index of the patch in the solution, and one more */
    size_t cut_count;
    kg_edge_ref *cuts; /* all cut edges, by source */
    size_t stretch_count, stretch_capacity;
    kg_stretch *stretches; /* by edge, then along it */
    size_t region_count;
    kg_regions *cut_up; /* for every region of the solution: what took its place, if anything */
    kg_measure *sums;   /* of every edge up to each of its points: all is measured once */
} kg_pieces;

/* Regions larger than `room` (mm on paper; (0,0): no limit) are cut up along rulings. */
kg_status kg_pieces_create(const kg_model *model, const kg_solution *solution, kg_vec2 room,
                           kg_pieces *out) KG_CHECKED;
void kg_pieces_clear(kg_pieces *pieces);

const kg_region_loop *kg_piece_loop(const kg_pieces *pieces, kg_edge_ref edge);
const kg_region_edge *kg_piece_edge(const kg_pieces *pieces, kg_edge_ref edge);
const kg_patch *kg_piece_patch(const kg_pieces *pieces, size_t piece);

/* The patch that made a cut edge; NULL for other edges. */
const kg_patch *kg_piece_cutter(const kg_pieces *pieces, const kg_region_edge *edge);

/* The exact point of an edge at a position; `out_slope` (may be NULL) is its derivative there. */
kg_cross_point kg_piece_point(const kg_pieces *pieces, kg_edge_ref edge, double position,
                              kg_cross_point *out_slope);

/* What a part of an edge measures. */
kg_measure kg_piece_measure(const kg_pieces *pieces, kg_edge_ref edge, double from, double to);

/* Is the edge a whole loop? */
bool kg_piece_closed(const kg_pieces *pieces, kg_edge_ref edge);

/* The stretches of an edge: [first, one behind the last). */
void kg_piece_stretches(const kg_pieces *pieces, kg_edge_ref edge, size_t *out_first,
                        size_t *out_end);

bool kg_same_edge(kg_edge_ref a, kg_edge_ref b);

#endif
