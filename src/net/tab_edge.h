/* A contour by arc length, and the division of a stretch of it into bases for tabs. */
#ifndef KG_NET_TAB_EDGE_H
#define KG_NET_TAB_EDGE_H

#include "katagami/net.h"

/* Positions s are mm along the contour from points[0]; they may exceed its length and wrap. */
typedef struct kg_tab_loop {
    const kg_net_line *line;
    double *s;      /* of every point, and the whole length behind the last */
    double outward; /* +1: the outside is right of the direction (as y points up), -1: left */
} kg_tab_loop;

kg_status kg_tab_loop_create(const kg_net_line *line, bool hole, kg_tab_loop *out) KG_CHECKED;
void kg_tab_loop_destroy(kg_tab_loop *loop);

double kg_tab_loop_length(const kg_tab_loop *loop);

/* The point at s; exactly the contour's point where s is one of its positions. */
kg_vec2 kg_tab_loop_at(const kg_tab_loop *loop, double s);

/* The angle of the free sector outside the contour at s, in [0, 2 pi]. */
double kg_tab_loop_gap(const kg_tab_loop *loop, double s);

/* What a base may be at most. */
typedef struct kg_tab_limits {
    double length;  /* mm */
    double turn;    /* radians, of the edge along it */
    double sagitta; /* mm, of the edge over its chord */
} kg_tab_limits;

/* A stretch of a contour with its bend in space (NULL: as on paper). */
typedef struct kg_tab_edge {
    const kg_tab_loop *loop;
    kg_net_side side;
    const double *bend;
    double from, to; /* positions; to - from is the whole length for a closed stretch */
} kg_tab_edge;

kg_tab_edge kg_tab_edge_of(const kg_tab_loop *loop, kg_net_side side, const double *bend);

/* Ends of the bases along an edge, ascending: out[0] = edge->from … out[count] = edge->to. The
 * caller frees them. */
kg_status kg_tab_edge_divide(const kg_tab_edge *edge, kg_tab_limits limits, double **out,
                             size_t *out_count) KG_CHECKED;

/* Turning of the edge towards the paper, radians: positive where it bulges outward. */
double kg_tab_edge_bulge(const kg_tab_edge *edge);

#endif
