/* What an origami holds. */
#ifndef KG_ORIGAMI_ORIGAMI_H
#define KG_ORIGAMI_ORIGAMI_H

#include "origami/state.h"

struct kg_origami {
    char *title; /* never NULL */
    kg_net_settings net;
    struct {
        kg_paper_sheet *items;
        size_t count, capacity;
    } sheets;
    struct {
        kg_fold *items; /* done ones first, then those that can be done again */
        size_t count, capacity;
    } folds;
    struct {
        kg_origami_state **items; /* before the first fold, and after each that was ever done */
        size_t count, capacity;
    } states;
    size_t step;         /* folds done */
    bool pattern;        /* it began as a crease pattern; `sheets` then may hold colours only */
    struct json_t *json; /* the file as read, for its unknown keys; may be NULL */
};

/* The flat sheets, later ones on top. */
kg_status kg_state_from_sheets(const kg_paper_sheet *sheets, size_t count,
                               kg_origami_state **out_state, kg_error *error);

/* KG_ERR_INPUT when the polygon is no sheet. */
kg_status kg_sheet_check(const kg_paper_sheet *sheet, kg_error *error);

/* The sheet with a polygon of its own; false when memory runs out. */
bool kg_sheet_copy(const kg_paper_sheet *sheet, kg_paper_sheet *out);

#endif
