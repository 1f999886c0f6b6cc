#include "net/bytes.h"

#include "base/array.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void kg_bytes_clear(kg_bytes *bytes) {
    free(bytes->items);
    *bytes = (kg_bytes){0};
}

void kg_bytes_add(kg_bytes *bytes, const void *data, size_t size) {
    if (bytes->failed || size > SIZE_MAX - bytes->count ||
        !kg_reserve(bytes, bytes->count + size)) {
        bytes->failed = true;
        return;
    }
    if (size > 0)
        memcpy(bytes->items + bytes->count, data, size);
    bytes->count += size;
}

void kg_bytes_text(kg_bytes *bytes, const char *text) {
    kg_bytes_add(bytes, text, strlen(text));
}

char *kg_number_text(double value, char *out) {
    double clamped = fmin(fmax(value, -1e12), 1e12);
    long long units = llround(clamped * 1e4);
    unsigned long long size = (unsigned long long)(units < 0 ? -units : units);
    int n = snprintf(out, KG_NUMBER_SIZE, "%s%llu", units < 0 ? "-" : "", size / 10000);
    if (size % 10000 != 0) {
        n += snprintf(out + n, (size_t)(KG_NUMBER_SIZE - n), ".%04llu", size % 10000);
        while (out[n - 1] == '0')
            out[--n] = '\0';
    }
    return out;
}

void kg_bytes_number(kg_bytes *bytes, double value) {
    char text[KG_NUMBER_SIZE];
    kg_bytes_text(bytes, kg_number_text(value, text));
}
