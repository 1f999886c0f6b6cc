/*
 * The fold being made: shared by the fold tool, its commands and its panel.
 *
 * A fold is given in one of four ways, after Huzita's axioms 2, 1, 3 and 4. Whatever the way, it
 * is worked out anew by every movement of the pointer (kg_fold_try), which changes no document; it
 * is made by kg_fold_done.
 */
#ifndef KG_APP_TOOLS_FOLD_H
#define KG_APP_TOOLS_FOLD_H

#include "app/modes/sheet_pick.h"
#include "app/tools/tool.h"

typedef enum kg_fold_way {
    KG_WAY_DRAG,   /* a vertex to where it goes */
    KG_WAY_AXIS,   /* along an edge, or through two points */
    KG_WAY_BISECT, /* an edge onto another */
    KG_WAY_SQUARE, /* through a point at right angles to an edge */
    KG_WAY_COUNT
} kg_fold_way;

typedef enum kg_fold_phase {
    KG_PHASE_READY,
    KG_PHASE_DRAGGING, /* a vertex is held */
    KG_PHASE_SECOND,   /* a point or an edge is chosen, another one is wanted */
    KG_PHASE_SIDE,     /* the axis is known; which side moves? */
    KG_PHASE_HELD      /* all is known; Enter makes the fold */
} kg_fold_phase;

/* What a place under the pointer was drawn to. */
typedef enum kg_snap_kind {
    KG_SNAP_FREE,
    KG_SNAP_GRID,
    KG_SNAP_LINE, /* on a bisector, or where the crease goes through a vertex */
    KG_SNAP_EDGE,
    KG_SNAP_SYMMETRIC, /* where such a line meets an edge */
    KG_SNAP_MIDDLE,
    KG_SNAP_CROSSING,
    KG_SNAP_VERTEX
} kg_snap_kind;

typedef struct kg_snap {
    kg_snap_kind kind;
    kg_vec3 point;
    int32_t half;     /* EDGE: one of its half-edges */
    kg_vec3 guide[2]; /* LINE, SYMMETRIC: from where the point follows; equal: none */
} kg_snap;

/* A straight line of paper: an edge, with the place on it that was clicked. */
typedef struct kg_fold_edge {
    kg_vec3 ends[2], at;
    int32_t half; /* of the layer that was clicked */
} kg_fold_edge;

typedef struct kg_fold_tool {
    kg_fold_way way;
    kg_fold_phase phase;
    double angle_deg; /* of the next fold; positive: towards the eye */
    bool keeps_angle; /* of the folds after it too, which else are flat */
    int32_t layers;   /* wanted; KG_ALL_LAYERS */
    char typed[12];   /* digits of the angle */

    uint64_t topology; /* of the sheets when `group` was set */
    int32_t group;     /* whose plane is folded in */
    int sign;          /* 1: its normal points to the eye that chose it, else -1 */
    int32_t picked;    /* the loop under the pointer at the vertex; -1 */
    int32_t vertex;    /* in the drag way: under the pointer, or held; -1 */
    kg_vec2 pressed;
    kg_snap snap;
    bool aimed; /* `snap` is meaningful */
    kg_fold_edge edge;
    kg_vec3 first;   /* of two points */
    kg_vec3 axis[2]; /* from SIDE on */

    bool given; /* `fold` and what follows are meaningful */
    kg_fold fold;
    kg_fold_preview preview;
    bool refused;
    char reason[KG_ERROR_SIZE]; /* why, translated */
    kg_fold_gap *gaps;          /* found when first asked for; NULL: not yet */
    size_t gap_count;
    int32_t between[2]; /* faces chosen to end between; -1, -1: outside */

    int32_t *pile; /* of loops at `vertex`: 1 the topmost …, 0 elsewhere; NULL: none */
    int32_t pile_count;
    int32_t shown_layer; /* of the panel, under the pointer; 0: none */
} kg_fold_tool;

#define KG_ALL_LAYERS 1000000

/* The state of the fold tool; NULL while another one is in use or when memory runs out. */
kg_fold_tool *kg_fold_tool_of(kg_editor *editor);
/* The same for looking at it; NULL also before the first event. */
const kg_fold_tool *kg_fold_tool_seen(const kg_editor *editor);

/* ---- what the commands and the panel do ---------------------------------------------------- */

/* Starts anew in a way, with the fold tool. */
void kg_fold_use_way(kg_editor *editor, kg_fold_way way);
/* Drops what was chosen so far. */
void kg_fold_drop(kg_editor *editor);
/* In [-180, 180]; 0 counts as 180. */
void kg_fold_set_angle(kg_editor *editor, double angle_deg);
void kg_fold_set_layers(kg_editor *editor, int32_t layers);
/* How many move, as far as known, and how many there are (0: nobody knows yet). */
int32_t kg_fold_layers_now(const kg_fold_tool *tool, int32_t *out_count);
/* Looks for the gaps of the fold being made, if that was not done yet. */
void kg_fold_find_gaps(kg_editor *editor);
/* 0: outside, else gaps[gap - 1]. */
size_t kg_fold_gap_now(const kg_fold_tool *tool);
void kg_fold_set_gap(kg_editor *editor, size_t gap);
/* Folds the document as one step of the history. */
kg_status kg_fold_add(kg_editor *editor, const kg_fold *fold, kg_error *error) KG_CHECKED;
/* Makes the fold, with its animation; KG_ERR_INPUT when it is refused or there is none. */
kg_status kg_fold_done(kg_editor *editor, kg_error *error) KG_CHECKED;
/* Folds what the last fold folded back where it was, as one step of the history: its crease stays.
 * KG_ERR_INPUT when other paper is in the way, or there is none. */
kg_status kg_fold_back(kg_editor *editor, kg_error *error) KG_CHECKED;
/* What would help, translated; NULL: the reason says all. */
const char *kg_fold_advice(const kg_fold_tool *tool);

/* ---- among the files of the tool ------------------------------------------------------------ */

/* Works out `fold`, whose angle, layers and gap are set here. */
void kg_fold_try(kg_editor *editor, kg_fold fold);
void kg_fold_forget(kg_fold_tool *tool);
/* Whether a loop has a corner at a point. */
bool kg_fold_has_corner(const kg_origami_state *state, int32_t loop, kg_vec3 point);
/* The loops with a corner at a vertex, in the group, from the topmost as it folds. */
void kg_fold_find_pile(kg_editor *editor, kg_fold_tool *tool);

/* The point of the group's plane under a pixel, drawn to what is near: with `from`, the place of a
 * vertex that is dragged, also to where the crease then goes through vertices or halves an angle.
 * Ctrl: to steps; Alt: to nothing. False: the plane is seen edge-on. */
bool kg_snap_find(const kg_editor *editor, const kg_fold_tool *tool, kg_vec2 px, unsigned mods,
                  const kg_vec3 *from, kg_snap *out);

/* The axis that brings one edge onto another, places clicked onto each other's sides; false when
 * they lie on one line. */
bool kg_axis_bisect(const kg_fold_edge *moving, const kg_fold_edge *resting, kg_vec3 out_axis[2]);
/* Through a point at right angles to an edge, in the plane of `normal`. */
bool kg_axis_square(const kg_fold_edge *edge, kg_vec3 point, kg_vec3 normal, kg_vec3 out_axis[2]);

void kg_fold_draw(const kg_editor *editor, kg_overlay *overlay);

#endif
