#include "origami/search.h"

#include <stdlib.h>
#include <string.h>

typedef struct decision {
    int32_t bit;
    bool second; /* the other value was tried as well */
    size_t trail;
} decision;

typedef struct search {
    const kg_clause *clauses;
    signed char *values;
    size_t *starts; /* clauses of each bit: uses[starts[i]] … uses[starts[i + 1] - 1] */
    int32_t *uses;
    int32_t *trail; /* bits in the order they got their values */
    size_t trail_count, done;
    int32_t *members; /* of the component at hand */
    size_t member_count;
    decision *decisions;
    double steps;
} search;

/* ---- clauses ---------------------------------------------------------------------------- */

static int compare_literals(const void *a, const void *b) {
    int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

static int compare_clauses(const void *a, const void *b) {
    const kg_clause *x = a, *y = b;
    for (int k = 0; k < 4; k++)
        if (x->literals[k] != y->literals[k])
            return x->literals[k] < y->literals[k] ? -1 : 1;
    return 0;
}

/* One form for clauses that say the same, each of them once: literals in order, no opposites but
 * perhaps the first in sums, the first not an opposite in others. */
static void tidy(kg_clauses *c) {
    for (size_t i = 0; i < c->count; i++) {
        int32_t *l = c->items[i].literals;
        bool sum = l[3] >= 0;
        int32_t odd = 0;
        qsort(l, sum ? 4 : 3, sizeof *l, compare_literals);
        for (int k = 0; sum && k < 4; k++) {
            odd ^= l[k] & 1;
            l[k] &= ~1;
        }
        for (int k = 2; !sum && k >= 0; k--)
            l[k] ^= l[0] & 1;
        l[0] ^= odd;
    }
    if (c->count > 0)
        qsort(c->items, c->count, sizeof *c->items, compare_clauses);
    size_t kept = 0;
    for (size_t i = 0; i < c->count; i++)
        if (kept == 0 || compare_clauses(&c->items[i], &c->items[kept - 1]) != 0)
            c->items[kept++] = c->items[i];
    c->count = kept;
}

static kg_status index_uses(search *s, const kg_clauses *c, size_t bits) {
    s->starts = calloc(bits + 2, sizeof *s->starts);
    s->uses = malloc((4 * c->count + 1) * sizeof *s->uses);
    if (!s->starts || !s->uses)
        return KG_ERR_MEMORY;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < c->count; i++)
            for (int k = 0; k < 4 && c->items[i].literals[k] >= 0; k++) {
                int32_t bit = c->items[i].literals[k] >> 1;
                if (pass == 0)
                    s->starts[bit + 2]++;
                else
                    s->uses[s->starts[bit + 1]++] = (int32_t)i;
            }
        for (size_t i = 2; i < bits + 2 && pass == 0; i++)
            s->starts[i] += s->starts[i - 1];
    }
    return KG_OK;
}

/* ---- propagation ------------------------------------------------------------------------ */

static int value_of(const search *s, int32_t literal) {
    int value = s->values[literal >> 1];
    return literal & 1 ? -value : value;
}

static void assign(search *s, int32_t literal) {
    s->values[literal >> 1] = literal & 1 ? -1 : 1;
    s->trail[s->trail_count++] = literal >> 1;
}

/* Follows from one clause whatever does; false when it is broken. */
static bool apply(search *s, const kg_clause *c) {
    bool sum = c->literals[3] >= 0;
    int32_t free_literal = -1;
    int product = 1, total = 0;
    for (int k = 0; k < 3 + sum; k++) {
        int value = value_of(s, c->literals[k]);
        if (value == 0 && free_literal >= 0)
            return true;
        if (value == 0)
            free_literal = c->literals[k];
        else
            product *= value, total += value;
    }
    if (free_literal < 0)
        return sum ? product == 1 : abs(total) != 3;
    if (sum)
        assign(s, product == 1 ? free_literal : free_literal ^ 1);
    else if (total != 0)
        assign(s, total < 0 ? free_literal : free_literal ^ 1);
    return true;
}

/* In a sum true counts as 1 and false as -1: four of them are even together when their product is
 * 1. */
static bool propagate(search *s) {
    while (s->done < s->trail_count) {
        int32_t bit = s->trail[s->done++];
        for (size_t i = s->starts[bit]; i < s->starts[bit + 1]; i++)
            if (!apply(s, &s->clauses[s->uses[i]]))
                return false;
    }
    return true;
}

static void undo(search *s, size_t trail) {
    while (s->trail_count > trail)
        s->values[s->trail[--s->trail_count]] = 0;
    s->done = trail;
}

/* ---- one component ---------------------------------------------------------------------- */

/* Bits that hang together by clauses that are not settled, in breadth. */
static void find_component(search *s, int32_t start, bool *seen) {
    s->member_count = 0;
    s->members[s->member_count++] = start;
    seen[start] = true;
    for (size_t m = 0; m < s->member_count; m++) {
        int32_t bit = s->members[m];
        for (size_t i = s->starts[bit]; i < s->starts[bit + 1]; i++) {
            const kg_clause *c = &s->clauses[s->uses[i]];
            bool sum = c->literals[3] >= 0, low = false, high = false;
            for (int k = 0; k < 3; k++) {
                low |= value_of(s, c->literals[k]) < 0;
                high |= value_of(s, c->literals[k]) > 0;
            }
            if (!sum && low && high)
                continue;
            for (int k = 0; k < 3 + sum; k++) {
                int32_t other = c->literals[k] >> 1;
                if (s->values[other] != 0 || seen[other])
                    continue;
                seen[other] = true;
                s->members[s->member_count++] = other;
            }
        }
    }
}

/* Goes back to the last decision with a value left to try. False when there is none. */
static bool backtrack(search *s, size_t *depth) {
    while (*depth > 0) {
        decision *d = &s->decisions[*depth - 1];
        undo(s, d->trail);
        if (d->second) {
            (*depth)--;
            continue;
        }
        d->second = true;
        assign(s, 2 * d->bit + 1);
        if (propagate(s))
            return true;
    }
    return false;
}

/* Counts the ways of the component at hand; `first` holds the first one's values in the order of
 * the members. Negative when the steps are over before there is one. */
static double count_component(search *s, const kg_layer_report *r, signed char *first,
                              bool *exact) {
    double count = 0;
    size_t depth = 0, next = 0, start = s->trail_count;
    for (bool going = true; going;) {
        while (next < s->member_count && s->values[s->members[next]] != 0)
            next++;
        if (next < s->member_count) {
            if (s->steps++ > r->most_steps) {
                *exact = false;
                undo(s, start);
                return count > 0 ? count : -1;
            }
            s->decisions[depth++] = (decision){s->members[next], false, s->trail_count};
            assign(s, 2 * s->members[next]);
            if (propagate(s))
                continue;
        } else {
            for (size_t i = 0; count == 0 && i < s->member_count; i++)
                first[i] = s->values[s->members[i]];
            if (++count >= r->most_states && depth > 0) {
                *exact = false;
                break;
            }
        }
        going = backtrack(s, &depth);
        next = 0;
    }
    undo(s, start);
    return count;
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status search_all(search *s, const int32_t *links, size_t bits, bool *seen,
                            signed char *first, kg_layer_report *r) {
    for (size_t i = 0; i < bits; i++)
        if (s->values[i] != 0)
            s->trail[s->trail_count++] = (int32_t)i;
    r->states = 0;
    r->components = 0;
    r->exact = true;
    if (!propagate(s))
        return KG_ERR_INPUT;
    double states = 1;
    for (size_t i = 0; i < bits; i++) {
        if (s->values[i] != 0 || links[i] >> 1 != (int32_t)i)
            continue;
        find_component(s, (int32_t)i, seen);
        double count = count_component(s, r, first, &r->exact);
        if (count <= 0)
            return count == 0 ? KG_ERR_INPUT : KG_ERR_CANCELLED;
        states *= count;
        r->components++;
        for (size_t k = 0; k < s->member_count; k++)
            assign(s, 2 * s->members[k] + (first[k] < 0));
        s->done = s->trail_count;
    }
    r->states = states;
    return KG_OK;
}

kg_status kg_search(kg_clauses *clauses, const int32_t *links, size_t bits, signed char *values,
                    kg_layer_report *report) {
    tidy(clauses);
    search s = {.clauses = clauses->items,
                .values = values,
                .trail = malloc((bits + 1) * sizeof *s.trail),
                .members = malloc((bits + 1) * sizeof *s.members),
                .decisions = malloc((bits + 1) * sizeof *s.decisions)};
    bool *seen = calloc(bits + 1, sizeof *seen);
    signed char *first = malloc(bits + 1);
    kg_status status = KG_ERR_MEMORY;
    if (s.trail && s.members && s.decisions && seen && first)
        status = index_uses(&s, clauses, bits);
    if (!status)
        status = search_all(&s, links, bits, seen, first, report);
    free(s.starts);
    free(s.uses);
    free(s.trail);
    free(s.members);
    free(s.decisions);
    free(seen);
    free(first);
    return status;
}
