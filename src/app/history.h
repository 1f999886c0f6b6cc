/*
 * Undo: copies of the document from before each step, and from after each step taken back.
 *
 * In a file each step holds only what the next state does not: "history": {"undo": [STEP…],
 * "redo": [STEP…]}, the steps from the oldest; a STEP is {"label": …, "delta": what leads to its
 * state from the next one, see delta.h}.
 */
#ifndef KG_APP_HISTORY_H
#define KG_APP_HISTORY_H

#include "katagami/document.h"

/* Steps kept while working and in a file, and how long the file's history may get, bytes: enough
 * for a day, little enough to save in an instant. */
enum { KG_HISTORY_STEPS = 1000, KG_HISTORY_FILE_BYTES = 1 << 20 };

typedef struct kg_step {
    kg_document *content;  /* the state to go back (or forward) to; NULL: only `stored` */
    struct json_t *stored; /* as in the file; NULL: not written yet */
    char *label;           /* what the step did: "Move points" */
    uint64_t state;        /* number of that state, to know the saved one again */
} kg_step;

typedef struct kg_steps {
    kg_step *items;
    size_t count, capacity;
} kg_steps;

typedef struct kg_history {
    kg_steps undo, redo; /* the last one is the next to be taken */
} kg_history;

/* Takes over `before`; forgets what was undone. */
kg_status kg_history_push(kg_history *history, kg_document *before, uint64_t state,
                          const char *label, kg_error *error) KG_CHECKED;

/* Exchanges the content (and the number of its state) with the last undone or redone one; false
 * when there is none, or when it came from a file and cannot be understood, which forgets the rest.
 */
bool kg_history_undo(kg_history *history, kg_document *document, uint64_t *state);
bool kg_history_redo(kg_history *history, kg_document *document, uint64_t *state);

void kg_history_clear(kg_history *history);

/* The file's "history" key, made from the history; the document itself is `now`. What was written
 * once is kept for the next time. */
kg_status kg_history_store(kg_history *history, kg_document *now, kg_error *error) KG_CHECKED;

/* Takes the "history" key out of a document just read. Its steps are looked into when they are
 * undone: a file with a long history opens as fast as one without. `next_state` numbers the states.
 */
void kg_history_restore(kg_document *now, uint64_t *next_state, kg_history *out_history);

#endif
