/*
 * The planar map that curves cut a patch's (u,v) plane into.
 *
 * Chains are noded where they cross, each node polished onto the exact curves, and the faces
 * between them are traced. Every arc knows which labels change across it, so a flood from the
 * unbounded face tells what each face is part of.
 */
#ifndef KG_TRIM_ARRANGEMENT_H
#define KG_TRIM_ARRANGEMENT_H

#include "trim/chain.h"

#define KG_NO_ARC SIZE_MAX

/* A stretch of a chain between two nodes. */
typedef struct kg_arc {
    size_t chain;
    size_t first, count; /* points in the arrangement's pool, both ends included */
    size_t node[2];
    unsigned labels;
    bool dropped;   /* dangling, a bridge, or the double of another arc */
    size_t doubles; /* the older arc it lies on, KG_NO_ARC if none */
    size_t face[2]; /* on the left of the arc as it runs, and on its right */
} kg_arc;

/* Half-edge 2 a runs along arc a, 2 a + 1 against it. */
typedef struct kg_face_loop {
    size_t face;
    size_t cycle;        /* loops that touch in nodes and bound one face share it */
    size_t first, count; /* half-edges in the arrangement's loop pool */
    double area;         /* signed, positive: the loop bounds its face from outside */
    double length;       /* in the plane */
} kg_face_loop;

typedef struct kg_arrangement {
    const kg_patch *patch;
    double scale; /* L */
    double snap;  /* mm */
    kg_chains *chains;
    size_t halvings; /* of segments whose chords crossed though the curves did not */
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

/* Builds nodes, arcs, faces. Arcs that divide nothing (dangling, bridges) are dropped. `chains`
 * may get more points and must outlive the arrangement. */
kg_status kg_arrangement_build(const kg_patch *patch, kg_chains *chains,
                               kg_arrangement *out) KG_CHECKED;
void kg_arrangement_clear(kg_arrangement *arrangement);

/* The steps of building: nodes and arcs are there, faces follow (faces.c). */
kg_status kg_arrangement_faces(kg_arrangement *arrangement) KG_CHECKED;

/* Areas narrower than this fraction of the patch (area over size and length) are what rounding
 * leaves between nearly coincident curves, not paper. */
#define KG_SLIVER 2e-7

static inline bool kg_is_sliver(const kg_arrangement *a, double area, double length) {
    return fabs(area) <= KG_SLIVER * a->patch->size * length;
}

static inline kg_vec2 kg_pool_plane(const kg_arrangement *a, size_t i) {
    return kg_plane(a->patch, a->pool[i].u, a->pool[i].v);
}
/* Point i of an arc; its ends are its nodes, so that loops close. */
static inline kg_vec2 kg_arc_plane(const kg_arrangement *a, const kg_arc *arc, size_t i) {
    return i == 0                ? a->nodes[arc->node[0]]
           : i + 1 == arc->count ? a->nodes[arc->node[1]]
                                 : kg_pool_plane(a, arc->first + i);
}
static inline size_t kg_half_origin(const kg_arrangement *a, size_t h) {
    return a->arcs[h / 2].node[h & 1];
}

#endif
