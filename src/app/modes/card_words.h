/* A pop-up card in words: what is wrong, what the cursor is at. */
#ifndef KG_APP_MODES_CARD_WORDS_H
#define KG_APP_MODES_CARD_WORDS_H

#include "app/modes/card_state.h"

/* "Not lifted"; the rest of it say kg_oa_remark_place and the like. */
const char *kg_card_trouble_name(kg_oa_trouble trouble);
/* "x 3  y 2  z 5   depth 4, window" */
void kg_card_say_cursor(const kg_editor *editor, char *out, size_t size);
const char *kg_card_brush_name(kg_brush brush);

/* What the status bar says: the cursor, and what is wrong there or anywhere. */
const char *kg_card_hint(const kg_editor *editor);

#endif
