#ifndef KG_NET_LAYOUT_H
#define KG_NET_LAYOUT_H

#include "katagami/net.h"

/* Where a part's point comes to lie on its page. */
kg_vec2 kg_layout_apply(const kg_net_layout *layout, size_t part, kg_vec2 p);

#endif
