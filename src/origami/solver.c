/*
 * Orders of layers after Akitaya, Demaine and Ku (2023), with a twist of algebra: "b lies above a"
 * is one bit for each pair of overlapping loops. Tortillas make bits equal: those are joined before
 * anything is searched. Two tacos say that the sum of four bits is even, and three loops with a
 * common part that three bits, taken round, are not all equal. What creases fold which way fixes
 * single bits. The rest is propagation and, component by component, backtracking.
 */
#include "origami/solver.h"

#include "base/array.h"
#include "base/progress.h"
#include "origami/condition.h"
#include "origami/convex.h"
#include "origami/overlap.h"
#include "origami/relation.h"
#include "origami/search.h"

#include <stdlib.h>

kg_layer_report kg_layer_report_default(void) {
    return (kg_layer_report){.most_states = 1e6, .most_steps = 1e8};
}

typedef struct solver {
    kg_origami_state *state;
    kg_outlines outlines;
    struct {
        kg_layer_order *items; /* loops that overlap: by a, then b */
        size_t count, capacity;
    } pairs;
    size_t *starts; /* of loops, the first pair with a or more */
    int32_t *links; /* of pairs, see relation.h */
    kg_clauses clauses;
    const kg_progress *progress;
    kg_error *error;
} solver;

/* Where the steps end, as shares of the whole. */
#define CONDITIONS_FOUND 0.1
#define TRIPLES_FOUND 0.5

/* Pairs between two calls. */
#define PAIRS_OF_A_CALL 64

/* ---- bits ------------------------------------------------------------------------------- */

/* "b lies above a" as a literal; -1 when they do not overlap. */
static int32_t literal(const solver *v, int32_t a, int32_t b) {
    int32_t low = a < b ? a : b, high = a < b ? b : a;
    size_t first = v->starts[low], last = v->starts[low + 1];
    while (first < last) {
        size_t middle = first + (last - first) / 2;
        if (v->pairs.items[middle].b < high)
            first = middle + 1;
        else
            last = middle;
    }
    bool found = first < v->starts[low + 1] && v->pairs.items[first].b == high;
    return found ? (int32_t)(2 * first) + (a > b) : -1;
}

static kg_status find_pairs(solver *v) {
    kg_origami_state *s = v->state;
    int32_t loops = (int32_t)s->loops.count;
    kg_status status = kg_overlaps_fill(s, &v->outlines);
    v->starts = malloc(((size_t)loops + 1) * sizeof *v->starts);
    if (status || !v->starts)
        return KG_ERR_MEMORY;
    kg_layer_order next = {0};
    bool more = kg_origami_next_order(s, &next);
    for (int32_t a = 0; a <= loops; a++) {
        v->starts[a] = v->pairs.count;
        for (; more && next.a == a; more = kg_origami_next_order(s, &next))
            if (!kg_push(&v->pairs, next))
                return KG_ERR_MEMORY;
    }
    v->links = malloc((v->pairs.count + 1) * sizeof *v->links);
    for (size_t i = 0; i < v->pairs.count && v->links; i++)
        v->links[i] = (int32_t)(2 * i);
    return v->links ? KG_OK : KG_ERR_MEMORY;
}

/* ---- conditions at edges ---------------------------------------------------------------- */

static kg_status add_conditions(solver *v) {
    kg_conditions found = {0};
    kg_progress_share share = {v->progress, 0, CONDITIONS_FOUND};
    kg_progress progress = kg_progress_of_share(&share);
    kg_status status = kg_conditions_find(v->state, &v->outlines, &progress, &found, v->error);
    for (size_t i = 0; i < found.count && !status; i++) {
        const kg_condition *c = &found.items[i];
        bool changed;
        if (c->kind == KG_CONDITION_SAME) {
            int32_t x = literal(v, c->a, c->b), y = literal(v, c->c, c->d);
            if (x >= 0 && y >= 0 && !kg_relation_join(v->links, x, y, &changed))
                status =
                    kg_fail(v->error, KG_ERR_INPUT,
                            "there is no order of layers: face %d cannot lie clear of the joined "
                            "faces %d and %d",
                            c->b, c->a, c->c);
            continue;
        }
        kg_clause clause = {{literal(v, c->a, c->c), literal(v, c->b, c->c), literal(v, c->a, c->d),
                             literal(v, c->b, c->d)}};
        bool overlap = true;
        for (int k = 0; k < 4; k++)
            overlap &= clause.literals[k] >= 0;
        if (overlap && !kg_push(&v->clauses, clause))
            status = KG_ERR_MEMORY;
    }
    free(found.items);
    return status;
}

/* ---- three loops ------------------------------------------------------------------------ */

/* Later loops that overlap both of a pair, where those overlap each other. */
static kg_status add_triples_of(solver *v, size_t pair, kg_vec2 *scratch) {
    const kg_outlines *o = &v->outlines;
    const kg_origami_state *s = v->state;
    int32_t a = v->pairs.items[pair].a, b = v->pairs.items[pair].b;
    size_t na = kg_outline_size(o, a), nb = kg_outline_size(o, b), n = 0;
    uint64_t later = ~(uint64_t)1 << (b & 63); /* of the first word */
    for (size_t w = (size_t)b / 64; w < s->layers.words; w++, later = ~(uint64_t)0)
        for (uint64_t both = kg_layer_any(s, a, w) & kg_layer_any(s, b, w) & later; both != 0;) {
            int32_t x = (int32_t)(64 * w) + kg_bit_next(&both);
            if (n == 0)
                n = kg_convex_common(kg_outline_points(o, a), na, kg_outline_points(o, b), nb,
                                     scratch, scratch + na + nb + 2);
            if (n == 0 || !kg_convex_overlap(scratch, n, kg_outline_points(o, x),
                                             kg_outline_size(o, x), s->touch))
                continue;
            kg_clause c = {{literal(v, a, b), literal(v, b, x), literal(v, x, a), -1}};
            if (!kg_push(&v->clauses, c))
                return KG_ERR_MEMORY;
        }
    return KG_OK;
}

static kg_status add_triples(solver *v) {
    size_t most = 0;
    for (size_t i = 0; i < v->state->loops.count; i++) {
        size_t n = kg_outline_size(&v->outlines, (int32_t)i);
        most = n > most ? n : most;
    }
    kg_vec2 *scratch = malloc((4 * most + 4) * sizeof *scratch);
    kg_status status = scratch ? KG_OK : KG_ERR_MEMORY;
    kg_progress_share share = {v->progress, CONDITIONS_FOUND, TRIPLES_FOUND};
    kg_progress progress = kg_progress_of_share(&share);
    for (size_t pair = 0; pair < v->pairs.count && !status; pair++) {
        if (pair % PAIRS_OF_A_CALL == 0)
            status = kg_progress_tell(&progress, (double)pair / (double)v->pairs.count, "layers",
                                      v->error);
        if (!status)
            status = add_triples_of(v, pair, scratch);
    }
    free(scratch);
    return status;
}

/* ---- simplifying ------------------------------------------------------------------------ */

static kg_status contradiction(const solver *v) {
    return kg_fail(v->error, KG_ERR_INPUT, "there is no order of layers");
}

/* Replaces literals by what they are known to equal. Equal bits of a sum cancel; when two remain
 * they are joined. Of three that are not all equal, two equal ones fix the third. */
static kg_status simplify_clause(solver *v, kg_clause *c, bool *keep, bool *changed) {
    int32_t *l = c->literals;
    bool sum = l[3] >= 0;
    for (int k = 0; k < 3 + sum; k++)
        l[k] = kg_relation_find(v->links, l[k]);
    *keep = true;
    for (int i = 0; i < 3 + sum; i++)
        for (int k = i + 1; k < 3 + sum; k++) {
            if (l[i] >> 1 != l[k] >> 1)
                continue;
            bool equal = l[i] == l[k];
            int32_t rest[3], n = 0;
            for (int m = 0; m < 3 + sum; m++)
                if (m != i && m != k)
                    rest[n++] = l[m];
            *keep = false;
            /* a sum of two equal bits is even, of opposite ones odd */
            if (sum)
                return kg_relation_join(v->links, rest[0], rest[1] ^ !equal, changed)
                           ? KG_OK
                           : contradiction(v);
            if (!equal)
                return KG_OK;
            return kg_relation_join(v->links, rest[0], l[i] ^ 1, changed) ? KG_OK
                                                                          : contradiction(v);
        }
    return KG_OK;
}

static kg_status simplify(solver *v) {
    bool changed = true;
    while (changed) {
        size_t kept = 0;
        kg_status told = kg_progress_tell(v->progress, TRIPLES_FOUND, "layers", v->error);
        if (told)
            return told;
        changed = false;
        for (size_t i = 0; i < v->clauses.count; i++) {
            bool keep;
            kg_status status = simplify_clause(v, &v->clauses.items[i], &keep, &changed);
            if (status)
                return status;
            if (keep)
                v->clauses.items[kept++] = v->clauses.items[i];
        }
        v->clauses.count = kept;
    }
    return KG_OK;
}

/* ---- creases ---------------------------------------------------------------------------- */

/* Valleys bring the fronts of their loops together, mountains the backs. */
static kg_status fix_creases(const solver *v, signed char *values) {
    const kg_origami_state *s = v->state;
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t a = kg_loop_of(s, (int32_t)(2 * e)), b = kg_loop_of(s, (int32_t)(2 * e + 1));
        if (s->edges.items[e].kind != KG_PAPER_CREASE || s->edges.items[e].angle == 0 || a < 0 ||
            b < 0)
            continue;
        int32_t l = literal(v, a, b);
        if (l < 0)
            continue;
        int front = s->edges.items[e].angle > 0 ? 1 : -1;
        l = kg_relation_find(v->links, l ^ (front * v->outlines.facing[a] < 0));
        signed char value = l & 1 ? -1 : 1;
        if (values[l >> 1] == -value)
            return kg_fail(v->error, KG_ERR_INPUT,
                           "there is no order of layers: the crease between faces %d and %d is "
                           "folded the wrong way for the others",
                           a, b);
        values[l >> 1] = value;
    }
    return KG_OK;
}

static void take_values(solver *v, const signed char *values) {
    kg_origami_state *s = v->state;
    kg_layers_empty(s);
    for (size_t i = 0; i < v->pairs.count; i++) {
        int32_t l = kg_relation_find(v->links, (int32_t)(2 * i));
        kg_layer_put(s, &v->outlines, v->pairs.items[i].a, v->pairs.items[i].b,
                     (l & 1 ? -1 : 1) * values[l >> 1]);
    }
    for (size_t e = 0; e < s->edges.count; e++) {
        kg_paper_edge *edge = &s->edges.items[e];
        int32_t a = kg_loop_of(s, (int32_t)(2 * e)), b = kg_loop_of(s, (int32_t)(2 * e + 1));
        if (edge->kind != KG_PAPER_OPEN)
            continue;
        edge->kind = KG_PAPER_CREASE;
        edge->angle = copysign(edge->angle, kg_origami_order(s, a, b) < 0 ? -1 : 1);
    }
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status search(solver *v, kg_layer_report *report) {
    size_t pairs = v->pairs.count;
    signed char *values = calloc(pairs + 1, 1);
    if (!values)
        return KG_ERR_MEMORY;
    kg_progress_share share = {v->progress, TRIPLES_FOUND, 1};
    kg_progress progress = kg_progress_of_share(&share);
    kg_status status = fix_creases(v, values);
    report->pairs = pairs;
    report->variables = 0;
    for (size_t i = 0; i < pairs; i++)
        report->variables += v->links[i] == (int32_t)(2 * i);
    if (!status)
        status = kg_search(&v->clauses, v->links, pairs, values, &progress, report, v->error);
    if (status == KG_ERR_INPUT && report->states == 0)
        status = contradiction(v);
    if (!status)
        take_values(v, values);
    free(values);
    return status;
}

kg_status kg_state_solve(kg_origami_state *state, const kg_progress *progress,
                         kg_layer_report *report, kg_error *error) {
    solver v = {.state = state, .progress = progress, .error = error};
    kg_layer_report found = *report;
    found.states = 0;
    kg_status status = kg_outlines_create(state, &v.outlines);
    if (!status)
        status = find_pairs(&v);
    if (!status)
        status = add_conditions(&v);
    if (!status)
        status = add_triples(&v);
    if (!status)
        status = simplify(&v);
    if (!status)
        status = search(&v, &found);
    if (status != KG_ERR_CANCELLED)
        *report = found;
    kg_outlines_clear(&v.outlines);
    free(v.pairs.items);
    free(v.starts);
    free(v.links);
    free(v.clauses.items);
    return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
}
