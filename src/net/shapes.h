/* The parts of a net in written size, as nesting wants them. */
#ifndef KG_NET_SHAPES_H
#define KG_NET_SHAPES_H

#include "katagami/net.h"
#include "net/nest.h"

typedef struct kg_shapes {
    kg_nest_part *parts; /* one per part of the net; none is pinned */
    kg_nest_loop *loops;
    kg_vec2 *points;
} kg_shapes;

/* False when memory runs out. */
bool kg_shapes_create(const kg_net *net, double scale, kg_shapes *out_shapes) KG_CHECKED;
void kg_shapes_clear(kg_shapes *shapes);

#endif
