/* One picture of a folding sequence: the paper, the line to fold along, and the arrow. */
#ifndef KG_GUIDE_DIAGRAM_H
#define KG_GUIDE_DIAGRAM_H

#include "guide/figure.h"
#include "katagami/origami.h"

typedef enum kg_arrow_kind {
    KG_ARROW_NONE,
    KG_ARROW_VALLEY,   /* towards the eye: a filled head */
    KG_ARROW_MOUNTAIN, /* away from it: a hollow half head */
    KG_ARROW_UNFOLD    /* there and back: a head at either end */
} kg_arrow_kind;

enum { KG_ARROW_POINTS = 33, KG_DIAGRAM_MARKS = 2, KG_DIAGRAM_MEASURES = 2 };

/* A length along an edge of the paper that a fold is found by. */
typedef struct kg_diagram_length {
    kg_vec2 from, to; /* from a corner */
    kg_vec2 outwards; /* unit */
    double length;    /* mm of paper */
} kg_diagram_length;

/* What on the paper a fold goes to. */
typedef enum kg_diagram_goal {
    KG_GOAL_NONE, /* told otherwise */
    KG_GOAL_CORNER,
    KG_GOAL_LINE, /* an edge onto a line that it meets */
    KG_GOAL_EDGE,
    KG_GOAL_POINT
} kg_diagram_goal;

/* Coordinates are as seen: millimetres of the paper, x to the right, y up. */
typedef struct kg_diagram {
    const kg_origami *origami;
    size_t step;  /* the fold shown; the number of folds: the finished model */
    size_t folds; /* how many it stands for: 2 when the next one undoes it, 0 at the end */
    int side;     /* 1 seen from where z points to, -1 from behind */
    bool oblique;
    bool turned; /* the paper is to be turned over first */
    kg_vec3 right, up, back;
    kg_box2 box; /* of paper and arrow */
    kg_arrow_kind arrow;
    kg_vec2 path[KG_ARROW_POINTS]; /* of the arrow, from its tail */
    bool tucked;                   /* its end lies between two layers */
    double angle_deg;              /* of the fold, above 0 */
    bool behind;                   /* it moves away from the eye */
    bool edge;                     /* a whole edge is folded, not a corner */
    size_t layers, stack;          /* that move where it is held, and all that lie there */
    kg_vec2 axis[2];               /* two points of the line */
    kg_diagram_goal goal;
    size_t mark_count; /* points to be circled */
    kg_vec2 marks[KG_DIAGRAM_MARKS];
    size_t measure_count;
    kg_diagram_length measures[KG_DIAGRAM_MEASURES];
} kg_diagram;

/* The pictures of all folds done and of the finished model; free() them. The sides they are seen
 * from are chosen so that few folds go behind and the paper is seldom turned over. */
kg_status kg_diagrams_create(const kg_origami *origami, kg_diagram **out_diagrams,
                             size_t *out_count, kg_error *error) KG_CHECKED;

/* Paints it with the middle of its box at `at` on the page, `scale` times the paper's size. */
kg_status kg_diagram_paint(const kg_diagram *diagram, cairo_t *cr, kg_vec2 at, double scale,
                           kg_error *error) KG_CHECKED;

/* The symbol for turning the paper over, `at` its middle, about 12 mm wide. */
void kg_diagram_turn_symbol(cairo_t *cr, kg_vec2 at);

/* An arrow along points on the page. */
void kg_arrow_paint(cairo_t *cr, kg_arrow_kind kind, bool tucked, const kg_vec2 *path,
                    size_t count);

/* ---- of one state ----------------------------------------------------------------------- */

/* A state at one moment of a fold, or at rest. */
typedef struct kg_moment {
    const kg_origami_state *topology; /* after the fold */
    const kg_origami_state *layers;   /* before it: what lies on what */
    kg_vec3 *positions;               /* of the vertices */
    int32_t *parents;                 /* per loop of `topology`, in `layers` */
    bool *moves;                      /* per loop */
    double *heights;                  /* per half-edge, in layers */
} kg_moment;

/* Just before fold `step`, cut along its line already; or the last state when there is none. */
kg_status kg_moment_create(const kg_origami *origami, size_t step, kg_moment *out,
                           kg_error *error) KG_CHECKED;
void kg_moment_clear(kg_moment *moment);

#endif
