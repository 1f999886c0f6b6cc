/* Origami models and crease patterns from files. Messages carry the file, the line and the fold. */
#include "origami/exchange.h"

#include "base/file.h"
#include "net/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Replaying takes time that grows with the paper's faces; people fold less. */
enum { MAX_FOLDS = 10000, MAX_SHEETS = 1000 };

/* ---- sheets ----------------------------------------------------------------------------- */

static int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/* "#rgb" or "#rrggbb" */
static kg_status read_color(kg_reader *p, const json_t *sheet, const char *key, uint32_t *out) {
    const json_t *v = json_object_get(sheet, key);
    const char *s = json_string_value(v);
    if (!v)
        return KG_OK;
    kg_read_enter(p, key, 0);
    size_t n = s ? strlen(s) : 0;
    bool ok = (n == 4 || n == 7) && s[0] == '#';
    uint32_t color = 0;
    for (size_t i = 1; i < n && ok; i++) {
        int digit = hex_digit(s[i]);
        ok = digit >= 0;
        color = n == 4 ? color << 8 | (uint32_t)(digit * 17) : color << 4 | (uint32_t)digit;
    }
    kg_status status = ok ? KG_OK : kg_read_fail(p, "a colour is \"#rgb\" or \"#rrggbb\"");
    kg_read_leave(p);
    if (ok)
        *out = color;
    return status;
}

static kg_status read_polygon(kg_reader *p, const json_t *v, kg_paper_sheet *out) {
    kg_read_enter(p, "polygon", 0);
    kg_status status = json_is_array(v) ? KG_OK
                                        : kg_read_fail(p, "a sheet has a \"polygon\": a list of "
                                                          "corners");
    out->polygon = calloc(json_array_size(v) + 1, sizeof *out->polygon);
    if (!out->polygon)
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < json_array_size(v) && !status; i++) {
        double x[3];
        size_t n;
        kg_read_enter(p, NULL, i);
        status = kg_read_point(p, json_array_get(v, i), 2, x, &n);
        kg_read_leave(p);
        if (!status)
            out->polygon[out->count++] = kg_v2(x[0], x[1]);
    }
    kg_error reason;
    if (!status && (status = kg_sheet_check(out, &reason)))
        status = kg_read_fail(p, "%s", reason.message);
    kg_read_leave(p);
    return status;
}

static kg_status read_sheets(kg_reader *p, const json_t *origami, bool needed, kg_origami *o) {
    const json_t *list = json_object_get(origami, "sheets");
    kg_read_enter(p, "sheets", 0);
    kg_status status = KG_OK;
    if (!json_is_array(list) || (json_array_size(list) == 0 && needed) ||
        json_array_size(list) > MAX_SHEETS)
        status = kg_read_fail(p, "\"sheets\" is a list of 1 to %d sheets", MAX_SHEETS);
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        const json_t *v = json_array_get(list, i);
        kg_paper_sheet sheet = {
            .front = KG_SHEET_FRONT, .back = KG_SHEET_BACK, .json = kg_read_keep(v)};
        kg_read_enter(p, NULL, i);
        status = read_polygon(p, json_object_get(v, "polygon"), &sheet);
        if (!status)
            status = read_color(p, v, "front", &sheet.front);
        if (!status)
            status = read_color(p, v, "back", &sheet.back);
        if (!status && !kg_push(&o->sheets, sheet))
            status = KG_ERR_MEMORY;
        if (status) {
            free(sheet.polygon);
            json_decref(sheet.json);
        }
        kg_read_leave(p);
    }
    kg_read_leave(p);
    return status;
}

/* ---- folds ------------------------------------------------------------------------------ */

/* Flat states are often written with two numbers; z is then 0. */
static kg_status read_point(kg_reader *p, const json_t *v, kg_vec3 *out) {
    double x[3] = {0};
    size_t n;
    kg_status status = kg_read_point(p, v, 2, x, &n);
    *out = kg_v3(x[0], x[1], x[2]);
    return status;
}

static kg_status read_member(kg_reader *p, const json_t *v, const char *key, kg_vec3 *out) {
    kg_read_enter(p, key, 0);
    kg_status status = read_point(p, json_object_get(v, key), out);
    kg_read_leave(p);
    return status;
}

static kg_status read_where(kg_reader *p, const json_t *v, kg_fold *f) {
    const json_t *axis = json_object_get(v, "axis");
    f->by_axis = axis != NULL;
    if (!axis) {
        if (!json_object_get(v, "from") || !json_object_get(v, "to"))
            return kg_read_fail(p, "a fold has \"from\" and \"to\", or an \"axis\" and a "
                                   "\"vertex\"");
        kg_status status = read_member(p, v, "from", &f->points[0]);
        return status ? status : read_member(p, v, "to", &f->points[1]);
    }
    kg_read_enter(p, "axis", 0);
    kg_status status =
        json_array_size(axis) == 2 ? KG_OK : kg_read_fail(p, "an axis has two points");
    for (size_t k = 0; k < 2 && !status; k++) {
        kg_read_enter(p, NULL, k);
        status = read_point(p, json_array_get(axis, k), &f->points[k]);
        kg_read_leave(p);
    }
    kg_read_leave(p);
    return status ? status : read_member(p, v, "vertex", &f->vertex);
}

static kg_status read_index_member(kg_reader *p, const json_t *v, const char *key, int64_t lo,
                                   int32_t *out) {
    const json_t *x = json_object_get(v, key);
    if (!x)
        return KG_OK;
    kg_read_enter(p, key, 0);
    kg_status status = kg_read_index(p, x, lo, INT32_MAX, out);
    kg_read_leave(p);
    return status;
}

static kg_status read_fold(kg_reader *p, const json_t *v, kg_fold *f) {
    kg_status status = json_is_object(v) ? read_where(p, v, f) : kg_read_fail(p, "a fold is { … }");
    kg_read_enter(p, "angle_deg", 0);
    const json_t *angle = json_object_get(v, "angle_deg");
    if (!status && angle)
        status = kg_read_number(p, angle, 180, &f->angle_deg);
    kg_read_leave(p);
    if (!status)
        status = read_index_member(p, v, "face", 0, &f->face);
    if (!status)
        status = read_index_member(p, v, "layers", 1, &f->layers);
    const json_t *between = json_object_get(v, "between");
    kg_read_enter(p, "between", 0);
    if (!status && between && json_array_size(between) != 2)
        status = kg_read_fail(p, "\"between\" is a list of two faces");
    for (size_t k = 0; k < json_array_size(between) && !status; k++)
        status = kg_read_index(p, json_array_get(between, k), 0, INT32_MAX, &f->between[k]);
    kg_read_leave(p);
    return status;
}

static kg_status read_folds(kg_reader *p, const json_t *origami, kg_origami *o) {
    const json_t *list = json_object_get(origami, "folds");
    kg_read_enter(p, "folds", 0);
    kg_status status = KG_OK;
    if (list && (!json_is_array(list) || json_array_size(list) > MAX_FOLDS))
        status = kg_read_fail(p, "\"folds\" is a list of at most %d folds", MAX_FOLDS);
    for (size_t i = 0; i < json_array_size(list) && !status; i++) {
        const json_t *v = json_array_get(list, i);
        kg_fold fold = kg_fold_default();
        kg_error reason;
        kg_read_enter(p, NULL, i);
        fold.json = (json_t *)(uintptr_t)v;
        status = read_fold(p, v, &fold);
        if (!status && (status = kg_origami_fold(o, &fold, &reason)) == KG_ERR_INPUT)
            status = kg_read_fail(p, "fold %zu: %s", i + 1, reason.message);
        kg_read_leave(p);
    }
    kg_read_leave(p);
    return status;
}

/* ---- models ----------------------------------------------------------------------------- */

/* Replaces the state of flat sheets by that of sheets, or of a pattern, that were read. */
static void set_start(kg_origami *o, kg_origami_state *s) {
    kg_state_destroy(o->states.items[0]);
    o->states.items[0] = s;
}

static kg_status read_model(kg_reader *p, kg_origami *o) {
    kg_status status = kg_read_header(p, "origami", "an origami model");
    if (status)
        return status;
    const json_t *origami = json_object_get(p->root, "origami"),
                 *pattern = json_object_get(origami, "pattern");
    kg_origami_state *s = NULL;
    o->json = kg_read_keep(p->root);
    status = kg_read_string(p, p->root, "title", &o->title);
    if (!status)
        status = kg_net_settings_parse(p, p->root, &o->net);
    if (status)
        return status;
    kg_read_enter(p, "origami", 0);
    if (!json_is_object(origami))
        return kg_read_fail(p, "an origami model has \"origami\": {\"sheets\": …}");
    status = read_sheets(p, origami, !pattern, o);
    if (!status && pattern) {
        kg_layer_report report = kg_layer_report_default();
        kg_read_enter(p, "pattern", 0);
        status = kg_fold_read(p, pattern, true, NULL, &report, &s);
        o->pattern = true;
        kg_read_leave(p);
    } else if (!status) {
        status = kg_state_from_sheets(o->sheets.items, o->sheets.count, &s, p->error);
    }
    if (status)
        return status;
    set_start(o, s);
    return read_folds(p, origami, o);
}

kg_status kg_origami_read_memory(const char *data, size_t size, const char *name,
                                 kg_origami **out_origami, kg_error *error) {
    kg_reader p;
    kg_status status = kg_read_begin(&p, data, size, name, error);
    if (status)
        return status;
    kg_origami *o = kg_origami_create();
    status = kg_read_end(&p, o ? read_model(&p, o) : KG_ERR_MEMORY);
    if (status)
        kg_origami_destroy(o);
    else
        *out_origami = o;
    return status;
}

/* ---- crease patterns -------------------------------------------------------------------- */

/* "vertices_coords[12]: ", since many such files are one line. */
static void say_path(const void *owner, char *out, size_t size) {
    const kg_reader *p = owner;
    size_t n = 0;
    for (size_t i = 0; i < p->depth && n < size; i++) {
        const kg_json_step *step = &p->path[i];
        n += (size_t)(step->key ? snprintf(out + n, size - n, "%s%s", i > 0 ? "." : "", step->key)
                                : snprintf(out + n, size - n, "[%zu]", step->index));
    }
    if (n > 0 && n < size)
        snprintf(out + n, size - n, ": ");
}

static kg_status import_state(const char *data, size_t size, const char *name,
                              const kg_progress *progress, kg_layer_report *report,
                              kg_origami_state **out_state, char **title, kg_error *error) {
    kg_status status;
    if (kg_file_ends_in(name, ".cp")) {
        kg_pattern pattern;
        if ((status = kg_cp_read(data, size, name, &pattern, error)))
            return status;
        status = kg_pattern_solve(&pattern, progress, report, out_state, error);
        kg_pattern_clear(&pattern);
    } else {
        kg_reader p;
        if ((status = kg_read_begin(&p, data, size, name, error)))
            return status;
        p.place = say_path;
        p.owner = &p;
        status = kg_fold_read(&p, p.root, false, progress, report, out_state);
        const char *given = json_string_value(json_object_get(p.root, "file_title"));
        char *copy = !status && given ? strdup(given) : NULL;
        if (copy) {
            free(*title);
            *title = copy;
        }
        status = kg_read_end(&p, status);
    }
    if (status == KG_ERR_MEMORY)
        return kg_fail(error, status, "%s: out of memory", name);
    return status == KG_ERR_INPUT || status == KG_ERR_CANCELLED
               ? kg_fail_in(error, status, "%s: ", name)
               : status;
}

kg_status kg_origami_import_memory(const char *data, size_t size, const char *name,
                                   const kg_progress *progress, kg_origami **out_origami,
                                   kg_layer_report *report, kg_error *error) {
    kg_layer_report plain = kg_layer_report_default();
    kg_origami_state *s;
    kg_origami *o = kg_origami_create();
    if (!o)
        return kg_fail(error, KG_ERR_MEMORY, "%s: out of memory", name);
    kg_status status =
        import_state(data, size, name, progress, report ? report : &plain, &s, &o->title, error);
    if (status) {
        kg_origami_destroy(o);
        return status;
    }
    set_start(o, s);
    o->pattern = true;
    *out_origami = o;
    return KG_OK;
}

/* ---- files ------------------------------------------------------------------------------ */

kg_status kg_origami_read(const char *path, kg_origami **out_origami, kg_error *error) {
    char *data;
    size_t size;
    kg_status status = kg_file_read(path, &data, &size, error);
    if (status)
        return status;
    status = kg_origami_read_memory(data, size, strcmp(path, "-") ? path : "standard input",
                                    out_origami, error);
    free(data);
    return status;
}

kg_status kg_origami_import(const char *path, const kg_progress *progress, kg_origami **out_origami,
                            kg_layer_report *report, kg_error *error) {
    char *data;
    size_t size;
    kg_status status = kg_file_read(path, &data, &size, error);
    if (status)
        return status;
    status = kg_origami_import_memory(data, size, path, progress, out_origami, report, error);
    free(data);
    return status;
}
