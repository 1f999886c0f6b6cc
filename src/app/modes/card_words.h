/* A pop-up card in words: what is wrong and where, what the cursor is at. */
#ifndef KG_APP_MODES_CARD_WORDS_H
#define KG_APP_MODES_CARD_WORDS_H

#include "app/modes/card_state.h"

/* In the language of the app: "floating front", why it is so, what helps. */
const char *kg_card_trouble_name(kg_oa_trouble trouble);
const char *kg_card_trouble_reason(kg_oa_trouble trouble);
const char *kg_card_trouble_advice(kg_oa_trouble trouble);
/* "front at depth 4, columns 2–5, levels 1–4" */
void kg_card_say_place(const kg_oa_remark *remark, char *out, size_t size);
/* "x 3  y 2  z 5   depth 4, window" */
void kg_card_say_cursor(const kg_editor *editor, char *out, size_t size);
const char *kg_card_brush_name(kg_brush brush);

/* What the status bar says: the cursor, and what is wrong there or anywhere. */
const char *kg_card_hint(const kg_editor *editor);

#endif
