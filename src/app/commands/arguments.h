/*
 * Arguments of commands. Readers leave the value as it is when the argument is missing, and fail
 * with a message that names it when it is of the wrong kind.
 */
#ifndef KG_APP_COMMANDS_ARGUMENTS_H
#define KG_APP_COMMANDS_ARGUMENTS_H

#include "app/editor.h"

#include <jansson.h>

kg_status kg_argument_number(const json_t *arguments, const char *name, double *value,
                             kg_error *error) KG_CHECKED;
kg_status kg_argument_bool(const json_t *arguments, const char *name, bool *value,
                           kg_error *error) KG_CHECKED;
kg_status kg_argument_index(const json_t *arguments, const char *name, size_t *value,
                            kg_error *error) KG_CHECKED;
kg_status kg_argument_id(const json_t *arguments, const char *name, int64_t *value,
                         kg_error *error) KG_CHECKED;
/* A text that lives as long as `arguments`. */
kg_status kg_argument_text(const json_t *arguments, const char *name, const char **value,
                           kg_error *error) KG_CHECKED;
kg_status kg_argument_vec3(const json_t *arguments, const char *name, kg_vec3 *value,
                           kg_error *error) KG_CHECKED;
/* "#rrggbb", as 0xrrggbb. */
kg_status kg_argument_color(const json_t *arguments, const char *name, uint32_t *value,
                            kg_error *error) KG_CHECKED;
/* Rows of `width` numbers; the array is malloc's. */
kg_status kg_argument_rows(const json_t *arguments, const char *name, size_t width,
                           double **out_numbers, size_t *out_count, kg_error *error) KG_CHECKED;

/* The patches a command is about: "patch": ID or "patches": [ID…], without them the selected ones.
 * The list is malloc's. KG_ERR_INPUT: none, or one that does not exist. */
kg_status kg_argument_patches(const kg_editor *editor, const json_t *arguments, int64_t **out_ids,
                              size_t *out_count, kg_error *error) KG_CHECKED;
/* The one patch a command is about. */
kg_status kg_argument_patch(const kg_editor *editor, const json_t *arguments,
                            kg_model_patch **out_patch, kg_error *error) KG_CHECKED;

/* Does something to each patch a command is about, as one step of the history: undone when one
 * fails. */
typedef kg_status (*kg_patch_act)(kg_editor *editor, int64_t patch, const void *user,
                                  kg_error *error);
kg_status kg_argument_each(kg_editor *editor, const json_t *arguments, const char *label,
                           kg_patch_act act, const void *user, kg_error *error) KG_CHECKED;

#endif
