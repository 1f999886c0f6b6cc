/* Outlines: the loops of pieces on paper. */
#ifndef KG_UNROLL_OUTLINE_H
#define KG_UNROLL_OUTLINE_H

#include "unroll/piece.h"

/* A growing line on paper, for kg_net_add_loop and kg_net_add_line. */
typedef struct kg_outline {
    kg_vec2 *points;
    unsigned char *corners;
    size_t count, point_capacity, corner_capacity;
} kg_outline;

kg_status kg_outline_add(kg_outline *outline, kg_vec2 at, bool corner) KG_CHECKED;
void kg_outline_clear(kg_outline *outline);

/* Paper coordinates of the printed side: flipping a patch mirrors x and nothing else. */
kg_vec2 kg_on_paper(const kg_patch *patch, double u, double v);

/* The direction there of a movement (du, dv). */
kg_vec2 kg_paper_direction(const kg_patch *patch, double u, double v, double du, double dv);

/* Unrolls a loop, and sets `first` and `count` of its stretches. */
kg_status kg_outline_of_loop(kg_pieces *pieces, size_t piece, size_t loop,
                             kg_outline *out) KG_CHECKED;

#endif
