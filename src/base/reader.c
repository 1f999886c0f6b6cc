#include "base/reader.h"
#include "base/phrase.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- files ------------------------------------------------------------------------------ */

kg_status kg_read_begin(kg_reader *r, const char *data, size_t size, const char *name,
                        kg_error *error) {
    json_error_t where;
    *r = (kg_reader){.name = name, .error = error};
    if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0)
        data += 3, size -= 3; /* the mark that some editors put in front */
    r->root = json_loadb(data, size, JSON_REJECT_DUPLICATES, &where);
    if (!r->root)
        return kg_fail(error, KG_ERR_PARSE,
                       json_error_code(&where) == json_error_invalid_utf8
                           ? N_("%s:%d: %s; save the file as UTF-8")
                           : "%s:%d: %s",
                       name, where.line < 1 ? 1 : where.line, where.text);
    r->text = malloc(size + 1); /* zero-terminated for the search of lines */
    if (!r->text)
        return kg_read_end(r, KG_ERR_MEMORY);
    memcpy(r->text, data, size);
    r->text[size] = '\0';
    return KG_OK;
}

kg_status kg_read_end(kg_reader *r, kg_status status) {
    json_decref(r->root);
    free(r->text);
    return status == KG_ERR_MEMORY ? kg_fail(r->error, status, "%s: out of memory", r->name)
                                   : status;
}

kg_status kg_read_header(kg_reader *r, const char *kind, const char *what) {
    const json_t *number = json_object_get(r->root, "katagami");
    const char *found = json_string_value(json_object_get(r->root, "kind"));
    long long version = (long long)json_integer_value(number);
    if (!json_is_object(r->root) || !json_is_integer(number))
        return kg_read_fail(r,
                            "this is no katagami model: it must begin with {\"katagami\": %d, "
                            "\"kind\": \"%s\", …}",
                            KG_FILE_VERSION, kind);
    kg_read_enter(r, "katagami", 0);
    if (version > KG_FILE_VERSION)
        return kg_read_fail(r,
                            "the model was written by a newer katagami (format %lld, this one "
                            "reads up to %d); update katagami",
                            version, KG_FILE_VERSION);
    if (version < 1)
        return kg_read_fail(r, "there is no format %lld", version);
    kg_read_leave(r);
    kg_read_enter(r, "kind", 0);
    if (!found || strcmp(found, kind))
        return kg_read_fail(r,
                            found ? N_("%s has \"kind\": \"%s\", this one is \"%s\"")
                                  : N_("%s has \"kind\": \"%s\""),
                            kg_phrase(what), kind, found);
    kg_read_leave(r);
    return KG_OK;
}

kg_status kg_read_fail(kg_reader *r, const char *format, ...) {
    char message[KG_ERROR_SIZE / 2], where[48] = "";
    va_list args;
    va_start(args, format);
    kg_phrase_vprint(message, sizeof message, format, args);
    va_end(args);
    if (r->place)
        r->place(r->owner, where, sizeof where);
    return kg_fail(r->error, KG_ERR_PARSE, "%s:%d: %s%s", r->name,
                   kg_json_line(r->text, r->path, r->depth), where, message);
}

void kg_read_enter(kg_reader *r, const char *key, size_t index) {
    assert(r->depth < KG_READ_DEPTH);
    r->path[r->depth++] = (kg_json_step){key, index};
}

void kg_read_leave(kg_reader *r) {
    r->depth--;
}

/* ---- values ----------------------------------------------------------------------------- */

kg_status kg_read_number(kg_reader *r, const json_t *v, double limit, double *out) {
    if (!json_is_number(v))
        return kg_read_fail(r, "a number is wanted here");
    double x = json_number_value(v);
    if (!(fabs(x) <= limit))
        return kg_read_fail(r, "%g is beyond %g", x, limit);
    *out = x;
    return KG_OK;
}

kg_status kg_read_double(kg_reader *r, const json_t *object, const char *key, double *out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    kg_read_enter(r, key, 0);
    kg_status status = json_is_number(v) ? kg_read_number(r, v, KG_MAX_COORDINATE, out)
                                         : kg_read_fail(r, "\"%s\" is a number", key);
    kg_read_leave(r);
    return status;
}

kg_status kg_read_bool(kg_reader *r, const json_t *object, const char *key, bool *out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    kg_read_enter(r, key, 0);
    kg_status status = json_is_boolean(v) ? KG_OK : kg_read_fail(r, "\"%s\" is true or false", key);
    kg_read_leave(r);
    if (!status)
        *out = json_is_true(v);
    return status;
}

kg_status kg_read_string(kg_reader *r, const json_t *object, const char *key, char **out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    kg_read_enter(r, key, 0);
    kg_status status = json_is_string(v) ? KG_OK : kg_read_fail(r, "\"%s\" is a text", key);
    kg_read_leave(r);
    if (status)
        return status;
    char *copy = strdup(json_string_value(v));
    if (!copy)
        return KG_ERR_MEMORY;
    free(*out);
    *out = copy;
    return KG_OK;
}

kg_status kg_read_numbers(kg_reader *r, const json_t *v, size_t n, double *out) {
    if (!json_is_array(v) || json_array_size(v) != n)
        return kg_read_fail(r, "%zu numbers are wanted here", n);
    for (size_t i = 0; i < n; i++) {
        kg_read_enter(r, NULL, i);
        kg_status status = kg_read_number(r, json_array_get(v, i), KG_MAX_COORDINATE, &out[i]);
        kg_read_leave(r);
        if (status)
            return status;
    }
    return KG_OK;
}

kg_status kg_read_point(kg_reader *r, const json_t *v, size_t least, double out[3],
                        size_t *out_count) {
    size_t n = json_array_size(v);
    if (n < least || n > 3)
        return kg_read_fail(r, least == 3 ? N_("3 numbers are wanted here")
                                          : N_("2 or 3 numbers are wanted here"));
    *out_count = n;
    return kg_read_numbers(r, v, n, out);
}

kg_status kg_read_index(kg_reader *r, const json_t *v, int64_t lo, int64_t hi, int32_t *out) {
    if (!json_is_integer(v) || json_integer_value(v) < lo || json_integer_value(v) > hi)
        return kg_read_fail(r, "a whole number from %lld to %lld is wanted here", (long long)lo,
                            (long long)hi);
    *out = (int32_t)json_integer_value(v);
    return KG_OK;
}

kg_status kg_read_rows(kg_reader *r, const json_t *v, size_t width, void **out_rows,
                       size_t *out_count) {
    if (!json_is_array(v))
        return kg_read_fail(r, "a list of points is wanted here");
    size_t n = json_array_size(v);
    double *rows = calloc(n + 1, width * sizeof *rows);
    if (!rows)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < n; i++) {
        kg_read_enter(r, NULL, i);
        kg_status status = kg_read_numbers(r, json_array_get(v, i), width, rows + i * width);
        kg_read_leave(r);
        if (status) {
            free(rows);
            return status;
        }
    }
    *out_rows = rows;
    *out_count = n;
    return KG_OK;
}

kg_status kg_read_object(kg_reader *r, const json_t *parent, const char *key, const json_t **out) {
    const json_t *v = json_object_get(parent, key);
    if (v && !json_is_object(v)) {
        kg_read_enter(r, key, 0);
        kg_status status = kg_read_fail(r, "\"%s\" is an object: { … }", key);
        kg_read_leave(r);
        return status;
    }
    *out = v;
    return KG_OK;
}

kg_status kg_read_word(kg_reader *r, const json_t *object, const char *key,
                       const char *const *words, size_t count, size_t *out) {
    const json_t *v = json_object_get(object, key);
    char list[128] = "";
    if (!v)
        return KG_OK;
    for (size_t i = 0; i < count; i++) {
        if (json_is_string(v) && strcmp(json_string_value(v), words[i]) == 0) {
            *out = i;
            return KG_OK;
        }
        size_t n = strlen(list);
        snprintf(list + n, sizeof list - n, "%s\"%s\"", i ? ", " : "", words[i]);
    }
    kg_read_enter(r, key, 0);
    kg_status status = kg_read_fail(r, "\"%s\" is one of %s", key, list);
    kg_read_leave(r);
    return status;
}

json_t *kg_read_keep(const json_t *v) {
    return json_incref((json_t *)(uintptr_t)v);
}
