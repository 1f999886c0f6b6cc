/*
 * JSON as people read it: values on short lines, numbers in the fewest digits that read back the
 * same, and lines to point at in error messages. Parsing and trees are jansson's.
 */
#ifndef KG_BASE_JSON_H
#define KG_BASE_JSON_H

#include "katagami/base.h"

#include <jansson.h>

/* The text of a tree, indented by two spaces; arrays and objects that fit on a line of 100
 * characters stay on it. Ends in a newline; free() it. NULL when memory runs out. */
char *kg_json_text(const json_t *value);

/* One step into a tree: a key, or (key NULL) an index. */
typedef struct kg_json_step {
    const char *key;
    size_t index;
} kg_json_step;

/* The line (from 1) on which the value at a path begins in a text that has been parsed; the line
 * of the nearest thing around it when the path leads nowhere. */
int kg_json_line(const char *text, const kg_json_step *path, size_t depth);

/* Shortest decimal that reads back as `value`, locale-proof; `out` holds 32 characters. Not
 * finite: "0", since JSON has no word for it. */
void kg_json_number(double value, char *out);

#endif
