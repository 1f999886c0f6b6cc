#include "app/event.h"

#include "base/array.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void kg_events_push(kg_events *e, kg_event event) {
    kg_event *last = e->count > e->first ? &e->items[e->count - 1] : NULL;
    if (last && last->type == KG_EVENT_MOVE && event.type == KG_EVENT_MOVE)
        *last = event;
    else if (!kg_push(e, event))
        kg_event_clear(&event);
}

bool kg_events_take(kg_events *e, kg_event *out_event) {
    if (e->first == e->count)
        return false;
    *out_event = e->items[e->first++];
    if (e->first == e->count)
        e->first = e->count = 0;
    return true;
}

void kg_event_clear(kg_event *event) {
    free(event->path);
    event->path = NULL;
}

void kg_events_clear(kg_events *e) {
    for (size_t i = e->first; i < e->count; i++)
        kg_event_clear(&e->items[i]);
    free(e->items);
    *e = (kg_events){0};
}

/* ---- names of keys ---------------------------------------------------------------------- */

static const struct {
    const char *name;
    int key;
} named_keys[] = {
    {"Esc", KG_KEY_ESCAPE},
    {"Enter", KG_KEY_ENTER},
    {"Tab", KG_KEY_TAB},
    {"Backspace", KG_KEY_BACKSPACE},
    {"Del", KG_KEY_DELETE},
    {"Right", KG_KEY_RIGHT},
    {"Left", KG_KEY_LEFT},
    {"Down", KG_KEY_DOWN},
    {"Up", KG_KEY_UP},
    {"Page Up", KG_KEY_PAGE_UP},
    {"PageUp", KG_KEY_PAGE_UP},
    {"Page Down", KG_KEY_PAGE_DOWN},
    {"Home", KG_KEY_HOME},
    {"End", KG_KEY_END},
    {"PageDown", KG_KEY_PAGE_DOWN},
    {"Space", ' '},
    {"Numpad .", KG_KEY_PAD_DECIMAL},
};

static int find_key(const char *name) {
    int number;
    char rest;
    for (size_t i = 0; i < sizeof named_keys / sizeof *named_keys; i++)
        if (strcasecmp(name, named_keys[i].name) == 0)
            return named_keys[i].key;
    if ((sscanf(name, "Numpad %d%c", &number, &rest) == 1 ||
         sscanf(name, "Numpad%d%c", &number, &rest) == 1) &&
        number >= 0 && number <= 9)
        return KG_KEY_PAD_0 + number;
    if (sscanf(name, "F%d%c", &number, &rest) == 1 && number >= 1 && number <= 12)
        return KG_KEY_F1 + number - 1;
    if (name[0] > ' ' && name[0] <= '~' && name[1] == '\0')
        return name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
    return 0;
}

bool kg_chord_parse(const char *text, kg_chord *out_chord) {
    static const struct {
        const char *name;
        unsigned mod;
    } mods[] = {{"Ctrl+", KG_MOD_CTRL}, {"Shift+", KG_MOD_SHIFT}, {"Alt+", KG_MOD_ALT}};
    kg_chord chord = {0};
    for (size_t i = 0; i < sizeof mods / sizeof *mods;) {
        size_t n = strlen(mods[i].name);
        if (strncasecmp(text, mods[i].name, n) == 0 && text[n]) {
            chord.mods |= mods[i].mod;
            text += n;
            i = 0;
        } else {
            i++;
        }
    }
    chord.key = find_key(text);
    if (!chord.key)
        return false;
    *out_chord = chord;
    return true;
}
