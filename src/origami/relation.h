/*
 * Boolean variables that are known to be equal or opposite: a forest with parities (Tarjan 1975).
 * A literal is 2 v for variable v, 2 v + 1 for its opposite.
 */
#ifndef KG_ORIGAMI_RELATION_H
#define KG_ORIGAMI_RELATION_H

#include <stdbool.h>
#include <stdint.h>

/* links[v] is the literal that v equals; 2 v for roots. */
static inline int32_t kg_relation_find(int32_t *links, int32_t literal) {
    int32_t v = literal >> 1, up = links[v];
    while (up >> 1 != v) { /* halving the path */
        int32_t above = links[up >> 1] ^ (up & 1);
        links[v] = above;
        literal = above ^ (literal & 1);
        v = above >> 1;
        up = links[v];
    }
    return literal;
}

/* Makes two literals equal; false when they are opposite already. `*changed` when they were
 * unrelated. */
static inline bool kg_relation_join(int32_t *links, int32_t a, int32_t b, bool *changed) {
    a = kg_relation_find(links, a);
    b = kg_relation_find(links, b);
    if (a >> 1 == b >> 1)
        return a == b;
    if (a >> 1 > b >> 1) /* roots are the smallest: the same forest whatever the order */
        links[a >> 1] = b ^ (a & 1);
    else
        links[b >> 1] = a ^ (b & 1);
    *changed = true;
    return true;
}

#endif
