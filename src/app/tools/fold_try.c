/* The fold being made: working it out, what can be chosen of it, making it. */
#include "app/text.h"
#include "app/tools/fold.h"

#include <stdio.h>
#include <stdlib.h>

void kg_fold_forget(kg_fold_tool *t) {
    if (t->given)
        kg_fold_preview_clear(&t->preview);
    t->given = false;
    free(t->gaps);
    t->gaps = NULL;
    t->gap_count = 0;
}

static void drop(kg_editor *e, kg_fold_tool *t) {
    kg_fold_forget(t);
    t->phase = KG_PHASE_READY;
    t->aimed = false;
    t->vertex = t->picked = -1;
    t->layers = 1;
    t->between[0] = t->between[1] = -1;
    t->typed[0] = '\0';
    free(t->pile);
    t->pile = NULL;
    t->pile_count = 0;
    kg_sheets_unmark(e);
}

kg_fold_tool *kg_fold_tool_of(kg_editor *e) {
    if (e->tool != &kg_tool_fold)
        return NULL;
    kg_fold_tool *t = e->tool_state;
    if (!t) {
        e->tool_state = t = calloc(1, sizeof *t);
        if (!t)
            return NULL;
        t->angle_deg = 180;
        t->sign = 1;
        drop(e, t);
    }
    /* what was chosen of paper that is no longer so */
    if ((t->phase != KG_PHASE_READY || t->given || t->vertex >= 0 || t->pile) &&
        t->topology != kg_sheets_of(e)->topology)
        drop(e, t);
    return t;
}

void kg_fold_drop(kg_editor *e) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (t)
        drop(e, t);
}

const kg_fold_tool *kg_fold_tool_seen(const kg_editor *e) {
    const kg_fold_tool *t = e->tool == &kg_tool_fold ? e->tool_state : NULL;
    return t && (t->topology == kg_sheets_of(e)->topology ||
                 (t->phase == KG_PHASE_READY && !t->given && t->vertex < 0))
               ? t
               : NULL;
}

/* ---- layers ------------------------------------------------------------------------------ */

/* The side of a loop that is on the side it folds to: 1 its front, -1 its back. */
static int upper_side(const kg_origami_state *s, const kg_fold_tool *t, int32_t loop) {
    kg_vec3 normal = s->groups.items[t->group].normal;
    return t->sign * t->angle_deg * kg_dot(kg_origami_normal(s, loop), normal) > 0 ? 1 : -1;
}

bool kg_fold_has_corner(const kg_origami_state *s, int32_t loop, kg_vec3 p) {
    int32_t first = s->loops.items[loop].first, h = first;
    do
        if (kg_dist(s->vertices.items[s->halves.items[h].origin].position, p) < 1e-8 * s->size)
            return true;
    while ((h = s->halves.items[h].next) != first);
    return false;
}

void kg_fold_find_pile(kg_editor *e, kg_fold_tool *t) {
    const kg_origami_state *s = kg_sheets_of(e)->state;
    size_t loops = s->loops.count;
    free(t->pile);
    t->pile_count = 0;
    t->pile = calloc(loops + 1, sizeof *t->pile);
    if (!t->pile || t->vertex < 0)
        return;
    kg_vec3 at = s->vertices.items[t->vertex].position;
    int32_t *members = malloc((loops + 1) * sizeof *members), count = 0;
    int32_t *uncovered = malloc((loops + 1) * sizeof *uncovered), ends = 0;
    int32_t *above = calloc(loops + 1, sizeof *above);
    bool ok = members && uncovered && above;
    for (size_t i = 0; i < loops && ok; i++)
        if (s->loops.items[i].group == t->group && kg_fold_has_corner(s, (int32_t)i, at)) {
            t->pile[i] = 1;
            members[count++] = (int32_t)i;
        }
    for (int32_t i = 0; i < count; i++) {
        int side = upper_side(s, t, members[i]);
        for (int32_t k = 0; k < count; k++)
            above[members[i]] += kg_origami_order(s, members[i], members[k]) == side;
        if (above[members[i]] == 0)
            uncovered[ends++] = members[i];
    }
    /* each below all that lie on it; layers in a ring stay where they are */
    for (int32_t i = 0; i < ends; i++) {
        int32_t loop = uncovered[i], side = upper_side(s, t, loop), depth = t->pile[loop];
        t->pile_count = depth > t->pile_count ? depth : t->pile_count;
        for (int32_t k = 0; k < count; k++) {
            int32_t lower = members[k];
            if (kg_origami_order(s, loop, lower) != -side)
                continue;
            t->pile[lower] = depth + 1 > t->pile[lower] ? depth + 1 : t->pile[lower];
            if (--above[lower] == 0)
                uncovered[ends++] = lower;
        }
    }
    free(members);
    free(uncovered);
    free(above);
}

static int32_t topmost(const kg_fold_tool *t, const kg_origami_state *s) {
    for (size_t i = 0; t->pile && i < s->loops.count; i++)
        if (t->pile[i] == 1)
            return (int32_t)i;
    return -1;
}

int32_t kg_fold_layers_now(const kg_fold_tool *t, int32_t *out_count) {
    *out_count = t->given ? t->preview.layer_count : t->pile_count;
    return t->given ? t->fold.layers : t->layers < *out_count ? t->layers : *out_count;
}

/* ---- working it out ---------------------------------------------------------------------- */

static void say_reason(kg_fold_tool *t, const kg_error *error) {
    const size_t size = sizeof t->reason;
    char *out = t->reason;
    const kg_fold_preview *p = &t->preview;
    int a = p->faces[0], b = p->faces[1];
    switch (p->fault) {
    case KG_FOLD_IN_WAY:
        snprintf(out, size, _("Paper is in the way: face %d meets face %d at %.1f°"), a, b,
                 p->meets_deg);
        break;
    case KG_FOLD_AT_EDGE:
        snprintf(out, size, _("Faces %d and %d would pass through each other at their edge"), a, b);
        break;
    case KG_FOLD_HELD:
        snprintf(out, size, _("Face %d would pull at face %d, which is held"), a, b);
        break;
    case KG_FOLD_ALL_MOVES:
        snprintf(out, size, "%s", _("The axis is beside the paper: all of it would move"));
        break;
    default:
        snprintf(out, size, _("It cannot be folded: %s"), error->message);
    }
}

static void work_out(kg_editor *e, kg_fold_tool *t) {
    kg_error error;
    if (t->given)
        kg_fold_preview_clear(&t->preview);
    t->refused = kg_fold_preview_make(kg_sheets_of(e)->state, &t->fold, &t->preview, &error);
    if (t->refused)
        say_reason(t, &error);
    t->given = true;
}

/* The face that starts it, where the one that follows from the vertex is not meant: of the plane
 * that is folded in; under the pointer, of flaps beside each other. */
static int32_t face_meant(const kg_editor *e, const kg_fold_tool *t) {
    const kg_origami_state *s = kg_sheets_of(e)->state;
    const kg_fold_preview *p = &t->preview;
    int32_t top = topmost(t, s);
    bool picked = t->picked >= 0 && t->angle_deg > 0 && t->pile && t->pile[t->picked] == 1;
    if (picked && t->picked != top)
        return t->picked;
    return !p->has_axis || p->group != t->group ? top : -1;
}

void kg_fold_try(kg_editor *e, kg_fold fold) {
    kg_fold_tool *t = e->tool_state;
    fold.angle_deg = t->sign * t->angle_deg;
    fold.layers = t->layers == KG_ALL_LAYERS ? 1 : t->layers;
    fold.face = -1;
    fold.between[0] = t->between[0], fold.between[1] = t->between[1];
    t->fold = fold;
    if (t->vertex >= 0)
        kg_fold_find_pile(e, t);
    work_out(e, t);
    t->fold.face = face_meant(e, t);
    if (t->fold.face >= 0)
        work_out(e, t);
    int32_t count = t->preview.layer_count, wanted = t->layers < count ? t->layers : count;
    if (count > 0 && t->fold.layers != wanted) {
        t->fold.layers = wanted;
        work_out(e, t);
    }
}

static void try_again(kg_editor *e, kg_fold_tool *t) {
    if (t->given)
        kg_fold_try(e, t->fold);
    else if (t->vertex >= 0)
        kg_fold_find_pile(e, t);
}

/* ---- choices ----------------------------------------------------------------------------- */

void kg_fold_use_way(kg_editor *e, kg_fold_way way) {
    if (e->tool != &kg_tool_fold)
        kg_editor_use(e, &kg_tool_fold, NULL);
    kg_fold_tool *t = kg_fold_tool_of(e);
    kg_fold_drop(e);
    if (t)
        t->way = way;
}

/* Gaps are of one angle and one number of layers. */
static void forget_gaps(kg_fold_tool *t) {
    free(t->gaps);
    t->gaps = NULL;
    t->gap_count = 0;
    t->between[0] = t->between[1] = -1;
}

void kg_fold_set_angle(kg_editor *e, double angle_deg) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t)
        return;
    angle_deg = fmin(fmax(angle_deg, -180), 180);
    t->angle_deg = fabs(angle_deg) > 1e-3 ? angle_deg : 180;
    t->typed[0] = '\0';
    forget_gaps(t);
    try_again(e, t);
    if (t->phase == KG_PHASE_HELD)
        kg_fold_find_gaps(e);
}

void kg_fold_set_layers(kg_editor *e, int32_t layers) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t)
        return;
    t->layers = layers > 1 ? layers : 1;
    forget_gaps(t);
    try_again(e, t);
    if (t->phase == KG_PHASE_HELD)
        kg_fold_find_gaps(e);
}

void kg_fold_find_gaps(kg_editor *e) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t || !t->given || t->gaps || fabs(t->angle_deg) < 180)
        return;
    if (kg_fold_gaps(kg_sheets_of(e)->state, &t->fold, &t->gaps, &t->gap_count, NULL)) {
        t->gaps = NULL; /* none */
        t->gap_count = 0;
    }
}

size_t kg_fold_gap_now(const kg_fold_tool *t) {
    for (size_t i = 0; i < t->gap_count; i++)
        if (t->gaps[i].lower == t->between[0] && t->gaps[i].upper == t->between[1])
            return i + 1;
    return 0;
}

void kg_fold_set_gap(kg_editor *e, size_t gap) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t)
        return;
    bool inside = gap > 0 && gap <= t->gap_count;
    t->between[0] = inside ? t->gaps[gap - 1].lower : -1;
    t->between[1] = inside ? t->gaps[gap - 1].upper : -1;
    try_again(e, t);
}

/* ---- making it --------------------------------------------------------------------------- */

const char *kg_fold_advice(const kg_fold_tool *t) {
    switch (t->preview.fault) {
    case KG_FOLD_IN_WAY:
        return _("Stop before that angle, fold away what is in the way, or move more layers.");
    case KG_FOLD_AT_EDGE:
        return _("Fold to the other side (V), or move another number of layers.");
    case KG_FOLD_HELD:
        return _("Move more layers along (wheel), or unfold first what holds it.");
    default:
        return NULL;
    }
}

kg_status kg_fold_add(kg_editor *e, const kg_fold *fold, kg_error *error) {
    kg_status status = kg_editor_begin(e, N_("Fold"), error);
    if (!status)
        status = kg_origami_fold(kg_editor_origami(e), fold, error);
    kg_editor_touch(e);
    return kg_editor_finish(e, status);
}

kg_status kg_fold_done(kg_editor *e, kg_error *error) {
    kg_fold_tool *t = kg_fold_tool_of(e);
    if (!t || !t->given)
        return kg_fail(error, KG_ERR_INPUT, "No fold is being made");
    if (!kg_sheets_can_fold(e))
        return kg_fail(error, KG_ERR_INPUT, "%s", kg_sheets_why_not(e));
    if (t->refused)
        return kg_fail(error, KG_ERR_INPUT, "%s", t->reason);
    kg_fold fold = t->fold;
    fold.layers = fold.layers > 1 ? fold.layers : 0; /* as files leave it out */
    kg_fold_drop(e);
    kg_status status = kg_fold_add(e, &fold, error);
    kg_editor_update(e);
    if (status)
        return status;
    kg_sheets_play_made(e);
    if ((t = kg_fold_tool_of(e)) && !t->keeps_angle)
        t->angle_deg = copysign(180, t->angle_deg);
    return KG_OK;
}
