/* Axes of folds, and turning about them. */
#include "origami/folding.h"

#include "origami/convex.h"

#include <stdlib.h>

/* 2 π / 360 */
static const double DEGREE = 0.017453292519943295;

/* ---- turning ---------------------------------------------------------------------------- */

static void sine_cosine(double angle, double *out_sine, double *out_cosine) {
    double quarters = angle / (90 * DEGREE);
    int q = (int)quarters;
    if (quarters == q && q >= -2 && q <= 2) {
        static const double sines[] = {0, -1, 0, 1, 0}, cosines[] = {-1, 0, 1, 0, -1};
        *out_sine = sines[q + 2], *out_cosine = cosines[q + 2];
    } else {
        *out_sine = sin(angle), *out_cosine = cos(angle);
    }
}

/* In the frame of the axis a point is (x, y, z) along side, normal and axis; turning by t takes it
 * to (x cos t - y sin t, x sin t + y cos t, z). */
kg_vec3 kg_fold_turn(const kg_fold_axis *f, kg_vec3 p, double angle) {
    double s, c;
    sine_cosine(angle, &s, &c);
    kg_vec3 r = kg_sub(p, f->origin);
    double x = kg_dot(r, f->side), y = kg_dot(r, f->normal);
    p = kg_madd(p, x * c - y * s - x, f->side);
    return kg_madd(p, x * s + y * c - y, f->normal);
}

kg_vec3 kg_fold_velocity(const kg_fold_axis *f, kg_vec3 p) {
    kg_vec3 r = kg_sub(p, f->origin);
    double turn = f->angle > 0 ? 1 : -1;
    return kg_add(kg_scale(f->side, -turn * kg_dot(r, f->normal)),
                  kg_scale(f->normal, turn * kg_dot(r, f->side)));
}

double kg_fold_radius(const kg_fold_axis *f, kg_vec3 p) {
    kg_vec3 r = kg_sub(p, f->origin);
    return hypot(kg_dot(r, f->side), kg_dot(r, f->normal));
}

/* ---- finding the axis ------------------------------------------------------------------- */

/* The vertex that a point means; -1 when none is near. */
static int32_t vertex_near(const kg_origami_state *s, kg_vec3 p) {
    int32_t best = -1;
    double least = KG_PICK * s->size;
    for (size_t i = 0; i < s->vertices.count; i++) {
        double d = kg_dist(s->vertices.items[i].position, p);
        if (d < least)
            best = (int32_t)i, least = d;
    }
    return best;
}

static kg_vec3 snapped(const kg_origami_state *s, kg_vec3 p) {
    int32_t v = vertex_near(s, p);
    return v < 0 ? p : s->vertices.items[v].position;
}

static bool group_holds(const kg_origami_state *s, int32_t group, const kg_vec3 *points,
                        size_t count) {
    const kg_face_group *g = &s->groups.items[group];
    for (size_t i = 0; i < count; i++) /* points given with few digits may lie beside it */
        if (fabs(kg_dot(g->normal, points[i]) - g->offset) > KG_PICK * s->size)
            return false;
    return true;
}

static bool has_corner(const kg_origami_state *s, size_t loop, kg_vec3 p) {
    int32_t first = s->loops.items[loop].first, h = first;
    do {
        if (kg_dist(*kg_origin(s, h), p) < KG_ON_PLANE * s->size)
            return true;
    } while ((h = kg_next(s, h)) != first);
    return false;
}

/* The group of the picked loop, or the first one with a loop at the vertex that holds the points.
 */
static kg_status find_group(const kg_origami_state *s, const kg_fold *fold, kg_vec3 vertex,
                            const kg_vec3 points[2], int32_t *out_group, kg_error *error) {
    if (fold->face >= 0) {
        if ((size_t)fold->face >= s->loops.count)
            return kg_fail(error, KG_ERR_INPUT, "there is no face %d: they go from 0 to %zu",
                           fold->face, s->loops.count - 1);
        *out_group = s->loops.items[fold->face].group;
        if (!group_holds(s, *out_group, points, 2))
            return kg_fail(error, KG_ERR_INPUT, "the axis does not lie in the plane of face %d",
                           fold->face);
        return KG_OK;
    }
    int32_t best = -1;
    for (size_t i = 0; i < s->loops.count; i++) {
        int32_t g = s->loops.items[i].group;
        if ((best < 0 || g < best) && has_corner(s, i, vertex) && group_holds(s, g, points, 2))
            best = g;
    }
    if (best < 0)
        return kg_fail(error, KG_ERR_INPUT,
                       "no face at the vertex lies in one plane with the axis");
    *out_group = best;
    return KG_OK;
}

/* Marks the vertices that lie in the group's loops with 0, others with -2. */
static void mark_vertices(kg_folding *f) {
    const kg_origami_state *s = f->state;
    for (size_t i = 0; i < s->vertices.count; i++)
        f->sides[i] = -2;
    for (size_t h = 0; h < s->halves.count; h++) {
        int32_t loop = s->halves.items[h].loop;
        if (loop >= 0 && s->loops.items[loop].group == f->axis.group)
            f->sides[s->halves.items[h].origin] = 0;
    }
}

/* An axis that all but goes through vertices goes through them: through the two farthest apart, or
 * the only one. */
static void snap_axis(kg_folding *f) {
    const kg_origami_state *s = f->state;
    kg_fold_axis *a = &f->axis;
    int32_t lo = -1, hi = -1;
    double least = 0, most = 0;
    for (size_t i = 0; i < s->vertices.count; i++) {
        kg_vec3 r = kg_sub(s->vertices.items[i].position, a->origin);
        double t = kg_dot(r, a->axis);
        if (f->sides[i] == -2 || fabs(kg_dot(r, a->side)) > KG_SNAP * s->size)
            continue;
        if (lo < 0 || t < least)
            lo = (int32_t)i, least = t;
        if (hi < 0 || t > most)
            hi = (int32_t)i, most = t;
    }
    if (lo < 0)
        return;
    a->origin = s->vertices.items[lo].position;
    if (most - least > KG_PICK * s->size) {
        kg_vec3 d = kg_sub(s->vertices.items[hi].position, a->origin);
        a->side = kg_unit(kg_cross(a->normal, d));
        a->axis = kg_cross(a->side, a->normal);
    }
}

static kg_status find_axis(kg_folding *f, const kg_fold *fold, kg_error *error) {
    const kg_origami_state *s = f->state;
    kg_fold_axis *a = &f->axis;
    kg_vec3 wanted = fold->by_axis ? fold->vertex : fold->points[0];
    int32_t vertex = vertex_near(s, wanted);
    if (vertex < 0)
        return kg_fail(error, KG_ERR_INPUT, "there is no vertex at (%g, %g, %g)", wanted.x,
                       wanted.y, wanted.z);
    kg_vec3 start = s->vertices.items[vertex].position;
    kg_vec3 points[2] = {snapped(s, fold->points[0]), snapped(s, fold->points[1])};
    kg_status status = find_group(s, fold, start, points, &a->group, error);
    if (status)
        return status;
    a->normal = s->groups.items[a->group].normal;
    kg_vec3 d = kg_sub(points[1], points[0]);
    d = kg_madd(d, -kg_dot(d, a->normal), a->normal);
    if (!(kg_len(d) > KG_PICK * s->size))
        return kg_fail(error, KG_ERR_INPUT, "the two points of the fold are the same");
    d = kg_unit(d);
    if (fold->by_axis) {
        a->origin = points[0];
        a->side = kg_cross(a->normal, d);
        if (kg_dot(kg_sub(start, a->origin), a->side) < 0)
            a->side = kg_neg(a->side);
    } else {
        a->origin = kg_lerp(points[0], points[1], 0.5);
        a->side = kg_neg(d);
    }
    double off = kg_dot(a->normal, a->origin) - s->groups.items[a->group].offset;
    a->origin = kg_madd(a->origin, -off, a->normal);
    a->axis = kg_cross(a->side, a->normal);
    a->angle = fold->angle_deg * DEGREE;
    if (!(fabs(fold->angle_deg) <= 180) || fabs(a->angle) < KG_LEAST_ANGLE)
        return kg_fail(error, KG_ERR_INPUT, "%g degrees: folds turn by up to 180, and not by 0",
                       fold->angle_deg);
    mark_vertices(f);
    snap_axis(f);
    if (kg_dot(kg_sub(start, a->origin), a->side) <= KG_SNAP * s->size)
        return kg_fail(error, KG_ERR_INPUT, "the vertex lies on the axis, not beside it");
    return KG_OK;
}

static void find_sides(kg_folding *f) {
    const kg_origami_state *s = f->state;
    double tolerance = KG_ON_AXIS * s->size;
    for (size_t i = 0; i < s->vertices.count; i++) {
        double d = kg_dot(kg_sub(s->vertices.items[i].position, f->axis.origin), f->axis.side);
        if (f->sides[i] != -2)
            f->sides[i] = d > tolerance ? 1 : d < -tolerance ? -1 : 0;
    }
    for (size_t h = 0; h < s->halves.count; h++) {
        int32_t loop = s->halves.items[h].loop;
        int side = f->sides[s->halves.items[h].origin];
        if (loop >= 0 && s->loops.items[loop].group == f->axis.group)
            f->reach[loop] |= side == 1 ? 1 : side == -1 ? 2 : 0;
    }
}

static void find_picked(kg_folding *f, const kg_fold *fold) {
    const kg_origami_state *s = f->state;
    int32_t index = vertex_near(s, fold->by_axis ? fold->vertex : fold->points[0]);
    kg_vec3 vertex = s->vertices.items[index].position;
    for (size_t i = 0; i < s->loops.count; i++)
        if (s->loops.items[i].group == f->axis.group && has_corner(s, i, vertex))
            kg_bit_set(f->picked, (int32_t)i);
}

kg_status kg_folding_create(const kg_origami_state *s, const kg_fold *fold, kg_folding *out,
                            kg_error *error) {
    kg_folding f = {.state = s,
                    .sides = calloc(s->vertices.count + 1, 1),
                    .reach = calloc(s->loops.count + 1, 1),
                    .moves = calloc(s->loops.count + 1, sizeof *f.moves),
                    .picked = calloc(kg_layer_words(s->loops.count), sizeof *f.picked),
                    .open = malloc(kg_layer_words(s->loops.count) * sizeof *f.open)};
    kg_status status = f.sides && f.reach && f.moves && f.picked && f.open ? KG_OK : KG_ERR_MEMORY;
    if (!status)
        status = kg_outlines_create(s, &f.outlines);
    if (!status)
        status = find_axis(&f, fold, error);
    if (status) {
        kg_folding_clear(&f);
        return status;
    }
    find_sides(&f);
    find_picked(&f, fold);
    kg_folding_rest(&f);
    *out = f;
    return KG_OK;
}

void kg_folding_clear(kg_folding *f) {
    kg_outlines_clear(&f->outlines);
    free(f->sides);
    free(f->reach);
    free(f->moves);
    free(f->picked);
    free(f->open);
    *f = (kg_folding){0};
}

kg_status kg_state_fold_axis(const kg_origami_state *s, const kg_fold *fold, kg_fold_axis *out_axis,
                             kg_error *error) {
    kg_folding f;
    kg_status status = kg_folding_create(s, fold, &f, error);
    if (status)
        return status;
    *out_axis = f.axis;
    kg_folding_clear(&f);
    return KG_OK;
}

/* ---- picking ---------------------------------------------------------------------------- */

/* The topmost resting loop at the vertex, seen from the side it folds to; -1 when there is none. */
static int32_t topmost(const kg_folding *f) {
    const kg_origami_state *s = f->state;
    int up = f->axis.angle > 0 ? 1 : -1;
    size_t words = s->layers.words;
    for (size_t w = 0; w < words; w++)
        for (uint64_t bits = f->picked[w] & f->open[w]; bits != 0;) {
            int32_t loop = (int32_t)(64 * w) + kg_bit_next(&bits);
            const uint64_t *row = kg_layer_pile(s, &f->outlines, loop, up);
            size_t k = 0;
            while (k < words && !(row[k] & f->picked[k] & f->open[k]))
                k++;
            if (k == words)
                return loop;
        }
    return -1;
}

kg_status kg_folding_pick(kg_folding *f, const kg_fold *fold, kg_error *error) {
    int32_t wanted = fold->layers > 0 ? fold->layers : 1;
    for (int32_t i = 0; i < wanted; i++) {
        int32_t loop = i == 0 && fold->face >= 0 ? fold->face : topmost(f);
        if (loop < 0)
            return kg_fail(error, KG_ERR_INPUT, "only %d layers can move there, not %d", i, wanted);
        kg_status status = kg_folding_move(f, loop, error);
        if (status)
            return status;
    }
    return KG_OK;
}
