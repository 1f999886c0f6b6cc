#include "app/monkey.h"

#include <stdlib.h>

/* splitmix64 */
static uint64_t next(uint64_t *state) {
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static int below(uint64_t *state, int limit) {
    return (int)(next(state) % (uint64_t)limit);
}

static int any_key(uint64_t *state) {
    static const int keys[] = {KG_KEY_ESCAPE, KG_KEY_ENTER, KG_KEY_TAB,  KG_KEY_BACKSPACE,
                               KG_KEY_DELETE, KG_KEY_UP,    KG_KEY_DOWN, KG_KEY_HOME,
                               KG_KEY_F1,     '/',          '.',         '-'};
    int i = below(state, 2 * (int)(sizeof keys / sizeof *keys));
    if (i < (int)(sizeof keys / sizeof *keys))
        return keys[i];
    return below(state, 4) == 0 ? '0' + below(state, 10) : 'A' + below(state, 26);
}

/* Half of the time near the last place, so that drags and double clicks happen. */
static kg_vec2 any_place(uint64_t *state, int width, int height, kg_vec2 pointer) {
    if (below(state, 2) == 0)
        return kg_v2(pointer.x + below(state, 41) - 20, pointer.y + below(state, 41) - 20);
    return kg_v2(below(state, width), below(state, height));
}

kg_event kg_monkey_event(uint64_t *state, int width, int height, kg_vec2 pointer) {
    static const unsigned mods[] = {
        0, 0, 0, 0, KG_MOD_SHIFT, KG_MOD_CTRL, KG_MOD_ALT, KG_MOD_CTRL | KG_MOD_SHIFT};
    kg_event e = {.position = pointer, .mods = mods[below(state, 8)]};
    int kind = below(state, 16);
    if (kind < 6) {
        e.type = KG_EVENT_MOVE;
        e.position = any_place(state, width, height, pointer);
    } else if (kind < 11) {
        e.type = kind < 9 ? KG_EVENT_PRESS : KG_EVENT_RELEASE;
        e.button = below(state, 4) == 0 ? below(state, KG_MOUSE_COUNT) : KG_MOUSE_LEFT;
    } else if (kind == 11) {
        e.type = KG_EVENT_WHEEL;
        e.wheel = below(state, 5) - 2;
    } else if (kind == 12) {
        e.type = KG_EVENT_TEXT;
        e.codepoint = below(state, 3) == 0 ? 0x4e00u + (uint32_t)below(state, 500)
                                           : (uint32_t)('0' + below(state, 75));
    } else {
        e.type = below(state, 4) == 0 ? KG_EVENT_KEY_UP : KG_EVENT_KEY;
        e.key = any_key(state);
    }
    return e;
}

kg_status kg_monkey_check(const kg_app *app, kg_error *error) {
    char *text;
    size_t size;
    kg_document *read;
    const kg_document *d = app->editor.document;
    kg_status status = kg_document_write_memory(d, &text, &size, error);
    if (status)
        return status;
    status = kg_document_read_memory(text, size, "the document", NULL, &read, error);
    free(text);
    if (!status)
        kg_document_destroy(read);
    return status;
}
