/*
 * What moves in a fold: the picked loop beyond the axis; what shares an edge with a moving part
 * there; what lies on a moving part on the side that it goes to. Loops in other planes that hang on
 * a moving part move as a whole.
 */
#include "origami/folding.h"

#include "origami/convex.h"

#include <stdlib.h>
#include <string.h>

typedef struct stack {
    int32_t *items;
    size_t count, capacity;
} stack;

static bool in_group(const kg_folding *f, int32_t loop) {
    return f->state->loops.items[loop].group == f->axis.group;
}

static int side_of(const kg_folding *f, int32_t half) {
    return f->sides[f->state->halves.items[half].origin];
}

void kg_folding_rest(kg_folding *f) {
    size_t loops = f->state->loops.count;
    memset(f->moves, 0, loops * sizeof *f->moves);
    memset(f->open, 0, kg_layer_words(loops) * sizeof *f->open);
    for (size_t i = 0; i < loops; i++)
        if (!in_group(f, (int32_t)i) || f->reach[i] & 1)
            kg_bit_set(f->open, (int32_t)i);
}

static kg_status add(kg_folding *f, stack *todo, int32_t loop) {
    if (f->moves[loop])
        return KG_OK;
    f->moves[loop] = true;
    kg_bit_unset(f->open, loop);
    return kg_push(todo, loop) ? KG_OK : KG_ERR_MEMORY;
}

static bool on_axis(const kg_folding *f, int32_t half) {
    double tolerance = KG_ON_AXIS * f->state->size;
    return kg_fold_radius(&f->axis, *kg_origin(f->state, half)) <= tolerance &&
           kg_fold_radius(&f->axis, *kg_origin(f->state, kg_twin(half))) <= tolerance;
}

/* The loop across an edge of a moving one. */
static kg_status follow_edge(kg_folding *f, stack *todo, int32_t half, kg_error *error) {
    int32_t loop = kg_loop_of(f->state, half), other = kg_loop_of(f->state, kg_twin(half));
    if (other < 0)
        return KG_OK;
    int a = side_of(f, half), b = side_of(f, kg_twin(half));
    bool beyond = a == 1 || b == 1, rests = a == -1 || b == -1;
    if (in_group(f, loop) && !beyond)
        return KG_OK;
    if (in_group(f, loop) && in_group(f, other))
        return add(f, todo, other);
    if (!in_group(f, loop) && on_axis(f, half))
        return KG_OK;
    if (rests) {
        int32_t rigid = in_group(f, loop) ? other : loop;
        f->blame = (kg_fold_blame){KG_FOLD_HELD, {loop, other}, 0};
        return kg_fail(
            error, KG_ERR_INPUT,
            "face %d, in another plane, would have to move with face %d and to stay with "
            "what is on the other side of the axis",
            rigid, rigid == loop ? other : loop);
    }
    return add(f, todo, other);
}

/* Parts beyond the axis of two overlapping loops, which both have one, overlap. */
static bool overlap_beyond(const kg_folding *f, int32_t a, int32_t b, kg_vec2 *scratch) {
    if (!(f->reach[a] & 2) || !(f->reach[b] & 2))
        /* what is beyond as a whole overlaps the other one there and nowhere else */
        return true;
    kg_vec3 u, v;
    kg_plane_axes(f->axis.normal, &u, &v);
    kg_vec2 m = kg_v2(kg_dot(u, f->axis.side), kg_dot(v, f->axis.side));
    double offset = kg_dot(f->axis.origin, kg_madd(kg_scale(u, m.x), m.y, v));
    const kg_outlines *o = &f->outlines;
    kg_vec2 *second = scratch + kg_outline_size(o, a) + 2;
    size_t n = kg_convex_clip(kg_outline_points(o, a), kg_outline_size(o, a), m, offset, scratch);
    size_t k = kg_convex_clip(kg_outline_points(o, b), kg_outline_size(o, b), m, offset, second);
    return n > 0 && k > 0 && kg_convex_overlap(scratch, n, second, k, f->state->touch);
}

/* A loop in another plane starts towards one that lies on it, somewhere in their common part. */
static bool pushes(const kg_folding *f, int32_t loop, int32_t other, int above, kg_vec2 *scratch) {
    const kg_outlines *o = &f->outlines;
    const kg_face_group *g = &f->state->groups.items[f->state->loops.items[loop].group];
    size_t na = kg_outline_size(o, loop), nb = kg_outline_size(o, other);
    size_t n = kg_convex_common(kg_outline_points(o, loop), na, kg_outline_points(o, other), nb,
                                scratch, scratch + na + nb + 2);
    kg_vec3 u, v;
    kg_plane_axes(g->normal, &u, &v);
    for (size_t i = 0; i < n; i++) {
        kg_vec3 p = kg_add(kg_scale(g->normal, g->offset),
                           kg_add(kg_scale(u, scratch[i].x), kg_scale(v, scratch[i].y)));
        if (above * kg_dot(kg_fold_velocity(&f->axis, p), g->normal) > f->state->touch)
            return true;
    }
    return false;
}

static kg_status follow_layers(kg_folding *f, stack *todo, int32_t loop, kg_vec2 *scratch) {
    int up = f->axis.angle > 0 ? 1 : -1;
    for (int above = -1; above <= 1; above += 2) {
        const uint64_t *row = kg_layer_pile(f->state, &f->outlines, loop, above);
        for (size_t w = 0; w < f->state->layers.words && (above == up || !in_group(f, loop)); w++)
            for (uint64_t bits = row[w] & f->open[w]; bits != 0;) {
                int32_t other = (int32_t)(64 * w) + kg_bit_next(&bits);
                if ((in_group(f, loop) ? overlap_beyond(f, loop, other, scratch)
                                       : pushes(f, loop, other, above, scratch)) &&
                    add(f, todo, other))
                    return KG_ERR_MEMORY;
            }
    }
    return KG_OK;
}

kg_status kg_folding_move(kg_folding *f, int32_t loop, kg_error *error) {
    if (in_group(f, loop) && !(f->reach[loop] & 1))
        return kg_fail(error, KG_ERR_INPUT, "face %d has nothing on the moving side of the axis",
                       loop);
    size_t most = 0;
    for (size_t i = 0; i < f->state->loops.count; i++) {
        size_t n = kg_outline_size(&f->outlines, (int32_t)i);
        most = n > most ? n : most;
    }
    kg_vec2 *scratch = malloc((4 * most + 8) * sizeof *scratch);
    stack todo = {0};
    kg_status status = scratch ? add(f, &todo, loop) : KG_ERR_MEMORY;
    while (todo.count > 0 && !status) {
        int32_t next = todo.items[--todo.count], first = f->state->loops.items[next].first,
                h = first;
        do
            status = follow_edge(f, &todo, h, error);
        while (!status && (h = kg_next(f->state, h)) != first);
        if (!status)
            status = follow_layers(f, &todo, next, scratch);
    }
    free(todo.items);
    free(scratch);
    return status;
}
