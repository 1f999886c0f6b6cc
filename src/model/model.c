#include "katagami/model.h"

#include "model/clear.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

void kg_trim_op_clear(kg_trim_op *op) {
    free(op->by);
    free(op->keep);
    free(op->contour);
    json_decref(op->json);
    *op = (kg_trim_op){0};
}

void kg_model_patch_clear(kg_model_patch *p) {
    for (size_t i = 0; i < p->trim_count; i++)
        kg_trim_op_clear(&p->trims[i]);
    free(p->trims);
    free(p->name);
    json_decref(p->json);
}

kg_model *kg_model_create(void) {
    kg_model *m = calloc(1, sizeof *m);
    if (!m)
        return NULL;
    m->reference.visible = true;
    m->reference.opacity = 0.4;
    m->net = kg_net_settings_default();
    m->mirror = (kg_mirror_plane){1, 0};
    m->title = strdup("");
    if (!m->title) {
        free(m);
        return NULL;
    }
    return m;
}

void kg_model_destroy(kg_model *m) {
    if (!m)
        return;
    for (size_t i = 0; i < m->patch_count; i++)
        kg_model_patch_clear(&m->patches[i]);
    free(m->patches);
    free(m->title);
    free(m->reference.file);
    json_decref(m->reference.json);
    for (size_t i = 0; i < m->join_count; i++)
        json_decref(m->joins[i].json);
    free(m->joins);
    kg_net_settings_clear(&m->net);
    json_decref(m->json);
    free(m);
}

/* A copy of `count` items, NULL for none; false when memory runs out. */
static bool copy_array(const void *from, size_t count, size_t size, void **out) {
    *out = NULL;
    if (count == 0)
        return true;
    *out = malloc(count * size); /* the source exists, so the product does not overflow */
    if (!*out)
        return false;
    memcpy(*out, from, count * size);
    return true;
}

static bool copy_text(const char *from, char **out) {
    *out = from ? strdup(from) : NULL;
    return !from || *out;
}

bool kg_trim_op_copy(const kg_trim_op *from, kg_trim_op *to) {
    *to = *from;
    to->json = json_incref(from->json); /* never changed in place, so it can be shared */
    to->by = NULL, to->keep = NULL, to->contour = NULL;
    return copy_array(from->by, from->by_count, sizeof *from->by, (void **)&to->by) &&
           copy_array(from->keep, from->keep_count, sizeof *from->keep, (void **)&to->keep) &&
           copy_array(from->contour, from->contour_count, sizeof *from->contour,
                      (void **)&to->contour);
}

static bool copy_patch(const kg_model_patch *from, kg_model_patch *to) {
    *to = *from;
    to->json = json_incref(from->json);
    to->name = NULL;
    to->trim_count = 0;
    to->trims = calloc(from->trim_count + 1, sizeof *to->trims);
    if (!to->trims || !copy_text(from->name, &to->name))
        return false;
    for (size_t i = 0; i < from->trim_count; i++) {
        to->trim_count++;
        if (!kg_trim_op_copy(&from->trims[i], &to->trims[i]))
            return false;
    }
    return true;
}

kg_model *kg_model_copy(const kg_model *from) {
    kg_model *to = malloc(sizeof *to);
    if (!to)
        return NULL;
    *to = *from;
    to->json = json_incref(from->json);
    to->reference.json = json_incref(from->reference.json);
    to->title = to->reference.file = NULL;
    to->net = (kg_net_settings){0};
    to->joins = NULL;
    to->join_count = 0;
    to->patch_count = 0;
    to->patches = calloc(from->patch_count + 1, sizeof *to->patches);
    bool ok = to->patches && copy_text(from->title, &to->title) &&
              copy_text(from->reference.file, &to->reference.file) &&
              kg_net_settings_copy(&from->net, &to->net) &&
              copy_array(from->joins, from->join_count, sizeof *from->joins, (void **)&to->joins);
    for (size_t i = 0; i < from->join_count && ok; i++, to->join_count = i)
        json_incref(to->joins[i].json);
    for (size_t i = 0; i < from->patch_count && ok; i++) {
        to->patch_count++;
        ok = copy_patch(&from->patches[i], &to->patches[i]);
    }
    if (!ok) {
        kg_model_destroy(to);
        return NULL;
    }
    return to;
}

kg_model_patch *kg_model_find(const kg_model *model, int64_t id) {
    for (size_t i = 0; i < model->patch_count; i++)
        if (model->patches[i].id == id)
            return &model->patches[i];
    return NULL;
}

const kg_model_join *kg_model_find_join(const kg_model *model, int64_t a, int64_t b) {
    for (size_t i = 0; i < model->join_count; i++) {
        const int64_t *p = model->joins[i].patches;
        if (!model->joins[i].has_at && ((p[0] == a && p[1] == b) || (p[0] == b && p[1] == a)))
            return &model->joins[i];
    }
    return NULL;
}

const kg_model_join *kg_model_find_join_at(const kg_model *model, const int64_t patches[2],
                                           kg_vec2 at) {
    for (size_t i = 0; i < model->join_count; i++) {
        const kg_model_join *j = &model->joins[i];
        if (j->has_at && j->patches[0] == patches[0] && j->patches[1] == patches[1] &&
            j->at.x == at.x && j->at.y == at.y)
            return j;
    }
    return NULL;
}
