/*
 * Degrees of freedom of the open card. Around every closed chain of patches the turns about its
 * hinges must add up to no motion: sum of w_h a_h = 0 and of w_h a_h x p_h = 0, with the hinge's
 * speed w_h, its axis a_h and a point p_h on it. What the equations of independent loops leave free
 * is the mobility. Coordinates are those of the standing card in thirds, so whole numbers. Where
 * all hinges are parallel (no pyramids) the rank is the same at every opening, since eq. 6 moves
 * points linearly.
 */
#include "oa/stability.h"

#include <stdlib.h>
#include <string.h>

/* The rank over the whole numbers is the largest modulo any prime, and smaller only modulo primes
 * that divide all its largest minors; two of 31 bits leave no practical doubt. */
static const uint64_t primes[2] = {2147483647, 2147483629};

typedef struct equations {
    size_t rows, columns;
    uint64_t *at;
    int64_t *equations;
} equations;

static uint64_t power(uint64_t a, uint64_t n, uint64_t p) {
    uint64_t result = 1;
    for (; n > 0; n /= 2, a = a * a % p)
        if (n % 2 == 1)
            result = result * a % p;
    return result;
}

static size_t rank_modulo(equations *e, uint64_t p) {
    size_t rank = 0;
    for (size_t i = 0; i < e->rows * e->columns; i++) {
        int64_t r = e->equations[i] % (int64_t)p;
        e->at[i] = (uint64_t)(r < 0 ? r + (int64_t)p : r);
    }
    for (size_t c = 0; c < e->columns && rank < e->rows; c++) {
        size_t pivot = rank;
        while (pivot < e->rows && e->at[pivot * e->columns + c] == 0)
            pivot++;
        if (pivot == e->rows)
            continue;
        for (size_t k = c; k < e->columns; k++) {
            uint64_t swap = e->at[pivot * e->columns + k];
            e->at[pivot * e->columns + k] = e->at[rank * e->columns + k];
            e->at[rank * e->columns + k] = swap;
        }
        const uint64_t *top = e->at + rank * e->columns;
        uint64_t inverse = power(top[c], p - 2, p);
        for (size_t r = rank + 1; r < e->rows; r++) {
            uint64_t *row = e->at + r * e->columns, factor = row[c] * inverse % p;
            for (size_t k = c; factor > 0 && k < e->columns; k++)
                row[k] = (row[k] + (p - factor) * top[k]) % p;
        }
        rank++;
    }
    return rank;
}

/* Three times the place of a point on the standing card. */
static void stand(const kg_oa_tuple *t, int64_t out[3]) {
    out[0] = 3 * t->v[0] + t->v[3] + t->v[4];
    out[1] = 3 * t->v[1] + 2 * t->v[3] - 2 * t->v[4];
    out[2] = 3 * t->v[2] + 2 * t->v[3] - 2 * t->v[4];
}

/* Adds the hinge's turn to the six equations of a loop that passes it from `from`. */
static void pass(equations *e, size_t loop, const kg_oa_stability *s, int hinge, int from) {
    const kg_oa_hinge *h = &s->hinges[hinge];
    int64_t p[3], q[3], six[6], sign = h->patches[0] == from ? 1 : -1;
    stand(&h->ends[0], p);
    stand(&h->ends[1], q);
    for (int i = 0; i < 3; i++)
        six[i] = q[i] - p[i];
    for (int i = 0; i < 3; i++)
        six[3 + i] = six[(i + 1) % 3] * p[(i + 2) % 3] - six[(i + 2) % 3] * p[(i + 1) % 3];
    for (size_t i = 0; i < 6; i++)
        e->equations[(6 * loop + i) * e->columns + (size_t)hinge] += sign * six[i];
}

typedef struct tree {
    int *parent, *hinge, *level; /* level 0: not reached yet, roots have 1 */
    int *queue;
} tree;

/* A spanning forest, breadth first; returns the number of its trees. */
static size_t grow(const kg_oa_stability *s, const kg_oa_neighbours *n, tree *t) {
    size_t trees = 0, count = 0;
    for (size_t root = 0; root < s->patch_count; root++) {
        if (t->level[root])
            continue;
        trees++;
        t->level[root] = 1;
        t->parent[root] = t->hinge[root] = -1;
        t->queue[count] = (int)root;
        for (size_t done = count++; done < count; done++) {
            int p = t->queue[done];
            for (size_t i = n->starts[p]; i < n->starts[p + 1]; i++) {
                int q = n->items[i];
                if (t->level[q])
                    continue;
                t->level[q] = t->level[p] + 1;
                t->parent[q] = p;
                t->hinge[q] = n->hinges[i];
                t->queue[count++] = q;
            }
        }
    }
    return trees;
}

/* One loop for each hinge outside the forest: across it and back through the tree. */
static void write_loops(equations *e, const kg_oa_stability *s, const tree *t) {
    size_t loop = 0;
    for (size_t i = 0; i < s->hinge_count; i++) {
        int p = s->hinges[i].patches[0], q = s->hinges[i].patches[1];
        if (t->hinge[p] == (int)i || t->hinge[q] == (int)i)
            continue;
        pass(e, loop, s, (int)i, p);
        while (p != q) {
            if (t->level[q] >= t->level[p]) { /* on from q towards the root */
                pass(e, loop, s, t->hinge[q], q);
                q = t->parent[q];
            } else { /* and down again to where the loop began */
                pass(e, loop, s, t->hinge[p], t->parent[p]);
                p = t->parent[p];
            }
        }
        loop++;
    }
}

static bool count_degrees(const kg_oa_stability *s, const kg_oa_neighbours *n, int *out) {
    int *numbers = calloc(s->patch_count, 4 * sizeof *numbers);
    if (!numbers)
        return false;
    size_t p = s->patch_count;
    tree t = {numbers, numbers + p, numbers + 2 * p, numbers + 3 * p};
    size_t trees = grow(s, n, &t);
    equations e = {.rows = 6 * (s->hinge_count + trees - p), .columns = s->hinge_count};
    size_t size = e.rows * e.columns + 1;
    e.at = calloc(size, sizeof *e.at);
    e.equations = calloc(size, sizeof *e.equations);
    bool done = e.at && e.equations;
    if (done) {
        write_loops(&e, s, &t);
        size_t a = rank_modulo(&e, primes[0]), b = rank_modulo(&e, primes[1]);
        *out = (int)(s->hinge_count - (a > b ? a : b) + 6 * (trees - 1));
    }
    free(e.at);
    free(e.equations);
    free(numbers);
    return done;
}

kg_status kg_oa_mobility(const kg_oa_stability *stability, int *out_degrees, kg_error *error) {
    if (stability->hinge_count > KG_OA_MOBILITY_HINGES) {
        *out_degrees = -1;
        return KG_OK;
    }
    kg_oa_neighbours n;
    kg_status status = kg_oa_neighbours_create(stability, false, &n, error);
    if (status)
        return status;
    if (!count_degrees(stability, &n, out_degrees))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_oa_neighbours_clear(&n);
    return status;
}
