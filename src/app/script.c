#include "app/script.h"

#include "app/commands/commands.h"
#include "app/monkey.h"
#include "app/recovery.h"
#include "app/tools/tool.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define FRAME (1.0 / 60)

enum { MOST_LINE = 4096, DRAG_MOVES = 8 };

/* A script while it runs. */
typedef struct script {
    kg_app *app;
    kg_shot_fn shot;
    void *user;
    kg_vec2 pointer;
} script;

/* ---- events ----------------------------------------------------------------------------- */

static void send(script *s, kg_event event) {
    event.position = s->pointer;
    kg_events_push(&s->app->events, event);
    kg_app_run_events(s->app, FRAME);
}

static void move_to(script *s, kg_vec2 to, unsigned mods) {
    s->pointer = to;
    send(s, (kg_event){.type = KG_EVENT_MOVE, .mods = mods});
}

static void click(script *s, int button, unsigned mods) {
    send(s, (kg_event){.type = KG_EVENT_PRESS, .button = button, .mods = mods});
    send(s, (kg_event){.type = KG_EVENT_RELEASE, .button = button, .mods = mods});
}

static void press_key(script *s, kg_chord chord) {
    send(s, (kg_event){.type = KG_EVENT_KEY, .key = chord.key, .mods = chord.mods});
    send(s, (kg_event){.type = KG_EVENT_KEY_UP, .key = chord.key, .mods = chord.mods});
}

/* The next character of a UTF-8 text. */
static uint32_t next_character(const unsigned char **text) {
    const unsigned char *p = *text;
    int more = *p < 0x80 ? 0 : *p < 0xe0 ? 1 : *p < 0xf0 ? 2 : 3;
    uint32_t c = more == 0 ? *p : *p & (0x3fu >> more);
    for (p++; more > 0 && *p; more--, p++)
        c = c << 6 | (*p & 0x3fu);
    *text = p;
    return c;
}

/* ---- words ------------------------------------------------------------------------------ */

static const char *skip_spaces(const char *words) {
    return words + strspn(words, " \t");
}

/* The words left of a line, in turn: plain ones, or with spaces in quotes. */
static bool next_word(const char **words, char *out, size_t size) {
    const char *p = skip_spaces(*words);
    char quote = *p == '"' ? '"' : '\0';
    p += quote != '\0';
    size_t n = quote ? strcspn(p, "\"") : strcspn(p, " \t");
    if (n == 0 && !quote)
        return false;
    snprintf(out, size, "%.*s", (int)n, p);
    *words = p + n + (quote && p[n] == quote);
    return true;
}

static bool next_number(const char **words, double *out) {
    char word[64], *end;
    if (!next_word(words, word, sizeof word))
        return false;
    *out = strtod(word, &end);
    return end != word && *end == '\0';
}

/* A place: X Y in the 3D view, @X,Y,Z in space, or "LABEL" of a widget. */
static kg_status read_place(script *s, const char **words, kg_vec2 *out, kg_error *error) {
    const kg_pane *pane = &s->app->editor.pane;
    const char *p = skip_spaces(*words);
    char word[256];
    kg_vec3 point;
    kg_area area;
    if (*p == '"') {
        next_word(words, word, sizeof word);
        if (!kg_ui_find(word, &area))
            return kg_fail(error, KG_ERR_INPUT, "no widget \"%s\" is shown", word);
        *out = kg_v2(area.x + area.width / 2, area.y + area.height / 2);
        return KG_OK;
    }
    if (*p == '@') {
        next_word(words, word, sizeof word);
        if (sscanf(word, "@%lf,%lf,%lf", &point.x, &point.y, &point.z) != 3 ||
            !kg_pane_project(pane, point, out))
            return kg_fail(error, KG_ERR_INPUT, "%s is no place that is seen (@X,Y,Z)", word);
        return KG_OK;
    }
    if (!next_number(words, &out->x) || !next_number(words, &out->y))
        return kg_fail(error, KG_ERR_INPUT, "a place is wanted: X Y, @X,Y,Z or \"LABEL\"");
    *out = kg_v2(pane->area.x + pane->scale * out->x, pane->area.y + pane->scale * out->y);
    return KG_OK;
}

/* What the mouse does: at which places, with which button and keys. */
typedef struct pointing {
    kg_vec2 at, to;
    int button, times;
    unsigned mods;
} pointing;

/* Words like "shift", "ctrl", "alt", "right", "middle", "double" at the end of a line. */
static kg_status read_manner(const char *words, pointing *p, kg_error *error) {
    char word[32];
    while (next_word(&words, word, sizeof word)) {
        if (strcmp(word, "shift") == 0)
            p->mods |= KG_MOD_SHIFT;
        else if (strcmp(word, "ctrl") == 0)
            p->mods |= KG_MOD_CTRL;
        else if (strcmp(word, "alt") == 0)
            p->mods |= KG_MOD_ALT;
        else if (strcmp(word, "right") == 0)
            p->button = KG_MOUSE_RIGHT;
        else if (strcmp(word, "middle") == 0)
            p->button = KG_MOUSE_MIDDLE;
        else if (strcmp(word, "double") == 0)
            p->times = 2;
        else
            return kg_fail(error, KG_ERR_INPUT, "\"%s\" says nothing about a click", word);
    }
    return KG_OK;
}

/* One place, or two, and the manner. */
static kg_status read_pointing(script *s, const char *words, int places, pointing *out,
                               kg_error *error) {
    *out = (pointing){.button = KG_MOUSE_LEFT, .times = 1};
    kg_status status = read_place(s, &words, &out->at, error);
    if (!status && places > 1)
        status = read_place(s, &words, &out->to, error);
    return status ? status : read_manner(words, out, error);
}

/* ---- verbs ------------------------------------------------------------------------------ */

static kg_status do_move(script *s, const char *words, kg_error *error) {
    pointing p;
    kg_status status = read_pointing(s, words, 1, &p, error);
    if (!status)
        move_to(s, p.at, p.mods);
    return status;
}

static kg_status do_click(script *s, const char *words, kg_error *error) {
    pointing p;
    kg_status status = read_pointing(s, words, 1, &p, error);
    if (status)
        return status;
    move_to(s, p.at, p.mods);
    for (int i = 0; i < p.times; i++)
        click(s, p.button, p.mods);
    return KG_OK;
}

static kg_status do_drag(script *s, const char *words, kg_error *error) {
    pointing p;
    kg_status status = read_pointing(s, words, 2, &p, error);
    if (status)
        return status;
    move_to(s, p.at, p.mods);
    send(s, (kg_event){.type = KG_EVENT_PRESS, .button = p.button, .mods = p.mods});
    for (int i = 1; i <= DRAG_MOVES; i++)
        move_to(s, kg_lerp2(p.at, p.to, (double)i / DRAG_MOVES), p.mods);
    send(s, (kg_event){.type = KG_EVENT_RELEASE, .button = p.button, .mods = p.mods});
    return KG_OK;
}

/* Presses at a place and holds, or lets go at another: what goes on meanwhile can be looked at. */
static kg_status press_or_release(script *s, const char *words, kg_event_type type,
                                  kg_error *error) {
    pointing p;
    kg_status status = read_pointing(s, words, 1, &p, error);
    if (status)
        return status;
    move_to(s, p.at, p.mods);
    send(s, (kg_event){.type = type, .button = p.button, .mods = p.mods});
    return KG_OK;
}

static kg_status do_press(script *s, const char *words, kg_error *error) {
    return press_or_release(s, words, KG_EVENT_PRESS, error);
}

static kg_status do_release(script *s, const char *words, kg_error *error) {
    return press_or_release(s, words, KG_EVENT_RELEASE, error);
}

static kg_status do_key(script *s, const char *words, kg_error *error) {
    kg_chord chord;
    char name[64];
    snprintf(name, sizeof name, "%s", skip_spaces(words));
    if (!kg_chord_parse(name, &chord))
        return kg_fail(error, KG_ERR_INPUT, "there is no key \"%s\"", name);
    press_key(s, chord);
    return KG_OK;
}

static kg_status do_text(script *s, const char *words, kg_error *error) {
    (void)error;
    const unsigned char *text = (const unsigned char *)skip_spaces(words);
    while (*text)
        send(s, (kg_event){.type = KG_EVENT_TEXT, .codepoint = next_character(&text)});
    return KG_OK;
}

static kg_status do_wheel(script *s, const char *words, kg_error *error) {
    double notches;
    if (!next_number(&words, &notches))
        return kg_fail(error, KG_ERR_INPUT, "wheel needs a number of notches");
    send(s, (kg_event){.type = KG_EVENT_WHEEL, .wheel = notches});
    return KG_OK;
}

static kg_status do_open(script *s, const char *words, kg_error *error) {
    char path[KG_PATH_SIZE];
    if (!next_word(&words, path, sizeof path))
        return kg_fail(error, KG_ERR_INPUT, "open needs a file");
    kg_status status = kg_editor_open(&s->app->editor, path, error);
    s->app->framed = false;
    kg_app_run_events(s->app, FRAME);
    return status;
}

static kg_status do_save(script *s, const char *words, kg_error *error) {
    char path[KG_PATH_SIZE];
    bool named = next_word(&words, path, sizeof path);
    kg_status status = kg_editor_save(&s->app->editor, named ? path : NULL, error);
    kg_app_run_events(s->app, FRAME);
    return status;
}

static kg_status do_drop(script *s, const char *words, kg_error *error) {
    char path[KG_PATH_SIZE];
    if (!next_word(&words, path, sizeof path))
        return kg_fail(error, KG_ERR_INPUT, "drop needs a file");
    send(s, (kg_event){.type = KG_EVENT_DROP, .path = strdup(path)});
    return KG_OK;
}

/* Until nothing goes on in the background, which does so only meanwhile. */
static void wait_for_all(script *s) {
    const struct timespec tick = {.tv_nsec = 2000000};
    kg_gate_set_closed(&s->app->gate, false);
    for (kg_app_run_events(s->app, FRAME); s->app->busy; kg_app_run_events(s->app, FRAME))
        nanosleep(&tick, NULL);
    kg_gate_set_closed(&s->app->gate, true);
    kg_app_run_events(s->app, FRAME);
}

/* Until a widget is shown; the work in the background goes on step by step and stays where it is.
 * False when that is over without the widget. */
static bool wait_for(script *s, const char *label) {
    kg_area area;
    kg_app_run_events(s->app, FRAME);
    while (!kg_ui_find(label, &area)) {
        if (!s->app->busy)
            return false;
        kg_gate_step(&s->app->gate);
        kg_app_run_events(s->app, FRAME);
    }
    return true;
}

static kg_status do_wait(script *s, const char *words, kg_error *error) {
    double seconds;
    char label[256];
    if (*skip_spaces(words) == '\0') {
        wait_for_all(s);
        return KG_OK;
    }
    if (*skip_spaces(words) == '"' && next_word(&words, label, sizeof label))
        return wait_for(s, label)
                   ? KG_OK
                   : kg_fail(error, KG_ERR_INPUT, "no widget \"%s\" was shown", label);
    if (!next_number(&words, &seconds))
        return kg_fail(error, KG_ERR_INPUT,
                       "wait needs a number of seconds, a \"LABEL\", or nothing");
    kg_app_run_events(s->app, seconds);
    return KG_OK;
}

static kg_status do_command(script *s, const char *words, kg_error *error) {
    char id[64];
    json_error_t wrong;
    json_t *arguments = NULL;
    if (!next_word(&words, id, sizeof id) || !kg_command_find(id))
        return kg_fail(error, KG_ERR_INPUT, "there is no command \"%s\"", skip_spaces(words));
    words = skip_spaces(words);
    if (*words && !(arguments = json_loads(words, 0, &wrong)))
        return kg_fail(error, KG_ERR_INPUT, "the arguments are no JSON object: %s", wrong.text);
    kg_status status = kg_command_run(kg_command_find(id), &s->app->editor, arguments, error);
    if (status) /* the script is told, no dialog is wanted */
        s->app->editor.request = KG_REQUEST_NONE;
    json_decref(arguments);
    kg_app_run_events(s->app, FRAME);
    return status;
}

/* A command that has to fail. */
static kg_status do_fail(script *s, const char *words, kg_error *error) {
    kg_error reason;
    if (do_command(s, words, &reason))
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "%s should have failed", words);
}

/* A command that may fail. */
static kg_status do_try(script *s, const char *words, kg_error *error) {
    kg_error reason;
    (void)error;
    if (do_command(s, words, &reason))
        s->app->editor.message[0] = '\0';
    return KG_OK;
}

static kg_status do_expect(script *s, const char *words, kg_error *error) {
    return kg_script_expect(s->app, skip_spaces(words), error);
}

static kg_status do_shot(script *s, const char *words, kg_error *error) {
    char path[KG_PATH_SIZE];
    if (!next_word(&words, path, sizeof path))
        return kg_fail(error, KG_ERR_INPUT, "shot needs a file");
    return s->shot(s->user, path, error);
}

static kg_status do_resize(script *s, const char *words, kg_error *error) {
    double width, height, scale = s->app->scale;
    if (!next_number(&words, &width) || !next_number(&words, &height))
        return kg_fail(error, KG_ERR_INPUT, "resize needs width and height in pixels");
    next_number(&words, &scale);
    send(s,
         (kg_event){
             .type = KG_EVENT_RESIZE, .width = (int)width, .height = (int)height, .scale = scale});
    return KG_OK;
}

/* As at the start of the app in a window. */
static kg_status do_recover(script *s, const char *words, kg_error *error) {
    (void)words, (void)error;
    kg_recovery_offer(s->app);
    kg_app_run_events(s->app, FRAME);
    return KG_OK;
}

/* From here on with the user's preferences, read and kept. */
static kg_status do_preferences(script *s, const char *words, kg_error *error) {
    (void)words, (void)error;
    s->app->editor.settings.transient = false;
    kg_settings_read(&s->app->editor.settings);
    return KG_OK;
}

static kg_status do_start(script *s, const char *words, kg_error *error) {
    (void)words, (void)error;
    s->app->start = true;
    send(s, (kg_event){.type = KG_EVENT_NONE});
    return KG_OK;
}

static kg_status do_autosave(script *s, const char *words, kg_error *error) {
    if (!next_number(&words, &s->app->editor.settings.autosave_minutes))
        return kg_fail(error, KG_ERR_INPUT, "autosave needs a number of minutes");
    return KG_OK;
}

/* Random events: clicks and drags all over the window, keys with and without modifiers. */
static kg_status do_monkey(script *s, const char *words, kg_error *error) {
    double count, seed;
    if (!next_number(&words, &count) || !next_number(&words, &seed))
        return kg_fail(error, KG_ERR_INPUT, "monkey needs a number of events and a seed");
    kg_status status = KG_OK;
    uint64_t state = (uint64_t)seed;
    for (int i = 0; i < (int)count && !status; i++) {
        kg_event event = kg_monkey_event(&state, s->app->width, s->app->height, s->pointer);
        s->pointer = event.position;
        send(s, event);
        kg_gate_step(&s->app->gate); /* so that results come between events, always the same */
        s->app->quit = false;
        status = kg_monkey_check(s->app, error);
        if (status)
            kg_fail_in(error, status, "event %d: ", i + 1);
    }
    for (int button = 0; button < KG_MOUSE_COUNT; button++)
        send(s, (kg_event){.type = KG_EVENT_RELEASE, .button = button});
    return status;
}

static const struct {
    const char *name;
    kg_status (*run)(script *, const char *, kg_error *);
} verbs[] = {{"move", do_move},
             {"click", do_click},
             {"drag", do_drag},
             {"press", do_press},
             {"release", do_release},
             {"key", do_key},
             {"text", do_text},
             {"wheel", do_wheel},
             {"open", do_open},
             {"save", do_save},
             {"drop", do_drop},
             {"wait", do_wait},
             {"command", do_command},
             {"fail", do_fail},
             {"expect", do_expect},
             {"shot", do_shot},
             {"resize", do_resize},
             {"monkey", do_monkey},
             {"recover", do_recover},
             {"autosave", do_autosave},
             {"preferences", do_preferences},
             {"start", do_start},
             {"try", do_try}};

static kg_status run_line(script *s, const char *line, kg_error *error) {
    char verb[32];
    const char *words = line;
    if (!next_word(&words, verb, sizeof verb) || verb[0] == '#')
        return KG_OK;
    for (size_t i = 0; i < sizeof verbs / sizeof *verbs; i++)
        if (strcmp(verbs[i].name, verb) == 0)
            return verbs[i].run(s, words, error);
    return kg_fail(error, KG_ERR_INPUT, "there is no verb \"%s\"", verb);
}

/* Replaces $NAME by the environment's value, so that scripts find their files. */
static void expand(const char *line, size_t length, char out[MOST_LINE]) {
    size_t n = 0;
    for (size_t i = 0; i < length && n + 1 < MOST_LINE;) {
        size_t k = 0;
        if (line[i] == '$')
            k = strspn(line + i + 1, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
        if (k == 0) {
            out[n++] = line[i++];
            continue;
        }
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)k, line + i + 1);
        const char *value = getenv(name);
        for (value = value ? value : ""; *value && n + 1 < MOST_LINE; value++)
            out[n++] = *value;
        i += k + 1;
    }
    out[n] = '\0';
}

kg_status kg_script_run(kg_app *app, const char *path, kg_shot_fn shot, void *user,
                        kg_error *error) {
    char *text, line[MOST_LINE];
    size_t size;
    script s = {.app = app, .shot = shot, .user = user};
    kg_status status = kg_file_read(path, &text, &size, error);
    if (status)
        return status;
    kg_gate_set_closed(&app->gate, true);
    kg_app_run_events(app, FRAME);
    const char *at = text;
    for (int number = 1; *at && !status && !app->quit; number++) {
        size_t length = strcspn(at, "\r\n");
        expand(at, length, line);
        status = run_line(&s, line, error);
        if (status)
            kg_fail_in(error, status, "%s:%d: ", path, number);
        at += length;
        at += *at == '\r';
        at += *at == '\n';
    }
    kg_gate_set_closed(&app->gate, false);
    free(text);
    return status;
}
