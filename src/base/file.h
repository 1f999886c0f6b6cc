/*
 * Whole files: read at once, written by a temporary file and a rename so that nothing half-written
 * stays behind. "-" is standard input or output.
 */
#ifndef KG_BASE_FILE_H
#define KG_BASE_FILE_H

#include "katagami/base.h"

#include <stdio.h>

/* Reads all of `path` into a new buffer with a zero byte behind it (not counted). */
kg_status kg_file_read(const char *path, char **out_data, size_t *out_size,
                       kg_error *error) KG_CHECKED;
/* The same, telling `progress` (may be NULL) how far it is. KG_ERR_CANCELLED. */
kg_status kg_file_read_telling(const char *path, const kg_progress *progress, char **out_data,
                               size_t *out_size, kg_error *error) KG_CHECKED;

/* Writes `size` bytes so that `path` holds either its old or its new content, never a part. */
kg_status kg_file_write(const char *path, const void *data, size_t size,
                        kg_error *error) KG_CHECKED;

/* A temporary name beside `path`, for writers that want a name themselves; finish with
 * kg_file_commit (rename) or kg_file_discard. The caller frees `*out_temporary`. */
kg_status kg_file_temporary(const char *path, char **out_temporary, kg_error *error) KG_CHECKED;
kg_status kg_file_commit(const char *temporary, const char *path, kg_error *error) KG_CHECKED;
void kg_file_discard(const char *temporary);

/* Does a path end in `ending` (".fold"), in capitals or not? */
bool kg_file_ends_in(const char *path, const char *ending);
/* The last name of a path without its ending: "cat" of "models/cat.obj"; free() it. NULL when
 * memory runs out. */
char *kg_file_stem(const char *path);

#endif
