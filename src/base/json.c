#include "base/json.h"

#include "base/array.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- writing ---------------------------------------------------------------------------- */

enum { LINE = 100 };

typedef struct text {
    char *items;
    size_t count, capacity;
    size_t stop; /* where a trial on one line gives up: deep trees are not written twice */
    bool failed;
} text;

static void put(text *t, const char *s, size_t n) {
    if (t->failed || !kg_reserve(t, t->count + n + 1)) {
        t->failed = true;
        return;
    }
    memcpy(t->items + t->count, s, n);
    t->count += n;
    t->items[t->count] = '\0';
}

static void put_word(text *t, const char *s) {
    put(t, s, strlen(s));
}

static void put_break(text *t, int indent) {
    put(t, "\n", 1);
    for (int i = 0; i < indent; i++)
        put(t, "  ", 2);
}

void kg_json_number(double value, char *out) {
    if (!isfinite(value)) {
        memcpy(out, "0", 2);
        return;
    }
    if (value == 0 && signbit(value)) {
        memcpy(out, "-0.0", 5); /* "-0" would come back as a whole number, which has no sign */
        return;
    }
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(out, 32, "%.*g", digits, value);
        if (strtod(out, NULL) == value)
            break;
    }
    char *comma = strchr(out, ','); /* the locale's decimal point */
    if (comma)
        *comma = '.';
}

static void put_scalar(text *t, const json_t *v) {
    char number[32];
    if (json_is_real(v)) {
        kg_json_number(json_real_value(v), number);
        put_word(t, number);
        return;
    }
    char *s = json_dumps(v, JSON_ENCODE_ANY | JSON_COMPACT);
    if (s)
        put_word(t, s);
    else
        t->failed = true;
    free(s);
}

static void put_key(text *t, const char *key) {
    json_t *k = json_string(key);
    if (k)
        put_scalar(t, k);
    else
        t->failed = true;
    json_decref(k);
    put(t, ": ", 2);
}

/* Writes a value on one line. */
static void put_flat(text *t, const json_t *v) {
    bool first = true;
    if (t->count > t->stop)
        return;
    if (json_is_array(v)) {
        put(t, "[", 1);
        for (size_t i = 0; i < json_array_size(v); i++) {
            if (i > 0)
                put(t, ", ", 2);
            put_flat(t, json_array_get(v, i));
        }
        put(t, "]", 1);
    } else if (json_is_object(v)) {
        const char *key;
        json_t *member;
        put(t, "{", 1);
        json_object_foreach((json_t *)(uintptr_t)v, key, member) {
            if (!first)
                put(t, ", ", 2);
            first = false;
            put_key(t, key);
            put_flat(t, member);
        }
        put(t, "}", 1);
    } else {
        put_scalar(t, v);
    }
}

/* An array of numbers: long ones are rows of a table. */
static bool is_plain(const json_t *array) {
    for (size_t i = 0; i < json_array_size(array); i++)
        if (!json_is_number(json_array_get(array, i)))
            return false;
    return true;
}

/* Writes numbers on as few lines as they fit on. */
static void put_lines(text *t, const json_t *array, int indent) {
    t->stop = SIZE_MAX;
    put_break(t, indent);
    size_t line = t->count - (size_t)indent * 2;
    for (size_t i = 0; i < json_array_size(array); i++) {
        size_t before = t->count;
        if (i > 0)
            put(t, ", ", 2);
        put_scalar(t, json_array_get(array, i));
        if (i > 0 && t->count - line > LINE - 1 && !t->failed) {
            t->count = before;
            put(t, ",", 1);
            put_break(t, indent);
            line = t->count - (size_t)indent * 2;
            put_scalar(t, json_array_get(array, i));
        }
    }
}

static void put_value(text *t, const json_t *v, int indent) {
    size_t start = t->count;
    bool nests = json_is_array(v) || json_is_object(v);
    t->stop = nests ? start + LINE : SIZE_MAX;
    put_flat(t, v);
    if (!nests || t->failed || t->count - start + (size_t)indent * 2 <= LINE)
        return;
    t->count = start;
    bool first = true;
    if (json_is_array(v)) {
        put(t, "[", 1);
        bool plain = is_plain(v);
        if (plain)
            put_lines(t, v, indent + 1);
        for (size_t i = 0; i < json_array_size(v) && !plain; i++) {
            if (i > 0)
                put(t, ",", 1);
            put_break(t, indent + 1);
            put_value(t, json_array_get(v, i), indent + 1);
        }
        put_break(t, indent);
        put(t, "]", 1);
        return;
    }
    const char *key;
    json_t *member;
    put(t, "{", 1);
    json_object_foreach((json_t *)(uintptr_t)v, key, member) {
        if (!first)
            put(t, ",", 1);
        first = false;
        put_break(t, indent + 1);
        put_key(t, key);
        put_value(t, member, indent + 1);
    }
    put_break(t, indent);
    put(t, "}", 1);
}

char *kg_json_text(const json_t *value) {
    text t = {0};
    put_value(&t, value, 0);
    put(&t, "\n", 1);
    if (t.failed) {
        free(t.items);
        return NULL;
    }
    return t.items;
}

/* ---- finding lines ---------------------------------------------------------------------- */

static const char *skip_space(const char *p) {
    while (*p == ' ' || *p == '\t' || *p == '\n' || *p == '\r')
        p++;
    return p;
}

static const char *skip_string(const char *p) {
    for (p++; *p && *p != '"'; p++)
        if (*p == '\\' && p[1])
            p++;
    return *p ? p + 1 : p;
}

static const char *skip_value(const char *p) {
    int depth = 0;
    do {
        p = skip_space(p);
        if (*p == '\0')
            return p;
        if (*p == '"') {
            p = skip_string(p);
        } else if (strchr("{[", *p)) {
            depth++, p++;
        } else if (strchr("}]", *p)) {
            depth--, p++;
        } else if (strchr(",:", *p)) {
            p++;
        } else {
            while (*p && !strchr(" \t\r\n,:{}[]\"", *p))
                p++;
        }
    } while (depth > 0);
    return p;
}

/* The member with this key, or NULL. Keys with escapes never match: only lines depend on it. */
static const char *find_member(const char *p, const char *key) {
    size_t n = strlen(key);
    for (p = skip_space(p + 1); *p == '"'; p = skip_space(p)) {
        bool match = strncmp(p + 1, key, n) == 0 && p[1 + n] == '"';
        const char *value = skip_space(skip_string(p));
        if (*value == ':')
            value = skip_space(value + 1);
        if (match)
            return value;
        p = skip_space(skip_value(value));
        if (*p == ',')
            p++;
    }
    return NULL;
}

static const char *find_item(const char *p, size_t index) {
    p = skip_space(p + 1);
    for (; index > 0 && *p && *p != ']'; index--) {
        p = skip_space(skip_value(p));
        if (*p == ',')
            p = skip_space(p + 1);
    }
    return *p && *p != ']' ? p : NULL;
}

int kg_json_line(const char *text_start, const kg_json_step *path, size_t depth) {
    const char *at = skip_space(text_start);
    for (size_t i = 0; i < depth; i++) {
        const char *next = NULL;
        if (path[i].key && *at == '{')
            next = find_member(at, path[i].key);
        else if (!path[i].key && *at == '[')
            next = find_item(at, path[i].index);
        if (!next)
            break;
        at = next;
    }
    int line = 1;
    for (const char *p = text_start; p < at; p++)
        line += *p == '\n';
    return line;
}
