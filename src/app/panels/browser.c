/* The file browser: opens and saves files of one kind. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"
#include "base/array.h"
#include "base/file.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* What each purpose wants. */
typedef struct kind {
    const char *title, *action;
    bool saves;
    const char *endings[12]; /* shown; the first is added to a name without one */
} kind;

#define MESHES ".obj", ".ply", ".stl", ".off", ".gltf", ".glb"

static const kind *kind_of(kg_purpose purpose) {
    static const kind open = {
        N_("Open model"), N_("Open"), false, {".katagami", ".json", ".fold", ".cp", MESHES}};
    static const kind save = {N_("Save model"), N_("Save"), true, {".katagami"}};
    static const kind net = {N_("Export net"), N_("Export"), true, {".svg", ".pdf", ".dxf"}};
    static const kind mesh = {N_("Export mesh"), N_("Export"), true, {MESHES, ".fold", ".cp"}};
    static const kind picture = {N_("Export picture"), N_("Export"), true, {".png"}};
    static const kind reference = {N_("Choose reference"), N_("Choose"), false, {MESHES}};
    static const kind guide = {N_("Export instructions"), N_("Export"), true, {".pdf"}};
    static const kind conversion = {
        N_("Choose a mesh for the card"), N_("Choose"), false, {MESHES}};
    switch (purpose) {
    case KG_FOR_SAVE:
        return &save;
    case KG_FOR_NET:
        return &net;
    case KG_FOR_MESH:
        return &mesh;
    case KG_FOR_PICTURE:
        return &picture;
    case KG_FOR_REFERENCE:
        return &reference;
    case KG_FOR_GUIDE:
        return &guide;
    case KG_FOR_CARD_OF_MESH:
        return &conversion;
    default:
        return &open;
    }
}

static bool has_ending(const kind *k, const char *name) {
    for (size_t i = 0; i < sizeof k->endings / sizeof *k->endings && k->endings[i]; i++)
        if (kg_file_ends_in(name, k->endings[i]))
            return true;
    return false;
}

bool kg_dialogs_is_mesh(const char *path) {
    return has_ending(kind_of(KG_FOR_REFERENCE), path);
}

/* ---- the folder -------------------------------------------------------------------------- */

void kg_dialogs_clear(kg_dialogs *d) {
    for (size_t i = 0; i < d->entries.count; i++)
        free(d->entries.items[i].name);
    free(d->entries.items);
    memset(&d->entries, 0, sizeof d->entries);
}

/* Folders first, then by name. */
static int compare(const void *a, const void *b) {
    const kg_browser_entry *x = a, *y = b;
    if (x->is_folder != y->is_folder)
        return x->is_folder ? -1 : 1;
    int order = strcasecmp(x->name, y->name);
    return order ? order : strcmp(x->name, y->name);
}

static void list_folder(kg_dialogs *d) {
    const kind *k = kind_of(d->purpose);
    kg_dialogs_clear(d);
    DIR *folder = opendir(d->folder);
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        char path[KG_PATH_SIZE + 256];
        struct stat info;
        snprintf(path, sizeof path, "%s/%s", d->folder, entry->d_name);
        if (entry->d_name[0] == '.' || stat(path, &info) != 0)
            continue;
        bool is_folder = S_ISDIR(info.st_mode);
        if (!is_folder && !has_ending(k, entry->d_name))
            continue;
        kg_browser_entry e = {strdup(entry->d_name), is_folder};
        if (!e.name || !kg_push(&d->entries, e))
            free(e.name);
    }
    if (folder)
        closedir(folder);
    if (d->entries.count > 1)
        qsort(d->entries.items, d->entries.count, sizeof *d->entries.items, compare);
}

static void go_to(kg_dialogs *d, const char *name) {
    size_t n = strlen(d->folder), slash = n > 1, m = strlen(name);
    if (strcmp(name, "..") == 0) {
        char *last = strrchr(d->folder, '/');
        if (last)
            last[last == d->folder] = '\0';
    } else if (n + slash + m < sizeof d->folder) {
        memcpy(d->folder + n, "/", slash);
        memcpy(d->folder + n + slash, name, m + 1);
    }
    list_folder(d);
}

/* ---- choosing --------------------------------------------------------------------------- */

void kg_dialogs_browse(kg_app *app, kg_purpose purpose) {
    kg_dialogs *d = &app->dialogs;
    const kind *k = kind_of(purpose);
    const char *path = app->editor.path, *slash = path ? strrchr(path, '/') : NULL;
    d->purpose = purpose;
    d->open_browser = d->focus = true;
    if (slash && path[0] == '/')
        snprintf(d->folder, sizeof d->folder, "%.*s", slash == path ? 1 : (int)(slash - path),
                 path);
    else if (!d->folder[0] && !getcwd(d->folder, sizeof d->folder))
        snprintf(d->folder, sizeof d->folder, "/");
    d->file[0] = '\0';
    if (k->saves) { /* a name to begin with */
        const char *name = slash ? slash + 1 : path ? path : _("untitled");
        const char *dot = strrchr(name, '.');
        snprintf(d->file, sizeof d->file, "%.*s%s",
                 (int)(dot ? (size_t)(dot - name) : strlen(name)), name, k->endings[0]);
    }
    list_folder(d);
}

static bool is_folder(const char *path) {
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* The whole path of what was chosen, with an ending. */
static bool chosen_path(const kg_dialogs *d, const kind *k, char out[KG_PATH_SIZE]) {
    const char *folder = d->file[0] == '/' ? "" : d->folder;
    const char *slash = d->file[0] == '/' || strcmp(d->folder, "/") == 0 ? "" : "/";
    int n = snprintf(out, KG_PATH_SIZE, "%s%s%s", folder, slash, d->file);
    const char *ending = k->saves && !has_ending(k, d->file) ? k->endings[0] : "";
    if (n <= 0 || (size_t)n + strlen(ending) >= KG_PATH_SIZE)
        return false;
    if (!is_folder(out))
        strcpy(out + n, ending);
    return d->file[0];
}

static void enter_path(kg_dialogs *d, const char *path) {
    char *last = d->folder + snprintf(d->folder, sizeof d->folder, "%s", path) - 1;
    if (last > d->folder && *last == '/')
        *last = '\0';
    d->file[0] = '\0';
    d->focus = true;
    list_folder(d);
}

/* The list; true when a file was double-clicked. */
static bool show_entries(kg_dialogs *d) {
    static const double widths[] = {24, 0};
    bool chosen = false;
    const char *enter = NULL;
    kg_ui_child_begin("files", 320);
    if (kg_ui_table_begin("entries", 2, widths)) {
        for (size_t i = 0; i < d->entries.count; i++) {
            const kg_browser_entry *entry = &d->entries.items[i];
            kg_ui_table_row();
            kg_ui_table_next();
            kg_ui_icon(entry->is_folder ? KG_ICON_FOLDER : KG_ICON_FILE, (kg_color){0});
            kg_ui_table_next();
            bool pressed = kg_ui_selectable(entry->name, strcmp(entry->name, d->file) == 0);
            if (pressed && entry->is_folder)
                enter = entry->name;
            else if (pressed)
                snprintf(d->file, sizeof d->file, "%s", entry->name);
            chosen = chosen || (!entry->is_folder && kg_ui_item_double_clicked());
        }
        kg_ui_table_end();
    }
    kg_ui_child_end();
    if (enter)
        go_to(d, enter);
    return chosen;
}

void kg_panel_browser(kg_app *app) {
    kg_dialogs *d = &app->dialogs;
    const kind *k = kind_of(d->purpose);
    if (!kg_panel_modal(&d->open_browser, _(k->title), 560))
        return;
    char path[KG_PATH_SIZE];
    if (kg_ui_icon_button("parent folder", KG_ICON_UP, false, 0))
        go_to(d, "..");
    kg_ui_same_line();
    kg_ui_text_dim(d->folder);
    kg_ui_separator();
    bool done = show_entries(d);
    kg_ui_width(-1);
    kg_ui_text_field("##file", d->file, sizeof d->file, _("File name"), d->focus);
    done = kg_ui_field_entered() || done;
    d->focus = false;
    kg_ui_space();
    bool ok = chosen_path(d, k, path);
    kg_ui_disabled_begin(!ok);
    done = (kg_ui_primary_button(_(k->action)) || done) && ok;
    kg_ui_disabled_end();
    if (done && is_folder(path)) {
        enter_path(d, path);
        done = false;
    }
    kg_ui_same_line();
    bool cancelled = kg_ui_button(_("Cancel")) || kg_ui_key_pressed(KG_KEY_ESCAPE);
    if (done || cancelled)
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (!done || cancelled)
        return;
    if (k->saves && access(path, F_OK) == 0 &&
        !(app->editor.path && strcmp(path, app->editor.path) == 0)) {
        snprintf(d->path, sizeof d->path, "%s", path);
        d->open_overwrite = true;
    } else {
        kg_dialogs_use_file(app, d->purpose, path);
    }
}
