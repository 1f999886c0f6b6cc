/* Choosing what stays of a patch that a new trim cuts: the piece under the pointer lights up. */
#include "app/aim.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "app/tools/tool.h"
#include "app/tools/tools.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_HITS = 32 };

typedef struct state {
    int64_t patch;
    kg_hit under;  /* patch 0: none */
    bool face;     /* there are no pieces: a place on the rectangle is wanted */
    int64_t *rest; /* cutters whose turn comes after this trim */
    size_t rest_count;
} state;

static kg_trim_op *last_trim(const kg_editor *e, int64_t patch) {
    kg_model_patch *p = kg_model_find(kg_editor_model(e), patch);
    return p && p->trim_count > 0 ? &p->trims[p->trim_count - 1] : NULL;
}

static void hover(const kg_editor *e, state *s, kg_vec2 px) {
    kg_hit hits[MOST_HITS];
    size_t count = kg_editor_hits(e, px, hits, MOST_HITS);
    s->under.patch = 0;
    for (size_t i = 0; i < count && !s->under.patch; i++)
        if (hits[i].patch == s->patch)
            s->under = hits[i];
}

/* Notes the place clicked as one of what the trim keeps; the pieces stay visible until the end. */
static void keep(kg_editor *e, kg_trim_op *op, kg_vec3 place) {
    kg_vec3 *more = realloc(op->keep, (op->keep_count + 1) * sizeof *more);
    if (!more) {
        kg_editor_say(e, KG_FAULT, "%s", _("Out of memory."));
        return;
    }
    op->keep = more;
    op->keep[op->keep_count++] = place;
}

/* The trimmed patch stays selected, so that the next trim can name its cutter; where there are more
 * of them already, they trim it next. */
static void finish(kg_editor *e) {
    state *s = e->tool_state;
    int64_t patch = s->patch, *rest = s->rest;
    size_t count = s->rest_count;
    s->rest = NULL;
    kg_editor_touch(e);
    kg_editor_commit(e);
    kg_editor_use_default(e);
    kg_editor_select(e, patch, false);
    for (size_t i = 0; i < count; i++)
        kg_editor_select(e, rest[i], true);
    free(rest);
    if (count == 0)
        return;
    kg_command_do(e, "trim.by");
    if (e->tool != &kg_tool_pieces) /* the rest cut nothing */
        kg_editor_select(e, patch, false);
}

static void end(kg_editor *e) {
    state *s = e->tool_state;
    free(s->rest);
}

/* ---- a face among several ----------------------------------------------------------------- */

static bool has_fault(const kg_editor *e, int64_t patch) {
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), patch);
    return !s || !s->valid;
}

/* Names the face under the pointer; where there is none nothing is named. */
static void choose_face(kg_editor *e, const state *s, kg_trim_op *op, kg_vec2 px) {
    const kg_solved_patch *solved = kg_solution_find(kg_editor_solution(e), s->patch);
    kg_vec3 origin, direction;
    kg_vec2 uv;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    if (!solved || !solved->prepared || !kg_patch_aim(&solved->patch, origin, direction, &uv))
        return;
    keep(e, op, kg_patch_point(&solved->patch, uv.x, uv.y));
    kg_editor_touch(e);
    kg_editor_update(e);
    if (has_fault(e, s->patch)) {
        op->keep_count--;
        kg_editor_say(e, KG_FAULT, "%s", _("That is no face that all the cutters border."));
        kg_editor_touch(e);
        return;
    }
    finish(e);
}

/* ---- events ----------------------------------------------------------------------------- */

static bool on_event(kg_editor *e, const kg_event *event) {
    state *s = e->tool_state;
    kg_trim_op *op = last_trim(e, s->patch);
    switch (event->type) {
    case KG_EVENT_MOVE:
        hover(e, s, event->position);
        return true;
    case KG_EVENT_PRESS:
        if (event->button != KG_MOUSE_LEFT)
            return false;
        if (s->face && op) {
            choose_face(e, s, op, event->position);
            return true;
        }
        hover(e, s, event->position);
        if (!s->under.patch || !op)
            return true;
        keep(e, op, s->under.point);
        if (!(event->mods & KG_MOD_SHIFT))
            finish(e);
        return true;
    case KG_EVENT_KEY:
        if (event->key == KG_KEY_ESCAPE) {
            kg_editor_use_default(e); /* which takes the trim back */
            return true;
        }
        if (!s->face && (event->key == KG_KEY_ENTER || event->key == KG_KEY_PAD_ENTER)) {
            finish(e);
            return true;
        }
        return false;
    default:
        return false;
    }
}

/* A little before the patch, of the distance to the eye: both have the same depth. */
#define IN_FRONT 2e-3

static void draw_piece(const kg_tessellation *piece, const kg_camera *camera, kg_color color,
                       kg_overlay *o) {
    kg_vec3 right, up, back;
    kg_camera_axes(camera, &right, &up, &back);
    kg_surface s = {.vertex_count = piece->vertex_count,
                    .triangle_count = piece->triangle_count,
                    .triangles = piece->triangles};
    kg_style style = kg_style_default(color);
    style.back = color;
    s.positions = calloc(piece->vertex_count + 1, sizeof *s.positions);
    s.normals = calloc(piece->vertex_count + 1, sizeof *s.normals);
    for (size_t i = 0; s.positions && s.normals && i < piece->vertex_count; i++) {
        s.positions[i] = kg_madd(piece->vertices[i].position, IN_FRONT * camera->distance, back);
        s.normals[i] = piece->vertices[i].normal;
    }
    if (s.positions && s.normals)
        kg_overlay_surface(o, &s, style);
    free(s.positions);
    free(s.normals);
}

static void draw(const kg_editor *e, kg_overlay *overlay) {
    const state *s = e->tool_state;
    const kg_patch_surface *surface = kg_surfaces_find(&e->surfaces, s->patch);
    const kg_trim_op *op = last_trim(e, s->patch);
    if (surface && s->under.patch && s->under.piece < surface->piece_count)
        draw_piece(&surface->pieces[s->under.piece], &e->pane.camera, (kg_color){1, 0.85F, 0.2F, 1},
                   overlay);
    if (op) {
        kg_style dot = kg_style_default((kg_color){1, 1, 1, 1});
        dot.size_px = 10;
        dot.hidden = 0.6F;
        kg_overlay_points(overlay, op->keep, op->keep_count, dot);
    }
}

static kg_status start(kg_editor *e, int64_t patch, bool face, const int64_t *rest, size_t count,
                       kg_error *error) {
    state *s = calloc(1, sizeof *s);
    if (s && count > 0 && (s->rest = calloc(count, sizeof *s->rest))) {
        memcpy(s->rest, rest, count * sizeof *rest);
        s->rest_count = count;
    }
    if (!s || s->rest_count < count) {
        free(s);
        kg_editor_cancel(e);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    s->patch = patch;
    s->face = face;
    /* the tool before ends without taking back the step that is open for this one */
    kg_document *before = e->before;
    e->before = NULL;
    kg_editor_use(e, &kg_tool_pieces, s);
    e->before = before;
    hover(e, s, e->pointer);
    return KG_OK;
}

kg_status kg_tool_start_pieces(kg_editor *e, int64_t patch, const int64_t *rest, size_t count,
                               kg_error *error) {
    return start(e, patch, false, rest, count, error);
}

kg_status kg_tool_start_face(kg_editor *e, int64_t patch, kg_error *error) {
    return start(e, patch, true, NULL, 0, error);
}

static const char *hint_now(const kg_editor *e) {
    const state *s = e->tool_state;
    return s->face ? _("Several faces border all the cutters: click the one that stays   Esc: no "
                       "trim")
                   : NULL;
}

const kg_tool kg_tool_pieces = {
    "pieces",
    N_("Choose what stays"),
    N_("Click the piece that stays   Shift+click: several   Enter: all pieces   Esc: no trim"),
    on_event,
    draw,
    hint_now,
    end,
};
