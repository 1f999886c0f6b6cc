/* Patch models to JSON: what was read, with what this version knows put in its place. */
#include "katagami/model.h"

#include "base/writer.h"
#include "model/mirror.h"
#include "net/settings.h"

#include <stdlib.h>
#include <string.h>

/* `count` rows of `width` numbers. */
static json_t *rows(const double *x, size_t count, size_t width) {
    json_t *list = json_array();
    for (size_t i = 0; i < count && list; i++) {
        json_t *row = json_array();
        for (size_t k = 0; k < width; k++)
            if (json_array_append_new(row, kg_write_number(x[i * width + k]))) {
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
    json_t *o = kg_write_start(op->json), *by = json_array();
    bool ok = o && by;
    if (op->kind == KG_TRIM_CONTOUR) {
        json_object_del(o, "by"); /* of a trim that became a contour */
        ok = ok && kg_write(o, "contour", rows(&op->contour->x, op->contour_count, 2)) &&
             kg_write(o, "keep", json_string(op->outside ? "outside" : "inside"));
    } else {
        json_object_del(o, "contour");
        for (size_t i = 0; i < op->by_count && ok; i++)
            ok = json_array_append_new(by, json_integer(op->by[i])) == 0;
        ok = ok && kg_write(o, "by", json_incref(by)) &&
             kg_write_unless(o, "inside", op->kind != KG_TRIM_INSIDE,
                             json_boolean(op->kind == KG_TRIM_INSIDE)) &&
             kg_write_unless(o, "keep", op->keep_count == 0,
                             rows(op->keep ? &op->keep->x : NULL, op->keep_count, 3)) &&
             kg_write_unless(o, "bounded", !op->bounded, json_boolean(op->bounded)) &&
             kg_write_unless(o, "trim_cutters", !op->trim_cutters, json_boolean(op->trim_cutters));
    }
    ok = ok && kg_write_unless(o, "off", !op->off, json_boolean(op->off));
    json_decref(by);
    return kg_write_end(o, ok);
}

static json_t *write_patch(const kg_model_patch *p) {
    const kg_patch_input *in = &p->input;
    json_t *o = kg_write_start(p->json), *trims = json_array();
    bool ok = o && trims && kg_write(o, "id", json_integer(p->id)) &&
              kg_write_unless(o, "name", p->name[0] == '\0', json_string(p->name)) &&
              kg_write(o, "points", rows(&in->points[0].x, in->point_count, 3)) &&
              kg_write(o, "extent", numbers(in->extent, 2)) &&
              kg_write_unless(o, "flip", !in->flip, json_boolean(in->flip)) &&
              kg_write_unless(o, "hidden", !p->hidden, json_boolean(p->hidden)) &&
              kg_write_unless(o, "construction", !p->construction, json_boolean(p->construction)) &&
              kg_write_if(o, "ruling", in->has_ruling, numbers(&in->ruling.x, 3));
    for (size_t i = 0; i < p->trim_count && ok; i++)
        ok = json_array_append_new(trims, write_op(&p->trims[i])) == 0;
    ok = ok && kg_write_unless(o, "trims", p->trim_count == 0, json_incref(trims));
    json_decref(trims);
    return kg_write_end(o, ok);
}

static json_t *write_reference(const kg_reference *ref) {
    json_t *o = kg_write_start(ref->json);
    bool ok = o && kg_write_if(o, "file", ref->file != NULL, json_string(ref->file)) &&
              kg_write_if(o, "size_mm", ref->size_mm > 0, kg_write_number(ref->size_mm)) &&
              kg_write_if(o, "matrix", ref->has_matrix, rows(ref->matrix, 4, 4)) &&
              kg_write_unless(o, "visible", ref->visible, json_boolean(ref->visible)) &&
              kg_write_unless(o, "opacity", ref->opacity == 0.4, kg_write_number(ref->opacity)) &&
              kg_write_unless(o, "up", !ref->up_y, json_string(ref->up_y ? "y" : "z"));
    return kg_write_end(o, ok);
}

static json_t *write_join(const kg_model_join *join) {
    json_t *o = kg_write_start(join->json);
    bool ok =
        o &&
        kg_write(o, "patches",
                 json_pack("[I,I]", (json_int_t)join->patches[0], (json_int_t)join->patches[1])) &&
        kg_write_if(o, "at", join->has_at, numbers(&join->at.x, 2)) &&
        kg_write_unless(o, "tab", join->tab == KG_TAB_AUTO,
                        json_string(kg_net_tab_side_names[join->tab])) &&
        kg_write_unless(o, "shape", join->shape == KG_TAB_SHAPE_AUTO,
                        json_string(kg_net_tab_shape_names[join->shape])) &&
        kg_write_unless(o, "merge", !join->merge, json_boolean(join->merge)) &&
        kg_write_if(o, "width", join->width > 0, kg_write_number(join->width));
    return kg_write_end(o, ok);
}

static json_t *write_net(const kg_model *m) {
    json_t *o = kg_net_settings_json(&m->net), *joins = json_array();
    bool ok = o && joins;
    for (size_t i = 0; i < m->join_count && ok; i++)
        ok = json_array_append_new(joins, write_join(&m->joins[i])) == 0;
    ok = ok && kg_write_unless(o, "joins", m->join_count == 0, json_incref(joins));
    json_decref(joins);
    return kg_write_end(o, ok);
}

static json_t *write_root(const kg_model *m) {
    json_t *o = kg_write_start(m->json), *patches = json_array(), *net = write_net(m);
    bool ok = o && patches && net && kg_write_header(o, "patches", m->title) &&
              kg_mirror_plane_write(m->mirror, o);
    ok = ok &&
         kg_write_if(o, "reference", m->reference.file || m->reference.json,
                     write_reference(&m->reference)) &&
         kg_write_unless(o, "net", json_object_size(net) == 0, json_incref(net));
    for (size_t i = 0; i < m->patch_count && ok; i++)
        ok = json_array_append_new(patches, write_patch(&m->patches[i])) == 0;
    ok = ok && kg_write(o, "patches", json_incref(patches));
    json_decref(patches);
    json_decref(net);
    return kg_write_end(o, ok);
}

kg_status kg_model_write_memory(const kg_model *model, char **out_text, size_t *out_size,
                                kg_error *error) {
    return kg_write_text(write_root(model), out_text, out_size, error);
}

kg_status kg_model_write(const kg_model *model, const char *path, kg_error *error) {
    return kg_write_file(write_root(model), path, error);
}
