#include "mesh/bytes.h"

#include "base/array.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static bool make_room(kg_bytes *b, size_t more) {
    if (b->failed || more > SIZE_MAX - b->count || !kg_reserve(b, b->count + more))
        b->failed = true;
    return !b->failed;
}

void kg_bytes_put(kg_bytes *b, const void *data, size_t size) {
    if (!size || !make_room(b, size))
        return;
    memcpy(b->items + b->count, data, size);
    b->count += size;
}

void kg_bytes_print(kg_bytes *b, const char *format, ...) {
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    char line[256];
    int n = vsnprintf(line, sizeof line, format, args);
    if (n < 0) {
        b->failed = true;
    } else if ((size_t)n < sizeof line) {
        kg_bytes_put(b, line, (size_t)n);
    } else if (make_room(b, (size_t)n + 1)) {
        vsnprintf(b->items + b->count, (size_t)n + 1, format, again);
        b->count += (size_t)n;
    }
    va_end(again);
    va_end(args);
}

void kg_bytes_u16(kg_bytes *b, uint16_t value) {
    unsigned char bytes[2] = {(unsigned char)value, (unsigned char)(value >> 8)};
    kg_bytes_put(b, bytes, sizeof bytes);
}

void kg_bytes_u32(kg_bytes *b, uint32_t value) {
    unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8),
                              (unsigned char)(value >> 16), (unsigned char)(value >> 24)};
    kg_bytes_put(b, bytes, sizeof bytes);
}

void kg_bytes_f32(kg_bytes *b, double value) {
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    kg_bytes_u32(b, bits);
}
