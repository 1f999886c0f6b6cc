#include "app/panels/panels.h"

#include "app/mode.h"

/* Layout units. */
enum { SIDE_WIDTH = 300, TOOLBAR_WIDTH = 42, STATUS_HEIGHT = 28 };

bool kg_panel_modal(bool *open, const char *title, double width) {
    if (*open)
        kg_ui_popup_open(title);
    *open = false;
    return kg_ui_modal_begin(title, width);
}

void kg_panels_show(kg_app *app) {
    double s = app->scale * app->editor.settings.scale, menu = kg_panel_menu(app);
    double width = app->width, height = app->height, bottom = STATUS_HEIGHT * s;
    double side = fmin(SIDE_WIDTH * s, width / 2), tools = TOOLBAR_WIDTH * s;
    double middle = fmax(height - menu - bottom, 1);
    app->editor.pane.area =
        (kg_area){tools, floor(menu), fmax(floor(width - side - tools), 1), floor(middle)};
    kg_panel_net(app);
    kg_pane_keep_frame(&app->editor.pane);
    kg_panel_handles(app);
    kg_panel_axes(app);
    kg_panel_toolbar(app, (kg_area){0, menu, tools, middle});
    app->editor.mode->side(app, (kg_area){width - side, menu, side, middle});
    kg_editor_update(&app->editor); /* the others show what its fields have changed */
    kg_panel_status(app, (kg_area){0, height - bottom, width, bottom});
    kg_panel_start(app);
    kg_panel_context_menu(app);
    kg_panel_browser(app);
    kg_panel_export(app); /* after the browser, which would take the same Enter */
    kg_panel_create(app);
    kg_panel_convert(app);
    kg_panel_stand(app);
    kg_panel_palette(app);
    kg_panel_help(app);
    kg_panel_settings(app);
    kg_panel_loading(app);
    kg_panel_prompts(app);
}

void kg_panel_handles(kg_app *app) {
    if (!app->editor.mode->handles)
        return;
    kg_ui_canvas(KG_CANVAS_BEHIND);
    kg_ui_canvas_clip(app->editor.pane.area);
    app->editor.mode->handles(app);
    kg_ui_canvas_unclip();
}
