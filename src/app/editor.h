/*
 * The editor: a document with its history, what is selected, and how it is looked at. Commands and
 * tools change it; panels and the scene show it. It needs no window, so `katagami apply` runs the
 * same commands.
 *
 * Every change of the model happens between kg_editor_begin and kg_editor_commit, which makes it
 * one step of the history, or kg_editor_cancel. Steps are gestures: press to release.
 */
#ifndef KG_APP_EDITOR_H
#define KG_APP_EDITOR_H

#include "app/backdrop.h"
#include "app/history.h"
#include "app/mending.h"
#include "app/pane.h"
#include "app/settings.h"
#include "app/surfaces.h"
#include "katagami/document.h"

/* Chord error of what is shown, mm: at most a pixel, and cheap enough to follow a dragged point.
 * Whatever is written is solved anew with its own. */
#define KG_EDITOR_CHORD 0.05

typedef struct kg_tool kg_tool;
typedef struct kg_mode kg_mode;

typedef enum kg_level { KG_LEVEL_POINTS, KG_LEVEL_PATCHES } kg_level;

typedef struct kg_point_ref {
    int64_t patch;
    size_t index;
} kg_point_ref;

/* Patches in the order they were selected: the first is trimmed, the others trim it. */
typedef struct kg_selection {
    struct {
        int64_t *items;
        size_t count, capacity;
    } patches;
    struct {
        kg_point_ref *items;
        size_t count, capacity;
    } points;
} kg_selection;

/* What a command asks of the window around the editor. */
typedef enum kg_request {
    KG_REQUEST_NONE,
    KG_REQUEST_NEW,
    KG_REQUEST_NEW_CARD,
    KG_REQUEST_NEW_SHEETS,
    KG_REQUEST_CARD_FROM_MESH,
    KG_REQUEST_OPEN,
    KG_REQUEST_SAVE_AS,
    KG_REQUEST_REFERENCE,
    KG_REQUEST_EXPORT_NET,
    KG_REQUEST_EXPORT_MESH,
    KG_REQUEST_EXPORT_GUIDE,
    KG_REQUEST_STAND, /* the card is to be made to stand */
    KG_REQUEST_QUIT,
    KG_REQUEST_PALETTE,
    KG_REQUEST_HELP,
    KG_REQUEST_SETTINGS,
    KG_REQUEST_RENAME,
    KG_REQUEST_MENU,
    KG_REQUEST_ERROR /* the message is worth a dialog */
} kg_request;

typedef struct kg_editor {
    kg_document *document; /* never NULL, always solved */
    const kg_mode *mode;   /* of the document's kind */
    void *mode_state;      /* the mode's own */
    char *path;            /* NULL: never saved */
    kg_history history;
    uint64_t state, saved_state, next_state; /* numbers of states of the document */
    uint64_t autosaved_state;
    kg_document *before; /* in a gesture: the document when it began */
    char gesture[64];
    bool stale;      /* the document changed since it was solved */
    uint64_t solved; /* counts the solutions */

    kg_selection selection;
    kg_level level;
    kg_point_ref hover_point; /* patch 0: none */
    int64_t hover_patch;      /* 0: none; in whatever view it is hovered */
    int64_t hover_seam[2];    /* patches that meet under the pointer, see tools/seam.h; 0: none */
    kg_vec3 hover_seam_place; /* a point of that seam */
    kg_vec2 hover_seam_at;    /* the same in the coordinates of hover_seam[0] */

    kg_surfaces surfaces; /* of the patches as solved */
    kg_backdrop backdrop;
    uint64_t reference_asked; /* counts the references that the model named */
    kg_pane pane;
    kg_settings settings;
    double patch_opacity;
    bool trim_cutters; /* trim inside also trims the cutters */
    kg_mends mends;    /* what would mend the patch shown */

    const kg_tool *tool;
    void *tool_state; /* the tool's own, freed when it ends */
    kg_vec2 pointer;
    unsigned mods;

    char message[KG_ERROR_SIZE]; /* the last thing to tell; empty: nothing */
    kg_severity severity;
    uint64_t message_number;
    double message_clock; /* when it was said */
    kg_request request;
    double clock; /* s */
} kg_editor;

/* An empty patch model. `settings` is copied. */
kg_status kg_editor_init(kg_editor *editor, const kg_settings *settings,
                         kg_error *error) KG_CHECKED;
void kg_editor_clear(kg_editor *editor);

bool kg_editor_is(const kg_editor *editor, kg_document_kind kind);
/* The model of a patch document and its solution, the card of a pop-up document, the sheets of an
 * origami document; NULL for the others. */
kg_model *kg_editor_model(const kg_editor *editor);
const kg_solution *kg_editor_solution(const kg_editor *editor);
kg_oa *kg_editor_oa(const kg_editor *editor);
kg_origami *kg_editor_origami(const kg_editor *editor);

/* ---- files ------------------------------------------------------------------------------ */

/* Opening replaces everything; on failure nothing changes. */
kg_status kg_editor_new(kg_editor *editor, kg_error *error) KG_CHECKED;
kg_status kg_editor_open(kg_editor *editor, const char *path, kg_error *error) KG_CHECKED;
/* The same with a document made elsewhere, which it takes over, also on failure; it is solved if it
 * was not. `path` (may be NULL) is where saving writes to. */
kg_status kg_editor_take(kg_editor *editor, kg_document *document, const char *path,
                         kg_error *error) KG_CHECKED;
/* Saves document and history; `path` NULL: where it came from. */
kg_status kg_editor_save(kg_editor *editor, const char *path, kg_error *error) KG_CHECKED;
bool kg_editor_is_modified(const kg_editor *editor);
/* The file that saving a document of this file writes to; NULL: it is a pattern, to be imported. */
const char *kg_editor_home(const char *path);
/* Asks for the reference that the model names; it is loaded by the app around the editor. */
void kg_editor_load_reference(kg_editor *editor);

/* ---- changes ---------------------------------------------------------------------------- */

/* Starts a step called `label`; within another one it joins that. KG_ERR_MEMORY. */
kg_status kg_editor_begin(kg_editor *editor, const char *label, kg_error *error) KG_CHECKED;
/* To be called after every change of the document within a step. */
void kg_editor_touch(kg_editor *editor);
/* Ends the step; one that changed nothing leaves no trace. */
void kg_editor_commit(kg_editor *editor);
/* Ends the step and puts the document back as it was. */
void kg_editor_cancel(kg_editor *editor);
/* Commits when `status` is KG_OK, else cancels; returns `status`. */
kg_status kg_editor_finish(kg_editor *editor, kg_status status);
bool kg_editor_undo(kg_editor *editor);
bool kg_editor_redo(kg_editor *editor);

/* Solves what changed. The app does so after each event and each command, so that what a panel or
 * a tool holds of the solution stays good until it returns. */
void kg_editor_update(kg_editor *editor);

/* Shows a message in the status bar, or clears it (`format` ""). */
void kg_editor_say(kg_editor *editor, kg_severity severity, const char *format, ...)
    KG_PRINTF(3, 4);

/* Seconds until a message gives way to the hints of the tool; negative: never by itself. */
double kg_editor_message_due(const kg_editor *editor);

/* ---- selection -------------------------------------------------------------------------- */

bool kg_editor_is_selected(const kg_editor *editor, int64_t patch);
/* Its place in the order of selection, from 0; -1: not selected. */
int kg_editor_selection_rank(const kg_editor *editor, int64_t patch);
void kg_editor_select(kg_editor *editor, int64_t patch, bool toggle);
void kg_editor_select_none(kg_editor *editor);
bool kg_editor_is_point_selected(const kg_editor *editor, kg_point_ref point);
void kg_editor_select_point(kg_editor *editor, kg_point_ref point, bool toggle);
/* The first selected patch, 0 for none. */
int64_t kg_editor_first_selected(const kg_editor *editor);
/* Whether its control points are shown and can be taken hold of. */
bool kg_editor_shows_points(const kg_editor *editor, int64_t patch);
/* Bounds of what is selected, or of everything. */
kg_box3 kg_editor_box(const kg_editor *editor, bool selection);

/* The patches under a pixel, the nearest first; after these the ones whose outline passes close by,
 * as that of a sheet seen edge-on. Returns how many, at most `most`. Hidden ones do not count. */
size_t kg_editor_hits(const kg_editor *editor, kg_vec2 px, kg_hit *out_hits, size_t most);

/* ---- tools ------------------------------------------------------------------------------ */

/* Ends the tool in use and starts another; `state` (may be NULL) becomes its own. */
void kg_editor_use(kg_editor *editor, const kg_tool *tool, void *state);
/* Back to what the mode does by itself. */
void kg_editor_use_default(kg_editor *editor);

#endif
