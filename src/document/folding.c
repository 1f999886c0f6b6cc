#include "document/folding.h"

#include "origami/folding.h"

#include <stdlib.h>

static kg_vec2 paper_at(const kg_origami_state *s, int32_t half) {
    return s->vertices.items[s->halves.items[half].origin].paper;
}

/* Takes a point of the paper to where a loop has it, by the loop's longest side. */
static kg_vec3 in_space(const kg_origami_state *s, int32_t loop, kg_vec2 paper) {
    int32_t first = s->loops.items[loop].first, h = first, best = first;
    double most = -1;
    do {
        double length = kg_dist2(paper_at(s, h), paper_at(s, kg_next(s, h)));
        if (length > most)
            most = length, best = h;
    } while ((h = kg_next(s, h)) != first);
    kg_vec2 from = paper_at(s, best), to = paper_at(s, kg_next(s, best)), r = kg_sub2(paper, from);
    kg_vec2 along = kg_scale2(kg_sub2(to, from), 1 / most);
    kg_vec3 p = *kg_origin(s, best), x = kg_unit(kg_sub(*kg_origin(s, kg_next(s, best)), p)),
            y = kg_cross(kg_origami_normal(s, loop), x);
    return kg_madd(kg_madd(p, kg_dot2(along, r), x), kg_cross2(along, r), y);
}

/* Corners of the loops of `s` as they lay in an earlier state (or in `s` itself): in their planes
 * (`out_flat`) and drawn apart. */
static kg_status find_corners(const kg_origami_state *s, const kg_origami_state *earlier,
                              double thickness, kg_vec3 *out_flat, kg_vec3 *out, kg_error *error) {
    double *heights = calloc(earlier->halves.count + 1, sizeof *heights);
    kg_status status = heights ? kg_origami_heights(earlier, heights, error)
                               : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    size_t n = 0;
    for (size_t i = 0; i < s->loops.count && !status; i++) {
        bool same = earlier == s;
        int32_t parent = kg_loop_in(earlier, s, (int32_t)i);
        int32_t first = earlier->loops.items[parent].first, h = first;
        kg_vec3 up = earlier->groups.items[earlier->loops.items[parent].group].normal;
        double mean = 0, count = 0;
        do {
            mean += heights[h];
            count++;
        } while ((h = kg_next(earlier, h)) != first);
        first = h = s->loops.items[i].first;
        do {
            out_flat[n] = same ? *kg_origin(s, h) : in_space(earlier, parent, paper_at(s, h));
            out[n] = kg_madd(out_flat[n], thickness * (same ? heights[h] : mean / count), up);
            n++;
        } while ((h = kg_next(s, h)) != first);
    }
    free(heights);
    return status;
}

/* Does any corner of the loop whose corners are [first, end) move? */
static bool moves(const kg_vec3 *from, const kg_vec3 *to, size_t first, size_t end, double least) {
    for (size_t i = first; i < end; i++)
        if (kg_dist(from[i], to[i]) > least)
            return true;
    return false;
}

static void turn(kg_turning *t, const kg_fold_axis *axis, size_t first, size_t end) {
    for (size_t i = first; i < end; i++) {
        kg_vec3 opposite = kg_fold_turn(axis, t->start[i], KG_PI);
        kg_vec3 foot = kg_lerp(t->start[i], opposite, 0.5);
        t->radius[i] = kg_sub(t->start[i], foot);
        t->across[i] = kg_sub(kg_fold_turn(axis, t->start[i], KG_PI / 2), foot);
    }
}

kg_status kg_turning_create(const kg_origami *o, size_t topology, size_t step, double thickness,
                            kg_turning *out, kg_error *error) {
    const kg_origami_state *s = kg_origami_state_at(o, topology),
                           *before = kg_origami_state_at(o, step),
                           *after = kg_origami_state_at(o, step + 1);
    kg_fold_axis axis;
    kg_status status = kg_state_fold_axis(before, kg_origami_fold_at(o, step), &axis, error);
    if (status)
        return status;
    kg_turning t = {.angle = axis.angle};
    for (size_t h = 0; h < s->halves.count; h++)
        t.count += s->halves.items[h].loop >= 0;
    kg_vec3 **arrays[] = {&t.start, &t.radius, &t.across, &t.settle};
    kg_vec3 *from = calloc(t.count + 1, sizeof *from), *to = calloc(t.count + 1, sizeof *to);
    status = from && to ? KG_OK : KG_ERR_MEMORY;
    for (int i = 0; i < 4 && !status; i++)
        status = (*arrays[i] = calloc(t.count + 1, sizeof **arrays[i])) ? KG_OK : KG_ERR_MEMORY;
    if (status)
        kg_fail(error, status, "out of memory");
    if (!status)
        status = find_corners(s, before, thickness, from, t.start, error);
    if (!status)
        status = find_corners(s, after, thickness, to, t.settle, error);
    for (size_t i = 0, n = 0; i < s->loops.count && !status; i++) {
        size_t first = n;
        int32_t h = s->loops.items[i].first;
        do
            n++;
        while ((h = kg_next(s, h)) != s->loops.items[i].first);
        if (moves(from, to, first, n, s->touch))
            turn(&t, &axis, first, n);
    }
    for (size_t i = 0; i < t.count && !status; i++) {
        kg_vec3 end = kg_madd(t.start[i], cos(t.angle) - 1, t.radius[i]);
        t.settle[i] = kg_sub(t.settle[i], kg_madd(end, sin(t.angle), t.across[i]));
    }
    free(from);
    free(to);
    if (status) {
        kg_turning_clear(&t);
        return status;
    }
    *out = t;
    return KG_OK;
}

void kg_turning_clear(kg_turning *t) {
    free(t->start);
    free(t->radius);
    free(t->across);
    free(t->settle);
    *t = (kg_turning){0};
}

void kg_turning_weights(const kg_turning *t, double fraction, double out[3]) {
    out[0] = cos(fraction * t->angle) - 1;
    out[1] = sin(fraction * t->angle);
    out[2] = fraction;
}
