/*
 * Changes of the sheets and of the folds done, for commands, panels and tools. They stand within a
 * step of the history that the caller has begun (kg_editor_begin), and touch the document.
 */
#ifndef KG_APP_MODES_SHEET_EDIT_H
#define KG_APP_MODES_SHEET_EDIT_H

#include "app/modes/sheet_state.h"

/* ---- sheets in the plane ----------------------------------------------------------------- */

/* Why sheets cannot be added or moved now, translated; NULL: they can. */
const char *kg_sheets_why_fixed(const kg_editor *editor);

/* Its corners with the middle at the origin. KG_ERR_INPUT: no such sheet. */
kg_status kg_sheet_corners(const kg_sheet_size *size, kg_vec2 out[KG_SHEET_MOST_SIDES],
                           size_t *out_count, kg_error *error) KG_CHECKED;

/* Adds a sheet on top, with its own corners moved by `at`; `at` NULL: beside the others. */
kg_status kg_sheets_add(kg_editor *editor, const kg_vec2 *corners, size_t count, const kg_vec2 *at,
                        uint32_t front, uint32_t back, kg_error *error) KG_CHECKED;
/* Turns a sheet by `angle` about `center`, then moves it, starting from how `from` lies (NULL: it
 * does). */
kg_status kg_sheets_place(kg_editor *editor, size_t sheet, const kg_paper_sheet *from,
                          kg_vec2 center, double angle, kg_vec2 by, kg_error *error) KG_CHECKED;
/* Puts a sheet at another place in the order; later ones lie on top. */
kg_status kg_sheets_reorder(kg_editor *editor, size_t sheet, size_t to, kg_error *error) KG_CHECKED;

/* Width and height of a sheet as it lies flat, whether the origami lists it or not. */
kg_vec2 kg_sheet_span(const kg_origami *origami, size_t sheet);
/* The middle of a sheet's bounds as it lies flat. */
kg_vec2 kg_sheet_middle(const kg_paper_sheet *sheet);

/* How many sheets there are, whether the origami lists them or not. */
size_t kg_sheets_count(const kg_sheets *sheets);

/* ---- folds done -------------------------------------------------------------------------- */

/* Does fold `index` in another way, and all done after it again. KG_ERR_INPUT when one of them
 * cannot be done. */
kg_status kg_sheets_refold(kg_editor *editor, size_t index, const kg_fold *fold,
                           kg_error *error) KG_CHECKED;

#endif
