/* The ball of axes in the corner of the 3D view: a click on an axis looks along it, dragging turns
 * the view. */
#include "app/panels/panels.h"

#include <string.h>

enum { AXIS_COUNT = 6, RADIUS = 38, DOT = 9, MARGIN = 14 }; /* layout units */

static kg_vec3 axis_of(int i) {
    double sign = i < 3 ? 1 : -1;
    return kg_v3(i % 3 == 0 ? sign : 0, i % 3 == 1 ? sign : 0, i % 3 == 2 ? sign : 0);
}

/* The view that looks at the model from the end of an axis. */
static const kg_view views[AXIS_COUNT] = {KG_VIEW_RIGHT, KG_VIEW_BACK,  KG_VIEW_TOP,
                                          KG_VIEW_LEFT,  KG_VIEW_FRONT, KG_VIEW_BOTTOM};
static const char *const names[] = {"X", "Y", "Z"};
static const kg_color colors[] = {
    {0.84F, 0.30F, 0.28F, 1}, {0.35F, 0.66F, 0.30F, 1}, {0.28F, 0.52F, 0.88F, 1}};

static void draw_axis(int i, kg_vec2 center, kg_vec2 tip, double s, bool hovered) {
    kg_color color = colors[i % 3];
    if (i < 3) {
        kg_ui_canvas_line(center, tip, color, 2 * s);
        kg_ui_canvas_disc(tip, DOT * s, color);
        kg_ui_canvas_text(tip, (kg_color){1, 1, 1, 1}, names[i]);
    } else {
        kg_color dim = color;
        dim.a = 0.35F;
        kg_ui_canvas_disc(tip, 0.75 * DOT * s, dim);
        kg_ui_canvas_circle(tip, 0.75 * DOT * s, color, 1.2 * s);
    }
    if (hovered)
        kg_ui_canvas_circle(tip, (DOT + 2) * s, (kg_color){1, 1, 1, 0.9F}, 1.5 * s);
}

void kg_panel_axes(kg_app *app) {
    kg_editor *e = &app->editor;
    kg_pane *pane = &e->pane;
    double s = pane->scale, side = 2 * (RADIUS + DOT + 3) * s;
    kg_area area = {pane->area.x + pane->area.width - side - MARGIN * s, pane->area.y + MARGIN * s,
                    side, side};
    kg_vec2 center = kg_v2(area.x + side / 2, area.y + side / 2), tips[AXIS_COUNT];
    double depths[AXIS_COUNT];
    kg_vec3 right, up, back;
    int hovered = -1;
    kg_camera_axes(&pane->camera, &right, &up, &back);
    for (int i = 0; i < AXIS_COUNT; i++) {
        kg_vec3 a = axis_of(i);
        depths[i] = kg_dot(a, back);
        tips[i] =
            kg_v2(center.x + RADIUS * s * kg_dot(a, right), center.y - RADIUS * s * kg_dot(a, up));
        if (kg_dist2(tips[i], e->pointer) <= DOT * s &&
            (hovered < 0 || depths[i] > depths[hovered]))
            hovered = i;
    }
    bool over =
        kg_area_contains(area, e->pointer) && kg_dist2(center, e->pointer) <= (RADIUS + DOT) * s;
    kg_ui_canvas(KG_CANVAS_BEHIND);
    if (over)
        kg_ui_canvas_disc(center, (RADIUS + DOT) * s, (kg_color){0.5F, 0.5F, 0.55F, 0.25F});
    bool drawn[AXIS_COUNT];
    memset(drawn, 0, sizeof drawn);
    for (int n = 0; n < AXIS_COUNT; n++) { /* the farthest first */
        int next = -1;
        for (int i = 0; i < AXIS_COUNT; i++)
            if (!drawn[i] && (next < 0 || depths[i] < depths[next]))
                next = i;
        drawn[next] = true;
        draw_axis(next, center, tips[next], s, next == hovered);
    }
    kg_axes_ball *ball = &app->axes;
    ball->area = area;
    ball->view = hovered >= 0 ? views[hovered] : KG_VIEW_COUNT;
    ball->over = over;
}

bool kg_axes_event(kg_app *app, const kg_event *event) {
    kg_axes_ball *ball = &app->axes;
    kg_pane *pane = &app->editor.pane;
    if (event->type == KG_EVENT_PRESS && event->button == KG_MOUSE_LEFT && ball->over) {
        ball->pressed = ball->view;
        pane->drag = KG_DRAG_ORBIT;
        pane->button = KG_MOUSE_LEFT;
        pane->pressed = pane->last = event->position;
        pane->moved = false;
        ball->held = true;
        return true;
    }
    if (event->type == KG_EVENT_RELEASE && ball->held) {
        if (!pane->moved && ball->pressed != KG_VIEW_COUNT) {
            kg_camera_look(&pane->camera, ball->pressed);
            pane->camera.ortho = true;
        }
        ball->held = false;
    }
    return false;
}
