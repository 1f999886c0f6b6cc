/*
 * Edits of a card, with their mirror images while the editor is symmetric. But for the last, all
 * are to be called within a step, and return whether anything changed.
 */
#ifndef KG_APP_MODES_CARD_EDIT_H
#define KG_APP_MODES_CARD_EDIT_H

#include "app/modes/card_state.h"

/* Fills the voxels, or takes them away, with all that the staircase rule asks for. */
bool kg_card_put(kg_editor *editor, kg_spots box, bool remove);
/* Sets a front's window, a top's omission. */
bool kg_card_set_face(kg_editor *editor, kg_face face, bool on);
/* Is the front a window, the top left out? */
bool kg_card_face_is_set(const kg_editor *editor, kg_face face);
/* The same for all fronts, or tops, of the voxels in a box. */
bool kg_card_set_faces(kg_editor *editor, kg_spots box, bool top, bool on);
/* Does any of these faces exist, and is none without window (in its place)? */
bool kg_card_all_set(const kg_editor *editor, kg_spots box, bool top);

/* A connected face of one depth, or of one height: a bit for each place (x, level) or (x, y). */
typedef struct kg_pulled {
    bool level; /* a top, which goes up and down; else a front, which goes out and in */
    int at;     /* its depth, or height, in voxels */
    int columns, rows;
    unsigned char *inside; /* x * rows + level or y */
} kg_pulled;

/* The face in front of (above) a voxel: within the selected box when that holds it, else as far as
 * it goes. KG_ERR_INPUT: it is the back sheet or the base, without a box to bound it. */
kg_status kg_pulled_create(const kg_editor *editor, kg_spot spot, bool level, kg_pulled *out_pulled,
                           kg_error *error) KG_CHECKED;
void kg_pulled_clear(kg_pulled *pulled);
/* Takes the face from where it was in `from` to `to` voxels; what lies behind or below follows. */
bool kg_card_pull(kg_editor *editor, const kg_oa *from, const kg_pulled *pulled, int to);

/* Gives the card the cells of `after`, a copy that was made to stand, as a step of its own, and
 * says what came of it; one that stood already is left without a step of the history. */
kg_status kg_card_stand(kg_editor *editor, const kg_oa *after, const kg_oa_mended *mended,
                        kg_error *error) KG_CHECKED;

#endif
