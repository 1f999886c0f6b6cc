#include "katagami/model.h"

#include "model/border.h"
#include "model/issues.h"
#include "model/lookup.h"
#include "model/pairs.h"
#include "model/signature.h"
#include "trim/region.h"

#include <stdlib.h>

/* Longest chain of patches that need each other's trimmed regions: each costs stack. */
enum { MAX_CHAIN = 200 };

/* A point of a face this many chord errors from a piece's boundary is on it: both are polylines of
 * the same curve, each off by one chord error. */
#define NEAR_FACE 4.0

typedef enum solve_state { WAITING, WORKING, DONE } solve_state;

struct kg_solution {
    const kg_model *model; /* only while solving */
    double tolerance;
    size_t count;
    kg_solved_patch *patches;
    uint64_t *inputs; /* hash of each patch's input */
    solve_state *states;
    kg_lookup places; /* of the patches, by id */
    kg_lookup wishes; /* patches with multi-surface trims that trim their cutters, by cutter */
    kg_pairs pairs;
    kg_solution *previous; /* only while solving */
    int depth;             /* patches that wait for the trimmed regions of the next */
    kg_issues issues;
};

/* ---- faults ----------------------------------------------------------------------------- */

/* Turns a failed call into an issue; only running out of memory goes on as a failure. */
static kg_status fault(kg_solution *s, kg_solved_patch *p, const char *code, kg_status status,
                       const kg_error *error) {
    if (!status || status == KG_ERR_MEMORY)
        return status;
    p->valid = false;
    return kg_issues_add(&s->issues, KG_FAULT, p->id, code, "%s", error->message);
}

/* ---- looking up ------------------------------------------------------------------------- */

static size_t index_of(const kg_solution *s, int64_t id) {
    const kg_lookup_entry *e = kg_lookup_find(&s->places, id);
    return e ? e->index : s->count;
}

/* Runs over the patches whose multi-surface trims ask for a cut of this one. Start with NULL. */
static const kg_lookup_entry *next_wish(const kg_solution *s, int64_t id,
                                        const kg_lookup_entry *before) {
    if (!before)
        return kg_lookup_find(&s->wishes, id);
    const kg_lookup_entry *next = before + 1, *end = s->wishes.entries + s->wishes.count;
    return next < end && next->id == id ? next : NULL;
}

/* Sorts ids and wishes for the lookups. */
static kg_status index_model(kg_solution *s) {
    const kg_model *m = s->model;
    size_t wishes = 0;
    for (size_t i = 0; i < m->patch_count; i++)
        for (size_t n = 0; n < m->patches[i].trim_count; n++)
            wishes += m->patches[i].trims[n].by_count;
    kg_status status = kg_lookup_create(m->patch_count, &s->places);
    if (!status)
        status = kg_lookup_create(wishes, &s->wishes);
    for (size_t i = 0; i < m->patch_count && !status; i++) {
        kg_lookup_add(&s->places, m->patches[i].id, i);
        for (size_t n = 0; n < m->patches[i].trim_count; n++) {
            const kg_trim_op *op = &m->patches[i].trims[n];
            for (size_t b = 0; b < op->by_count; b++)
                if (op->kind == KG_TRIM_INSIDE && op->trim_cutters && !op->off &&
                    op->by[b] != m->patches[i].id)
                    kg_lookup_add(&s->wishes, op->by[b], i);
        }
    }
    if (!status) {
        kg_lookup_sort(&s->places);
        kg_lookup_sort(&s->wishes);
    }
    return status;
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

static kg_status prepare(kg_solution *s, size_t i) {
    const kg_model_patch *m = &s->model->patches[i];
    kg_solved_patch *p = &s->patches[i];
    kg_error error;
    *p = (kg_solved_patch){.id = m->id, .construction = m->construction, .valid = true};
    s->inputs[i] = kg_hash_input(&m->input);
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
    return kg_issues_of_patch(&s->issues, p);
}

/* ---- trimming --------------------------------------------------------------------------- */

static kg_status solve_patch(kg_solution *s, size_t i);

/* The crossings of two patches with the first as A; faults name the second. */
static kg_status crossings_of(kg_solution *s, size_t a, size_t b, const kg_crossings **out,
                              kg_error *error) {
    kg_pair_side sides[2] = {{s->patches[a].id, s->inputs[a], &s->patches[a].patch},
                             {s->patches[b].id, s->inputs[b], &s->patches[b].patch}};
    kg_status status = kg_pairs_find(&s->pairs, sides, s->tolerance, out, error);
    if (status == KG_ERR_INPUT)
        kg_fail_in(error, status, "and patch %lld: ", (long long)s->patches[b].id);
    return status;
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
        if (!s->patches[k].valid)
            return kg_fail(error, KG_ERR_INPUT,
                           "is trimmed by the trimmed region of patch %lld, which has a fault",
                           (long long)by);
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

/* Is the middle of an edge that patch i made on the regions of patch k on the piece's boundary? */
static bool borders_face(const kg_solution *s, size_t i, const kg_region *piece, size_t k) {
    const kg_regions *faces = &s->patches[k].regions;
    const kg_patch *patch = &s->patches[i].patch;
    for (size_t f = 0; f < faces->count; f++)
        for (size_t l = 0; l < faces->items[f].loop_count; l++)
            for (size_t e = 0; e < faces->items[f].loops[l].edge_count; e++) {
                const kg_region_loop *loop = &faces->items[f].loops[l];
                const kg_region_edge *edge = &loop->edges[e];
                if (edge->kind != KG_EDGE_CUT || edge->source != s->patches[i].id)
                    continue;
                kg_cross_point middle =
                    kg_region_edge_at(&s->patches[k].patch, loop, edge, patch, edge->count / 2,
                                      edge->count == 1 ? 0.5 : 0, NULL);
                for (size_t n = 0; n < piece->loop_count; n++)
                    if (kg_loop_near(patch, &piece->loops[n], middle.s, middle.t,
                                     NEAR_FACE * s->tolerance))
                        return true;
            }
    return false;
}

/* Cuts patch i by patch k, whose multi-surface trim says so, and keeps the largest piece along
 * that trim's face. */
static kg_status trim_cutter(kg_solution *s, size_t i, size_t k, const kg_trim *trim,
                             const kg_regions *in, kg_regions *out, kg_error *error) {
    long long other = s->patches[k].id;
    if (s->states[k] == WORKING)
        return kg_fail(error, KG_ERR_INPUT,
                       "and patch %lld wait for each other's trimmed regions; switch off "
                       "\"bounded\" or \"trim_cutters\" in one of them",
                       other);
    kg_cut cut;
    kg_regions pieces = {0};
    kg_status status = solve_patch(s, k);
    if (!status && !s->patches[k].valid)
        return kg_fail(error, KG_ERR_INPUT, "is a cutter trimmed by patch %lld, which has a fault",
                       other);
    if (!status)
        status = make_cut(s, i, s->patches[k].id, false, &cut, error);
    if (!status)
        status = kg_trim_by(trim, in, &cut, NULL, 0, &pieces, error);
    if (status)
        return status;
    size_t best = pieces.count;
    double largest = 0;
    for (size_t p = 0; p < pieces.count; p++) {
        double area = kg_region_measure(trim->patch, &pieces.items[p], trim->finder).paper_moment;
        if (area > largest && borders_face(s, i, &pieces.items[p], k))
            largest = area, best = p;
    }
    for (size_t p = 0; p < pieces.count; p++)
        if (p != best)
            kg_region_clear(&pieces.items[p]);
    if (best == pieces.count) {
        free(pieces.items);
        return kg_fail(error, KG_ERR_INPUT,
                       "is trimmed away along patch %lld, which trims its cutters; change its own "
                       "trims or switch off \"trim_cutters\" there",
                       other);
    }
    pieces.items[0] = pieces.items[best];
    pieces.count = 1;
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
        h = kg_hash_op(h, op);
        for (size_t b = 0; b < op->by_count && !op->off; b++) {
            size_t k = index_of(s, op->by[b]);
            if (k == s->count)
                continue;
            h = kg_hash_bytes(h, &s->inputs[k], sizeof s->inputs[k]);
            if (!op->bounded || s->states[k] == WORKING)
                continue;
            kg_status status = solve_patch(s, k);
            if (status)
                return status;
            h = kg_hash_bytes(h, &s->patches[k].signature, sizeof s->patches[k].signature);
        }
    }
    for (const kg_lookup_entry *w = NULL; (w = next_wish(s, m->id, w));) {
        const kg_solved_patch *by = &s->patches[w->index];
        h = kg_hash_bytes(h, &by->id, sizeof by->id);
        if (s->states[w->index] == WORKING)
            continue;
        kg_status status = solve_patch(s, w->index);
        if (status)
            return status;
        h = kg_hash_bytes(h, &by->signature, sizeof by->signature);
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
    for (const kg_lookup_entry *w = NULL; !status && (w = next_wish(s, m->id, w));) {
        status = trim_cutter(s, i, w->index, &trim, &p->regions, &next, error);
        advance(&p->regions, &next, status);
    }
    return status;
}

static kg_status solve_patch(kg_solution *s, size_t i) {
    kg_solved_patch *p = &s->patches[i];
    if (s->states[i] != WAITING)
        return KG_OK;
    kg_status status = KG_OK;
    kg_error error;
    s->states[i] = WORKING;
    s->depth++;
    if (s->depth > MAX_CHAIN)
        status = fault(s, p, "bad-trim",
                       kg_fail(&error, KG_ERR_INPUT,
                               "is at the end of a chain of more than %d patches that need each "
                               "other's trimmed regions; switch off \"bounded\" in one of them",
                               MAX_CHAIN),
                       &error);
    else if (p->prepared && !(status = sign(s, i, &p->signature)) && !reuse(s, p))
        status = fault(s, p, "bad-trim", trim_patch(s, i, &error), &error);
    s->depth--;
    if (!status)
        status = kg_issues_of_notes(&s->issues, p);
    s->states[i] = DONE;
    return status;
}

/* ---- the whole -------------------------------------------------------------------------- */

/* Do the crossings of the previous solution hold in this one? */
static bool pair_holds(const void *user, const kg_pair *pair) {
    const kg_solution *s = user;
    for (int side = 0; side < 2; side++) {
        size_t i = index_of(s, pair->id[side]);
        if (i == s->count || s->inputs[i] != pair->input[side])
            return false;
    }
    return true;
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
    if (!status)
        status = index_model(s);
    for (size_t i = 0; i < n && !status; i++, s->count = i)
        status = prepare(s, i);
    if (!status && previous && previous->tolerance == tolerance)
        status = kg_pairs_adopt(&s->pairs, &previous->pairs, pair_holds, s);
    for (size_t i = 0; i < n && !status; i++)
        status = solve_patch(s, i);
    if (!status)
        status = kg_issues_sort(&s->issues, &s->places);
    kg_solution_destroy(previous);
    if (status) {
        kg_solution_destroy(s);
        return kg_fail(error, status, "out of memory");
    }
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
    kg_lookup_clear(&s->places);
    kg_lookup_clear(&s->wishes);
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
    return kg_fail(error, KG_ERR_INPUT, "patch %lld: %s", (long long)s->issues.items[0].patch,
                   s->issues.items[0].message);
}
