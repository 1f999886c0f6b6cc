/* Windows and thin tops, opened greedily where the card stays valid (section 3). */
#include "oa/reach.h"

#include <stdlib.h>

static bool asked_to_stop(const kg_progress *progress, double fraction, const char *what) {
    return progress && progress->call && !progress->call(progress->user, fraction, what);
}

/* Room for the search through a card's windows. */
typedef struct search {
    kg_oa_reach *reach;
    int32_t *places; /* of a column */
    int *tops;       /* per column: where the run of windows that holds the last one ends */
} search;

/* Tries the window at level z of column x, which is no window yet. */
static kg_status try_window(kg_oa *oa, search *s, int x, int z, kg_error *error) {
    bool valid;
    int z0 = z, depth;
    while (z0 > 0 && kg_oa_window(oa, x, z0 - 1))
        z0--;
    depth = kg_oa_depth(oa, x, z0);
    int first = kg_oa_front_row(oa, x, s->tops[x]), last = kg_oa_front_row(oa, x, z0);
    for (int k = 0; k <= last - first; k++)
        s->places[last - first - k] = kg_oa_pushed_place(depth, k);
    kg_status status = kg_oa_reach_try(s->reach, x, first, last, s->places, &valid, error);
    oa->window[x * oa->height + z] = !status && valid;
    return status;
}

static kg_status try_level(kg_oa *oa, search *s, const unsigned char *candidates, int z,
                           kg_error *error) {
    kg_status status = KG_OK;
    for (int x = 0; x < oa->width && !status; x++) {
        if (z + 1 == oa->height || !kg_oa_window(oa, x, z + 1))
            s->tops[x] = z;
        if (candidates[x * oa->height + z] && kg_oa_depth(oa, x, z) > 0 && !kg_oa_window(oa, x, z))
            status = try_window(oa, s, x, z, error);
    }
    return status;
}

kg_status kg_oa_open_windows(kg_oa *oa, const unsigned char *candidates,
                             const kg_progress *progress, kg_error *error) {
    search s = {.places = calloc((size_t)oa->height + (size_t)oa->depth_limit, sizeof *s.places),
                .tops = calloc((size_t)oa->width, sizeof *s.tops)};
    kg_status status = s.places && s.tops ? kg_oa_reach_create(oa, &s.reach, error)
                                          : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (int z = oa->height - 1; z >= 0 && !status; z--) {
        status = try_level(oa, &s, candidates, z, error);
        if (!status && asked_to_stop(progress, 1 - (double)z / oa->height, "windows"))
            status = kg_fail(error, KG_ERR_CANCELLED, "cancelled");
    }
    kg_oa_reach_destroy(s.reach);
    free(s.places);
    free(s.tops);
    return status;
}

/* ---- thin tops -------------------------------------------------------------------------- */

/* A top that may go; not one between two windows of a run, which takes it along. */
static bool is_thin(const kg_oa *oa, int x, int z, int limit) {
    int cells = kg_oa_top(oa, x, z);
    bool in_run = z < oa->height && kg_oa_window(oa, x, z) && kg_oa_window(oa, x, z - 1);
    return cells > 0 && cells <= limit && !in_run && !kg_oa_omitted(oa, x, z);
}

/* The height of the thin top above the front at depth y of a column, 0: there is none. */
static int thin_top_at(const kg_oa *oa, int x, int y, int limit) {
    if (x < 0 || x >= oa->width)
        return 0;
    for (int z = oa->height; z >= 1; z--)
        if (kg_oa_depth(oa, x, z - 1) >= y)
            return kg_oa_depth(oa, x, z - 1) == y && is_thin(oa, x, z, limit) ? z : 0;
    return 0;
}

/* Is it one of the tallest of the neighbouring thin tops above one front? */
static bool is_tallest(const kg_oa *oa, int x, int z, int limit) {
    int y = kg_oa_depth(oa, x, z - 1), other;
    for (int side = -1; side <= 1; side += 2)
        for (int to = x + side; (other = thin_top_at(oa, to, y, limit)) > 0; to += side)
            if (other > z)
                return false;
    return true;
}

static kg_status try_top(kg_oa *oa, kg_oa_reach *reach, int x, int z, int32_t *places,
                         kg_error *error) {
    int depth = z < oa->height ? kg_oa_depth(oa, x, z) : 0, cells = kg_oa_top(oa, x, z);
    int first = oa->height - z + depth;
    bool valid;
    for (int i = 0; i < cells; i++)
        places[i] = kg_oa_fallen_place(depth, z, i);
    kg_status status = kg_oa_reach_try(reach, x, first, first + cells - 1, places, &valid, error);
    if (!status && valid)
        oa->omitted[x * (oa->height + 1) + z] = 1;
    return status;
}

kg_status kg_oa_thin_tops(kg_oa *oa, int limit, kg_error *error) {
    size_t tops = (size_t)oa->width * ((size_t)oa->height + 1);
    kg_oa_reach *reach = NULL;
    unsigned char *keep = calloc(tops, 1);
    int32_t *places = calloc((size_t)oa->depth_limit + 1, sizeof *places);
    kg_status status = keep && places ? kg_oa_reach_create(oa, &reach, error)
                                      : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (int x = 0; x < oa->width && !status; x++)
        for (int z = 1; z <= oa->height; z++)
            keep[x * (oa->height + 1) + z] =
                !is_thin(oa, x, z, limit) || is_tallest(oa, x, z, limit);
    for (int z = 1; z <= oa->height && !status; z++)
        for (int x = 0; x < oa->width && !status; x++)
            if (!keep[x * (oa->height + 1) + z])
                status = try_top(oa, reach, x, z, places, error);
    kg_oa_reach_destroy(reach);
    free(keep);
    free(places);
    return status;
}
