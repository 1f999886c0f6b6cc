#include "app/panels/panels.h"
#include "app/tools/drag.h"
#include "app/tools/gizmo.h"

/* Layout units. */
enum { SIDE_WIDTH = 300, TOOLBAR_WIDTH = 42, STATUS_HEIGHT = 28 };

/* Of the height of the side, the part for the list of patches. */
#define OUTLINER_SHARE 0.38

void kg_panels_show(kg_app *app) {
    double s = app->scale * app->editor.settings.scale, menu = kg_panel_menu(app);
    double width = app->width, height = app->height, bottom = STATUS_HEIGHT * s;
    double side = fmin(SIDE_WIDTH * s, width / 2), tools = TOOLBAR_WIDTH * s;
    double middle = fmax(height - menu - bottom, 1);
    double list = floor(OUTLINER_SHARE * middle);
    app->editor.pane.area =
        (kg_area){tools, floor(menu), fmax(floor(width - side - tools), 1), floor(middle)};
    kg_panel_net(app);
    kg_panel_handles(app);
    kg_panel_axes(app);
    kg_panel_toolbar(app, (kg_area){0, menu, tools, middle});
    kg_panel_outliner(app, (kg_area){width - side, menu, side, list});
    kg_panel_properties(app, (kg_area){width - side, menu + list, side, middle - list});
    kg_panel_status(app, (kg_area){0, height - bottom, width, bottom});
    kg_panel_context_menu(app);
    kg_panel_browser(app);
    kg_panel_export(app); /* after the browser, which would take the same Enter */
    kg_panel_palette(app);
    kg_panel_help(app);
    kg_panel_settings(app);
    kg_panel_prompts(app);
}

void kg_panel_handles(kg_app *app) {
    const kg_editor *e = &app->editor;
    kg_vec2 from;
    kg_ui_canvas(KG_CANVAS_BEHIND);
    kg_ui_canvas_clip(e->pane.area);
    kg_gizmo_draw(e);
    if (kg_select_box_now(e, &from)) {
        kg_area box = {fmin(from.x, e->pointer.x), fmin(from.y, e->pointer.y),
                       fabs(e->pointer.x - from.x), fabs(e->pointer.y - from.y)};
        kg_ui_canvas_rect(box, (kg_color){0.3F, 0.6F, 0.95F, 0.15F}, 0);
        kg_ui_canvas_frame(box, (kg_color){0.4F, 0.7F, 1, 0.9F}, e->pane.scale, 0);
    }
    kg_ui_canvas_unclip();
}
