/* Crease patterns: edges on flat sheets, to be folded. */
#ifndef KG_ORIGAMI_PATTERN_H
#define KG_ORIGAMI_PATTERN_H

#include "base/array.h"
#include "katagami/origami.h"
#include "origami/state.h"

/* In FOLD's letters: B border, M mountain, V valley, F flat, U mountain or valley, C cut,
 * J where a face is divided. */
typedef struct kg_pattern_edge {
    int32_t ends[2];
    char assignment;
    double angle; /* in [-π, π], V > 0; π for U */
} kg_pattern_edge;

typedef struct kg_pattern {
    struct {
        kg_vec2 *items;
        size_t count, capacity;
    } vertices;
    struct {
        kg_pattern_edge *items;
        size_t count, capacity;
    } edges;
    kg_vec2 unit;       /* what 1 along x and y of the file is here; 0: the same */
    kg_face_list faces; /* counter-clockwise; empty: to be traced */
    struct {
        int32_t *items; /* vertices that were divided at cuts, one for every piece more */
        size_t count, capacity;
    } divided;
} kg_pattern;

void kg_pattern_clear(kg_pattern *pattern);

/* The longer side of the box around it. */
double kg_pattern_length(const kg_pattern *pattern);

/* A place in the coordinates of the file, for messages. */
kg_vec2 kg_pattern_in_file(const kg_pattern *pattern, kg_vec2 place);

/* Joins ends that are nearer than a ten-thousandth of the size, cuts segments where they meet. */
kg_status kg_pattern_clean(kg_pattern *pattern, kg_error *error);

/* Finds the faces that edges enclose. */
kg_status kg_pattern_trace(kg_pattern *pattern, kg_error *error);

/* Half-edges with all vertices flat in z = 0, loops in face order (each divided face in place of
 * one), sheets numbered by connected pieces; faces are traced when there are none. Cuts become two
 * borders, and a vertex whose faces are parted by cuts or borders becomes one for each part, so
 * that paper can open there: those come behind the pattern's, which lists them as divided. Edge
 * angles are those of the pattern, not of the flat state. */
kg_status kg_pattern_state(kg_pattern *pattern, kg_origami_state **out_state, kg_error *error);

/* Turns a state whose vertices lie flat as its angles say, from the first loop of every sheet
 * outward, and finds groups. KG_ERR_INPUT naming the vertex around which paper does not close:
 * with Kawasaki's or Maekawa's condition when all its creases are folded flat. */
kg_status kg_pattern_fold(const kg_pattern *pattern, kg_origami_state *state, kg_error *error);

/* Accepts positions that were given: KG_ERR_INPUT for faces that are not congruent to the paper.
 * Finds groups. */
kg_status kg_pattern_take(kg_origami_state *state, kg_error *error);

#endif
