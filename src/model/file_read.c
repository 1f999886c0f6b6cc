/* Patch models from JSON. Messages carry the file, the line and the patch. */
#include "katagami/model.h"

#include "base/file.h"
#include "base/json.h"
#include "model/lookup.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DEPTH = 8 };

typedef struct reader {
    const char *name, *text;
    kg_json_step path[MAX_DEPTH];
    size_t depth;
    int64_t patch;
    bool in_patch;
    kg_error *error;
} reader;

static kg_status fail_at(reader *r, const char *format, ...) KG_PRINTF(2, 3);

static kg_status fail_at(reader *r, const char *format, ...) {
    char message[KG_ERROR_SIZE / 2], where[32] = "";
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    if (r->in_patch)
        snprintf(where, sizeof where, "patch %lld: ", (long long)r->patch);
    return kg_fail(r->error, KG_ERR_PARSE, "%s:%d: %s%s", r->name,
                   kg_json_line(r->text, r->path, r->depth), where, message);
}

static void enter(reader *r, const char *key, size_t index) {
    r->path[r->depth++] = (kg_json_step){key, index};
}

static void leave(reader *r) {
    r->depth--;
}

/* ---- values ----------------------------------------------------------------------------- */

static kg_status read_number(reader *r, const json_t *v, double limit, double *out) {
    if (!json_is_number(v))
        return fail_at(r, "a number is wanted here");
    double x = json_number_value(v);
    if (!(fabs(x) <= limit))
        return fail_at(r, "%g is beyond %g", x, limit);
    *out = x;
    return KG_OK;
}

/* An optional member; absent leaves `*out`. */
static kg_status read_double(reader *r, const json_t *object, const char *key, double *out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    kg_status status = read_number(r, v, KG_MAX_COORDINATE, out);
    leave(r);
    return status;
}

static kg_status read_bool(reader *r, const json_t *object, const char *key, bool *out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    kg_status status = json_is_boolean(v) ? KG_OK : fail_at(r, "\"%s\" is true or false", key);
    leave(r);
    if (!status)
        *out = json_is_true(v);
    return status;
}

static kg_status read_string(reader *r, const json_t *object, const char *key, char **out) {
    const json_t *v = json_object_get(object, key);
    if (!v)
        return KG_OK;
    enter(r, key, 0);
    kg_status status = json_is_string(v) ? KG_OK : fail_at(r, "\"%s\" is a text", key);
    leave(r);
    if (status)
        return status;
    char *copy = strdup(json_string_value(v));
    if (!copy)
        return KG_ERR_MEMORY;
    free(*out);
    *out = copy;
    return KG_OK;
}

/* An array of `n` numbers. */
static kg_status read_numbers(reader *r, const json_t *v, size_t n, double *out) {
    if (!json_is_array(v) || json_array_size(v) != n)
        return fail_at(r, "%zu numbers are wanted here", n);
    for (size_t i = 0; i < n; i++) {
        enter(r, NULL, i);
        kg_status status = read_number(r, json_array_get(v, i), KG_MAX_COORDINATE, &out[i]);
        leave(r);
        if (status)
            return status;
    }
    return KG_OK;
}

/* An array of rows of `width` doubles (2 or 3), as kg_vec2 or kg_vec3. */
static kg_status read_rows(reader *r, const json_t *v, size_t width, void **out_rows,
                           size_t *out_count) {
    if (!json_is_array(v))
        return fail_at(r, "a list of points is wanted here");
    size_t n = json_array_size(v);
    double *rows = calloc(n + 1, width * sizeof *rows);
    if (!rows)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < n; i++) {
        enter(r, NULL, i);
        kg_status status = read_numbers(r, json_array_get(v, i), width, rows + i * width);
        leave(r);
        if (status) {
            free(rows);
            return status;
        }
    }
    *out_rows = rows;
    *out_count = n;
    return KG_OK;
}

static kg_status read_object(reader *r, const json_t *parent, const char *key, const json_t **out) {
    const json_t *v = json_object_get(parent, key);
    if (v && !json_is_object(v)) {
        enter(r, key, 0);
        kg_status status = fail_at(r, "\"%s\" is an object: { … }", key);
        leave(r);
        return status;
    }
    *out = v;
    return KG_OK;
}

/* Keeps the object as it was read, so that what this version does not know survives. It is never
 * changed in place, so it can be shared. */
static json_t *keep_json(const json_t *v) {
    return json_incref((json_t *)(uintptr_t)v);
}

/* ---- trims ------------------------------------------------------------------------------ */

static kg_status read_cutter(reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_integer(v))
        return fail_at(r, "a patch id (a whole number) is wanted here");
    if (json_integer_value(v) == r->patch)
        return fail_at(r, "a patch cannot cut itself");
    op->by[op->by_count++] = json_integer_value(v);
    return KG_OK;
}

static kg_status check_repeats(reader *r, const kg_trim_op *op) {
    kg_lookup ids;
    kg_status status = kg_lookup_create(op->by_count, &ids);
    if (status)
        return status;
    for (size_t i = 0; i < op->by_count; i++)
        kg_lookup_add(&ids, op->by[i], i);
    kg_lookup_sort(&ids);
    for (size_t i = 1; i < ids.count && !status; i++)
        if (ids.entries[i].id == ids.entries[i - 1].id) {
            enter(r, NULL, ids.entries[i].index);
            status = fail_at(r, "patch %lld is named twice", (long long)ids.entries[i].id);
            leave(r);
        }
    kg_lookup_clear(&ids);
    return status;
}

static kg_status read_by(reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_array(v) || json_array_size(v) == 0)
        return fail_at(r, "\"by\" is a list of patch ids");
    op->by = calloc(json_array_size(v), sizeof *op->by);
    if (!op->by)
        return KG_ERR_MEMORY;
    kg_status status = KG_OK;
    for (size_t i = 0; i < json_array_size(v) && !status; i++) {
        enter(r, NULL, i);
        status = read_cutter(r, json_array_get(v, i), op);
        leave(r);
    }
    return status ? status : check_repeats(r, op);
}

static kg_status read_contour(reader *r, const json_t *v, kg_trim_op *op) {
    op->kind = KG_TRIM_CONTOUR;
    enter(r, "contour", 0);
    kg_status status =
        read_rows(r, json_object_get(v, "contour"), 2, (void **)&op->contour, &op->contour_count);
    leave(r);
    const json_t *keep = json_object_get(v, "keep");
    if (status || !keep)
        return status;
    const char *word = json_string_value(keep);
    enter(r, "keep", 0);
    if (!word || (strcmp(word, "inside") && strcmp(word, "outside")))
        status = fail_at(r, "a contour keeps \"inside\" or \"outside\"");
    leave(r);
    op->outside = !status && !strcmp(word, "outside");
    return status;
}

static kg_status read_cut(reader *r, const json_t *v, kg_trim_op *op) {
    const json_t *by = json_object_get(v, "by"), *keep = json_object_get(v, "keep");
    bool inside = false;
    if (!by)
        return fail_at(r, "a trim has \"by\": [ids] or a \"contour\"");
    enter(r, "by", 0);
    kg_status status = read_by(r, by, op);
    leave(r);
    if (!status)
        status = read_bool(r, v, "inside", &inside);
    if (!status)
        status = read_bool(r, v, "bounded", &op->bounded);
    if (!status)
        status = read_bool(r, v, "trim_cutters", &op->trim_cutters);
    if (!status && keep) {
        enter(r, "keep", 0);
        status = read_rows(r, keep, 3, (void **)&op->keep, &op->keep_count);
        leave(r);
    }
    if (status)
        return status;
    op->kind = inside ? KG_TRIM_INSIDE : KG_TRIM_BY;
    if (!inside && op->by_count > 1)
        return fail_at(r, "several cutters need \"inside\": true, or one trim for each");
    return KG_OK;
}

static kg_status read_trim(reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_object(v))
        return fail_at(r, "a trim is an object: { … }");
    if (json_object_get(v, "by") && json_object_get(v, "contour"))
        return fail_at(r, "a trim has \"by\" or a \"contour\", not both");
    op->json = keep_json(v);
    kg_status status = read_bool(r, v, "off", &op->off);
    if (!status)
        status = json_object_get(v, "contour") ? read_contour(r, v, op) : read_cut(r, v, op);
    return status;
}

/* ---- patches ---------------------------------------------------------------------------- */

static kg_status read_points(reader *r, const json_t *v, kg_patch_input *in) {
    kg_vec3 *points = NULL;
    size_t count = 0;
    enter(r, "points", 0);
    kg_status status =
        v ? read_rows(r, v, 3, (void **)&points, &count) : fail_at(r, "a patch needs \"points\"");
    if (!status && count != 4 && count != 6)
        status = fail_at(r, "a geodesic has 4 or 6 control points, not %zu", count);
    leave(r);
    if (!status) {
        memcpy(in->points, points, count * sizeof *points);
        in->point_count = count;
    }
    free(points);
    return status;
}

static kg_status read_extent(reader *r, const json_t *v, kg_patch_input *in) {
    enter(r, "extent", 0);
    kg_status status =
        v ? read_numbers(r, v, 2, in->extent) : fail_at(r, "a patch needs \"extent\": [lo, hi]");
    if (!status && !(in->extent[0] < in->extent[1]))
        status = fail_at(r, "the extent [%g, %g] must grow", in->extent[0], in->extent[1]);
    leave(r);
    return status;
}

static kg_status read_ruling(reader *r, const json_t *v, kg_patch_input *in) {
    double d[3];
    if (!v)
        return KG_OK;
    enter(r, "ruling", 0);
    kg_status status = read_numbers(r, v, 3, d);
    leave(r);
    if (!status) {
        in->has_ruling = true;
        in->ruling = kg_v3(d[0], d[1], d[2]);
    }
    return status;
}

static kg_status read_trims(reader *r, const json_t *v, kg_model_patch *p) {
    if (!v)
        return KG_OK;
    enter(r, "trims", 0);
    kg_status status = json_is_array(v) ? KG_OK : fail_at(r, "\"trims\" is a list");
    size_t n = json_array_size(v);
    if (!status && !(p->trims = calloc(n + 1, sizeof *p->trims)))
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        enter(r, NULL, i);
        p->trim_count++;
        status = read_trim(r, json_array_get(v, i), &p->trims[i]);
        leave(r);
    }
    leave(r);
    return status;
}

static kg_status read_patch(reader *r, const json_t *v, kg_model_patch *p) {
    const json_t *id = json_object_get(v, "id");
    if (!json_is_object(v))
        return fail_at(r, "a patch is an object: { … }");
    if (!json_is_integer(id))
        return fail_at(r, "a patch needs an \"id\", a whole number");
    if (json_integer_value(id) < 1)
        return fail_at(r, "ids start at 1, so there is no patch %lld",
                       (long long)json_integer_value(id));
    p->id = r->patch = json_integer_value(id);
    r->in_patch = true;
    p->json = keep_json(v);
    p->name = strdup("");
    kg_status status = p->name ? read_string(r, v, "name", &p->name) : KG_ERR_MEMORY;
    if (!status)
        status = read_points(r, json_object_get(v, "points"), &p->input);
    if (!status)
        status = read_extent(r, json_object_get(v, "extent"), &p->input);
    if (!status)
        status = read_ruling(r, json_object_get(v, "ruling"), &p->input);
    if (!status)
        status = read_bool(r, v, "flip", &p->input.flip);
    if (!status)
        status = read_bool(r, v, "hidden", &p->hidden);
    if (!status)
        status = read_bool(r, v, "construction", &p->construction);
    if (!status)
        status = read_trims(r, json_object_get(v, "trims"), p);
    r->in_patch = false;
    return status;
}

/* Does every cutter of a patch exist? */
static kg_status check_cutters(reader *r, const kg_model_patch *p, const kg_lookup *ids) {
    kg_status status = KG_OK;
    for (size_t n = 0; n < p->trim_count && !status; n++)
        for (size_t b = 0; b < p->trims[n].by_count && !status; b++) {
            if (kg_lookup_find(ids, p->trims[n].by[b]))
                continue;
            enter(r, "trims", 0), enter(r, NULL, n), enter(r, "by", 0), enter(r, NULL, b);
            status =
                fail_at(r, "there is no patch %lld to cut it with", (long long)p->trims[n].by[b]);
            leave(r), leave(r), leave(r), leave(r);
        }
    return status;
}

/* Ids: all different, and every cutter exists. */
static kg_status check_ids(reader *r, const kg_model *m) {
    kg_lookup ids;
    kg_status status = kg_lookup_create(m->patch_count, &ids);
    if (status)
        return status;
    for (size_t i = 0; i < m->patch_count; i++)
        kg_lookup_add(&ids, m->patches[i].id, i);
    kg_lookup_sort(&ids);
    for (size_t i = 0; i < m->patch_count && !status; i++) {
        const kg_model_patch *p = &m->patches[i];
        enter(r, NULL, i);
        if (kg_lookup_find(&ids, p->id)->index != i)
            status = fail_at(r, "two patches have the id %lld", (long long)p->id);
        r->patch = p->id;
        r->in_patch = true;
        if (!status)
            status = check_cutters(r, p, &ids);
        r->in_patch = false;
        leave(r);
    }
    kg_lookup_clear(&ids);
    return status;
}

static kg_status read_patches(reader *r, const json_t *root, kg_model *m) {
    const json_t *v = json_object_get(root, "patches");
    if (!v)
        return KG_OK;
    enter(r, "patches", 0);
    kg_status status = json_is_array(v) ? KG_OK : fail_at(r, "\"patches\" is a list");
    size_t n = json_array_size(v);
    if (!status && !(m->patches = calloc(n + 1, sizeof *m->patches)))
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        enter(r, NULL, i);
        m->patch_count++;
        status = read_patch(r, json_array_get(v, i), &m->patches[i]);
        leave(r);
    }
    if (!status)
        status = check_ids(r, m);
    leave(r);
    return status;
}

/* ---- the rest --------------------------------------------------------------------------- */

static kg_status read_matrix(reader *r, const json_t *v, kg_reference *ref) {
    if (!v)
        return KG_OK;
    enter(r, "matrix", 0);
    kg_status status = KG_OK;
    ref->has_matrix = true;
    if (json_array_size(v) == 16) {
        status = read_numbers(r, v, 16, ref->matrix);
    } else if (json_array_size(v) == 4) {
        for (size_t i = 0; i < 4 && !status; i++) {
            enter(r, NULL, i);
            status = read_numbers(r, json_array_get(v, i), 4, ref->matrix + 4 * i);
            leave(r);
        }
    } else {
        status = fail_at(r, "a matrix has 4 rows of 4 numbers");
    }
    leave(r);
    return status;
}

static kg_status read_reference(reader *r, const json_t *root, kg_reference *ref) {
    const json_t *v = NULL;
    kg_status status = read_object(r, root, "reference", &v);
    if (status || !v)
        return status;
    char *up = NULL;
    enter(r, "reference", 0);
    ref->json = keep_json(v);
    status = read_string(r, v, "file", &ref->file);
    if (!status)
        status = read_double(r, v, "size_mm", &ref->size_mm);
    if (!status && json_object_get(v, "size_mm") && !(ref->size_mm > 0))
        status = fail_at(r, "\"size_mm\" is a length above 0");
    if (!status)
        status = read_bool(r, v, "visible", &ref->visible);
    if (!status)
        status = read_double(r, v, "opacity", &ref->opacity);
    if (!status && !(ref->opacity >= 0 && ref->opacity <= 1))
        status = fail_at(r, "\"opacity\" lies between 0 and 1");
    if (!status)
        status = read_matrix(r, json_object_get(v, "matrix"), ref);
    if (!status)
        status = read_string(r, v, "up", &up);
    if (!status && up && strcmp(up, "y") && strcmp(up, "z"))
        status = fail_at(r, "\"up\" is \"y\" or \"z\"");
    ref->up_y = up && strcmp(up, "y") == 0;
    free(up);
    leave(r);
    return status;
}

static kg_status read_net(reader *r, const json_t *root, kg_model_net *net) {
    const json_t *v = NULL;
    kg_status status = read_object(r, root, "net", &v);
    if (status || !v)
        return status;
    enter(r, "net", 0);
    net->json = keep_json(v);
    status = read_string(r, v, "paper", &net->paper);
    if (!status)
        status = read_double(r, v, "margin", &net->margin);
    if (!status)
        status = read_double(r, v, "scale", &net->scale);
    if (!status)
        status = read_double(r, v, "tab_width", &net->tab_width);
    if (!status && !(net->margin >= 0 && net->scale > 0 && net->tab_width > 0))
        status = fail_at(r, "\"scale\" and \"tab_width\" are above 0, \"margin\" is not negative");
    leave(r);
    return status;
}

/* Version and kind: is this a file for this reader at all? */
static kg_status check_header(reader *r, const json_t *root) {
    const json_t *version = json_object_get(root, "katagami");
    const char *kind = json_string_value(json_object_get(root, "kind"));
    if (!json_is_object(root) || !json_is_integer(version))
        return fail_at(r, "this is no katagami model: it must begin with {\"katagami\": 1, "
                          "\"kind\": \"patches\", …}");
    enter(r, "katagami", 0);
    if (json_integer_value(version) > KG_MODEL_VERSION)
        return fail_at(r,
                       "the model was written by a newer katagami (format %lld, this one reads "
                       "up to %d); update katagami",
                       (long long)json_integer_value(version), KG_MODEL_VERSION);
    if (json_integer_value(version) < 1)
        return fail_at(r, "there is no format %lld", (long long)json_integer_value(version));
    leave(r);
    enter(r, "kind", 0);
    if (!kind || strcmp(kind, "patches"))
        return fail_at(r, "a patch model has \"kind\": \"patches\"%s%s%s",
                       kind ? ", this one is \"" : "", kind ? kind : "", kind ? "\"" : "");
    leave(r);
    return KG_OK;
}

static kg_status read_root(reader *r, const json_t *root, kg_model *m) {
    kg_status status = check_header(r, root);
    if (status)
        return status;
    m->json = json_copy((json_t *)(uintptr_t)root);
    if (!m->json || json_object_set_new(m->json, "patches", json_array()))
        return KG_ERR_MEMORY; /* each patch keeps its own */
    status = read_string(r, root, "title", &m->title);
    if (!status)
        status = read_reference(r, root, &m->reference);
    if (!status)
        status = read_net(r, root, &m->net);
    if (!status)
        status = read_patches(r, root, m);
    return status;
}

kg_status kg_model_read_memory(const char *data, size_t size, const char *name,
                               kg_model **out_model, kg_error *error) {
    json_error_t where;
    if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0)
        data += 3, size -= 3; /* the mark that some editors put in front */
    json_t *root = json_loadb(data, size, JSON_REJECT_DUPLICATES, &where);
    if (!root)
        return kg_fail(
            error, KG_ERR_PARSE, "%s:%d: %s%s", name, where.line < 1 ? 1 : where.line, where.text,
            json_error_code(&where) == json_error_invalid_utf8 ? "; save the file as UTF-8" : "");
    char *text = malloc(size + 1); /* zero-terminated for the search of lines */
    kg_model *m = kg_model_create();
    kg_status status = KG_ERR_MEMORY;
    if (text && m) {
        memcpy(text, data, size);
        text[size] = '\0';
        reader r = {.name = name, .text = text, .error = error};
        status = read_root(&r, root, m);
    }
    free(text);
    json_decref(root);
    if (status) {
        kg_model_destroy(m);
        return status == KG_ERR_MEMORY ? kg_fail(error, status, "%s: out of memory", name) : status;
    }
    *out_model = m;
    return KG_OK;
}

kg_status kg_model_read(const char *path, kg_model **out_model, kg_error *error) {
    char *data;
    size_t size;
    kg_status status = kg_file_read(path, &data, &size, error);
    if (status)
        return status;
    status = kg_model_read_memory(data, size, strcmp(path, "-") ? path : "standard input",
                                  out_model, error);
    free(data);
    return status;
}
