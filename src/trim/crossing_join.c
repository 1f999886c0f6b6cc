/* Arcs of neighbouring cells joined end to end, and what happens in cells that stayed unclear. */
#include "trim/crossing.h"

#include "base/array.h"

#include <stdlib.h>

/* Two cells see the same root of their common edge from different coefficients: the two differ by
 * rounding, more where the root is nearly double. */
#define SAME_ROOT 1e-9
#define SAME_DOUBLE_ROOT 1e-5

/* An end by the line it lies on and its place on the line. */
typedef struct key {
    int line;
    double level, position;
    int index, side;
} key;

static int compare(const void *x, const void *y) {
    const key *a = x, *b = y;
    if (a->line != b->line)
        return a->line - b->line;
    if (a->level != b->level)
        return a->level < b->level ? -1 : 1;
    if (a->position != b->position)
        return a->position < b->position ? -1 : 1;
    return a->index - b->index;
}

/* Pairs ends within `reach` of each other that face each other, the first with the first. */
static void match_near(kg_topology *t, const key *keys, size_t count, double reach) {
    for (size_t i = 0; i < count; i++) {
        kg_arc_end *e = &t->ends.items[keys[i].index];
        for (size_t j = i + 1; j < count && e->match < 0; j++) {
            if (keys[j].line != keys[i].line || keys[j].level != keys[i].level ||
                keys[j].position > keys[i].position + reach)
                break;
            kg_arc_end *f = &t->ends.items[keys[j].index];
            if (f->match < 0 && f->side != e->side) {
                e->match = keys[j].index;
                f->match = keys[i].index;
            }
        }
    }
}

static bool match(kg_topology *t) {
    size_t count = t->ends.count;
    if (count == 0)
        return true;
    key *keys = malloc(count * sizeof *keys);
    if (!keys)
        return false;
    for (size_t i = 0; i < count; i++) {
        const kg_arc_end *e = &t->ends.items[i];
        keys[i] = e->line == 0 ? (key){0, e->v, e->t, (int)i, e->side}
                               : (key){1, e->t, e->v, (int)i, e->side};
    }
    qsort(keys, count, sizeof *keys, compare);
    match_near(t, keys, count, SAME_ROOT);
    match_near(t, keys, count, SAME_DOUBLE_ROOT);
    free(keys);
    return true;
}

/* ---- hubs ------------------------------------------------------------------------------ */

static int root_of(kg_topology *t, int hub) {
    while (t->hubs.items[hub].cluster != hub)
        hub = t->hubs.items[hub].cluster;
    return hub;
}

static bool touch(const kg_hub *x, const kg_hub *y) {
    return x->v[0] <= y->v[1] && y->v[0] <= x->v[1] && x->t[0] <= y->t[1] && y->t[0] <= x->t[1];
}

/* Hubs that have a corner or more in common form one cluster, named by its first. */
static void cluster(kg_topology *t) {
    for (int i = 0; i < (int)t->hubs.count; i++)
        for (int j = 0; j < i; j++)
            if (touch(&t->hubs.items[i], &t->hubs.items[j])) {
                int x = root_of(t, i), y = root_of(t, j);
                t->hubs.items[x > y ? x : y].cluster = x > y ? y : x;
            }
    for (int i = 0; i < (int)t->hubs.count; i++)
        t->hubs.items[i].cluster = root_of(t, i);
}

/* Where F_v = F_t = 0, by Newton steps from the middle of a cluster; false if they leave it. */
static bool saddle(const kg_strips *a, const kg_strips *b, const double v[2], const double t[2],
                   kg_vec2 *out) {
    double h = 1e-5; /* of differences; second derivatives to 1e-6 are ample for Newton steps */
    kg_vec2 at = kg_v2(0.5 * (v[0] + v[1]), 0.5 * (t[0] + t[1])), start = at;
    double reach = 4 * fmax(v[1] - v[0], t[1] - t[0]);
    for (int i = 0; i < 12; i++) {
        double g[2], gv[2], gt[2];
        kg_line x = kg_ruled_line(&a->ruled, at.x), y = kg_ruled_line(&b->ruled, at.y);
        kg_line dx = kg_ruled_line(&a->ruled, at.x + h), dy = kg_ruled_line(&b->ruled, at.y + h);
        kg_cross_value(&x, &y, &g[0], &g[1]);
        kg_cross_value(&dx, &y, &gv[0], &gv[1]);
        kg_cross_value(&x, &dy, &gt[0], &gt[1]);
        kg_vec2 cv = kg_v2((gv[0] - g[0]) / h, (gv[1] - g[1]) / h);
        kg_vec2 ct = kg_v2((gt[0] - g[0]) / h, (gt[1] - g[1]) / h);
        double det = kg_cross2(cv, ct);
        kg_vec2 r = kg_v2(-g[0], -g[1]);
        kg_vec2 step = kg_v2(kg_cross2(r, ct) / det, kg_cross2(cv, r) / det);
        at = kg_add2(at, step);
        if (!(kg_dist2(at, start) <= reach))
            return false;
        if (kg_len2(step) < 1e-15)
            break;
    }
    *out = at;
    return true;
}

static bool add_short(kg_topology *t, int e0, int e1) {
    int arc = (int)t->arcs.count;
    kg_arc_end *x = &t->ends.items[e0], *y = &t->ends.items[e1];
    x->arc = y->arc = arc;
    x->hub = y->hub = -1;
    return kg_push(&t->arcs, ((kg_arc){.kind = KG_ARC_SHORT,
                                       .v = {fmin(x->v, y->v), fmax(x->v, y->v)},
                                       .t = {fmin(x->t, y->t), fmax(x->t, y->t)},
                                       .ends = {e0, e1}}));
}

/* A cluster has ends at which arcs arrive, and others between its own hubs. Two arrive: the curve
 * goes through. None: an isolated point, where the surfaces touch. More: branches cross, and all
 * of them end in one point. */
static bool resolve(kg_topology *t, const kg_strips *a, const kg_strips *b, int c) {
    double v[2] = {INFINITY, -INFINITY}, x[2] = {INFINITY, -INFINITY};
    for (int i = c; i < (int)t->hubs.count; i++) {
        const kg_hub *h = &t->hubs.items[i];
        if (h->cluster != c)
            continue;
        v[0] = fmin(v[0], h->v[0]), v[1] = fmax(v[1], h->v[1]);
        x[0] = fmin(x[0], h->t[0]), x[1] = fmax(x[1], h->t[1]);
    }
    kg_vec2 at;
    bool singular = saddle(a, b, v, x, &at);
    if (!singular)
        at = kg_v2(0.5 * (v[0] + v[1]), 0.5 * (x[0] + x[1]));
    if (!kg_push(&t->singular, at))
        return false;
    int arrive[64], count = 0;
    for (int i = 0; i < (int)t->ends.count && count < 64; i++) {
        const kg_arc_end *e = &t->ends.items[i];
        if (e->hub >= 0 && t->hubs.items[e->hub].cluster == c && e->match >= 0 &&
            t->ends.items[e->match].hub < 0)
            arrive[count++] = i;
    }
    if (count == 2)
        return add_short(t, arrive[0], arrive[1]);
    for (int i = 0; i < count; i++) {
        int end = (int)t->ends.count;
        if (!kg_push(&t->ends, ((kg_arc_end){at.x, at.y, -1, 0, -1, -1, -1})) ||
            !add_short(t, arrive[i], end))
            return false;
    }
    return true;
}

bool kg_topology_join(kg_topology *t, const kg_strips *a, const kg_strips *b) {
    if (!match(t))
        return false;
    cluster(t);
    size_t hubs = t->hubs.count;
    for (int i = 0; i < (int)hubs; i++)
        if (t->hubs.items[i].cluster == i && !resolve(t, a, b, i))
            return false;
    /* what is left at hubs leads nowhere */
    for (size_t i = 0; i < t->ends.count; i++) {
        int match = t->ends.items[i].match;
        if (match >= 0 && t->ends.items[match].arc < 0)
            t->ends.items[i].match = -1;
    }
    return true;
}
