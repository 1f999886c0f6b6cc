/* Where a dragged vertex, or a point of an axis, comes to lie: on what is near the pointer. */
#include "app/tools/drag.h"
#include "app/tools/fold.h"
#include "base/array.h"

#include <stdlib.h>

/* Layout units: from points, from points that only follow from others, from edges, from lines. */
enum { POINT_REACH = 10, DERIVED_REACH = 7, EDGE_REACH = 7, LINE_REACH = 5 };
/* Edges at one corner; lines near the pointer. */
enum { MOST_DIRECTIONS = 12, MOST_NEAR = 48 };

/* A line that places may lie on: a part of a straight one, or a circle. */
typedef struct line {
    kg_vec3 a, b; /* ends; of a circle, its center and the vertex that is dragged */
    bool circle;
    int32_t half; /* an edge's, else -1 */
} line;

typedef struct finder {
    const kg_editor *editor;
    const kg_origami_state *state;
    kg_vec2 px;
    kg_vec3 at, normal; /* under the pointer, unsnapped; of the plane */
    double offset;
    line near[MOST_NEAR];
    size_t near_count;
    double best; /* px, of the best point so far */
    kg_snap *out;
} finder;

static bool in_plane(const finder *f, kg_vec3 p) {
    return fabs(kg_dot(f->normal, p) - f->offset) < 1e-6 * f->state->size;
}

static double seen_distance(const finder *f, kg_vec3 p) {
    kg_vec2 at;
    return kg_pane_project(&f->editor->pane, p, &at) ? kg_dist2(at, f->px) / f->editor->pane.scale
                                                     : (double)INFINITY;
}

/* Takes a point when it is nearer than the best one. */
static void offer(finder *f, kg_snap_kind kind, kg_vec3 p, double reach, const line *from) {
    double d = seen_distance(f, p);
    if (d > reach || d >= f->best)
        return;
    f->best = d;
    *f->out = (kg_snap){.kind = kind, .point = p, .half = -1};
    if (from && (kind == KG_SNAP_SYMMETRIC || kind == KG_SNAP_LINE)) {
        f->out->guide[0] = from->a;
        f->out->guide[1] = from->circle ? kg_lerp(from->b, p, 0.5) : p;
    }
    if (from && kind == KG_SNAP_EDGE)
        f->out->half = from->half;
}

/* ---- lines ------------------------------------------------------------------------------- */

/* The point of a line nearest to the pointer, in the plane. */
static kg_vec3 nearest_on(const finder *f, const line *l) {
    kg_vec3 d = kg_sub(l->b, l->a);
    if (l->circle) {
        kg_vec3 r = kg_sub(f->at, l->a);
        return kg_len(r) > 0 ? kg_madd(l->a, kg_len(d) / kg_len(r), r) : l->b;
    }
    double t = kg_dot(kg_sub(f->at, l->a), d) / fmax(kg_dot(d, d), 1e-300);
    return kg_lerp(l->a, l->b, fmin(fmax(t, 0), 1));
}

static void add_line(finder *f, line l) {
    if (f->near_count < MOST_NEAR && seen_distance(f, nearest_on(f, &l)) <= POINT_REACH)
        f->near[f->near_count++] = l;
}

static void add_edges(finder *f) {
    const kg_origami_state *s = f->state;
    for (size_t e = 0; e < s->edges.count; e++) {
        int32_t half = (int32_t)(2 * e), at[2];
        if (s->edges.items[e].kind == KG_PAPER_JOIN)
            continue;
        at[0] = s->halves.items[half].origin, at[1] = s->halves.items[half ^ 1].origin;
        line l = {s->vertices.items[at[0]].position, s->vertices.items[at[1]].position, false,
                  half};
        if (in_plane(f, l.a) && in_plane(f, l.b))
            add_line(f, l);
    }
}

/* Where the crease goes through a vertex: circles about it; where it is at right angles to the
 * bisector of two edges at the dragged vertex, and so brings one of them onto the other's line. */
static void add_symmetries(finder *f, kg_vec3 from) {
    const kg_origami_state *s = f->state;
    kg_vec3 directions[MOST_DIRECTIONS];
    size_t count = 0;
    double same = 1e-6 * s->size;
    for (size_t e = 0; e < s->edges.count; e++)
        for (size_t k = 0; k < 2 && s->edges.items[e].kind != KG_PAPER_JOIN; k++) {
            size_t half = 2 * e + k;
            kg_vec3 a = s->vertices.items[s->halves.items[half].origin].position,
                    b = s->vertices.items[s->halves.items[half ^ 1].origin].position;
            if (kg_dist(a, from) > same || !in_plane(f, b) || count == MOST_DIRECTIONS)
                continue;
            kg_vec3 d = kg_unit(kg_sub(b, a));
            bool known = false;
            for (size_t i = 0; i < count; i++)
                known |= kg_dist(directions[i], d) < 1e-6;
            if (!known)
                directions[count++] = d;
        }
    for (size_t i = 0; i < count; i++)
        for (size_t k = i + 1; k < count; k++) {
            kg_vec3 half = kg_add(directions[i], directions[k]);
            if (kg_len(half) > 1e-6)
                add_line(f, (line){from, kg_madd(from, 4 * s->size, kg_unit(half)), false, -1});
        }
    for (size_t v = 0; v < s->vertices.count; v++) {
        kg_vec3 center = s->vertices.items[v].position;
        if (in_plane(f, center) && kg_dist(center, from) > same)
            add_line(f, (line){center, from, true, -1});
    }
}

/* ---- crossings --------------------------------------------------------------------------- */

static void cross_straight(finder *f, const line *a, const line *b, kg_snap_kind kind) {
    kg_vec3 d = kg_sub(a->b, a->a), n = kg_sub(b->b, b->a), across = kg_cross(d, n);
    double square = kg_dot(across, across);
    if (square < 1e-12 * kg_dot(d, d) * kg_dot(n, n))
        return;
    kg_vec3 r = kg_sub(b->a, a->a);
    double t = kg_dot(kg_cross(r, n), across) / square, u = kg_dot(kg_cross(r, d), across) / square;
    if (t >= -1e-9 && t <= 1 + 1e-9 && u >= -1e-9 && u <= 1 + 1e-9)
        offer(f, kind, kg_madd(a->a, t, d), kind == KG_SNAP_CROSSING ? POINT_REACH : DERIVED_REACH,
              a);
}

static void cross_circle(finder *f, const line *circle, const line *straight) {
    kg_vec3 d = kg_sub(straight->b, straight->a), r = kg_sub(straight->a, circle->a);
    double radius = kg_dist(circle->a, circle->b), a = kg_dot(d, d), b = kg_dot(r, d),
           c = kg_dot(r, r) - radius * radius, root = b * b - a * c;
    for (int k = -1; k <= 1 && root >= 0 && a > 0; k += 2) {
        double t = (-b + k * sqrt(root)) / a;
        if (t >= -1e-9 && t <= 1 + 1e-9)
            offer(f, KG_SNAP_SYMMETRIC, kg_madd(straight->a, t, d), DERIVED_REACH, circle);
    }
}

/* Crossings of edges, or of an edge with a line of symmetry. */
static void offer_crossings(finder *f, bool edges) {
    for (size_t i = 0; i < f->near_count; i++)
        for (size_t k = 0; k < f->near_count; k++) {
            const line *a = &f->near[i], *b = &f->near[k];
            if (b->half < 0 || (edges ? a->half < 0 || i >= k : a->half >= 0))
                continue;
            if (a->circle)
                cross_circle(f, a, b);
            else
                cross_straight(f, a, b, edges ? KG_SNAP_CROSSING : KG_SNAP_SYMMETRIC);
        }
}

/* ---- the finder -------------------------------------------------------------------------- */

static void offer_points(finder *f, const kg_vec3 *from) {
    const kg_origami_state *s = f->state;
    for (size_t v = 0; v < s->vertices.count; v++) {
        kg_vec3 p = s->vertices.items[v].position;
        if (in_plane(f, p) && !(from && kg_dist(p, *from) < 1e-6 * s->size))
            offer(f, KG_SNAP_VERTEX, p, POINT_REACH, NULL);
    }
    if (f->out->kind == KG_SNAP_VERTEX)
        return;
    for (size_t i = 0; i < f->near_count; i++)
        if (f->near[i].half >= 0)
            offer(f, KG_SNAP_MIDDLE, kg_lerp(f->near[i].a, f->near[i].b, 0.5), POINT_REACH, NULL);
    offer_crossings(f, true);
}

static void offer_lines(finder *f, bool edges) {
    for (size_t i = 0; i < f->near_count; i++)
        if ((f->near[i].half >= 0) == edges)
            offer(f, edges ? KG_SNAP_EDGE : KG_SNAP_LINE, nearest_on(f, &f->near[i]),
                  edges ? EDGE_REACH : LINE_REACH, &f->near[i]);
}

/* To the editor's steps, from the middle of space along the axes of the plane that lie nearest to
 * its own. */
static kg_vec3 on_grid(const finder *f) {
    kg_vec3 n = f->normal;
    kg_vec3 u = fabs(n.z) > 0.999999 ? kg_v3(1, 0, 0) : kg_unit(kg_cross(kg_v3(0, 0, 1), n)),
            v = kg_cross(n, u);
    double x = kg_round_to_step(f->editor, kg_dot(f->at, u)),
           y = kg_round_to_step(f->editor, kg_dot(f->at, v));
    return kg_add(kg_scale(n, f->offset), kg_add(kg_scale(u, x), kg_scale(v, y)));
}

bool kg_snap_find(const kg_editor *e, const kg_fold_tool *t, kg_vec2 px, unsigned mods,
                  const kg_vec3 *from, kg_snap *out) {
    const kg_sheets *sheets = kg_sheets_of(e);
    finder f = {.editor = e, .state = sheets->state, .px = px, .best = INFINITY, .out = out};
    if (!f.state || (size_t)t->group >= f.state->groups.count)
        return false;
    const kg_face_group *g = &f.state->groups.items[t->group];
    f.normal = g->normal;
    f.offset = g->offset;
    if (!kg_pane_on_plane(&e->pane, px, kg_scale(g->normal, g->offset), g->normal, &f.at) ||
        !(kg_len(f.at) < 1e6))
        return false;
    *out = (kg_snap){.kind = KG_SNAP_FREE, .point = f.at, .half = -1};
    if (mods & KG_MOD_ALT)
        return true;
    if (mods & KG_MOD_CTRL) {
        out->kind = KG_SNAP_GRID;
        out->point = on_grid(&f);
        return true;
    }
    add_edges(&f);
    offer_points(&f, from);
    if (out->kind != KG_SNAP_FREE)
        return true;
    if (from)
        add_symmetries(&f, *from);
    offer_crossings(&f, false);
    if (out->kind == KG_SNAP_FREE)
        offer_lines(&f, true);
    if (out->kind == KG_SNAP_FREE)
        offer_lines(&f, false);
    return true;
}
