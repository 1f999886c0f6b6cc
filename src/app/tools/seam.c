#include "app/tools/seam.h"

#include "app/scenery.h"

#include <stdlib.h>

enum { SEAM_DISTANCE = 7 }; /* layout units */

/* An edge behind the nearest surface by more than this share of the distance is hidden by it; those
 * on it are off by its triangles' chords. */
#define BEHIND 0.01

bool kg_seam_is_hovered(const kg_editor *e, int64_t a, int64_t b) {
    const int64_t *seam = e->hover_seam;
    bool one = e->hover_patch && (e->hover_patch == seam[0] || e->hover_patch == seam[1]);
    return one && ((a == seam[0] && b == seam[1]) || (a == seam[1] && b == seam[0]));
}

/* Calls `visit` for each cut edge of a patch that is seen, until it returns false. */
typedef bool (*edge_visit)(const kg_solved_patch *patch, const kg_region_loop *loop,
                           const kg_region_edge *edge, void *data);
static void visit_edges(const kg_solved_patch *p, edge_visit visit, void *data) {
    for (size_t i = 0; p && i < p->regions.count; i++)
        for (size_t k = 0; k < p->regions.items[i].loop_count; k++) {
            const kg_region_loop *loop = &p->regions.items[i].loops[k];
            for (size_t j = 0; j < loop->edge_count; j++)
                if (loop->edges[j].kind == KG_EDGE_CUT && !visit(p, loop, &loop->edges[j], data))
                    return;
        }
}

/* ---- under the pointer ------------------------------------------------------------------- */

typedef struct search {
    const kg_editor *editor;
    kg_vec2 px;
    kg_vec3 eye, direction; /* of the line of sight */
    double depth;           /* of the nearest surface, mm; infinite: none */
    double nearest;         /* px */
    int64_t patch, source;
    kg_vec3 place;
    kg_vec2 at; /* on `patch` */
} search;

static bool look_at(const kg_solved_patch *patch, const kg_region_loop *loop,
                    const kg_region_edge *edge, void *data) {
    search *s = data;
    kg_cross_point before = kg_region_edge_point(loop, edge, 0);
    kg_vec2 from, to;
    bool seen = kg_pane_project(&s->editor->pane, before.x, &from);
    for (size_t i = 1; i <= edge->count; i++) {
        kg_cross_point next = kg_region_edge_point(loop, edge, i);
        bool sees = kg_pane_project(&s->editor->pane, next.x, &to);
        double f = 0, distance = seen && sees ? kg_segment_distance(s->px, from, to, &f) : HUGE_VAL;
        if (distance < s->nearest) {
            kg_vec3 place = kg_lerp(before.x, next.x, f);
            double depth = kg_dot(kg_sub(place, s->eye), s->direction);
            if (depth <= s->depth * (1 + BEHIND)) {
                s->nearest = distance;
                s->patch = patch->id;
                s->source = edge->source;
                s->place = place;
                s->at = kg_lerp2(kg_v2(before.u, before.v), kg_v2(next.u, next.v), f);
            }
        }
        before = next, from = to, seen = sees;
    }
    return true;
}

/* The same cut on two patches differs by the chords of both. */
#define NEAR (4 * KG_EDITOR_CHORD)

static bool goes_through(const kg_region_loop *loop, const kg_region_edge *edge, kg_vec3 place) {
    for (size_t i = 1; i <= edge->count; i++) {
        kg_vec3 a = kg_region_edge_point(loop, edge, i - 1).x,
                b = kg_region_edge_point(loop, edge, i).x, d = kg_sub(b, a);
        double n = kg_dot(d, d), f = n > 0 ? kg_dot(kg_sub(place, a), d) / n : 0;
        if (kg_dist(kg_madd(a, fmin(fmax(f, 0), 1), d), place) <= NEAR)
            return true;
    }
    return false;
}

/* A patch whose edge by the same source goes through a place: behind a construction patch that
 * separates two. */
typedef struct partner {
    int64_t source, found;
    kg_vec3 place;
} partner;

static bool is_partner(const kg_solved_patch *patch, const kg_region_loop *loop,
                       const kg_region_edge *edge, void *data) {
    partner *p = data;
    if (edge->source == p->source && goes_through(loop, edge, p->place))
        p->found = patch->id;
    return !p->found;
}

static int64_t other_side(const kg_editor *e, const search *s) {
    const kg_solution *solution = kg_editor_solution(e);
    const kg_solved_patch *cutter = kg_solution_find(solution, s->source);
    if (!cutter || !cutter->construction)
        return s->source;
    partner p = {s->source, 0, s->place};
    for (size_t i = 0; i < kg_solution_count(solution) && !p.found; i++)
        if (kg_solution_patch(solution, i)->id != s->patch)
            visit_edges(kg_solution_patch(solution, i), is_partner, &p);
    return p.found ? p.found : s->source;
}

void kg_seam_hover(kg_editor *e, kg_vec2 px) {
    const kg_model *m = kg_editor_model(e);
    kg_hit hit;
    search s = {.editor = e, .px = px, .nearest = SEAM_DISTANCE * e->pane.scale};
    e->hover_seam[0] = e->hover_seam[1] = 0;
    kg_pane_ray(&e->pane, px, &s.eye, &s.direction);
    s.direction = kg_unit(s.direction);
    s.depth = kg_editor_hits(e, px, &hit, 1) > 0 ? kg_dot(kg_sub(hit.point, s.eye), s.direction)
                                                 : HUGE_VAL;
    for (size_t i = 0; i < m->patch_count; i++)
        if (!m->patches[i].hidden)
            visit_edges(kg_solution_patch(kg_editor_solution(e), i), look_at, &s);
    if (!s.patch)
        return;
    e->hover_seam[0] = s.patch;
    e->hover_seam[1] = other_side(e, &s);
    e->hover_seam_place = s.place;
    e->hover_seam_at = s.at;
    if (e->hover_patch != e->hover_seam[1])
        e->hover_patch = s.patch;
}

/* ---- drawing ----------------------------------------------------------------------------- */

typedef struct drawing {
    const kg_editor *editor;
    kg_overlay *overlay;
    int64_t other; /* the patch on the other side */
} drawing;

typedef struct shared {
    int64_t source;
    bool found;
} shared;

static bool has_source(const kg_solved_patch *patch, const kg_region_loop *loop,
                       const kg_region_edge *edge, void *data) {
    (void)patch;
    (void)loop;
    shared *s = data;
    s->found = s->found || edge->source == s->source;
    return !s->found;
}

/* The edge is on the other patch, or on a construction patch that cuts both. */
static bool draw_edge(const kg_solved_patch *patch, const kg_region_loop *loop,
                      const kg_region_edge *edge, void *data) {
    (void)patch;
    drawing *d = data;
    if (!goes_through(loop, edge, d->editor->hover_seam_place))
        return true;
    const kg_solution *solution = kg_editor_solution(d->editor);
    const kg_solved_patch *cutter = kg_solution_find(solution, edge->source);
    shared both = {edge->source, edge->source == d->other};
    if (!both.found && cutter && cutter->construction)
        visit_edges(kg_solution_find(solution, d->other), has_source, &both);
    if (!both.found)
        return true;
    kg_vec3 *points = calloc(edge->count + 1, sizeof *points);
    for (size_t i = 0; points && i <= edge->count; i++)
        points[i] = kg_region_edge_point(loop, edge, i).x;
    if (points) {
        kg_style style = kg_line_style((kg_color){1, 0.55F, 0.1F, 1}, 5);
        style.hidden = 0.6F;
        kg_overlay_line(d->overlay, points, edge->count + 1, style);
    }
    free(points);
    return true;
}

void kg_seam_draw(const kg_editor *e, kg_overlay *overlay) {
    const int64_t *seam = e->hover_seam;
    if (!kg_seam_is_hovered(e, seam[0], seam[1]))
        return;
    for (int i = 0; i < 2; i++) {
        drawing d = {e, overlay, seam[1 - i]};
        visit_edges(kg_solution_find(kg_editor_solution(e), seam[i]), draw_edge, &d);
    }
}
