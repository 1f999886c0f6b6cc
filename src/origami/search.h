/* Counting the ways to meet clauses over bits, component by component. */
#ifndef KG_ORIGAMI_SEARCH_H
#define KG_ORIGAMI_SEARCH_H

#include "katagami/origami.h"

/* Four literals (2 v, or 2 v + 1 for its opposite) whose sum is even; or, with -1 as the fourth,
 * three that are not all equal. */
typedef struct kg_clause {
    int32_t literals[4];
} kg_clause;

typedef struct kg_clauses {
    kg_clause *items;
    size_t count, capacity;
} kg_clauses;

/* `links` as in relation.h: only roots are bits of their own, and clauses hold nothing else.
 * `values` 1 or -1 for bits that are given, 0 for free ones: filled in with the first way found.
 * Clauses are sorted. KG_ERR_INPUT: no way; KG_ERR_CANCELLED, with a message: report->most_steps
 * are over, or `progress` was told enough. */
kg_status kg_search(kg_clauses *clauses, const int32_t *links, size_t bit_count,
                    signed char *values, const kg_progress *progress, kg_layer_report *report,
                    kg_error *error);

#endif
