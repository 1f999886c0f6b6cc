/* Faces to loops: edges are found, concave faces divided. */
#include "origami/state.h"

#include "base/phrase.h"
#include "origami/convex.h"

#include <stdlib.h>

kg_status kg_face_list_add(kg_face_list *list, const int32_t *corners, size_t count) {
    if (list->starts.count == 0 && !kg_push(&list->starts, 0))
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < count; i++)
        if (!kg_push(&list->corners, corners[i]))
            return KG_ERR_MEMORY;
    return kg_push(&list->starts, (int32_t)list->corners.count) ? KG_OK : KG_ERR_MEMORY;
}

void kg_face_list_clear(kg_face_list *list) {
    free(list->corners.items);
    free(list->starts.items);
    *list = (kg_face_list){0};
}

kg_status kg_state_add_edge(kg_origami_state *s, int32_t from, int32_t to, kg_paper_edge_kind kind,
                            double angle) {
    kg_half_edge there = {from, -1, -1}, back = {to, -1, -1};
    kg_paper_edge edge = {kind, angle};
    return kg_push(&s->halves, there) && kg_push(&s->halves, back) && kg_push(&s->edges, edge)
               ? KG_OK
               : KG_ERR_MEMORY;
}

/* ---- dividing concave faces ------------------------------------------------------------- */

/* Sines of corners below this are concave, not rounding of straight ones. */
#define CONCAVE (-1e-9)

static kg_vec2 paper(const kg_origami_state *s, int32_t vertex) {
    return s->vertices.items[vertex].paper;
}

static double turn(kg_vec2 a, kg_vec2 b, kg_vec2 c) {
    return kg_cross2(kg_sub2(b, a), kg_sub2(c, b));
}

/* A slit ends there: the outline turns back along its other side. */
static bool is_tip(const int32_t *c, size_t n, size_t i) {
    return n > 2 && c[(i + n - 1) % n] == c[(i + 1) % n];
}

static bool is_concave(const kg_origami_state *s, const int32_t *c, size_t n, size_t i) {
    if (is_tip(c, n, i))
        return true;
    kg_vec2 a = paper(s, c[(i + n - 1) % n]), b = paper(s, c[i]), d = paper(s, c[(i + 1) % n]);
    return turn(a, b, d) < CONCAVE * kg_dist2(a, b) * kg_dist2(b, d);
}

/* The direction from corner i to `target` points into the face. */
static bool looks_inside(const kg_origami_state *s, const int32_t *c, size_t n, size_t i,
                         kg_vec2 target) {
    kg_vec2 a = paper(s, c[(i + n - 1) % n]), b = paper(s, c[i]), d = paper(s, c[(i + 1) % n]);
    if (is_tip(c, n, i))
        return turn(b, d, target) != 0 || kg_dot2(kg_sub2(d, b), kg_sub2(target, b)) < 0;
    bool after = turn(b, d, target) > 0, before = turn(a, b, target) > 0;
    return turn(a, b, d) >= 0 ? after && before : after || before;
}

static bool is_diagonal(const kg_origami_state *s, const int32_t *c, size_t n, size_t i, size_t j) {
    kg_vec2 p = paper(s, c[i]), q = paper(s, c[j]);
    if (!looks_inside(s, c, n, i, q) || !looks_inside(s, c, n, j, p))
        return false;
    for (size_t k = 0; k < n; k++) {
        size_t l = (k + 1) % n;
        if (c[k] == c[i] || c[k] == c[j] || c[l] == c[i] || c[l] == c[j])
            continue; /* both sides of a slit have the same vertices */
        kg_vec2 a = paper(s, c[k]), b = paper(s, c[l]);
        double ap = turn(p, q, a), bp = turn(p, q, b), pa = turn(a, b, p), qa = turn(a, b, q);
        if (ap * bp <= 0 && pa * qa <= 0)
            return false;
    }
    return true;
}

/* The corner that a cut from concave corner i best halves it with; n when there is none. */
static size_t best_cut(const kg_origami_state *s, const int32_t *c, size_t n, size_t i) {
    kg_vec2 a = paper(s, c[(i + n - 1) % n]), b = paper(s, c[i]), d = paper(s, c[(i + 1) % n]);
    kg_vec2 in = kg_sub2(b, a), out = kg_sub2(d, b);
    kg_vec2 middle = kg_sub2(kg_scale2(in, 1 / kg_len2(in)), kg_scale2(out, 1 / kg_len2(out)));
    size_t best = n;
    double best_cosine = -2;
    for (size_t j = 0; j < n; j++) {
        if (j == i || (j + 1) % n == i || (i + 1) % n == j || !is_diagonal(s, c, n, i, j))
            continue;
        kg_vec2 r = kg_sub2(paper(s, c[j]), b);
        double cosine = kg_dot2(r, middle) / (kg_len2(r) * kg_len2(middle) + 1e-300);
        if (cosine > best_cosine)
            best = j, best_cosine = cosine;
    }
    return best;
}

/* Cuts faces until all are convex; every cut makes a KG_PAPER_JOIN. */
static kg_status divide(kg_origami_state *s, kg_face_list *faces, const int32_t *corners,
                        size_t count, size_t face, kg_error *error) {
    int32_t *part = malloc((count + 1) * sizeof *part);
    kg_face_list rest = {0};
    kg_status status = part ? kg_face_list_add(&rest, corners, count) : KG_ERR_MEMORY;
    for (size_t f = 0; !status && f + 1 < rest.starts.count; f++) {
        const int32_t *c = rest.corners.items + rest.starts.items[f];
        size_t n = (size_t)(rest.starts.items[f + 1] - rest.starts.items[f]), i = 0;
        while (i < n && !is_concave(s, c, n, i))
            i++;
        if (i == n) {
            status = kg_face_list_add(faces, c, n);
            continue;
        }
        size_t j = best_cut(s, c, n, i);
        if (j == n) {
            status = kg_fail(error, KG_ERR_INPUT, "face %zu crosses itself", face);
            break;
        }
        status = kg_state_add_edge(s, c[i], c[j], KG_PAPER_JOIN, 0);
        for (int side = 0; side < 2 && !status; side++) {
            size_t m = 0, from = side ? j : i, to = side ? i : j;
            c = rest.corners.items + rest.starts.items[f];
            for (size_t k = from; k != to; k = (k + 1) % n)
                part[m++] = c[k];
            part[m++] = c[to];
            status = kg_face_list_add(&rest, part, m);
        }
    }
    free(part);
    kg_face_list_clear(&rest);
    return status;
}

/* ---- loops ------------------------------------------------------------------------------ */

typedef struct named_half {
    int32_t from, to, half;
} named_half;

static int compare_halves(const void *a, const void *b) {
    const named_half *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    if (x->to != y->to)
        return x->to < y->to ? -1 : 1;
    return x->half < y->half ? -1 : x->half > y->half;
}

/* Only edges that face lists have just been given: those without loops. */
static named_half *name_halves(const kg_origami_state *s, size_t *out_count) {
    named_half *names = malloc((s->halves.count + 1) * sizeof *names);
    if (!names)
        return NULL;
    size_t n = 0;
    for (size_t h = 0; h < s->halves.count; h++)
        if (s->halves.items[h].loop < 0)
            names[n++] =
                (named_half){s->halves.items[h].origin, s->halves.items[h ^ 1].origin, (int32_t)h};
    qsort(names, n, sizeof *names, compare_halves);
    *out_count = n;
    return names;
}

static int compare_ends(const void *a, const void *b) {
    const named_half *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

static kg_status add_loop(kg_origami_state *s, int32_t sheet, const int32_t *c, size_t n,
                          const named_half *names, size_t name_count, kg_error *error) {
    int32_t loop = (int32_t)s->loops.count, first = -1, last = -1;
    for (size_t i = 0; i < n; i++) {
        named_half key = {c[i], c[(i + 1) % n], 0};
        const named_half *found = bsearch(&key, names, name_count, sizeof *names, compare_ends);
        if (!found || s->halves.items[found->half].loop >= 0)
            return kg_fail(error, KG_ERR_INPUT,
                           found ? N_("two faces lie on the same side of the edge between vertices "
                                      "%d and %d")
                                 : N_("a face has no edge between vertices %d and %d"),
                           key.from, key.to);
        s->halves.items[found->half].loop = loop;
        if (last >= 0)
            s->halves.items[last].next = found->half;
        else
            first = found->half;
        last = found->half;
    }
    s->halves.items[last].next = first;
    kg_paper_loop l = {first, sheet, 0, -1};
    return kg_push(&s->loops, l) ? KG_OK : KG_ERR_MEMORY;
}

kg_status kg_state_add_faces(kg_origami_state *s, int32_t sheet, const kg_face_list *faces,
                             kg_error *error) {
    kg_face_list convex = {0};
    kg_status status = KG_OK;
    for (size_t f = 0; f + 1 < faces->starts.count && !status; f++) {
        int32_t start = faces->starts.items[f];
        status = divide(s, &convex, faces->corners.items + start,
                        (size_t)(faces->starts.items[f + 1] - start), f, error);
    }
    size_t name_count = 0;
    named_half *names = status ? NULL : name_halves(s, &name_count);
    if (!status && !names)
        status = KG_ERR_MEMORY;
    for (size_t f = 0; f + 1 < convex.starts.count && !status; f++) {
        int32_t start = convex.starts.items[f];
        status = add_loop(s, sheet, convex.corners.items + start,
                          (size_t)(convex.starts.items[f + 1] - start), names, name_count, error);
    }
    free(names);
    kg_face_list_clear(&convex);
    return status;
}
