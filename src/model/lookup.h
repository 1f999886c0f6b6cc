/* Positions of ids in a list, found by halving. */
#ifndef KG_MODEL_LOOKUP_H
#define KG_MODEL_LOOKUP_H

#include "katagami/base.h"

typedef struct kg_lookup_entry {
    int64_t id;
    size_t index;
} kg_lookup_entry;

/* Entries by id, equal ids by index. */
typedef struct kg_lookup {
    size_t count;
    kg_lookup_entry *entries;
} kg_lookup;

/* Room for `capacity` entries; fill it with kg_lookup_add, then kg_lookup_sort. */
kg_status kg_lookup_create(size_t capacity, kg_lookup *out) KG_CHECKED;
void kg_lookup_add(kg_lookup *lookup, int64_t id, size_t index);
void kg_lookup_sort(kg_lookup *lookup);
void kg_lookup_clear(kg_lookup *lookup);

/* The first entry with this id, or NULL; others with it follow. */
const kg_lookup_entry *kg_lookup_find(const kg_lookup *lookup, int64_t id);

#endif
