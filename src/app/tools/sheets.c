/* Arranging sheets before the first fold: a drag moves one, its ring turns it. */
#include "app/modes/sheet_edit.h"
#include "app/modes/sheet_pick.h"
#include "app/scenery.h"
#include "app/text.h"
#include "app/tools/gesture.h"
#include "app/tools/tool.h"

#include <stdlib.h>

/* Layout units. */
enum { GRAB_DISTANCE = 8 };
enum { RING_POINTS = 65 };

/* Ring over the farthest corner; steps of Ctrl, mm and degrees; degrees within which a sheet comes
 * to rest at such a step. */
#define RING 1.15
#define STEP_MM 5
#define STEP_DEG 15
#define REST_DEG 2

typedef enum gesture { IDLE, MOVING, TURNING } gesture;

typedef struct state {
    gesture gesture;
    kg_vec2 pressed; /* in the plane of the sheets */
} state;

static state *state_of(kg_editor *e) {
    if (!e->tool_state)
        e->tool_state = calloc(1, sizeof(state));
    return e->tool_state;
}

/* The selected sheet; NULL: none, or it stays where it is. */
static const kg_paper_sheet *selected(const kg_editor *e) {
    const kg_origami *o = kg_editor_origami(e);
    int32_t sheet = kg_sheets_of(e)->sheet;
    return sheet >= 0 && (size_t)sheet < kg_origami_sheet_count(o) && !kg_sheets_why_fixed(e)
               ? kg_origami_sheet(o, (size_t)sheet)
               : NULL;
}

/* As it lay when the gesture began. */
static const kg_paper_sheet *selected_before(const kg_editor *e) {
    return kg_origami_sheet(kg_document_origami(e->before), (size_t)kg_sheets_of(e)->sheet);
}

static bool in_plane(const kg_editor *e, kg_vec2 px, kg_vec2 *out) {
    kg_vec3 p;
    if (!kg_pane_on_plane(&e->pane, px, kg_v3(0, 0, 0), kg_v3(0, 0, 1), &p))
        return false;
    *out = kg_v2(p.x, p.y);
    return true;
}

/* ---- the ring ---------------------------------------------------------------------------- */

static void ring_of(const kg_paper_sheet *sheet, kg_vec3 out[RING_POINTS]) {
    kg_vec2 middle = kg_sheet_middle(sheet);
    double radius = 0;
    for (size_t i = 0; i < sheet->count; i++)
        radius = fmax(radius, RING * kg_dist2(sheet->polygon[i], middle));
    for (int i = 0; i < RING_POINTS; i++) {
        double turn = 2 * KG_PI * i / (RING_POINTS - 1);
        out[i] = kg_v3(middle.x + radius * cos(turn), middle.y + radius * sin(turn), 0);
    }
}

static bool on_ring(const kg_editor *e, kg_vec2 px) {
    const kg_paper_sheet *sheet = selected(e);
    kg_vec3 ring[RING_POINTS];
    kg_vec2 a, b;
    if (!sheet)
        return false;
    ring_of(sheet, ring);
    for (int i = 0; i + 1 < RING_POINTS; i++) {
        if (!kg_pane_project(&e->pane, ring[i], &a) || !kg_pane_project(&e->pane, ring[i + 1], &b))
            continue;
        if (kg_segment_distance(px, a, b, NULL) < GRAB_DISTANCE * e->pane.scale)
            return true;
    }
    return false;
}

/* ---- snapping ---------------------------------------------------------------------------- */

/* What moves a corner at `p` to a place of another sheet: its corners first, then its sides. */
static kg_vec2 pull_of(const kg_paper_sheet *other, kg_vec2 p, double reach, double *best) {
    kg_vec2 pull = kg_v2(0, 0);
    for (size_t i = 0; i < other->count; i++) {
        kg_vec2 a = other->polygon[i], b = other->polygon[(i + 1) % other->count];
        double t, distance = kg_segment_distance(p, a, b, &t);
        if (kg_dist2(p, a) < fmin(reach, *best)) {
            *best = kg_dist2(p, a);
            pull = kg_sub2(a, p);
        }
        if (reach + distance < *best) { /* worse than any corner */
            *best = reach + distance;
            pull = kg_sub2(kg_lerp2(a, b, t), p);
        }
    }
    return pull;
}

static kg_vec2 snap(const kg_editor *e, kg_vec2 by) {
    const kg_origami *o = kg_editor_origami(e);
    const kg_paper_sheet *sheet = selected_before(e);
    kg_vec2 middle = kg_sheet_middle(sheet), pull = kg_v2(0, 0);
    double reach = GRAB_DISTANCE * e->pane.scale *
                   kg_pane_pixel_mm(&e->pane, kg_v3(middle.x + by.x, middle.y + by.y, 0));
    double best = 2 * reach;
    for (size_t i = 0; i < kg_origami_sheet_count(o); i++) {
        if ((int32_t)i == kg_sheets_of(e)->sheet)
            continue;
        for (size_t k = 0; k < sheet->count; k++) {
            double before = best;
            kg_vec2 found =
                pull_of(kg_origami_sheet(o, i), kg_add2(sheet->polygon[k], by), reach, &best);
            if (best < before)
                pull = found;
        }
    }
    return kg_add2(by, pull);
}

/* ---- gestures ---------------------------------------------------------------------------- */

static void press(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    kg_sheets *sheets = kg_sheets_of(e);
    kg_sheet_hit hit;
    kg_error error;
    const char *fixed = kg_sheets_why_fixed(e);
    bool turns = on_ring(e, event->position);
    if (!turns)
        sheets->sheet = kg_sheets_hit(e, event->position, &hit, 1) > 0
                            ? sheets->state->loops.items[hit.loop].sheet
                            : -1;
    if (fixed)
        kg_editor_say(e, KG_WARNING, "%s", fixed);
    if (!selected(e) || !in_plane(e, event->position, &s->pressed))
        return;
    if (kg_editor_begin(e, turns ? N_("Turn sheet") : N_("Move sheet"), &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
    else
        s->gesture = turns ? TURNING : MOVING;
}

static kg_vec2 movement(const kg_editor *e, const state *s, kg_vec2 at, unsigned mods) {
    kg_vec2 by = kg_sub2(at, s->pressed);
    if (mods & KG_MOD_CTRL)
        return kg_v2(STEP_MM * round(by.x / STEP_MM), STEP_MM * round(by.y / STEP_MM));
    return mods & KG_MOD_ALT ? by : snap(e, by);
}

/* Radians. */
static double turning(const kg_editor *e, const state *s, kg_vec2 at, unsigned mods) {
    const kg_paper_sheet *sheet = selected_before(e);
    kg_vec2 middle = kg_sheet_middle(sheet), a = kg_sub2(s->pressed, middle),
            b = kg_sub2(at, middle), side = kg_sub2(sheet->polygon[1], sheet->polygon[0]);
    double turn = atan2(kg_cross2(a, b), kg_dot2(a, b)), first = atan2(side.y, side.x);
    double degrees = (first + turn) * 180 / KG_PI, rest = STEP_DEG * round(degrees / STEP_DEG);
    bool rests = mods & KG_MOD_CTRL || (!(mods & KG_MOD_ALT) && fabs(degrees - rest) < REST_DEG);
    return rests ? rest * KG_PI / 180 - first : turn;
}

static void move(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    kg_vec2 at;
    kg_error error;
    if (s->gesture == IDLE || !e->before || !in_plane(e, event->position, &at))
        return;
    const kg_paper_sheet *from = selected_before(e);
    kg_vec2 by = s->gesture == MOVING ? movement(e, s, at, event->mods) : kg_v2(0, 0);
    double angle = s->gesture == TURNING ? turning(e, s, at, event->mods) : 0;
    if (kg_sheets_place(e, (size_t)kg_sheets_of(e)->sheet, from, kg_sheet_middle(from), angle, by,
                        &error))
        kg_editor_say(e, KG_FAULT, "%s", error.message);
}

static void release(kg_editor *e, const kg_event *event) {
    (void)event;
    state *s = e->tool_state;
    s->gesture = IDLE;
    kg_editor_commit(e);
}

static bool key(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    bool busy = s->gesture != IDLE; /* one thing at a time */
    if (busy && event->key == KG_KEY_ESCAPE) {
        s->gesture = IDLE;
        kg_editor_cancel(e);
    }
    return busy;
}

static bool on_event(kg_editor *e, const kg_event *event) {
    static const kg_gestures gestures = {press, move, release, NULL, key};
    const state *s = state_of(e);
    return s && kg_gestures_event(&gestures, e, event, s->gesture != IDLE);
}

static void draw(const kg_editor *e, kg_overlay *o) {
    const kg_paper_sheet *sheet = selected(e);
    kg_vec3 ring[RING_POINTS];
    if (!sheet)
        return;
    ring_of(sheet, ring);
    kg_style style = kg_line_style((kg_color){0.1F, 0.45F, 0.9F, 1}, 2.5F);
    style.hidden = 0.5F;
    kg_overlay_line(o, ring, RING_POINTS, style);
    for (size_t i = 0; i < sheet->count; i++) {
        kg_vec2 a = sheet->polygon[i], b = sheet->polygon[(i + 1) % sheet->count];
        kg_overlay_line(o, (kg_vec3[]){{a.x, a.y, 0}, {b.x, b.y, 0}}, 2, style);
    }
}

const kg_tool kg_tool_sheets = {
    .id = "sheets",
    .title = N_("Arrange sheets"),
    .hint = N_("Drag a sheet: move it   Drag the ring: turn it   Ctrl: steps   Alt: free   Esc: "
               "fold"),
    .event = on_event,
    .draw = draw,
};
