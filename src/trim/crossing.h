/*
 * Inside of kg_crossings_find: trees of ruled strips, the certified topology of F(v,t) = 0, and
 * the tracing of its arcs.
 *
 * With the Plücker coordinates (R, R × p) of a ruling, both polynomials in v,
 *
 *     F(v,t) = det(R_A, R_B, p_B - p_A) = R_A · (R_B × p_B) + R_B · (R_A × p_A)
 *
 * so the Bernstein coefficients of F on any cell are a product of two matrices of rank 6, made
 * from the coefficients of the two strips.
 */
#ifndef KG_TRIM_CROSSING_H
#define KG_TRIM_CROSSING_H

#include "katagami/crossing.h"

enum { KG_PLUCKER_MAX = KG_DARBOUX_MAX_COUNT + KG_CURVE_MAX_POINTS - 1 };

/* A patch seen from an origin near the pair. */
typedef struct kg_ruled {
    const kg_patch *patch;
    kg_vec3 origin;
    int degree; /* of the Plücker coefficients */
    kg_vec3 p[KG_CURVE_MAX_POINTS];
    double size; /* of the pair, mm */
} kg_ruled;

/* The strip of a patch over an interval of v. */
typedef struct kg_strip {
    double lo, hi;
    int child[2]; /* -1: not made yet */
    int depth;
    double c[6][KG_PLUCKER_MAX]; /* Bernstein coefficients of R, then of R × p */
    double largest[6];           /* of |c| */
    kg_vec3 p[KG_CURVE_MAX_POINTS];
    /* for pruning, made with the strip down to KG_STRIP_DEPTH */
    kg_box3 box;
    kg_vec3 d[KG_PLUCKER_MAX]; /* unit vectors whose cone holds the rulings */
    double widen;              /* |d| of their mixtures is at least 1/widen */
    kg_vec3 normal;            /* of the strip's middle */
    double along_normal[2];    /* its range in that direction */
} kg_strip;

/* Below this depth cells are so small that strips that lie apart have been dropped already. */
enum { KG_STRIP_DEPTH = 5 };

/* The strips of one patch, halved on demand; index 0 is the whole, a hair longer than [0,1]. */
typedef struct kg_strips {
    kg_ruled ruled;
    double cut; /* where strips are halved, a fraction near 1/2 */
    kg_strip *items;
    size_t count, capacity;
} kg_strips;

/* `which`: 0 for A, 1 for B. */
bool kg_strips_init(kg_strips *strips, const kg_patch *patch, int which, kg_vec3 origin,
                    double size);
void kg_strips_clear(kg_strips *strips);
/* Makes both children of a strip; false when memory runs out. Moves `items`. */
bool kg_strips_split(kg_strips *strips, int index);
/* True only if the two strips have no point in common. */
bool kg_strips_apart(const kg_strips *a, int i, const kg_strips *b, int j);

/* ---- roots on an edge ------------------------------------------------------------------ */

/* Roots in (0,1) at which the polynomial of the Bernstein coefficients c[0..n] changes its sign,
 * ascending; values within `noise` of 0 count as unknown. Returns their number, at most n, or -1
 * where the sign at an end is unknown. */
int kg_sign_changes(const double *c, int n, double noise, double *out_roots);

/* ---- topology -------------------------------------------------------------------------- */

/* How an arc lies in its box: as a graph t(v), as a graph v(t), or so short that it is its chord.
 */
typedef enum kg_arc_kind { KG_ARC_OVER_V, KG_ARC_OVER_T, KG_ARC_SHORT } kg_arc_kind;

typedef struct kg_arc_end {
    double v, t;
    int line;     /* 0: lies on a line v = const, 1: on t = const, -1: where branches meet */
    int side;     /* the cell lies below (-1) or above (+1) the line */
    int arc, hub; /* owner: one of them, the other -1 */
    int match;    /* the end of the neighbouring arc, or -1 */
} kg_arc_end;

typedef struct kg_arc {
    kg_arc_kind kind;
    double v[2], t[2]; /* box */
    int slope;         /* sign of F_t (over v) or F_v (over t) */
    int ends[2];
} kg_arc;

/* A cell that could not be resolved: branches cross, touch or turn sharply in it. */
typedef struct kg_hub {
    double v[2], t[2];
    int cluster; /* the first hub of those that touch */
} kg_hub;

typedef struct kg_topology {
    struct {
        kg_arc_end *items;
        size_t count, capacity;
    } ends;
    struct {
        kg_arc *items;
        size_t count, capacity;
    } arcs;
    struct {
        kg_hub *items;
        size_t count, capacity;
    } hubs;
    struct {
        kg_vec2 *items; /* (v,t) where hubs were found singular */
        size_t count, capacity;
    } singular;
    bool crowded; /* singular along a curve, or the surfaces coincide */
} kg_topology;

/* All arcs of F = 0 in the cells where the two patches come near each other, matched end to end. */
bool kg_topology_find(kg_strips *a, kg_strips *b, kg_topology *out);
/* Its second half: matches the ends and resolves the hubs. */
bool kg_topology_join(kg_topology *topology, const kg_strips *a, const kg_strips *b);
void kg_topology_clear(kg_topology *topology);

/* ---- points ---------------------------------------------------------------------------- */

/* A ruling as polynomials give it: R is not of unit length. */
typedef struct kg_line {
    kg_vec3 p, dp, r, dr;
} kg_line;

kg_line kg_ruled_line(const kg_ruled *ruled, double v);

/* In kg_sample.out: rulings that are parallel and do not meet, which are roots of F too. */
enum { KG_SIDE_FALSE = 256 };

/* A point of the crossing with what the tracing needs; derivatives by arc length in space. */
typedef struct kg_sample {
    kg_cross_point at, slope; /* slope.x: unit tangent, or 0 where there is none */
    kg_vec2 paper[2];         /* unit tangents on the papers of A and B */
    kg_vec2 off[2];           /* place on paper, from the foot of its ruling */
    double speed[2];          /* of the geodesics */
    kg_vec3 across;           /* d_A × d_B */
    unsigned out;             /* sides it lies beyond */
} kg_sample;

typedef struct kg_ruled_pair {
    kg_ruled a, b;
    double tolerance;
    double slack; /* v, t, and u, s by the size: what is within this of a side is on it */
} kg_ruled_pair;

/* The point of two lines at (v,t), where F = 0; its tangent runs in the direction of growing v
 * (KG_ARC_OVER_V) or t (KG_ARC_OVER_T) if `direction` is 1. */
kg_sample kg_cross_sample(const kg_ruled_pair *pair, double v, double t, kg_arc_kind kind,
                          int direction);

/* The same from both lines, v and t as kg_on_unit_side gives them: 0 or 1 where they are within the
 * slack of it. */
kg_sample kg_cross_lines(const kg_ruled_pair *pair, double v, const kg_line *a, double t,
                         const kg_line *b, kg_arc_kind kind, int direction);
double kg_on_unit_side(const kg_ruled_pair *pair, double v);

/* |p'| */
double kg_ruled_speed(const kg_ruled *ruled, double v);

/* d = R/|R| and its derivative. */
void kg_line_unit(const kg_line *line, kg_vec3 *out_d, kg_vec3 *out_dd);

/* F with its derivatives. */
double kg_cross_value(const kg_line *a, const kg_line *b, double *out_v, double *out_t);

/* The number of samples so far with a growing list. */
typedef struct kg_path {
    struct {
        kg_sample *items;
        size_t count, capacity;
    } samples;
    struct {
        bool *items; /* is the span that ends at this sample inside both rectangles? */
        size_t count, capacity;
    } inside;
} kg_path;

/* Traces all chains of arcs and appends what lies inside both rectangles. */
bool kg_trace(const kg_ruled_pair *pair, const kg_topology *topology, kg_crossings *out);

/* Appends a branch of `count` samples. */
bool kg_crossings_add(kg_crossings *crossings, const kg_ruled_pair *pair, const kg_sample *samples,
                      size_t count, bool closed);

/* ---- degenerate pairs ------------------------------------------------------------------ */

/* Patches with constant, parallel rulings: crossings of their cross-sections. */
kg_status kg_parallel_find(const kg_ruled_pair *pair, kg_crossings *out,
                           kg_error *error) KG_CHECKED;

/* Appends the stretch of a ruling that the rulings v of A and t of B share inside both
 * rectangles, if any. */
bool kg_shared_ruling(const kg_ruled_pair *pair, double v, double t, kg_crossings *out);

/* Two straight patches in one plane. */
bool kg_coplanar(const kg_patch *a, const kg_patch *b);
/* Do the rectangles of two coplanar patches overlap? */
bool kg_coplanar_overlap(const kg_patch *a, const kg_patch *b);

/* Are the surfaces one on a piece that begins next to the ruling v of A? */
bool kg_coincide_near(const kg_patch *a, double v, const kg_patch *b);

/* The one message for surfaces that coincide. */
kg_status kg_fail_coincident(kg_error *error) KG_CHECKED;

#endif
