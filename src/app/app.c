#include "app/app.h"

#include "app/commands/commands.h"
#include "app/language.h"
#include "app/mode.h"
#include "app/panels/panels.h"
#include "app/recovery.h"
#include "app/text.h"
#include "app/tools/tool.h"

#include <stdio.h>
#include <string.h>

/* Frames after an event until everything has its place: a menu opens in the second. More would mean
 * that something moves for ever. */
enum { MOST_FRAMES = 8 };

kg_status kg_app_init(kg_app *app, int width, int height, double scale, const kg_settings *settings,
                      kg_error *error) {
    kg_language_use(settings->language);
    *app = (kg_app){.width = width, .height = height, .scale = scale, .redraw = true};
    app->dialogs.creation = kg_creation_default();
    kg_status status = kg_editor_init(&app->editor, settings, error);
    if (status)
        return status;
    kg_gate_init(&app->gate);
    if (!(status = kg_net_view_init(&app->net_view, &app->gate, error)))
        status = kg_ui_create(error);
    if (!status)
        status = kg_scenery_create(&app->stage, error);
    if (status)
        kg_app_clear(app);
    return status;
}

void kg_app_clear(kg_app *app) {
    kg_export_stop(app);
    kg_loading_stop(app);
    kg_conversion_stop(app);
    kg_stand_stop(app);
    kg_net_view_clear(&app->net_view);
    kg_scenery_destroy(app->stage);
    kg_ui_destroy();
    kg_editor_clear(&app->editor);
    kg_events_clear(&app->events);
    kg_dialogs_clear(&app->dialogs);
    kg_gate_clear(&app->gate);
}

/* ---- requests of commands ---------------------------------------------------------------- */

static void serve_request(kg_app *app) {
    kg_request request = app->editor.request;
    app->editor.request = KG_REQUEST_NONE;
    switch (request) {
    case KG_REQUEST_NEW:
        kg_dialogs_go_on(app, KG_FOR_NEW);
        break;
    case KG_REQUEST_NEW_CARD:
        kg_dialogs_go_on(app, KG_FOR_NEW_CARD);
        break;
    case KG_REQUEST_NEW_SHEETS:
        kg_dialogs_go_on(app, KG_FOR_NEW_SHEETS);
        break;
    case KG_REQUEST_CARD_FROM_MESH:
        kg_dialogs_go_on(app, KG_FOR_CONVERSION);
        break;
    case KG_REQUEST_OPEN:
        kg_dialogs_go_on(app, KG_FOR_OPEN);
        break;
    case KG_REQUEST_QUIT:
        kg_dialogs_go_on(app, KG_FOR_QUIT);
        break;
    case KG_REQUEST_SAVE_AS:
        kg_dialogs_browse(app, KG_FOR_SAVE);
        break;
    case KG_REQUEST_REFERENCE:
        kg_dialogs_browse(app, KG_FOR_REFERENCE);
        break;
    case KG_REQUEST_EXPORT_NET:
        kg_export_ask(app, KG_FOR_NET);
        break;
    case KG_REQUEST_EXPORT_MESH:
        kg_export_ask(app, KG_FOR_MESH);
        break;
    case KG_REQUEST_EXPORT_GUIDE:
        kg_export_ask(app, KG_FOR_GUIDE);
        break;
    case KG_REQUEST_STAND:
        kg_stand_begin(app);
        break;
    case KG_REQUEST_PALETTE:
        app->dialogs.open_palette = true;
        break;
    case KG_REQUEST_HELP:
        app->dialogs.open_help = true;
        break;
    case KG_REQUEST_SETTINGS:
        app->dialogs.open_settings = true;
        break;
    case KG_REQUEST_RENAME:
        app->dialogs.open_rename = true;
        break;
    case KG_REQUEST_ERROR:
        snprintf(app->dialogs.error, sizeof app->dialogs.error, "%s", app->editor.message);
        app->dialogs.open_error = true;
        break;
    case KG_REQUEST_MENU:
        app->dialogs.open_menu = true;
        break;
    case KG_REQUEST_NONE:
        break;
    }
}

void kg_app_open(kg_app *app, const char *path) {
    snprintf(app->dialogs.path, sizeof app->dialogs.path, "%s", path);
    if (!kg_dialogs_is_mesh(path))
        kg_dialogs_go_on(app, KG_FOR_OPEN_PATH);
    else if (kg_editor_model(&app->editor))
        kg_dialogs_use_file(app, KG_FOR_REFERENCE, path);
    else
        kg_dialogs_go_on(app, KG_FOR_CARD_OF_PATH);
}

/* ---- events ----------------------------------------------------------------------------- */

static bool is_of_mouse(const kg_event *e) {
    return e->type == KG_EVENT_MOVE || e->type == KG_EVENT_PRESS || e->type == KG_EVENT_RELEASE ||
           e->type == KG_EVENT_WHEEL;
}

static void give_to_editor(kg_app *app, const kg_event *event) {
    kg_editor *e = &app->editor;
    if (event->type == KG_EVENT_PRESS || event->type == KG_EVENT_KEY)
        app->start = false;
    if (kg_axes_event(app, event) || kg_net_view_event(&app->net_view, e, event))
        return;
    if (event->type == KG_EVENT_WHEEL && e->tool->event(e, event)) /* what is held may want it */
        return;
    if (kg_pane_event(&e->pane, event, e->settings.navigation))
        return;
    if (e->tool->event(e, event) || event->type != KG_EVENT_KEY)
        return;
    const kg_app_command *command = kg_command_of_key(e, event);
    if (command)
        kg_command_use(command, e);
}

static void give_to_app(kg_app *app, const kg_event *event) {
    switch (event->type) {
    case KG_EVENT_RESIZE:
        app->width = event->width;
        app->height = event->height;
        app->scale = event->scale;
        break;
    case KG_EVENT_CLOSE:
        kg_dialogs_go_on(app, KG_FOR_QUIT);
        break;
    case KG_EVENT_DROP:
        if (event->path) /* memory ran out otherwise */
            kg_app_open(app, event->path);
        break;
    default:
        break;
    }
}

static void move_on(kg_app *app, double seconds) {
    kg_editor *e = &app->editor;
    if (e->mode->tick && e->mode->tick(e, seconds))
        app->busy = app->redraw = true;
}

void kg_app_event(kg_app *app, const kg_event *event, double seconds) {
    kg_editor *e = &app->editor;
    double scale = app->scale * e->settings.scale;
    e->clock += seconds;
    e->mods = event->type == KG_EVENT_NONE ? e->mods : event->mods;
    e->pane.scale = scale;
    if (is_of_mouse(event))
        e->pointer = event->position;
    bool acts = event->type == KG_EVENT_PRESS || event->type == KG_EVENT_KEY;
    if (kg_editor_message_due(e) == 0 || (acts && kg_editor_message_due(e) > 0)) {
        e->message[0] = '\0';
        app->redraw = true;
    }
    give_to_app(app, event);
    kg_ui_set_look(e->settings.theme, scale);
    kg_ui_begin(event, app->width, app->height, seconds);
    bool dragging = e->pane.drag != KG_DRAG_NONE;
    if (is_of_mouse(event) && kg_ui_has_mouse()) { /* panels may set it again */
        e->hover_patch = 0;
        e->hover_point.patch = 0;
    }
    if (is_of_mouse(event) ? dragging || !kg_ui_has_mouse() : !kg_ui_has_keys())
        give_to_editor(app, event);
    serve_request(app);
    kg_editor_update(e);
    move_on(app, seconds); /* before the panels, which show the same moment as the view */
    kg_panels_show(app);
    serve_request(app);
    kg_editor_update(e);
    move_on(app, 0); /* what they began */
    kg_ui_end();
    if (!app->framed && !app->load_job && e->pane.area.width > 1) {
        kg_pane_fit(&e->pane, kg_editor_box(e, false));
        app->framed = true;
    }
    kg_recovery_tick(app);
    app->redraw = app->redraw || event->type != KG_EVENT_NONE;
}

void kg_app_run_events(kg_app *app, double seconds) {
    kg_event event;
    while (kg_events_take(&app->events, &event)) {
        kg_app_event(app, &event, seconds);
        kg_event_clear(&event);
        seconds = 0;
    }
    for (int i = 0; i < MOST_FRAMES && (i == 0 || kg_ui_unsettled()); i++) {
        kg_event nothing = {.mods = app->editor.mods};
        app->redraw = app->redraw || kg_ui_unsettled();
        kg_app_event(app, &nothing, seconds);
        seconds = 0;
    }
}

kg_status kg_app_draw(kg_app *app, kg_error *error) {
    kg_status status = kg_scenery_draw(app->stage, &app->editor, app->height, error);
    if (!status)
        kg_ui_draw();
    app->redraw = false;
    return status;
}

void kg_app_title(const kg_app *app, char *out, size_t size) {
    const char *path = app->editor.path, *slash = path ? strrchr(path, '/') : NULL;
    snprintf(out, size, "%s%s — katagami", kg_editor_is_modified(&app->editor) ? "● " : "",
             slash  ? slash + 1
             : path ? path
                    : _("untitled"));
}
