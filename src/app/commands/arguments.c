#include "app/commands/arguments.h"

#include "app/scenery.h"
#include "app/text.h"

#include <stdlib.h>

static kg_status wrong_rows(const char *name, size_t width, kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be a list of [%zu numbers]", name, width);
}

static kg_status wrong(const char *name, const char *wanted, kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT, "\"%s\" has to be %s", name, _(wanted));
}

kg_status kg_argument_number(const json_t *arguments, const char *name, double *value,
                             kg_error *error) {
    const json_t *x = json_object_get(arguments, name);
    if (!x)
        return KG_OK;
    if (!json_is_number(x))
        return wrong(name, N_("a number"), error);
    *value = json_number_value(x);
    return KG_OK;
}

kg_status kg_argument_bool(const json_t *arguments, const char *name, bool *value,
                           kg_error *error) {
    const json_t *x = json_object_get(arguments, name);
    if (!x)
        return KG_OK;
    if (!json_is_boolean(x))
        return wrong(name, N_("true or false"), error);
    *value = json_is_true(x);
    return KG_OK;
}

kg_status kg_argument_id(const json_t *arguments, const char *name, int64_t *value,
                         kg_error *error) {
    const json_t *x = json_object_get(arguments, name);
    if (!x)
        return KG_OK;
    if (!json_is_integer(x))
        return wrong(name, N_("a whole number"), error);
    *value = json_integer_value(x);
    return KG_OK;
}

kg_status kg_argument_index(const json_t *arguments, const char *name, size_t *value,
                            kg_error *error) {
    int64_t number = (int64_t)*value;
    kg_status status = kg_argument_id(arguments, name, &number, error);
    if (!status && number < 0)
        status = wrong(name, N_("0 or more"), error);
    if (!status)
        *value = (size_t)number;
    return status;
}

kg_status kg_argument_text(const json_t *arguments, const char *name, const char **value,
                           kg_error *error) {
    const json_t *x = json_object_get(arguments, name);
    if (!x)
        return KG_OK;
    if (!json_is_string(x))
        return wrong(name, N_("a text"), error);
    *value = json_string_value(x);
    return KG_OK;
}

kg_status kg_argument_color(const json_t *arguments, const char *name, uint32_t *value,
                            kg_error *error) {
    const char *text = NULL;
    kg_color color;
    kg_status status = kg_argument_text(arguments, name, &text, error);
    if (status || !text)
        return status;
    if (!kg_color_parse(text, &color))
        return wrong(name, N_("a colour, \"#rrggbb\""), error);
    *value = kg_color_to_rgb(color);
    return KG_OK;
}

kg_status kg_argument_rows(const json_t *arguments, const char *name, size_t width,
                           double **out_numbers, size_t *out_count, kg_error *error) {
    const json_t *list = json_object_get(arguments, name);
    if (!json_is_array(list))
        return wrong_rows(name, width, error);
    size_t count = json_array_size(list);
    double *numbers = calloc(count * width + 1, sizeof *numbers);
    if (!numbers)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < count * width; i++) {
        const json_t *row = json_array_get(list, i / width), *x = json_array_get(row, i % width);
        if (json_array_size(row) != width || !json_is_number(x)) {
            free(numbers);
            return wrong_rows(name, width, error);
        }
        numbers[i] = json_number_value(x);
    }
    *out_numbers = numbers;
    *out_count = count;
    return KG_OK;
}

kg_status kg_argument_vec3(const json_t *arguments, const char *name, kg_vec3 *value,
                           kg_error *error) {
    const json_t *x = json_object_get(arguments, name);
    if (!x)
        return KG_OK;
    if (json_array_size(x) != 3 || !json_is_number(json_array_get(x, 0)) ||
        !json_is_number(json_array_get(x, 1)) || !json_is_number(json_array_get(x, 2)))
        return wrong(name, "[x, y, z]", error);
    *value = kg_v3(json_number_value(json_array_get(x, 0)), json_number_value(json_array_get(x, 1)),
                   json_number_value(json_array_get(x, 2)));
    return KG_OK;
}

/* ---- patches ---------------------------------------------------------------------------- */

static kg_status check_patch(const kg_editor *e, int64_t id, kg_error *error) {
    if (kg_model_find(kg_editor_model(e), id))
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)id);
}

kg_status kg_argument_patches(const kg_editor *e, const json_t *arguments, int64_t **out_ids,
                              size_t *out_count, kg_error *error) {
    const json_t *one = json_object_get(arguments, "patch"),
                 *list = json_object_get(arguments, "patches");
    size_t count = one ? 1 : list ? json_array_size(list) : e->selection.patches.count;
    int64_t *ids = calloc(count + 1, sizeof *ids);
    if (!ids)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = KG_OK;
    for (size_t i = 0; i < count && !status; i++) {
        const json_t *id = one ? one : list ? json_array_get(list, i) : NULL;
        if (id && !json_is_integer(id))
            status = wrong(one ? "patch" : "patches",
                           one ? N_("a number") : N_("a list of numbers"), error);
        ids[i] = id ? json_integer_value(id) : e->selection.patches.items[i];
        if (!status)
            status = check_patch(e, ids[i], error);
    }
    if (!status && count == 0)
        status = kg_fail(error, KG_ERR_INPUT,
                         arguments ? N_("\"patch\" is missing") : N_("select a patch first"));
    if (status) {
        free(ids);
        return status;
    }
    *out_ids = ids;
    *out_count = count;
    return KG_OK;
}

kg_status kg_argument_patch(const kg_editor *e, const json_t *arguments, kg_model_patch **out_patch,
                            kg_error *error) {
    int64_t *ids;
    size_t count;
    kg_status status = kg_argument_patches(e, arguments, &ids, &count, error);
    if (status)
        return status;
    *out_patch = kg_model_find(kg_editor_model(e), ids[0]);
    free(ids);
    return KG_OK;
}

kg_status kg_argument_each(kg_editor *e, const json_t *arguments, const char *label,
                           kg_patch_act act, const void *user, kg_error *error) {
    int64_t *ids;
    size_t count;
    kg_status status = kg_argument_patches(e, arguments, &ids, &count, error);
    if (status)
        return status;
    status = kg_editor_begin(e, label, error);
    for (size_t i = 0; i < count && !status; i++)
        status = act(e, ids[i], user, error);
    free(ids);
    return kg_editor_finish(e, status);
}
