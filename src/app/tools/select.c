/*
 * Selecting, and dragging control points and extents: what the mouse does when no other tool is in
 * use.
 */
#include "app/text.h"
#include "app/tools/box.h"
#include "app/tools/corner.h"
#include "app/tools/cutter.h"
#include "app/tools/drag.h"
#include "app/tools/gesture.h"
#include "app/tools/gizmo.h"
#include "app/tools/seam.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"
#include "base/array.h"

#include <stdlib.h>

enum { GRAB_DISTANCE = 9, MOST_HITS = 32 }; /* layout units; patches behind one another */

typedef enum gesture {
    IDLE,
    PRESSED,
    DRAGGING_POINTS,
    DRAGGING_EXTENT,
    DRAGGING_CORNER,
    BOXING
} gesture;

typedef struct state {
    gesture gesture;
    kg_vec2 pressed;
    bool on_patch; /* the press was over one */
    kg_point_drag drag;
    kg_extent_drag extent;
    kg_corner corner;
    kg_cutter_preview cutters;
    kg_vec2 cycled_at; /* where the last click was, to reach what lies behind */
    size_t depth;
} state;

static state *state_of(kg_editor *e) {
    if (!e->tool_state)
        e->tool_state = calloc(1, sizeof(state));
    return e->tool_state;
}

/* ---- what lies under the pointer --------------------------------------------------------- */

static kg_point_ref point_under(const kg_editor *e, kg_vec2 px) {
    const kg_model *m = kg_editor_model(e);
    kg_point_ref best = {0};
    double nearest = GRAB_DISTANCE * e->pane.scale;
    for (size_t i = 0; i < m->patch_count; i++) {
        const kg_model_patch *p = &m->patches[i];
        for (size_t k = 0; kg_editor_shows_points(e, p->id) && k < p->input.point_count; k++) {
            kg_vec2 at;
            if (!kg_pane_project(&e->pane, p->input.points[k], &at) || kg_dist2(at, px) >= nearest)
                continue;
            nearest = kg_dist2(at, px);
            best = (kg_point_ref){p->id, k};
        }
    }
    return best;
}

static void hover(kg_editor *e, kg_vec2 px) {
    kg_hit hit;
    e->hover_point = point_under(e, px);
    e->hover_patch = !e->hover_point.patch && kg_editor_hits(e, px, &hit, 1) > 0 ? hit.patch : 0;
    e->hover_seam[0] = e->hover_seam[1] = 0;
    if (!e->hover_point.patch)
        kg_seam_hover(e, px);
}

/* ---- clicks ----------------------------------------------------------------------------- */

/* The patch under the pointer; clicking again at the same place goes one deeper. */
static void click(kg_editor *e, state *s, kg_vec2 px, bool toggle) {
    kg_hit hits[MOST_HITS];
    size_t count = kg_editor_hits(e, px, hits, MOST_HITS);
    if (count == 0) {
        if (!toggle)
            kg_editor_select_none(e);
        return;
    }
    bool again = !toggle && kg_dist2(px, s->cycled_at) < KG_CLICK_DISTANCE * e->pane.scale;
    s->depth = again ? (s->depth + 1) % count : 0;
    s->cycled_at = px;
    kg_editor_select(e, hits[s->depth].patch, toggle);
}

/* ---- gestures --------------------------------------------------------------------------- */

static void press(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    bool toggle = event->mods & KG_MOD_SHIFT;
    kg_error error;
    kg_gizmo_handle handle = kg_gizmo_under(e, event->position);
    if (handle.any) { /* this tool ends here */
        if (kg_tool_hold_transform(e, handle.kind, handle.axis, &error))
            kg_editor_say(e, KG_FAULT, "%s", error.message);
        return;
    }
    s->pressed = event->position;
    s->gesture = PRESSED;
    hover(e, event->position);
    s->on_patch = e->hover_patch != 0;
    s->corner = e->hover_point.patch ? (kg_corner){0} : kg_corner_under(e, event->position);
    if (!s->corner.patch && !e->hover_point.patch && event->mods & KG_MOD_CTRL)
        s->corner = kg_corner_insert(e, event->position);
    if (s->corner.patch) {
        if (kg_editor_begin(e, N_("Move corner"), &error))
            kg_editor_say(e, KG_FAULT, "%s", error.message);
        else
            s->gesture = DRAGGING_CORNER;
    } else if (kg_extent_drag_start(&s->extent, e, event->position)) {
        s->gesture = DRAGGING_EXTENT;
    } else if (e->hover_point.patch) {
        if (toggle || !kg_editor_is_point_selected(e, e->hover_point))
            kg_editor_select_point(e, e->hover_point, toggle);
        if (kg_point_drag_start(&s->drag, e, e->hover_point, event->position, &error))
            kg_editor_say(e, KG_FAULT, "%s", error.message);
        else
            s->gesture = DRAGGING_POINTS;
    }
}

static void move(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    switch (s->gesture) {
    case IDLE:
        hover(e, event->position);
        kg_extent_drag_hover(e, event->position);
        break;
    case PRESSED:
        if (kg_dist2(event->position, s->pressed) >= KG_CLICK_DISTANCE * e->pane.scale)
            s->gesture = BOXING;
        break;
    case DRAGGING_POINTS:
        kg_point_drag_move(&s->drag, e, event->position, event->mods);
        break;
    case DRAGGING_EXTENT:
        kg_extent_drag_move(&s->extent, e, event->position, event->mods);
        break;
    case DRAGGING_CORNER:
        kg_corner_move(e, s->corner, event->position);
        break;
    case BOXING:
        break;
    }
}

static void release(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    bool toggle = event->mods & KG_MOD_SHIFT;
    gesture ended = s->gesture;
    s->gesture = IDLE;
    switch (ended) {
    case PRESSED:
        click(e, s, event->position, toggle);
        break;
    case BOXING:
        kg_select_in_box(e, s->pressed, event->position, toggle);
        break;
    case DRAGGING_POINTS:
    case DRAGGING_EXTENT:
    case DRAGGING_CORNER:
        kg_editor_commit(e);
        break;
    case IDLE:
        break;
    }
    hover(e, event->position);
}

/* The menu is about the patch under the pointer, or the selection it belongs to. */
static void choose_for_menu(kg_editor *e, const kg_event *event) {
    kg_hit hit;
    if (kg_editor_hits(e, event->position, &hit, 1) > 0 && !kg_editor_is_selected(e, hit.patch))
        kg_editor_select(e, hit.patch, false);
}

static bool key(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    kg_corner corner = s->gesture == IDLE && event->key == KG_KEY_BACKSPACE
                           ? kg_corner_under(e, e->pointer)
                           : (kg_corner){0};
    if (s->gesture == DRAGGING_POINTS && event->key >= 'X' && event->key <= 'Z') {
        kg_point_drag_lock(&s->drag, e, event->key - 'X');
        return true;
    }
    if (corner.patch) {
        kg_corner_remove(e, corner);
        return true;
    }
    if (event->key == KG_KEY_ESCAPE && s->gesture == IDLE && !e->message[0]) {
        kg_editor_select_none(e);
        return true;
    }
    if (event->key == KG_KEY_ESCAPE)
        e->message[0] = '\0';
    return s->gesture != IDLE && event->key != KG_KEY_ESCAPE; /* one thing at a time */
}

static bool on_event(kg_editor *e, const kg_event *event) {
    static const kg_gestures gestures = {press, move, release, choose_for_menu, key};
    const state *s = state_of(e);
    return s && kg_gestures_event(&gestures, e, event, s->gesture != IDLE);
}

/* With Shift, the patch that a click would make a cutter. */
static int64_t next_cutter(const kg_editor *e, const state *s) {
    return s->gesture == IDLE && e->mods & KG_MOD_SHIFT ? kg_cutter_hovered(e) : 0;
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    state *s = e->tool_state;
    kg_extent_drag_draw(e, overlay);
    kg_corners_draw(e, overlay);
    if (!s)
        return;
    if (s->gesture == DRAGGING_POINTS && s->drag.axis >= 0)
        kg_axis_draw(e, s->drag.start, s->drag.axis, overlay);
    if (s->gesture == DRAGGING_POINTS || s->gesture == DRAGGING_EXTENT)
        kg_legal_band_draw(e, overlay);
    kg_cutter_preview_draw(&s->cutters, e, next_cutter(e, s), overlay);
    if (!next_cutter(e, s))
        kg_seam_draw(e, overlay);
}

bool kg_select_box_now(const kg_editor *e, kg_vec2 *out_from) {
    const state *s = e->tool == &kg_tool_select ? e->tool_state : NULL;
    if (!s || s->gesture != BOXING)
        return false;
    *out_from = s->pressed;
    return true;
}

static const char *hint_now(const kg_editor *e) {
    const state *s = e->tool_state;
    if (s && s->gesture == DRAGGING_POINTS && s->drag.on_surface && s->drag.axis < 0 &&
        !(e->mods & KG_MOD_ALT))
        return _("The point slides on the reference   Alt: screen plane   X/Y/Z: axis   Ctrl: "
                 "steps   Shift: fine   Esc: back");
    if (s && s->gesture == DRAGGING_POINTS)
        return _("X/Y/Z: axis   Ctrl: steps   Shift: fine   Esc: back");
    if (s && s->gesture == DRAGGING_EXTENT)
        return _("Pink lines: no farther   Ctrl: steps   Shift: fine   Esc: back");
    if (s && s->gesture == BOXING)
        return kg_box_touches(s->pressed, e->pointer)
                   ? _("Selects what the box touches   Drawn to the right: what lies wholly in it")
                   : _("Selects what lies wholly in the box   Drawn to the left: what it touches");
    if (kg_editor_model(e)->patch_count == 0)
        return _("A: place a patch by four clicks   File > Reference…: a mesh to sculpt over");
    if (kg_corner_under(e, e->pointer).patch)
        return _(
            "Drag the corner of the contour   Backspace: remove it   Ctrl+click on an edge: one "
            "more");
    if (kg_extent_is_hovered(e))
        return _("Drag the handle: how far the patch goes to this side");
    if (s && next_cutter(e, s) && !kg_cutter_preview_meets(&s->cutters, next_cutter(e, s)))
        return _("This patch does not meet the red one, so it cannot trim it.");
    if (e->selection.patches.count > 1)
        return _(
            "T: the red patch is trimmed by the blue one   Shift+T: trim inside   Shift+click: "
            "more");
    return NULL;
}

const kg_tool kg_tool_select = {
    "select",
    N_("Select"),
    N_("Click: select   Shift+click: add   Drag a point: move it   Right drag: turn   Wheel: zoom  "
       " "
       "Ctrl+P: commands"),
    on_event,
    draw,
    hint_now,
    NULL,
};
