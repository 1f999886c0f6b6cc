/* Tabs of one part against each other. */
#ifndef KG_NET_TAB_SETTLE_H
#define KG_NET_TAB_SETTLE_H

#include "net/tab_place.h"

/* Splits, lowers and drops tabs of one part (all of `tabs`) until none runs into another. Both of
 * two that meet give way; tabs without a height are passed over. */
kg_status kg_tab_settle(const kg_tab_ground *ground, const kg_tab_options *options,
                        kg_tab_list *tabs) KG_CHECKED;

#endif
