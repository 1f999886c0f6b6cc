/*
 * When layers can lie on each other as they do: the conditions of flat-folded paper, after Justin
 * (1994) and Akitaya, Demaine and Ku (2023). Loops on both sides of a line are what matters:
 *
 *   taco: an edge folded flat, both its loops on one side; tortilla: paper that goes on across the
 *   line, flat at an edge or without one.
 *
 *   tortilla - tortilla   do not change places across the line
 *   taco - tortilla       the tortilla is not between the taco's two halves
 *   taco - taco           both halves of one, or none, are between the halves of the other
 *
 * and, where three loops have a part in common, they are in some order (transitivity).
 */
#ifndef KG_ORIGAMI_CONDITION_H
#define KG_ORIGAMI_CONDITION_H

#include "origami/layers.h"

/* Of pairs (a, b), "b lies above a" along the group's normal. */
typedef enum kg_condition_kind {
    KG_CONDITION_SAME, /* pairs (a, b) and (c, d) have the same order */
    KG_CONDITION_TACOS /* c and d are both between a and b, or none of them: the orders of (a, c),
                          (b, c), (a, d) and (b, d) hold an even number of "above" */
} kg_condition_kind;

typedef struct kg_condition {
    kg_condition_kind kind;
    int32_t a, b, c, d;
    int32_t edges[2]; /* where; the second is -1 for paper without an edge */
} kg_condition;

typedef struct kg_conditions {
    kg_condition *items;
    size_t count, capacity;
} kg_conditions;

/* All conditions at the edges of one state, between loops of one group. Orders need not be right;
 * only which pairs there are counts. KG_ERR_CANCELLED, KG_ERR_MEMORY. */
kg_status kg_conditions_find(const kg_origami_state *state, const kg_outlines *outlines,
                             const kg_progress *progress, kg_conditions *out, kg_error *error);

/* KG_ERR_INPUT with a condition that the orders do not meet. Of a row of bits of loops, `moved`,
 * only the orders between those and others are looked at; NULL: all of them. */
kg_status kg_layers_check(const kg_origami_state *state, const kg_outlines *outlines,
                          const uint64_t *moved, kg_error *error);

#endif
