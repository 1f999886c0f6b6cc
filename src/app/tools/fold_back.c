/* Unfolding as hands do it: another fold turns the paper back, and the crease stays. */
#include "app/text.h"
#include "app/tools/fold.h"

#include <stdlib.h>

/* Over the size of the sheets: corners this near are where they were before. */
#define SAME_PLACE 1e-6

typedef struct search {
    const kg_origami *origami;
    const kg_origami_state *now;
    kg_vec3 *before; /* of the corners of `now`, while the last fold was not made */
} search;

/* How far a corner was moved by the last fold. */
static double way_of(const search *s, int32_t vertex) {
    return kg_dist(s->before[vertex], s->now->vertices.items[vertex].position);
}

static bool has_moved(const search *s, int32_t loop) {
    int32_t first = s->now->loops.items[loop].first, h = first;
    do
        if (way_of(s, s->now->halves.items[h].origin) > SAME_PLACE * s->now->size)
            return true;
    while ((h = s->now->halves.items[h].next) != first);
    return false;
}

static bool brings_back(const search *s, const kg_fold *fold) {
    kg_origami *trial = kg_origami_copy(s->origami);
    kg_error ignored;
    bool back = trial && !kg_origami_fold(trial, fold, &ignored);
    const kg_origami_state *after =
        back ? kg_origami_state_at(trial, kg_origami_step(trial)) : NULL;
    back = back && after->vertices.count == s->now->vertices.count;
    for (size_t i = 0; back && i < after->vertices.count; i++)
        back = kg_dist(after->vertices.items[i].position, s->before[i]) < SAME_PLACE * s->now->size;
    kg_origami_destroy(trial);
    return back;
}

/* About the same line, held at the corner that moved farthest; which of its layers is the lowest
 * that moved, and which way is back, is tried. */
static bool find(const search *s, double angle, kg_fold *fold) {
    int32_t held = 0;
    for (int32_t i = 1; (size_t)i < s->now->vertices.count; i++)
        held = way_of(s, i) > way_of(s, held) ? i : held;
    fold->by_axis = true;
    fold->vertex = s->now->vertices.items[held].position;
    for (int32_t i = 0; (size_t)i < s->now->loops.count; i++) {
        if (!has_moved(s, i) || !kg_fold_has_corner(s->now, i, fold->vertex))
            continue;
        fold->face = i;
        for (int sign = -1; sign <= 1; sign += 2) {
            fold->angle_deg = sign * angle;
            if (brings_back(s, fold))
                return true;
        }
    }
    return false;
}

/* Two points of the line that a fold of `state` turns about. */
static kg_status find_axis(const kg_origami_state *state, const kg_fold *made, kg_vec3 out[2],
                           kg_error *error) {
    kg_fold_preview preview;
    kg_status status = kg_fold_preview_make(state, made, &preview, error);
    out[0] = preview.origin;
    out[1] = kg_madd(preview.origin, state->size, preview.axis);
    kg_fold_preview_clear(&preview);
    return status;
}

kg_status kg_fold_back(kg_editor *e, kg_error *error) {
    const kg_origami *o = kg_editor_origami(e);
    size_t step = kg_origami_step(o);
    if (!kg_sheets_can_fold(e) || step == 0)
        return kg_fail(error, KG_ERR_INPUT, "%s",
                       step == 0 ? _("No folds yet.") : kg_sheets_why_not(e));
    const kg_fold *made = kg_origami_fold_at(o, step - 1);
    search s = {.origami = o, .now = kg_origami_state_at(o, step)};
    kg_fold fold = kg_fold_default();
    kg_status status = find_axis(kg_origami_state_at(o, step - 1), made, fold.points, error);
    if (status)
        return status;
    s.before = malloc((s.now->vertices.count + 1) * sizeof *s.before);
    if (!s.before)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_origami_between(o, step - 1, 0, s.before);
    bool found = find(&s, fabs(made->angle_deg), &fold);
    free(s.before);
    if (!found)
        return kg_fail(
            error, KG_ERR_INPUT, "%s",
            _("Other paper keeps the last fold from being unfolded; undo takes it back"));
    status = kg_fold_add(e, &fold, error);
    kg_editor_update(e);
    if (!status)
        kg_sheets_play_made(e);
    return status;
}
