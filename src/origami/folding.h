/* One fold while it is being worked out. */
#ifndef KG_ORIGAMI_FOLDING_H
#define KG_ORIGAMI_FOLDING_H

#include "origami/layers.h"

/* The moving side turns about the line through `origin` along `axis` so that `side` goes towards
 * `normal` when the angle is positive: axis = side × normal. All unit, perpendicular. */
typedef struct kg_fold_axis {
    kg_vec3 origin, axis, side, normal;
    double angle; /* signed */
    int32_t group;
} kg_fold_axis;

/* Why a fold was refused, where that is more than words can say. */
typedef struct kg_fold_blame {
    kg_fold_fault fault;
    int32_t faces[2]; /* of the state it starts from; -1: none */
    double angle;     /* turned when they first touch */
} kg_fold_blame;

typedef struct kg_folding {
    const kg_origami_state *state; /* the one it starts from */
    kg_fold_axis axis;
    kg_outlines outlines;
    signed char *sides; /* of vertices in the group's plane: 1 moving side, -1, 0 on the axis; -2 in
                           other planes */
    signed char *reach; /* of loops in the group, bits: 1 some corner beyond the axis, 2 some on the
                           resting side */
    bool *moves;        /* loops that move; those across the axis with their part beyond it */
    uint64_t *picked;   /* bits of loops in the group that have a corner at the chosen vertex */
    uint64_t *open;     /* bits of loops that do not move but could: all in other planes, in the
                           group those with a corner beyond the axis */
    kg_fold_blame blame;
} kg_folding;

/* Prepares a fold up to its axis. */
kg_status kg_folding_create(const kg_origami_state *state, const kg_fold *fold, kg_folding *out,
                            kg_error *error);
void kg_folding_clear(kg_folding *folding);

/* Nothing moves yet. */
void kg_folding_rest(kg_folding *folding);
/* Finds out what moves: the picked layers at the vertex and all that follows from them. */
kg_status kg_folding_pick(kg_folding *folding, const kg_fold *fold, kg_error *error);
/* Adds a loop and everything that must move along with it: what is joined beyond the axis and what
 * lies in the way, repeatedly. KG_ERR_INPUT when a loop would have to stay and to move. */
kg_status kg_folding_move(kg_folding *folding, int32_t loop, kg_error *error);

/* Turns a point by `angle`; exact for multiples of a quarter turn. */
kg_vec3 kg_fold_turn(const kg_fold_axis *axis, kg_vec3 point, double angle);
/* Direction in which a point starts to move, when it is on the moving side; its length is the
 * distance from the axis. */
kg_vec3 kg_fold_velocity(const kg_fold_axis *axis, kg_vec3 point);
/* Distance from the axis. */
double kg_fold_radius(const kg_fold_axis *axis, kg_vec3 point);

/* Where two sets of loops first meet. */
typedef struct kg_collision {
    int32_t moving, resting; /* loops */
    double angle;            /* turned so far, absolute, in [0, |angle|] */
} kg_collision;

/* Sweeps the moving loops (`moves`, one per loop, none across the axis) against all others. True
 * when they would pass through one another; touching is no collision, nor is lying on each other
 * at the start or the end. */
kg_status kg_sweep(const kg_origami_state *state, const kg_fold_axis *axis, const bool *moves,
                   bool *out_collides, kg_collision *out_collision) KG_CHECKED;

/* What becomes of each loop when those across the axis are cut. */
typedef struct kg_fold_parts {
    int32_t *children; /* per loop of the state before: its moving part, -1 when not cut */
    bool *moves;       /* per loop after */
} kg_fold_parts;

/* Works out the orders of `after`, which has its positions and groups and no orders yet, from those
 * before. */
kg_status kg_fold_land(const kg_folding *folding, const kg_fold *fold, const kg_fold_parts *parts,
                       kg_origami_state *after, kg_error *error);

/* Does the fold when it is known what moves. `out_moves` (may be NULL) receives for each loop of
 * the new state whether it moved; free() it. */
kg_status kg_folding_finish(kg_folding *folding, const kg_fold *fold, kg_origami_state **out_state,
                            bool **out_moves, kg_error *error) KG_CHECKED;

/* `fold` done to `state`. */
kg_status kg_state_fold(const kg_origami_state *state, const kg_fold *fold,
                        kg_origami_state **out_state, kg_error *error) KG_CHECKED;
/* The axis alone, for animation. */
kg_status kg_state_fold_axis(const kg_origami_state *state, const kg_fold *fold,
                             kg_fold_axis *out_axis, kg_error *error) KG_CHECKED;

#endif
