/*
 * What one JSON tree has and another has not.
 *
 * A delta is null (nothing changes) or one of
 *   {"is": VALUE}                               another value
 *   {"keys": {KEY: DELTA …}, "without": [KEY …]}  an object, some of its keys
 *   {"items": {INDEX: DELTA …}}                 a list of the same length, some of its items
 *   {"at": INDEX, "drop": COUNT, "put": [VALUE …]}  a list, some of it replaced
 */
#ifndef KG_APP_DELTA_H
#define KG_APP_DELTA_H

#include <jansson.h>

/* The delta that leads from one tree to another, which it shares values with; NULL when memory runs
 * out. */
json_t *kg_delta_create(const json_t *from, const json_t *to);

/* The tree a delta leads to, which shares values with `from`; NULL when the delta does not fit, or
 * memory runs out. */
json_t *kg_delta_apply(const json_t *from, const json_t *delta);

#endif
