/*
 * The topology of F(v,t) = 0 by subdivision, certified by the hull of Bernstein coefficients: a
 * cell is empty where they have one sign, and simple where those of F_t (or F_v) have one sign:
 * there the curve is a set of graphs over v (or t) that start and end on the cell's edges. (After
 * Snyder 1992, "Interval analysis for computer graphics", global parametrizability.)
 */
#include "trim/crossing.h"

#include "base/array.h"

#include <stdlib.h>

/* Cells are halved this often at most: 100 mm come down to 0.0004 mm, and branches that pass each
 * other in a saddle of F are told apart from crossing ones down to that gap; the saddle itself is
 * then on both surfaces to 1e-11 of the size. */
enum { MAX_DEPTH = 18 };

/* More unresolved cells on one level than this, below a level where ordinary pairs are done, mean
 * that F is singular along a curve: nothing to be gained by smaller cells. */
enum { CROWD = 256, CROWD_DEPTH = 6 };

/* Rounding of a Bernstein coefficient relative to the sum of the terms' magnitudes: a few units in
 * the last place from the products and one from each halving. */
#define NOISE 8e-15

typedef struct cell {
    int a, b; /* strips */
} cell;

typedef struct kg_cells {
    cell *items;
    size_t count, capacity;
} kg_cells;

typedef struct work {
    kg_strips *a, *b;
    int n, m;
    double noise;
    double f[KG_PLUCKER_MAX][KG_PLUCKER_MAX];
    kg_topology *out;
} work;

typedef enum verdict { EMPTY, SIMPLE, UNCLEAR, VANISHING, NO_MEMORY } verdict;

/* Coefficients of F on the cell; f[i][j] belongs to v^i t^j. */
static void multiply(work *w, const kg_strip *s, const kg_strip *t) {
    w->noise = 0;
    for (int k = 0; k < 6; k++)
        w->noise += s->largest[k] * t->largest[(k + 3) % 6];
    w->noise *= NOISE;
    for (int i = 0; i <= w->n; i++) {
        double *row = w->f[i];
        double a0 = s->c[0][i], a1 = s->c[1][i], a2 = s->c[2][i];
        double a3 = s->c[3][i], a4 = s->c[4][i], a5 = s->c[5][i];
        for (int j = 0; j <= w->m; j++)
            row[j] = ((a0 * t->c[3][j] + a1 * t->c[4][j]) + (a2 * t->c[5][j] + a3 * t->c[0][j])) +
                     (a4 * t->c[1][j] + a5 * t->c[2][j]);
    }
}

static int one_sign(double lo, double hi, double noise) {
    return lo > noise ? 1 : hi < -noise ? -1 : 0;
}

static bool add_end(work *w, double v, double t, int line, int side, int arc, int hub) {
    return kg_push(&w->out->ends, ((kg_arc_end){v, t, line, side, arc, hub, -1}));
}

/* The curve's ends on the four edges of a cell. */
typedef struct edges {
    /* low and high end of the graph's parameter, then low and high edge across */
    int count[4];
    double at[4][KG_PLUCKER_MAX];
    bool known;
} edges;

/* Edges 0, 1: v = lo, hi; 2, 3: t = lo, hi. Positions are fractions of the edge. */
static void find_edges(const work *w, edges *e) {
    double low[KG_PLUCKER_MAX], high[KG_PLUCKER_MAX];
    for (int i = 0; i <= w->n; i++)
        low[i] = w->f[i][0], high[i] = w->f[i][w->m];
    e->count[0] = kg_sign_changes(w->f[0], w->m, w->noise, e->at[0]);
    e->count[1] = kg_sign_changes(w->f[w->n], w->m, w->noise, e->at[1]);
    e->count[2] = kg_sign_changes(low, w->n, w->noise, e->at[2]);
    e->count[3] = kg_sign_changes(high, w->n, w->noise, e->at[3]);
    e->known = e->count[0] >= 0 && e->count[1] >= 0 && e->count[2] >= 0 && e->count[3] >= 0;
}

/* Adds the end at position `at` of edge `edge`. */
static bool add_edge_end(work *w, const kg_strip *s, const kg_strip *t, int edge, double at,
                         int arc, int hub) {
    double v = edge == 0 ? s->lo : edge == 1 ? s->hi : s->lo + at * (s->hi - s->lo);
    double x = edge == 2 ? t->lo : edge == 3 ? t->hi : t->lo + at * (t->hi - t->lo);
    return add_end(w, v, x, edge >> 1, edge & 1 ? -1 : 1, arc, hub);
}

static bool add_arc(work *w, const kg_strip *s, const kg_strip *t, kg_arc_kind kind, int slope,
                    int first, double at, int last, double to) {
    int arc = (int)w->out->arcs.count, end = (int)w->out->ends.count;
    return add_edge_end(w, s, t, first, at, arc, -1) && add_edge_end(w, s, t, last, to, arc, -1) &&
           kg_push(&w->out->arcs, ((kg_arc){.kind = kind,
                                            .v = {s->lo, s->hi},
                                            .t = {t->lo, t->hi},
                                            .slope = slope,
                                            .ends = {end, end + 1}}));
}

/* Joins the ends on the edges of a simple cell in the order of the graph's parameter: each graph
 * starts and ends where the signs on the two edges along that parameter become different. */
static verdict join(work *w, const kg_strip *s, const kg_strip *t, kg_arc_kind kind, int slope) {
    edges e;
    find_edges(w, &e);
    int first = kind == KG_ARC_OVER_V ? 0 : 2, along = 2 - first;
    if (!e.known || e.count[first] > 1 || e.count[first + 1] > 1)
        return UNCLEAR;
    struct {
        int edge;
        double at;
    } list[2 * KG_PLUCKER_MAX + 2];
    int count = 0, i = 0, j = 0;
    if (e.count[first])
        list[count].edge = first, list[count++].at = e.at[first][0];
    while (i < e.count[along] || j < e.count[along + 1]) {
        bool low =
            j == e.count[along + 1] || (i < e.count[along] && e.at[along][i] < e.at[along + 1][j]);
        list[count].edge = low ? along : along + 1;
        list[count++].at = low ? e.at[along][i++] : e.at[along + 1][j++];
    }
    if (e.count[first + 1])
        list[count].edge = first + 1, list[count++].at = e.at[first + 1][0];
    if (count & 1)
        return UNCLEAR;
    for (int k = 0; k < count; k += 2) {
        if (!add_arc(w, s, t, kind, slope, list[k].edge, list[k].at, list[k + 1].edge,
                     list[k + 1].at))
            return NO_MEMORY;
    }
    return SIMPLE;
}

static verdict examine(work *w, cell c) {
    const kg_strip *s = &w->a->items[c.a], *t = &w->b->items[c.b];
    multiply(w, s, t);
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i <= w->n; i++)
        for (int j = 0; j <= w->m; j++) {
            double f = w->f[i][j];
            lo = f < lo ? f : lo;
            hi = f > hi ? f : hi;
        }
    if (one_sign(lo, hi, w->noise))
        return EMPTY;
    if (lo >= -w->noise && hi <= w->noise)
        return VANISHING;
    double dv[2] = {INFINITY, -INFINITY}, dt[2] = {INFINITY, -INFINITY};
    for (int i = 0; i <= w->n; i++)
        for (int j = 0; j < w->m; j++) {
            double d = w->f[i][j + 1] - w->f[i][j];
            dt[0] = d < dt[0] ? d : dt[0];
            dt[1] = d > dt[1] ? d : dt[1];
        }
    for (int i = 0; i < w->n; i++)
        for (int j = 0; j <= w->m; j++) {
            double d = w->f[i + 1][j] - w->f[i][j];
            dv[0] = d < dv[0] ? d : dv[0];
            dv[1] = d > dv[1] ? d : dv[1];
        }
    int over_v = one_sign(dt[0], dt[1], 2 * w->noise),
        over_t = one_sign(dv[0], dv[1], 2 * w->noise);
    if (!over_v && !over_t)
        return UNCLEAR;
    /* the parameter along which the graph is less steep */
    if (over_v && over_t) {
        double width = (s->hi - s->lo) / (t->hi - t->lo);
        if (w->m * fmin(fabs(dt[0]), fabs(dt[1])) * width >= w->n * fmin(fabs(dv[0]), fabs(dv[1])))
            over_t = 0;
        else
            over_v = 0;
    }
    return over_v ? join(w, s, t, KG_ARC_OVER_V, over_v) : join(w, s, t, KG_ARC_OVER_T, over_t);
}

static bool add_hub(work *w, cell c, bool crowded) {
    const kg_strip *s = &w->a->items[c.a], *t = &w->b->items[c.b];
    int hub = (int)w->out->hubs.count;
    multiply(w, s, t);
    edges e;
    find_edges(w, &e);
    /* A curve of odd multiplicity through a cell: F changes its sign across it all along. */
    if (crowded && e.known)
        for (int first = 0; first < 4; first += 2)
            if (e.count[first] == 1 && e.count[first + 1] == 1 && !e.count[2 - first] &&
                !e.count[3 - first])
                return add_arc(w, s, t, first ? KG_ARC_OVER_T : KG_ARC_OVER_V,
                               (first ? w->f[w->n][0] : w->f[0][w->m]) > 0 ? 1 : -1, first,
                               e.at[first][0], first + 1, e.at[first + 1][0]);
    if (!kg_push(&w->out->hubs,
                 ((kg_hub){.v = {s->lo, s->hi}, .t = {t->lo, t->hi}, .cluster = hub})))
        return false;
    for (int edge = 0; edge < 4; edge++)
        for (int k = 0; k < e.count[edge]; k++)
            if (!add_edge_end(w, s, t, edge, e.at[edge][k], -1, hub))
                return false;
    return true;
}

static bool split(work *w, cell c, kg_cells *next) {
    if (!kg_strips_split(w->a, c.a) || !kg_strips_split(w->b, c.b))
        return false;
    for (int k = 0; k < 4; k++) {
        cell part = {w->a->items[c.a].child[k >> 1], w->b->items[c.b].child[k & 1]};
        if (!kg_strips_apart(w->a, part.a, w->b, part.b) && !kg_push(next, part))
            return false;
    }
    return true;
}

static bool subdivide(work *w, kg_cells level[2]) {
    if (!kg_push(&level[0], ((cell){0, 0})))
        return false;
    for (int depth = 0; level[0].count > 0; depth++) {
        bool crowded = depth >= CROWD_DEPTH && level[0].count > CROWD;
        w->out->crowded |= crowded;
        level[1].count = 0;
        for (size_t i = 0; i < level[0].count; i++) {
            cell c = level[0].items[i];
            verdict v = examine(w, c);
            if (v == NO_MEMORY)
                return false;
            if (v == VANISHING)
                w->out->crowded = true;
            if (v == EMPTY || v == SIMPLE)
                continue;
            bool last = crowded || depth == MAX_DEPTH || v == VANISHING;
            if (!(last ? add_hub(w, c, crowded) : split(w, c, &level[1])))
                return false;
        }
        kg_cells done = level[0];
        level[0] = level[1];
        level[1] = done;
    }
    return true;
}

bool kg_topology_find(kg_strips *a, kg_strips *b, kg_topology *out) {
    kg_topology topology = {0};
    work w = {.a = a, .b = b, .n = a->ruled.degree, .m = b->ruled.degree, .out = &topology};
    kg_cells level[2] = {{0}, {0}};
    bool ok = subdivide(&w, level) && kg_topology_join(&topology, a, b);
    free(level[0].items);
    free(level[1].items);
    if (!ok)
        kg_topology_clear(&topology);
    else
        *out = topology;
    return ok;
}

void kg_topology_clear(kg_topology *t) {
    free(t->ends.items);
    free(t->arcs.items);
    free(t->hubs.items);
    free(t->singular.items);
    *t = (kg_topology){0};
}
