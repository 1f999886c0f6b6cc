/* Origami models and crease patterns to files. */
#include "origami/exchange.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A copy of the kept object to write into, or a new one. Members are replaced, never changed. */
static json_t *start(const json_t *kept) {
    return kept ? json_copy((json_t *)(uintptr_t)kept) : json_object();
}

static json_t *number(double x) {
    return x == floor(x) && fabs(x) < 1e15 ? json_integer((json_int_t)x) : json_real(x);
}

static json_t *point(const double *x, size_t n) {
    json_t *row = json_array();
    for (size_t i = 0; i < n; i++)
        json_array_append_new(row, number(x[i]));
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
    json_t *o = start(s->json), *polygon = json_array();
    for (size_t i = 0; i < s->count; i++)
        json_array_append_new(polygon, point(&s->polygon[i].x, 2));
    json_object_set_new(o, "polygon", polygon);
    set_color(o, "front", s->front);
    set_color(o, "back", s->back);
    return o;
}

/* Sets a member that is there, takes out one that is not; what stays keeps its place. */
static void set_if(json_t *o, const char *key, bool is_there, json_t *value) {
    if (is_there)
        json_object_set(o, key, value);
    else
        json_object_del(o, key);
    json_decref(value);
}

static json_t *write_fold(const kg_fold *f) {
    json_t *o = start(f->json);
    set_if(o, "from", !f->by_axis, point(&f->points[0].x, 3));
    set_if(o, "to", !f->by_axis, point(&f->points[1].x, 3));
    set_if(o, "axis", f->by_axis,
           json_pack("[o,o]", point(&f->points[0].x, 3), point(&f->points[1].x, 3)));
    set_if(o, "vertex", f->by_axis, point(&f->vertex.x, 3));
    set_if(o, "angle_deg", true, number(f->angle_deg));
    set_if(o, "face", f->face >= 0, json_integer(f->face));
    set_if(o, "layers", f->layers > 0, json_integer(f->layers));
    set_if(o, "between", f->between[0] >= 0, json_pack("[i,i]", f->between[0], f->between[1]));
    return o;
}

kg_status kg_origami_write_memory(const kg_origami *o, char **out_text, size_t *out_size,
                                  kg_error *error) {
    json_t *root = start(o->json), *origami = root ? start(json_object_get(root, "origami")) : NULL,
           *sheets = json_array(), *folds = json_array();
    for (size_t i = 0; i < o->sheets.count; i++)
        json_array_append_new(sheets, write_sheet(&o->sheets.items[i]));
    for (size_t i = 0; i < o->step; i++)
        json_array_append_new(folds, write_fold(&o->folds.items[i]));
    bool ok = root && origami && sheets && folds &&
              json_object_set_new(root, "katagami", json_integer(1)) == 0 &&
              json_object_set_new(root, "kind", json_string("origami")) == 0 &&
              json_object_set(origami, "sheets", sheets) == 0 &&
              json_object_set(origami, "folds", folds) == 0;
    if (ok && o->title[0])
        ok = json_object_set_new(root, "title", json_string(o->title)) == 0;
    if (!o->title[0] && root)
        json_object_del(root, "title");
    /* the crease pattern that it began as is kept as a FOLD object */
    if (ok && o->pattern && !json_object_get(origami, "pattern"))
        ok = json_object_set_new(origami, "pattern",
                                 kg_fold_json(o->states.items[0], NULL, 0, o->title)) == 0;
    ok = ok && json_object_set(root, "origami", origami) == 0;
    char *text = ok ? kg_json_text(root) : NULL;
    json_decref(root);
    json_decref(origami);
    json_decref(sheets);
    json_decref(folds);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_text = text;
    *out_size = strlen(text);
    return KG_OK;
}

kg_status kg_origami_write(const kg_origami *o, const char *path, kg_error *error) {
    char *text;
    size_t size;
    kg_status status = kg_origami_write_memory(o, &text, &size, error);
    if (status)
        return status;
    status = kg_file_write(path, text, size, error);
    free(text);
    return status;
}

/* ---- exchange --------------------------------------------------------------------------- */

kg_status kg_origami_fold_text(const kg_origami *o, size_t step, bool all_steps, char **out_text,
                               size_t *out_size, kg_error *error) {
    json_t *root =
        kg_fold_json(o->states.items[step], o->states.items, all_steps ? step : 0, o->title);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    *out_text = text;
    *out_size = strlen(text);
    return KG_OK;
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
