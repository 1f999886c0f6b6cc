/* Assertions of scripts about folded sheets; see kg_mode. */
#ifndef KG_APP_MODES_SHEET_EXPECT_H
#define KG_APP_MODES_SHEET_EXPECT_H

#include "app/editor.h"

kg_status kg_sheet_expect(const kg_editor *editor, const char *words, kg_error *error) KG_CHECKED;

#endif
