/*
 * Editing a pop-up card by mouse and keys: the voxel cursor, strokes of voxels, windows and tops,
 * boxes, and pulling whole faces. One gesture is one step.
 */
#include "app/modes/card_edit.h"
#include "app/modes/card_words.h"
#include "app/text.h"
#include "app/tools/tool.h"
#include "app/tools/voxel_aim.h"
#include "app/tools/voxel_draw.h"

#include <stdio.h>
#include <stdlib.h>

/* With a face seen head-on, moving the pointer by so many layout units pulls it by a voxel. */
enum { PULL_PIXELS = 12 };

/* Pixels between two places of a stroke where the paper is looked for. */
#define SAMPLE 3

typedef enum gesture { IDLE, STROKE, FACES, FILLING, SELECTING, PULLING } gesture;

typedef struct state {
    gesture gesture;
    kg_vec2 pressed, last; /* px */
    bool remove;           /* STROKE, FILLING: takes voxels away */
    bool top, on;          /* FACES: what is set, and how */
    bool level;            /* the plane of the gesture */
    bool flat;             /* no plane: the card is nearly flat or closed */
    double at;             /* of the plane */
    kg_spot start, now;    /* voxels at the press and at the pointer */
    kg_vec3 within;        /* of the press in its voxel, each in (0, 1) */
    kg_pulled pulled;
    kg_vec2 along; /* px: where the face goes for each voxel */
    int by;        /* voxels that it was pulled */
} state;

static state *state_of(kg_editor *e) {
    if (!e->tool_state)
        e->tool_state = calloc(1, sizeof(state));
    return e->tool_state;
}

/* ---- hovering --------------------------------------------------------------------------- */

static bool takes_away(const kg_editor *e, unsigned mods) {
    return (mods & KG_MOD_SHIFT) || kg_card_state_of(e)->brush == KG_BRUSH_REMOVE;
}

/* Whether the pointer means the voxel behind the paper. */
static bool means_filled(const kg_editor *e, unsigned mods) {
    return takes_away(e, mods) || kg_card_state_of(e)->brush != KG_BRUSH_ADD;
}

static void hover(kg_editor *e, kg_vec2 px, unsigned mods) {
    kg_card_state *s = kg_card_state_of(e);
    kg_oa_hit hit;
    kg_spot spot;
    s->hovering = kg_voxel_hit(e, px, &hit);
    if (s->hovering) {
        s->hover_x = hit.x;
        s->hover_row = hit.row;
    }
    s->hover_remark = s->hovering ? kg_card_remark_at(e, s->hover_x, s->hover_row) : -1;
    if (kg_voxel_under(e, px, means_filled(e, mods), &spot))
        kg_card_move_cursor(e, spot);
}

/* ---- strokes ---------------------------------------------------------------------------- */

/* A number of (0, 1), also where the paper lies exactly between two voxels. */
static double inside(double from_start) {
    return fmin(fmax(from_start, 1e-6), 1 - 1e-6);
}

/* Lays the plane of a gesture through the paper at the pointer. */
static void lay_plane(const kg_editor *e, state *s, kg_vec2 px) {
    kg_vec3 p;
    s->level = kg_card_state_of(e)->level;
    s->flat = true;
    if (kg_voxel_on_paper(e, px, &p)) {
        s->at = s->level ? p.z : p.y;
    } else {
        s->at = s->level ? s->start.z : s->start.y;
    }
    if (!kg_voxel_on_plane(e, px, s->level, s->at, &p))
        return;
    s->within = kg_v3(inside(p.x - s->start.x), inside(p.y - s->start.y), inside(p.z - s->start.z));
    kg_vec3 off = kg_sub(p, kg_add(kg_v3(s->start.x, s->start.y, s->start.z), s->within));
    /* a press beside its voxel, as on the far side of a sheet: the plane is of no use */
    s->flat = fabs(off.x) > 0.01 || (s->level ? fabs(off.y) : fabs(off.z)) > 0.01;
}

/* The voxel of the plane at the pointer. */
static bool spot_at(const kg_editor *e, const state *s, kg_vec2 px, kg_spot *out) {
    const kg_oa *oa = kg_editor_oa(e);
    kg_vec3 p;
    if (s->flat) {
        if (!kg_voxel_under(e, px, s->remove, out))
            return false;
    } else if (kg_voxel_on_plane(e, px, s->level, s->at, &p)) {
        double limit = 1e6; /* beyond every card, within int */
        *out = (kg_spot){(int)floor(fmin(fmax(p.x, -limit), limit)),
                         (int)floor(fmin(fmax(p.y, -limit), limit)),
                         (int)floor(fmin(fmax(p.z, -limit), limit))};
    } else {
        return false;
    }
    if (s->level)
        out->z = s->start.z;
    else
        out->y = s->start.y;
    out->x = out->x < 0 ? 0 : out->x >= oa->width ? oa->width - 1 : out->x;
    out->y = out->y < 0 ? 0 : out->y >= oa->depth_limit ? oa->depth_limit - 1 : out->y;
    out->z = out->z < 0 ? 0 : out->z >= oa->height ? oa->height - 1 : out->z;
    return true;
}

static int between(int a, int b, int i, int steps) {
    return steps > 0 ? a + (int)lround((double)(b - a) * i / steps) : b;
}

/* All voxels from the last one to the pointer's, so that a quick stroke has no gaps. */
static void stroke_to(kg_editor *e, state *s, kg_spot to) {
    kg_spot from = s->now;
    int steps = abs(to.x - from.x);
    steps = abs(to.y - from.y) > steps ? abs(to.y - from.y) : steps;
    steps = abs(to.z - from.z) > steps ? abs(to.z - from.z) : steps;
    for (int i = 0; i <= steps; i++) {
        kg_spot spot = {between(from.x, to.x, i, steps), between(from.y, to.y, i, steps),
                        between(from.z, to.z, i, steps)};
        kg_card_put(e, (kg_spots){spot, spot}, s->remove);
    }
    s->now = to;
}

/* Sets the faces of the brush's kind on the way of the pointer. */
static void faces_to(kg_editor *e, state *s, kg_vec2 px) {
    int steps = (int)fmin(ceil(kg_dist2(s->last, px) / SAMPLE), 500);
    for (int i = steps > 0; i <= steps; i++) {
        kg_oa_hit hit;
        kg_face face;
        kg_vec2 at = steps > 0 ? kg_lerp2(s->last, px, (double)i / steps) : px;
        if (kg_voxel_hit(e, at, &hit) && kg_card_face_at(e, hit.x, hit.row, &face) &&
            face.top == s->top)
            kg_card_set_face(e, face, s->on);
    }
}

/* ---- pulling ---------------------------------------------------------------------------- */

static kg_status start_pull(kg_editor *e, state *s, kg_error *error) {
    kg_oa_hit hit;
    if (!kg_voxel_hit(e, s->pressed, &hit))
        return kg_fail(error, KG_ERR_INPUT, "Pull at the paper.");
    kg_oa_voxel v = hit.voxel;
    kg_spot spot = {v.x, v.y < 0 ? 0 : v.y, v.z < 0 ? 0 : v.z};
    if (!kg_card_has(kg_editor_oa(e), spot))
        return kg_fail(error, KG_ERR_INPUT, "There is no block here.");
    kg_status status = kg_pulled_create(e, spot, v.top, &s->pulled, error);
    if (status)
        return status;
    kg_vec3 p = kg_v3(spot.x + 0.5, spot.y + 1, spot.z + 0.5), q = p;
    *(v.top ? &q.z : &q.y) += 1;
    kg_vec2 a, b;
    s->along = kg_v2(0, 0);
    if (kg_pane_project(&e->pane, kg_voxel_world(e, p), &a) &&
        kg_pane_project(&e->pane, kg_voxel_world(e, q), &b))
        s->along = kg_sub2(b, a);
    if (kg_len2(s->along) < 2 * e->pane.scale) /* head-on */
        s->along = kg_v2(0, (v.top ? -PULL_PIXELS : PULL_PIXELS) * e->pane.scale);
    s->by = 0;
    return kg_editor_begin(e, N_("Pull"), error);
}

static void pull_to(kg_editor *e, state *s, kg_vec2 px) {
    kg_vec2 way = kg_sub2(px, s->pressed);
    double limit = KG_OA_MAX_SIZE;
    double by = kg_dot2(way, s->along) / kg_dot2(s->along, s->along);
    s->by = (int)lround(fmin(fmax(by, -limit), limit));
    kg_card_pull(e, kg_document_oa(e->before), &s->pulled, s->pulled.at + s->by);
}

/* ---- gestures --------------------------------------------------------------------------- */

static void end_gesture(state *s) {
    kg_pulled_clear(&s->pulled);
    s->gesture = IDLE;
}

/* A window or top under the pointer: the stroke gives all the state that this one had not. */
static bool start_faces(const kg_editor *e, state *s, kg_vec2 px, bool top) {
    kg_oa_hit hit;
    kg_face face;
    if (!kg_voxel_hit(e, px, &hit) || !kg_card_face_at(e, hit.x, hit.row, &face) || face.top != top)
        return false;
    s->top = top;
    s->on = !kg_card_face_is_set(e, face);
    return true;
}

static kg_status start(kg_editor *e, state *s, const kg_event *event, kg_error *error) {
    kg_card_state *card = kg_card_state_of(e);
    kg_brush brush = card->brush;
    s->remove = takes_away(e, event->mods);
    bool filled = means_filled(e, event->mods);
    bool box = event->mods & (KG_MOD_CTRL | KG_MOD_ALT);
    s->pressed = s->last = event->position;
    if (!box && (brush == KG_BRUSH_WINDOW || brush == KG_BRUSH_TOP)) {
        if (!start_faces(e, s, event->position, brush == KG_BRUSH_TOP))
            return kg_fail(error, KG_ERR_INPUT, "%s",
                           brush == KG_BRUSH_TOP ? _("No top of a block is here.")
                                                 : _("No front of a block is here."));
        s->gesture = FACES;
        return kg_editor_begin(e, s->top ? N_("Leave out tops") : N_("Windows"), error);
    }
    if (!box && brush == KG_BRUSH_PULL && !(event->mods & KG_MOD_SHIFT)) {
        kg_status status = start_pull(e, s, error);
        s->gesture = status ? IDLE : PULLING;
        return status;
    }
    if (!kg_voxel_under(e, event->position, filled, &s->start)) {
        card->boxed = false;
        return KG_OK;
    }
    s->now = s->start;
    lay_plane(e, s, event->position);
    s->gesture = event->mods & KG_MOD_ALT ? SELECTING : box ? FILLING : STROKE;
    if (s->gesture == SELECTING)
        return KG_OK;
    card->boxed = false;
    return kg_editor_begin(e, s->remove ? N_("Remove voxels") : N_("Add voxels"), error);
}

static void press(kg_editor *e, state *s, const kg_event *event) {
    kg_error error;
    e->message[0] = '\0';
    kg_card_play(e, false);
    if (start(e, s, event, &error)) {
        kg_editor_say(e, KG_WARNING, "%s", error.message);
        end_gesture(s);
    } else if (s->gesture == STROKE) {
        kg_card_put(e, (kg_spots){s->start, s->start}, s->remove);
    } else if (s->gesture == FACES) {
        faces_to(e, s, event->position);
    }
}

static void move(kg_editor *e, state *s, const kg_event *event) {
    kg_card_state *card = kg_card_state_of(e);
    kg_spot to;
    if (!e->before && s->gesture != SELECTING) /* the step was ended elsewhere */
        end_gesture(s);
    switch (s->gesture) {
    case IDLE:
        hover(e, event->position, event->mods);
        break;
    case STROKE:
        if (spot_at(e, s, event->position, &to)) {
            stroke_to(e, s, to);
            card->cursor = to;
        }
        break;
    case FACES:
        faces_to(e, s, event->position);
        break;
    case FILLING:
    case SELECTING:
        if (spot_at(e, s, event->position, &to))
            card->cursor = s->now = to;
        break;
    case PULLING:
        pull_to(e, s, event->position);
        break;
    }
    s->last = event->position;
}

static void release(kg_editor *e, state *s, const kg_event *event) {
    kg_card_state *card = kg_card_state_of(e);
    if (s->gesture == FILLING && e->before) {
        kg_card_put(e, kg_spots_between(s->start, s->now), s->remove);
    } else if (s->gesture == SELECTING) {
        card->boxed = true;
        card->anchor = s->start;
        card->box = kg_spots_between(s->start, s->now);
    }
    end_gesture(s);
    kg_editor_commit(e);
    kg_editor_update(e);
    hover(e, event->position, event->mods);
}

/* ---- keys ------------------------------------------------------------------------------- */

/* Where a key moves the cursor; all zero: nowhere. */
static kg_spot step_of(const kg_editor *e, int key) {
    bool level = kg_card_state_of(e)->level;
    switch (key) {
    case KG_KEY_LEFT:
        return (kg_spot){-1, 0, 0};
    case KG_KEY_RIGHT:
        return (kg_spot){1, 0, 0};
    case KG_KEY_UP:
        return level ? (kg_spot){0, -1, 0} : (kg_spot){0, 0, 1};
    case KG_KEY_DOWN:
        return level ? (kg_spot){0, 1, 0} : (kg_spot){0, 0, -1};
    case KG_KEY_PAGE_UP:
        return level ? (kg_spot){0, 0, 1} : (kg_spot){0, -1, 0};
    case KG_KEY_PAGE_DOWN:
        return level ? (kg_spot){0, 0, -1} : (kg_spot){0, 1, 0};
    default:
        return (kg_spot){0, 0, 0};
    }
}

/* Shift takes the other corner of the selected box along. */
static bool move_cursor(kg_editor *e, const kg_event *event) {
    kg_card_state *s = kg_card_state_of(e);
    kg_spot by = step_of(e, event->key);
    bool extend = event->mods == KG_MOD_SHIFT;
    if ((event->mods && !extend) || (by.x == 0 && by.y == 0 && by.z == 0))
        return false;
    if (extend && !s->boxed)
        s->anchor = s->cursor;
    kg_card_move_cursor(e, (kg_spot){s->cursor.x + by.x, s->cursor.y + by.y, s->cursor.z + by.z});
    s->boxed = extend;
    s->box = kg_spots_between(s->anchor, s->cursor);
    s->hovering = false;
    s->hover_remark = -1;
    return true;
}

/* Ends the motion; else what is chosen; else the brush is the usual one again. */
static bool escape(kg_editor *e) {
    kg_card_state *s = kg_card_state_of(e);
    bool chosen = e->message[0] || s->boxed || s->shown_remark >= 0;
    if (s->painting_net) {
        kg_editor_cancel(e);
    } else if (s->playing) {
        kg_card_play(e, false);
    } else if (chosen) {
        e->message[0] = '\0';
        s->boxed = false;
        s->shown_remark = -1;
    } else {
        s->brush = KG_BRUSH_ADD;
    }
    return true;
}

static bool key(kg_editor *e, const state *s, const kg_event *event) {
    if (event->key == KG_KEY_ESCAPE && event->mods == 0 && s->gesture == IDLE)
        return escape(e);
    if (s->gesture != IDLE) /* one thing at a time */
        return event->key != KG_KEY_ESCAPE;
    return move_cursor(e, event);
}

static bool on_event(kg_editor *e, const kg_event *event) {
    state *s = state_of(e);
    if (!s)
        return false;
    switch (event->type) {
    case KG_EVENT_PRESS:
        if (event->button != KG_MOUSE_LEFT || s->gesture != IDLE)
            return false;
        press(e, s, event);
        return true;
    case KG_EVENT_MOVE:
        move(e, s, event);
        return true;
    case KG_EVENT_RELEASE:
        if (event->button == KG_MOUSE_RIGHT && s->gesture == IDLE) {
            e->request = KG_REQUEST_MENU;
            return true;
        }
        if (event->button != KG_MOUSE_LEFT || s->gesture == IDLE)
            return false;
        release(e, s, event);
        return true;
    case KG_EVENT_KEY:
        return key(e, s, event);
    default:
        return false;
    }
}

static void end(kg_editor *e) {
    kg_card_state *s = kg_card_state_of(e);
    if (s)
        s->painting_net = false;
    if (e->tool_state)
        end_gesture(e->tool_state);
}

/* ---- what it shows ---------------------------------------------------------------------- */

/* A box, and its mirror image while edits are symmetric. */
static void draw_box(const kg_editor *e, kg_overlay *o, kg_spots box, kg_voxel_look look) {
    int last = kg_editor_oa(e)->width - 1, lo = last - box.hi.x, hi = last - box.lo.x;
    kg_voxel_draw_box(e, o, &box, look);
    if (!kg_card_state_of(e)->symmetric || look == KG_VOXEL_SELECTED || lo == box.lo.x)
        return;
    box.lo.x = lo;
    box.hi.x = hi;
    kg_voxel_draw_box(e, o, &box, look);
}

static void draw(const kg_editor *e, kg_overlay *o) {
    const state *s = e->tool_state;
    const kg_card_state *card = kg_card_state_of(e);
    if (card->playing)
        return;
    bool filling = s && s->gesture == FILLING, selecting = s && s->gesture == SELECTING;
    bool remove = s && s->gesture != IDLE ? s->remove : takes_away(e, e->mods);
    kg_voxel_draw_plane(e, o);
    if (filling || selecting) {
        draw_box(e, o, kg_spots_between(s->start, s->now),
                 selecting   ? KG_VOXEL_SELECTED
                 : s->remove ? KG_VOXEL_REMOVED
                             : KG_VOXEL_ADDED);
        return;
    }
    if (card->boxed)
        draw_box(e, o, card->box, KG_VOXEL_SELECTED);
    draw_box(e, o, (kg_spots){card->cursor, card->cursor},
             remove ? KG_VOXEL_REMOVED : KG_VOXEL_ADDED);
}

static const char *hint_now(const kg_editor *e) {
    const state *s = e->tool_state;
    kg_card_state *card = kg_card_state_of(e);
    if (s && s->gesture == PULLING) {
        snprintf(card->hint, sizeof card->hint, _("%d voxels to %d   Esc: back"), s->by,
                 s->pulled.at + s->by);
        return card->hint;
    }
    if (s && s->gesture == FILLING) {
        snprintf(card->hint, sizeof card->hint, _("%d × %d × %d voxels   Esc: back"),
                 abs(s->now.x - s->start.x) + 1, abs(s->now.y - s->start.y) + 1,
                 abs(s->now.z - s->start.z) + 1);
        return card->hint;
    }
    return kg_card_hint(e);
}

const kg_tool kg_tool_voxel = {
    "voxel",
    N_("Voxels"),
    N_("Click: add   Shift+click: remove   Ctrl+drag: fill a box   arrows: cursor"),
    on_event,
    draw,
    hint_now,
    end,
};
