/* A pop-up card's net under the pointer: linked with the 3D view, windows and tops painted. */
#ifndef KG_APP_MODES_CARD_NET_H
#define KG_APP_MODES_CARD_NET_H

#include "app/modes/card_state.h"
#include "app/net_view.h"

/* See kg_mode. */
bool kg_card_net_event(kg_editor *editor, const kg_event *event, const kg_vec2 *point);
void kg_card_net_draw(const kg_editor *editor, const kg_net_map *map, double scale);

#endif
