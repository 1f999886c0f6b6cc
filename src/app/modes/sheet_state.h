/*
 * Folded sheets in the app: which step is shown, and where every corner of every layer is drawn.
 *
 * The document is its folds; what is done of them (kg_origami_step) is what the file holds. The
 * view is free of that: any step from the flat sheets to the last fold, also of those that were
 * taken back and could be done again, can be looked at, and any moment within a fold. Folding goes
 * on where the folds end, so a tool asks kg_sheets_can_fold first; kg_sheets_fold_from_here makes
 * the shown step the end.
 *
 * All arrays belong to `state`, which is the one after the fold under way, or after the last fold
 * shown when none is. They are made anew by every change of the document and of what is shown; a
 * tool that keeps indices of loops, edges or vertices compares `revision`. After a change within a
 * gesture they follow at once when the tool calls kg_editor_update.
 */
#ifndef KG_APP_MODES_SHEET_STATE_H
#define KG_APP_MODES_SHEET_STATE_H

#include "app/editor.h"

typedef enum kg_sheet_shape {
    KG_SHEET_SQUARE,
    KG_SHEET_RECTANGLE,
    KG_SHEET_A4,
    KG_SHEET_TRIANGLE, /* equilateral */
    KG_SHEET_POLYGON,  /* regular */
    KG_SHEET_SHAPE_COUNT
} kg_sheet_shape;

typedef struct kg_sheet_size {
    kg_sheet_shape shape;
    double width;  /* mm: of squares and triangles the side, of polygons from corner to corner */
    double height; /* mm, of rectangles */
    int sides;     /* of polygons, 3 … KG_SHEET_MOST_SIDES */
} kg_sheet_size;

enum { KG_SHEET_MOST_SIDES = 64 };

/* Indices of loops, edges or vertices of the state shown. */
typedef struct kg_sheet_marks {
    int32_t *items;
    size_t count, capacity;
} kg_sheet_marks;

struct kg_sheet_thumbs;

typedef struct kg_sheets {
    /* What is shown. Set by kg_sheets_show and its like. */
    size_t step;     /* folds done; fold `step` (from 0) is under way when fraction > 0 */
    double fraction; /* of its angle, in [0, 1) */
    bool playing;
    double played; /* s, of the fold under way */
    double pace;   /* s, of a whole fold */
    double target; /* where playing ends, folds */

    /* How; change them with kg_sheets_relayer. */
    double spread;  /* [0, 1]: layers drawn apart, to look between them */
    double opacity; /* [0, 1]: of paper; 1 hides what lies behind */

    /* Follows from them. */
    kg_origami *origami;           /* a copy, which keeps the states alive */
    const kg_origami_state *state; /* NULL when there was no memory: nothing is shown then */
    uint64_t topology;  /* another number whenever `state` is another: marks are gone then */
    uint64_t revision;  /* another number whenever anything drawn is */
    kg_vec3 *positions; /* of vertices, without thickness */
    kg_vec3 *normals;   /* unit, of the fronts of loops */
    kg_vec3 *drawn;     /* of half-edges: where the corner at the origin is drawn in its loop */
    double *heights;    /* of half-edges: layers towards the front of its loop that `drawn` lies off
                           `positions` */
    double layer;       /* mm from a layer to the next as drawn */

    /* What the tool sets: marked ones are drawn strongly, hovered ones (-1: none) lightly. */
    kg_sheet_marks loops, edges, vertices;
    int32_t hover_loop, hover_edge, hover_vertex;
    int32_t sheet; /* selected, from 0; -1: none */

    struct kg_sheet_thumbs *thumbs; /* NULL: none was needed yet */

    /* Of the panels. */
    size_t listed;      /* step that the list was scrolled to */
    const char *edited; /* field of a fold in the user's hands, NULL: none */
    double wish;        /* what stands in it */
    kg_sheet_size next_sheet;
} kg_sheets;

/* The state of the sheet mode; only while the document is of folded sheets. */
kg_sheets *kg_sheets_of(const kg_editor *editor);

/* ---- what is shown ----------------------------------------------------------------------- */

/* Shows the sheets after `folds` folds, in [0, kg_origami_fold_count]: 2.25 is a quarter of the
 * third one. Stops what plays. */
void kg_sheets_show(kg_editor *editor, double folds);
/* What is shown, as kg_sheets_show takes it. */
double kg_sheets_shown(const kg_sheets *sheets);
/* Plays from `from` to `to`, both in folds, about a second each; the app is busy until then. */
void kg_sheets_play(kg_editor *editor, double from, double to);
/* Plays the last fold done, faster: how a tool shows what it has just made, after
 * kg_editor_update. */
void kg_sheets_play_made(kg_editor *editor);
/* Shows at once what playing would end with. */
void kg_sheets_skip(kg_editor *editor);
void kg_sheets_stop(kg_editor *editor);
/* Draws the layers anew after `spread` was changed. */
void kg_sheets_relayer(kg_editor *editor);

/* Whether a fold may be made: the step shown is the last one done, and no fold is under way. */
bool kg_sheets_can_fold(const kg_editor *editor);
/* Why not, translated; NULL: it may. */
const char *kg_sheets_why_not(const kg_editor *editor);
/* Makes the step shown the last one done, as one step of the history; folds behind it can be done
 * again until another is made. The fold under way counts as not done. */
kg_status kg_sheets_fold_from_here(kg_editor *editor, kg_error *error) KG_CHECKED;

/* ---- marks ------------------------------------------------------------------------------- */

void kg_sheets_unmark(kg_editor *editor); /* all, and what is hovered */
bool kg_sheets_is_marked(const kg_sheet_marks *marks, int32_t index);

/* Another one that shows the sheets after `step` folds, for a picture of its own; clear it after
 * use, while `sheets` still lives. False without memory. */
bool kg_sheets_snapshot(const kg_sheets *sheets, size_t step, kg_sheets *out);
void kg_sheets_snapshot_clear(kg_sheets *snapshot);

/* ---- life: for the mode ------------------------------------------------------------------ */

kg_status kg_sheets_create(const kg_document *document, void **out_state, kg_error *error);
void kg_sheets_destroy(void *state);
void kg_sheets_follow(kg_editor *editor);
bool kg_sheets_tick(kg_editor *editor, double seconds);
/* Bounds of all steps, or (`selection`) of what is shown. */
kg_box3 kg_sheets_box(const kg_editor *editor, bool selection);
/* Just below flat sheets; none when seen from below. */
bool kg_sheets_ground(const kg_editor *editor, double *out_z);

#endif
