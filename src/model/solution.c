#include "katagami/model.h"

#include "base/array.h"
#include "model/pairs.h"
#include "trim/region.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum solve_state { WAITING, WORKING, DONE } solve_state;

struct kg_solution {
    const kg_model *model; /* only while solving */
    double tolerance;
    size_t count;
    kg_solved_patch *patches;
    uint64_t *inputs; /* hash of each patch's input */
    solve_state *states;
    kg_pairs pairs;
    kg_solution *previous; /* only while solving */
    struct {
        kg_issue *items;
        size_t count, capacity;
    } issues;
};

/* ---- issues ----------------------------------------------------------------------------- */

static kg_status add_issue(kg_solution *s, kg_severity severity, int64_t patch, const char *code,
                           const char *format, ...) KG_PRINTF(5, 6);

static kg_status add_issue(kg_solution *s, kg_severity severity, int64_t patch, const char *code,
                           const char *format, ...) {
    kg_issue issue = {.severity = severity, .patch = patch, .code = code};
    va_list args;
    va_start(args, format);
    vsnprintf(issue.message, sizeof issue.message, format, args);
    va_end(args);
    return kg_push(&s->issues, issue) ? KG_OK : KG_ERR_MEMORY;
}

/* Turns a failed call into an issue; only running out of memory goes on as a failure. */
static kg_status fault(kg_solution *s, kg_solved_patch *p, const char *code, kg_status status,
                       const kg_error *error) {
    if (!status || status == KG_ERR_MEMORY)
        return status;
    p->valid = false;
    return add_issue(s, KG_FAULT, p->id, code, "%s", error->message);
}

/* ---- signatures: what a result depends on ----------------------------------------------- */

/* FNV-1a */
static uint64_t hash_bytes(uint64_t h, const void *data, size_t size) {
    const unsigned char *p = data;
    for (size_t i = 0; i < size; i++)
        h = (h ^ p[i]) * 0x100000001b3u;
    return h;
}

static uint64_t hash_input(const kg_patch_input *in) {
    uint64_t h = 0xcbf29ce484222325u;
    unsigned char flags[2] = {in->flip, in->has_ruling};
    h = hash_bytes(h, in->points, in->point_count * sizeof in->points[0]);
    h = hash_bytes(h, in->extent, sizeof in->extent);
    h = hash_bytes(h, flags, sizeof flags);
    return in->has_ruling ? hash_bytes(h, &in->ruling, sizeof in->ruling) : h;
}

static uint64_t hash_op(uint64_t h, const kg_trim_op *op) {
    unsigned char flags[5] = {(unsigned char)op->kind, op->off, op->bounded, op->trim_cutters,
                              op->outside};
    h = hash_bytes(h, flags, sizeof flags);
    if (op->by_count)
        h = hash_bytes(h, op->by, op->by_count * sizeof *op->by);
    if (op->keep_count)
        h = hash_bytes(h, op->keep, op->keep_count * sizeof *op->keep);
    if (op->contour_count)
        h = hash_bytes(h, op->contour, op->contour_count * sizeof *op->contour);
    return h;
}

/* ---- looking up ------------------------------------------------------------------------- */

static size_t index_of(const kg_solution *s, int64_t id) {
    for (size_t i = 0; i < s->count; i++)
        if (s->patches[i].id == id)
            return i;
    return s->count;
}

static const kg_patch *find_patch(const void *user, int64_t id) {
    const kg_solution *s = user;
    size_t i = index_of(s, id);
    return i < s->count ? &s->patches[i].patch : NULL;
}

kg_patch_finder kg_solution_finder(const kg_solution *solution) {
    return (kg_patch_finder){find_patch, solution};
}

/* ---- preparing patches ------------------------------------------------------------------ */

static kg_status warn_patch(kg_solution *s, const kg_solved_patch *p) {
    const kg_patch *k = &p->patch;
    kg_status status = KG_OK;
    if (k->clamped) {
        int side = k->extent[0] != k->wished_extent[0] ? 0 : 1;
        status = add_issue(s, KG_WARNING, p->id, "extent-clamped",
                           "its extent %g is cut back to %.4g: beyond %.4g, at v = %.3g, the paper "
                           "would fold back on itself; narrow the extent, or straighten the "
                           "geodesic there",
                           k->wished_extent[side], k->extent[side], k->regression[side],
                           k->regression_v[side]);
    }
    double flattest = fmin(k->theta[0], acos(-1.0) - k->theta[1]);
    if (!status && flattest < KG_FLAT_RULING)
        status = add_issue(s, KG_WARNING, p->id, "flat-ruling",
                           "at v = %.3g its rulings run at %.2g degrees to the geodesic; bend the "
                           "geodesic more evenly",
                           k->flattest_v, flattest * 180 / acos(-1.0));
    return status;
}

static kg_status prepare(kg_solution *s, size_t i) {
    const kg_model_patch *m = &s->model->patches[i];
    kg_solved_patch *p = &s->patches[i];
    kg_error error;
    *p = (kg_solved_patch){.id = m->id, .construction = m->construction, .valid = true};
    s->inputs[i] = hash_input(&m->input);
    const kg_solution *old = s->previous;
    size_t k = old ? index_of(old, m->id) : 0;
    if (old && k < old->count && old->inputs[k] == s->inputs[i] && old->patches[k].prepared) {
        p->patch = old->patches[k].patch;
        p->prepared = true;
    } else {
        kg_status status = kg_patch_init(&m->input, &p->patch, &error);
        p->prepared = status == KG_OK;
        if (status)
            return fault(s, p, "bad-patch", status, &error);
    }
    return warn_patch(s, p);
}

/* ---- trimming --------------------------------------------------------------------------- */

static kg_status solve_patch(kg_solution *s, size_t i);

/* The crossings of two patches with the first as A; faults name the pair. */
static kg_status crossings_of(kg_solution *s, size_t a, size_t b, const kg_crossings **out,
                              kg_error *error) {
    const kg_pairs *old = s->previous ? &s->previous->pairs : NULL;
    kg_pair_side sides[2] = {{s->patches[a].id, s->inputs[a], &s->patches[a].patch},
                             {s->patches[b].id, s->inputs[b], &s->patches[b].patch}};
    return kg_pairs_find(&s->pairs, (kg_pairs *)(uintptr_t)old, sides, s->tolerance, out, error);
}

/* A cut of patch i by the patch with this id. */
static kg_status make_cut(kg_solution *s, size_t i, int64_t by, bool bounded, kg_cut *out,
                          kg_error *error) {
    size_t k = index_of(s, by);
    if (k == s->count)
        return kg_fail(error, KG_ERR_INPUT, "is trimmed by patch %lld, which does not exist",
                       (long long)by);
    if (k == i)
        return kg_fail(error, KG_ERR_INPUT, "is trimmed by itself");
    if (!s->patches[k].prepared)
        return kg_fail(error, KG_ERR_INPUT, "is trimmed by patch %lld, which is not valid",
                       (long long)by);
    *out = (kg_cut){.source = by, .cutter = &s->patches[k].patch};
    if (bounded) {
        if (s->states[k] == WORKING)
            return kg_fail(error, KG_ERR_INPUT,
                           "and patch %lld cut each other with their trimmed regions "
                           "(\"bounded\"): one of them must cut with its whole rectangle",
                           (long long)by);
        kg_status status = solve_patch(s, k);
        if (status)
            return status;
        out->bounded = &s->patches[k].regions;
    }
    return crossings_of(s, i, k, &out->crossings, error);
}

static kg_status apply_op(kg_solution *s, size_t i, size_t number, const kg_trim *trim,
                          const kg_regions *in, kg_regions *out, kg_error *error) {
    const kg_trim_op *op = &s->model->patches[i].trims[number];
    if (op->kind == KG_TRIM_CONTOUR)
        return kg_trim_contour(trim, in, op->contour, op->contour_count, !op->outside,
                               (int64_t)number, out, error);
    kg_cut *cuts = calloc(op->by_count ? op->by_count : 1, sizeof *cuts);
    if (!cuts)
        return KG_ERR_MEMORY;
    kg_status status = KG_OK;
    for (size_t k = 0; k < op->by_count && !status; k++)
        status = make_cut(s, i, op->by[k], op->bounded, &cuts[k], error);
    if (!status)
        status = op->kind == KG_TRIM_BY
                     ? kg_trim_by(trim, in, &cuts[0], op->keep, op->keep_count, out, error)
                     : kg_trim_inside(trim, in, cuts, op->by_count, op->keep, op->keep_count, out,
                                      error);
    free(cuts);
    return status;
}

static kg_status warn_notes(kg_solution *s, int64_t patch, const kg_trim_notes *notes) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < notes->count && !status; i++) {
        const kg_trim_note *n = &notes->items[i];
        long long by = n->source;
        switch (n->kind) {
        case KG_NOTE_PROLONGED:
            status = add_issue(s, KG_WARNING, patch, "cut-prolonged",
                               "the cut by patch %lld ends inside it at (%.4g, %.4g, %.4g) and is "
                               "prolonged by %.3g mm; widen the extent of one of them",
                               by, n->place.x, n->place.y, n->place.z, n->length);
            break;
        case KG_NOTE_JOINED:
            status = add_issue(s, KG_WARNING, patch, "cuts-joined",
                               "the cut by patch %lld ends at (%.4g, %.4g, %.4g) without meeting "
                               "another and is joined to the nearest over %.3g mm; let the cutters "
                               "cross",
                               by, n->place.x, n->place.y, n->place.z, n->length);
            break;
        case KG_NOTE_OUTSIDE:
            status = add_issue(s, KG_WARNING, patch, "cut-outside",
                               "the cut by patch %lld lies wholly outside what is left of it and "
                               "changes nothing; remove that trim or put it first",
                               by);
            break;
        }
    }
    return status;
}

/* Is the middle of some edge of `piece` made by `patch` on the boundary of the patch's regions? */
static bool borders_face(const kg_region *piece, int64_t patch, const kg_regions *faces,
                         double near) {
    for (size_t l = 0; l < piece->loop_count; l++)
        for (size_t k = 0; k < piece->loops[l].edge_count; k++) {
            const kg_region_edge *e = &piece->loops[l].edges[k];
            if (e->kind != KG_EDGE_CUT || e->source != patch)
                continue;
            kg_vec3 x = kg_region_edge_point(&piece->loops[l], e, e->count / 2).x;
            for (size_t f = 0; f < faces->count; f++)
                for (size_t m = 0; m < faces->items[f].loop_count; m++) {
                    const kg_region_loop *loop = &faces->items[f].loops[m];
                    for (size_t q = 0; q < loop->point_count; q++)
                        if (kg_dist(loop->points[q].x, x) <= near)
                            return true;
                }
        }
    return false;
}

/* Cuts patch i by patch k, whose multi-surface trim says so, and keeps the largest piece along
 * that trim's face. */
static kg_status trim_cutter(kg_solution *s, size_t i, size_t k, const kg_trim *trim,
                             const kg_regions *in, kg_regions *out, kg_error *error) {
    if (s->states[k] == WORKING)
        return kg_fail(error, KG_ERR_INPUT,
                       "and patch %lld wait for each other's trimmed regions; switch off "
                       "\"bounded\" or \"trim_cutters\" in one of them",
                       (long long)s->patches[k].id);
    kg_cut cut;
    kg_regions pieces = {0};
    kg_status status = solve_patch(s, k);
    if (!status)
        status = make_cut(s, i, s->patches[k].id, false, &cut, error);
    if (!status)
        status = kg_trim_by(trim, in, &cut, NULL, 0, &pieces, error);
    if (status)
        return status;
    size_t best = pieces.count;
    double largest = 0;
    for (size_t p = 0; p < pieces.count; p++) {
        /* both sides store the same crossing, so its points are equal */
        bool along = borders_face(&pieces.items[p], s->patches[k].id, &s->patches[k].regions,
                                  KG_CROSSING_EXACT * trim->patch->size);
        double area = kg_region_measure(trim->patch, &pieces.items[p], trim->finder).paper_moment;
        if (along && area > largest)
            largest = area, best = p;
    }
    for (size_t p = 0; p < pieces.count && best < pieces.count; p++)
        if (p != best)
            kg_region_clear(&pieces.items[p]);
    if (best < pieces.count) {
        pieces.items[0] = pieces.items[best];
        pieces.count = 1;
    }
    *out = pieces;
    return KG_OK;
}

/* The regions depend on the patch, its trims, the cutters, and the trims that name it as a cutter
 * to be cut as well. Also solves what has to be known first. */
static kg_status sign(kg_solution *s, size_t i, uint64_t *out_signature) {
    const kg_model_patch *m = &s->model->patches[i];
    uint64_t h = s->inputs[i];
    for (size_t n = 0; n < m->trim_count; n++) {
        const kg_trim_op *op = &m->trims[n];
        h = hash_op(h, op);
        for (size_t b = 0; b < op->by_count && !op->off; b++) {
            size_t k = index_of(s, op->by[b]);
            if (k == s->count)
                continue;
            h = hash_bytes(h, &s->inputs[k], sizeof s->inputs[k]);
            if (!op->bounded || s->states[k] == WORKING)
                continue;
            kg_status status = solve_patch(s, k);
            if (status)
                return status;
            h = hash_bytes(h, &s->patches[k].signature, sizeof s->patches[k].signature);
        }
    }
    for (size_t k = 0; k < s->count; k++)
        for (size_t n = 0; n < s->model->patches[k].trim_count; n++) {
            const kg_trim_op *op = &s->model->patches[k].trims[n];
            bool named = false;
            for (size_t b = 0; b < op->by_count; b++)
                named = named || op->by[b] == m->id;
            if (op->off || !op->trim_cutters || !named)
                continue;
            h = hash_bytes(h, &s->patches[k].id, sizeof s->patches[k].id);
            if (k == i || s->states[k] == WORKING)
                continue;
            kg_status status = solve_patch(s, k);
            if (status)
                return status;
            h = hash_bytes(h, &s->patches[k].signature, sizeof s->patches[k].signature);
        }
    *out_signature = h;
    return KG_OK;
}

/* Takes over the regions of the previous solution if nothing they depend on changed. */
static bool reuse(kg_solution *s, kg_solved_patch *p) {
    if (!s->previous || s->previous->tolerance != s->tolerance)
        return false;
    size_t k = index_of(s->previous, p->id);
    if (k == s->previous->count)
        return false;
    kg_solved_patch *old = &s->previous->patches[k];
    if (!old->valid || old->signature != p->signature)
        return false;
    p->regions = old->regions;
    p->notes = old->notes;
    old->regions = (kg_regions){0};
    old->notes = (kg_trim_notes){0};
    old->valid = false;
    return true;
}

/* Replaces `*regions` by the result of a trim, or by nothing when it failed. */
static void advance(kg_regions *regions, kg_regions *next, kg_status status) {
    kg_regions_clear(regions);
    if (!status)
        *regions = *next;
}

static kg_status trim_patch(kg_solution *s, size_t i, kg_error *error) {
    const kg_model_patch *m = &s->model->patches[i];
    kg_solved_patch *p = &s->patches[i];
    kg_trim trim = {&p->patch, kg_solution_finder(s), s->tolerance, &p->notes};
    kg_regions next;
    kg_status status = kg_regions_rectangle(&p->patch, s->tolerance, &p->regions, error);
    for (size_t n = 0; n < m->trim_count && !status; n++) {
        if (m->trims[n].off)
            continue;
        status = apply_op(s, i, n, &trim, &p->regions, &next, error);
        advance(&p->regions, &next, status);
    }
    for (size_t k = 0; k < s->count && !status; k++)
        for (size_t n = 0; n < s->model->patches[k].trim_count && !status; n++) {
            const kg_trim_op *op = &s->model->patches[k].trims[n];
            for (size_t b = 0; b < op->by_count && !status; b++) {
                if (op->off || !op->trim_cutters || op->by[b] != m->id || k == i)
                    continue;
                status = trim_cutter(s, i, k, &trim, &p->regions, &next, error);
                advance(&p->regions, &next, status);
            }
        }
    return status;
}

static kg_status solve_patch(kg_solution *s, size_t i) {
    kg_solved_patch *p = &s->patches[i];
    if (s->states[i] != WAITING)
        return KG_OK;
    s->states[i] = WORKING;
    kg_status status = KG_OK;
    if (p->prepared && !(status = sign(s, i, &p->signature)) && !reuse(s, p)) {
        kg_error error;
        status = fault(s, p, "bad-trim", trim_patch(s, i, &error), &error);
    }
    if (!status)
        status = warn_notes(s, p->id, &p->notes);
    s->states[i] = DONE;
    return status;
}

/* ---- the whole -------------------------------------------------------------------------- */

static int compare_issues(const kg_solution *s, const kg_issue *a, const kg_issue *b) {
    if (a->severity != b->severity)
        return a->severity == KG_FAULT ? -1 : 1;
    size_t i = index_of(s, a->patch), j = index_of(s, b->patch);
    return i < j ? -1 : i > j;
}

/* Faults first, then in the order of the model; stable, so a patch's own order stays. */
static void sort_issues(kg_solution *s) {
    for (size_t i = 1; i < s->issues.count; i++) {
        kg_issue moved = s->issues.items[i];
        size_t j = i;
        for (; j > 0 && compare_issues(s, &moved, &s->issues.items[j - 1]) < 0; j--)
            s->issues.items[j] = s->issues.items[j - 1];
        s->issues.items[j] = moved;
    }
}

kg_status kg_solution_create(const kg_model *model, double tolerance, kg_solution *previous,
                             kg_solution **out_solution, kg_error *error) {
    size_t n = model->patch_count;
    kg_solution *s = calloc(1, sizeof *s);
    kg_status status = KG_ERR_MEMORY;
    if (s) {
        *s = (kg_solution){.model = model, .tolerance = tolerance, .previous = previous};
        s->patches = calloc(n + 1, sizeof *s->patches);
        s->inputs = calloc(n + 1, sizeof *s->inputs);
        s->states = calloc(n + 1, sizeof *s->states);
        if (s->patches && s->inputs && s->states)
            status = KG_OK;
    }
    for (size_t i = 0; i < n && !status; i++, s->count = i)
        status = prepare(s, i);
    for (size_t i = 0; i < n && !status; i++)
        status = solve_patch(s, i);
    kg_solution_destroy(previous);
    if (status) {
        kg_solution_destroy(s);
        return kg_fail(error, status, "out of memory");
    }
    sort_issues(s);
    s->model = NULL;
    s->previous = NULL;
    *out_solution = s;
    return KG_OK;
}

void kg_solution_destroy(kg_solution *s) {
    if (!s)
        return;
    for (size_t i = 0; i < s->count; i++) {
        kg_regions_clear(&s->patches[i].regions);
        free(s->patches[i].notes.items);
    }
    free(s->patches);
    free(s->inputs);
    free(s->states);
    kg_pairs_clear(&s->pairs);
    free(s->issues.items);
    free(s);
}

size_t kg_solution_count(const kg_solution *s) {
    return s->count;
}

const kg_solved_patch *kg_solution_patch(const kg_solution *s, size_t index) {
    return &s->patches[index];
}

const kg_solved_patch *kg_solution_find(const kg_solution *s, int64_t id) {
    size_t i = index_of(s, id);
    return i < s->count ? &s->patches[i] : NULL;
}

double kg_solution_tolerance(const kg_solution *s) {
    return s->tolerance;
}

size_t kg_solution_issue_count(const kg_solution *s) {
    return s->issues.count;
}

const kg_issue *kg_solution_issue(const kg_solution *s, size_t index) {
    return &s->issues.items[index];
}

kg_status kg_solution_check(const kg_solution *s, kg_error *error) {
    if (s->issues.count == 0 || s->issues.items[0].severity != KG_FAULT)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "patch %lld %s", (long long)s->issues.items[0].patch,
                   s->issues.items[0].message);
}
