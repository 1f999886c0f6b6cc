#include "origami/search.h"

#include "base/array.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/*
 * A component, or a part that became independent of the others by a decision, while its ways are
 * counted: one of its bits gets both values in turn, and the ways of each are the product of the
 * ways of the parts that what remains falls into.
 */
typedef struct part {
    size_t from, to;  /* its bits among the members */
    size_t next, end; /* its own parts, where the next one starts and the last one ends */
    size_t trail;
    int32_t bit;  /* to decide */
    int tried;    /* values */
    bool first;   /* the first way is still to be kept */
    bool more;    /* there may be more than `ways` */
    bool most;    /* there may be more than `product` */
    double limit; /* count no further */
    double ways, product;
} part;

typedef struct search {
    const kg_clause *clauses;
    signed char *values;
    size_t *starts; /* clauses of each bit: uses[starts[i]] … uses[starts[i + 1] - 1] */
    int32_t *uses;
    int32_t *trail; /* bits in the order they got their values */
    size_t trail_count, done;
    int32_t *members;   /* bits of the component at hand, those of each part side by side */
    int32_t *rank;      /* of each bit, its place among the members at first */
    int32_t *ends;      /* of a part that starts at a place among the members, its end */
    int32_t *found;     /* members as parts, until they are copied */
    size_t *seen, look; /* of each bit, the last look for parts that has found it */
    signed char *first; /* values of the first way */
    struct {
        part *items;
        size_t count, capacity;
    } parts;
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

/* ---- parts ------------------------------------------------------------------------------ */

/* Bits that hang together with `bit` by clauses that are not settled, in breadth: into `found` from
 * `count` on. Returns how many are in there then. */
static size_t find_part(search *s, int32_t bit, size_t count) {
    size_t next = count;
    s->found[count++] = bit;
    s->seen[bit] = s->look;
    for (; next < count; next++) {
        bit = s->found[next];
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
                if (s->values[other] != 0 || s->seen[other] == s->look)
                    continue;
                s->seen[other] = s->look;
                s->found[count++] = other;
            }
        }
    }
    return count;
}

/* Puts the free bits of a part in front, by the parts they fall into, each with its earliest bit
 * first: so the first way that is found does not depend on how parts are found. */
static void split(search *s, part *p) {
    size_t count = 0, taken = 0;
    s->look++;
    for (size_t i = p->from; i < p->to; i++) {
        int32_t bit = s->members[i];
        if (s->values[bit] != 0 || s->seen[bit] == s->look)
            continue;
        size_t start = count, least = count;
        count = find_part(s, bit, count);
        for (size_t k = start; k < count; k++)
            least = s->rank[s->found[k]] < s->rank[s->found[least]] ? k : least;
        bit = s->found[least];
        s->found[least] = s->found[start], s->found[start] = bit;
        s->ends[p->from + start] = (int32_t)(p->from + count);
    }
    p->next = p->from;
    p->end = p->from + count;
    /* those with a value now, or in another part, come behind */
    for (size_t i = p->from; i < p->to; i++)
        if (s->values[s->members[i]] != 0)
            s->found[count + taken++] = s->members[i];
    memcpy(s->members + p->from, s->found, (count + taken) * sizeof *s->found);
}

static bool open_part(search *s, size_t from, size_t to, double limit, bool first) {
    return kg_push(&s->parts, ((part){.from = from,
                                      .to = to,
                                      .trail = s->trail_count,
                                      .bit = s->members[from],
                                      .limit = limit,
                                      .first = first}));
}

/* All parts of a part are counted. */
static void take_ways(search *s, part *p) {
    for (size_t i = p->trail; p->first && i < s->trail_count; i++)
        s->first[s->trail[i]] = s->values[s->trail[i]];
    p->first = false;
    p->more |= p->most;
    p->ways = fmin(p->ways + p->product, DBL_MAX);
}

/* Counts the ways of the component at hand, which is `count` members, and keeps the first. 0 when
 * there is none, or when the steps are over before there is one: then `*exact` is false. */
static kg_status count_ways(search *s, size_t count, const kg_layer_report *r, bool *exact,
                            double *out_ways) {
    *out_ways = 0;
    if (!open_part(s, 0, count, r->most_states, true))
        return KG_ERR_MEMORY;
    while (s->parts.count > 0) {
        part *p = &s->parts.items[s->parts.count - 1];
        if (p->next < p->end && p->product > 0) {
            size_t from = p->next;
            p->next = (size_t)s->ends[from];
            if (!open_part(s, from, p->next, (p->limit - p->ways) / p->product, p->first))
                return KG_ERR_MEMORY;
            continue;
        }
        if (p->tried > 0 && p->product > 0)
            take_ways(s, p);
        undo(s, p->trail);
        bool over = s->steps > r->most_steps,
             enough = p->tried < 2 && ((p->ways > 0 && p->ways >= p->limit) || over);
        if (enough || p->tried == 2) {
            bool more = p->more || enough;
            *out_ways = p->ways;
            if (--s->parts.count > 0) {
                part *whole = &s->parts.items[s->parts.count - 1];
                whole->product = fmin(whole->product * *out_ways, DBL_MAX);
                whole->most |= more;
                whole->more |= over;
            } else {
                *exact &= !more;
            }
            continue;
        }
        s->steps += p->tried == 0;
        assign(s, 2 * p->bit + p->tried++);
        p->product = propagate(s);
        p->next = p->end = 0;
        p->most = false;
        if (p->product > 0)
            split(s, p);
    }
    return KG_OK;
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status search_all(search *s, const int32_t *links, size_t bits, kg_layer_report *r) {
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
        s->look++;
        size_t count = find_part(s, (int32_t)i, 0);
        for (size_t k = 0; k < count; k++) {
            s->members[k] = s->found[k];
            s->rank[s->members[k]] = (int32_t)k;
        }
        double ways;
        kg_status status = count_ways(s, count, r, &r->exact, &ways);
        if (status)
            return status;
        if (ways == 0)
            return r->exact ? KG_ERR_INPUT : KG_ERR_CANCELLED;
        states = fmin(states * ways, DBL_MAX);
        r->components++;
        for (size_t k = 0; k < count; k++)
            assign(s, 2 * s->members[k] + (s->first[s->members[k]] < 0));
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
                .rank = malloc((bits + 1) * sizeof *s.rank),
                .ends = malloc((bits + 1) * sizeof *s.ends),
                .found = malloc((bits + 1) * sizeof *s.found),
                .seen = calloc(bits + 1, sizeof *s.seen),
                .first = malloc(bits + 1)};
    kg_status status = KG_ERR_MEMORY;
    if (s.trail && s.members && s.rank && s.ends && s.found && s.seen && s.first)
        status = index_uses(&s, clauses, bits);
    if (!status)
        status = search_all(&s, links, bits, report);
    free(s.starts);
    free(s.uses);
    free(s.trail);
    free(s.members);
    free(s.rank);
    free(s.ends);
    free(s.found);
    free(s.seen);
    free(s.first);
    free(s.parts.items);
    return status;
}
