/* What is wrong with where parts lie on their pages. */
#ifndef KG_NET_CLASH_H
#define KG_NET_CLASH_H

#include "katagami/net.h"

enum {
    KG_CLASH_PAGE = 1,   /* reaches over the margins, or onto what is printed in the corners */
    KG_CLASH_OVERLAP = 2 /* lies on another part */
};

/* Sets out_clashes[part] for every part of the layout. Errors: KG_ERR_INPUT (options),
 * KG_ERR_MEMORY. */
kg_status kg_net_clashes(const kg_net *net, const kg_net_layout *layout,
                         const kg_net_options *options, unsigned *out_clashes,
                         kg_error *error) KG_CHECKED;

/* How many parts have tabs that lie on the part itself, on each other or on another part, found
 * anew from the finished contours. Errors: as kg_net_clashes. */
kg_status kg_net_tab_overlaps(const kg_net *net, const kg_net_layout *layout,
                              const kg_net_options *options, int *out_count,
                              kg_error *error) KG_CHECKED;

#endif
