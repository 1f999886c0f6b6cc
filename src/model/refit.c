#include "model/refit.h"

#include "model/edit.h"

#include <string.h>

/* Left on either side of what is used, as a share of it. */
#define MARGIN 0.01

/* Relative difference of lengths and areas that measuring along other chords makes. */
#define SAME 1e-6

typedef struct span {
    double lo, hi;
} span;

static void add_value(span *s, double v) {
    s->lo = fmin(s->lo, v);
    s->hi = fmax(s->hi, v);
}

/* ---- what is used ------------------------------------------------------------------------ */

static void add_regions(const kg_regions *regions, span *s) {
    for (size_t i = 0; i < regions->count; i++)
        for (size_t k = 0; k < regions->items[i].loop_count; k++)
            for (size_t j = 0; j < regions->items[i].loops[k].point_count; j++)
                add_value(s, regions->items[i].loops[k].points[j].v);
}

/* All of the crossing of patch a with another. */
static kg_status add_crossing(const kg_solution *solution, const kg_patch *a, int64_t other,
                              span *s, kg_error *error) {
    const kg_solved_patch *b = kg_solution_find(solution, other);
    kg_crossings found;
    if (!b || !b->prepared)
        return kg_fail(error, KG_ERR_INPUT, "patch %lld is not valid; mend it first",
                       (long long)other);
    kg_status status =
        kg_crossings_find(a, &b->patch, kg_solution_tolerance(solution), &found, error);
    if (status)
        return status;
    for (size_t i = 0; i < found.count; i++)
        for (size_t k = 0; k < found.branches[i].count; k++)
            add_value(s, found.branches[i].points[k].v);
    kg_crossings_clear(&found);
    return KG_OK;
}

/* What trims of other patches use of patch `id`; with `own`, also where its own cutters run, so
 * that none of them misses it afterwards. */
static kg_status add_trims(const kg_model *model, const kg_solution *solution,
                           const kg_solved_patch *patch, bool own, span *s, kg_error *error) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < model->patch_count; i++)
        for (size_t n = 0; n < model->patches[i].trim_count; n++) {
            const kg_model_patch *m = &model->patches[i];
            const kg_trim_op *op = &m->trims[n];
            for (size_t b = 0; b < op->by_count && !status && !op->off; b++) {
                bool cuts_other = op->by[b] == patch->id && !op->bounded;
                bool cuts_this = m->id == patch->id && (own || op->trim_cutters);
                if (cuts_other || cuts_this)
                    status = add_crossing(solution, &patch->patch, cuts_other ? m->id : op->by[b],
                                          s, error);
            }
        }
    return status;
}

/* ---- the same patch on a part of its geodesic --------------------------------------------- */

static kg_vec2 remapped(kg_vec2 at, span s, double sign) {
    return kg_v2(sign * at.x, (at.y - s.lo) / (s.hi - s.lo));
}

static kg_status remap(const kg_patch *old, span s, kg_model *model, int64_t id, kg_error *error) {
    kg_model_patch *m = kg_model_find(model, id);
    kg_patch_input in = m->input;
    double middle = 0.5 * (s.lo + s.hi);
    kg_vec3 d = kg_patch_ruling(old, middle).d;
    kg_curve part = kg_curve_segment(&old->geodesic, s.lo, s.hi);
    memcpy(in.points, part.points, in.point_count * sizeof in.points[0]);
    memcpy(in.extent, old->extent, sizeof in.extent);
    if (kg_curve_classify(&part) == KG_CURVE_STRAIGHT) {
        in.has_ruling = true;
        in.ruling = d;
    }
    kg_patch fresh;
    kg_status status = kg_patch_init(&in, &fresh, error);
    if (status)
        return status;
    double sign = kg_dot(kg_patch_ruling(&fresh, 0.5).d, d) < 0 ? -1 : 1;
    if (sign < 0) {
        in.extent[0] = -old->extent[1];
        in.extent[1] = -old->extent[0];
        in.flip = !in.flip;
    }
    m->input = in;
    for (size_t n = 0; n < m->trim_count; n++)
        for (size_t i = 0; i < m->trims[n].contour_count; i++) {
            kg_vec2 *c = &m->trims[n].contour[i];
            *c = remapped(*c, s, sign);
            if (!(fabs(c->y) <= KG_MAX_COORDINATE))
                return kg_fail(error, KG_ERR_INPUT,
                               "a contour of patch %lld reaches too far beyond it; bring its "
                               "corners nearer",
                               (long long)m->id);
        }
    for (size_t i = 0; i < model->join_count; i++) {
        kg_model_join *j = &model->joins[i];
        if (j->has_at && j->patches[0] == id) { /* a hint, so one far off may be brought nearer */
            j->at = remapped(j->at, s, sign);
            j->at.y = fmin(fmax(j->at.y, -1), 2);
        }
    }
    return KG_OK;
}

/* ---- is it the same? ---------------------------------------------------------------------- */

static bool same_regions(const kg_solution *x, const kg_solved_patch *a, const kg_solution *y,
                         const kg_solved_patch *b) {
    if (a->valid != b->valid || a->regions.count != b->regions.count)
        return false;
    for (size_t i = 0; i < a->regions.count; i++) {
        kg_measure p = kg_region_measure(&a->patch, &a->regions.items[i], kg_solution_finder(x));
        kg_measure q = kg_region_measure(&b->patch, &b->regions.items[i], kg_solution_finder(y));
        if (!(fabs(p.space_moment - q.space_moment) <= SAME * fabs(p.space_moment) &&
              fabs(p.space_length - q.space_length) <= SAME * p.space_length))
            return false;
    }
    return true;
}

static bool trims_with(const kg_model_patch *m, int64_t id) {
    bool found = m->id == id;
    for (size_t n = 0; n < m->trim_count; n++)
        for (size_t b = 0; b < m->trims[n].by_count; b++)
            found = found || m->trims[n].by[b] == id;
    return found;
}

static kg_status check_same(const kg_model *model, const kg_solution *before, int64_t id,
                            bool *out_same, kg_error *error) {
    kg_solution *after;
    kg_status status =
        kg_solution_create(model, kg_solution_tolerance(before), NULL, &after, error);
    if (status)
        return status;
    *out_same = true;
    for (size_t i = 0; i < model->patch_count && *out_same; i++)
        if (trims_with(&model->patches[i], id))
            *out_same = same_regions(before, kg_solution_patch(before, i), after,
                                     kg_solution_patch(after, i));
    kg_solution_destroy(after);
    return KG_OK;
}

/* ---- the edit ----------------------------------------------------------------------------- */

static kg_status try_span(kg_model *model, const kg_solution *solution,
                          const kg_solved_patch *patch, span s, bool *out_done, kg_error *error) {
    kg_model *copy = kg_model_copy(model);
    if (!copy)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = remap(&patch->patch, s, copy, patch->id, error);
    if (!status)
        status = check_same(copy, solution, patch->id, out_done, error);
    if (!status && *out_done)
        kg_model_swap(model, copy);
    kg_model_destroy(copy);
    return status;
}

kg_status kg_model_refit(kg_model *model, const kg_solution *solution, int64_t id,
                         kg_error *error) {
    const kg_solved_patch *patch = kg_solution_find(solution, id);
    if (!patch || !kg_model_find(model, id))
        return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)id);
    if (!patch->valid || patch->regions.count == 0)
        return kg_fail(error, KG_ERR_INPUT, "patch %lld is not valid; mend it first",
                       (long long)id);
    kg_status status = KG_OK;
    for (int own = 0; own < 2; own++) {
        span s = {1, 0};
        add_regions(&patch->regions, &s);
        if ((status = add_trims(model, solution, patch, own, &s, error)))
            return status;
        double margin = MARGIN * (s.hi - s.lo);
        s = (span){fmax(s.lo - margin, 0), fmin(s.hi + margin, 1)};
        if (s.lo == 0 && s.hi == 1)
            return KG_OK;
        bool done = false;
        if ((status = try_span(model, solution, patch, s, &done, error)) || done)
            return status;
    }
    return kg_fail(error, KG_ERR_INPUT,
                   "patch %lld cannot be cut back without a change to what is cut from it",
                   (long long)id);
}
