/* Patch models to JSON: what was read, with what this version knows put in its place. */
#include "katagami/model.h"

#include "base/file.h"
#include "base/json.h"

#include <stdlib.h>
#include <string.h>

/* A copy of the kept object to write into, or a new one. Members are replaced, never changed. */
static json_t *start(const json_t *kept) {
    return kept ? json_copy((json_t *)(uintptr_t)kept) : json_object();
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

/* Sets a member that is there, takes out one that is not. */
static bool set_if(json_t *object, const char *key, bool is_there, json_t *value) {
    if (is_there)
        return set(object, key, value);
    json_decref(value);
    json_object_del(object, key);
    return true;
}

/* Whole numbers without a decimal point, as people write them. */
static json_t *number(double x) {
    if (x == floor(x) && fabs(x) < 1e15)
        return json_integer((json_int_t)x);
    return json_real(x);
}

/* `count` rows of `width` numbers. */
static json_t *rows(const double *x, size_t count, size_t width) {
    json_t *list = json_array();
    for (size_t i = 0; i < count && list; i++) {
        json_t *row = json_array();
        for (size_t k = 0; k < width; k++)
            if (json_array_append_new(row, number(x[i * width + k]))) {
                json_decref(row);
                row = NULL;
                break;
            }
        if (json_array_append_new(list, row)) {
            json_decref(list);
            list = NULL;
        }
    }
    return list;
}

static json_t *numbers(const double *x, size_t count) {
    json_t *list = rows(x, 1, count), *row = json_incref(json_array_get(list, 0));
    json_decref(list);
    return row;
}

static json_t *write_op(const kg_trim_op *op) {
    json_t *o = start(op->json), *by = json_array();
    bool ok = o && by;
    if (op->kind == KG_TRIM_CONTOUR) {
        json_object_del(o, "by"); /* of a trim that became a contour */
        ok = ok && set(o, "contour", rows(&op->contour->x, op->contour_count, 2)) &&
             set(o, "keep", json_string(op->outside ? "outside" : "inside"));
    } else {
        json_object_del(o, "contour");
        for (size_t i = 0; i < op->by_count && ok; i++)
            ok = json_array_append_new(by, json_integer(op->by[i])) == 0;
        ok = ok && set(o, "by", json_incref(by)) &&
             set_unless(o, "inside", op->kind != KG_TRIM_INSIDE,
                        json_boolean(op->kind == KG_TRIM_INSIDE)) &&
             set_unless(o, "keep", op->keep_count == 0,
                        rows(op->keep ? &op->keep->x : NULL, op->keep_count, 3)) &&
             set_unless(o, "bounded", !op->bounded, json_boolean(op->bounded)) &&
             set_unless(o, "trim_cutters", !op->trim_cutters, json_boolean(op->trim_cutters));
    }
    ok = ok && set_unless(o, "off", !op->off, json_boolean(op->off));
    json_decref(by);
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

static json_t *write_patch(const kg_model_patch *p) {
    const kg_patch_input *in = &p->input;
    json_t *o = start(p->json), *trims = json_array();
    bool ok = o && trims && set(o, "id", json_integer(p->id)) &&
              set_unless(o, "name", p->name[0] == '\0', json_string(p->name)) &&
              set(o, "points", rows(&in->points[0].x, in->point_count, 3)) &&
              set(o, "extent", numbers(in->extent, 2)) &&
              set_unless(o, "flip", !in->flip, json_boolean(in->flip)) &&
              set_unless(o, "hidden", !p->hidden, json_boolean(p->hidden)) &&
              set_unless(o, "construction", !p->construction, json_boolean(p->construction)) &&
              set_if(o, "ruling", in->has_ruling, numbers(&in->ruling.x, 3));
    for (size_t i = 0; i < p->trim_count && ok; i++)
        ok = json_array_append_new(trims, write_op(&p->trims[i])) == 0;
    ok = ok && set_unless(o, "trims", p->trim_count == 0, json_incref(trims));
    json_decref(trims);
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

static json_t *write_reference(const kg_reference *ref) {
    json_t *o = start(ref->json);
    bool ok = o && set_if(o, "file", ref->file != NULL, json_string(ref->file)) &&
              set_if(o, "size_mm", ref->size_mm > 0, number(ref->size_mm)) &&
              set_if(o, "matrix", ref->has_matrix, rows(ref->matrix, 4, 4)) &&
              set_unless(o, "visible", ref->visible, json_boolean(ref->visible)) &&
              set_unless(o, "opacity", ref->opacity == 0.4, number(ref->opacity)) &&
              set_unless(o, "up", !ref->up_y, json_string(ref->up_y ? "y" : "z"));
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

static json_t *write_join(const kg_model_join *join) {
    static const char *const tabs[] = {"auto", "none", "this", "other"};
    static const char *const shapes[] = {"auto", "trapezoid", "teeth"};
    json_t *o = start(join->json);
    bool ok =
        o &&
        set(o, "patches",
            json_pack("[I,I]", (json_int_t)join->patches[0], (json_int_t)join->patches[1])) &&
        set_unless(o, "tab", join->tab == KG_JOIN_TAB_AUTO, json_string(tabs[join->tab])) &&
        set_unless(o, "shape", join->shape == KG_JOIN_AUTO, json_string(shapes[join->shape])) &&
        set_unless(o, "merge", !join->merge, json_boolean(join->merge)) &&
        set_if(o, "width", join->width > 0, number(join->width));
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

static json_t *write_net(const kg_model_net *net) {
    json_t *o = start(net->json), *joins = json_array();
    bool ok = o && joins &&
              set_unless(o, "paper", !net->paper, json_string(net->paper ? net->paper : "A4")) &&
              set_unless(o, "margin", net->margin == 8, number(net->margin)) &&
              set_unless(o, "scale", net->scale == 1, number(net->scale)) &&
              set_unless(o, "tab_width", net->tab_width == 5, number(net->tab_width));
    for (size_t i = 0; i < net->join_count && ok; i++)
        ok = json_array_append_new(joins, write_join(&net->joins[i])) == 0;
    ok = ok && set_unless(o, "joins", net->join_count == 0, json_incref(joins));
    json_decref(joins);
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

static json_t *write_root(const kg_model *m) {
    json_t *o = start(m->json), *patches = json_array(), *net = write_net(&m->net);
    bool ok = o && patches && net && set(o, "katagami", json_integer(KG_MODEL_VERSION)) &&
              set(o, "kind", json_string("patches")) &&
              set_unless(o, "title", m->title[0] == '\0', json_string(m->title));
    ok = ok &&
         set_if(o, "reference", m->reference.file || m->reference.json,
                write_reference(&m->reference)) &&
         set_unless(o, "net", json_object_size(net) == 0, json_incref(net));
    for (size_t i = 0; i < m->patch_count && ok; i++)
        ok = json_array_append_new(patches, write_patch(&m->patches[i])) == 0;
    ok = ok && set(o, "patches", json_incref(patches));
    json_decref(patches);
    json_decref(net);
    if (!ok) {
        json_decref(o);
        return NULL;
    }
    return o;
}

kg_status kg_model_write_memory(const kg_model *model, char **out_text, size_t *out_size,
                                kg_error *error) {
    json_t *root = write_root(model);
    char *text = root ? kg_json_text(root) : NULL;
    json_decref(root);
    if (!text)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory, or a name that is not UTF-8");
    *out_text = text;
    *out_size = strlen(text);
    return KG_OK;
}

kg_status kg_model_write(const kg_model *model, const char *path, kg_error *error) {
    char *text;
    size_t size;
    kg_status status = kg_model_write_memory(model, &text, &size, error);
    if (status)
        return status;
    status = kg_file_write(path, text, size, error);
    free(text);
    return status;
}
