/* The command palette and the help of keys: the table of commands, searched and listed. */
#include "app/commands/commands.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <ctype.h>
#include <string.h>

/* Layout units; more commands are reached by scrolling. */
enum { LIST_HEIGHT = 330 };

/* Every word of `search` occurs in `text`, in any case of ASCII letters. */
static bool matches(const char *text, const char *search) {
    char word[64];
    while (*search) {
        size_t n = strcspn(search, " "), m = n < sizeof word ? n : sizeof word - 1;
        bool found = n == 0;
        for (const char *at = text; *at && !found; at++) {
            size_t k = 0;
            while (k < m && tolower((unsigned char)at[k]) == tolower((unsigned char)search[k]))
                k++;
            found = k == m;
        }
        if (!found)
            return false;
        search += n;
        search += *search == ' ';
    }
    return true;
}

static bool is_listed(const kg_editor *e, const kg_app_command *c, const char *search) {
    return kg_command_is_for(c, kg_document_get_kind(e->document)) &&
           !(c->flags & KG_COMMAND_HIDDEN) && strcmp(c->id, "edit.palette") != 0 &&
           (matches(_(c->title), search) || matches(c->id, search));
}

/* True when the choice is another one by the keyboard: the list scrolls to it. */
static bool move_choice(kg_dialogs *d, size_t count) {
    size_t before = d->chosen;
    if (kg_ui_key_pressed(KG_KEY_DOWN) && d->chosen + 1 < count)
        d->chosen++;
    if (kg_ui_key_pressed(KG_KEY_UP) && d->chosen > 0)
        d->chosen--;
    if (d->chosen >= count)
        d->chosen = count > 0 ? count - 1 : 0;
    return d->chosen != before;
}

void kg_panel_palette(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_dialogs *d = &app->dialogs;
    static const double widths[] = {0, 120};
    if (d->open_palette) {
        d->open_palette = false;
        d->search[0] = '\0';
        d->chosen = 0;
        d->focus = true;
        kg_ui_popup_open("palette");
    }
    if (!kg_ui_palette_begin("palette", 440))
        return;
    const kg_app_command *run = NULL;
    size_t count = 0, n = 0;
    kg_ui_width(-1);
    if (kg_ui_text_field("##search", d->search, sizeof d->search, _("Find a command"), d->focus) &
        KG_FIELD_CHANGED)
        d->chosen = 0;
    bool entered = kg_ui_field_entered();
    d->focus = false;
    for (size_t i = 0; i < kg_command_count(); i++)
        count += is_listed(e, kg_command_at(i), d->search);
    bool moved = move_choice(d, count);
    kg_ui_child_begin("list", LIST_HEIGHT);
    if (kg_ui_table_begin("found", 2, widths)) {
        for (size_t i = 0; i < kg_command_count(); i++) {
            const kg_app_command *c = kg_command_at(i);
            char keys[32];
            if (!is_listed(e, c, d->search))
                continue;
            bool chosen = n++ == d->chosen;
            kg_ui_table_row();
            kg_ui_table_next();
            kg_ui_disabled_begin(!kg_command_is_enabled(c, e));
            if (kg_ui_selectable(_(c->title), chosen) || (chosen && entered))
                run = c;
            if (chosen && moved)
                kg_ui_scroll_here();
            kg_ui_tooltip(_(c->help));
            kg_ui_disabled_end();
            kg_ui_table_next();
            kg_command_shortcut(c, e->settings.navigation, keys);
            kg_ui_text_dim(keys);
        }
        kg_ui_table_end();
    }
    if (count == 0)
        kg_ui_text_dim(_("No command has these words."));
    kg_ui_child_end();
    if (run || kg_ui_key_pressed(KG_KEY_ESCAPE))
        kg_ui_popup_close();
    kg_ui_popup_end();
    if (run)
        kg_command_do(e, run->id);
}

/* ---- help ------------------------------------------------------------------------------- */

/* What the mouse does is in no table. */
static const struct {
    const char *what, *keys;
    const char *blender_keys; /* NULL: the same */
    unsigned kinds;           /* of documents, 0: all */
} mouse[] = {
    {N_("Turn the view"), N_("Right drag"), N_("Middle drag"), 0},
    {N_("Move the view"), N_("Middle drag, Shift + right drag"), N_("Shift + middle drag"), 0},
    {N_("Zoom"), N_("Wheel"), N_("Wheel, Ctrl + middle drag"), 0},
    {N_("Select"), N_("Click; Shift adds; again: what lies behind"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_PATCHES)},
    {N_("Select several"), N_("Drag over empty space"), NULL, KG_FOR_KIND(KG_DOCUMENT_PATCHES)},
    {N_("Drag a control point"), N_("Alt: off the reference; Ctrl: steps; Shift: fine"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_PATCHES)},
    {N_("Fold a corner"), N_("Drag it; Ctrl: steps; Alt: free; Shift: look first"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)},
    {N_("Layers at a corner"), N_("Click it, or numbers"), NULL, KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)},
    {N_("While folding: layers, gaps, angle"), N_("Wheel; Shift + wheel; numbers"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_ORIGAMI)},
    {N_("Add voxels"), N_("Click or drag"), NULL, KG_FOR_KIND(KG_DOCUMENT_OA)},
    {N_("Remove voxels"), N_("Shift + click or drag"), NULL, KG_FOR_KIND(KG_DOCUMENT_OA)},
    {N_("Fill or empty a box"), N_("Ctrl + drag, Ctrl + Shift + drag"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_OA)},
    {N_("Select a box"), N_("Alt + drag, Shift + arrows"), NULL, KG_FOR_KIND(KG_DOCUMENT_OA)},
    {N_("Move the cursor"), N_("Arrows, Page Up and Page Down for the third direction"), NULL,
     KG_FOR_KIND(KG_DOCUMENT_OA)},
    {N_("Windows and tops"), N_("Click or drag in the net"), NULL, KG_FOR_KIND(KG_DOCUMENT_OA)},
};

static void help_row(const char *what, const char *keys) {
    kg_ui_table_row();
    kg_ui_table_next();
    kg_ui_text(what);
    kg_ui_table_next();
    kg_ui_text_dim(keys);
}

void kg_panel_help(kg_app *app) {
    static const double widths[] = {230, 0};
    kg_navigation navigation = app->editor.settings.navigation;
    kg_document_kind kind = kg_document_get_kind(app->editor.document);
    bool blender = navigation == KG_NAVIGATION_BLENDER;
    if (app->dialogs.open_help)
        kg_ui_popup_open("help");
    app->dialogs.open_help = false;
    if (!kg_ui_palette_begin("help", 640))
        return;
    kg_ui_text(_("Keys and mouse"));
    kg_ui_separator();
    kg_ui_child_begin("list", 460);
    if (kg_ui_table_begin("keys", 2, widths)) {
        for (size_t i = 0; i < sizeof mouse / sizeof *mouse; i++)
            if (mouse[i].kinds == 0 || mouse[i].kinds & KG_FOR_KIND(kind))
                help_row(
                    _(mouse[i].what),
                    _(blender && mouse[i].blender_keys ? mouse[i].blender_keys : mouse[i].keys));
        for (size_t i = 0; i < kg_command_count(); i++) {
            const kg_app_command *c = kg_command_at(i);
            const char *keys = kg_command_keys(c, navigation);
            char shown[64];
            if (!keys || !kg_command_is_for(c, kind))
                continue;
            size_t n = 0; /* "A|B" as "A, B" */
            for (const char *k = keys; *k && n + 3 < sizeof shown; k++) {
                shown[n++] = *k == '|' ? ',' : *k;
                if (*k == '|')
                    shown[n++] = ' ';
            }
            shown[n] = '\0';
            help_row(_(c->title), shown);
        }
        kg_ui_table_end();
    }
    kg_ui_child_end();
    if (kg_ui_key_pressed(KG_KEY_ESCAPE))
        kg_ui_popup_close();
    kg_ui_popup_end();
}
