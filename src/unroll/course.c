#include "unroll/course.h"

#include "unroll/stretch.h"

#include <stdint.h>

/* ---- where joins run --------------------------------------------------------------------- */

/* Points of a stretch, evenly along its chords, both ends included. */
static void trace(const kg_pieces *all, const kg_stretch *s, kg_cross_point out[KG_JOIN_PLACES]) {
    double positions[KG_JOIN_PLACES] = {s->from};
    kg_stretch_divide(all, s, KG_JOIN_PLACES - 1, positions + 1);
    positions[KG_JOIN_PLACES - 1] = s->to;
    for (int i = 0; i < KG_JOIN_PLACES; i++)
        out[i] = kg_piece_point(all, s->edge, positions[i], NULL);
}

/* Written with so few digits: seams are farther apart. */
static double rounded(double x, double steps) {
    return round(x * steps) / steps;
}

void kg_course_of_stretch(const kg_pieces *all, const kg_stretch *s, kg_net_join *join) {
    kg_cross_point points[KG_JOIN_PLACES];
    trace(all, s, points);
    for (int i = 0; i < KG_JOIN_PLACES; i++) {
        join->course[0][i] = kg_v2(points[i].u, points[i].v);
        join->course[1][i] = kg_v2(points[i].s, points[i].t);
    }
    if (s->seam) {
        trace(all, &all->stretches[s->mate], points);
        for (int i = 0; i < KG_JOIN_PLACES; i++) {
            const kg_cross_point *p = &points[s->mate_reversed ? KG_JOIN_PLACES - 1 - i : i];
            join->course[1][i] = kg_v2(p->u, p->v);
        }
    }
    kg_vec2 middle = join->course[0][KG_JOIN_PLACES / 2];
    join->at = kg_v2(rounded(middle.x, 100), rounded(middle.y, 10000));
}

/* ---- which join is meant ----------------------------------------------------------------- */

static double segment_distance(kg_vec2 at, kg_vec2 a, kg_vec2 b) {
    kg_vec2 d = kg_sub2(b, a);
    double n = kg_dot2(d, d), f = n > 0 ? kg_dot2(kg_sub2(at, a), d) / n : 0;
    return kg_dist2(at, kg_lerp2(a, b, fmin(fmax(f, 0), 1)));
}

/* From a place to a side of a join, v counted as if the geodesic were run through evenly. */
static double side_distance(const kg_net_join *join, int side, double length, kg_vec2 at) {
    const kg_vec2 *c = join->course[side];
    double nearest = HUGE_VAL;
    for (int i = 1; i < KG_JOIN_PLACES; i++)
        nearest = fmin(nearest, segment_distance(kg_v2(at.x, length * at.y),
                                                 kg_v2(c[i - 1].x, length * c[i - 1].y),
                                                 kg_v2(c[i].x, length * c[i].y)));
    return nearest;
}

size_t kg_net_nearest_join(const kg_net *net, const kg_solution *solution, const int64_t patches[2],
                           kg_vec2 at, double *out_distance) {
    const kg_solved_patch *p = kg_solution_find(solution, patches[0]);
    size_t best = SIZE_MAX;
    *out_distance = HUGE_VAL;
    for (size_t i = 0; p && p->prepared && i < net->join_count; i++)
        for (int side = 0; side < 2; side++) {
            const kg_net_join *j = &net->joins[i];
            if (j->sources[side] != patches[0] || j->sources[1 - side] != patches[1])
                continue;
            double d = side_distance(j, side, p->patch.length_at[KG_PATCH_CELLS], at);
            if (d < *out_distance) {
                *out_distance = d;
                best = i;
            }
        }
    return best;
}

void kg_unroll_wishes(const kg_model *model, const kg_solution *solution, const kg_net *net,
                      size_t *out_wishes) {
    for (size_t i = 0; i < net->join_count; i++) {
        const kg_model_join *all =
            kg_model_find_join(model, net->joins[i].sources[0], net->joins[i].sources[1]);
        out_wishes[i] = all ? (size_t)(all - model->joins) : SIZE_MAX;
    }
    for (size_t w = 0; w < model->join_count; w++) {
        const kg_model_join *wish = &model->joins[w];
        double distance, before;
        size_t join = wish->has_at
                          ? kg_net_nearest_join(net, solution, wish->patches, wish->at, &distance)
                          : SIZE_MAX;
        if (join == SIZE_MAX)
            continue;
        const kg_model_join *other =
            out_wishes[join] == SIZE_MAX ? NULL : &model->joins[out_wishes[join]];
        if (other && other->has_at) {
            const kg_net one = {.join_count = 1, .joins = &net->joins[join]};
            kg_net_nearest_join(&one, solution, other->patches, other->at, &before);
            if (before <= distance)
                continue;
        }
        out_wishes[join] = w;
    }
}
