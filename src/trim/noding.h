/* Where chains meet: the events that nodes are made of. */
#ifndef KG_TRIM_NODING_H
#define KG_TRIM_NODING_H

#include "trim/arrangement.h"

/* A node on a chain. */
typedef struct kg_event {
    size_t chain, segment, node;
    double fraction;
    kg_cross_point point; /* with the chain's own s, t */
} kg_event;

typedef struct kg_events {
    kg_event *items;
    size_t count, capacity;
} kg_events;

/* Halves segments whose chords cross though the curves do not. Fills the arrangement's nodes and
 * the events of all chains, sorted along each chain. */
kg_status kg_node_chains(kg_arrangement *a, kg_events *out_events) KG_CHECKED;

#endif
