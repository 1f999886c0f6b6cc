/* Folding a state: cuts, turning, planes. */
#include "origami/folding.h"

#include <stdlib.h>

/* ---- cutting along the axis ------------------------------------------------------------- */

typedef struct cutting {
    const kg_origami_state *before;
    kg_origami_state *state; /* after */
    struct {
        signed char *items; /* of vertices, as in kg_folding */
        size_t count, capacity;
    } sides;
    kg_fold_parts parts;
} cutting;

static int side_at(const cutting *c, int32_t half) {
    return c->sides.items[c->state->halves.items[half].origin];
}

static kg_status cut_edge(cutting *c, const kg_fold_axis *a, int32_t half) {
    double x = kg_dot(kg_sub(*kg_origin(c->state, half), a->origin), a->side),
           y = kg_dot(kg_sub(*kg_origin(c->state, kg_twin(half)), a->origin), a->side);
    int32_t vertex;
    kg_status status = kg_state_split_edge(c->state, half, x / (x - y), &vertex);
    return !status && !kg_push(&c->sides, 0) ? KG_ERR_MEMORY : status;
}

/* Cuts one loop; its moving part becomes a new loop. Loops that do not reach across stay whole. */
static kg_status cut_loop(cutting *c, const kg_fold_axis *a, int32_t loop) {
    kg_origami_state *s = c->state;
    int32_t first = s->loops.items[loop].first, h = first, to_rest = -1, to_move = -1;
    kg_status status = KG_OK;
    do {
        if (side_at(c, h) * side_at(c, kg_next(s, h)) < 0)
            status = cut_edge(c, a, h);
        h = kg_next(s, h);
    } while (!status && h != first);
    if (status)
        return status;
    h = s->loops.items[loop].first;
    first = h;
    do {
        int next = side_at(c, kg_next(s, h));
        if (side_at(c, h) == 0 && next == -1)
            to_rest = h;
        if (side_at(c, h) == 0 && next == 1)
            to_move = h;
        h = kg_next(s, h);
    } while (h != first);
    if (to_rest < 0 || to_move < 0)
        return KG_OK;
    c->parts.children[loop] = (int32_t)s->loops.count;
    return kg_state_split_loop(s, to_rest, to_move);
}

static void cutting_clear(cutting *c) {
    kg_state_destroy(c->state);
    free(c->sides.items);
    free(c->parts.children);
    free(c->parts.moves);
}

static int32_t loop_before(const cutting *c, int32_t loop) {
    return kg_loop_in(c->before, c->state, loop);
}

static kg_status cut_loops(const kg_folding *f, cutting *c) {
    size_t loops = f->state->loops.count, vertices = f->state->vertices.count;
    c->before = f->state;
    c->state = kg_state_copy(f->state);
    c->parts.children = malloc((loops + 1) * sizeof *c->parts.children);
    c->parts.moves = calloc(2 * loops + 1, sizeof *c->parts.moves);
    if (!c->state || !c->parts.children || !c->parts.moves || !kg_reserve(&c->sides, vertices))
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < vertices; i++)
        c->sides.items[c->sides.count++] = f->sides[i];
    for (size_t i = 0; i < loops; i++) {
        c->parts.children[i] = -1;
        c->parts.moves[i] = f->moves[i];
    }
    for (size_t i = 0; i < loops; i++) {
        if (!f->moves[i] || f->state->loops.items[i].group != f->axis.group)
            continue;
        kg_status status = cut_loop(c, &f->axis, (int32_t)i);
        if (status)
            return status;
        int32_t child = c->parts.children[i];
        if (child >= 0) {
            c->parts.moves[child] = true;
            c->parts.moves[i] = false;
        }
    }
    return KG_OK;
}

/* ---- turning ---------------------------------------------------------------------------- */

/* Fold angles of the edges on the axis, from which side moves. */
static kg_status turn_edges(cutting *c, const kg_fold_axis *a, kg_fold_blame *blame,
                            kg_error *error) {
    kg_origami_state *s = c->state;
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t half = (int32_t)(2 * e), x = kg_loop_of(s, half), y = kg_loop_of(s, half + 1);
        if (x < 0 || y < 0 || c->parts.moves[x] == c->parts.moves[y])
            continue;
        int32_t moving = c->parts.moves[x] ? x : y;
        /* a valley closes when the moving loop turns towards its own front; of its corners the one
         * farthest from the axis shows most clearly which way it goes */
        int32_t first = s->loops.items[moving].first, h = first, far = first;
        do
            if (kg_fold_radius(a, *kg_origin(s, h)) > kg_fold_radius(a, *kg_origin(s, far)))
                far = h;
        while ((h = kg_next(s, h)) != first);
        double towards =
            kg_dot(kg_fold_velocity(a, *kg_origin(s, far)), kg_origami_normal(s, moving));
        kg_paper_edge *edge = &s->edges.items[e];
        double angle = edge->angle + copysign(fabs(a->angle), towards);
        if (fabs(angle) > KG_PI + KG_LEAST_ANGLE) {
            *blame = (kg_fold_blame){
                KG_FOLD_AT_EDGE, {loop_before(c, x), loop_before(c, y)}, KG_PI - fabs(edge->angle)};
            return kg_fail(error, KG_ERR_INPUT,
                           "faces %d and %d would pass through each other at their common edge",
                           blame->faces[0], blame->faces[1]);
        }
        if (fabs(angle) > KG_PI - KG_LEAST_ANGLE)
            angle = copysign(KG_PI, angle);
        edge->angle = fabs(angle) < KG_LEAST_ANGLE ? 0 : angle;
        edge->kind = KG_PAPER_CREASE;
    }
    return KG_OK;
}

static kg_status turn_vertices(cutting *c, const kg_fold_axis *a, kg_error *error) {
    kg_origami_state *s = c->state;
    signed char *turns = calloc(s->vertices.count + 1, 1); /* bits: 1 moves, 2 rests */
    kg_status status = turns ? KG_OK : KG_ERR_MEMORY;
    for (size_t h = 0; h < s->halves.count && turns; h++) {
        int32_t v = s->halves.items[h].origin, loop = s->halves.items[h].loop;
        bool on = c->sides.items[v] == -2
                      ? kg_fold_radius(a, s->vertices.items[v].position) <= KG_ON_AXIS * s->size
                      : c->sides.items[v] == 0;
        if (loop >= 0 && !on)
            turns[v] |= c->parts.moves[loop] ? 1 : 2;
    }
    for (size_t v = 0; v < s->vertices.count && !status; v++) {
        if (turns[v] == 3)
            status = kg_fail(error, KG_ERR_INPUT, "the paper would tear at vertex %zu", v);
        else if (turns[v] == 1)
            s->vertices.items[v].position =
                kg_fold_turn(a, s->vertices.items[v].position, a->angle);
    }
    free(turns);
    return status;
}

/* ---- planes ----------------------------------------------------------------------------- */

static kg_face_group turn_plane(const kg_face_group *g, const kg_fold_axis *a) {
    kg_vec3 on = kg_fold_turn(a, kg_scale(g->normal, g->offset), a->angle);
    kg_fold_axis through_zero = *a;
    through_zero.origin = kg_v3(0, 0, 0);
    kg_vec3 n = kg_unit(kg_fold_turn(&through_zero, g->normal, a->angle));
    return (kg_face_group){n, kg_dot(n, on)};
}

static bool same_plane(const kg_face_group *a, const kg_face_group *b, double size) {
    double same = kg_dot(a->normal, b->normal) > 0 ? 1 : -1;
    return kg_len(kg_cross(a->normal, b->normal)) < KG_ON_PLANE &&
           fabs(a->offset - same * b->offset) < KG_ON_PLANE * size;
}

/* Gives the moving loops of every group their new plane: one that is there already, the old one
 * turned when nothing rests in it, or a new one. */
static kg_status turn_groups(cutting *c, const kg_fold_axis *a) {
    kg_origami_state *s = c->state;
    size_t before = s->groups.count;
    int32_t *targets = malloc((before + 1) * sizeof *targets);
    signed char *use = calloc(before + 1, 1); /* bits: 1 something moves, 2 something rests */
    kg_status status = targets && use ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < s->loops.count && !status; i++)
        use[s->loops.items[i].group] |= c->parts.moves[i] ? 1 : 2;
    for (size_t g = 0; g < before && !status; g++) {
        if (!(use[g] & 1))
            continue;
        kg_face_group turned = turn_plane(&s->groups.items[g], a);
        size_t k = 0;
        while (k < before && !((use[k] & 2) && same_plane(&s->groups.items[k], &turned, s->size)))
            k++;
        targets[g] = (int32_t)k;
        if (k == before) {
            targets[g] = use[g] & 2 ? (int32_t)s->groups.count : (int32_t)g;
            if (!(use[g] & 2))
                s->groups.items[g] = turned;
            else if (!kg_push(&s->groups, turned))
                status = KG_ERR_MEMORY;
        }
    }
    for (size_t i = 0; i < s->loops.count && !status; i++)
        if (c->parts.moves[i])
            s->loops.items[i].group = targets[s->loops.items[i].group];
    free(targets);
    free(use);
    return status;
}

/* ---- the fold --------------------------------------------------------------------------- */

static kg_status check_sweep(const cutting *c, const kg_fold_axis *a, kg_fold_blame *blame,
                             kg_error *error) {
    bool collides, rests = false;
    kg_collision hit;
    for (size_t i = 0; i < c->state->loops.count; i++)
        rests |= !c->parts.moves[i];
    if (!rests) {
        blame->fault = KG_FOLD_ALL_MOVES;
        return kg_fail(error, KG_ERR_INPUT, "the whole paper would move: the axis is beside it");
    }
    kg_status status = kg_sweep(c->state, a, c->parts.moves, &collides, &hit);
    if (!status && collides) {
        *blame = (kg_fold_blame){
            KG_FOLD_IN_WAY, {loop_before(c, hit.moving), loop_before(c, hit.resting)}, hit.angle};
        return kg_fail(error, KG_ERR_INPUT,
                       "the fold would pass through paper: face %d meets face %d at %.4g degrees",
                       blame->faces[0], blame->faces[1], hit.angle * 180 / KG_PI);
    }
    return status;
}

kg_status kg_folding_finish(kg_folding *f, const kg_fold *fold, kg_origami_state **out_state,
                            bool **out_moves, kg_error *error) {
    cutting c = {0};
    kg_status status = cut_loops(f, &c);
    if (!status)
        status = check_sweep(&c, &f->axis, &f->blame, error);
    if (!status)
        status = turn_edges(&c, &f->axis, &f->blame, error);
    if (!status)
        status = turn_vertices(&c, &f->axis, error);
    if (!status)
        status = turn_groups(&c, &f->axis);
    if (!status)
        status = kg_fold_land(f, fold, &c.parts, c.state, error);
    if (!status) {
        *out_state = c.state;
        c.state = NULL;
    }
    if (!status && out_moves) {
        *out_moves = c.parts.moves;
        c.parts.moves = NULL;
    }
    cutting_clear(&c);
    return status;
}

kg_status kg_state_fold(const kg_origami_state *state, const kg_fold *fold,
                        kg_origami_state **out_state, kg_error *error) {
    kg_folding f;
    kg_status status = kg_folding_create(state, fold, &f, error);
    if (!status) {
        status = kg_folding_pick(&f, fold, error);
        if (!status)
            status = kg_folding_finish(&f, fold, out_state, NULL, error);
        kg_folding_clear(&f);
    }
    return status == KG_ERR_MEMORY ? kg_fail(error, status, "out of memory") : status;
}
