/* Commands: edits that mend what is wrong with a patch, or make it tidy. */
#include "app/commands/mend.h"
#include "app/commands/arguments.h"
#include "app/commands/commands.h"
#include "app/text.h"
#include "model/refit.h"
#include "patch/mend.h"

typedef struct mending {
    kg_status (*act)(kg_editor *, kg_model_patch *, kg_error *);
} mending;

/* Each patch is mended with the others as they are by then. */
static kg_status mend_one(kg_editor *e, int64_t id, const void *user, kg_error *error) {
    const mending *m = user;
    kg_editor_update(e);
    kg_status status = m->act(e, kg_model_find(kg_editor_model(e), id), error);
    kg_editor_touch(e);
    return status;
}

static kg_status refit_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    return kg_model_refit(kg_editor_model(e), kg_editor_solution(e), p->id, error);
}
static kg_status refit(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Refit"), mend_one, &(mending){refit_one}, error);
}

/* Puts "patch N" before a message of the kernel. */
static kg_status of_patch(int64_t id, kg_status status, const kg_error *from, kg_error *error) {
    return status ? kg_fail(error, status, "patch %lld: %s", (long long)id, from->message) : KG_OK;
}

static kg_status planarize_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    (void)e;
    kg_error why;
    return of_patch(p->id, kg_patch_flatten(&p->input, &p->input, &why), &why, error);
}
static kg_status planarize(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Flatten geodesic"), mend_one, &(mending){planarize_one},
                            error);
}

static kg_status equalize_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    (void)e;
    kg_error why;
    return of_patch(p->id, kg_patch_equalize(&p->input, &p->input, &why), &why, error);
}
static kg_status equalize(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Equalise end angles"), mend_one, &(mending){equalize_one},
                            error);
}

static kg_status split_one(kg_editor *e, kg_model_patch *p, kg_error *error) {
    kg_error why;
    int64_t id = p->id;
    return of_patch(id, kg_mend_split(e, id, &why), &why, error);
}
static kg_status split(kg_editor *e, const json_t *a, kg_error *error) {
    return kg_argument_each(e, a, N_("Split with a plane"), mend_one, &(mending){split_one}, error);
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
    return kg_argument_each(e, a, N_("Narrow extent"), mend_one, &(mending){narrow_one}, error);
}

/* ---- what they would do ------------------------------------------------------------------ */

enum { SAMPLES = 33 };

/* The farthest that a point of one geodesic is from another, at equal v. */
static double movement(const kg_patch_input *a, const kg_patch_input *b) {
    kg_curve from, to;
    double most = 0;
    if (kg_curve_init(a->points, a->point_count, &from, NULL) ||
        kg_curve_init(b->points, b->point_count, &to, NULL))
        return 0;
    for (int i = 0; i < SAMPLES; i++) {
        double v = (double)i / (SAMPLES - 1);
        most = fmax(most, kg_dist(kg_curve_point(&from, v), kg_curve_point(&to, v)));
    }
    return most;
}

/* The farthest that the halves and the plane between them are from the geodesic. */
static double split_movement(const kg_patch_input *input, const kg_patch_parts *parts) {
    kg_curve from, to;
    double most = 0;
    if (kg_curve_init(input->points, input->point_count, &from, NULL))
        return 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < SAMPLES && !kg_curve_init(parts->halves[k].points, 4, &to, NULL); i++) {
            kg_vec3 x = kg_curve_point(&to, (double)i / (SAMPLES - 1));
            double nearest = HUGE_VAL;
            for (int j = 0; j < 4 * SAMPLES; j++)
                nearest = fmin(nearest, kg_dist(x, kg_curve_point(&from, j / (4.0 * SAMPLES - 1))));
            most = fmax(most, nearest);
        }
    return most;
}

static void offer(kg_mends *mends, const char *command, double moved, const double extent[2]) {
    mends->items[mends->count++] = (kg_mend){command, moved, {extent[0], extent[1]}};
}

void kg_mend_offer(kg_editor *e, int64_t id) {
    kg_mends *mends = &e->mends;
    if (mends->patch == id && mends->solved == e->solved)
        return;
    *mends = (kg_mends){.patch = id, .solved = e->solved};
    const kg_model_patch *p = kg_model_find(kg_editor_model(e), id);
    kg_patch_input out;
    kg_patch patch;
    kg_patch_parts parts;
    if (!p || kg_patch_is_sound(&p->input))
        return;
    if (!kg_patch_equalize(&p->input, &out, NULL))
        offer(mends, "patch.equalise", movement(&p->input, &out), out.extent);
    if (!kg_patch_divide(&p->input, &parts, NULL))
        offer(mends, "patch.split", split_movement(&p->input, &parts), p->input.extent);
    if (!kg_patch_flatten(&p->input, &out, NULL) && kg_patch_is_sound(&out))
        offer(mends, "patch.planarize", movement(&p->input, &out), out.extent);
    if (!kg_patch_init(&p->input, &patch, NULL) && patch.clamped) {
        out = p->input;
        out.extent[0] = patch.extent[0];
        out.extent[1] = patch.extent[1];
        if (kg_patch_is_sound(&out))
            offer(mends, "patch.narrow", 0, out.extent);
    }
}

static const kg_app_command items[] = {
    {"patch.refit", N_("Refit"), N_("Cuts the geodesic back to what is left of the patch."),
     "Ctrl+R", NULL, refit, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.planarize", N_("Flatten geodesic"),
     N_("Moves the inner points into one plane with the ends: the rulings become parallel."), NULL,
     NULL, planarize, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.equalise", N_("Equalise end angles"),
     N_("Evens out how the geodesic turns, as far as its rulings need; its ends stay."), NULL, NULL,
     equalize, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.split", N_("Split with a plane"),
     N_("Divides the patch where its rulings are bad, with a plane between the halves."), NULL,
     NULL, split, kg_has_selection, KG_COMMAND_EDIT},
    {"patch.narrow", N_("Narrow extent"),
     N_("Sets the extent to what the edge of regression allows."), NULL, NULL, narrow,
     kg_has_selection, KG_COMMAND_EDIT},
};
const kg_command_table kg_mend_commands = {items, sizeof items / sizeof *items,
                                           KG_FOR_KIND(KG_DOCUMENT_PATCHES)};
