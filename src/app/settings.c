#include "app/settings.h"

#include "base/file.h"
#include "base/json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void kg_settings_default(kg_settings *s) {
    *s = (kg_settings){.scale = 1,
                       .autosave_minutes = 2,
                       .net_view = true,
                       .net_share = 0.46,
                       .lift = 0,
                       .step = 1,
                       .export = {.format = "svg", .dash = 2, .gap = 0.5, .width = 1600}};
}

void kg_settings_clear(kg_settings *s) {
    for (int i = 0; i < KG_RECENT_COUNT; i++)
        free(s->recent[i]);
    memset(s->recent, 0, sizeof s->recent);
}

kg_status kg_settings_copy(const kg_settings *from, kg_settings *to) {
    *to = *from;
    memset(to->recent, 0, sizeof to->recent);
    for (int i = 0; i < KG_RECENT_COUNT && from->recent[i]; i++)
        if (!(to->recent[i] = strdup(from->recent[i]))) {
            kg_settings_clear(to);
            return KG_ERR_MEMORY;
        }
    return KG_OK;
}

/* ---- folders ---------------------------------------------------------------------------- */

/* Makes every folder on the way to a file. */
static bool make_folders(char *path) {
    for (char *p = strchr(path + 1, '/'); p; p = strchr(p + 1, '/')) {
        struct stat info;
        *p = '\0';
        bool there = mkdir(path, 0700) == 0 || (stat(path, &info) == 0 && S_ISDIR(info.st_mode));
        *p = '/';
        if (!there)
            return false;
    }
    return true;
}

static bool path_in(const char *variable, const char *fallback, const char *name,
                    char out[KG_PATH_SIZE]) {
    const char *base = getenv(variable), *home = getenv("HOME");
    int n = base && base[0] == '/' ? snprintf(out, KG_PATH_SIZE, "%s/katagami/%s", base, name)
            : home && home[0] == '/'
                ? snprintf(out, KG_PATH_SIZE, "%s/%s/katagami/%s", home, fallback, name)
                : -1;
    return n > 0 && n < KG_PATH_SIZE && make_folders(out);
}

bool kg_config_path(const char *name, char out[KG_PATH_SIZE]) {
    return path_in("XDG_CONFIG_HOME", ".config", name, out);
}

bool kg_state_path(const char *name, char out[KG_PATH_SIZE]) {
    return path_in("XDG_STATE_HOME", ".local/state", name, out);
}

/* ---- the file --------------------------------------------------------------------------- */

static void read_number(const json_t *root, const char *key, double lo, double hi, double *value) {
    double x = json_number_value(json_object_get(root, key));
    if (json_is_number(json_object_get(root, key)) && x >= lo && x <= hi)
        *value = x;
}

static void read_bool(const json_t *root, const char *key, bool *value) {
    if (json_is_boolean(json_object_get(root, key)))
        *value = json_is_true(json_object_get(root, key));
}

static void read_export(const json_t *root, kg_export_choice *c) {
    const char *format = json_string_value(json_object_get(root, "format"));
    if (format)
        snprintf(c->format, sizeof c->format, "%s", format);
    read_bool(root, "separate", &c->separate);
    read_bool(root, "mirrored", &c->mirrored);
    read_bool(root, "perforate", &c->perforate);
    read_number(root, "dash", 0.1, 50, &c->dash);
    read_number(root, "gap", 0.1, 50, &c->gap);
    read_number(root, "width", 64, 8192, &c->width);
}

static json_t *write_export(const kg_export_choice *c) {
    return json_pack("{s:s, s:b, s:b, s:b, s:f, s:f, s:f}", "format", c->format, "separate",
                     c->separate, "mirrored", c->mirrored, "perforate", c->perforate, "dash",
                     c->dash, "gap", c->gap, "width", c->width);
}

void kg_settings_read(kg_settings *s) {
    char path[KG_PATH_SIZE], *text;
    size_t size;
    if (!kg_config_path("settings.json", path) || kg_file_read(path, &text, &size, NULL))
        return;
    json_t *root = json_loadb(text, size, 0, NULL);
    free(text);
    const char *language = json_string_value(json_object_get(root, "language"));
    const char *navigation = json_string_value(json_object_get(root, "navigation"));
    const char *theme = json_string_value(json_object_get(root, "theme"));
    if (language)
        snprintf(s->language, sizeof s->language, "%s", language);
    if (navigation)
        s->navigation =
            strcmp(navigation, "blender") == 0 ? KG_NAVIGATION_BLENDER : KG_NAVIGATION_DEFAULT;
    if (theme)
        s->theme = strcmp(theme, "light") == 0 ? KG_UI_LIGHT : KG_UI_DARK;
    read_number(root, "scale", 0.5, 4, &s->scale);
    read_number(root, "autosave_minutes", 0, 1440, &s->autosave_minutes);
    read_number(root, "lift", -1e3, 1e3, &s->lift);
    read_number(root, "step", 1e-3, 1e3, &s->step);
    read_bool(root, "net_view", &s->net_view);
    read_number(root, "net_share", 0.2, 0.8, &s->net_share);
    read_export(json_object_get(root, "export"), &s->export);
    const json_t *recent = json_object_get(root, "recent");
    for (size_t i = json_array_size(recent); i-- > 0;)
        if (json_is_string(json_array_get(recent, i)))
            kg_settings_add_recent(s, json_string_value(json_array_get(recent, i)));
    json_decref(root);
}

kg_status kg_settings_write(const kg_settings *s, kg_error *error) {
    char path[KG_PATH_SIZE];
    if (s->transient)
        return KG_OK;
    if (!kg_config_path("settings.json", path))
        return kg_fail(error, KG_ERR_IO, "there is no home folder to keep preferences in");
    json_t *recent = json_array();
    for (int i = 0; i < KG_RECENT_COUNT && s->recent[i]; i++)
        json_array_append_new(recent, json_string(s->recent[i]));
    json_t *root = json_pack(
        "{s:s, s:s, s:s, s:f, s:f, s:f, s:f, s:b, s:f, s:o, s:o}", "language", s->language,
        "navigation", s->navigation == KG_NAVIGATION_BLENDER ? "blender" : "default", "theme",
        s->theme == KG_UI_LIGHT ? "light" : "dark", "scale", s->scale, "autosave_minutes",
        s->autosave_minutes, "lift", s->lift, "step", s->step, "net_view", s->net_view, "net_share",
        s->net_share, "export", write_export(&s->export), "recent", recent);
    char *text = root ? kg_json_text(root) : NULL;
    kg_status status = text ? kg_file_write(path, text, strlen(text), error)
                            : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(text);
    json_decref(root);
    return status;
}

void kg_settings_add_recent(kg_settings *s, const char *path) {
    char *copy = strdup(path);
    if (!copy)
        return;
    int last = 0;
    while (last < KG_RECENT_COUNT - 1 && s->recent[last] && strcmp(s->recent[last], path) != 0)
        last++;
    free(s->recent[last]);
    memmove(s->recent + 1, s->recent, (size_t)last * sizeof *s->recent);
    s->recent[0] = copy;
}
