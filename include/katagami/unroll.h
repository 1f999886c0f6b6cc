/*
 * katagami: from a solved patch model to a net.
 *
 * Every piece of every patch becomes a part, unrolled exactly. Where an edge of one lies on
 * another, they are joined: edge to edge a seam, edge on the inside a contact, whose curve is
 * drawn as a mark on the other part.
 */
#ifndef KATAGAMI_UNROLL_H
#define KATAGAMI_UNROLL_H

#include "katagami/model.h"
#include "katagami/net.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct kg_unrolled {
    kg_net *net; /* at scale 1, without tabs */
    /* How edges of joins bend in space, for tabs: bends[2 * join + side] is NULL or holds one value
     * per point of that stretch, the turning of the tangent in space since its start, radians. */
    size_t bend_count;
    double **bends;
    size_t *wishes; /* per join, see kg_unroll_wishes */
} kg_unrolled;

/* Unrolls all valid patches that are no construction, parts in the order of the model.
 * KG_ERR_MEMORY only: check the solution first. */
KG_API kg_status kg_unroll(const kg_model *model, const kg_solution *solution,
                           kg_unrolled **out_unrolled, kg_error *error) KG_CHECKED;
/* The same with parts larger than `room` (mm, in any turn; (0,0): no limit) cut in two along a
 * short ruling, joined by a seam, as often as needed. A part that rulings cannot make small enough
 * stays as large as it is. */
KG_API kg_status kg_unroll_to_fit(const kg_model *model, const kg_solution *solution, kg_vec2 room,
                                  kg_unrolled **out_unrolled, kg_error *error) KG_CHECKED;
KG_API void kg_unrolled_destroy(kg_unrolled *unrolled);

/* The join of two patches, in either order, that runs nearest to a place (u, v) of the first, and
 * how far from it that is, mm; SIZE_MAX: they have none. */
KG_API size_t kg_net_nearest_join(const kg_net *net, const kg_solution *solution,
                                  const int64_t patches[2], kg_vec2 at, double *out_distance);

/* For each join of the net the index of the model's wish that holds for it, or SIZE_MAX. A wish for
 * one join holds for the nearest of its two patches, unless another is nearer to that one still; it
 * comes before the wish for all of them. */
KG_API void kg_unroll_wishes(const kg_model *model, const kg_solution *solution, const kg_net *net,
                             size_t *out_wishes);

#ifdef __cplusplus
}
#endif
#endif
