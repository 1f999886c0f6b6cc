/* Copies of origamis, and whether two are the same. */
#include "origami/layers.h"
#include "origami/origami.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static bool copy_sheets(const kg_origami *o, kg_origami *out) {
    if (!kg_reserve(&out->sheets, o->sheets.count))
        return false;
    for (size_t i = 0; i < o->sheets.count; i++) {
        if (!kg_sheet_copy(&o->sheets.items[i], &out->sheets.items[i]))
            return false;
        out->sheets.count++;
    }
    return true;
}

kg_origami *kg_origami_copy(const kg_origami *o) {
    kg_origami *out = calloc(1, sizeof *out);
    if (!out)
        return NULL;
    out->title = strdup(o->title);
    bool ok = kg_net_settings_copy(&o->net, &out->net) && out->title;
    if (!ok || !copy_sheets(o, out) || !kg_reserve(&out->folds, o->folds.count) ||
        !kg_reserve(&out->states, o->states.count)) {
        kg_origami_destroy(out);
        return NULL;
    }
    for (size_t i = 0; i < o->folds.count; i++) {
        out->folds.items[out->folds.count++] = o->folds.items[i];
        json_incref(o->folds.items[i].json);
    }
    for (size_t i = 0; i < o->states.count; i++)
        out->states.items[out->states.count++] = kg_state_share(o->states.items[i]);
    out->step = o->step;
    out->pattern = o->pattern;
    out->json = json_incref(o->json);
    return out;
}

/* ---- comparing -------------------------------------------------------------------------- */

static bool same_json(const json_t *a, const json_t *b) {
    return a == b || json_equal(a, b);
}

static bool same_sheet(const kg_paper_sheet *a, const kg_paper_sheet *b) {
    return a->count == b->count && a->front == b->front && a->back == b->back &&
           memcmp(a->polygon, b->polygon, a->count * sizeof *a->polygon) == 0 &&
           same_json(a->json, b->json);
}

static bool same_point(kg_vec3 a, kg_vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_fold(const kg_fold *a, const kg_fold *b) {
    return a->by_axis == b->by_axis && same_point(a->points[0], b->points[0]) &&
           same_point(a->points[1], b->points[1]) &&
           (!a->by_axis || same_point(a->vertex, b->vertex)) && a->angle_deg == b->angle_deg &&
           a->face == b->face && a->layers == b->layers && a->between[0] == b->between[0] &&
           a->between[1] == b->between[1] && same_json(a->json, b->json);
}

#define SAME(array)                                                                                \
    (a->array.count == b->array.count &&                                                           \
     (a->array.count == 0 ||                                                                       \
      memcmp(a->array.items, b->array.items, a->array.count * sizeof *a->array.items) == 0))

/* Bit for bit, as replaying gives it. */
static bool same_state(const kg_origami_state *a, const kg_origami_state *b) {
    if (a->edges.count != b->edges.count || a->groups.count != b->groups.count)
        return false;
    for (size_t i = 0; i < a->edges.count; i++) /* these have padding */
        if (a->edges.items[i].kind != b->edges.items[i].kind ||
            a->edges.items[i].angle != b->edges.items[i].angle)
            return false;
    for (size_t i = 0; i < a->vertices.count && i < b->vertices.count; i++) {
        const kg_paper_vertex *v = &a->vertices.items[i], *w = &b->vertices.items[i];
        if (v->sheet != w->sheet || v->paper.x != w->paper.x || v->paper.y != w->paper.y ||
            !same_point(v->position, w->position))
            return false;
    }
    return a->vertices.count == b->vertices.count && SAME(halves) && SAME(loops) && SAME(groups) &&
           kg_layers_equal(a, b);
}

bool kg_origami_equal(const kg_origami *a, const kg_origami *b) {
    if (a->step != b->step || a->sheets.count != b->sheets.count ||
        a->folds.count != b->folds.count || strcmp(a->title, b->title) != 0 ||
        !kg_net_settings_equal(&a->net, &b->net))
        return false;
    for (size_t i = 0; i < a->sheets.count; i++)
        if (!same_sheet(&a->sheets.items[i], &b->sheets.items[i]))
            return false;
    for (size_t i = 0; i < a->folds.count; i++)
        if (!same_fold(&a->folds.items[i], &b->folds.items[i]))
            return false;
    const kg_origami_state *s = a->states.items[0], *t = b->states.items[0];
    return (s == t || same_state(s, t)) && same_json(a->json, b->json);
}
