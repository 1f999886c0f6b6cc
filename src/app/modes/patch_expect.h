/* Assertions of scripts about patch models; see kg_mode. */
#ifndef KG_APP_MODES_PATCH_EXPECT_H
#define KG_APP_MODES_PATCH_EXPECT_H

#include "app/editor.h"

kg_status kg_patch_expect(const kg_editor *editor, const char *words, kg_error *error) KG_CHECKED;

#endif
