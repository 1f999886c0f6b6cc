/* FOLD and .cp files, as texts and as JSON trees. */
#ifndef KG_ORIGAMI_EXCHANGE_H
#define KG_ORIGAMI_EXCHANGE_H

#include "base/reader.h"
#include "origami/origami.h"
#include "origami/pattern.h"

/* The folded state a FOLD object describes: its layers are solved for when it does not hold them.
 * `in_mm`: whatever unit it names. */
kg_status kg_fold_read(kg_reader *place, const json_t *root, bool in_mm,
                       const kg_progress *progress, kg_layer_report *report,
                       kg_origami_state **out_state);
/* A state as FOLD object; `states` before it (count may be 0) as further frames. */
json_t *kg_fold_json(const kg_origami_state *state, kg_origami_state *const *states, size_t count,
                     const char *title);

kg_status kg_cp_read(const char *data, size_t size, const char *name, kg_pattern *out_pattern,
                     kg_error *error);
/* NULL when memory runs out; free() it. */
char *kg_cp_text(const kg_origami_state *state);

/* Folds and solves what a pattern says. */
kg_status kg_pattern_solve(kg_pattern *pattern, const kg_progress *progress,
                           kg_layer_report *report, kg_origami_state **out_state, kg_error *error);

/* Where each sheet is put so that they do not overlap: one shift per sheet; free() it. */
kg_status kg_sheet_shifts(const kg_origami_state *state, size_t *out_count, kg_vec2 **out_shifts);

#endif
