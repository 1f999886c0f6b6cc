/*
 * katagami: trimmed regions of patches.
 *
 * A region is a connected piece of a patch: a polygon with holes in its (u,v) plane whose edges
 * know where they come from. Edges are curves: outline, contour and tail edges are straight in
 * (u,v), cut edges lie exactly on the patch that cut them. Points between the stored ones come
 * from kg_region_edge_at, so lengths and areas are exact although loops are stored as polylines.
 */
#ifndef KATAGAMI_TRIM_H
#define KATAGAMI_TRIM_H

#include "katagami/crossing.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum kg_edge_kind {
    KG_EDGE_OUTLINE, /* a side of the rectangle; source: 0 u low, 1 u high, 2 v low, 3 v high */
    KG_EDGE_CONTOUR, /* drawn by hand; source: number of the trim in its patch's list */
    KG_EDGE_CUT,     /* on another patch; source: that patch's id */
    KG_EDGE_TAIL,    /* where a cut was prolonged or joined to another; source as for cuts */
    KG_EDGE_SPLIT /* a ruling along which a large part was cut in two; source: number of the cut */
} kg_edge_kind;

/* A run of a loop's points: points[first] … points[first + count], the last shared with the next
 * edge (indices wrap). */
typedef struct kg_region_edge {
    kg_edge_kind kind;
    int64_t source;
    size_t first, count;
} kg_region_edge;

/* A closed loop, the paper on its left in the (u right, v up) plane. points[i].s and .t are the
 * cutting patch's coordinates on cut edges. Where two edges meet the point belongs to the edge
 * that starts there; the one that ends there finds its own s, t in `ends`. */
typedef struct kg_region_loop {
    size_t point_count;
    kg_cross_point *points;
    size_t edge_count;
    kg_region_edge *edges;
    kg_cross_point *ends; /* one per edge: its last point with its own s, t */
} kg_region_loop;

typedef struct kg_region {
    size_t loop_count; /* the outer loop first, then holes */
    kg_region_loop *loops;
} kg_region;

typedef struct kg_regions {
    size_t count;
    kg_region *items;
} kg_regions;

/* What happened on the way that the user should know. */
typedef enum kg_trim_note_kind {
    KG_NOTE_PROLONGED, /* a cut ended inside and was prolonged by `length` */
    KG_NOTE_JOINED,    /* two cuts missed each other and were joined over `length` */
    KG_NOTE_OUTSIDE    /* a cut lies wholly outside what is left of the patch: no effect */
} kg_trim_note_kind;

typedef struct kg_trim_note {
    kg_trim_note_kind kind;
    int64_t source; /* the cutter */
    kg_vec3 place;
    double length; /* mm on the patch */
} kg_trim_note;

typedef struct kg_trim_notes {
    kg_trim_note *items;
    size_t count, capacity;
} kg_trim_notes;

/* Finds a patch by its id; never NULL for the source of a cut edge. */
typedef struct kg_patch_finder {
    const kg_patch *(*find)(const void *user, int64_t id);
    const void *user;
} kg_patch_finder;

/* One cutting patch. */
typedef struct kg_cut {
    int64_t source;
    const kg_patch *cutter;
    const kg_crossings *crossings; /* A: the patch to be trimmed, B: the cutter */
    const kg_regions *bounded;     /* NULL: the whole rectangle cuts; else only these regions,
                                      with their boundary */
} kg_cut;

/* The whole rectangle of a patch. `tolerance`: greatest chord error of loops, mm. */
KG_API kg_status kg_regions_rectangle(const kg_patch *patch, double tolerance,
                                      kg_regions *out_regions, kg_error *error) KG_CHECKED;
KG_API void kg_regions_clear(kg_regions *regions);

/* What all trims of one patch have in common. */
typedef struct kg_trim {
    const kg_patch *patch;
    kg_patch_finder finder; /* knows the patches that made earlier cuts */
    double tolerance;       /* mm, greatest chord error of loops */
    kg_trim_notes *notes;   /* appended to; may be NULL */
} kg_trim;

/* Single-surface trim: all branches split the regions; each point of `keep` keeps the piece
 * nearest to it; no points keep every piece. A branch that ends inside is prolonged along its
 * tangent. KG_ERR_INPUT: the cutter, or what is left of a bounded one, misses. */
KG_API kg_status kg_trim_by(const kg_trim *trim, const kg_regions *regions, const kg_cut *cut,
                            const kg_vec3 *keep, size_t keep_count, kg_regions *out_regions,
                            kg_error *error) KG_CHECKED;

/* Multi-surface trim: keeps the face away from the outline that borders every cutter; where there
 * are several, those named by `keep`. Tails beyond a crossing are dropped, ends that miss each
 * other joined. KG_ERR_INPUT: a cutter misses (as above); no such face; several and no `keep`. */
KG_API kg_status kg_trim_inside(const kg_trim *trim, const kg_regions *regions, const kg_cut *cuts,
                                size_t cut_count, const kg_vec3 *keep, size_t keep_count,
                                kg_regions *out_regions, kg_error *error) KG_CHECKED;

/* Keeps what is inside (or outside) a polygon in (u, v): polygon[i].x is u in mm, .y is v.
 *   source  number of the trim, for the edges
 * KG_ERR_INPUT: fewer than 3 corners, no area, crosses itself, keeps nothing. */
KG_API kg_status kg_trim_contour(const kg_trim *trim, const kg_regions *regions,
                                 const kg_vec2 *polygon, size_t corner_count, bool inside,
                                 int64_t source, kg_regions *out_regions,
                                 kg_error *error) KG_CHECKED;

/* Cuts a region along the ruling at `v` into the pieces on both sides of it.
 *   source  number of the cut, for the new edges */
KG_API kg_status kg_region_split(const kg_trim *trim, const kg_region *region, double v,
                                 int64_t source, kg_regions *out_regions,
                                 kg_error *error) KG_CHECKED;

/* Is (u, v) in the region (its polyline)? */
KG_API bool kg_region_contains(const kg_region *region, double u, double v);

/* Distance from a point in space to the trimmed surface. */
KG_API double kg_region_distance(const kg_patch *patch, const kg_region *region, kg_vec3 point);

/* What an edge (or a stretch of it) measures, in space and on paper, each by quadrature of its own
 * surface along the exact curve. Moments sum up to areas around a region (Green's theorem). */
typedef struct kg_measure {
    double space_length, paper_length; /* mm */
    double space_moment, paper_moment; /* mm² */
} kg_measure;

/* The edge from position `from` to `to`, 0 <= from <= to <= count, where position i + f is fraction
 * f between its points i and i + 1. `cutter`: the patch of a cut edge, ignored for others. */
KG_API kg_measure kg_region_edge_measure(const kg_patch *patch, const kg_region_loop *loop,
                                         const kg_region_edge *edge, const kg_patch *cutter,
                                         double from, double to);

/* The whole boundary: perimeter and area (the moments), in space and on paper. */
KG_API kg_measure kg_region_measure(const kg_patch *patch, const kg_region *region,
                                    kg_patch_finder finder);

/* The exact point of an edge between its points `i` and `i + 1` (0 <= i < count) at `fraction`,
 * and its derivative (may be NULL). `cutter` is the patch of a cut edge, ignored for others. */
KG_API kg_cross_point kg_region_edge_at(const kg_patch *patch, const kg_region_loop *loop,
                                        const kg_region_edge *edge, const kg_patch *cutter,
                                        size_t i, double fraction, kg_cross_point *out_slope);

/* The edge's own point i (0 … count), with its own s, t. */
KG_API kg_cross_point kg_region_edge_point(const kg_region_loop *loop, const kg_region_edge *edge,
                                           size_t i);

/* ---- triangles -------------------------------------------------------------------------- */

typedef struct kg_vertex {
    kg_vec3 position, normal; /* unit, to the front */
    double u, v;
} kg_vertex;

typedef struct kg_tessellation {
    size_t vertex_count; /* the points of the loops in their order */
    kg_vertex *vertices;
    size_t triangle_count;
    uint32_t *triangles; /* 3 indices each, counter-clockwise about the front normal */
} kg_tessellation;

/* Triangles of a region with all vertices on its boundary: regions that share boundary points
 * share vertices, and the chord error is that of the loops. KG_ERR_INPUT: a boundary that touches
 * itself so that it bounds no area. */
KG_API kg_status kg_region_tessellate(const kg_patch *patch, const kg_region *region,
                                      kg_tessellation *out_tessellation,
                                      kg_error *error) KG_CHECKED;
KG_API void kg_tessellation_clear(kg_tessellation *tessellation);

#ifdef __cplusplus
}
#endif
#endif
