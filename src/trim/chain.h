/*
 * Chains: the curves an arrangement is made of, as polylines of exact points.
 *
 * Plane coordinates are (u, v L): L, the geodesic's length, makes both axes millimetres.
 */
#ifndef KG_TRIM_CHAIN_H
#define KG_TRIM_CHAIN_H

#include "katagami/trim.h"

/* What is nearer than this fraction of the patch's size is one: a hundred times what crossings are
 * polished to, a thousandth of what a cutter can follow. */
#define KG_NODE_SNAP 1e-7

enum {
    KG_LABEL_REGION = 1, /* the chain bounds what was left of the patch before */
    KG_LABEL_CONTOUR = 2 /* the chain bounds a contour being applied */
};

typedef struct kg_chain {
    kg_edge_kind kind;
    int64_t source;
    const kg_patch *other; /* cut chains: the cutter */
    unsigned labels;       /* what changes across the chain */
    bool closed;           /* the first point is repeated at the end */
    size_t count;
    kg_cross_point *points; /* owned */
} kg_chain;

typedef struct kg_chains {
    kg_chain *items;
    size_t count, capacity;
} kg_chains;

/* Appends a chain and takes over `points`, also on failure. */
kg_status kg_chains_add(kg_chains *chains, kg_chain chain) KG_CHECKED;
void kg_chains_clear(kg_chains *chains);

/* Plane coordinates of a point. */
static inline kg_vec2 kg_plane(const kg_patch *patch, double u, double v) {
    return kg_v2(u, v * patch->length_at[KG_PATCH_CELLS]);
}
static inline kg_vec2 kg_chain_plane(const kg_patch *patch, const kg_chain *chain, size_t i) {
    return kg_plane(patch, chain->points[i].u, chain->points[i].v);
}

/* Cuts bend between their points; all other chains are straight there in (u,v). */
static inline bool kg_chain_is_straight(const kg_chain *chain) {
    return chain->kind != KG_EDGE_CUT;
}

/* The exact point of a chain on its segment i (points i, i + 1) at `fraction`. */
kg_cross_point kg_chain_at(const kg_patch *patch, const kg_chain *chain, size_t i, double fraction,
                           kg_cross_point *out_slope);

/* Fraction of the segment from a to b that is nearest to p. */
double kg_nearest_fraction(kg_vec2 p, kg_vec2 a, kg_vec2 b);

/* Does the exact curve of segment i pass within the snap distance of a place in the plane? The
 * fraction and the curve's own point there. */
bool kg_chain_passes(const kg_patch *patch, const kg_chain *chain, size_t i, kg_vec2 place,
                     double *out_fraction, kg_cross_point *out_point);

/* Where a ray from `from` first meets a chain, as a fraction of `to - from` (beyond 1 allowed),
 * or infinity; hits within the snap distance of `from` do not count. */
double kg_chains_ray(const kg_patch *patch, const kg_chains *chains, kg_vec2 from, kg_vec2 to);

/* Does the end of an open chain lie on some other chain (within the snap distance)? */
bool kg_chains_touch(const kg_patch *patch, const kg_chains *chains, size_t chain, bool last);

#endif
