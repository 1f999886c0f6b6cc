/*
 * The planar map that curves cut a patch's (u,v) plane into.
 *
 * Plane coordinates are (u, v L): L, the geodesic's length, makes both axes millimetres. Chains
 * (polylines of exact points) are noded where they cross, each node polished onto the exact curves,
 * and the faces between them are traced. Every arc knows which labels change across it, so a flood
 * from the unbounded face tells what each face is part of.
 */
#ifndef KG_TRIM_ARRANGEMENT_H
#define KG_TRIM_ARRANGEMENT_H

#include "katagami/trim.h"

/* Nodes nearer than this fraction of the patch's size are one: a hundred times what crossings are
 * polished to, a thousandth of what a cutter can follow. */
#define KG_NODE_SNAP 1e-7

enum {
    KG_LABEL_REGION = 1, /* the arc bounds what was left of the patch before */
    KG_LABEL_CONTOUR = 2 /* the arc bounds a contour being applied */
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

/* A stretch of a chain between two nodes. */
typedef struct kg_arc {
    size_t chain;
    size_t first, count; /* points in the arrangement's pool, both ends included */
    size_t node[2];
    unsigned labels;
    bool dropped;   /* dangling, or the double of another arc */
    size_t face[2]; /* on the left of the arc as it runs, and on its right */
} kg_arc;

/* Half-edge 2 a runs along arc a, 2 a + 1 against it. */
typedef struct kg_face_loop {
    size_t face;
    size_t first, count; /* half-edges in the arrangement's loop pool */
    double area;         /* signed, positive: the loop bounds its face from outside */
} kg_face_loop;

typedef struct kg_arrangement {
    const kg_patch *patch;
    double scale; /* L */
    double snap;  /* mm */
    const kg_chains *chains;
    kg_vec2 *nodes;
    size_t node_count, node_capacity;
    kg_cross_point *pool;
    size_t pool_count, pool_capacity;
    kg_arc *arcs;
    size_t arc_count, arc_capacity;
    size_t *halfedges;
    size_t halfedge_count, halfedge_capacity;
    kg_face_loop *loops; /* of a face: its outer loop first */
    size_t loop_count, loop_capacity;
    size_t face_count; /* face 0 is the unbounded one */
    unsigned *labels;  /* per face */
} kg_arrangement;

/* Appends a chain and takes over `points`, also on failure. */
kg_status kg_chains_add(kg_chains *chains, kg_chain chain) KG_CHECKED;
void kg_chains_clear(kg_chains *chains);

/* Builds nodes, arcs, faces. Dangling arcs are dropped. `chains` must outlive the arrangement. */
kg_status kg_arrangement_build(const kg_patch *patch, const kg_chains *chains,
                               kg_arrangement *out) KG_CHECKED;
void kg_arrangement_clear(kg_arrangement *arrangement);

/* Where a ray from `from` first meets a chain, as a fraction of `to - from` (beyond 1 allowed),
 * or infinity; hits within the snap distance of `from` do not count. */
double kg_chains_ray(const kg_patch *patch, const kg_chains *chains, kg_vec2 from, kg_vec2 to);

/* Does the end of an open chain lie on some other chain (within the snap distance)? */
bool kg_chains_touch(const kg_patch *patch, const kg_chains *chains, size_t chain, bool last);

/* Plane coordinates of a point. */
static inline kg_vec2 kg_plane(const kg_patch *patch, double u, double v) {
    return kg_v2(u, v * patch->length_at[KG_PATCH_CELLS]);
}

/* The exact point of a chain on its segment i (points i, i + 1) at `fraction`. */
kg_cross_point kg_chain_at(const kg_patch *patch, const kg_chain *chain, size_t i, double fraction,
                           kg_cross_point *out_slope);

#endif
