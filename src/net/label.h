/*
 * Words on the net: every part's number and name in a box, every join's number in a ring at its
 * edge or mark on both sides.
 *
 * A part's label stands where its shape has most room (a pole of inaccessibility in the text's own
 * shape), shrinks where it must, loses the name, and at last stands outside with a leader line. A
 * join's number runs along its edge. No label lies on a line or another label as long as any of
 * the places tried is free.
 */
#ifndef KG_NET_LABEL_H
#define KG_NET_LABEL_H

#include "net/drawing.h"

/* Adds captions and leader lines to the pages. Errors: KG_ERR_MEMORY. */
kg_status kg_label_draw(const kg_net *net, const kg_net_layout *layout,
                        const kg_net_options *options, kg_drawing *drawing,
                        kg_error *error) KG_CHECKED;

#endif
