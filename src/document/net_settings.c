#include "document/net_settings.h"

#include <jansson.h>
#include <string.h>

const char *const kg_net_label_names[] = {"none", "inside", "outside", NULL};
const char *const kg_net_preset_names[] = {"print", "laser", "silhouette", "cricut", NULL};

static kg_status read_bool(const json_t *net, const char *key, bool *value, kg_error *error) {
    const json_t *v = json_object_get(net, key);
    if (v && !json_is_boolean(v))
        return kg_fail(error, KG_ERR_INPUT, "net: \"%s\" has to be true or false", key);
    if (v)
        *value = json_is_true(v);
    return KG_OK;
}

/* The index of a word among `names`; stays as it is when the key is missing. */
static kg_status read_word(const json_t *net, const char *key, const char *const *names, int *value,
                           kg_error *error) {
    const json_t *v = json_object_get(net, key);
    const char *text = json_string_value(v);
    if (!v)
        return KG_OK;
    for (int i = 0; text && names[i]; i++)
        if (strcmp(text, names[i]) == 0) {
            *value = i;
            return KG_OK;
        }
    char list[128] = "";
    for (int i = 0; names[i]; i++) {
        strcat(list, i ? ", " : "");
        strcat(list, names[i]);
    }
    return kg_fail(error, KG_ERR_INPUT, "net: \"%s\" has to be one of %s", key, list);
}

kg_net_preset kg_net_settings_preset(const kg_model_net *net) {
    int preset = KG_PRESET_PRINT;
    kg_status status = read_word(net->json, "preset", kg_net_preset_names, &preset, NULL);
    return status ? KG_PRESET_PRINT : (kg_net_preset)preset;
}

static kg_status read_gap(const json_t *net, double *value, kg_error *error) {
    const json_t *v = json_object_get(net, "gap");
    double gap = v ? json_number_value(v) : *value;
    if ((v && !json_is_number(v)) || !(gap >= 0 && gap <= 1000))
        return kg_fail(error, KG_ERR_INPUT, "net: \"gap\" has to be 0 to 1000 mm");
    *value = gap;
    return KG_OK;
}

kg_status kg_net_settings_read(const kg_model_net *net, kg_net_options *out_options,
                               kg_error *error) {
    kg_net_options o = kg_net_options_default();
    const json_t *json = net->json;
    int preset = KG_PRESET_PRINT, labels = (int)o.labels;
    o.nest = true;
    kg_status status = read_word(json, "preset", kg_net_preset_names, &preset, error);
    if (!status) /* first: one of them brings its own page */
        kg_net_options_preset(&o, (kg_net_preset)preset);
    if (!status && net->paper)
        status = kg_net_paper_parse(net->paper, &o.paper, error);
    if (!status)
        status = read_word(json, "labels", kg_net_label_names, &labels, error);
    if (!status)
        status = read_bool(json, "landscape", &o.landscape, error);
    if (!status)
        status = read_bool(json, "nest", &o.nest, error);
    if (!status)
        status = read_bool(json, "grain", &o.grain, error);
    bool merge;
    if (!status)
        status = read_bool(json, "merge", &merge, error);
    if (!status)
        status = read_gap(json, &o.gap, error);
    if (status)
        return status;
    o.labels = (kg_net_labels)labels;
    o.margin = net->margin;
    o.scale = net->scale;
    *out_options = o;
    return KG_OK;
}

kg_parts_options kg_net_settings_parts(const kg_model_net *net, const kg_net_options *options,
                                       double tab_width) {
    double rims = 2 * options->margin;
    kg_parts_options parts = {.tab_width = tab_width / options->scale};
    if (options->paper.x > 0)
        parts.room = kg_v2((options->paper.x - rims) / options->scale,
                           (options->paper.y - rims) / options->scale);
    parts.merge = net && json_is_true(json_object_get(net->json, "merge"));
    return parts;
}

double kg_net_settings_chord(const kg_net_options *options) {
    return fmin(KG_NET_CHORD, 0.2 * options->tolerance / options->scale);
}

kg_status kg_net_settings_set(kg_model_net *net, const char *key, json_t *value, kg_error *error) {
    /* models share their objects, so that one is never changed in place */
    json_t *copy = net->json ? json_copy(net->json) : json_object();
    int failed = !copy || (value ? json_object_set(copy, key, value) : 0);
    if (!value)
        json_object_del(copy, key); /* it may not be there */
    json_decref(value);
    if (failed) {
        json_decref(copy);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    json_decref(net->json);
    net->json = copy;
    return KG_OK;
}
