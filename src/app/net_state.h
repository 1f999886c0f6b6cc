/*
 * The net of what is being edited, made on a thread of its own: unrolled with tabs, laid out on
 * pages and drawn as `katagami net` does it. It follows the editor; whoever shows it looks at the
 * picture last made.
 *
 * While a gesture goes on the net is made coarsely and its parts stay where they lie; when it ends
 * they are placed anew.
 */
#ifndef KG_APP_NET_STATE_H
#define KG_APP_NET_STATE_H

#include "app/editor.h"
#include "app/gate.h"
#include "net/drawing.h"

/* A net on its pages. */
typedef struct kg_net_picture {
    kg_document_net net;
    kg_net_options options;
    kg_net_layout *layout;
    kg_drawing *drawing;
    unsigned *clashes; /* per part, see net/clash.h */
    bool rough;        /* made during a gesture, or in rows after placing was cancelled */
} kg_net_picture;

void kg_net_picture_clear(kg_net_picture *picture);

typedef struct kg_net_state kg_net_state;

/* `gate`, which its threads pass, may be NULL. NULL when memory runs out. */
kg_net_state *kg_net_state_create(kg_gate *gate);
void kg_net_state_destroy(kg_net_state *state);

/* Takes over what the thread has done, and starts it when the editor's model is another. True:
 * there is something new to show. To be called in every frame that shows the net. */
bool kg_net_state_follow(kg_net_state *state, const kg_editor *editor);

/* Whether the net is being made; `out_fraction` (may be NULL) how far placing the parts is, in
 * [0, 1]. */
bool kg_net_state_busy(const kg_net_state *state, double *out_fraction);
/* Ends a search for good places; the parts come in rows. */
void kg_net_state_cancel(kg_net_state *state);

/* NULL: nothing was made yet, or the model has no parts. Valid until the next follow. */
const kg_net_picture *kg_net_state_picture(const kg_net_state *state);
/* Why the picture is not that of the model; "" when it is. */
const char *kg_net_state_error(const kg_net_state *state);
/* Counts the pictures. */
uint64_t kg_net_state_revision(const kg_net_state *state);

#endif
