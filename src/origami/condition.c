#include "origami/condition.h"

#include "origami/convex.h"

#include <stdlib.h>

/* An edge between two loops of one group, in the group's axes. */
typedef struct crease {
    int32_t loops[2];
    kg_vec2 ends[2];
    int sides[2]; /* of the two loops: 1 left of the edge, -1 right */
    bool valid, is_taco;
} crease;

typedef struct finder {
    const kg_origami_state *state;
    const kg_outlines *outlines;
    const kg_layer_rows *rows;
    crease *creases;
    int32_t *seen; /* per edge: the last edge it was compared with */
    double tolerance;
    kg_conditions *out;
} finder;

static crease crease_of(const finder *f, int32_t edge) {
    const kg_origami_state *s = f->state;
    int32_t half = 2 * edge, a = kg_loop_of(s, half), b = kg_loop_of(s, half + 1);
    crease c = {.loops = {a, b}};
    if (a < 0 || b < 0 || s->loops.items[a].group != s->loops.items[b].group)
        return c;
    kg_vec3 u, v;
    kg_plane_axes(s->groups.items[s->loops.items[a].group].normal, &u, &v);
    for (int k = 0; k < 2; k++) {
        kg_vec3 p = *kg_origin(s, half + k);
        c.ends[k] = kg_v2(kg_dot(u, p), kg_dot(v, p));
    }
    /* a loop lies left of its half-edges when its front shows */
    c.sides[0] = f->outlines->facing[a];
    c.sides[1] = -f->outlines->facing[b];
    c.valid = true;
    c.is_taco = c.sides[0] == c.sides[1];
    return c;
}

static kg_status add(finder *f, kg_condition c) {
    return kg_push(f->out, c) ? KG_OK : KG_ERR_MEMORY;
}

/* ---- an edge and paper that goes on across it ------------------------------------------- */

/* A part of the edge, longer than the tolerance, runs inside a loop. */
static bool runs_inside(const finder *f, const crease *e, int32_t loop) {
    kg_vec2 p = e->ends[0], d = kg_sub2(e->ends[1], p);
    double length = kg_len2(d), t[2] = {0, 1};
    const kg_vec2 *q = kg_outline_points(f->outlines, loop);
    size_t n = kg_outline_size(f->outlines, loop);
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
    const kg_layer_rows *r = f->rows;
    size_t i = r->starts[e->loops[0]], k = r->starts[e->loops[1]];
    kg_status status = KG_OK;
    while (i < r->starts[e->loops[0] + 1] && k < r->starts[e->loops[1] + 1] && !status) {
        int32_t x = kg_row_other(r, i), y = kg_row_other(r, k);
        if (x == y && runs_inside(f, e, x))
            status = add(
                f, (kg_condition){KG_CONDITION_SAME, e->loops[0], x, e->loops[1], x, {edge, -1}});
        i += x <= y;
        k += y <= x;
    }
    return status;
}

/* ---- two edges on one line -------------------------------------------------------------- */

/* Same line and a common stretch; `*out_turned` when they run against each other. */
static bool coincide(const finder *f, const crease *e, const crease *g, bool *out_turned) {
    kg_vec2 d = kg_sub2(e->ends[1], e->ends[0]);
    double length = kg_len2(d), t[2];
    d = kg_scale2(d, 1 / length);
    for (int k = 0; k < 2; k++) {
        kg_vec2 r = kg_sub2(g->ends[k], e->ends[0]);
        if (fabs(kg_cross2(d, r)) > f->tolerance)
            return false;
        t[k] = kg_dot2(d, r);
    }
    *out_turned = t[0] > t[1];
    return fmin(length, fmax(t[0], t[1])) - fmax(0, fmin(t[0], t[1])) > f->tolerance;
}

static kg_status compare(finder *f, int32_t edge, int32_t other) {
    const crease *e = &f->creases[edge], *g = &f->creases[other];
    bool turned;
    if (!g->valid || !coincide(f, e, g, &turned))
        return KG_OK;
    int flip = turned ? -1 : 1;
    int32_t a = e->loops[0], b = e->loops[1], c = g->loops[0], d = g->loops[1];
    int side_c = flip * g->sides[0];
    if (a == c || a == d || b == c || b == d)
        return KG_OK; /* both bound one loop: rounding of a sliver */
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
        for (size_t i = f->rows->starts[e->loops[side]];
             i < f->rows->starts[e->loops[side] + 1] && !status; i++) {
            int32_t loop = kg_row_other(f->rows, i), first = f->state->loops.items[loop].first,
                    h = first;
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

/* ---- all -------------------------------------------------------------------------------- */

kg_status kg_conditions_find(const kg_origami_state *s, const kg_outlines *o,
                             const kg_layer_rows *rows, kg_conditions *out) {
    kg_conditions conditions = {0};
    finder f = {.state = s,
                .outlines = o,
                .rows = rows,
                .tolerance = s->touch,
                .creases = malloc((s->edges.count + 1) * sizeof *f.creases),
                .seen = malloc((s->edges.count + 1) * sizeof *f.seen),
                .out = &conditions};
    kg_status status = f.creases && f.seen ? KG_OK : KG_ERR_MEMORY;
    for (size_t e = 0; e < s->edges.count && !status; e++) {
        f.creases[e] = crease_of(&f, (int32_t)e);
        f.seen[e] = -1;
    }
    for (size_t e = 0; e < s->edges.count && !status; e++) {
        if (!f.creases[e].valid)
            continue;
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

/* "b lies above a"; 0 when they do not overlap */
static int above(const kg_origami_state *s, const kg_outlines *o, int32_t a, int32_t b) {
    return kg_origami_order(s, a, b) * o->facing[a];
}

static bool is_met(const kg_origami_state *s, const kg_outlines *o, const kg_condition *c) {
    if (c->kind == KG_CONDITION_SAME) {
        int x = above(s, o, c->a, c->b), y = above(s, o, c->c, c->d);
        return x == 0 || y == 0 || x == y;
    }
    return above(s, o, c->a, c->c) * above(s, o, c->b, c->c) * above(s, o, c->a, c->d) *
               above(s, o, c->b, c->d) >=
           0;
}

kg_status kg_layers_check(const kg_origami_state *s, const kg_outlines *o, kg_error *error) {
    kg_layer_rows rows;
    kg_conditions conditions = {0};
    kg_status status = kg_layer_rows_create(s, o, &rows);
    if (status)
        return status;
    status = kg_conditions_find(s, o, &rows, &conditions);
    for (size_t i = 0; i < conditions.count && !status; i++) {
        const kg_condition *c = &conditions.items[i];
        if (is_met(s, o, c))
            continue;
        if (c->kind == KG_CONDITION_TACOS)
            status = kg_fail(error, KG_ERR_INPUT,
                             "the joined faces %d and %d would pass through the joined faces %d "
                             "and %d",
                             c->a, c->b, c->c, c->d);
        else
            status =
                kg_fail(error, KG_ERR_INPUT,
                        "face %d would pass through the joined faces %d and %d", c->b, c->a, c->c);
    }
    free(conditions.items);
    kg_layer_rows_clear(&rows);
    return status;
}
