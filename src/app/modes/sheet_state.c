#include "app/modes/sheet_state.h"

#include "app/modes/sheet_thumbs.h"
#include "app/text.h"
#include "base/array.h"
#include "origami/state.h"

#include <assert.h>
#include <stdlib.h>

/* Between layers, over the size of the sheets: as thin as can be told apart, and spread wide. */
#define LAYER 0.0025
#define SPREAD_LAYER 0.08
/* How far below flat sheets the ground lies, over their size; nearer, its grid shines through. */
#define GROUND 0.02
/* s, of one fold played, and of one just made, which nobody wants to wait for. */
#define FOLD_SECONDS 1.0
#define MADE_SECONDS 0.4

kg_sheets *kg_sheets_of(const kg_editor *e) {
    assert(kg_editor_is(e, KG_DOCUMENT_ORIGAMI));
    return e->mode_state;
}

static kg_vec2 paper_at(const kg_origami_state *s, int32_t half) {
    return s->vertices.items[s->halves.items[half].origin].paper;
}

/* ---- heights ----------------------------------------------------------------------------- */

/* Heights of all half-edges towards the fronts of their loops; malloc's, NULL without memory. */
static double *front_heights(const kg_origami_state *s) {
    double *heights = calloc(s->halves.count + 1, sizeof *heights);
    kg_error error;
    if (heights && kg_origami_heights(s, heights, &error)) {
        free(heights);
        return NULL;
    }
    for (size_t h = 0; heights && h < s->halves.count; h++) {
        int32_t loop = s->halves.items[h].loop;
        if (loop >= 0 && kg_dot(kg_origami_normal(s, loop),
                                s->groups.items[s->loops.items[loop].group].normal) < 0)
            heights[h] = -heights[h];
    }
    return heights;
}

/* The height of a loop at a point of its outline. */
static double height_at(const kg_origami_state *s, const double *heights, int32_t loop, kg_vec2 p) {
    int32_t first = s->loops.items[loop].first, h = first;
    double best = INFINITY, height = 0;
    do {
        int32_t next = kg_next(s, h);
        double t, distance = kg_segment_distance(p, paper_at(s, h), paper_at(s, next), &t);
        if (distance < best) {
            best = distance;
            height = heights[h] + t * (heights[next] - heights[h]);
        }
        h = next;
    } while (h != first);
    return height;
}

/* Heights of the parts of `after` before the fold, `own` being those of `before`. */
static double *heights_before(const kg_origami_state *before, const double *own,
                              const kg_origami_state *after) {
    double *heights = calloc(after->halves.count + 1, sizeof *heights);
    for (int32_t i = 0; heights && (size_t)i < after->loops.count; i++) {
        int32_t whole = kg_loop_in(before, after, i), first = after->loops.items[i].first,
                h = first;
        do {
            heights[h] = height_at(before, own, whole, paper_at(after, h));
        } while ((h = kg_next(after, h)) != first);
    }
    return heights;
}

/* ---- drawn positions --------------------------------------------------------------------- */

static void clear_drawn(kg_sheets *s) {
    free(s->positions);
    free(s->normals);
    free(s->drawn);
    free(s->heights);
    s->positions = s->normals = s->drawn = NULL;
    s->heights = NULL;
    s->state = NULL;
}

/* Newell's normal of a loop whose vertices lie at `positions`. */
static kg_vec3 loop_normal(const kg_origami_state *s, const kg_vec3 *positions, int32_t loop) {
    int32_t first = s->loops.items[loop].first, h = first;
    kg_vec3 o = positions[s->halves.items[first].origin], sum = kg_v3(0, 0, 0);
    do {
        int32_t next = kg_next(s, h);
        sum = kg_add(sum, kg_cross(kg_sub(positions[s->halves.items[h].origin], o),
                                   kg_sub(positions[s->halves.items[next].origin], o)));
        h = next;
    } while (h != first);
    return kg_unit(sum);
}

static void place_corners(kg_sheets *s) {
    const kg_origami_state *state = s->state;
    s->layer = state->size * (LAYER + s->spread * s->spread * SPREAD_LAYER);
    for (size_t h = 0; h < state->halves.count; h++) {
        const kg_half_edge *half = &state->halves.items[h];
        s->drawn[h] = s->positions[half->origin];
        if (half->loop >= 0)
            s->drawn[h] = kg_madd(s->drawn[h], s->layer * s->heights[h], s->normals[half->loop]);
    }
    s->revision++;
}

/* Heights of the fold under way go over from those before it to those after it, in the frame of
 * each loop, so that nothing jumps at either end. */
static bool mix_heights(kg_sheets *s) {
    if (s->fraction <= 0)
        return true;
    const kg_origami_state *before = kg_origami_state_at(s->origami, s->step);
    double *own = front_heights(before), *from = own ? heights_before(before, own, s->state) : NULL;
    for (size_t h = 0; from && h < s->state->halves.count; h++)
        s->heights[h] = from[h] + s->fraction * (s->heights[h] - from[h]);
    free(own);
    free(from);
    return from != NULL;
}

/* Everything that follows from what is shown. */
static void lay_out(kg_sheets *s) {
    const kg_origami_state *was = s->state;
    size_t shown = s->step + (s->fraction > 0);
    clear_drawn(s);
    const kg_origami_state *state = kg_origami_state_at(s->origami, shown);
    s->positions = calloc(state->vertices.count + 1, sizeof *s->positions);
    s->normals = calloc(state->loops.count + 1, sizeof *s->normals);
    s->drawn = calloc(state->halves.count + 1, sizeof *s->drawn);
    s->heights = front_heights(state);
    s->state = state;
    if (!s->positions || !s->normals || !s->drawn || !s->heights || !mix_heights(s)) {
        clear_drawn(s);
        s->revision++;
        return;
    }
    for (size_t i = 0; i < state->vertices.count; i++)
        s->positions[i] = state->vertices.items[i].position;
    if (s->fraction > 0)
        kg_origami_between(s->origami, s->step, s->fraction, s->positions);
    for (size_t i = 0; i < state->loops.count; i++)
        s->normals[i] = loop_normal(state, s->positions, (int32_t)i);
    place_corners(s);
    if (state != was) {
        s->topology++;
        s->loops.count = s->edges.count = s->vertices.count = 0;
        s->hover_loop = s->hover_edge = s->hover_vertex = -1;
    }
}

void kg_sheets_relayer(kg_editor *e) {
    kg_sheets *s = kg_sheets_of(e);
    if (s->state)
        place_corners(s);
}

/* ---- what is shown ----------------------------------------------------------------------- */

static void show(kg_sheets *s, double folds) {
    double most = (double)kg_origami_fold_count(s->origami);
    folds = folds > 0 ? fmin(folds, most) : 0;
    size_t step = (size_t)folds;
    double fraction = folds - (double)step;
    if (step == s->step && fraction == s->fraction && s->state)
        return;
    s->step = step;
    s->fraction = fraction;
    lay_out(s);
}

double kg_sheets_shown(const kg_sheets *s) {
    return (double)s->step + s->fraction;
}

void kg_sheets_show(kg_editor *e, double folds) {
    kg_sheets_stop(e);
    show(kg_sheets_of(e), folds);
}

static void play(kg_sheets *s, double from, double to, double pace) {
    show(s, from);
    s->pace = pace;
    s->target = fmin(to, (double)kg_origami_fold_count(s->origami));
    s->playing = kg_sheets_shown(s) < s->target;
    /* goes on where the eased fold stands */
    s->played = pace * acos(1 - 2 * s->fraction) / KG_PI;
}

void kg_sheets_play(kg_editor *e, double from, double to) {
    play(kg_sheets_of(e), from, to, FOLD_SECONDS);
}

void kg_sheets_play_made(kg_editor *e) {
    double n = (double)kg_origami_step(kg_sheets_of(e)->origami);
    if (n > 0)
        play(kg_sheets_of(e), n - 1, n, MADE_SECONDS);
}

void kg_sheets_stop(kg_editor *e) {
    kg_sheets_of(e)->playing = false;
}

void kg_sheets_skip(kg_editor *e) {
    kg_sheets *s = kg_sheets_of(e);
    if (s->playing)
        kg_sheets_show(e, s->target);
}

bool kg_sheets_tick(kg_editor *e, double seconds) {
    kg_sheets *s = kg_sheets_of(e);
    if (!s->playing)
        return false;
    s->played += seconds;
    size_t whole = (size_t)fmin(s->played / s->pace, s->target); /* long ticks are many folds */
    size_t step = s->step + whole;
    s->played -= (double)whole * s->pace;
    double folds = (double)step + (1 - cos(KG_PI * s->played / s->pace)) / 2;
    s->playing = folds < s->target;
    show(s, fmin(folds, s->target));
    return true;
}

const char *kg_sheets_why_not(const kg_editor *e) {
    const kg_sheets *s = kg_sheets_of(e);
    if (!s->state)
        return _("Out of memory.");
    if (s->playing || s->fraction > 0)
        return _("A fold is under way.");
    if (s->step != kg_origami_step(s->origami))
        return _("An earlier or later step is shown: fold from here first.");
    return NULL;
}

bool kg_sheets_can_fold(const kg_editor *e) {
    return !kg_sheets_why_not(e);
}

kg_status kg_sheets_fold_from_here(kg_editor *e, kg_error *error) {
    kg_sheets *s = kg_sheets_of(e);
    size_t step = s->step;
    kg_sheets_show(e, (double)step);
    kg_status status = kg_editor_begin(e, N_("Fold from here"), error);
    if (status)
        return status;
    kg_origami *o = kg_editor_origami(e);
    while (kg_origami_step(o) > step && kg_origami_undo(o))
        continue;
    while (kg_origami_step(o) < step && kg_origami_redo(o))
        continue;
    kg_editor_touch(e);
    kg_editor_commit(e);
    kg_editor_update(e);
    return KG_OK;
}

bool kg_sheets_snapshot(const kg_sheets *s, size_t step, kg_sheets *out) {
    *out = (kg_sheets){.origami = s->origami, .step = step, .opacity = 1};
    out->hover_loop = out->hover_edge = out->hover_vertex = -1;
    lay_out(out);
    return out->state != NULL;
}

void kg_sheets_snapshot_clear(kg_sheets *snapshot) {
    clear_drawn(snapshot);
}

/* ---- marks ------------------------------------------------------------------------------- */

void kg_sheets_unmark(kg_editor *e) {
    kg_sheets *s = kg_sheets_of(e);
    s->loops.count = s->edges.count = s->vertices.count = 0;
    s->hover_loop = s->hover_edge = s->hover_vertex = -1;
}

bool kg_sheets_is_marked(const kg_sheet_marks *marks, int32_t index) {
    for (size_t i = 0; i < marks->count; i++)
        if (marks->items[i] == index)
            return true;
    return false;
}

/* ---- life -------------------------------------------------------------------------------- */

kg_status kg_sheets_create(const kg_document *document, void **out_state, kg_error *error) {
    kg_sheets *s = calloc(1, sizeof *s);
    (void)document; /* kg_sheets_follow comes before anything is shown */
    if (!s || !(s->origami = kg_origami_create())) {
        free(s);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    s->opacity = 1;
    s->next_sheet = (kg_sheet_size){KG_SHEET_SQUARE, 150, 150, 6};
    s->hover_loop = s->hover_edge = s->hover_vertex = s->sheet = -1;
    *out_state = s;
    return KG_OK;
}

void kg_sheets_destroy(void *state) {
    kg_sheets *s = state;
    clear_drawn(s);
    kg_sheet_thumbs_destroy(s->thumbs);
    kg_origami_destroy(s->origami);
    free(s->loops.items);
    free(s->edges.items);
    free(s->vertices.items);
    free(s);
}

/* Whether two hold the same states in the same order, as far as both are done. States are shared
 * by copies, so another state is another address. */
static bool same_states(const kg_origami *a, const kg_origami *b) {
    if (kg_origami_step(a) != kg_origami_step(b))
        return false;
    for (size_t i = 0; i <= kg_origami_step(a); i++)
        if (kg_origami_state_at(a, i) != kg_origami_state_at(b, i))
            return false;
    return true;
}

void kg_sheets_follow(kg_editor *e) {
    kg_sheets *s = kg_sheets_of(e);
    kg_origami *copy = kg_origami_copy(kg_editor_origami(e));
    if (!copy) {
        kg_editor_say(e, KG_FAULT, "%s", _("Out of memory: the sheets are shown as they were."));
        return;
    }
    bool same =
        same_states(copy, s->origami) && kg_sheets_shown(s) <= (double)kg_origami_fold_count(copy);
    kg_origami *was = s->origami;
    s->origami = copy;
    if (!same) { /* shows what was changed */
        s->playing = false;
        s->step = kg_origami_step(copy);
        s->fraction = 0;
    }
    lay_out(s);
    kg_sheet_thumbs_follow(s);
    if (s->sheet >= (int32_t)kg_origami_sheet_count(copy))
        s->sheet = -1;
    kg_origami_destroy(was);
}

kg_box3 kg_sheets_box(const kg_editor *e, bool selection) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_box3 box = kg_box3_empty();
    for (size_t h = 0; s->state && h < s->state->halves.count; h++)
        if (s->state->halves.items[h].loop >= 0)
            kg_box3_add(&box, s->drawn[h]);
    /* all steps, so that nothing leaves the view while they play */
    for (size_t i = 0; !selection && i <= kg_origami_fold_count(s->origami); i++) {
        const kg_origami_state *state = kg_origami_state_at(s->origami, i);
        for (size_t k = 0; k < state->vertices.count; k++)
            kg_box3_add(&box, state->vertices.items[k].position);
    }
    return box;
}

bool kg_sheets_ground(const kg_editor *e, double *out_z) {
    const kg_sheets *s = kg_sheets_of(e);
    *out_z = s->state ? -GROUND * s->state->size : 0;
    return e->pane.camera.pitch >= 0;
}
