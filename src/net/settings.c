#include "net/settings.h"

#include "base/writer.h"

#include <stdlib.h>
#include <string.h>

const char *const kg_net_label_names[] = {"none", "inside", "outside", NULL};
const char *const kg_net_tab_side_names[] = {"auto", "none", "this", "other", NULL};
const char *const kg_net_tab_shape_names[] = {"auto", "trapezoid", "teeth", NULL};
const char *const kg_net_preset_names[] = {"print", "laser", "silhouette", "cricut", NULL};

kg_net_settings kg_net_settings_default(void) {
    return (kg_net_settings){.margin = 8, .scale = 1, .tab_width = 5};
}

void kg_net_settings_clear(kg_net_settings *s) {
    free(s->paper);
    json_decref(s->json);
    *s = kg_net_settings_default();
}

bool kg_net_settings_copy(const kg_net_settings *from, kg_net_settings *to) {
    *to = *from;
    to->json = json_incref(from->json); /* never changed in place, so it can be shared */
    to->paper = from->paper ? strdup(from->paper) : NULL;
    return to->paper || !from->paper;
}

bool kg_net_settings_equal(const kg_net_settings *a, const kg_net_settings *b) {
    bool same_paper = a->paper == b->paper || (a->paper && b->paper && !strcmp(a->paper, b->paper));
    return same_paper && a->margin == b->margin && a->scale == b->scale &&
           a->tab_width == b->tab_width && (a->json == b->json || json_equal(a->json, b->json));
}

/* ---- files ------------------------------------------------------------------------------ */

kg_status kg_net_settings_parse(kg_reader *r, const json_t *root, kg_net_settings *s) {
    const json_t *v = NULL;
    kg_status status = kg_read_object(r, root, "net", &v);
    if (status || !v)
        return status;
    kg_read_enter(r, "net", 0);
    s->json = kg_read_keep(v);
    status = kg_read_string(r, v, "paper", &s->paper);
    if (!status)
        status = kg_read_double(r, v, "margin", &s->margin);
    if (!status)
        status = kg_read_double(r, v, "scale", &s->scale);
    if (!status)
        status = kg_read_double(r, v, "tab_width", &s->tab_width);
    if (!status && !(s->margin >= 0 && s->scale > 0 && s->tab_width >= 0))
        status = kg_read_fail(r, "\"scale\" is above 0, \"margin\" and \"tab_width\" are not "
                                 "negative");
    kg_read_leave(r);
    return status;
}

json_t *kg_net_settings_json(const kg_net_settings *s) {
    json_t *o = kg_write_start(s->json);
    bool ok = o &&
              kg_write_unless(o, "paper", !s->paper, json_string(s->paper ? s->paper : "A4")) &&
              kg_write_unless(o, "margin", s->margin == 8, kg_write_number(s->margin)) &&
              kg_write_unless(o, "scale", s->scale == 1, kg_write_number(s->scale)) &&
              kg_write_unless(o, "tab_width", s->tab_width == 5, kg_write_number(s->tab_width));
    return kg_write_end(o, ok);
}

kg_status kg_net_settings_set(kg_net_settings *s, const char *key, json_t *value, kg_error *error) {
    /* copies share their objects, so that one is never changed in place */
    json_t *copy = s->json ? json_copy(s->json) : json_object();
    int failed = !copy || (value ? json_object_set(copy, key, value) : 0);
    if (!value)
        json_object_del(copy, key); /* it may not be there */
    json_decref(value);
    if (failed) {
        json_decref(copy);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    json_decref(s->json);
    s->json = copy;
    return KG_OK;
}

/* ---- what they ask for ------------------------------------------------------------------ */

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

kg_net_preset kg_net_settings_preset(const kg_net_settings *s) {
    int preset = KG_PRESET_PRINT;
    kg_status status = read_word(s->json, "preset", kg_net_preset_names, &preset, NULL);
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

kg_status kg_net_settings_options(const kg_net_settings *s, kg_net_options *out_options,
                                  kg_error *error) {
    kg_net_options o = kg_net_options_default();
    const json_t *json = s->json;
    int preset = KG_PRESET_PRINT, labels = (int)o.labels;
    o.nest = true;
    kg_status status = read_word(json, "preset", kg_net_preset_names, &preset, error);
    if (!status) /* first: one of them brings its own page */
        kg_net_options_preset(&o, (kg_net_preset)preset);
    if (!status && s->paper)
        status = kg_net_paper_parse(s->paper, &o.paper, error);
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
    o.margin = s->margin;
    o.scale = s->scale;
    *out_options = o;
    return KG_OK;
}

kg_net_tab_side kg_net_tab_turned(kg_net_tab_side side) {
    return side == KG_TAB_THIS ? KG_TAB_OTHER : side == KG_TAB_OTHER ? KG_TAB_THIS : side;
}
