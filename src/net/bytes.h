/* A growing text buffer for the writers, with numbers that follow no locale. */
#ifndef KG_NET_BYTES_H
#define KG_NET_BYTES_H

#include "katagami/base.h"

typedef struct kg_bytes {
    char *items;
    size_t count, capacity;
    bool failed; /* memory ran out; later additions do nothing */
} kg_bytes;

void kg_bytes_clear(kg_bytes *bytes);
void kg_bytes_add(kg_bytes *bytes, const void *data, size_t size);
void kg_bytes_text(kg_bytes *bytes, const char *text);

/* `value` with at most four decimals (a ten-thousandth of a millimetre), trailing zeros and "-0"
 * left out; the value is clamped to ±1e12. */
void kg_bytes_number(kg_bytes *bytes, double value);

/* The same into `out`, which must hold KG_NUMBER_SIZE bytes. Returns `out`. */
enum { KG_NUMBER_SIZE = 32 };
char *kg_number_text(double value, char *out);

#endif
