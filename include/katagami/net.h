/*
 * katagami: nets, what is cut out of paper and put together.
 *
 * The net model knows parts, their outlines, folds, marks and the joins between them, and nothing
 * of where they come from: patches, pop-up cards and folded sheets all end here. Data flows one
 * way: a mode builds a kg_net (parts in their own coordinates, joins), kg_net_tabs adds glue tabs,
 * kg_net_layout places parts on pages, the writers draw the pages.
 *
 * Lengths are millimetres on paper at the net's own scale; y points down, as on the page.
 */
#ifndef KATAGAMI_NET_H
#define KATAGAMI_NET_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum kg_net_kind {
    KG_NET_CUT = 0,
    KG_NET_MOUNTAIN,
    KG_NET_VALLEY,
    KG_NET_MARK
} kg_net_kind;

/* A curve on paper as a dense polyline (its chords are within a tenth of the writing tolerance of
 * the true curve). corners[i] is 1 where the direction breaks at points[i]; elsewhere the curve is
 * smooth there. A closed line does not repeat its first point. */
typedef struct kg_net_line {
    kg_net_kind kind;
    bool closed;
    size_t count;
    kg_vec2 *points;
    unsigned char *corners;
    int64_t contact; /* mark lines: id of the source that touches here, else 0 */
    int tab;         /* tab folds: number of the tab in its part, from 1, else 0 */
    int join;        /* index of the join this line belongs to, else -1 */
} kg_net_line;

typedef enum kg_net_join_kind {
    KG_JOIN_SEAM,   /* two edges are glued edge to edge */
    KG_JOIN_CONTACT /* an edge is glued onto the inside of another part, along a mark line */
} kg_net_join_kind;

typedef enum kg_net_tab_side {
    KG_TAB_AUTO = 0,
    KG_TAB_NONE,
    KG_TAB_THIS, /* on side 0 of the join */
    KG_TAB_OTHER /* on side 1 of the join */
} kg_net_tab_side;

typedef enum kg_net_tab_shape { KG_TAB_SHAPE_AUTO = 0, KG_TAB_TRAPEZOID, KG_TAB_TEETH } kg_net_tab_shape;

/* One side of a join: a stretch of a part's outline (or a mark line inside the part). */
typedef struct kg_net_side {
    int part;      /* index in kg_net.parts, or -1 when that side is in no part */
    int loop;      /* index of the outline loop, or -1 for a mark line */
    size_t first;  /* the stretch runs from points[first], `count` points onward (wrapping) */
    size_t count;  /* at least 2 for an outline stretch */
    int line;      /* index in the part's lines when loop is -1 */
    double length; /* true length on paper, by quadrature, not of the polyline */
    bool reversed; /* side 1: runs against the direction of side 0 */
} kg_net_side;

/* Where paper is glued to paper. Side 0 of a contact is the edge, side 1 the mark line. */
typedef struct kg_net_join {
    kg_net_join_kind kind;
    int number;          /* printed on both sides, from 1 */
    kg_net_side sides[2];
    int64_t sources[2];  /* ids of what the two parts were made from */
    /* Signed angle by which a tab on side 0 / side 1 is folded from the part's plane to lie on the
     * other part, positive: valley as seen from the printed front, negative: mountain; the largest
     * along the stretch in absolute value. */
    double fold[2];
    kg_net_tab_side tab_side; /* wish of the user */
    kg_net_tab_shape tab_shape;
    double tab_width; /* mm; 0: the net's */
} kg_net_join;

typedef struct kg_net_loop {
    kg_net_line line; /* closed; the outer loop runs so that the paper lies on its left in a y-down
                         picture's coordinates taken as they are (positive shoelace area); holes the
                         other way round */
} kg_net_loop;

typedef struct kg_net_part {
    int number;        /* printed on it, from 1 */
    int64_t source;    /* id of the patch (or card, sheet) it is made from */
    char *name;        /* UTF-8, may be empty */
    size_t loop_count; /* outer contour first, then holes */
    kg_net_loop *loops;
    size_t line_count; /* folds and marks */
    kg_net_line *lines;
    double area;       /* true area on paper, mm² */
    double surface;    /* true area in space, mm² */
    double perimeter;
    double isometry_error;
} kg_net_part;

typedef struct kg_net {
    char *title;
    size_t part_count;
    kg_net_part *parts;
    size_t join_count;
    kg_net_join *joins;
} kg_net;

/* Frees everything a net holds; NULL is fine. The net itself must come from kg_net_create. */
KG_API kg_net *kg_net_create(void);
KG_API void kg_net_destroy(kg_net *net);

#ifdef __cplusplus
}
#endif
#endif
