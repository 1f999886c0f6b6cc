/*
 * Glue tabs: strips of paper outside the edges that are glued, merged into the cut contours.
 *
 * Each edge is split at its corners and where it bends into bases that are nearly straight on paper
 * and in space, because a tab cannot be folded along a bent line and glued flat. A base carries a
 * trapezoid, or a tooth where bases are short. Tabs that run into the part are split and lowered
 * alone, tabs that run into each other give way together.
 */
#ifndef KG_NET_TAB_H
#define KG_NET_TAB_H

#include "katagami/net.h"

typedef struct kg_tab_options {
    bool none;    /* no tabs at all */
    double width; /* mm, how far a tab reaches from its edge */
    double least; /* mm, below this a tab holds no glue and is left out, except on edges so short
                     that theirs never reaches it */
    /* For joins whose edge bends in space more than on paper (the rim of a cylinder is straight on
     * paper): bends[2 * join + side] is NULL or holds one value per point of that stretch, the
     * turning of the edge's tangent in space from the stretch's start to there, radians, never
     * decreasing. NULL: all edges bend as they do on paper. */
    const double *const *bends;
} kg_tab_options;

/* 5 mm wide, at least 1.2 mm. */
kg_tab_options kg_tab_options_default(void);

typedef enum kg_tab_trouble {
    KG_TAB_LOWERED, /* narrower than asked for */
    KG_TAB_MISSING, /* a stretch without a tab */
    KG_TAB_MOVED    /* not on the side that the user wanted */
} kg_tab_trouble;

typedef enum kg_tab_reason {
    KG_TAB_NO_ROOM,   /* the part itself, or a narrow corner of it, is in the way */
    KG_TAB_NEIGHBOUR, /* another tab is */
    KG_TAB_SHORT,     /* the edge, or a piece of it between corners, is short */
    KG_TAB_TAKEN,     /* another join has its tabs on this edge */
    KG_TAB_NO_EDGE    /* the side is no edge: a mark line, or in no part of this net */
} kg_tab_reason;

/* What is not as asked for, one remark per join, trouble and reason. */
typedef struct kg_tab_remark {
    int join, side;
    kg_tab_trouble trouble;
    kg_tab_reason reason;
    double length; /* mm of the edge, all such stretches together */
    double height; /* mm, the lowest of the tabs; 0 where none is */
    kg_vec2 at;    /* middle of the first such stretch, in the part's coordinates */
} kg_tab_remark;

typedef struct kg_tab_report {
    size_t tab_count;
    size_t remark_count;
    kg_tab_remark *remarks; /* by join */
} kg_tab_report;

void kg_tab_report_clear(kg_tab_report *report);

/* The remark as a sentence, cut off at `size` bytes. */
void kg_tab_remark_print(const kg_net *net, const kg_tab_remark *remark, char *out, size_t size);

/*
 * A copy of the net with tabs; `net` itself stays as it is.
 *
 * In the copy every contour is one closed cut line around its tabs: between tabs it has the points
 * and corner flags it had, a tab's four points are corners. Under each tab its part gets a fold
 * line, the stretch of the old contour between the tab's ends, valley where join.fold of that side
 * is positive or 0, else mountain, with `join` and the tab's number in the part. A join's side
 * counts the points of the new contour along the stretch, tabs included.
 *
 * A contact has its tabs on side 0, a seam where more glue surface fits, then on the side that
 * bulges more, then on side 0, unless the join says otherwise.
 *
 * Errors: KG_ERR_INPUT (widths out of range, a net that kg_net_check refuses), KG_ERR_MEMORY.
 */
kg_status kg_net_tabs(const kg_net *net, const kg_tab_options *options, kg_net **out_net,
                      kg_tab_report *out_report, kg_error *error) KG_CHECKED;

#endif
