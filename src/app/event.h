/*
 * Input as one stream of events. The window's callbacks fill the queue, and so does a script; the
 * app and the user interface see nothing else.
 *
 * Positions are framebuffer pixels from the upper left corner.
 */
#ifndef KG_APP_EVENT_H
#define KG_APP_EVENT_H

#include "katagami/base.h"

typedef enum kg_event_type {
    KG_EVENT_NONE, /* time passes, nothing else */
    KG_EVENT_MOVE,
    KG_EVENT_PRESS,
    KG_EVENT_RELEASE,
    KG_EVENT_WHEEL,
    KG_EVENT_KEY, /* pressed, or repeated while held */
    KG_EVENT_KEY_UP,
    KG_EVENT_TEXT,
    KG_EVENT_DROP, /* a file dropped onto the window */
    KG_EVENT_RESIZE,
    KG_EVENT_CLOSE
} kg_event_type;

enum { KG_MOD_SHIFT = 1, KG_MOD_CTRL = 2, KG_MOD_ALT = 4 };
enum { KG_MOUSE_LEFT, KG_MOUSE_RIGHT, KG_MOUSE_MIDDLE, KG_MOUSE_COUNT };

/* Keys that write a character are that character (letters in upper case); window.c checks that
 * these are GLFW's numbers. */
enum {
    KG_KEY_ESCAPE = 256,
    KG_KEY_ENTER,
    KG_KEY_TAB,
    KG_KEY_BACKSPACE,
    KG_KEY_INSERT,
    KG_KEY_DELETE,
    KG_KEY_RIGHT,
    KG_KEY_LEFT,
    KG_KEY_DOWN,
    KG_KEY_UP,
    KG_KEY_PAGE_UP,
    KG_KEY_PAGE_DOWN,
    KG_KEY_HOME,
    KG_KEY_END,
    KG_KEY_F1 = 290,
    KG_KEY_PAD_0 = 320,
    KG_KEY_PAD_DECIMAL = 330,
    KG_KEY_PAD_ENTER = 335,
    KG_KEY_COUNT = 512
};

typedef struct kg_event {
    kg_event_type type;
    unsigned mods;
    int button;
    int key;
    bool repeat;        /* KEY: held down */
    uint32_t codepoint; /* TEXT */
    kg_vec2 position;   /* MOVE, PRESS, RELEASE, WHEEL */
    double wheel;       /* notches, away from the user is positive */
    int width, height;  /* RESIZE */
    double scale;       /* RESIZE: pixels per unit of the layout, 1 without HiDPI */
    char *path;         /* DROP: owned by the event */
} kg_event;

typedef struct kg_events {
    kg_event *items;
    size_t count, capacity, first;
} kg_events;

/* Appends; several moves in a row become the last of them. An event that no memory is left for is
 * lost. */
void kg_events_push(kg_events *events, kg_event event);
/* False when the queue is empty. The taken event is to be cleared. */
bool kg_events_take(kg_events *events, kg_event *out_event);
void kg_event_clear(kg_event *event);
void kg_events_clear(kg_events *events);

/* A key with its modifiers: "Ctrl+Shift+Z", "F1", "Numpad 3", "Page Up". */
typedef struct kg_chord {
    int key; /* 0: none */
    unsigned mods;
} kg_chord;

/* False for text that names no key. */
bool kg_chord_parse(const char *text, kg_chord *out_chord);

#endif
