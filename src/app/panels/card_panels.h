/* The panels of pop-up cards. */
#ifndef KG_APP_PANELS_CARD_PANELS_H
#define KG_APP_PANELS_CARD_PANELS_H

#include "app/app.h"

void kg_panel_card(kg_app *app, kg_area area);
void kg_panel_card_remarks(kg_app *app, kg_area area);
/* What lines and hatchings mean; a section of a panel. */
void kg_panel_card_legend(const kg_editor *editor);
/* The slider of the opening, over the lower rim of the 3D view. */
void kg_panel_card_opening(kg_app *app);

#endif
