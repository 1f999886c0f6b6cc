/* Commands: edits that mend what is wrong with a patch, or make it tidy. */
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "model/refit.h"

#include <stdlib.h>

static kg_status for_each(kg_editor *e, const json_t *a, const char *label,
                          kg_status (*act)(kg_editor *, kg_model_patch *, kg_error *),
                          kg_error *error) {
    int64_t *ids;
    size_t count;
    kg_status status = kg_argument_patches(e, a, &ids, &count, error);
    if (status)
        return status;
    status = kg_editor_begin(e, label, error);
    for (size_t i = 0; i < count && !status; i++) {
        kg_editor_update(e);
        status = act(e, kg_model_find(kg_editor_model(e), ids[i]), error);
        kg_editor_touch(e);
    }
    free(ids);
    return kg_editor_finish(e, status);
}

static kg_status refit_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    return kg_model_refit(kg_editor_model(e), kg_editor_solution(e), p->id, error);
}
static kg_status refit(kg_editor *e, const json_t *a, kg_error *error) {
    return for_each(e, a, N_("Refit"), refit_one, error);
}

/*
 * The ends of the geodesic stay; the inner points are moved into the plane through the chord that
 * they are nearest to. With the parts a_i of them across the chord, in any two directions x, y
 * across it, its angle is that of the main axis of Σ a_i a_iᵀ: tan 2φ = 2 Σxy / (Σx² − Σy²).
 */
static kg_status planarize_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    (void)e;
    kg_patch_input *in = &p->input;
    kg_vec3 first = in->points[0], chord = kg_sub(in->points[in->point_count - 1], first);
    if (!(kg_len(chord) > 0))
        return kg_fail(error, KG_ERR_INPUT,
                       "patch %lld ends where it begins: it has no chord to be flattened along",
                       (long long)p->id);
    chord = kg_unit(chord);
    kg_vec3 aside = fabs(chord.x) < 0.6 ? kg_v3(1, 0, 0) : kg_v3(0, 1, 0);
    kg_vec3 x = kg_unit(kg_cross(chord, aside)), y = kg_cross(chord, x);
    double xx = 0, xy = 0, yy = 0;
    for (size_t i = 1; i + 1 < in->point_count; i++) {
        kg_vec3 a = kg_sub(in->points[i], first);
        xx += kg_dot(a, x) * kg_dot(a, x);
        xy += kg_dot(a, x) * kg_dot(a, y);
        yy += kg_dot(a, y) * kg_dot(a, y);
    }
    double angle = 0.5 * atan2(2 * xy, xx - yy);
    kg_vec3 normal = kg_add(kg_scale(x, -sin(angle)), kg_scale(y, cos(angle)));
    for (size_t i = 1; i + 1 < in->point_count; i++) {
        double off = kg_dot(kg_sub(in->points[i], first), normal);
        in->points[i] = kg_madd(in->points[i], -off, normal);
    }
    return KG_OK;
}
static kg_status planarize(kg_editor *e, const json_t *a, kg_error *error) {
    return for_each(e, a, N_("Flatten geodesic"), planarize_one, error);
}

/* The extent in force becomes the wished one. */
static kg_status narrow_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    (void)error;
    const kg_solved_patch *s = kg_solution_find(kg_editor_solution(e), p->id);
    for (int side = 0; s && s->prepared && side < 2; side++)
        p->input.extent[side] = s->patch.extent[side];
    return KG_OK;
}
static kg_status narrow(kg_editor *e, const json_t *a, kg_error *error) {
    return for_each(e, a, N_("Narrow extent"), narrow_one, error);
}

static const kg_app_command items[] = {
    {"patch.refit", N_("Refit"), N_("Cuts the geodesic back to what is left of the patch."),
     "Ctrl+R", NULL, refit, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.planarize", N_("Flatten geodesic"),
     N_("Moves the inner points into one plane with the ends: the rulings become parallel."), NULL,
     NULL, planarize, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.narrow", N_("Narrow extent"),
     N_("Sets the extent to what the edge of regression allows."), NULL, NULL, narrow,
     kg_has_selection, KG_COMMAND_EDIT},
};
const kg_command_table kg_mend_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
