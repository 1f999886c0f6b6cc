/* Assertions of scripts about pop-up cards. */
#ifndef KG_APP_MODES_CARD_EXPECT_H
#define KG_APP_MODES_CARD_EXPECT_H

#include "app/expect.h"

kg_status kg_card_expect(const kg_editor *editor, const char *words, kg_error *error) KG_CHECKED;

#endif
