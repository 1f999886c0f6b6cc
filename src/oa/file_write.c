/* Cards to JSON: what was read, with what this version knows put in its place. */
#include "katagami/oa.h"

#include "base/writer.h"
#include "net/settings.h"

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
    json_t *o = kg_write_start(json_object_get(oa->json, "oa"));
    json_t *windows = faces(oa->window, oa->width, oa->height);
    json_t *omitted = faces(oa->omitted, oa->width, oa->height + 1);
    bool ok =
        o && windows && omitted &&
        kg_write(o, "size", json_pack("[i, i, i]", oa->width, oa->depth_limit, oa->height)) &&
        kg_write(o, "cell_mm", kg_write_number(oa->cell_mm)) && kg_write(o, "depth", depths(oa)) &&
        kg_write_unless(o, "windows", json_array_size(windows) == 0, json_incref(windows)) &&
        kg_write_unless(o, "omitted", json_array_size(omitted) == 0, json_incref(omitted)) &&
        kg_write_unless(o, "diagonals", !oa->diagonals, json_boolean(oa->diagonals)) &&
        kg_write_unless(o, "margin_cells", oa->margin_cells == 0, json_integer(oa->margin_cells)) &&
        kg_write_unless(o, "tiny_mm", oa->tiny_mm == KG_OA_TINY, kg_write_number(oa->tiny_mm));
    json_decref(windows);
    json_decref(omitted);
    return kg_write_end(o, ok);
}

static json_t *write_root(const kg_oa *oa) {
    json_t *o = kg_write_start(oa->json), *net = kg_net_settings_json(&oa->net);
    bool ok = o && net && kg_write_header(o, "oa", oa->title) &&
              kg_write_unless(o, "net", json_object_size(net) == 0, json_incref(net)) &&
              kg_write(o, "oa", write_card(oa));
    json_decref(net);
    return kg_write_end(o, ok);
}

kg_status kg_oa_write_memory(const kg_oa *oa, char **out_text, size_t *out_size, kg_error *error) {
    return kg_write_text(write_root(oa), out_text, out_size, error);
}

kg_status kg_oa_write(const kg_oa *oa, const char *path, kg_error *error) {
    return kg_write_file(write_root(oa), path, error);
}
