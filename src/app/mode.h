/*
 * Modes: how the app shows and edits one kind of document. One file each in modes/; the editor is
 * in the mode of its document.
 *
 * A mode has its state in editor->mode_state, made anew for every document.
 */
#ifndef KG_APP_MODE_H
#define KG_APP_MODE_H

#include "app/editor.h"
#include "app/net_view.h"
#include "app/overlay.h"
#include "app/ui/icons.h"

struct kg_app;

typedef struct kg_menu {
    const char *title; /* marked for translation */
    const char *ids; /* of commands, in the order in which they are shown; "-" is a line between */
} kg_menu;

struct kg_mode {
    kg_document_kind kind;
    const char *title;   /* of such documents, marked for translation */
    const kg_tool *tool; /* in use when no other is */

    /* The state for a document, which is solved; both NULL: none is needed. */
    kg_status (*create)(const kg_document *document, void **out_state, kg_error *error);
    void (*destroy)(void *state);
    /* The document was solved anew, or is another one; may be NULL. */
    void (*follow)(kg_editor *editor);
    /* Lets time go by; true: something moves. May be NULL. */
    bool (*tick)(kg_editor *editor, double seconds);
    /* Bounds of what is selected, or of everything. */
    kg_box3 (*box)(const kg_editor *editor, bool selection);

    /* Height of the ground, where a grid is drawn; false: none. NULL: z = 0. */
    bool (*ground)(const kg_editor *editor, double *out_z);

    /* Adds what is to be seen. `cache` holds what stays on the graphics card, NULL at first. */
    kg_status (*compose)(void **cache, const kg_editor *editor, kg_overlay *overlay,
                         kg_error *error);
    void (*drop)(void *cache);

    kg_menu menu;                                    /* in the menu bar */
    const char *(*context)(const kg_editor *editor); /* ids of a right click */
    void (*toolbar)(struct kg_app *app);             /* buttons below each other */
    void (*side)(struct kg_app *app, kg_area area);  /* panels at the right */
    void (*handles)(struct kg_app *app);             /* over the 3D view; may be NULL */

    /* The mouse over the net, at a point of its part (NULL: beside it); NULL: the net is only
     * looked at. True of a press of the left button: what follows until its release comes here too.
     */
    bool (*net_event)(kg_editor *editor, const kg_event *event, const kg_vec2 *point);
    /* Adds to the drawing of the net's part; may be NULL. `scale`: pixels per layout unit. */
    void (*net_draw)(const kg_editor *editor, const kg_net_map *map, double scale);

    /* Whether the document works, in a sentence for the status bar; false: nothing is wrong with
     * it. NULL: faults and warnings are counted. */
    bool (*verdict)(const kg_editor *editor, char *out, size_t size, kg_severity *out_severity);

    /* An assertion of a script, the words after "expect". */
    kg_status (*expect)(const kg_editor *editor, const char *words, kg_error *error);
};

const kg_mode *kg_mode_of(kg_document_kind kind);

#endif
