/* Building and changing states. */
#ifndef KG_ORIGAMI_STATE_H
#define KG_ORIGAMI_STATE_H

#include "base/array.h"
#include "katagami/origami.h"

/* Tolerances, all relative to the size of the sheets.
 * Rounding of rotations and cuts, which stays below 1e-13 in a dozen folds: what is nearer to an
 * axis or a plane than this is on it. Faces stay congruent to 1e-9 although points on an axis do
 * not move. */
#define KG_ON_AXIS 1e-10
#define KG_ON_PLANE 1e-8
/* Overlaps narrower than this are none (the state's `touch`), but for patterns whose numbers are
 * less exact. */
#define KG_OVERLAP 1e-7
/* An axis this near a vertex is meant to go through it; cutting beside it leaves slivers. */
#define KG_SNAP 1e-6
/* Points that people give, with few digits, mean vertices this near. */
#define KG_PICK 1e-3
/* Radians: the least angle of a fold; fold angles this near 0 or a half turn are that. */
#define KG_LEAST_ANGLE 1e-9

static inline int32_t kg_twin(int32_t half) {
    return half ^ 1;
}

kg_origami_state *kg_state_create(void);
/* Frees a state once as often as it was created and shared. */
void kg_state_destroy(kg_origami_state *state);
/* The same state for one more holder; it must not change any more. */
kg_origami_state *kg_state_share(kg_origami_state *state);
/* A copy without the layers, which are going to be others. */
kg_origami_state *kg_state_copy(const kg_origami_state *state);

/* Faces as lists of vertices, counter-clockwise in paper coordinates: face i has the corners
 * corners[starts[i]] … corners[starts[i + 1] - 1]. */
typedef struct kg_face_list {
    struct {
        int32_t *items;
        size_t count, capacity;
    } corners, starts;
} kg_face_list;

kg_status kg_face_list_add(kg_face_list *list, const int32_t *corners, size_t count);
void kg_face_list_clear(kg_face_list *list);

/* Adds an edge between two vertices with no loop on either side yet. */
kg_status kg_state_add_edge(kg_origami_state *state, int32_t from, int32_t to,
                            kg_paper_edge_kind kind, double angle);
/* Makes loops of faces whose edges are all there; concave ones are divided by edges of kind
 * KG_PAPER_JOIN. KG_ERR_INPUT naming the face for edges that are missing or have two faces on one
 * side, and for faces that cross themselves. */
kg_status kg_state_add_faces(kg_origami_state *state, int32_t sheet, const kg_face_list *faces,
                             kg_error *error);

/* A new vertex at `t` in (0, 1) of a half-edge; `*out_vertex` is its index. The half-edge keeps
 * its origin, its twin then starts from the new vertex. */
kg_status kg_state_split_edge(kg_origami_state *state, int32_t half, double t, int32_t *out_vertex);
/* A crease across the loop left of two half-edges, between their origins. The loop keeps the side
 * of `h`, up to `k`; the side that starts with `k` becomes a new loop, the last one. */
kg_status kg_state_split_loop(kg_origami_state *state, int32_t h, int32_t k);

/* Corners of a loop as plane coordinates along u and v (paper coordinates: u NULL). Returns how
 * many; `out` may be NULL. */
size_t kg_state_polygon(const kg_origami_state *state, int32_t loop, const kg_vec3 *u,
                        const kg_vec3 *v, kg_vec2 *out);

static inline const kg_vec3 *kg_origin(const kg_origami_state *s, int32_t half) {
    return &s->vertices.items[s->halves.items[half].origin].position;
}
static inline int32_t kg_next(const kg_origami_state *s, int32_t half) {
    return s->halves.items[half].next;
}
static inline int32_t kg_loop_of(const kg_origami_state *s, int32_t half) {
    return s->halves.items[half].loop;
}

/* The loop of an earlier state of the same folding that `loop` was part of. */
static inline int32_t kg_loop_in(const kg_origami_state *earlier, const kg_origami_state *s,
                                 int32_t loop) {
    while ((size_t)loop >= earlier->loops.count)
        loop = s->loops.items[loop].parent;
    return loop;
}

/* Sets size and touch from the paper coordinates. */
void kg_state_measure(kg_origami_state *state);

#endif
