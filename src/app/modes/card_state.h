/* What the app keeps beside a pop-up card: how far it stands open, the voxel cursor, the brush. */
#ifndef KG_APP_MODES_CARD_STATE_H
#define KG_APP_MODES_CARD_STATE_H

#include "app/editor.h"

/* A voxel, counted as kg_oa does. */
typedef struct kg_spot {
    int x, y, z;
} kg_spot;

/* Voxels from `lo` to `hi`, both included. */
typedef struct kg_spots {
    kg_spot lo, hi;
} kg_spots;

/* What a drag of the left button does. */
typedef enum kg_brush {
    KG_BRUSH_ADD,
    KG_BRUSH_REMOVE,
    KG_BRUSH_PULL,
    KG_BRUSH_WINDOW,
    KG_BRUSH_TOP,
    KG_BRUSH_COUNT
} kg_brush;

typedef struct kg_card_state {
    double open; /* angle between the sheets, in [0, π] */
    bool playing;
    double phase, played; /* of the motion: where it began, radians; what is done of it, s */

    kg_spot cursor;
    bool boxed;     /* voxels from the anchor to the cursor's last box are selected */
    kg_spots box;   /* in order */
    kg_spot anchor; /* the corner of the box that stays while keys move the other */
    bool level;     /* the active plane is horizontal */
    bool symmetric; /* edits are done on the other side too */
    kg_brush brush;

    bool hovering;                       /* the pointer is over a cell, in whatever view */
    int hover_x, hover_row;              /* of the sheet */
    int shown_remark;                    /* chosen in the list, -1: none */
    int hover_remark;                    /* under the pointer, -1: none */
    bool painting_net, paint_top, paint; /* a stroke in the net, of tops or fronts, what it sets */

    int degrees; /* of freedom, -1: not counted */
    uint64_t counted;
    char hint[512];
} kg_card_state;

/* NULL for other documents. */
kg_card_state *kg_card_state_of(const kg_editor *editor);
kg_status kg_card_state_create(const kg_document *document, void **out_state,
                               kg_error *error) KG_CHECKED;

/* Puts state and document right after another solution. */
void kg_card_follow(kg_editor *editor);

/* Opens the card so far, radians; what lies beyond flat or closed is cut off. */
void kg_card_open(kg_editor *editor, double open);
/* Starts the motion from where the card stands to closed, flat and back again, or stops it. */
void kg_card_play(kg_editor *editor, bool on);
/* Lets time go by; true while the card moves. */
bool kg_card_tick(kg_editor *editor, double seconds);

bool kg_card_has(const kg_oa *oa, kg_spot spot);    /* is it inside the card? */
bool kg_card_filled(const kg_oa *oa, kg_spot spot); /* and filled? */
void kg_card_move_cursor(kg_editor *editor, kg_spot to);
kg_spots kg_spots_between(kg_spot a, kg_spot b);
/* The selected box, else the cursor. */
kg_spots kg_card_selected(const kg_editor *editor);

/* The remark that a cell of the sheet belongs to, faults first; -1: none. */
int kg_card_remark_at(const kg_editor *editor, int x, int row);
/* The remark to be shown: under the pointer, else the chosen one; -1: none. */
int kg_card_remark_now(const kg_editor *editor);

/* A front or top of the card without margins. */
typedef struct kg_face {
    bool top; /* else a front */
    int x, z; /* level of the front, height of the top */
} kg_face;

/* Which face a cell of the sheet belongs to by the paths of section 2, wherever it is placed.
 * False: back sheet, base or margin. */
bool kg_card_face_at(const kg_editor *editor, int x, int row, kg_face *out_face);
/* Degrees of freedom of the card as it is, -1 when it is too large to count them in no time. */
int kg_card_degrees(const kg_editor *editor);

#endif
