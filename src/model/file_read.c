/* Patch models from JSON. Messages carry the file, the line and the patch. */
#include "katagami/model.h"

#include "base/file.h"
#include "base/phrase.h"
#include "base/reader.h"
#include "model/lookup.h"
#include "model/mirror.h"
#include "net/settings.h"

#include <stdlib.h>
#include <string.h>

/* What messages name besides file and line. */
static void print_patch(const void *patch, char *out, size_t size) {
    const int64_t *id = patch;
    kg_phrase_print(out, size, "patch %lld: ", (long long)*id);
}

static void enter_patch(kg_reader *r, const kg_model_patch *p) {
    r->place = print_patch;
    r->owner = &p->id;
}

static void leave_patch(kg_reader *r) {
    r->place = NULL;
    r->owner = NULL;
}

/* ---- trims ------------------------------------------------------------------------------ */

static kg_status read_cutter(kg_reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_integer(v))
        return kg_read_fail(r, "a patch id (a whole number) is wanted here");
    if (json_integer_value(v) == *(const int64_t *)r->owner)
        return kg_read_fail(r, "a patch cannot cut itself");
    op->by[op->by_count++] = json_integer_value(v);
    return KG_OK;
}

static kg_status check_repeats(kg_reader *r, const kg_trim_op *op) {
    kg_lookup ids;
    kg_status status = kg_lookup_create(op->by_count, &ids);
    if (status)
        return status;
    for (size_t i = 0; i < op->by_count; i++)
        kg_lookup_add(&ids, op->by[i], i);
    kg_lookup_sort(&ids);
    for (size_t i = 1; i < ids.count && !status; i++)
        if (ids.entries[i].id == ids.entries[i - 1].id) {
            kg_read_enter(r, NULL, ids.entries[i].index);
            status = kg_read_fail(r, "patch %lld is named twice", (long long)ids.entries[i].id);
            kg_read_leave(r);
        }
    kg_lookup_clear(&ids);
    return status;
}

static kg_status read_by(kg_reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_array(v) || json_array_size(v) == 0)
        return kg_read_fail(r, "\"by\" is a list of patch ids");
    op->by = calloc(json_array_size(v), sizeof *op->by);
    if (!op->by)
        return KG_ERR_MEMORY;
    kg_status status = KG_OK;
    for (size_t i = 0; i < json_array_size(v) && !status; i++) {
        kg_read_enter(r, NULL, i);
        status = read_cutter(r, json_array_get(v, i), op);
        kg_read_leave(r);
    }
    return status ? status : check_repeats(r, op);
}

static kg_status read_contour(kg_reader *r, const json_t *v, kg_trim_op *op) {
    op->kind = KG_TRIM_CONTOUR;
    kg_read_enter(r, "contour", 0);
    kg_status status = kg_read_rows(r, json_object_get(v, "contour"), 2, (void **)&op->contour,
                                    &op->contour_count);
    kg_read_leave(r);
    const json_t *keep = json_object_get(v, "keep");
    if (status || !keep)
        return status;
    const char *word = json_string_value(keep);
    kg_read_enter(r, "keep", 0);
    if (!word || (strcmp(word, "inside") && strcmp(word, "outside")))
        status = kg_read_fail(r, "a contour keeps \"inside\" or \"outside\"");
    kg_read_leave(r);
    op->outside = !status && !strcmp(word, "outside");
    return status;
}

static kg_status read_cut(kg_reader *r, const json_t *v, kg_trim_op *op) {
    const json_t *by = json_object_get(v, "by"), *keep = json_object_get(v, "keep");
    bool inside = false;
    if (!by)
        return kg_read_fail(r, "a trim has \"by\": [ids] or a \"contour\"");
    kg_read_enter(r, "by", 0);
    kg_status status = read_by(r, by, op);
    kg_read_leave(r);
    if (!status)
        status = kg_read_bool(r, v, "inside", &inside);
    if (!status)
        status = kg_read_bool(r, v, "bounded", &op->bounded);
    if (!status)
        status = kg_read_bool(r, v, "trim_cutters", &op->trim_cutters);
    if (!status && keep) {
        kg_read_enter(r, "keep", 0);
        status = kg_read_rows(r, keep, 3, (void **)&op->keep, &op->keep_count);
        kg_read_leave(r);
    }
    if (status)
        return status;
    op->kind = inside ? KG_TRIM_INSIDE : KG_TRIM_BY;
    if (!inside && op->by_count > 1)
        return kg_read_fail(r, "several cutters need \"inside\": true, or one trim for each");
    return KG_OK;
}

static kg_status read_trim(kg_reader *r, const json_t *v, kg_trim_op *op) {
    if (!json_is_object(v))
        return kg_read_fail(r, "a trim is an object: { … }");
    if (json_object_get(v, "by") && json_object_get(v, "contour"))
        return kg_read_fail(r, "a trim has \"by\" or a \"contour\", not both");
    op->json = kg_read_keep(v);
    kg_status status = kg_read_bool(r, v, "off", &op->off);
    if (!status)
        status = json_object_get(v, "contour") ? read_contour(r, v, op) : read_cut(r, v, op);
    return status;
}

/* ---- patches ---------------------------------------------------------------------------- */

static kg_status read_points(kg_reader *r, const json_t *v, kg_patch_input *in) {
    kg_vec3 *points = NULL;
    size_t count = 0;
    kg_read_enter(r, "points", 0);
    kg_status status = v ? kg_read_rows(r, v, 3, (void **)&points, &count)
                         : kg_read_fail(r, "a patch needs \"points\"");
    if (!status && count != 4 && count != 6)
        status = kg_read_fail(r, "a geodesic has 4 or 6 control points, not %zu", count);
    kg_read_leave(r);
    if (!status) {
        memcpy(in->points, points, count * sizeof *points);
        in->point_count = count;
    }
    free(points);
    return status;
}

static kg_status read_extent(kg_reader *r, const json_t *v, kg_patch_input *in) {
    kg_read_enter(r, "extent", 0);
    kg_status status = v ? kg_read_numbers(r, v, 2, in->extent)
                         : kg_read_fail(r, "a patch needs \"extent\": [lo, hi]");
    if (!status && !(in->extent[0] < in->extent[1]))
        status = kg_read_fail(r, "the extent [%g, %g] must grow", in->extent[0], in->extent[1]);
    kg_read_leave(r);
    return status;
}

/* Numbers that may be missing: whether they are there, and can be read, is in `*out_has`. */
static kg_status read_optional(kg_reader *r, const json_t *v, const char *field, size_t count,
                               double *out, bool *out_has) {
    *out_has = false;
    if (!v)
        return KG_OK;
    kg_read_enter(r, field, 0);
    kg_status status = kg_read_numbers(r, v, count, out);
    kg_read_leave(r);
    *out_has = !status;
    return status;
}

static kg_status read_ruling(kg_reader *r, const json_t *v, kg_patch_input *in) {
    double d[3] = {0};
    kg_status status = read_optional(r, v, "ruling", 3, d, &in->has_ruling);
    if (in->has_ruling)
        in->ruling = kg_v3(d[0], d[1], d[2]);
    return status;
}

static kg_status read_trims(kg_reader *r, const json_t *v, kg_model_patch *p) {
    if (!v)
        return KG_OK;
    kg_read_enter(r, "trims", 0);
    kg_status status = json_is_array(v) ? KG_OK : kg_read_fail(r, "\"trims\" is a list");
    size_t n = json_array_size(v);
    if (!status && !(p->trims = calloc(n + 1, sizeof *p->trims)))
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        kg_read_enter(r, NULL, i);
        p->trim_count++;
        status = read_trim(r, json_array_get(v, i), &p->trims[i]);
        kg_read_leave(r);
    }
    kg_read_leave(r);
    return status;
}

static kg_status read_patch(kg_reader *r, const json_t *v, kg_model_patch *p) {
    const json_t *id = json_object_get(v, "id");
    if (!json_is_object(v))
        return kg_read_fail(r, "a patch is an object: { … }");
    if (!json_is_integer(id))
        return kg_read_fail(r, "a patch needs an \"id\", a whole number");
    if (json_integer_value(id) < 1)
        return kg_read_fail(r, "ids start at 1, so there is no patch %lld",
                            (long long)json_integer_value(id));
    p->id = json_integer_value(id);
    enter_patch(r, p);
    p->json = kg_read_keep(v);
    p->name = strdup("");
    kg_status status = p->name ? kg_read_string(r, v, "name", &p->name) : KG_ERR_MEMORY;
    if (!status)
        status = read_points(r, json_object_get(v, "points"), &p->input);
    if (!status)
        status = read_extent(r, json_object_get(v, "extent"), &p->input);
    if (!status)
        status = read_ruling(r, json_object_get(v, "ruling"), &p->input);
    if (!status)
        status = kg_read_bool(r, v, "flip", &p->input.flip);
    if (!status)
        status = kg_read_bool(r, v, "hidden", &p->hidden);
    if (!status)
        status = kg_read_bool(r, v, "construction", &p->construction);
    if (!status)
        status = read_trims(r, json_object_get(v, "trims"), p);
    leave_patch(r);
    return status;
}

/* Does every cutter of a patch exist? */
static kg_status check_cutters(kg_reader *r, const kg_model_patch *p, const kg_lookup *ids) {
    kg_status status = KG_OK;
    for (size_t n = 0; n < p->trim_count && !status; n++)
        for (size_t b = 0; b < p->trims[n].by_count && !status; b++) {
            if (kg_lookup_find(ids, p->trims[n].by[b]))
                continue;
            kg_read_enter(r, "trims", 0), kg_read_enter(r, NULL, n), kg_read_enter(r, "by", 0),
                kg_read_enter(r, NULL, b);
            status = kg_read_fail(r, "there is no patch %lld to cut it with",
                                  (long long)p->trims[n].by[b]);
            kg_read_leave(r), kg_read_leave(r), kg_read_leave(r), kg_read_leave(r);
        }
    return status;
}

/* Ids: all different, and every cutter exists. */
static kg_status check_ids(kg_reader *r, const kg_model *m) {
    kg_lookup ids;
    kg_status status = kg_lookup_create(m->patch_count, &ids);
    if (status)
        return status;
    for (size_t i = 0; i < m->patch_count; i++)
        kg_lookup_add(&ids, m->patches[i].id, i);
    kg_lookup_sort(&ids);
    for (size_t i = 0; i < m->patch_count && !status; i++) {
        const kg_model_patch *p = &m->patches[i];
        kg_read_enter(r, NULL, i);
        if (kg_lookup_find(&ids, p->id)->index != i)
            status = kg_read_fail(r, "two patches have the id %lld", (long long)p->id);
        enter_patch(r, p);
        if (!status)
            status = check_cutters(r, p, &ids);
        leave_patch(r);
        kg_read_leave(r);
    }
    kg_lookup_clear(&ids);
    return status;
}

static kg_status read_patches(kg_reader *r, const json_t *root, kg_model *m) {
    const json_t *v = json_object_get(root, "patches");
    if (!v)
        return KG_OK;
    kg_read_enter(r, "patches", 0);
    kg_status status = json_is_array(v) ? KG_OK : kg_read_fail(r, "\"patches\" is a list");
    size_t n = json_array_size(v);
    if (!status && !(m->patches = calloc(n + 1, sizeof *m->patches)))
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        kg_read_enter(r, NULL, i);
        m->patch_count++;
        status = read_patch(r, json_array_get(v, i), &m->patches[i]);
        kg_read_leave(r);
    }
    if (!status)
        status = check_ids(r, m);
    kg_read_leave(r);
    return status;
}

/* ---- the rest --------------------------------------------------------------------------- */

static kg_status read_matrix(kg_reader *r, const json_t *v, kg_reference *ref) {
    if (!v)
        return KG_OK;
    kg_read_enter(r, "matrix", 0);
    kg_status status = KG_OK;
    ref->has_matrix = true;
    if (json_array_size(v) == 16) {
        status = kg_read_numbers(r, v, 16, ref->matrix);
    } else if (json_array_size(v) == 4) {
        for (size_t i = 0; i < 4 && !status; i++) {
            kg_read_enter(r, NULL, i);
            status = kg_read_numbers(r, json_array_get(v, i), 4, ref->matrix + 4 * i);
            kg_read_leave(r);
        }
    } else {
        status = kg_read_fail(r, "a matrix has 4 rows of 4 numbers");
    }
    kg_read_leave(r);
    return status;
}

static kg_status read_reference(kg_reader *r, const json_t *root, kg_reference *ref) {
    const json_t *v = NULL;
    kg_status status = kg_read_object(r, root, "reference", &v);
    if (status || !v)
        return status;
    static const char *const axes[] = {"z", "y"};
    size_t up = 0;
    kg_read_enter(r, "reference", 0);
    ref->json = kg_read_keep(v);
    status = kg_read_string(r, v, "file", &ref->file);
    if (!status)
        status = kg_read_double(r, v, "size_mm", &ref->size_mm);
    if (!status && json_object_get(v, "size_mm") && !(ref->size_mm > 0))
        status = kg_read_fail(r, "\"size_mm\" is a length above 0");
    if (!status)
        status = kg_read_bool(r, v, "visible", &ref->visible);
    if (!status)
        status = kg_read_double(r, v, "opacity", &ref->opacity);
    if (!status && !(ref->opacity >= 0 && ref->opacity <= 1))
        status = kg_read_fail(r, "\"opacity\" lies between 0 and 1");
    if (!status)
        status = read_matrix(r, json_object_get(v, "matrix"), ref);
    if (!status)
        status = kg_read_word(r, v, "up", axes, 2, &up);
    ref->up_y = up == 1;
    kg_read_leave(r);
    return status;
}

static kg_status read_join_place(kg_reader *r, const json_t *v, kg_model_join *join) {
    double at[2] = {0};
    kg_status status = read_optional(r, v, "at", 2, at, &join->has_at);
    if (join->has_at)
        join->at = kg_v2(at[0], at[1]);
    return status;
}

static kg_status read_join(kg_reader *r, const json_t *v, kg_model_join *join) {
    const json_t *pair = json_object_get(v, "patches");
    size_t tab = 0, shape = 0;
    if (!json_is_integer(json_array_get(pair, 0)) || !json_is_integer(json_array_get(pair, 1)) ||
        json_array_size(pair) != 2)
        return kg_read_fail(r, "a join is an object with \"patches\": [id, id]");
    join->json = kg_read_keep(v);
    for (size_t i = 0; i < 2; i++)
        join->patches[i] = json_integer_value(json_array_get(pair, i));
    kg_status status = kg_read_word(r, v, "tab", kg_net_tab_side_names, 4, &tab);
    if (!status)
        status = kg_read_word(r, v, "shape", kg_net_tab_shape_names, 3, &shape);
    if (!status)
        status = kg_read_bool(r, v, "merge", &join->merge);
    if (!status)
        status = kg_read_double(r, v, "width", &join->width);
    if (!status && json_object_get(v, "width") && !(join->width > 0))
        status = kg_read_fail(r, "\"width\" is a length above 0");
    if (!status)
        status = read_join_place(r, json_object_get(v, "at"), join);
    join->tab = (kg_net_tab_side)tab;
    join->shape = (kg_net_tab_shape)shape;
    return status;
}

/* Joins of patches that are gone are kept: they do no harm, and may come back. */
static kg_status read_joins(kg_reader *r, kg_model *m) {
    const json_t *v = json_object_get(m->net.json, "joins");
    if (!v)
        return KG_OK;
    kg_read_enter(r, "net", 0);
    kg_read_enter(r, "joins", 0);
    kg_status status = json_is_array(v) ? KG_OK : kg_read_fail(r, "\"joins\" is a list");
    size_t n = json_array_size(v);
    if (!status && !(m->joins = calloc(n + 1, sizeof *m->joins)))
        status = KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++) {
        kg_read_enter(r, NULL, i);
        m->join_count++;
        status = read_join(r, json_array_get(v, i), &m->joins[i]);
        kg_read_leave(r);
    }
    kg_read_leave(r);
    kg_read_leave(r);
    return status;
}

static kg_status read_root(kg_reader *r, kg_model *m) {
    kg_status status = kg_read_header(r, "patches", "a patch model");
    if (status)
        return status;
    m->json = json_copy(r->root);
    if (!m->json || json_object_set_new(m->json, "patches", json_array()))
        return KG_ERR_MEMORY; /* each patch keeps its own */
    m->mirror = kg_mirror_plane_read(r->root);
    status = kg_read_string(r, r->root, "title", &m->title);
    if (!status)
        status = read_reference(r, r->root, &m->reference);
    if (!status)
        status = kg_net_settings_parse(r, r->root, &m->net);
    if (!status)
        status = read_joins(r, m);
    if (!status)
        status = read_patches(r, r->root, m);
    return status;
}

kg_status kg_model_read_memory(const char *data, size_t size, const char *name,
                               kg_model **out_model, kg_error *error) {
    kg_reader r;
    kg_status status = kg_read_begin(&r, data, size, name, error);
    if (status)
        return status;
    kg_model *m = kg_model_create();
    status = kg_read_end(&r, m ? read_root(&r, m) : KG_ERR_MEMORY);
    if (status)
        kg_model_destroy(m);
    else
        *out_model = m;
    return status;
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
