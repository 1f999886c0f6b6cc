/* Cards to JSON: what was read, with what this version knows put in its place. */
#include "katagami/oa.h"

#include "base/file.h"
#include "base/json.h"

#include <stdlib.h>
#include <string.h>

/* A shallow copy of the object kept under `key`, or a new one. */
static json_t *start(const json_t *kept, const char *key) {
    const json_t *object = key ? json_object_get(kept, key) : kept;
    return json_is_object(object) ? json_copy((json_t *)(uintptr_t)object) : json_object();
}

/* Sets a member and takes over `value`; false when memory ran out anywhere. */
static bool set(json_t *object, const char *key, json_t *value) {
    return json_object_set_new(object, key, value) == 0;
}

/* Sets a member that need not be written while it has its default and is not there yet. */
static bool set_unless(json_t *object, const char *key, bool is_default, json_t *value) {
    if (is_default && !json_object_get(object, key)) {
        json_decref(value);
        return true;
    }
    return set(object, key, value);
}

/* Whole numbers without a decimal point, as people write them. */
static json_t *number(double x) {
    return x == floor(x) ? json_integer((json_int_t)x) : json_real(x);
}

static json_t *depths(const kg_oa *oa) {
    json_t *columns = json_array();
    for (int x = 0; x < oa->width && columns; x++) {
        json_t *column = json_array();
        bool ok = column != NULL;
        for (int z = 0; z < oa->height && ok; z++)
            ok = json_array_append_new(column, json_integer(kg_oa_depth(oa, x, z))) == 0;
        if (!ok)
            json_decref(column);
        if (json_array_append_new(columns, ok ? column : NULL)) {
            json_decref(columns);
            columns = NULL;
        }
    }
    return columns;
}

/* The [x, z] that are set in columns of `levels` flags. */
static json_t *faces(const unsigned char *flags, int width, int levels) {
    json_t *list = json_array();
    for (int x = 0; x < width; x++)
        for (int z = 0; z < levels && list; z++)
            if (flags[x * levels + z] && json_array_append_new(list, json_pack("[i, i]", x, z))) {
                json_decref(list);
                list = NULL;
            }
    return list;
}

static json_t *write_card(const kg_oa *oa) {
    json_t *o = start(oa->json, "oa");
    json_t *windows = faces(oa->window, oa->width, oa->height);
    json_t *omitted = faces(oa->omitted, oa->width, oa->height + 1);
    bool ok =
        o && windows && omitted &&
        set(o, "size", json_pack("[i, i, i]", oa->width, oa->depth_limit, oa->height)) &&
        set(o, "cell_mm", number(oa->cell_mm)) && set(o, "depth", depths(oa)) &&
        set_unless(o, "windows", json_array_size(windows) == 0, json_incref(windows)) &&
        set_unless(o, "omitted", json_array_size(omitted) == 0, json_incref(omitted)) &&
        set_unless(o, "diagonals", !oa->diagonals, json_boolean(oa->diagonals)) &&
        set_unless(o, "margin_cells", oa->margin_cells == 0, json_integer(oa->margin_cells)) &&
        set_unless(o, "tiny_mm", oa->tiny_mm == KG_OA_TINY, number(oa->tiny_mm));
    json_decref(windows);
    json_decref(omitted);
    if (ok)
        return o;
    json_decref(o);
    return NULL;
}

static json_t *write_net(const kg_oa *oa) {
    json_t *o = start(oa->json, "net");
    bool ok = o && set_unless(o, "paper", !oa->paper, json_string(oa->paper ? oa->paper : "A4")) &&
              set_unless(o, "margin", oa->margin == 8, number(oa->margin)) &&
              set_unless(o, "scale", oa->scale == 1, number(oa->scale));
    if (ok)
        return o;
    json_decref(o);
    return NULL;
}

static json_t *write_root(const kg_oa *oa) {
    json_t *o = start(oa->json, NULL), *net = write_net(oa);
    bool ok = o && net && set(o, "katagami", json_integer(KG_OA_VERSION)) &&
              set(o, "kind", json_string("oa")) &&
              set_unless(o, "title", oa->title[0] == '\0', json_string(oa->title)) &&
              set_unless(o, "net", json_object_size(net) == 0, json_incref(net)) &&
              set(o, "oa", write_card(oa));
    json_decref(net);
    if (ok)
        return o;
    json_decref(o);
    return NULL;
}

kg_status kg_oa_write_memory(const kg_oa *oa, char **out_text, size_t *out_size, kg_error *error) {
    json_t *root = write_root(oa);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory, or a title that is not UTF-8");
    *out_text = text;
    *out_size = strlen(text);
    return KG_OK;
}

kg_status kg_oa_write(const kg_oa *oa, const char *path, kg_error *error) {
    char *text;
    size_t size;
    kg_status status = kg_oa_write_memory(oa, &text, &size, error);
    if (status)
        return status;
    status = kg_file_write(path, text, size, error);
    free(text);
    return status;
}
