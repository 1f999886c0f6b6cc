#include "samples/text.h"

#include "base/array.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void text_add(text *t, const char *format, ...) {
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof line)
        t->failed = true;
    for (int i = 0; i < length && !t->failed; i++)
        if (!kg_push(t, line[i]))
            t->failed = true;
}

/* Through integers, since printf's point depends on the locale. */
void text_number(text *t, double value, int decimals) {
    int64_t unit = 1;
    for (int i = 0; i < decimals; i++)
        unit *= 10;
    int64_t fixed = llround(value * (double)unit);
    int64_t whole = llabs(fixed) / unit, part = llabs(fixed) % unit;
    text_add(t, "%s%" PRId64, fixed < 0 ? "-" : "", whole);
    if (part == 0)
        return;
    for (; part % 10 == 0; part /= 10)
        decimals--;
    text_add(t, ".%0*" PRId64, decimals, part);
}

void text_clear(text *t) {
    free(t->items);
    *t = (text){0};
}
