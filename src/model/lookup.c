#include "model/lookup.h"

#include <stdlib.h>

kg_status kg_lookup_create(size_t capacity, kg_lookup *out) {
    *out = (kg_lookup){.entries = calloc(capacity + 1, sizeof *out->entries)};
    return out->entries ? KG_OK : KG_ERR_MEMORY;
}

void kg_lookup_add(kg_lookup *lookup, int64_t id, size_t index) {
    lookup->entries[lookup->count++] = (kg_lookup_entry){id, index};
}

static int compare(const void *a, const void *b) {
    const kg_lookup_entry *x = a, *y = b;
    if (x->id != y->id)
        return x->id < y->id ? -1 : 1;
    return x->index < y->index ? -1 : x->index > y->index;
}

void kg_lookup_sort(kg_lookup *lookup) {
    qsort(lookup->entries, lookup->count, sizeof *lookup->entries, compare);
}

void kg_lookup_clear(kg_lookup *lookup) {
    free(lookup->entries);
    *lookup = (kg_lookup){0};
}

const kg_lookup_entry *kg_lookup_find(const kg_lookup *lookup, int64_t id) {
    size_t lo = 0, hi = lookup->count;
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        if (lookup->entries[mid].id < id)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo < lookup->count && lookup->entries[lo].id == id ? &lookup->entries[lo] : NULL;
}
