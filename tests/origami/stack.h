/*
 * An oracle for layer orders that shares nothing with the kernel: it looks at the paper at points.
 * On both sides of every edge the loops there must be in one order, and what is joined across the
 * line, or folded back at it, must nest without crossing.
 */
#ifndef KG_TESTS_ORIGAMI_STACK_H
#define KG_TESTS_ORIGAMI_STACK_H

#include "katagami/origami.h"

/* NULL, or what is wrong (in a static buffer). */
const char *stack_check(const kg_origami_state *state);

/* NULL, or what is wrong: faces congruent to the sheet within `tolerance` times its size, joined
 * vertices in one place, fold angles as the faces lie, half-edges consistent. */
const char *shape_check(const kg_origami_state *state, double tolerance);

/* Neither of both is wrong. */
void assert_sound(const kg_origami_state *state, double tolerance);

/* Layers alone. */
bool same_orders(const kg_origami_state *a, const kg_origami_state *b);

/* All bits of two states are the same. */
bool same_state(const kg_origami_state *a, const kg_origami_state *b);

#endif
