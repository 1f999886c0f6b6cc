/* Layer orders after a fold. */
#include "origami/condition.h"
#include "origami/convex.h"
#include "origami/folding.h"
#include "origami/overlap.h"

#include <stdlib.h>
#include <string.h>

typedef struct landing {
    const kg_folding *folding;
    const kg_fold_parts *parts;
    kg_origami_state *after;
    kg_outlines outlines; /* of `after` */
    kg_overlaps overlaps;
    bool inserts;   /* it ends between two layers */
    bool elsewhere; /* paper comes to lie on other paper beside the fold's own plane */
    /* rows of bits, of loops after */
    uint64_t *moving, *resting;
    uint64_t *own;    /* that move, and were and are in the fold's own plane */
    uint64_t *raised; /* that move and come from above wherever they lie on others */
    uint64_t *single; /* that move and have to be looked at with each that they lie on */
    uint64_t *upper;  /* that the fold ends below, when it ends between two */
    uint64_t *wanted[2], *found;
    /* of loops before */
    uint64_t *whole[2]; /* not cut: that rest, that move */
    uint64_t *cut;
    kg_error *error;
} landing;

static bool is_flat(const kg_fold_axis *a) {
    return fabs(fabs(a->angle) - KG_PI) < KG_LEAST_ANGLE;
}

static int32_t loop_before(const landing *l, int32_t loop) {
    return kg_loop_in(l->folding->state, l->after, loop);
}

/* ---- orders that stay ------------------------------------------------------------------- */

/* An order between two loops that stay or move together holds for their parts: at once for those
 * that are whole, for the others when they overlap. Fills in a row, of what was cut only the bits
 * behind the loop's own. */
static void keep_orders(landing *l, int32_t loop) {
    const kg_origami_state *before = l->folding->state;
    const int32_t *children = l->parts->children;
    bool moves = l->parts->moves[loop];
    int32_t old = loop_before(l, loop);
    bool whole = children[old] < 0;
    size_t words = before->layers.words, first = (size_t)loop / 64;
    for (int k = 0; k < 2; k++) {
        const uint64_t *from = kg_layer_row(before, old, 2 * k - 1);
        uint64_t *to = kg_layer_row(l->after, loop, 2 * k - 1);
        memset(l->wanted[k], 0, l->after->layers.words * sizeof *l->wanted[k]);
        for (size_t w = 0; w < words; w++) {
            uint64_t same = from[w] & l->whole[moves][w], parts = from[w] & l->cut[w];
            *(whole ? &to[w] : &l->wanted[k][w]) |= same;
            if (!moves)
                l->wanted[k][w] |= parts;
            else
                while (parts != 0)
                    kg_bit_set(l->wanted[k], children[64 * w + (size_t)kg_bit_next(&parts)]);
        }
        l->wanted[k][first] &= ~(uint64_t)1 << (loop & 63);
    }
    uint64_t *back = kg_layer_row(l->after, loop, -1), *front = kg_layer_row(l->after, loop, 1);
    for (size_t w = first; w < l->after->layers.words; w++)
        l->found[w] = l->wanted[0][w] | l->wanted[1][w];
    kg_overlaps_find(&l->overlaps, loop, l->found, first, l->found);
    for (size_t w = first; w < l->after->layers.words; w++) {
        back[w] |= l->found[w] & l->wanted[0][w];
        front[w] |= l->found[w] & l->wanted[1][w];
    }
}

/* ---- between two layers ----------------------------------------------------------------- */

typedef struct stack {
    int32_t *items;
    size_t count, capacity;
} stack;

static bool raise(landing *l, stack *todo, int32_t loop) {
    kg_bit_set(l->upper, loop);
    return kg_push(todo, loop);
}

/* Adds to `upper` what lies above its loops or goes on flat from them. */
static kg_status spread_up(landing *l, int32_t start) {
    const kg_origami_state *s = l->after;
    stack todo = {0};
    bool ok = raise(l, &todo, start);
    while (ok && todo.count > 0) {
        int32_t loop = todo.items[--todo.count], first = s->loops.items[loop].first, h = first;
        const uint64_t *row = kg_layer_pile(s, &l->outlines, loop, 1);
        for (size_t w = 0; w < s->layers.words; w++)
            for (uint64_t more = row[w] & l->resting[w] & ~l->upper[w]; ok && more != 0;)
                ok = raise(l, &todo, (int32_t)(64 * w) + kg_bit_next(&more));
        do {
            int32_t other = kg_loop_of(s, kg_twin(h));
            if (ok && other >= 0 && s->edges.items[h >> 1].angle == 0 && !l->parts->moves[other] &&
                !kg_bit_at(l->upper, other))
                ok = raise(l, &todo, other);
        } while ((h = kg_next(s, h)) != first);
    }
    free(todo.items);
    return ok ? KG_OK : KG_ERR_MEMORY;
}

static kg_status find_upper(landing *l, const int32_t between[2]) {
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
    kg_status status = spread_up(l, between[order > 0]);
    if (!status && kg_bit_at(l->upper, between[order < 0]))
        return kg_fail(l->error, KG_ERR_INPUT, "faces %d and %d are joined: nothing goes between",
                       between[0], between[1]);
    return status;
}

/* Whether something that moves in the fold's own plane came to lie on one of the two. */
static bool is_inserted(const landing *l, const int32_t between[2]) {
    uint64_t any = 0;
    for (int k = 0; k < 2; k++)
        for (size_t w = 0; w < l->after->layers.words; w++)
            any |= l->own[w] & (kg_layer_row(l->after, between[k], 1)[w] |
                                kg_layer_row(l->after, between[k], -1)[w]);
    return any != 0;
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

/* Its plane holds the axis: it arrives the same way everywhere. */
static bool is_through_axis(const landing *l, int32_t loop) {
    const kg_origami_state *s = l->after;
    const kg_fold_axis *a = &l->folding->axis;
    const kg_face_group *g = &s->groups.items[s->loops.items[loop].group];
    return fabs(kg_dot(g->normal, a->axis)) < KG_ON_PLANE &&
           fabs(kg_dot(g->normal, a->origin) - g->offset) < KG_ON_PLANE * s->size;
}

/* Orders with all at rest of a loop that slides, or arrives in different ways. */
static kg_status land_alone(landing *l, int32_t moving) {
    kg_origami_state *s = l->after;
    bool slides = is_through_axis(l, moving);
    kg_overlaps_find(&l->overlaps, moving, l->resting, 0, l->found);
    for (size_t w = 0; w < s->layers.words; w++)
        for (uint64_t bits = l->found[w]; bits != 0;) {
            int32_t resting = (int32_t)(64 * w) + kg_bit_next(&bits);
            int above = 0;
            kg_status status = slides ? KG_OK : arrival(l, moving, resting, &above);
            if (status)
                return status;
            if (above == 0) { /* it slid: an old order holds */
                int32_t old = loop_before(l, resting);
                above = kg_origami_order(l->folding->state, old, loop_before(l, moving)) *
                        l->outlines.facing[resting];
                if (above == 0)
                    return kg_fail(l->error, KG_ERR_INPUT,
                                   "face %d would slide edge on into face %d, in its plane",
                                   loop_before(l, moving), old);
            }
            l->elsewhere |= !kg_bit_at(l->own, moving);
            kg_layer_put(s, &l->outlines, resting, moving, above);
        }
    return KG_OK;
}

/* Orders of one loop with later ones, of which one moves and the other rests. */
static void land(landing *l, int32_t loop) {
    const kg_origami_state *s = l->after;
    bool moves = l->parts->moves[loop], own = kg_bit_at(l->own, loop),
         upper = l->inserts && kg_bit_at(l->upper, loop), raised = kg_bit_at(l->raised, loop);
    size_t first = (size_t)loop / 64, words = s->layers.words;
    if (kg_bit_at(l->single, loop))
        return;
    for (size_t w = first; w < words; w++)
        l->wanted[0][w] = moves ? l->resting[w] : l->moving[w] & ~l->single[w];
    l->wanted[0][first] &= ~(uint64_t)1 << (loop & 63);
    kg_overlaps_find(&l->overlaps, loop, l->wanted[0], first, l->found);
    uint64_t *below = kg_layer_pile(s, &l->outlines, loop, -1),
             *above = kg_layer_pile(s, &l->outlines, loop, 1);
    for (size_t w = first; w < words; w++) {
        uint64_t found = l->found[w], higher;
        if (moves)
            higher = own && l->inserts ? l->upper[w] : raised ? 0 : ~(uint64_t)0;
        else
            higher =
                !l->inserts ? l->raised[w] : (l->raised[w] & ~l->own[w]) | (upper ? 0 : l->own[w]);
        above[w] |= found & higher;
        below[w] |= found & ~higher;
        l->elsewhere |= (found & ~(moves ? own ? ~(uint64_t)0 : 0 : l->own[w])) != 0;
    }
}

/* ---- all -------------------------------------------------------------------------------- */

/* Which loops move, and how they arrive. */
static void mark(landing *l) {
    const kg_origami_state *s = l->after, *before = l->folding->state;
    const kg_fold_axis *a = &l->folding->axis;
    for (size_t i = 0; i < before->loops.count; i++)
        kg_bit_set(l->parts->children[i] >= 0 ? l->cut : l->whole[l->parts->moves[i]], (int32_t)i);
    for (int32_t i = 0; i < (int32_t)s->loops.count; i++) {
        kg_bit_set(l->parts->moves[i] ? l->moving : l->resting, i);
        if (!l->parts->moves[i])
            continue;
        int32_t group = s->loops.items[i].group;
        bool own = is_flat(a) && group == a->group &&
                   before->loops.items[loop_before(l, i)].group == a->group;
        int way = is_through_axis(l, i) ? arrival_at(l, i, l->outlines.middles[i]) : 0;
        if (own)
            kg_bit_set(l->own, i);
        if (way > 0)
            kg_bit_set(l->raised, i);
        else if (way == 0 && !(own && l->inserts))
            kg_bit_set(l->single, i);
    }
}

/* One block for all rows of bits. */
static uint64_t *create_rows(landing *l) {
    uint64_t **rows[] = {&l->moving, &l->resting,  &l->own,       &l->raised,
                         &l->single, &l->upper,    &l->wanted[0], &l->wanted[1],
                         &l->found,  &l->whole[0], &l->whole[1],  &l->cut};
    size_t words = l->after->layers.words, count = sizeof rows / sizeof *rows;
    uint64_t *block = calloc(count * words, sizeof *block);
    for (size_t i = 0; i < count && block; i++)
        *rows[i] = block + i * words;
    return block;
}

static kg_status find_orders(landing *l, const int32_t between[2]) {
    int32_t loops = (int32_t)l->after->loops.count;
    kg_status status = KG_OK;
    mark(l);
    for (int32_t i = 0; i < loops; i++)
        keep_orders(l, i);
    if (l->inserts) {
        kg_layers_mirror(l->after, &l->outlines);
        status = find_upper(l, between);
    }
    for (int32_t i = 0; i < loops && !status; i++)
        land(l, i);
    kg_layers_mirror(l->after, &l->outlines);
    for (int32_t i = 0; i < loops && !status; i++)
        if (kg_bit_at(l->single, i))
            status = land_alone(l, i);
    if (!status && l->inserts && !is_inserted(l, between))
        status = kg_fail(l->error, KG_ERR_INPUT, "the fold does not end between faces %d and %d",
                         between[0], between[1]);
    /* the rules of what moves keep layers from crossing, but not where they go between others or
     * meet those of other planes */
    if (!status && (l->inserts || l->elsewhere))
        status = kg_layers_check(l->after, &l->outlines, l->moving, l->error);
    return status;
}

kg_status kg_fold_land(const kg_folding *folding, const kg_fold *fold, const kg_fold_parts *parts,
                       kg_origami_state *after, kg_error *error) {
    landing l = {.folding = folding,
                 .parts = parts,
                 .after = after,
                 .inserts = fold->between[0] >= 0 || fold->between[1] >= 0,
                 .error = error};
    kg_status status = kg_layers_create(after);
    if (!status)
        status = kg_outlines_create(after, &l.outlines);
    if (!status)
        status = kg_overlaps_create(after, &l.outlines, &l.overlaps);
    uint64_t *rows = status ? NULL : create_rows(&l);
    if (!status)
        status = rows ? find_orders(&l, fold->between) : KG_ERR_MEMORY;
    free(rows);
    kg_overlaps_clear(&l.overlaps);
    kg_outlines_clear(&l.outlines);
    return status;
}
