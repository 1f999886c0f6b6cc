/*
 * Reading the JSON trees of files: every failure names the file, the line, and what its reader adds
 * (the patch, the column).
 */
#ifndef KG_BASE_READER_H
#define KG_BASE_READER_H

#include "base/json.h"

/* The format of model files that this version writes, of whatever kind. */
#define KG_FILE_VERSION 1

enum { KG_READ_DEPTH = 8 };

/* Where the reader is. */
typedef struct kg_reader {
    const char *name;
    char *text; /* the file, zero-terminated */
    json_t *root;
    kg_json_step path[KG_READ_DEPTH];
    size_t depth;
    /* Says where that is in the user's words, such as "patch 3: "; NULL: the line says enough */
    void (*place)(const void *owner, char *out, size_t size);
    const void *owner;
    kg_error *error;
} kg_reader;

/* Parses a file; a byte order mark in front is skipped. `name` is what messages call it.
 * KG_ERR_PARSE, KG_ERR_MEMORY: there is nothing to end. */
kg_status kg_read_begin(kg_reader *r, const char *data, size_t size, const char *name,
                        kg_error *error) KG_CHECKED;
/* Frees what was parsed and passes `status` on, with a message for KG_ERR_MEMORY. */
kg_status kg_read_end(kg_reader *r, kg_status status) KG_CHECKED;

/* Is it a model file of this version and kind? `what` is such a model, with its article. */
kg_status kg_read_header(kg_reader *r, const char *kind, const char *what) KG_CHECKED;

kg_status kg_read_fail(kg_reader *r, const char *format, ...) KG_PRINTF(2, 3) KG_CHECKED;

/* Into a member, or (key NULL) an item, and out again. */
void kg_read_enter(kg_reader *r, const char *key, size_t index);
void kg_read_leave(kg_reader *r);

/* A number of at most `limit`. */
kg_status kg_read_number(kg_reader *r, const json_t *v, double limit, double *out) KG_CHECKED;

/* `count` numbers within KG_MAX_COORDINATE. */
kg_status kg_read_numbers(kg_reader *r, const json_t *v, size_t count, double *out) KG_CHECKED;

/* `least` to 3 numbers within KG_MAX_COORDINATE; those that are not there stay. */
kg_status kg_read_point(kg_reader *r, const json_t *v, size_t least, double out[3],
                        size_t *out_count) KG_CHECKED;

/* A whole number in [lo, hi]. */
kg_status kg_read_index(kg_reader *r, const json_t *v, int64_t lo, int64_t hi,
                        int32_t *out) KG_CHECKED;

/* An array of rows of `width` doubles (2 or 3), as kg_vec2 or kg_vec3; free it. */
kg_status kg_read_rows(kg_reader *r, const json_t *v, size_t width, void **out_rows,
                       size_t *out_count) KG_CHECKED;

/* Optional members; absent leaves `*out`. Strings replace and free the old one. */
kg_status kg_read_double(kg_reader *r, const json_t *object, const char *key,
                         double *out) KG_CHECKED;
kg_status kg_read_bool(kg_reader *r, const json_t *object, const char *key, bool *out) KG_CHECKED;
kg_status kg_read_string(kg_reader *r, const json_t *object, const char *key,
                         char **out) KG_CHECKED;
kg_status kg_read_object(kg_reader *r, const json_t *parent, const char *key,
                         const json_t **out) KG_CHECKED;

/* One of `count` words, as its number. */
kg_status kg_read_word(kg_reader *r, const json_t *object, const char *key,
                       const char *const *words, size_t count, size_t *out) KG_CHECKED;

/* Keeps the object as it was read, so that what this version does not know survives. It is never
 * changed in place, so it can be shared. */
json_t *kg_read_keep(const json_t *v);

#endif
