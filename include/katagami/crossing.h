/*
 * katagami: where two patches cross.
 *
 * The rulings of two ruled surfaces meet where
 *
 *     F(v,t) = det(R_A(v), R_B(t), p_B(t) - p_A(v)) = 0
 *
 * a polynomial of bidegree (9,9) for two cubics (Heo, Kim, Elber 1999, "The intersection of two
 * ruled surfaces"). Its zero set inside both rectangles is the crossing, found with all branches.
 */
#ifndef KATAGAMI_CROSSING_H
#define KATAGAMI_CROSSING_H

#include "katagami/patch.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One point of both surfaces: A at (u, v), B at (s, t), both at x within KG_CROSSING_EXACT of the
 * patches' size. */
typedef struct kg_cross_point {
    double u, v;
    double s, t;
    kg_vec3 x;
} kg_cross_point;

/* Residual, as a fraction of the larger patch, that every point is polished to. */
#define KG_CROSSING_EXACT 1e-9

/* Sides of the two rectangles, as bits: where a branch ends. */
enum {
    KG_SIDE_A_U_LO = 1,
    KG_SIDE_A_U_HI = 2,
    KG_SIDE_A_V_LO = 4,
    KG_SIDE_A_V_HI = 8,
    KG_SIDE_B_U_LO = 16,
    KG_SIDE_B_U_HI = 32,
    KG_SIDE_B_V_LO = 64,
    KG_SIDE_B_V_HI = 128,
    KG_SIDES_A = 15,
    KG_SIDES_B = 240
};

/* One branch: a curve without crossings of itself, as points whose chords are within the wished
 * tolerance of it in space and on both papers. A closed branch repeats its first point at the
 * end. A branch end on a side has that coordinate exactly. */
typedef struct kg_crossing {
    size_t count; /* at least 2 */
    kg_cross_point *points;
    bool closed;
    unsigned ends[2]; /* sides on which the first and last point lie; 0 for a closed branch, or at
                         a point where branches meet */
} kg_crossing;

typedef struct kg_crossings {
    size_t count;
    kg_crossing *branches; /* in an order that depends on the geometry alone */
} kg_crossings;

/* All branches inside both rectangles (the extents in force). None is not an error. The points are
 * the same whichever patch comes first. Surfaces that touch without passing through each other do
 * not cross there; a stretch that looks into a rectangle by less than the tolerance may be left
 * out. A ruling that both patches share is a branch, unless they are tangent along it.
 *   tolerance  mm, greatest chord error; below 1e-6 of the patches' size, that is taken
 * KG_ERR_INPUT: the surfaces coincide on a piece. */
KG_API kg_status kg_crossings_find(const kg_patch *a, const kg_patch *b, double tolerance,
                                   kg_crossings *out_crossings, kg_error *error) KG_CHECKED;

KG_API void kg_crossings_clear(kg_crossings *crossings);

/* The exact point of the branch between points `i` and `i + 1`, in the plane square to that chord
 * at `fraction` of it, with its derivative by fraction (out_slope: u, v, s, t, x; may be NULL).
 * Smooth in `fraction`, so lengths and areas can be had by quadrature. Only in the span next to a
 * point where the surfaces touch or branches meet the plane may hold no point: then one on both
 * surfaces near the fraction is given, and the chord as slope. */
KG_API kg_cross_point kg_crossing_at(const kg_patch *a, const kg_patch *b,
                                     const kg_crossing *branch, size_t i, double fraction,
                                     kg_cross_point *out_slope);

/* The same with the roles of A and B exchanged, in place: u,v <-> s,t and the sides' bits. */
KG_API void kg_crossings_swap(kg_crossings *crossings);

#ifdef __cplusplus
}
#endif
#endif
