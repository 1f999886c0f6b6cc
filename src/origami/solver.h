/* Layer orders of a folded pattern: all that the geometry leaves free is found and counted. */
#ifndef KG_ORIGAMI_SOLVER_H
#define KG_ORIGAMI_SOLVER_H

#include "origami/state.h"

/* Gives a state whose vertices are placed the first valid orders, and open creases the way they are
 * then folded. KG_ERR_INPUT when there are none, which is proved, naming faces where a single
 * condition shows it; KG_ERR_CANCELLED when `report->most_steps` was not enough to tell, or
 * `progress` (may be NULL) said so: the report is then as it was. */
kg_status kg_state_solve(kg_origami_state *state, const kg_progress *progress,
                         kg_layer_report *report, kg_error *error) KG_CHECKED;

#endif
