#include "app/tools/gesture.h"

bool kg_gestures_event(const kg_gestures *g, kg_editor *e, const kg_event *event, bool busy) {
    bool left = event->button == KG_MOUSE_LEFT;
    switch (event->type) {
    case KG_EVENT_PRESS:
        if (!left || busy)
            return false;
        e->message[0] = '\0';
        g->press(e, event);
        return true;
    case KG_EVENT_MOVE:
        g->move(e, event);
        return true;
    case KG_EVENT_RELEASE:
        if (left && busy) {
            g->release(e, event);
        } else if (event->button == KG_MOUSE_RIGHT && !busy) {
            if (g->menu)
                g->menu(e, event);
            e->request = KG_REQUEST_MENU;
        } else {
            return false;
        }
        return true;
    case KG_EVENT_KEY:
        return g->key(e, event);
    default:
        return false;
    }
}
