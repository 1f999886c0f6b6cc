/*
 * Which loops overlap, found for whole rows of bits at once: common points tell of most that do,
 * slabs in a few directions of most that do not; only what is left is looked at pair by pair.
 */
#ifndef KG_ORIGAMI_OVERLAP_H
#define KG_ORIGAMI_OVERLAP_H

#include "origami/layers.h"

typedef struct kg_overlaps {
    const kg_outlines *outlines; /* outlives it */
    double touch;
    size_t loops, words;  /* of a row */
    uint64_t *planes;     /* rows: the loops of each group that has several */
    int32_t *places;      /* of loops, where their group's row is; -1: alone in it */
    uint64_t *points;     /* rows: the loops that hold each of some points, well inside */
    uint64_t *held;       /* of loops, the points that each holds: POINT_WORDS words */
    uint64_t *slabs;      /* rows, see overlap.c */
    unsigned char *spans; /* of loops, the first and the last slab in each direction */
} kg_overlaps;

kg_status kg_overlaps_create(const kg_origami_state *state, const kg_outlines *outlines,
                             kg_overlaps *out);
void kg_overlaps_clear(kg_overlaps *overlaps);

/* Of the loops `wanted` those that overlap `loop`, in its group, by more than the state's touch.
 * Words before `first` are neither read nor written. */
void kg_overlaps_find(const kg_overlaps *overlaps, int32_t loop, const uint64_t *wanted,
                      size_t first, uint64_t *out_row);

/* Layers for a state that has none yet: of every two loops that overlap the later one lies above.
 */
kg_status kg_overlaps_fill(kg_origami_state *state, const kg_outlines *outlines);

#endif
