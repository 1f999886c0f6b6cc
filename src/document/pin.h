/*
 * Pins: parts of the net that the user put somewhere. The model keeps them in its "net" object:
 *
 *     "placements": [{"patch": ID, "piece": 0, "page": 0, "x": mm, "y": mm, "angle_deg": 0}]
 *
 * x and y are where the part's own origin (the start of its patch's geodesic) lies on the page;
 * piece counts the parts of a patch in the order of the net. What names no part is ignored.
 */
#ifndef KG_DOCUMENT_PIN_H
#define KG_DOCUMENT_PIN_H

#include "katagami/model.h"
#include "katagami/net.h"

/* Which of its patch's parts a part is, from 0. */
size_t kg_pin_piece(const kg_net *net, size_t part);

/* The part of a patch with that number; -1: it has not so many. */
int kg_pin_part(const kg_net *net, int64_t patch, size_t piece);

/* Pins the net's parts as the model says, each at most one page beyond what could be needed. */
void kg_pin_parts(const kg_model *model, kg_net *net);

/* KG_ERR_INPUT: no place on a page; KG_ERR_MEMORY. */
kg_status kg_pin_set(kg_model *model, int64_t patch, size_t piece, kg_net_placement place,
                     kg_error *error) KG_CHECKED;
/* Removes one pin, or all of a patch (`piece` KG_PIN_ALL), or all (`patch` 0). KG_ERR_MEMORY. */
#define KG_PIN_ALL SIZE_MAX
kg_status kg_pin_remove(kg_model *model, int64_t patch, size_t piece, kg_error *error) KG_CHECKED;

/* Removes all that the net says of a patch that is going to be removed: pins and wishes for its
 * joins. A later patch may get its number. KG_ERR_MEMORY. */
kg_status kg_pin_forget_patch(kg_model *model, int64_t patch, kg_error *error) KG_CHECKED;

#endif
