/* All modes. */
#ifndef KG_APP_MODES_MODES_H
#define KG_APP_MODES_MODES_H

#include "app/mode.h"

extern const kg_mode kg_patch_mode, kg_card_mode, kg_sheet_mode;

#endif
