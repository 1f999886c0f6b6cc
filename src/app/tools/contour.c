/* Drawing a contour or a hole on a patch by clicks. */
#include "app/aim.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"
#include "base/array.h"

#include <stdlib.h>

enum { EDGE_SAMPLES = 12 };

typedef struct state {
    int64_t patch;
    struct {
        kg_vec2 *items;
        size_t count, capacity;
    } corners; /* (u, v) */
    kg_vec2 under;
    bool aimed;
} state;

/* The place on the patch's rectangle, in (u, v), under the pixel or nearest to it. */
static bool aim(const kg_editor *e, const state *s, kg_vec2 px, kg_vec2 *out) {
    const kg_solved_patch *solved = kg_solution_find(kg_editor_solution(e), s->patch);
    return solved && solved->prepared && kg_patch_aim_px(&solved->patch, &e->pane, px, out);
}

/* Places beside a patch may all be nearest to one of its corners. */
static bool is_last(const state *s, kg_vec2 at) {
    if (s->corners.count == 0)
        return false;
    kg_vec2 last = s->corners.items[s->corners.count - 1];
    return last.x == at.x && last.y == at.y;
}

static void finish(kg_editor *e, bool outside) {
    state *s = e->tool_state;
    json_t *corners = json_array();
    for (size_t i = 0; i < s->corners.count; i++)
        json_array_append_new(corners,
                              json_pack("[ff]", s->corners.items[i].x, s->corners.items[i].y));
    /* a contour that cannot be stays to be mended */
    if (kg_command_do_with(e, "trim.contour",
                           json_pack("{s:I,s:o,s:s}", "patch", (json_int_t)s->patch, "contour",
                                     corners, "keep", outside ? "outside" : "inside")))
        kg_editor_use_default(e);
}

static bool on_key(kg_editor *e, state *s, const kg_event *event) {
    switch (event->key) {
    case KG_KEY_BACKSPACE:
        s->corners.count -= s->corners.count > 0;
        return true;
    case KG_KEY_ESCAPE:
        kg_editor_use_default(e);
        return true;
    case KG_KEY_ENTER:
    case KG_KEY_PAD_ENTER:
        finish(e, event->mods & KG_MOD_SHIFT);
        return true;
    default:
        return false;
    }
}

static bool on_event(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    kg_vec2 at;
    switch (event->type) {
    case KG_EVENT_MOVE:
        s->aimed = aim(e, s, event->position, &s->under);
        return true;
    case KG_EVENT_PRESS:
        if (event->button != KG_MOUSE_LEFT)
            return false;
        if (aim(e, s, event->position, &at) && !is_last(s, at) && !kg_push(&s->corners, at))
            kg_editor_say(e, KG_FAULT, "%s", _("Out of memory."));
        s->aimed = false;
        return true;
    case KG_EVENT_KEY:
        return on_key(e, s, event);
    default:
        return false;
    }
}

/* A straight line in (u, v) is a curve in space. */
static void draw_edge(const kg_patch *patch, kg_vec2 a, kg_vec2 b, kg_style style, kg_overlay *o) {
    kg_vec3 points[EDGE_SAMPLES];
    for (int i = 0; i < EDGE_SAMPLES; i++) {
        kg_vec2 at = kg_lerp2(a, b, (double)i / (EDGE_SAMPLES - 1));
        points[i] = kg_patch_point(patch, at.x, at.y);
    }
    kg_overlay_line(o, points, EDGE_SAMPLES, style);
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    const state *s = e->tool_state;
    const kg_solved_patch *solved = kg_solution_find(kg_editor_solution(e), s->patch);
    if (!solved || !solved->prepared)
        return;
    kg_style line = kg_style_default((kg_color){1, 0.85F, 0.2F, 1}), dashed = line, dot = line;
    line.size_px = dashed.size_px = 2;
    dot.size_px = 8;
    line.hidden = dashed.hidden = dot.hidden = 0.5F;
    dashed.dashes_px[0] = dashed.dashes_px[2] = 5;
    dashed.dashes_px[1] = dashed.dashes_px[3] = 4;
    size_t count = s->corners.count;
    for (size_t i = 0; i < count; i++) {
        kg_vec2 at = s->corners.items[i];
        kg_vec3 point = kg_patch_point(&solved->patch, at.x, at.y);
        kg_overlay_points(overlay, &point, 1, dot);
        if (i > 0)
            draw_edge(&solved->patch, s->corners.items[i - 1], at, line, overlay);
    }
    if (count > 0 && s->aimed) {
        draw_edge(&solved->patch, s->corners.items[count - 1], s->under, line, overlay);
        draw_edge(&solved->patch, s->under, s->corners.items[0], dashed, overlay);
    } else if (count > 2) {
        draw_edge(&solved->patch, s->corners.items[count - 1], s->corners.items[0], dashed,
                  overlay);
    }
}

static void end(kg_editor *e) {
    state *s = e->tool_state;
    free(s->corners.items);
}

kg_status kg_tool_start_contour(kg_editor *e, int64_t patch, kg_error *error) {
    state *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    s->patch = patch;
    kg_editor_use(e, &kg_tool_contour, s);
    return KG_OK;
}

const kg_tool kg_tool_contour = {
    "contour",
    N_("Draw contour"),
    N_("Click corners on the patch   Enter: keep the inside   Shift+Enter: cut a hole   "
       "Backspace: drop the last"),
    on_event,
    draw,
    NULL,
    end,
};
