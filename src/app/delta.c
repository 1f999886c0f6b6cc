#include "app/delta.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* jansson counts references in trees that are only read, too */
static json_t *share(const json_t *value) {
    return json_incref((json_t *)(uintptr_t)value);
}

/* ---- making ----------------------------------------------------------------------------- */

static json_t *other_value(const json_t *to) {
    return json_pack("{s:o}", "is", share(to));
}

static json_t *between_objects(const json_t *from, const json_t *to) {
    json_t *keys = json_object(), *without = json_array();
    const char *key;
    json_t *value;
    bool ok = keys && without;
    json_object_foreach((json_t *)(uintptr_t)to, key, value) {
        const json_t *old = json_object_get(from, key);
        json_t *delta = old ? kg_delta_create(old, value) : other_value(value);
        ok = ok && delta;
        if (!json_is_null(delta))
            ok = ok && json_object_set(keys, key, delta) == 0;
        json_decref(delta);
    }
    json_object_foreach((json_t *)(uintptr_t)from, key, value) {
        if (!json_object_get(to, key))
            ok = ok && json_array_append_new(without, json_string(key)) == 0;
    }
    if (ok)
        return json_pack("{s:o, s:o}", "keys", keys, "without", without);
    json_decref(keys);
    json_decref(without);
    return NULL;
}

/* The items that differ, where not most do. NULL: most do, or memory ran out. */
static json_t *between_items(const json_t *from, const json_t *to) {
    json_t *items = json_object();
    size_t count = json_array_size(to);
    bool ok = items != NULL;
    for (size_t i = 0; i < count && ok; i++) {
        char index[24];
        json_t *delta = kg_delta_create(json_array_get(from, i), json_array_get(to, i));
        snprintf(index, sizeof index, "%zu", i);
        ok = delta && (json_is_null(delta) || json_object_set(items, index, delta) == 0) &&
             2 * json_object_size(items) <= count;
        json_decref(delta);
    }
    if (ok)
        return json_pack("{s:o}", "items", items);
    json_decref(items);
    return NULL;
}

static json_t *between_lists(const json_t *from, const json_t *to) {
    size_t old = json_array_size(from), now = json_array_size(to), head = 0, tail = 0;
    json_t *items = old == now ? between_items(from, to) : NULL;
    if (items)
        return items;
    while (head < old && head < now &&
           json_equal(json_array_get(from, head), json_array_get(to, head)))
        head++;
    while (tail + head < old && tail + head < now &&
           json_equal(json_array_get(from, old - 1 - tail), json_array_get(to, now - 1 - tail)))
        tail++;
    json_t *put = json_array();
    bool ok = put != NULL;
    for (size_t i = head; i < now - tail && ok; i++)
        ok = json_array_append(put, json_array_get(to, i)) == 0;
    if (ok)
        return json_pack("{s:I, s:I, s:o}", "at", (json_int_t)head, "drop",
                         (json_int_t)(old - tail - head), "put", put);
    json_decref(put);
    return NULL;
}

json_t *kg_delta_create(const json_t *from, const json_t *to) {
    if (json_equal(from, to))
        return json_null();
    if (json_is_object(from) && json_is_object(to))
        return between_objects(from, to);
    if (json_is_array(from) && json_is_array(to))
        return between_lists(from, to);
    return other_value(to);
}

/* ---- applying --------------------------------------------------------------------------- */

static json_t *apply_keys(const json_t *from, const json_t *delta) {
    json_t *to = json_is_object(from) ? json_copy((json_t *)(uintptr_t)from) : NULL, *value;
    const char *key;
    bool ok = to != NULL;
    json_object_foreach(json_object_get(delta, "keys"), key, value) {
        const json_t *old = json_object_get(from, key);
        ok = ok && (old || json_object_get(value, "is")) &&
             json_object_set_new(to, key, kg_delta_apply(old, value)) == 0;
    }
    const json_t *without = json_object_get(delta, "without");
    for (size_t i = 0; i < json_array_size(without) && ok; i++) {
        key = json_string_value(json_array_get(without, i));
        ok = key && json_object_del(to, key) == 0;
    }
    if (ok)
        return to;
    json_decref(to);
    return NULL;
}

static json_t *apply_items(const json_t *from, json_t *items) {
    json_t *to = json_is_array(from) ? json_copy((json_t *)(uintptr_t)from) : NULL, *value;
    const char *key;
    bool ok = to != NULL;
    json_object_foreach(items, key, value) {
        char *end;
        size_t index = strtoul(key, &end, 10);
        ok = ok && *end == '\0' && index < json_array_size(from) &&
             json_array_set_new(to, index, kg_delta_apply(json_array_get(from, index), value)) == 0;
    }
    if (ok)
        return to;
    json_decref(to);
    return NULL;
}

static json_t *apply_put(const json_t *from, const json_t *delta) {
    json_int_t at = json_integer_value(json_object_get(delta, "at"));
    json_int_t drop = json_integer_value(json_object_get(delta, "drop"));
    json_int_t count = (json_int_t)json_array_size(from);
    json_t *put = json_object_get(delta, "put"), *to = json_array();
    bool ok =
        to && json_is_array(from) && at >= 0 && at <= count && drop >= 0 && drop <= count - at;
    for (json_int_t i = 0; ok && i < at; i++)
        ok = json_array_append(to, json_array_get(from, (size_t)i)) == 0;
    ok = ok && json_array_extend(to, put) == 0;
    for (json_int_t i = at + drop; ok && i < count; i++)
        ok = json_array_append(to, json_array_get(from, (size_t)i)) == 0;
    if (ok)
        return to;
    json_decref(to);
    return NULL;
}

json_t *kg_delta_apply(const json_t *from, const json_t *delta) {
    json_t *value;
    if (json_is_null(delta))
        return share(from);
    if ((value = json_object_get(delta, "is")))
        return json_incref(value);
    if (json_object_get(delta, "keys"))
        return apply_keys(from, delta);
    if ((value = json_object_get(delta, "items")))
        return apply_items(from, value);
    return json_object_get(delta, "put") ? apply_put(from, delta) : NULL;
}
