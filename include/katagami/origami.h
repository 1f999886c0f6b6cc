/*
 * katagami: folding mode, sheets folded step by step and crease patterns folded flat.
 *
 * A kg_origami is sheets and a list of folds; its states follow from them by replay, so the same
 * folds always give the same bits. A state is a half-edge model of all sheets together, with the
 * planes its loops lie in and the order of loops that lie on each other. After Teramoto, "An
 * interactive origami simulator" (2007); the layer orders of finished patterns after Akitaya,
 * Demaine and Ku, "Computing flat-folded states" (2023).
 *
 * Lengths are millimetres, angles radians but where a name ends in _deg.
 */
#ifndef KATAGAMI_ORIGAMI_H
#define KATAGAMI_ORIGAMI_H

#include "katagami/base.h"
#include "katagami/net.h"

#ifdef __cplusplus
extern "C" {
#endif

struct json_t;

/* ---- states ----------------------------------------------------------------------------- */

/* Kinds of edges. */
typedef enum kg_paper_edge_kind {
    KG_PAPER_BORDER, /* paper on one side only */
    KG_PAPER_CREASE, /* folded, or folded once and flat again */
    KG_PAPER_JOIN,   /* no crease: where a concave face is divided into convex loops */
    KG_PAPER_OPEN    /* a crease that is neither mountain nor valley yet (crease patterns) */
} kg_paper_edge_kind;

typedef struct kg_paper_vertex {
    kg_vec2 paper;    /* on its sheet, in the sheet's own coordinates */
    kg_vec3 position; /* in space */
    int32_t sheet;
} kg_paper_vertex;

/* Half-edges 2 e and 2 e + 1 are the two directions of edge e: the twin of h is h ^ 1. */
typedef struct kg_half_edge {
    int32_t origin; /* vertex it starts from */
    int32_t next;   /* around its loop; meaningless outside the paper */
    int32_t loop;   /* the loop on its left, -1 outside the paper */
} kg_half_edge;

typedef struct kg_paper_edge {
    kg_paper_edge_kind kind;
    double angle; /* of folding, in [-π, π]: positive valley, negative mountain, seen from the
                     front; 0 flat */
} kg_paper_edge;

/* A convex piece of paper; its half-edges run counter-clockwise seen from the front. */
typedef struct kg_paper_loop {
    int32_t first; /* one of its half-edges */
    int32_t sheet;
    int32_t group;
    int32_t parent; /* the loop it was cut off by a fold, of lower index, which goes on as the rest;
                       -1: it was there from the start */
} kg_paper_loop;

/* A plane that loops lie in: { x : normal · x = offset }. */
typedef struct kg_face_group {
    kg_vec3 normal;
    double offset;
} kg_face_group;

/* Loops a < b lie on each other; b on the front of a (side 1) or on its back (-1). */
typedef struct kg_layer_order {
    int32_t a, b;
    int32_t side;
} kg_layer_order;

typedef struct kg_origami_state {
    struct {
        kg_paper_vertex *items;
        size_t count, capacity;
    } vertices;
    struct {
        kg_half_edge *items;
        size_t count, capacity;
    } halves;
    struct {
        kg_paper_edge *items;
        size_t count, capacity;
    } edges;
    struct {
        kg_paper_loop *items;
        size_t count, capacity;
    } loops;
    struct {
        kg_face_group *items; /* may hold planes that no loop lies in any more */
        size_t count, capacity;
    } groups;
    struct {
        uint64_t *bits; /* two rows for each loop, of one bit for each loop: what lies on its back,
                           then what lies on its front; see kg_origami_order */
        size_t words;   /* of one row */
    } layers;
    double size;  /* mm, the longest side around all flat sheets; tolerances grow with it */
    double touch; /* mm: overlaps narrower than this are none, paper that merely touches */
} kg_origami_state;

/* 1: loop b is in front of loop a, -1: behind it, 0: they do not overlap. */
KG_API int kg_origami_order(const kg_origami_state *state, int32_t a, int32_t b);
/* The pair of overlapping loops that follows `*order`, by a, then b; the first one follows {0}.
 * False: there is none. */
KG_API bool kg_origami_next_order(const kg_origami_state *state, kg_layer_order *order);
/* How many there are. */
KG_API size_t kg_origami_pair_count(const kg_origami_state *state);

/* Unit normal of the front of a loop. */
KG_API kg_vec3 kg_origami_normal(const kg_origami_state *state, int32_t loop);

/* ---- sheets and folds ------------------------------------------------------------------- */

/* Colours of sheets that name none, 0xrrggbb. */
#define KG_SHEET_FRONT 0xcc3333
#define KG_SHEET_BACK 0xffffff

typedef struct kg_paper_sheet {
    size_t count;
    kg_vec2 *polygon;     /* simple, any direction, in the plane z = 0 */
    uint32_t front, back; /* colours, 0xrrggbb */
    struct json_t *json;  /* the object as read, for its unknown keys; may be NULL */
} kg_paper_sheet;

/* One fold, in the coordinates of the state it starts from. Points within a thousandth of the
 * state's size of a vertex mean that vertex. */
typedef struct kg_fold {
    bool by_axis;      /* an axis and a vertex on the moving side, else `from` and `to` */
    kg_vec3 points[2]; /* two points of the axis, or where a vertex is and where it goes when folded
                          flat */
    kg_vec3 vertex;    /* by_axis only */
    double angle_deg;  /* in [-180, 180], not 0; positive: towards the normal of the picked loop's
                          group */
    int32_t face;   /* the picked loop; -1: the topmost at the vertex, seen from the side it folds
                       to */
    int32_t layers; /* how many layers at the vertex move, from the picked one down; all that
                       lies above them moves along. 0 means 1 */
    int32_t between[2];  /* a flat fold ends between these two loops; -1, -1: outside all */
    struct json_t *json; /* the object as read, for its unknown keys; may be NULL */
} kg_fold;

/* A fold from a vertex to a point, flat, of the topmost layer. */
KG_API kg_fold kg_fold_default(void);

typedef struct kg_origami kg_origami;

/* No sheets yet and no folds. NULL when memory runs out; destroying NULL is fine. */
KG_API kg_origami *kg_origami_create(void);
KG_API void kg_origami_destroy(kg_origami *origami);
/* All of it, with the folds that can be done again. States, which never change, are shared, so that
 * a copy costs no more than its lists; copies may be used by different threads. NULL when memory
 * runs out. */
KG_API kg_origami *kg_origami_copy(const kg_origami *origami);
/* Do both hold the same: title, sheets, colours, folds done and to be done again, and all keys of
 * their files? */
KG_API bool kg_origami_equal(const kg_origami *a, const kg_origami *b);

/* Puts a sheet on top of the others (copied). Only before the first fold, and not in crease
 * patterns; folds that could be done again are forgotten. Errors: KG_ERR_INPUT for polygons of
 * fewer than 3 corners, that cross or touch themselves, without area, or beyond 1e6 mm;
 * KG_ERR_MEMORY. */
KG_API kg_status kg_origami_add_sheet(kg_origami *origami, const kg_paper_sheet *sheet,
                                      kg_error *error) KG_CHECKED;
/* Takes a sheet away, or gives it another polygon (copied): moved, turned or cut otherwise. When
 * and errors as above; also KG_ERR_INPUT for no such sheet. */
KG_API kg_status kg_origami_remove_sheet(kg_origami *origami, size_t index,
                                         kg_error *error) KG_CHECKED;
KG_API kg_status kg_origami_place_sheet(kg_origami *origami, size_t index, const kg_vec2 *polygon,
                                        size_t count, kg_error *error) KG_CHECKED;
KG_API size_t kg_origami_sheet_count(const kg_origami *origami);
KG_API const kg_paper_sheet *kg_origami_sheet(const kg_origami *origami, size_t index);

/* The state after the first `step` folds, up to kg_origami_step(). */
KG_API const kg_origami_state *kg_origami_state_at(const kg_origami *origami, size_t step);
/* How many folds are done; those behind them can be done again. */
KG_API size_t kg_origami_step(const kg_origami *origami);
KG_API size_t kg_origami_fold_count(const kg_origami *origami);
KG_API const kg_fold *kg_origami_fold_at(const kg_origami *origami, size_t index);

/* Folds the last state and takes what could be done again out of the list. KG_ERR_INPUT with the
 * reason when paper cannot do it: no such vertex, an axis beside the paper, a loop that would have
 * to stay and to move, paper in the way (the two faces and the angle where they first touch),
 * joined edges that keep it from going between two layers. */
KG_API kg_status kg_origami_fold(kg_origami *origami, const kg_fold *fold,
                                 kg_error *error) KG_CHECKED;
/* One fold back, one forth; false when there is none. States come back bit for bit. */
KG_API bool kg_origami_undo(kg_origami *origami);
KG_API bool kg_origami_redo(kg_origami *origami);
/* Takes fold `index` out and replays those behind it. KG_ERR_INPUT, with everything as it was, when
 * one of them cannot be done without it. */
KG_API kg_status kg_origami_unfold(kg_origami *origami, size_t index, kg_error *error) KG_CHECKED;

/* ---- folds being made ------------------------------------------------------------------- */

/* Why a fold is refused, where it is more than the message says. */
typedef enum kg_fold_fault {
    KG_FOLD_OTHER,    /* see the message */
    KG_FOLD_IN_WAY,   /* face [0] would pass through face [1] */
    KG_FOLD_AT_EDGE,  /* two faces would pass through each other at the edge they share */
    KG_FOLD_HELD,     /* face [0] would pull at face [1], which something at rest holds */
    KG_FOLD_ALL_MOVES /* the axis is beside the paper */
} kg_fold_fault;

/* What a fold would do. Faces are those of the state it starts from. */
typedef struct kg_fold_preview {
    bool has_axis;                      /* false: nothing below is known */
    kg_vec3 origin, axis, side, normal; /* a point of the axis, its direction, the side that moves,
                                           the group's normal; unit */
    double angle;                       /* radians, signed: positive towards the normal */
    int32_t group;
    int32_t layer_count; /* how many layers can move */
    int32_t *layers;     /* of each loop: with the first so many it moves; 0: with none */
    size_t part_count;   /* pieces that move */
    kg_vec3 *points;     /* their corners as they lie before the fold … */
    size_t *starts;      /* … of piece i from starts[i] up to starts[i + 1] */
    int32_t *loops;      /* that each is part of */
    size_t crease_count;
    kg_vec3 *creases; /* two ends each: where loops are cut */
    kg_fold_fault fault;
    int32_t faces[2]; /* to blame, -1: none */
    double meets_deg; /* turned when they first touch, >= 0 */
} kg_fold_preview;

/* Works out a fold of `state` without doing it. Errors are those of kg_origami_fold; `out` then
 * holds as much as is known and is to be cleared all the same. */
KG_API kg_status kg_fold_preview_make(const kg_origami_state *state, const kg_fold *fold,
                                      kg_fold_preview *out, kg_error *error) KG_CHECKED;
KG_API void kg_fold_preview_clear(kg_fold_preview *preview);
/* A point of the moving part after `fraction` of the angle. */
KG_API kg_vec3 kg_fold_preview_turn(const kg_fold_preview *preview, kg_vec3 point, double fraction);

/* Two faces that a flat fold can end between, for kg_fold.between. */
typedef struct kg_fold_gap {
    int32_t lower, upper; /* seen from the side it folds to */
    int32_t depth;        /* layers that lie above the gap */
} kg_fold_gap;

/* Gaps between faces at rest that a fold can end in, from the top down; of those that come to the
 * same only one, and no more than 64. Where thousands of layers lie on each other only the
 * uppermost are tried. free() the list. Errors as above, of the fold that ends outside. */
KG_API kg_status kg_fold_gaps(const kg_origami_state *state, const kg_fold *fold,
                              kg_fold_gap **out_gaps, size_t *out_count,
                              kg_error *error) KG_CHECKED;

/* ---- between two steps -------------------------------------------------------------------- */

/* Positions of the vertices of step `step` while fold `step` is under way: `fraction` in [0, 1] of
 * its angle. `out_positions` holds as many as the state at `step` + 1, whose topology it is. */
KG_API void kg_origami_between(const kg_origami *origami, size_t step, double fraction,
                               kg_vec3 *out_positions);

/* Colours of a sheet, 0xrrggbb; of sheets of imported patterns, red and white. */
KG_API void kg_origami_colors(const kg_origami *origami, int32_t sheet, uint32_t *out_front,
                              uint32_t *out_back);
/* Whether it began as a crease pattern, whose sheets stay as they are. */
KG_API bool kg_origami_is_pattern(const kg_origami *origami);
/* At any time. Sheets of crease patterns are then listed, as the boxes around them, for their
 * colours. KG_ERR_INPUT: there is no such sheet. */
KG_API kg_status kg_origami_set_colors(kg_origami *origami, size_t sheet, uint32_t front,
                                       uint32_t back, kg_error *error) KG_CHECKED;

/* ---- drawing ---------------------------------------------------------------------------- */

/* Heights at which the layers of each group are drawn, in layers above the group's plane along its
 * normal, so that loops on each other are seen in their order from both sides: one number for every
 * half-edge, the height of its origin in its loop (0 outside the paper). Loops stay flat but in
 * groups where they lie over one another in a ring; there each corner counts the layers below it.
 * Errors: KG_ERR_MEMORY. */
KG_API kg_status kg_origami_heights(const kg_origami_state *state, double *out_heights,
                                    kg_error *error) KG_CHECKED;

/* ---- crease patterns -------------------------------------------------------------------- */

/* What was found out about the layers of a folded crease pattern. */
typedef struct kg_layer_report {
    double most_states; /* in: stop counting a component at this many, > 0 */
    double most_steps;  /* in: give up after this much work: clauses looked at, > 0 */
    size_t pairs;       /* of loops that overlap */
    size_t variables;   /* of them, those that the joined edges leave free of each other */
    size_t components;  /* sets of free ones that do not depend on each other, each with a choice */
    double states;      /* ways to order all layers */
    bool exact;         /* false: at least so many */
    double mm_per_unit; /* what a file that names no unit was scaled by; 0: nothing of the kind */
} kg_layer_report;

/* The longer side of new sheets, and of crease patterns without a unit, mm. */
#define KG_SHEET_SIZE 150.0

/* 1e6 states of each component, 1e8 steps, which are a few seconds. */
KG_API kg_layer_report kg_layer_report_default(void);

/* Reads a crease pattern: FOLD 1.2 (.fold: its first frame with flat vertices) or .cp (lines
 * `type x1 y1 x2 y2`: 1 border, 2 mountain, 3 valley, 4 flat), folds it as its angles say and finds
 * the order of its layers, unless the file holds it. The first state is the folded one; folds may
 * follow. Coordinates become mm by the frame_unit of a FOLD file; where that names none, its
 * pattern is made KG_SHEET_SIZE long. Errors: KG_ERR_PARSE naming file and line; KG_ERR_INPUT when
 * it cannot be folded flat: the vertex that breaks Kawasaki's or Maekawa's condition, or that no
 * order of layers is possible, which is proved; KG_ERR_CANCELLED when most_steps did not suffice,
 * or when `progress`, which is told while layers are looked for, said so: the report is then as it
 * was. `progress` and `report` may be NULL. */
KG_API kg_status kg_origami_import(const char *path, const kg_progress *progress,
                                   kg_origami **out_origami, kg_layer_report *report,
                                   kg_error *error) KG_CHECKED;
KG_API kg_status kg_origami_import_memory(const char *data, size_t size, const char *name,
                                          const kg_progress *progress, kg_origami **out_origami,
                                          kg_layer_report *report, kg_error *error) KG_CHECKED;

/* Counts the orders that the layers of the first state could have, whatever the one they have.
 * Errors as of kg_origami_import. */
KG_API kg_status kg_origami_count_orders(const kg_origami *origami, const kg_progress *progress,
                                         kg_layer_report *report, kg_error *error) KG_CHECKED;

/* Writes NAME.fold: the crease pattern as first frame, the folded state of `step` with its
 * faceOrders as second, and, when `all_steps`, a frame for every step before it; or NAME.cp: the
 * crease pattern. */
KG_API kg_status kg_origami_export(const kg_origami *origami, size_t step, bool all_steps,
                                   const char *path, kg_error *error) KG_CHECKED;
KG_API kg_status kg_origami_fold_text(const kg_origami *origami, size_t step, bool all_steps,
                                      char **out_text, size_t *out_size,
                                      kg_error *error) KG_CHECKED;

/* The crease pattern of a state as a net: one part per sheet, mountains and valleys as folds and
 * what was unfolded again as marks, seen from the front. KG_ERR_MEMORY. */
KG_API kg_status kg_origami_net(const kg_origami *origami, size_t step, kg_net **out_net,
                                kg_error *error) KG_CHECKED;

/* ---- files ------------------------------------------------------------------------------ */

/* Reads an origami model ("-": standard input) and replays its folds. KG_ERR_PARSE, KG_ERR_INPUT:
 * the message names file, line and fold. */
KG_API kg_status kg_origami_read(const char *path, kg_origami **out_origami,
                                 kg_error *error) KG_CHECKED;
KG_API kg_status kg_origami_read_memory(const char *data, size_t size, const char *name,
                                        kg_origami **out_origami, kg_error *error) KG_CHECKED;
/* Writes the whole file or nothing. Unknown keys survive. */
KG_API kg_status kg_origami_write(const kg_origami *origami, const char *path,
                                  kg_error *error) KG_CHECKED;
KG_API kg_status kg_origami_write_memory(const kg_origami *origami, char **out_text,
                                         size_t *out_size, kg_error *error) KG_CHECKED;
/* Never NULL. */
KG_API const char *kg_origami_title(const kg_origami *origami);
/* How nets of it are written unless a command says otherwise. */
KG_API kg_net_settings *kg_origami_net_settings(kg_origami *origami);
KG_API kg_status kg_origami_set_title(kg_origami *origami, const char *title,
                                      kg_error *error) KG_CHECKED;

#ifdef __cplusplus
}
#endif
#endif
