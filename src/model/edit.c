#include "model/edit.h"

#include "model/clear.h"
#include "model/mirror.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static kg_status no_memory(kg_error *error) {
    return kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

static kg_status find(const kg_model *m, int64_t id, size_t *out_index, kg_error *error) {
    for (size_t i = 0; i < m->patch_count; i++)
        if (m->patches[i].id == id) {
            *out_index = i;
            return KG_OK;
        }
    return kg_fail(error, KG_ERR_INPUT, "there is no patch %lld", (long long)id);
}

/* ---- patches ---------------------------------------------------------------------------- */

/* Moves the item at `from` to `to`. */
static void move_item(void *items, size_t size, size_t from, size_t to, void *scratch) {
    char *at = items;
    memcpy(scratch, at + from * size, size);
    if (from < to)
        memmove(at + from * size, at + (from + 1) * size, (to - from) * size);
    else
        memmove(at + (to + 1) * size, at + to * size, (from - to) * size);
    memcpy(at + to * size, scratch, size);
}

/* One more than the largest id; where that is the last there is, the first that is free. */
static int64_t free_id(const kg_model *m) {
    int64_t largest = 0, id = 1;
    for (size_t i = 0; i < m->patch_count; i++)
        largest = m->patches[i].id > largest ? m->patches[i].id : largest;
    if (largest < INT64_MAX)
        return largest + 1;
    while (kg_model_find(m, id))
        id++;
    return id;
}

/* Makes room for one more patch. */
static bool grow(kg_model *m) {
    kg_model_patch *more = realloc(m->patches, (m->patch_count + 1) * sizeof *more);
    if (more)
        m->patches = more;
    return more != NULL;
}

kg_status kg_model_add_patch(kg_model *m, const kg_patch_input *input, const char *name,
                             int64_t *out_id, kg_error *error) {
    kg_patch patch;
    kg_status status = kg_patch_init(input, &patch, error);
    if (status)
        return status;
    char *copy = strdup(name ? name : "");
    if (!copy || !grow(m)) {
        free(copy);
        return no_memory(error);
    }
    *out_id = free_id(m);
    m->patches[m->patch_count++] = (kg_model_patch){.id = *out_id, .name = copy, .input = *input};
    return KG_OK;
}

/* Takes `id` out of a trim; true when nothing is left of it. */
static bool forget_cutter(kg_trim_op *op, int64_t id) {
    size_t kept = 0;
    for (size_t i = 0; i < op->by_count; i++)
        if (op->by[i] != id)
            op->by[kept++] = op->by[i];
    bool changed = kept < op->by_count;
    op->by_count = kept;
    return changed && kept == 0;
}

kg_status kg_model_remove_patch(kg_model *m, int64_t id, kg_error *error) {
    size_t index = 0;
    kg_status status = find(m, id, &index, error);
    if (status)
        return status;
    kg_model_patch_clear(&m->patches[index]);
    m->patch_count--;
    memmove(&m->patches[index], &m->patches[index + 1],
            (m->patch_count - index) * sizeof *m->patches);
    for (size_t i = 0; i < m->patch_count; i++) {
        kg_model_patch *p = &m->patches[i];
        size_t kept = 0;
        for (size_t n = 0; n < p->trim_count; n++)
            if (forget_cutter(&p->trims[n], id))
                kg_trim_op_clear(&p->trims[n]);
            else
                p->trims[kept++] = p->trims[n];
        p->trim_count = kept;
    }
    return KG_OK;
}

kg_status kg_model_duplicate_patch(kg_model *m, int64_t id, int64_t *out_id, kg_error *error) {
    size_t index = 0;
    kg_status status = find(m, id, &index, error);
    if (status)
        return status;
    /* copying a model of this one patch copies all that a patch has */
    kg_model one = {.title = m->title, .patch_count = 1, .patches = &m->patches[index]};
    kg_model *copy = kg_model_copy(&one);
    if (!copy || !grow(m)) {
        kg_model_destroy(copy);
        return no_memory(error);
    }
    *out_id = free_id(m);
    m->patches[m->patch_count] = copy->patches[0];
    m->patches[m->patch_count].id = *out_id;
    m->patch_count++;
    copy->patch_count = 0;
    kg_model_destroy(copy);
    kg_model_patch scratch;
    move_item(m->patches, sizeof *m->patches, m->patch_count - 1, index + 1, &scratch);
    return KG_OK;
}

/* ---- moving in space -------------------------------------------------------------------- */

static kg_vec3 turned(const double r[9], kg_vec3 p) {
    return kg_v3(r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
                 r[6] * p.x + r[7] * p.y + r[8] * p.z);
}

kg_vec3 kg_similarity_apply(const kg_similarity *map, kg_vec3 point) {
    return kg_add(kg_scale(turned(map->rotation, point), map->scale), map->offset);
}

kg_similarity kg_similarity_mirror(kg_vec3 point, kg_vec3 n) {
    return (kg_similarity){{1 - 2 * n.x * n.x, -2 * n.x * n.y, -2 * n.x * n.z, -2 * n.x * n.y,
                            1 - 2 * n.y * n.y, -2 * n.y * n.z, -2 * n.x * n.z, -2 * n.y * n.z,
                            1 - 2 * n.z * n.z},
                           1,
                           kg_scale(n, 2 * kg_dot(point, n))};
}

/* Rodrigues' formula */
kg_similarity kg_similarity_turn(kg_vec3 center, kg_vec3 a, double angle) {
    double c = cos(angle), s = sin(angle), k = 1 - c;
    kg_similarity m = {{c + k * a.x * a.x, k * a.x * a.y - s * a.z, k * a.x * a.z + s * a.y,
                        k * a.x * a.y + s * a.z, c + k * a.y * a.y, k * a.y * a.z - s * a.x,
                        k * a.x * a.z - s * a.y, k * a.y * a.z + s * a.x, c + k * a.z * a.z},
                       1,
                       {0, 0, 0}};
    m.offset = kg_sub(center, turned(m.rotation, center));
    return m;
}

static bool in_range(kg_vec3 p) {
    return fabs(p.x) <= KG_MAX_COORDINATE && fabs(p.y) <= KG_MAX_COORDINATE &&
           fabs(p.z) <= KG_MAX_COORDINATE;
}

/* A straight geodesic's rulings follow a wish; a mirrored one has to say which side they take. */
static void transform_ruling(const kg_patch_input *from, const kg_similarity *map, bool mirrors,
                             kg_patch_input *to) {
    kg_patch patch;
    bool wanted = from->has_ruling;
    kg_vec3 d = from->ruling;
    if (!wanted && !kg_patch_init(from, &patch, NULL) && patch.shape == KG_CURVE_STRAIGHT) {
        wanted = true;
        d = kg_patch_ruling(&patch, 0).d;
    }
    if (!wanted)
        return;
    to->has_ruling = true;
    to->ruling = kg_scale(turned(map->rotation, d), mirrors ? -1 : 1);
}

kg_status kg_model_transform_patch(kg_model *m, int64_t id, const kg_similarity *map,
                                   kg_error *error) {
    size_t index = 0;
    kg_status status = find(m, id, &index, error);
    if (status)
        return status;
    if (!(map->scale > 0) || !isfinite(map->scale))
        return kg_fail(error, KG_ERR_INPUT, "the scale is %g; it must be above 0", map->scale);
    const double *r = map->rotation;
    bool mirrors =
        kg_det(kg_v3(r[0], r[1], r[2]), kg_v3(r[3], r[4], r[5]), kg_v3(r[6], r[7], r[8])) < 0;
    double side = mirrors ? -map->scale : map->scale;
    kg_model_patch *p = &m->patches[index];
    kg_patch_input moved = p->input;
    for (size_t i = 0; i < moved.point_count; i++) {
        moved.points[i] = kg_similarity_apply(map, moved.points[i]);
        if (!in_range(moved.points[i]))
            return kg_fail(error, KG_ERR_INPUT,
                           "patch %lld would leave the space of 1000 m that models lie in",
                           (long long)id);
    }
    double a = side * moved.extent[0], b = side * moved.extent[1];
    moved.extent[0] = fmin(a, b);
    moved.extent[1] = fmax(a, b);
    transform_ruling(&p->input, map, mirrors, &moved);
    p->input = moved;
    for (size_t n = 0; n < p->trim_count; n++) {
        kg_trim_op *op = &p->trims[n];
        for (size_t i = 0; i < op->keep_count; i++)
            op->keep[i] = kg_similarity_apply(map, op->keep[i]);
        for (size_t i = 0; i < op->contour_count; i++)
            op->contour[i].x *= side;
    }
    for (size_t i = 0; i < m->join_count; i++)
        if (m->joins[i].patches[0] == id)
            m->joins[i].at.x *= side;
    return KG_OK;
}

/* ---- trims ------------------------------------------------------------------------------ */

kg_status kg_model_add_trim(kg_model *m, int64_t patch, kg_trim_op *op, kg_error *error) {
    size_t index = 0;
    kg_status status = find(m, patch, &index, error);
    if (!status) {
        kg_model_patch *p = &m->patches[index];
        kg_trim_op *more = realloc(p->trims, (p->trim_count + 1) * sizeof *more);
        if (more) {
            p->trims = more;
            more[p->trim_count++] = *op;
            *op = (kg_trim_op){0};
            return KG_OK;
        }
        status = no_memory(error);
    }
    kg_trim_op_clear(op);
    return status;
}

static kg_status find_trim(kg_model *m, int64_t patch, size_t trim, kg_model_patch **out,
                           kg_error *error) {
    size_t index = 0;
    kg_status status = find(m, patch, &index, error);
    if (status)
        return status;
    if (trim >= m->patches[index].trim_count)
        return kg_fail(error, KG_ERR_INPUT, "patch %lld has no trim %zu; it has %zu",
                       (long long)patch, trim + 1, m->patches[index].trim_count);
    *out = &m->patches[index];
    return KG_OK;
}

kg_status kg_model_remove_trim(kg_model *m, int64_t patch, size_t index, kg_error *error) {
    kg_model_patch *p = NULL;
    kg_status status = find_trim(m, patch, index, &p, error);
    if (status)
        return status;
    kg_trim_op_clear(&p->trims[index]);
    p->trim_count--;
    memmove(&p->trims[index], &p->trims[index + 1], (p->trim_count - index) * sizeof *p->trims);
    return KG_OK;
}

kg_status kg_model_move_trim(kg_model *m, int64_t patch, size_t from, size_t to, kg_error *error) {
    kg_model_patch *p = NULL;
    kg_status status = find_trim(m, patch, from, &p, error);
    if (!status)
        status = find_trim(m, patch, to, &p, error);
    if (status)
        return status;
    kg_trim_op scratch;
    move_item(p->trims, sizeof *p->trims, from, to, &scratch);
    return KG_OK;
}

/* ---- colours ---------------------------------------------------------------------------- */

const char *kg_model_patch_color(const kg_model_patch *patch) {
    return json_string_value(json_object_get(patch->json, "color"));
}

kg_status kg_model_set_patch_color(kg_model_patch *patch, const char *color, kg_error *error) {
    json_t *json = patch->json ? json_copy(patch->json) : json_object();
    if (!json || json_object_set_new(json, "color", json_string(color))) {
        json_decref(json);
        return no_memory(error);
    }
    json_decref(patch->json);
    patch->json = json;
    return KG_OK;
}

/* ---- comparing -------------------------------------------------------------------------- */

static bool same_text(const char *a, const char *b) {
    return a == b || (a && b && strcmp(a, b) == 0);
}

static bool same_bytes(const void *a, const void *b, size_t count, size_t size) {
    return count == 0 || memcmp(a, b, count * size) == 0;
}

static bool same_json(const json_t *a, const json_t *b) {
    return a == b || json_equal(a, b);
}

static bool same_op(const kg_trim_op *a, const kg_trim_op *b) {
    return a->kind == b->kind && a->off == b->off && a->bounded == b->bounded &&
           a->trim_cutters == b->trim_cutters && a->outside == b->outside &&
           a->by_count == b->by_count && a->keep_count == b->keep_count &&
           a->contour_count == b->contour_count &&
           same_bytes(a->by, b->by, a->by_count, sizeof *a->by) &&
           same_bytes(a->keep, b->keep, a->keep_count, sizeof *a->keep) &&
           same_bytes(a->contour, b->contour, a->contour_count, sizeof *a->contour) &&
           same_json(a->json, b->json);
}

static bool same_input(const kg_patch_input *a, const kg_patch_input *b) {
    return a->point_count == b->point_count &&
           same_bytes(a->points, b->points, a->point_count, sizeof *a->points) &&
           a->extent[0] == b->extent[0] && a->extent[1] == b->extent[1] &&
           a->has_ruling == b->has_ruling &&
           (!a->has_ruling || same_bytes(&a->ruling, &b->ruling, 1, sizeof a->ruling)) &&
           a->flip == b->flip;
}

bool kg_model_patch_equal(const kg_model_patch *a, const kg_model_patch *b) {
    if (a->id != b->id || a->hidden != b->hidden || a->construction != b->construction ||
        a->trim_count != b->trim_count || !same_text(a->name, b->name) ||
        !same_input(&a->input, &b->input) || !same_json(a->json, b->json))
        return false;
    for (size_t i = 0; i < a->trim_count; i++)
        if (!same_op(&a->trims[i], &b->trims[i]))
            return false;
    return true;
}

static bool same_join(const kg_model_join *a, const kg_model_join *b) {
    return a->patches[0] == b->patches[0] && a->patches[1] == b->patches[1] && a->tab == b->tab &&
           a->has_at == b->has_at && (!a->has_at || same_bytes(&a->at, &b->at, 1, sizeof a->at)) &&
           a->width == b->width && a->shape == b->shape && a->merge == b->merge &&
           same_json(a->json, b->json);
}

static bool same_joins(const kg_model *a, const kg_model *b) {
    bool same = a->join_count == b->join_count;
    for (size_t i = 0; same && i < a->join_count; i++)
        same = same_join(&a->joins[i], &b->joins[i]);
    return same;
}

bool kg_model_equal(const kg_model *a, const kg_model *b) {
    const kg_reference *r = &a->reference, *s = &b->reference;
    if (!same_text(a->title, b->title) || !kg_mirror_plane_equal(a->mirror, b->mirror) ||
        !same_text(r->file, s->file) || r->size_mm != s->size_mm || r->up_y != s->up_y ||
        r->visible != s->visible || r->opacity != s->opacity || r->has_matrix != s->has_matrix ||
        (r->has_matrix && memcmp(r->matrix, s->matrix, sizeof r->matrix) != 0) ||
        !same_json(r->json, s->json) || !kg_net_settings_equal(&a->net, &b->net) ||
        !same_joins(a, b) || !same_json(a->json, b->json) || a->patch_count != b->patch_count)
        return false;
    for (size_t i = 0; i < a->patch_count; i++)
        if (!kg_model_patch_equal(&a->patches[i], &b->patches[i]))
            return false;
    return true;
}

void kg_model_swap(kg_model *a, kg_model *b) {
    kg_model held = *a;
    *a = *b;
    *b = held;
}
