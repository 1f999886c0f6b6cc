/* Alignment ticks: short marks across long joins, at the same points of both sides. */
#ifndef KG_UNROLL_TICK_H
#define KG_UNROLL_TICK_H

#include "unroll/piece.h"

/* Adds the ticks of a stretch's join to the net, on both parts. */
kg_status kg_ticks_add(const kg_pieces *pieces, size_t stretch, int join, kg_net *net,
                       kg_error *error) KG_CHECKED;

#endif
