/* Text that grows, with numbers in a form that depends neither on the locale nor on the last bits
 * of a double. */
#ifndef KG_SAMPLES_TEXT_H
#define KG_SAMPLES_TEXT_H

#include "katagami/base.h"

typedef struct text {
    char *items;
    size_t count, capacity;
    bool failed; /* memory ran out; what follows is dropped */
} text;

void text_add(text *t, const char *format, ...) KG_PRINTF(2, 3);

/* With at most `decimals` (0 … 6) digits behind the point, trailing zeros left out, never "-0". */
void text_number(text *t, double value, int decimals);

/* Frees the text and makes it empty. */
void text_clear(text *t);

#endif
