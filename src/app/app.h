/*
 * The app around an editor: it gives events to the widgets, the camera, the tools and the
 * commands, in this order, shows the panels, and draws. It knows no window: window.c and
 * headless.c feed it events and ask it to draw.
 */
#ifndef KG_APP_APP_H
#define KG_APP_APP_H

#include "app/dialogs.h"
#include "app/editor.h"
#include "app/gate.h"
#include "app/net_view.h"
#include "app/scenery.h"

/* The ball of axes as it was last drawn. */
typedef struct kg_axes_ball {
    kg_area area;
    kg_view view, pressed; /* under the pointer, and where it was pressed; KG_VIEW_COUNT: none */
    bool over, held;
} kg_axes_ball;

typedef struct kg_conversion kg_conversion;

typedef struct kg_app {
    kg_editor editor;
    kg_scenery *stage;
    kg_events events;
    int width, height; /* pixels */
    double scale;      /* of the screen, 1 without HiDPI */
    kg_dialogs dialogs;
    kg_axes_ball axes;
    kg_net_view net_view;
    kg_gate gate;                     /* of all work in the background */
    struct kg_export_job *export_job; /* NULL: nothing is being written */
    struct kg_load_job *load_job;     /* NULL: nothing is being read */
    struct kg_stand_job *stand_job;   /* NULL: no card is being made to stand */
    kg_conversion *conversion;        /* NULL: no card is being made of a mesh */
    struct {
        struct kg_load_job **items;
        size_t count, capacity;
    } given_up;                /* jobs that have not noticed yet */
    uint64_t reference_loaded; /* of editor.reference_asked */
    double autosaved;          /* clock of the last autosave */
    bool has_autosave;         /* its file is there */
    bool framed;               /* the camera was set to the document at least once */
    bool start;                /* the panel to start with is shown */
    bool quit;
    bool busy;   /* work goes on in the background: look again soon */
    bool redraw; /* the picture is no longer what is shown */
} kg_app;

/* Needs a current OpenGL context. `settings` is copied. */
kg_status kg_app_init(kg_app *app, int width, int height, double scale, const kg_settings *settings,
                      kg_error *error) KG_CHECKED;
void kg_app_clear(kg_app *app);

/* Opens a model; a mesh becomes the reference of a patch model, else a card. What goes wrong is
 * shown. */
void kg_app_open(kg_app *app, const char *path);

/* Handles one event, `seconds` after the last one. */
void kg_app_event(kg_app *app, const kg_event *event, double seconds);
/* Handles all events in the queue, then shows frames until nothing moves any more. */
void kg_app_run_events(kg_app *app, double seconds);

/* Draws into the bound framebuffer. */
kg_status kg_app_draw(kg_app *app, kg_error *error) KG_CHECKED;

/* The window's title: the file's name, with a mark when it is not saved. */
void kg_app_title(const kg_app *app, char *out, size_t size);

#endif
