/* Which patches follow from the opening of the card. */
/*
 * All hinges but those of pyramids are parallel to x, so patches move within the yz section, and at
 * the standing card an upright patch has one speed along z (its slide) and speeds along y that
 * change evenly with z (its swing); a level patch slides along y and swings along z. A hinge of an
 * upright patch at y = a and a level one at z = b says that the slide of either is the swing of the
 * other there: nothing mixes slides with slides. What is known of back and base spreads: a known
 * swing gives every patch hinged to it its slide, slides known at two places give a swing, and
 * patches hinged to one patch in the same place slide alike.
 * What is left is linear equations: the slides of the patches hinged to one patch lie on its swing,
 * a straight line over their places. They are solved where they are few. Patches of which slide and
 * swing are known are stable. Eq. 6 moves points linearly, so this holds at every
 * opening.
 *
 * The four folds of a pyramid meet in its apex: to the two parents it is one more hinge there, and
 * its patches follow when its parents do.
 */
#include "oa/stability.h"

#include <stdlib.h>
#include <string.h>

/* Unknown slides that depend on each other are solved together up to so many; beyond that, patches
 * are called loose that only the equations could tell to be stable. */
enum { MOST_UNKNOWNS = 128 };

/* For arithmetic with remainders: whole numbers are told from zero by what is left modulo a prime
 * that divides none of the determinants in question (which are small, of sizes of cells). */
static const uint64_t prime = 2147483647;

typedef struct closure {
    kg_oa_stability *s;
    const kg_oa_neighbours *n;
    int *place;           /* plane of the first neighbour whose slide is known, -1: none */
    unsigned char *known; /* SLIDE, SWING */
    int *queue;           /* patch * 2, plus 1 for the swing */
    size_t count, done;
} closure;

enum { SLIDE = 1, SWING = 2 };

static bool slants(const closure *c, int patch) {
    return c->s->patches[patch].plane > KG_OA_FLOOR;
}

static void learn(closure *c, int patch, unsigned char what) {
    if (slants(c, patch) || (c->known[patch] & what))
        return;
    c->known[patch] |= what;
    c->queue[c->count++] = 2 * patch + (what == SWING);
}

/* The parent of a pyramid's patch: the one neighbour that does not slant. */
static int parent_of(const closure *c, int slanting) {
    for (size_t i = c->n->starts[slanting]; i < c->n->starts[slanting + 1]; i++)
        if (!slants(c, c->n->items[i]))
            return c->n->items[i];
    return -1;
}

/* The other parent of the pyramid whose patch is `slanting`. */
static int parent_beyond(const closure *c, int slanting) {
    for (size_t i = c->n->starts[slanting]; i < c->n->starts[slanting + 1]; i++)
        if (slants(c, c->n->items[i]))
            return parent_of(c, c->n->items[i]);
    return -1;
}

/* The patch a neighbour stands for: beyond a pyramid its other parent; -1: none. */
static int partner(const closure *c, size_t link) {
    int to = c->n->items[link];
    if (c->n->hinges[link] < 0) /* back and base need not be hinged */
        return -1;
    return slants(c, to) ? parent_beyond(c, to) : to;
}

/* Patch `to` is hinged to `from`, of which something became known. */
static void pass(closure *c, int from, int to, bool swing) {
    int plane = c->s->patches[from].plane_id;
    if (swing) {
        learn(c, to, SLIDE);
    } else if (c->place[to] < 0) {
        c->place[to] = plane;
        for (size_t i = c->n->starts[to]; i < c->n->starts[to + 1]; i++) {
            int other = partner(c, i);
            if (other >= 0 && c->s->patches[other].plane_id == plane)
                learn(c, other, SLIDE); /* hinged to it in the same place */
        }
    } else if (c->place[to] != plane) {
        learn(c, to, SWING);
    }
}

static void spread(closure *c) {
    for (; c->done < c->count; c->done++) {
        int from = c->queue[c->done] / 2;
        bool swing = c->queue[c->done] % 2 == 1;
        for (size_t i = c->n->starts[from]; i < c->n->starts[from + 1]; i++) {
            int to = partner(c, i);
            if (to >= 0)
                pass(c, from, to, swing);
        }
    }
}

/* ---- equations -------------------------------------------------------------------------- */

/* A connected set of unknown slides. */
typedef struct joint {
    int *index;   /* per patch: of its unknown slide, -1: none */
    bool *seen;   /* per patch: is it among the lines, or was it in those of another set? */
    int *members; /* patches by index */
    size_t count;
    int *lines; /* patches on whose swings these slides lie */
    size_t line_count;
    uint64_t *rows; /* per unknown: the equation it is solved by, or an empty one */
    uint64_t *row;  /* the equation that is added */
} joint;

static uint64_t inverse(uint64_t a) {
    uint64_t result = 1;
    for (uint64_t n = prime - 2; n > 0; n /= 2, a = a * a % prime)
        if (n % 2 == 1)
            result = result * a % prime;
    return result;
}

/* Takes `factor` times the equation solved by unknown `from` away from `row`. */
static void take_away(const joint *j, uint64_t *row, size_t from) {
    const uint64_t *other = j->rows + from * j->count;
    uint64_t factor = row[from];
    for (size_t k = 0; factor > 0 && k < j->count; k++)
        row[k] = (row[k] + (prime - factor) * other[k]) % prime;
}

static void add_equation(joint *j) {
    for (size_t v = 0; v < j->count; v++) {
        if (j->row[v] == 0)
            continue;
        if (j->rows[v * j->count + v] == 1) {
            take_away(j, j->row, v);
            continue;
        }
        uint64_t factor = inverse(j->row[v]);
        for (size_t k = 0; k < j->count; k++)
            j->rows[v * j->count + k] = j->row[k] * factor % prime;
        return;
    }
}

static void add_term(const closure *c, joint *j, int patch, int64_t factor) {
    if (c->known[patch] & SLIDE) /* it is zero */
        return;
    uint64_t *term = &j->row[j->index[patch]];
    *term = (*term + (uint64_t)(factor + (int64_t)prime)) % prime;
}

/* The slides of what is hinged to `patch` lie on one straight line over their places. */
static void add_line(const closure *c, joint *j, int patch) {
    int first = -1, second = -1;
    const kg_oa_patch *p = c->s->patches;
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = c->n->starts[patch]; i < c->n->starts[patch + 1]; i++) {
            int other = partner(c, i);
            if (other < 0)
                continue;
            if (first < 0)
                first = other;
            if (second < 0 && p[other].plane_id != p[first].plane_id)
                second = other;
            if (pass == 0 || other == first || other == second)
                continue;
            int64_t whole = second < 0 ? 1 : p[second].plane_id - p[first].plane_id;
            int64_t part = second < 0 ? 0 : p[other].plane_id - p[first].plane_id;
            memset(j->row, 0, j->count * sizeof *j->row);
            add_term(c, j, other, whole);
            add_term(c, j, first, part - whole);
            if (second >= 0)
                add_term(c, j, second, -part);
            add_equation(j);
        }
}

/* Gathers the unknowns that depend on that of `patch`, and the patches whose lines they lie on. */
static void gather(const closure *c, joint *j, int patch) {
    j->count = j->line_count = 0;
    j->members[j->count] = patch;
    j->index[patch] = (int)j->count++;
    for (size_t done = 0; done < j->count; done++)
        for (size_t i = c->n->starts[j->members[done]]; i < c->n->starts[j->members[done] + 1];
             i++) {
            int line = partner(c, i);
            if (line < 0 || j->seen[line] || (c->known[line] & SWING))
                continue;
            j->seen[line] = true;
            j->lines[j->line_count++] = line;
            for (size_t k = c->n->starts[line]; k < c->n->starts[line + 1]; k++) {
                int other = partner(c, k);
                if (other >= 0 && !(c->known[other] & SLIDE) && j->index[other] < 0) {
                    j->members[j->count] = other;
                    j->index[other] = (int)j->count++;
                }
            }
        }
}

/* Every unknown of a gathered set whose equation names no other one is known: zero. */
static bool solve(closure *c, joint *j) {
    size_t n = j->count;
    j->rows = calloc(n * n + n, sizeof *j->rows);
    if (!j->rows)
        return false;
    j->row = j->rows + n * n;
    for (size_t i = 0; i < j->line_count; i++)
        add_line(c, j, j->lines[i]);
    for (size_t v = n; v-- > 0;)
        for (size_t k = v + 1; k < n; k++)
            if (j->rows[v * n + k] > 0 && j->rows[k * n + k] == 1)
                take_away(j, j->rows + v * n, k);
    for (size_t v = 0; v < n; v++) {
        bool alone = j->rows[v * n + v] == 1;
        for (size_t k = 0; k < n && alone; k++)
            alone = k == v || j->rows[v * n + k] == 0;
        if (alone)
            learn(c, j->members[v], SLIDE);
    }
    free(j->rows);
    return true;
}

static bool solve_all(closure *c, joint *j) {
    size_t count = c->s->patch_count;
    memset(j->seen, 0, count * sizeof *j->seen);
    for (size_t i = 0; i < count; i++)
        j->index[i] = -1;
    for (size_t i = 0; i < count; i++) {
        if (slants(c, (int)i) || (c->known[i] & SLIDE) || j->index[i] >= 0)
            continue;
        gather(c, j, (int)i);
        if (j->count > 1 && j->count <= MOST_UNKNOWNS && !solve(c, j))
            return false;
    }
    return true;
}

/* ---- all -------------------------------------------------------------------------------- */

static void judge(closure *c) {
    c->s->loose_count = 0;
    for (size_t i = 0; i < c->s->patch_count; i++) {
        int patch = (int)i, a = patch, b = patch;
        if (slants(c, patch)) {
            a = parent_of(c, patch);
            b = parent_beyond(c, patch);
        }
        c->s->patches[i].stable =
            a >= 0 && b >= 0 && c->known[a] == (SLIDE | SWING) && c->known[b] == (SLIDE | SWING);
        c->s->loose_count += !c->s->patches[i].stable;
    }
}

/* What is known from the start: back and base, or the patches that are held. */
static void begin(closure *c, const unsigned char *held) {
    for (int i = 0; i < (int)c->s->patch_count; i++)
        if (held ? held[i] : i == c->s->back || i == c->s->base) {
            learn(c, i, SLIDE);
            learn(c, i, SWING);
        }
}

static bool close_rules(closure *c, joint *j, const unsigned char *held) {
    begin(c, held);
    spread(c);
    for (size_t before = 0; before < c->count;) {
        before = c->count;
        if (!solve_all(c, j))
            return false;
        spread(c);
    }
    judge(c);
    return true;
}

bool kg_oa_close(kg_oa_stability *s, const kg_oa_neighbours *neighbours,
                 const unsigned char *held) {
    size_t count = s->patch_count;
    closure c = {.s = s,
                 .n = neighbours,
                 .place = malloc(count * sizeof *c.place),
                 .known = calloc(count, 1),
                 .queue = malloc(2 * count * sizeof *c.queue)};
    joint j = {.index = malloc(count * sizeof *j.index),
               .seen = calloc(count, sizeof *j.seen),
               .members = malloc(count * sizeof *j.members),
               .lines = malloc(count * sizeof *j.lines)};
    bool done = c.place && c.known && c.queue && j.index && j.seen && j.members && j.lines;
    for (size_t i = 0; i < count && done; i++)
        c.place[i] = -1;
    done = done && close_rules(&c, &j, held);
    free(c.place);
    free(c.known);
    free(c.queue);
    free(j.index);
    free(j.seen);
    free(j.members);
    free(j.lines);
    return done;
}
