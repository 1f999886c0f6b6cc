/* FOLD and .cp files, as texts and as JSON trees. */
#ifndef KG_ORIGAMI_EXCHANGE_H
#define KG_ORIGAMI_EXCHANGE_H

#include "base/json.h"
#include "origami/origami.h"
#include "origami/pattern.h"

/* Where in a file a value stands, for messages. */
typedef struct kg_json_place {
    const char *name, *text;
    kg_json_step path[8];
    size_t depth;
    kg_error *error;
} kg_json_place;

kg_status kg_json_fail(kg_json_place *place, const char *format, ...) KG_PRINTF(2, 3);
void kg_json_enter(kg_json_place *place, const char *key, size_t index);
static inline void kg_json_leave(kg_json_place *place) {
    place->depth--;
}

/* A number of at most `limit`. */
kg_status kg_json_read_number(kg_json_place *place, const json_t *value, double limit, double *out);
/* `least` to 3 numbers; those that are not there stay. */
kg_status kg_json_read_point(kg_json_place *place, const json_t *value, size_t least, double out[3],
                             size_t *out_count);
/* A whole number in [lo, hi]. */
kg_status kg_json_read_index(kg_json_place *place, const json_t *value, int64_t lo, int64_t hi,
                             int32_t *out);

/* The folded state a FOLD object describes: its layers are solved for when it does not hold them.
 */
kg_status kg_fold_read(kg_json_place *place, const json_t *root, kg_layer_report *report,
                       kg_origami_state **out_state);
/* A state as FOLD object; `states` before it (count may be 0) as further frames. */
json_t *kg_fold_json(const kg_origami_state *state, kg_origami_state *const *states, size_t count,
                     const char *title);

kg_status kg_cp_read(const char *data, size_t size, const char *name, kg_pattern *out_pattern,
                     kg_error *error);
/* NULL when memory runs out; free() it. */
char *kg_cp_text(const kg_origami_state *state);

/* Folds and solves what a pattern says. */
kg_status kg_pattern_solve(kg_pattern *pattern, kg_layer_report *report,
                           kg_origami_state **out_state, kg_error *error);

/* Where each sheet is put so that they do not overlap: one shift per sheet; free() it. */
kg_status kg_sheet_shifts(const kg_origami_state *state, size_t *out_count, kg_vec2 **out_shifts);

#endif
