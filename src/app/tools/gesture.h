/* What tools that are used by the left button have in common: which events are theirs. */
#ifndef KG_APP_TOOLS_GESTURE_H
#define KG_APP_TOOLS_GESTURE_H

#include "app/editor.h"

typedef struct kg_gestures {
    void (*press)(kg_editor *editor, const kg_event *event);   /* of the left button */
    void (*move)(kg_editor *editor, const kg_event *event);    /* also while nothing is held */
    void (*release)(kg_editor *editor, const kg_event *event); /* ends what a press began */
    void (*menu)(kg_editor *editor, const kg_event *event);    /* before it opens; NULL: nothing */
    bool (*key)(kg_editor *editor, const kg_event *event);
} kg_gestures;

/* Gives an event to who wants it; `busy`: a press began something that goes on. True: the event is
 * used up. A press clears the message. A click of the right button, which turns the view when it is
 * dragged, opens the menu. */
bool kg_gestures_event(const kg_gestures *gestures, kg_editor *editor, const kg_event *event,
                       bool busy);

#endif
