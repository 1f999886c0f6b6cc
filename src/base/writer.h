/*
 * JSON trees for files: what was read, with what this version knows put in its place, so that what
 * it does not know survives.
 */
#ifndef KG_BASE_WRITER_H
#define KG_BASE_WRITER_H

#include "base/json.h"

/* A shallow copy of the kept object to write into, or a new one when `kept` is none. Members are
 * replaced, never changed. NULL when memory runs out. */
json_t *kg_write_start(const json_t *kept);

/* These set a member and take over `value`; false when memory ran out anywhere. */
bool kg_write(json_t *object, const char *key, json_t *value);
/* One that need not be written while it has its default and is not there yet. */
bool kg_write_unless(json_t *object, const char *key, bool is_default, json_t *value);
/* One that may be missing: then it is taken out. */
bool kg_write_if(json_t *object, const char *key, bool is_there, json_t *value);
/* Version, kind and title of a model file. */
bool kg_write_header(json_t *root, const char *kind, const char *title);

/* Whole numbers without a decimal point, as people write them. */
json_t *kg_write_number(double x);
/* An object that is whole, or (ok false) NULL in its place. */
json_t *kg_write_end(json_t *object, bool ok);

/* The text of a tree, zero-terminated, and a file of it, whole or not at all; both take `root` over
 * (NULL: memory ran out). KG_ERR_MEMORY, KG_ERR_IO. */
kg_status kg_write_text(json_t *root, char **out_text, size_t *out_size,
                        kg_error *error) KG_CHECKED;
kg_status kg_write_file(json_t *root, const char *path, kg_error *error) KG_CHECKED;

#endif
