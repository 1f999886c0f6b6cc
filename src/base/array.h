/*
 * A growing array, typed by its element: struct { T *items; size_t count, capacity; }.
 *
 *     struct { kg_vec2 *items; size_t count, capacity; } points = {0};
 *     if (!kg_push(&points, p)) return KG_ERR_MEMORY;
 */
#ifndef KG_BASE_ARRAY_H
#define KG_BASE_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/* Makes room for `wanted` items of `size` bytes; false when memory (or size_t) runs out, with the
 * array left as it was. */
bool kg_reserve_bytes(void **items, size_t *capacity, size_t wanted, size_t size);

#define kg_reserve(a, wanted)                                                                      \
    ((wanted) <= (a)->capacity ||                                                                  \
     kg_reserve_bytes((void **)&(a)->items, &(a)->capacity, (wanted), sizeof *(a)->items))

#define kg_push(a, value)                                                                          \
    (kg_reserve((a), (a)->count + 1) && ((a)->items[(a)->count++] = (value), true))

#endif
