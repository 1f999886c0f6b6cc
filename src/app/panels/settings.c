/* Preferences. */
#include "app/language.h"
#include "app/panels/panels.h"
#include "app/text.h"

#include <stdio.h>
#include <string.h>

static void language(kg_editor *e) {
    kg_settings *s = &e->settings;
    static const char *const codes[] = {"", "en", "ja"};
    const char *const names[] = {_("as the system"), "English", "日本語"};
    int index = 0;
    for (int i = 1; i < 3; i++)
        if (strcmp(s->language, codes[i]) == 0)
            index = i;
    kg_ui_width(200);
    if (!kg_ui_choice(_("language"), names, 3, &index))
        return;
    snprintf(s->language, sizeof s->language, "%s", codes[index]);
    kg_language_use(s->language);
    kg_editor_say(e, KG_WARNING, "%s", "");
    e->stale = true; /* what is wrong with the model is said again */
}

void kg_panel_settings(kg_app *app) {
    kg_settings *s = &app->editor.settings;
    char title[64]; /* known by what is behind ###: it stays open in another language */
    snprintf(title, sizeof title, "%s###preferences", _("Preferences"));
    if (!kg_panel_modal(&app->dialogs.open_settings, title, 420))
        return;
    const char *const themes[] = {_("dark"), _("light")};
    const char *const navigations[] = {_("katagami"), _("as in Blender")};
    int theme = (int)s->theme, navigation = (int)s->navigation;
    language(&app->editor);
    kg_ui_width(200);
    if (kg_ui_choice(_("navigation"), navigations, 2, &navigation))
        s->navigation = (kg_navigation)navigation;
    kg_ui_width(200);
    if (kg_ui_choice(_("theme"), themes, 2, &theme))
        s->theme = (kg_ui_theme)theme;
    kg_ui_width(200);
    double scale = s->scale;
    kg_ui_slider(_("size of everything"), &scale, 0.75, 2.5, "%.2f");
    if (!kg_ui_mouse_held()) /* not under the pointer while it drags */
        s->scale = app->dialogs.scale > 0 ? app->dialogs.scale : scale;
    app->dialogs.scale = kg_ui_mouse_held() ? scale : 0;
    kg_ui_width(200);
    kg_ui_slider(_("autosave, minutes"), &s->autosave_minutes, 0, 15, "%.0f");
    kg_ui_tooltip(_("0: never"));
    kg_ui_space();
    if (kg_ui_primary_button(_("Close")) || kg_ui_key_pressed(KG_KEY_ESCAPE)) {
        kg_error error;
        if (kg_settings_write(s, &error))
            kg_editor_say(&app->editor, KG_FAULT, "%s", error.message);
        kg_ui_popup_close();
    }
    kg_ui_popup_end();
}
