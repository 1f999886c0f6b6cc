/* A pop-up card in words: what is wrong, what the cursor is at. */
#ifndef KG_APP_MODES_CARD_WORDS_H
#define KG_APP_MODES_CARD_WORDS_H

#include "app/modes/card_state.h"

/* "Not lifted"; the rest of it say kg_oa_remark_place and the like. */
const char *kg_card_trouble_name(kg_oa_trouble trouble);
/* "x 3  y 2  z 5   depth 4, window" */
void kg_card_say_cursor(const kg_editor *editor, char *out, size_t size);
const char *kg_card_brush_name(kg_brush brush);

/* "Works, but 3 patches are loose": whether the card works, in one sentence that the panel and the
 * status bar show. Of a card with nothing wrong there is no severity: false. */
bool kg_card_verdict(const kg_editor *editor, char *out, size_t size, kg_severity *out_severity);

/* What the status bar says: the cursor, and what is wrong there or anywhere. */
const char *kg_card_hint(const kg_editor *editor);

#endif
