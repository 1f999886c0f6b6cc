#include "origami/search.h"

#include "base/array.h"
#include "base/progress.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/*
 * Counting as solvers of #SAT do it (Bayardo and Pehoushek 2000; Sang and others 2004): all bits
 * are the first part; one bit of a part gets both values in turn, and the ways of each are the
 * product of the ways of the parts that what remains falls into. Counts are kept, since the same
 * part comes back under many decisions.
 */

/* What a part is known by: sums of scattered numbers for its bits, and for its clauses with the
 * values in them. That any two of a million parts share 128 bits by chance happens in one of 1e26
 * searches. */
typedef struct part_key {
    uint64_t low, high;
} part_key;

/* Bits that hang together by clauses that are not settled. */
typedef struct part {
    size_t bits, end_bits;       /* among the members */
    size_t clauses, end_clauses; /* among the places */
    int32_t bit;                 /* to decide: of most weight */
    int32_t number;              /* as it was found */
    part_key key;
} part;

/* A part while its ways are counted. */
typedef struct tally {
    part part;
    size_t next, end; /* its own parts: where the next one starts, where the last one ends */
    size_t trail;
    int tried;    /* values */
    bool first;   /* the first way is still to be kept */
    bool more;    /* there may be more than `ways` */
    bool most;    /* there may be more than `product` */
    double limit; /* count no further */
    double ways, product;
} tally;

/* A part that was counted; later ones take the places of earlier ones. */
typedef struct record {
    part_key key;
    double ways;
    bool used, more;
} record;

enum { RECORDS = 1 << 18 }; /* 8 MB, of which only what is used is touched */

/* What values leave of a clause. */
typedef struct rest {
    int32_t clause;
    int32_t bit;    /* a free one, -1 when the clause is settled */
    uint32_t value; /* what those in it come to */
} rest;

typedef struct search {
    const kg_clause *clauses;
    signed char *values;
    size_t *starts; /* clauses of each bit: uses[starts[i]] … uses[starts[i + 1] - 1] */
    int32_t *uses;
    int32_t *trail; /* bits in the order they got their values */
    size_t trail_count, done;
    int32_t *members;   /* free bits, those of each part side by side */
    int32_t *places;    /* clauses, likewise */
    part *parts;        /* by their first place among the members */
    signed char *first; /* values of the first way */
    record *records;
    struct {
        tally *items;
        size_t count, capacity;
    } tallies;
    double steps;            /* clauses looked at */
    double told;             /* of them, when `progress` was last told */
    kg_progress_share share; /* of what is being done */
    kg_error *error;
    /* while parts are found */
    int32_t *roots;   /* of each bit, an earlier one of its part */
    int32_t *numbers; /* of roots, the part's; -1: none yet */
    int32_t *weights; /* of each bit, how much may follow from its value */
    rest *rests;      /* of each place */
    part *found;
    size_t *ends; /* of each part found, where its bits end */
    int32_t *bits;
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
        s->steps += (double)(s->starts[bit + 1] - s->starts[bit]);
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

static uint64_t scatter(uint64_t x) { /* splitmix64 */
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static void add_to_key(part_key *key, uint64_t x) {
    key->low += scatter(x);
    key->high += scatter(~x);
}

static int32_t root_of(const search *s, int32_t bit) {
    while (s->roots[bit] != bit)
        bit = s->roots[bit] = s->roots[s->roots[bit]];
    return bit;
}

/* Joins the free bits of a clause and weighs them: a decision settles clauses of two at once. */
static rest look_at(search *s, int32_t clause) {
    const int32_t *l = s->clauses[clause].literals;
    bool sum = l[3] >= 0, low = false, high = false;
    int32_t bits[4], n = 0;
    int product = 1;
    for (int k = 0; k < 3 + sum; k++) {
        int value = value_of(s, l[k]);
        if (value == 0)
            bits[n++] = l[k] >> 1;
        else
            low |= value<0, high |= value> 0, product *= value;
    }
    if (n == 0 || (!sum && low && high))
        return (rest){clause, -1, 0};
    int32_t a = root_of(s, bits[0]);
    for (int k = 0; k < n; k++) {
        s->weights[bits[k]] += n == 2 ? 2 : 1;
        int32_t b = root_of(s, bits[k]);
        if (a < b)
            s->roots[b] = a;
        else
            s->roots[a] = b, a = b;
    }
    return (rest){clause, bits[0], sum ? product > 0 : (uint32_t)low + 2 * (uint32_t)high};
}

/* The smallest first: there dead ends show soonest. */
static int compare_parts(const void *a, const void *b) {
    const part *x = a, *y = b;
    if (x->end_bits != y->end_bits)
        return x->end_bits < y->end_bits ? -1 : 1;
    return x->bit < y->bit ? -1 : x->bit > y->bit;
}

/* Lists the parts that the free bits of a part fall into: `end_bits` and `end_clauses` are only
 * numbers yet. Returns how many. */
static size_t find_parts(search *s, const part *whole) {
    size_t count = 0;
    for (size_t i = whole->bits; i < whole->end_bits; i++) {
        int32_t bit = s->members[i];
        s->roots[bit] = bit;
        s->numbers[bit] = -1;
        s->weights[bit] = 0;
    }
    for (size_t i = whole->clauses; i < whole->end_clauses; i++)
        s->rests[i] = look_at(s, s->places[i]);
    s->steps += (double)(whole->end_clauses - whole->clauses + whole->end_bits - whole->bits);
    for (size_t i = whole->bits; i < whole->end_bits; i++) {
        int32_t bit = s->members[i], root = root_of(s, bit);
        if (s->values[bit] != 0)
            continue;
        if (s->numbers[root] < 0) {
            s->found[count] = (part){.bit = bit, .number = (int32_t)count};
            s->numbers[root] = (int32_t)count++;
        }
        part *p = &s->found[s->numbers[root]];
        p->end_bits++;
        add_to_key(&p->key, (uint64_t)bit);
        int32_t more = s->weights[bit] - s->weights[p->bit];
        if (more > 0 || (more == 0 && bit < p->bit))
            p->bit = bit;
    }
    for (size_t i = whole->clauses; i < whole->end_clauses; i++) {
        const rest *r = &s->rests[i];
        if (r->bit < 0)
            continue;
        part *p = &s->found[s->numbers[root_of(s, r->bit)]];
        p->end_clauses++;
        add_to_key(&p->key, (uint64_t)(r->clause + 1) << 32 | r->value);
    }
    return count;
}

/* Puts the free bits of a part in front, by the parts they fall into, and clauses that are not
 * settled likewise. Returns where those bits end. */
static size_t split(search *s, const part *whole) {
    size_t count = find_parts(s, whole), bits = whole->bits, clauses = whole->clauses,
           end = whole->end_bits - whole->bits;
    qsort(s->found, count, sizeof *s->found, compare_parts);
    size_t *next_bit = s->ends, *next_clause = s->ends + count + 1;
    for (size_t i = 0; i < count; i++) {
        part p = s->found[i];
        p.bits = bits, p.clauses = clauses;
        next_bit[p.number] = bits, next_clause[p.number] = clauses;
        p.end_bits = bits += p.end_bits;
        p.end_clauses = clauses += p.end_clauses;
        s->parts[p.bits] = p;
    }
    next_bit[count] = bits, next_clause[count] = clauses; /* of what is settled */
    if (end > 0)
        memcpy(s->bits, s->members + whole->bits, end * sizeof *s->bits);
    for (size_t i = 0; i < end; i++) {
        int32_t bit = s->bits[i];
        size_t p = s->values[bit] ? count : (size_t)s->numbers[root_of(s, bit)];
        s->members[next_bit[p]++] = bit;
    }
    for (size_t i = whole->clauses; i < whole->end_clauses; i++) {
        const rest *r = &s->rests[i];
        size_t p = r->bit < 0 ? count : (size_t)s->numbers[root_of(s, r->bit)];
        s->places[next_clause[p]++] = r->clause;
    }
    return bits;
}

/* ---- telling how far it is ---------------------------------------------------------------- */

/* Steps between two calls: about a millisecond. */
#define STEPS_OF_A_CALL 65536

/* How far the steps of one part have come nobody knows: each that is told of goes a hundredth of
 * the way that is left of the part's share. */
static kg_status tell(search *s, double *fraction) {
    if (s->steps - s->told < STEPS_OF_A_CALL)
        return KG_OK;
    s->told = s->steps;
    *fraction += (1 - *fraction) / 100;
    kg_progress progress = kg_progress_of_share(&s->share);
    return kg_progress_tell(&progress, *fraction, "layers", s->error);
}

/* ---- counting --------------------------------------------------------------------------- */

static bool open_part(search *s, const part *p, double limit, bool first) {
    return kg_push(&s->tallies,
                   ((tally){.part = *p, .trail = s->trail_count, .limit = limit, .first = first}));
}

static record *record_of(const search *s, part_key key) {
    return &s->records[key.low & (RECORDS - 1)];
}

/* The count of a part, when it is known well enough. */
static const record *recall(const search *s, const part *p, double limit, bool first) {
    const record *r = record_of(s, p->key);
    bool same = r->used && r->key.low == p->key.low && r->key.high == p->key.high;
    return same && (!first || r->ways == 0) && (!r->more || r->ways >= limit) ? r : NULL;
}

/* One part of a part is counted. */
static void multiply(tally *whole, double ways, bool more) {
    whole->product = fmin(whole->product * ways, DBL_MAX);
    whole->most |= more;
}

/* All parts of a part are counted. */
static void add_ways(search *s, tally *c) {
    for (size_t i = c->trail; c->first && i < s->trail_count; i++)
        s->first[s->trail[i]] = s->values[s->trail[i]];
    c->first = false;
    c->more |= c->most;
    c->ways = fmin(c->ways + c->product, DBL_MAX);
}

/* Counts the ways of a part, up to `limit`, and keeps the first when it is asked for. When the
 * steps are over before there is any, `*out_ways` is 0 and `*out_more` true. */
static kg_status count_ways(search *s, const part *whole, double limit, double most_steps,
                            bool first, double *out_ways, bool *out_more) {
    double fraction = 0;
    if (!open_part(s, whole, limit, first))
        return KG_ERR_MEMORY;
    while (s->tallies.count > 0) {
        kg_status status = tell(s, &fraction);
        if (status)
            return status;
        tally *c = &s->tallies.items[s->tallies.count - 1];
        if (c->next < c->end && c->product > 0) {
            const part *p = &s->parts[c->next];
            double most = (c->limit - c->ways) / c->product;
            const record *known = recall(s, p, most, c->first);
            c->next = p->end_bits;
            if (known)
                multiply(c, known->ways, known->more);
            else if (!open_part(s, p, most, c->first))
                return KG_ERR_MEMORY;
            continue;
        }
        if (c->tried > 0 && c->product > 0)
            add_ways(s, c);
        undo(s, c->trail);
        bool over = s->steps > most_steps,
             enough = c->tried < 2 && ((c->ways > 0 && c->ways >= c->limit) || over);
        if (enough || c->tried == 2) {
            c->more |= enough;
            *out_ways = c->ways;
            *out_more = c->more;
            if (!over)
                *record_of(s, c->part.key) = (record){c->part.key, c->ways, true, c->more};
            if (--s->tallies.count > 0) {
                tally *up = &s->tallies.items[s->tallies.count - 1];
                multiply(up, *out_ways, *out_more);
                up->more |= over;
            }
            continue;
        }
        assign(s, 2 * c->part.bit + c->tried++);
        c->product = propagate(s);
        c->next = c->end = c->part.bits;
        c->most = false;
        if (c->product > 0)
            c->end = split(s, &c->part);
    }
    return KG_OK;
}

/* ---- all -------------------------------------------------------------------------------- */

/* First a way of every component, then how many there are. */
static kg_status search_parts(search *s, const part *components, size_t count, size_t trail,
                              kg_layer_report *r) {
    double ways, each = 0.5 / (double)(count + 1);
    bool more;
    for (size_t i = 0; i < count; i++) {
        s->share.from = (double)i * each, s->share.to = s->share.from + each;
        kg_status status = count_ways(s, &components[i], 1, r->most_steps, true, &ways, &more);
        if (status)
            return status;
        if (ways == 0)
            return more ? kg_fail(s->error, KG_ERR_CANCELLED,
                                  "the order of layers was neither found nor excluded in %g steps",
                                  r->most_steps)
                        : KG_ERR_INPUT;
    }
    r->states = 1;
    for (size_t i = 0; i < count; i++) {
        s->share.from = 0.5 + (double)i * each, s->share.to = s->share.from + each;
        kg_status status =
            count_ways(s, &components[i], r->most_states, r->most_steps, false, &ways, &more);
        if (status)
            return status;
        r->states = fmin(r->states * fmax(ways, 1), DBL_MAX);
        r->exact &= !more;
    }
    undo(s, trail);
    for (size_t i = 0; i < count; i++)
        for (size_t k = components[i].bits; k < components[i].end_bits; k++)
            s->values[s->members[k]] = s->first[s->members[k]];
    return KG_OK;
}

static kg_status search_all(search *s, const int32_t *links, size_t bits, size_t clauses,
                            kg_layer_report *r) {
    part whole = {.end_clauses = clauses};
    for (size_t i = 0; i < bits; i++)
        if (s->values[i] != 0)
            s->trail[s->trail_count++] = (int32_t)i;
        else if (links[i] >> 1 == (int32_t)i)
            s->members[whole.end_bits++] = (int32_t)i;
    for (size_t i = 0; i < clauses; i++)
        s->places[i] = (int32_t)i;
    r->states = 0;
    r->components = 0;
    r->exact = true;
    if (!propagate(s))
        return KG_ERR_INPUT;
    size_t end = split(s, &whole);
    for (size_t i = 0; i < end; i = s->parts[i].end_bits)
        r->components++;
    part *components = malloc((r->components + 1) * sizeof *components);
    if (!components)
        return KG_ERR_MEMORY;
    size_t count = 0;
    for (size_t i = 0; i < end; i = s->parts[i].end_bits)
        components[count++] = s->parts[i];
    kg_status status = search_parts(s, components, count, s->trail_count, r);
    free(components);
    return status;
}

kg_status kg_search(kg_clauses *clauses, const int32_t *links, size_t bits, signed char *values,
                    const kg_progress *progress, kg_layer_report *report, kg_error *error) {
    tidy(clauses);
    size_t n = bits + 1, m = clauses->count + 1;
    search s = {.clauses = clauses->items,
                .values = values,
                .share = {progress, 0, 1},
                .error = error,
                .trail = malloc(n * sizeof *s.trail),
                .members = malloc(n * sizeof *s.members),
                .places = malloc(m * sizeof *s.places),
                .parts = malloc(n * sizeof *s.parts),
                .first = calloc(n, 1),
                .records = calloc(RECORDS, sizeof *s.records),
                .roots = malloc(n * sizeof *s.roots),
                .numbers = malloc(n * sizeof *s.numbers),
                .weights = malloc(n * sizeof *s.weights),
                .rests = malloc(m * sizeof *s.rests),
                .found = malloc(n * sizeof *s.found),
                .ends = malloc(2 * n * sizeof *s.ends),
                .bits = malloc(n * sizeof *s.bits)};
    kg_status status = KG_ERR_MEMORY;
    if (s.trail && s.members && s.places && s.parts && s.first && s.records && s.roots &&
        s.numbers && s.weights && s.rests && s.found && s.ends && s.bits)
        status = index_uses(&s, clauses, bits);
    if (!status)
        status = search_all(&s, links, bits, clauses->count, report);
    void *all[] = {s.starts, s.uses,    s.trail, s.members,      s.places,  s.parts,
                   s.first,  s.records, s.roots, s.numbers,      s.weights, s.rests,
                   s.found,  s.ends,    s.bits,  s.tallies.items};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
    return status;
}
