#include "trim/chain.h"

#include "base/array.h"

#include <stdlib.h>

kg_status kg_chains_add(kg_chains *chains, kg_chain chain) {
    if (kg_push(chains, chain))
        return KG_OK;
    free(chain.points);
    return KG_ERR_MEMORY;
}

void kg_chains_clear(kg_chains *chains) {
    for (size_t i = 0; i < chains->count; i++)
        free(chains->items[i].points);
    free(chains->items);
    *chains = (kg_chains){0};
}

kg_cross_point kg_chain_at(const kg_patch *patch, const kg_chain *chain, size_t i, double fraction,
                           kg_cross_point *out_slope) {
    const kg_cross_point *p = &chain->points[i];
    if (!kg_chain_is_straight(chain)) {
        kg_crossing span = {.count = 2, .points = chain->points + i};
        return kg_crossing_at(patch, chain->other, &span, 0, fraction, out_slope);
    }
    double du = p[1].u - p[0].u, dv = p[1].v - p[0].v;
    kg_cross_point r = {.u = p[0].u + fraction * du, .v = p[0].v + fraction * dv};
    if (!out_slope) {
        r.x = kg_patch_point(patch, r.u, r.v);
        return r;
    }
    kg_vec3 xu, xv;
    r.x = kg_patch_derivatives(patch, r.u, r.v, &xu, &xv);
    *out_slope = (kg_cross_point){.u = du, .v = dv};
    out_slope->x = kg_add(kg_scale(xu, du), kg_scale(xv, dv));
    return r;
}

double kg_nearest_fraction(kg_vec2 p, kg_vec2 a, kg_vec2 b) {
    kg_vec2 d = kg_sub2(b, a);
    double n = kg_dot2(d, d), f = n > 0 ? kg_dot2(kg_sub2(p, a), d) / n : 0;
    return kg_min(kg_max(f, 0), 1);
}

/* Curves are sampled so that they leave their chords by less than this share of the chord. */
#define SAGITTA 0.1
enum { NEAREST_STEPS = 5 };

bool kg_chain_passes(const kg_patch *patch, const kg_chain *chain, size_t i, kg_vec2 place,
                     double *out_fraction, kg_cross_point *out_point) {
    kg_vec2 a = kg_chain_plane(patch, chain, i), b = kg_chain_plane(patch, chain, i + 1);
    double snap = KG_NODE_SNAP * patch->size, f = kg_nearest_fraction(place, a, b);
    double gap = kg_dist2(place, kg_lerp2(a, b, f));
    if (kg_dist2(place, a) <= snap || kg_dist2(place, b) <= snap) {
        f = kg_dist2(place, a) <= kg_dist2(place, b) ? 0 : 1;
        *out_fraction = f;
        *out_point = chain->points[f == 0 ? i : i + 1];
        return true;
    }
    if (gap > snap + (kg_chain_is_straight(chain) ? 0 : SAGITTA * kg_dist2(a, b)))
        return false;
    /* the curve's own nearest point: steps along its tangent */
    for (int step = 0; step < NEAREST_STEPS; step++) {
        kg_cross_point slope;
        *out_fraction = f;
        *out_point = kg_chain_at(patch, chain, i, f, &slope);
        kg_vec2 off = kg_sub2(place, kg_plane(patch, out_point->u, out_point->v));
        kg_vec2 along = kg_plane(patch, slope.u, slope.v);
        if (kg_len2(off) <= snap)
            return true;
        f += kg_dot2(off, along) / kg_dot2(along, along);
        if (!(f >= 0 && f <= 1))
            return false;
    }
    return false;
}

double kg_chains_ray(const kg_patch *patch, const kg_chains *chains, kg_vec2 from, kg_vec2 to) {
    kg_vec2 d = kg_sub2(to, from);
    double best = INFINITY, away = KG_NODE_SNAP * patch->size / kg_len2(d);
    for (size_t i = 0; i < chains->count; i++) {
        const kg_chain *c = &chains->items[i];
        kg_vec2 p = kg_plane(patch, c->points[0].u, c->points[0].v);
        for (size_t k = 1; k < c->count; k++) {
            kg_vec2 q = kg_plane(patch, c->points[k].u, c->points[k].v);
            kg_vec2 e = kg_sub2(q, p), g = kg_sub2(p, from);
            double den = kg_cross2(d, e);
            if (den != 0) {
                double f = kg_cross2(g, e) / den, h = kg_cross2(g, d) / den;
                if (h >= 0 && h <= 1 && f > away && f < best)
                    best = f;
            }
            p = q;
        }
    }
    return best;
}

bool kg_chains_touch(const kg_patch *patch, const kg_chains *chains, size_t chain, bool last) {
    const kg_chain *own = &chains->items[chain];
    kg_vec2 at = kg_chain_plane(patch, own, last ? own->count - 1 : 0);
    for (size_t i = 0; i < chains->count; i++) {
        double fraction;
        kg_cross_point point;
        for (size_t k = 0; k + 1 < chains->items[i].count && i != chain; k++)
            if (kg_chain_passes(patch, &chains->items[i], k, at, &fraction, &point))
                return true;
    }
    return false;
}
