/* What the mouse does on the pages of a net. */
#include "app/commands/commands.h"
#include "app/mode.h"
#include "app/net_view.h"
#include "app/text.h"
#include "document/pin.h"
#include "net/clash.h"

#include <stdlib.h>

#define TURN_STEP (KG_PI / 12) /* with Ctrl: 15 degrees */

static const double ZOOM_STEP = 1.15, LEAST_ZOOM = 0.05, MOST_ZOOM = 200;

enum { HANDLE_NEAR = 10, DIVIDER = 5 }; /* layout units */

static const kg_net_part *part_of(const kg_net_view *v, int part) {
    return &kg_net_state_picture(v->state)->net.net->parts[part];
}

/* ---- moving a part ---------------------------------------------------------------------- */

/* Looks for overlaps with the part where it is now; without memory the old ones stay. */
static void follow_clashes(kg_net_view *v) {
    const kg_net_picture *p = kg_net_state_picture(v->state);
    kg_net_layout layout = *p->layout;
    size_t count = p->net.net->part_count;
    kg_error error;
    layout.placements = calloc(count, sizeof *layout.placements);
    if (!v->clashes)
        v->clashes = calloc(count, sizeof *v->clashes);
    for (size_t i = 0; layout.placements && i < count; i++)
        layout.placements[i] = kg_net_view_placement(v, i);
    if (!layout.placements || !v->clashes ||
        kg_net_clashes(p->net.net, &layout, &p->options, v->clashes, &error)) {
        free(v->clashes);
        v->clashes = NULL;
    }
    free(layout.placements);
}

/* The page nearest to a point of the board. */
static int page_at(const kg_net_view *v, kg_vec2 board) {
    kg_vec2 size = kg_net_state_picture(v->state)->layout->page_size;
    double nearest = INFINITY;
    int best = 0;
    for (int i = 0; i < (int)kg_net_view_page_count(v); i++) {
        kg_vec2 at = kg_net_view_page_origin(v, i);
        kg_vec2 off = kg_v2(fmax(fmax(at.x - board.x, board.x - at.x - size.x), 0),
                            fmax(fmax(at.y - board.y, board.y - at.y - size.y), 0));
        if (kg_len2(off) < nearest) {
            nearest = kg_len2(off);
            best = i;
        }
    }
    return best;
}

static void begin(kg_net_view *v, kg_net_gesture gesture, int part) {
    v->gesture = gesture;
    v->active_part = part;
    v->before = kg_net_view_placement(v, (size_t)part);
    v->moved_part = part;
    v->moved = v->before;
}

static double rounded(double x, double step) {
    return step > 0 ? round(x / step) * step : x;
}

static void move_part(kg_net_view *v, const kg_editor *e, const kg_event *event) {
    kg_vec2 by = kg_scale2(kg_sub2(event->position, v->pressed), 1 / v->zoom);
    kg_vec2 board =
        kg_add2(kg_add2(kg_net_view_page_origin(v, v->before.page), v->before.offset), by);
    v->moved.page = page_at(v, kg_net_view_to_board(v, event->position));
    v->moved.offset = kg_sub2(board, kg_net_view_page_origin(v, v->moved.page));
    if (event->mods & KG_MOD_CTRL)
        v->moved.offset = kg_v2(rounded(v->moved.offset.x, e->settings.step),
                                rounded(v->moved.offset.y, e->settings.step));
    follow_clashes(v);
}

static void turn_part(kg_net_view *v, const kg_event *event) {
    kg_vec2 center, handle;
    if (!kg_net_view_handle(v, &center, &handle))
        return;
    kg_vec2 from = kg_sub2(v->pressed, center), to = kg_sub2(event->position, center);
    double by = atan2(kg_cross2(from, to), kg_dot2(from, to));
    if (event->mods & KG_MOD_CTRL)
        by = rounded(v->before.angle + by, TURN_STEP) - v->before.angle;
    v->moved = v->before;
    v->moved = kg_net_view_turned(v, (size_t)v->moved_part, by);
    follow_clashes(v);
}

/* Pins the moved part where it is now. It stays there until the next picture. */
static void drop(kg_net_view *v, kg_editor *e) {
    const kg_net *net = kg_net_state_picture(v->state)->net.net;
    const kg_net_part *part = &net->parts[v->moved_part];
    json_t *arguments = json_pack(
        "{s:I, s:I, s:i, s:f, s:f, s:f}", "patch", (json_int_t)part->source, "piece",
        (json_int_t)kg_pin_piece(net, (size_t)v->moved_part), "page", v->moved.page, "x",
        v->moved.offset.x, "y", v->moved.offset.y, "angle_deg", v->moved.angle * 180 / KG_PI);
    if (!kg_command_do_with(e, "net.pin", arguments))
        v->moved_part = -1;
}

static void give_up(kg_net_view *v) {
    v->moved_part = -1;
    free(v->clashes);
    v->clashes = NULL;
    v->gesture = KG_NET_IDLE;
}

/* ---- the divider ------------------------------------------------------------------------- */

static bool is_on_divider(const kg_net_view *v, kg_vec2 px) {
    return px.x < v->area.x + DIVIDER * v->scale;
}

static void divide(const kg_net_view *v, kg_editor *e, kg_vec2 px) {
    double left = e->pane.area.x, right = v->area.x + v->area.width;
    e->settings.net_share = fmin(fmax((right - px.x) / (right - left), 0.2), 0.8);
}

static void keep_settings(kg_editor *e) {
    kg_error error;
    if (kg_settings_write(&e->settings, &error))
        kg_editor_say(e, KG_WARNING, "%s", error.message);
}

/* ---- events ----------------------------------------------------------------------------- */

static void hover(kg_net_view *v, kg_editor *e, kg_vec2 px) {
    v->on_divider = is_on_divider(v, px);
    v->hover_join = kg_net_view_join_at(v, px);
    v->hover_part = kg_net_view_part_at(v, px);
    e->hover_point = (kg_point_ref){0};
    e->hover_patch =
        v->hover_part >= 0 && kg_editor_model(e) ? part_of(v, v->hover_part)->source : 0;
    e->hover_seam[0] = e->hover_seam[1] = 0;
    if (v->hover_join < 0 || !kg_editor_model(e))
        return;
    const kg_net_join *join = &kg_net_state_picture(v->state)->net.net->joins[v->hover_join];
    const kg_solved_patch *patch = kg_solution_find(kg_editor_solution(e), join->sources[0]);
    if (!patch || !patch->prepared)
        return;
    e->hover_seam[0] = join->sources[0];
    e->hover_seam[1] = join->sources[1];
    e->hover_seam_at = join->course[0][KG_JOIN_PLACES / 2];
    e->hover_seam_place = kg_patch_point(&patch->patch, e->hover_seam_at.x, e->hover_seam_at.y);
    if (e->hover_patch != join->sources[1])
        e->hover_patch = join->sources[0];
}

/* Gives an event to the mode, with the point of the part under the pointer. */
static bool give_to_mode(const kg_net_view *v, kg_editor *e, const kg_event *event) {
    int part = kg_net_view_part_at(v, event->position);
    kg_vec2 point;
    if (!e->mode->net_event)
        return false;
    if (part >= 0)
        point = kg_net_view_part_point(v, (size_t)part, event->position);
    return e->mode->net_event(e, event, part >= 0 ? &point : NULL);
}

static void press(kg_net_view *v, kg_editor *e, const kg_event *event) {
    kg_vec2 center, handle;
    v->button = event->button;
    v->pressed = v->last = event->position;
    v->gesture = is_on_divider(v, event->position) ? KG_NET_DIVIDING : KG_NET_PRESSED;
    if (v->gesture == KG_NET_PRESSED && event->button == KG_MOUSE_LEFT &&
        kg_net_view_handle(v, &center, &handle) &&
        kg_dist2(handle, event->position) < HANDLE_NEAR * v->scale)
        begin(v, KG_NET_TURNING, v->active_part);
    else if (v->gesture == KG_NET_PRESSED && event->button == KG_MOUSE_LEFT &&
             give_to_mode(v, e, event))
        v->gesture = KG_NET_EDITING;
}

static void move(kg_net_view *v, kg_editor *e, const kg_event *event) {
    bool far = kg_dist2(event->position, v->pressed) >= KG_CLICK_DISTANCE * v->scale;
    const kg_net_picture *p = kg_net_state_picture(v->state);
    if (v->gesture == KG_NET_PRESSED && far) {
        int part = v->button == KG_MOUSE_LEFT && p && p->options.paper.x > 0 && kg_editor_model(e)
                       ? kg_net_view_part_at(v, v->pressed)
                       : -1;
        if (part >= 0)
            begin(v, KG_NET_MOVING, part);
        else
            v->gesture = KG_NET_PANNING;
    }
    switch (v->gesture) {
    case KG_NET_IDLE:
        hover(v, e, event->position);
        give_to_mode(v, e, event);
        break;
    case KG_NET_EDITING:
        give_to_mode(v, e, event);
        break;
    case KG_NET_PRESSED:
        return;
    case KG_NET_PANNING:
        v->fitted = false;
        v->pan = kg_add2(v->pan, kg_sub2(event->position, v->last));
        break;
    case KG_NET_MOVING:
        move_part(v, e, event);
        break;
    case KG_NET_TURNING:
        v->last = event->position;
        turn_part(v, event);
        break;
    case KG_NET_DIVIDING:
        divide(v, e, event->position);
        break;
    }
    v->last = event->position;
}

static void click(kg_net_view *v, kg_editor *e, const kg_event *event) {
    int part = kg_net_view_part_at(v, event->position);
    if (v->button == KG_MOUSE_RIGHT) {
        v->menu_part = part;
        v->menu_join = kg_net_view_join_at(v, event->position);
        v->open_menu = true;
        return;
    }
    if (v->button != KG_MOUSE_LEFT)
        return;
    if (!kg_editor_model(e)) /* one sheet: nothing to choose from */
        return;
    v->active_part = part;
    if (part >= 0)
        kg_editor_select(e, part_of(v, part)->source, event->mods & KG_MOD_SHIFT);
    else if (!(event->mods & KG_MOD_SHIFT))
        kg_editor_select_none(e);
}

static void release(kg_net_view *v, kg_editor *e, const kg_event *event) {
    kg_net_gesture gesture = v->gesture;
    v->gesture = KG_NET_IDLE;
    if (gesture == KG_NET_PRESSED)
        click(v, e, event);
    else if (gesture == KG_NET_MOVING || gesture == KG_NET_TURNING)
        drop(v, e);
    else if (gesture == KG_NET_DIVIDING)
        keep_settings(e);
    else if (gesture == KG_NET_EDITING)
        give_to_mode(v, e, event);
}

static void zoom(kg_net_view *v, const kg_event *event) {
    kg_vec2 at = kg_net_view_to_board(v, event->position);
    double zoom = v->zoom * pow(ZOOM_STEP, event->wheel);
    v->fitted = false;
    v->zoom = fmin(fmax(zoom, LEAST_ZOOM * v->scale), MOST_ZOOM * v->scale);
    v->pan = kg_sub2(event->position, kg_scale2(at, v->zoom));
}

static bool key(kg_net_view *v, const kg_event *event) {
    bool busy = v->gesture == KG_NET_MOVING || v->gesture == KG_NET_TURNING;
    if (event->key == KG_KEY_ESCAPE && busy) {
        give_up(v);
        return true;
    }
    if ((event->key == KG_KEY_HOME || event->key == 'F') && event->mods == 0 &&
        kg_area_contains(v->area, v->last)) {
        kg_net_view_fit(v);
        return true;
    }
    return busy;
}

bool kg_net_view_event(kg_net_view *v, kg_editor *e, const kg_event *event) {
    bool mine = v->gesture != KG_NET_IDLE;
    bool over = mine || (!v->foreign && !e->before && kg_area_contains(v->area, event->position));
    switch (event->type) {
    case KG_EVENT_MOVE:
        if (!over) {
            v->hover_part = v->hover_join = -1;
            v->on_divider = false;
            v->last = event->position;
            return false;
        }
        move(v, e, event);
        return true;
    case KG_EVENT_PRESS:
        v->foreign = !over;
        if (over && !mine)
            press(v, e, event);
        return over;
    case KG_EVENT_RELEASE:
        v->foreign = false;
        if (mine && event->button == v->button)
            release(v, e, event);
        return mine;
    case KG_EVENT_WHEEL:
        if (over)
            zoom(v, event);
        return over;
    case KG_EVENT_KEY:
        return v->area.width > 0 && key(v, event);
    default:
        return false;
    }
}
