/* Reading values of a JSON tree: every failure names the file, the line and the patch. */
#ifndef KG_MODEL_READER_H
#define KG_MODEL_READER_H

#include "base/json.h"
#include "katagami/model.h"

enum { KG_READ_DEPTH = 8 };

/* Where the reader is. */
typedef struct kg_reader {
    const char *name, *text;
    kg_json_step path[KG_READ_DEPTH];
    size_t depth;
    int64_t patch;
    bool in_patch;
    kg_error *error;
} kg_reader;

kg_status kg_read_fail(kg_reader *r, const char *format, ...) KG_PRINTF(2, 3) KG_CHECKED;

/* Into a member, or (key NULL) an item, and out again. */
void kg_read_enter(kg_reader *r, const char *key, size_t index);
void kg_read_leave(kg_reader *r);

/* `count` numbers within KG_MAX_COORDINATE. */
kg_status kg_read_numbers(kg_reader *r, const json_t *v, size_t count, double *out) KG_CHECKED;

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
