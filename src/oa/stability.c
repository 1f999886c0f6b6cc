/* The graph of patches, and which of them hang on a single one. */
#include "oa/stability.h"

#include <stdlib.h>
#include <string.h>

/* ---- neighbours ------------------------------------------------------------------------- */

kg_status kg_oa_neighbours_create(const kg_oa_stability *s, bool extra, kg_oa_neighbours *out,
                                  kg_error *error) {
    size_t n = s->patch_count, links = 2 * (s->hinge_count + 1);
    kg_oa_neighbours made = {.starts = calloc(n + 2, sizeof *made.starts),
                             .items = calloc(links, sizeof *made.items),
                             .hinges = calloc(links, sizeof *made.hinges)};
    if (!made.starts || !made.items || !made.hinges) {
        kg_oa_neighbours_clear(&made);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    /* counted two places on, so that filling in moves every start to its own place */
    size_t *fill = made.starts + 1;
    if (extra)
        fill[s->back + 1]++, fill[s->base + 1]++;
    for (size_t i = 0; i < s->hinge_count; i++)
        fill[s->hinges[i].patches[0] + 1]++, fill[s->hinges[i].patches[1] + 1]++;
    for (size_t p = 1; p <= n; p++)
        fill[p] += fill[p - 1];
    int ends[2] = {s->back, s->base};
    for (int64_t i = extra ? -1 : 0; i < (int64_t)s->hinge_count; i++) {
        const int *pair = i < 0 ? ends : s->hinges[i].patches;
        for (int k = 0; k < 2; k++) {
            size_t at = fill[pair[k]]++;
            made.items[at] = pair[1 - k];
            made.hinges[at] = (int)i;
        }
    }
    *out = made;
    return KG_OK;
}

void kg_oa_neighbours_clear(kg_oa_neighbours *n) {
    free(n->starts);
    free(n->items);
    free(n->hinges);
}

/* ---- flaps ---------------------------------------------------------------------------- */

typedef struct search {
    const kg_oa_neighbours *n;
    int *found, *low, *parent; /* found: from 1 in the order of discovery, 0: not yet */
    size_t *next;              /* neighbour to look at */
    int *order;
    size_t count;
} search;

/* Depth-first search from `root`: Tarjan's lowest discovery reachable by one edge back. */
static void search_from(search *f, int root) {
    int at = root;
    f->order[f->count] = root;
    f->found[root] = f->low[root] = (int)++f->count;
    f->parent[root] = -1;
    while (at >= 0) {
        if (f->next[at] == f->n->starts[at + 1]) {
            int up = f->parent[at];
            if (up >= 0 && f->low[at] < f->low[up])
                f->low[up] = f->low[at];
            at = up;
            continue;
        }
        int to = f->n->items[f->next[at]++];
        if (!f->found[to]) {
            f->parent[to] = at;
            f->order[f->count] = to;
            f->found[to] = f->low[to] = (int)++f->count;
            at = to;
        } else if (to != f->parent[at] && f->found[to] < f->low[at]) {
            f->low[at] = f->found[to];
        }
    }
}

/* Flaps are all patches outside the biconnected component of the edge back-base. The search starts
 * in the back and goes to the base first, so that component is the base and everything below it
 * that no patch but the back cuts off. */
static void mark_flaps(kg_oa_stability *s, search *f) {
    search_from(f, s->back);
    for (size_t i = 0; i < s->patch_count; i++)
        s->patches[i].flap = true;
    s->patches[s->back].flap = s->patches[s->base].flap = false;
    for (size_t i = 0; i < f->count; i++) {
        int v = f->order[i], up = f->parent[v];
        if (up >= 0 && up != s->back && !s->patches[up].flap && f->low[v] < f->found[up])
            s->patches[v].flap = false;
    }
}

/* ---- the whole ------------------------------------------------------------------------------- */

static bool find_flaps(kg_oa_stability *s, const kg_oa_neighbours *n) {
    size_t count = s->patch_count;
    int *numbers = calloc(count, 4 * sizeof *numbers);
    size_t *next = malloc(count * sizeof *next);
    bool done = numbers && next;
    if (done) {
        memcpy(next, n->starts, count * sizeof *next);
        search f = {.n = n,
                    .found = numbers,
                    .low = numbers + count,
                    .parent = numbers + 2 * count,
                    .order = numbers + 3 * count,
                    .next = next};
        mark_flaps(s, &f);
    }
    free(numbers);
    free(next);
    return done;
}

kg_status kg_oa_stability_create(const kg_oa_sheet *sheet, kg_oa_stability **out_stability,
                                 kg_error *error) {
    kg_oa_stability *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_oa_neighbours n = {0};
    kg_status status = kg_oa_patches_map(sheet, s, error);
    if (!status)
        status = kg_oa_neighbours_create(s, true, &n, error);
    if (!status && !(kg_oa_close(s, &n, NULL) && find_flaps(s, &n)))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_oa_neighbours_clear(&n);
    if (status)
        kg_oa_stability_destroy(s);
    else
        *out_stability = s;
    return status;
}

void kg_oa_stability_destroy(kg_oa_stability *stability) {
    if (!stability)
        return;
    free(stability->patches);
    free(stability->patch_of);
    free(stability->hinges);
    free(stability);
}
