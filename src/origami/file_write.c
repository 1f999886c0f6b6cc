/* Origami models and crease patterns to files. */
#include "origami/exchange.h"

#include "base/file.h"
#include "base/writer.h"
#include "net/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static json_t *point(const double *x, size_t n) {
    json_t *row = json_array();
    for (size_t i = 0; i < n; i++)
        json_array_append_new(row, kg_write_number(x[i]));
    return row;
}

/* A colour that was written as "#rgb" stays so. */
static void set_color(json_t *o, const char *key, uint32_t color) {
    char text[16];
    snprintf(text, sizeof text, "#%06x", color & 0xffffff);
    const char *old = json_string_value(json_object_get(o, key));
    if (old && strlen(old) == 4) {
        char wide[] = {'#', old[1], old[1], old[2], old[2], old[3], old[3], '\0'};
        for (char *c = wide; *c; c++)
            *c = *c >= 'A' && *c <= 'F' ? (char)(*c - 'A' + 'a') : *c;
        if (strcmp(wide, text) == 0)
            return;
    }
    json_object_set_new(o, key, json_string(text));
}

static json_t *write_sheet(const kg_paper_sheet *s) {
    json_t *o = kg_write_start(s->json), *polygon = json_array();
    for (size_t i = 0; i < s->count; i++)
        json_array_append_new(polygon, point(&s->polygon[i].x, 2));
    json_object_set_new(o, "polygon", polygon);
    set_color(o, "front", s->front);
    set_color(o, "back", s->back);
    return o;
}

static json_t *write_fold(const kg_fold *f) {
    json_t *o = kg_write_start(f->json);
    kg_write_if(o, "from", !f->by_axis, point(&f->points[0].x, 3));
    kg_write_if(o, "to", !f->by_axis, point(&f->points[1].x, 3));
    kg_write_if(o, "axis", f->by_axis,
                json_pack("[o,o]", point(&f->points[0].x, 3), point(&f->points[1].x, 3)));
    kg_write_if(o, "vertex", f->by_axis, point(&f->vertex.x, 3));
    kg_write_if(o, "angle_deg", true, kg_write_number(f->angle_deg));
    kg_write_if(o, "face", f->face >= 0, json_integer(f->face));
    kg_write_if(o, "layers", f->layers > 0, json_integer(f->layers));
    kg_write_if(o, "between", f->between[0] >= 0, json_pack("[i,i]", f->between[0], f->between[1]));
    return o;
}

static json_t *write_root(const kg_origami *o) {
    json_t *root = kg_write_start(o->json), *net = kg_net_settings_json(&o->net),
           *origami = kg_write_start(json_object_get(o->json, "origami")), *sheets = json_array(),
           *folds = json_array();
    for (size_t i = 0; i < o->sheets.count; i++)
        json_array_append_new(sheets, write_sheet(&o->sheets.items[i]));
    for (size_t i = 0; i < o->step; i++)
        json_array_append_new(folds, write_fold(&o->folds.items[i]));
    bool ok = root && net && origami && sheets && folds &&
              kg_write_header(root, "origami", o->title) &&
              kg_write_unless(root, "net", json_object_size(net) == 0, json_incref(net)) &&
              kg_write(origami, "sheets", json_incref(sheets)) &&
              kg_write(origami, "folds", json_incref(folds));
    /* the crease pattern that it began as is kept as a FOLD object */
    if (ok && o->pattern && !json_object_get(origami, "pattern"))
        ok = kg_write(origami, "pattern", kg_fold_json(o->states.items[0], NULL, 0, o->title));
    ok = ok && kg_write(root, "origami", json_incref(origami));
    json_decref(net);
    json_decref(origami);
    json_decref(sheets);
    json_decref(folds);
    return kg_write_end(root, ok);
}

kg_status kg_origami_write_memory(const kg_origami *o, char **out_text, size_t *out_size,
                                  kg_error *error) {
    return kg_write_text(write_root(o), out_text, out_size, error);
}

kg_status kg_origami_write(const kg_origami *o, const char *path, kg_error *error) {
    return kg_write_file(write_root(o), path, error);
}

/* ---- exchange --------------------------------------------------------------------------- */

kg_status kg_origami_fold_text(const kg_origami *o, size_t step, bool all_steps, char **out_text,
                               size_t *out_size, kg_error *error) {
    return kg_write_text(
        kg_fold_json(o->states.items[step], o->states.items, all_steps ? step : 0, o->title),
        out_text, out_size, error);
}

kg_status kg_origami_export(const kg_origami *o, size_t step, bool all_steps, const char *path,
                            kg_error *error) {
    size_t n = strlen(path), size = 0;
    char *text = NULL;
    kg_status status = KG_OK;
    if (n >= 3 && strcmp(path + n - 3, ".cp") == 0) {
        text = kg_cp_text(o->states.items[step]);
        status = text ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
        size = text ? strlen(text) : 0;
    } else {
        status = kg_origami_fold_text(o, step, all_steps, &text, &size, error);
    }
    if (!status)
        status = kg_file_write(path, text, size, error);
    free(text);
    return status;
}
