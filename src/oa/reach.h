/*
 * Validity kept up to date while single stretches of single columns are placed anew: what the
 * greedy searches for windows and thin tops ask some hundred thousand times.
 *
 * Joins, front cells and both floods are kept as rows of bits. A flood never turns back a row, so
 * after a change only the rows of the stretch and those beyond it are worked out again, each only
 * in the joined stretches of cells that the change or the row before has touched, until a row comes
 * out as it was. Where all cells beside the change are reached, and straight from the row before,
 * nothing can come out otherwise: that is nearly everywhere, and is told of many rows at once. All
 * changes can be taken back. The answer is that of kg_oa_flood (and is tested to be).
 */
#ifndef KG_OA_REACH_H
#define KG_OA_REACH_H

#include "oa/sheet.h"

typedef struct kg_oa_reach kg_oa_reach;

/* Of a card without regard to its margins and pyramids. */
kg_status kg_oa_reach_create(const kg_oa *oa, kg_oa_reach **out_reach, kg_error *error) KG_CHECKED;
void kg_oa_reach_destroy(kg_oa_reach *reach);

/* Places the cells of rows [first, last] of column x anew, out of which no front is left, and keeps
 * it that way when the card is valid then (*out_valid). Errors: KG_ERR_MEMORY. */
kg_status kg_oa_reach_try(kg_oa_reach *reach, int x, int first, int last, const int32_t *places,
                          bool *out_valid, kg_error *error) KG_CHECKED;

#endif
