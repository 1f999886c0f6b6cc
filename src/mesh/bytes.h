/*
 * A growing buffer that file writers print into. A failed allocation is remembered and makes every
 * later call do nothing, so that one check at the end is enough.
 */
#ifndef KG_MESH_BYTES_H
#define KG_MESH_BYTES_H

#include "katagami/base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct kg_bytes {
    char *items;
    size_t count, capacity;
    bool failed;
} kg_bytes;

void kg_bytes_put(kg_bytes *b, const void *data, size_t size);
void kg_bytes_print(kg_bytes *b, const char *format, ...) KG_PRINTF(2, 3);

/* Little endian, as PLY (when it says so) and STL want them. */
void kg_bytes_u16(kg_bytes *b, uint16_t value);
void kg_bytes_u32(kg_bytes *b, uint32_t value);
void kg_bytes_f32(kg_bytes *b, double value);

#ifdef __cplusplus
}
#endif
#endif
