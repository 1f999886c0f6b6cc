#include "origami/condition.h"

#include "base/progress.h"
#include "origami/convex.h"

#include <stdlib.h>

/* An edge between two loops of one group, in the group's axes. */
typedef struct crease {
    int32_t loops[2];
    kg_vec2 ends[2], along; /* unit */
    double length;
    int sides[2]; /* of the two loops: 1 left of the edge, -1 right */
    bool valid, is_taco;
} crease;

typedef struct finder {
    const kg_origami_state *state;
    const kg_outlines *outlines;
    crease *creases;
    double tolerance;
    int32_t *seen;         /* finding, per edge: the last edge it was compared with */
    kg_conditions *out;    /* finding */
    const uint64_t *moved; /* checking */
    kg_error *error;       /* checking */
} finder;

static kg_status find_creases(finder *f) {
    const kg_origami_state *s = f->state;
    int32_t axes_of = -1;
    kg_vec3 u, v;
    f->creases = calloc(s->edges.count + 1, sizeof *f->creases);
    for (size_t e = 0; e < s->edges.count && f->creases; e++) {
        int32_t half = (int32_t)(2 * e), a = kg_loop_of(s, half), b = kg_loop_of(s, half + 1);
        crease *c = &f->creases[e];
        if (a < 0 || b < 0 || s->loops.items[a].group != s->loops.items[b].group)
            continue;
        if (s->loops.items[a].group != axes_of) {
            axes_of = s->loops.items[a].group;
            kg_plane_axes(s->groups.items[axes_of].normal, &u, &v);
        }
        for (int k = 0; k < 2; k++) {
            kg_vec3 p = *kg_origin(s, half + k);
            c->ends[k] = kg_v2(kg_dot(u, p), kg_dot(v, p));
        }
        c->length = kg_dist2(c->ends[0], c->ends[1]);
        c->along = kg_scale2(kg_sub2(c->ends[1], c->ends[0]), 1 / c->length);
        c->loops[0] = a, c->loops[1] = b;
        /* a loop lies left of its half-edges when its front shows */
        c->sides[0] = f->outlines->facing[a];
        c->sides[1] = -f->outlines->facing[b];
        c->valid = true;
        c->is_taco = c->sides[0] == c->sides[1];
    }
    return f->creases ? KG_OK : KG_ERR_MEMORY;
}

static kg_status add(finder *f, kg_condition c) {
    return kg_push(f->out, c) ? KG_OK : KG_ERR_MEMORY;
}

/* ---- an edge and paper that goes on across it ------------------------------------------- */

/* A part of the edge, longer than the tolerance, runs inside a loop. */
static bool runs_inside(const finder *f, const crease *e, int32_t loop) {
    const kg_outline_side *sides = f->outlines->sides + f->outlines->starts[loop];
    const kg_vec2 *q = kg_outline_points(f->outlines, loop);
    size_t n = kg_outline_size(f->outlines, loop);
    for (size_t i = 0; i < n; i++) /* most lie beside it */
        if (kg_outline_depth(&sides[i], e->ends[0]) <= f->tolerance &&
            kg_outline_depth(&sides[i], e->ends[1]) <= f->tolerance)
            return false;
    kg_vec2 p = e->ends[0], d = kg_sub2(e->ends[1], p);
    double length = e->length, t[2] = {0, 1};
    for (size_t i = 0; i < n; i++) {
        kg_vec2 side = kg_sub2(q[i + 1 < n ? i + 1 : 0], q[i]);
        double w = kg_len2(side), from = kg_cross2(side, kg_sub2(p, q[i])) - f->tolerance * w,
               slope = kg_cross2(side, d);
        if (fabs(slope) <= 1e-12 * w * length) {
            if (from <= 0)
                return false;
        } else if (slope > 0) {
            t[0] = fmax(t[0], -from / slope);
        } else {
            t[1] = fmin(t[1], -from / slope);
        }
    }
    return (t[1] - t[0]) * length > f->tolerance;
}

static kg_status find_through(finder *f, int32_t edge) {
    const crease *e = &f->creases[edge];
    kg_status status = KG_OK;
    for (size_t w = 0; w < f->state->layers.words; w++)
        for (uint64_t both =
                 kg_layer_any(f->state, e->loops[0], w) & kg_layer_any(f->state, e->loops[1], w);
             both != 0 && !status;) {
            int32_t x = (int32_t)(64 * w) + kg_bit_next(&both);
            if (runs_inside(f, e, x))
                status = add(f, (kg_condition){
                                    KG_CONDITION_SAME, e->loops[0], x, e->loops[1], x, {edge, -1}});
        }
    return status;
}

/* ---- two edges on one line -------------------------------------------------------------- */

/* Same line and a common stretch; `*out_turned` when they run against each other. */
static bool coincide(const finder *f, const crease *e, const crease *g, bool *out_turned) {
    double t[2];
    for (int k = 0; k < 2; k++) {
        kg_vec2 r = kg_sub2(g->ends[k], e->ends[0]);
        if (fabs(kg_cross2(e->along, r)) > f->tolerance)
            return false;
        t[k] = kg_dot2(e->along, r);
    }
    *out_turned = t[0] > t[1];
    return fmin(e->length, fmax(t[0], t[1])) - fmax(0, fmin(t[0], t[1])) > f->tolerance;
}

/* Both bound one loop: rounding of a sliver. */
static bool share_loop(const crease *e, const crease *g) {
    return e->loops[0] == g->loops[0] || e->loops[0] == g->loops[1] || e->loops[1] == g->loops[0] ||
           e->loops[1] == g->loops[1];
}

static kg_status compare(finder *f, int32_t edge, int32_t other) {
    const crease *e = &f->creases[edge], *g = &f->creases[other];
    bool turned;
    if (!g->valid || share_loop(e, g) || !coincide(f, e, g, &turned))
        return KG_OK;
    int flip = turned ? -1 : 1;
    int32_t a = e->loops[0], b = e->loops[1], c = g->loops[0], d = g->loops[1];
    int side_c = flip * g->sides[0];
    if (e->is_taco && g->is_taco)
        return side_c != e->sides[0]
                   ? KG_OK
                   : add(f, (kg_condition){KG_CONDITION_TACOS, a, b, c, d, {edge, other}});
    if (e->is_taco) {
        int32_t tortilla = side_c == e->sides[0] ? c : d;
        return add(f, (kg_condition){KG_CONDITION_SAME, a, tortilla, b, tortilla, {edge, other}});
    }
    if (g->is_taco) {
        int32_t tortilla = e->sides[0] == side_c ? a : b;
        return add(f, (kg_condition){KG_CONDITION_SAME, c, tortilla, d, tortilla, {other, edge}});
    }
    return e->sides[0] == side_c
               ? add(f, (kg_condition){KG_CONDITION_SAME, a, c, b, d, {edge, other}})
               : add(f, (kg_condition){KG_CONDITION_SAME, a, d, b, c, {edge, other}});
}

/* With later edges of all loops that overlap either of this edge's. */
static kg_status find_along(finder *f, int32_t edge) {
    const crease *e = &f->creases[edge];
    kg_status status = KG_OK;
    for (int side = 0; side < 2; side++)
        for (size_t w = 0; w < f->state->layers.words; w++)
            for (uint64_t bits = kg_layer_any(f->state, e->loops[side], w); bits != 0 && !status;) {
                int32_t loop = (int32_t)(64 * w) + kg_bit_next(&bits),
                        first = f->state->loops.items[loop].first, h = first;
                do {
                    int32_t other = h >> 1;
                    if (other > edge && f->seen[other] != edge) {
                        f->seen[other] = edge;
                        status = compare(f, edge, other);
                    }
                } while (!status && (h = kg_next(f->state, h)) != first);
            }
    return status;
}

kg_status kg_conditions_find(const kg_origami_state *s, const kg_outlines *o,
                             const kg_progress *progress, kg_conditions *out, kg_error *error) {
    kg_conditions conditions = {0};
    finder f = {.state = s,
                .outlines = o,
                .tolerance = s->touch,
                .seen = malloc((s->edges.count + 1) * sizeof *f.seen),
                .out = &conditions};
    kg_status status = f.seen ? find_creases(&f) : KG_ERR_MEMORY;
    for (size_t e = 0; e < s->edges.count && !status; e++)
        f.seen[e] = -1;
    for (size_t e = 0; e < s->edges.count && !status; e++) {
        if (!f.creases[e].valid)
            continue;
        status = kg_progress_tell(progress, (double)e / (double)s->edges.count, "layers", error);
        if (!status)
            status = find_through(&f, (int32_t)e);
        if (!status)
            status = find_along(&f, (int32_t)e);
    }
    free(f.creases);
    free(f.seen);
    if (status) {
        free(conditions.items);
        return status;
    }
    *out = conditions;
    return KG_OK;
}

/* ---- checking orders -------------------------------------------------------------------- */

/*
 * Whatever breaks a condition at a taco lies between its halves, at least in part, and two
 * tortillas on one line that break theirs lie on each other: so only those are looked at.
 */

/* "b lies above a"; 0 when they do not overlap */
static int above(const finder *f, int32_t a, int32_t b) {
    return kg_origami_order(f->state, a, b) * f->outlines->facing[a];
}

static kg_status passes(const finder *f, int32_t loop, const crease *e) {
    return kg_fail(f->error, KG_ERR_INPUT, "face %d would pass through the joined faces %d and %d",
                   loop, e->loops[0], e->loops[1]);
}

/* Loops whose orders with `loop` are to be looked at. */
static uint64_t asked(const finder *f, int32_t loop, size_t word) {
    return !f->moved ? ~(uint64_t)0 : kg_bit_at(f->moved, loop) ? ~f->moved[word] : f->moved[word];
}

/* Loop x lies between the halves of e; g is one of its edges. */
static kg_status check_taco(const finder *f, int32_t edge, int32_t x, int32_t other) {
    const crease *e = &f->creases[edge], *g = &f->creases[other];
    bool turned;
    if (!g->valid || share_loop(e, g) ||
        !(edge < other ? coincide(f, e, g, &turned) : coincide(f, g, e, &turned)))
        return KG_OK;
    int flip = turned ? -1 : 1, at = g->loops[1] == x;
    if (flip * g->sides[at] != e->sides[0])
        return KG_OK;
    if (!g->is_taco)
        return passes(f, x, e);
    int32_t y = g->loops[!at];
    if (above(f, e->loops[0], y) * above(f, e->loops[1], y) <= 0)
        return KG_OK;
    return kg_fail(f->error, KG_ERR_INPUT,
                   "the joined faces %d and %d would pass through the joined faces %d and %d",
                   e->loops[0], e->loops[1], g->loops[0], g->loops[1]);
}

/* Loop x lies on the half `end` of e, which goes on flat; g is one of its edges. */
static kg_status check_tortilla(const finder *f, int32_t edge, int end, int32_t x, int32_t other) {
    const crease *e = &f->creases[edge], *g = &f->creases[other];
    bool turned;
    if (!g->valid || g->is_taco || share_loop(e, g) ||
        !(edge < other ? coincide(f, e, g, &turned) : coincide(f, g, e, &turned)))
        return KG_OK;
    int flip = turned ? -1 : 1, at = g->loops[1] == x;
    bool crosses = flip * g->sides[at] == e->sides[end] &&
                   above(f, e->loops[end], x) * above(f, e->loops[!end], g->loops[!at]) < 0;
    return crosses ? passes(f, x, e) : KG_OK;
}

/* What lies between the halves of an edge, or is above one and below the other. */
static kg_status check_between(const finder *f, int32_t edge) {
    const kg_origami_state *s = f->state;
    const crease *e = &f->creases[edge];
    int32_t a = e->loops[0], b = e->loops[1];
    const uint64_t *up[2] = {kg_layer_pile(s, f->outlines, a, 1),
                             kg_layer_pile(s, f->outlines, b, 1)},
                   *down[2] = {kg_layer_pile(s, f->outlines, a, -1),
                               kg_layer_pile(s, f->outlines, b, -1)};
    for (size_t w = 0; w < s->layers.words; w++) {
        uint64_t bits =
            ((up[0][w] & down[1][w]) | (down[0][w] & up[1][w])) & (asked(f, a, w) | asked(f, b, w));
        while (bits != 0) {
            int32_t x = (int32_t)(64 * w) + kg_bit_next(&bits), first = s->loops.items[x].first,
                    h = first;
            kg_status status = runs_inside(f, e, x) ? passes(f, x, e) : KG_OK;
            do
                status = status || !e->is_taco ? status : check_taco(f, edge, x, h >> 1);
            while (!status && (h = kg_next(s, h)) != first);
            if (status)
                return status;
        }
    }
    return KG_OK;
}

/* What lies on an edge that is flat. */
static kg_status check_across(const finder *f, int32_t edge) {
    const kg_origami_state *s = f->state;
    const crease *e = &f->creases[edge];
    for (int end = 0; end < 2 && !e->is_taco; end++)
        for (size_t w = 0; w < s->layers.words; w++)
            for (uint64_t bits =
                     kg_layer_any(f->state, e->loops[end], w) & asked(f, e->loops[end], w);
                 bits != 0;) {
                int32_t x = (int32_t)(64 * w) + kg_bit_next(&bits), first = s->loops.items[x].first,
                        h = first;
                do {
                    kg_status status = check_tortilla(f, edge, end, x, h >> 1);
                    if (status)
                        return status;
                } while ((h = kg_next(s, h)) != first);
            }
    return KG_OK;
}

kg_status kg_layers_check(const kg_origami_state *s, const kg_outlines *o, const uint64_t *moved,
                          kg_error *error) {
    finder f = {.state = s, .outlines = o, .tolerance = s->touch, .moved = moved, .error = error};
    kg_status status = find_creases(&f);
    for (size_t e = 0; e < s->edges.count && !status; e++) {
        if (!f.creases[e].valid)
            continue;
        status = check_between(&f, (int32_t)e);
        if (!status)
            status = check_across(&f, (int32_t)e);
    }
    free(f.creases);
    return status;
}
