/* Layer orders after a fold. */
#include "origami/condition.h"
#include "origami/convex.h"
#include "origami/folding.h"

#include <stdlib.h>

typedef struct landing {
    const kg_folding *folding;
    const kg_fold_parts *parts;
    kg_origami_state *after;
    kg_outlines outlines; /* of `after` */
    kg_layer_bits layers; /* of `after`: each pair in the row of its smaller loop */
    int32_t *resting;     /* loops that do not move */
    size_t resting_count;
    bool *upper; /* loops that the fold ends below, when it ends between two; else NULL */
    kg_error *error;
} landing;

static bool is_flat(const kg_fold_axis *a) {
    return fabs(fabs(a->angle) - KG_PI) < KG_LEAST_ANGLE;
}

static int32_t loop_before(const landing *l, int32_t loop) {
    return kg_loop_in(l->folding->state, l->after, loop);
}

/* b lies above (1) or below (-1) a */
static void put(landing *l, int32_t a, int32_t b, int above) {
    if (a < b)
        kg_layer_put(&l->layers, a, b, above);
    else
        kg_layer_put(&l->layers, b, a, -above);
}

/* ---- orders that stay ------------------------------------------------------------------- */

static void keep(landing *l, int32_t a, int32_t b, int side) {
    if (kg_outlines_overlap(&l->outlines, a, b, l->after->touch))
        put(l, a, b, side * l->outlines.facing[a]);
}

/* An order between two loops that stay or move together holds for their parts. */
static void keep_orders(landing *l) {
    const kg_origami_state *before = l->folding->state;
    const int32_t *children = l->parts->children;
    const bool *moves = l->parts->moves;
    for (size_t i = 0; i < before->orders.count; i++) {
        kg_layer_order o = before->orders.items[i];
        int32_t a = children[o.a], b = children[o.b];
        if (a < 0 && b < 0) {
            /* no branch: which loops move follows no pattern */
            uint64_t *row = kg_layer_row(&l->layers, o.a, o.side * l->outlines.facing[o.a]);
            row[o.b >> 6] |= (uint64_t)(moves[o.a] == moves[o.b]) << (o.b & 63);
            continue;
        }
        if (!moves[o.a] && !moves[o.b])
            keep(l, o.a, o.b, o.side);
        a = a < 0 ? o.a : a, b = b < 0 ? o.b : b;
        if (moves[a] && moves[b])
            keep(l, a, b, o.side);
    }
}

/* ---- between two layers ----------------------------------------------------------------- */

/* Adds to `upper` what lies above its loops or goes on flat from them. */
static kg_status spread_up(landing *l, const kg_layer_rows *rows, int32_t start) {
    const kg_origami_state *s = l->after;
    struct {
        int32_t *items;
        size_t count, capacity;
    } todo = {0};
    l->upper[start] = true;
    bool ok = kg_push(&todo, start);
    while (ok && todo.count > 0) {
        int32_t loop = todo.items[--todo.count], first = s->loops.items[loop].first, h = first;
        for (size_t k = rows->starts[loop]; k < rows->starts[loop + 1] && ok; k++) {
            int32_t other = kg_row_other(rows, k);
            if (kg_row_above(rows, k) != 1 || l->parts->moves[other] || l->upper[other])
                continue;
            l->upper[other] = true;
            ok = kg_push(&todo, other);
        }
        do {
            int32_t other = kg_loop_of(s, kg_twin(h));
            if (other < 0 || s->edges.items[h >> 1].angle != 0 || l->parts->moves[other] ||
                l->upper[other])
                continue;
            l->upper[other] = true;
            ok = ok && kg_push(&todo, other);
        } while ((h = kg_next(s, h)) != first);
    }
    free(todo.items);
    return ok ? KG_OK : KG_ERR_MEMORY;
}

static kg_status find_upper(landing *l, const int32_t between[2]) {
    kg_status written = kg_layer_bits_write(&l->layers, &l->outlines, l->after);
    if (written)
        return written;
    const kg_origami_state *s = l->after;
    size_t loops = l->folding->state->loops.count;
    for (int k = 0; k < 2; k++)
        if (between[k] < 0 || (size_t)between[k] >= loops)
            return kg_fail(l->error, KG_ERR_INPUT, "there is no face %d to go between", between[k]);
    if (!is_flat(&l->folding->axis))
        return kg_fail(l->error, KG_ERR_INPUT,
                       "only a flat fold, by 180 degrees, ends between faces");
    int order = kg_origami_order(s, between[0], between[1]) * l->outlines.facing[between[0]];
    if (order == 0 || l->parts->moves[between[0]] || l->parts->moves[between[1]] ||
        s->loops.items[between[0]].group != l->folding->axis.group)
        return kg_fail(l->error, KG_ERR_INPUT,
                       "faces %d and %d do not lie on each other where the fold ends", between[0],
                       between[1]);
    l->upper = calloc(s->loops.count + 1, sizeof *l->upper);
    kg_layer_rows rows;
    kg_status status = l->upper ? kg_layer_rows_create(s, &l->outlines, &rows) : KG_ERR_MEMORY;
    if (status)
        return status;
    status = spread_up(l, &rows, between[order > 0]);
    kg_layer_rows_clear(&rows);
    if (!status && l->upper[between[order < 0]])
        return kg_fail(l->error, KG_ERR_INPUT, "faces %d and %d are joined: nothing goes between",
                       between[0], between[1]);
    return status;
}

/* ---- orders that are new ---------------------------------------------------------------- */

static kg_vec2 middle(const kg_vec2 *p, size_t n) {
    kg_vec2 sum = kg_v2(0, 0);
    for (size_t i = 0; i < n; i++)
        sum = kg_add2(sum, p[i]);
    return kg_scale2(sum, 1 / (double)n);
}

/* How a moving loop arrives at a point of its plane: 1 from above, -1 from below, 0 along it. */
static int arrival_at(const landing *l, int32_t moving, kg_vec2 at) {
    const kg_face_group *g = &l->after->groups.items[l->after->loops.items[moving].group];
    kg_vec3 u, v;
    kg_plane_axes(g->normal, &u, &v);
    kg_vec3 p =
        kg_add(kg_scale(g->normal, g->offset), kg_add(kg_scale(u, at.x), kg_scale(v, at.y)));
    double towards = kg_dot(kg_fold_velocity(&l->folding->axis, p), g->normal);
    return towards < -l->after->touch ? 1 : towards > l->after->touch ? -1 : 0;
}

/* The same at the part that it has in common with one at rest. */
static kg_status arrival(const landing *l, int32_t moving, int32_t resting, int *out_above) {
    const kg_outlines *o = &l->outlines;
    kg_vec2 at = o->middles[moving];
    size_t na = kg_outline_size(o, moving), nb = kg_outline_size(o, resting);
    kg_vec2 *scratch = malloc(2 * (na + nb + 2) * sizeof *scratch);
    if (!scratch)
        return KG_ERR_MEMORY;
    size_t n = kg_convex_common(kg_outline_points(o, moving), na, kg_outline_points(o, resting), nb,
                                scratch, scratch + na + nb + 2);
    if (n > 0)
        at = middle(scratch, n);
    free(scratch);
    *out_above = arrival_at(l, moving, at);
    return KG_OK;
}

/* Orders of one moving loop with all at rest in its group. `*inserted` when it comes to lie between
 * the two chosen loops. */
static kg_status land_loop(landing *l, int32_t moving, const int32_t between[2], bool *inserted,
                           bool *elsewhere) {
    const kg_origami_state *s = l->after;
    const kg_fold_axis *a = &l->folding->axis;
    int32_t group = s->loops.items[moving].group;
    const kg_face_group *g = &s->groups.items[group];
    bool through_axis = fabs(kg_dot(g->normal, a->axis)) < KG_ON_PLANE &&
                        fabs(kg_dot(g->normal, a->origin) - g->offset) < KG_ON_PLANE * s->size;
    bool own = is_flat(a) && group == a->group &&
               l->folding->state->loops.items[loop_before(l, moving)].group == a->group;
    /* in a plane through the axis it arrives the same way everywhere */
    int common = through_axis ? arrival_at(l, moving, l->outlines.middles[moving]) : 0;
    for (size_t i = 0; i < l->resting_count; i++) {
        int32_t resting = l->resting[i];
        if (s->loops.items[resting].group != group ||
            !kg_outlines_overlap(&l->outlines, moving, resting, s->touch))
            continue;
        int above = common;
        kg_status status = through_axis ? KG_OK : arrival(l, moving, resting, &above);
        if (status)
            return status;
        if (own && l->upper) {
            above = l->upper[resting] ? -1 : 1;
            *inserted |= resting == between[0] || resting == between[1];
        } else if (above == 0) { /* it slid: an old order holds */
            int32_t old = loop_before(l, resting);
            above = kg_origami_order(l->folding->state, old, loop_before(l, moving)) *
                    l->outlines.facing[resting];
            if (above == 0)
                return kg_fail(l->error, KG_ERR_INPUT,
                               "face %d would slide edge on into face %d, in its plane",
                               loop_before(l, moving), old);
        }
        *elsewhere |= !own;
        put(l, resting, moving, above);
    }
    return KG_OK;
}

kg_status kg_fold_land(const kg_folding *folding, const kg_fold *fold, const kg_fold_parts *parts,
                       kg_origami_state *after, kg_error *error) {
    landing l = {.folding = folding, .parts = parts, .after = after, .error = error};
    bool inserts = fold->between[0] >= 0 || fold->between[1] >= 0, inserted = false,
         elsewhere = false;
    kg_status status = kg_outlines_create(after, &l.outlines);
    if (!status)
        status = kg_layer_bits_create(after->loops.count, &l.layers);
    l.resting = malloc((after->loops.count + 1) * sizeof *l.resting);
    if (!l.resting)
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < after->loops.count && !status; i++)
        if (!parts->moves[i])
            l.resting[l.resting_count++] = (int32_t)i;
    if (!status) {
        kg_outlines_probe(&l.outlines, after);
        keep_orders(&l);
    }
    if (!status && inserts)
        status = find_upper(&l, fold->between);
    for (size_t i = 0; i < after->loops.count && !status; i++)
        if (parts->moves[i])
            status = land_loop(&l, (int32_t)i, fold->between, &inserted, &elsewhere);
    if (!status && inserts && !inserted)
        status = kg_fail(error, KG_ERR_INPUT, "the fold does not end between faces %d and %d",
                         fold->between[0], fold->between[1]);
    if (!status)
        status = kg_layer_bits_write(&l.layers, &l.outlines, after);
    /* the rules of what moves keep layers from crossing, but not where they go between others or
     * meet those of other planes */
    if (!status && (inserts || elsewhere))
        status = kg_layers_check(after, &l.outlines, error);
    kg_outlines_clear(&l.outlines);
    kg_layer_bits_clear(&l.layers);
    free(l.resting);
    free(l.upper);
    return status;
}
