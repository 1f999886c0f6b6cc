#include "app/modes/sheet_pick.h"

#include "app/pane.h"

/* mm over the size of the sheets: paper so little nearer to the eye does not hide a corner. */
#define COVER 1e-3

static int32_t next_half(const kg_origami_state *s, int32_t half) {
    return s->halves.items[half].next;
}

/* Where a ray meets a triangle, from either side: weights of its corners. */
static bool meets(const kg_vec3 p[3], kg_vec3 origin, kg_vec3 direction, double *out_distance,
                  double out_weights[3]) {
    kg_vec3 a = kg_sub(p[1], p[0]), b = kg_sub(p[2], p[0]), h = kg_cross(direction, b);
    double det = kg_dot(a, h);
    if (fabs(det) <= 1e-12 * kg_len(a) * kg_len(b))
        return false;
    kg_vec3 s = kg_sub(origin, p[0]), q = kg_cross(s, a);
    double u = kg_dot(s, h) / det, v = kg_dot(direction, q) / det;
    *out_distance = kg_dot(b, q) / det;
    out_weights[0] = 1 - u - v;
    out_weights[1] = u;
    out_weights[2] = v;
    return u >= 0 && v >= 0 && u + v <= 1 && *out_distance > 0;
}

static bool hit_loop(const kg_sheets *s, int32_t loop, kg_vec3 origin, kg_vec3 direction,
                     kg_sheet_hit *out) {
    const kg_origami_state *state = s->state;
    int32_t first = state->loops.items[loop].first, corners[3] = {first, next_half(state, first)};
    double w[3];
    for (; (corners[2] = next_half(state, corners[1])) != first; corners[1] = corners[2]) {
        kg_vec3 p[3] = {s->drawn[corners[0]], s->drawn[corners[1]], s->drawn[corners[2]]};
        if (!meets(p, origin, direction, &out->distance, w))
            continue;
        out->loop = loop;
        out->front = kg_dot(s->normals[loop], direction) < 0;
        out->drawn = kg_madd(origin, out->distance, direction);
        out->position = kg_v3(0, 0, 0);
        out->paper = kg_v2(0, 0);
        for (int k = 0; k < 3; k++) {
            int32_t v = state->halves.items[corners[k]].origin;
            out->position = kg_madd(out->position, w[k], s->positions[v]);
            out->paper = kg_add2(out->paper, kg_scale2(state->vertices.items[v].paper, w[k]));
        }
        return true;
    }
    return false;
}

size_t kg_sheets_hit(const kg_editor *e, kg_vec2 px, kg_sheet_hit *out_hits, size_t most) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_vec3 origin, direction;
    size_t count = 0;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    for (int32_t i = 0; s->state && (size_t)i < s->state->loops.count; i++) {
        kg_sheet_hit hit;
        if (!hit_loop(s, i, origin, direction, &hit))
            continue;
        count = kg_hits_keep(out_hits, count, most, &hit, sizeof hit);
    }
    return count;
}

/* Whether paper lies between the eye and a drawn point. */
static bool is_hidden(const kg_editor *e, kg_vec2 px, kg_vec3 point) {
    const kg_sheets *s = kg_sheets_of(e);
    kg_sheet_hit hit;
    kg_vec3 origin, direction;
    if (s->opacity < 1 || kg_sheets_hit(e, px, &hit, 1) == 0)
        return false;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    return hit.distance < kg_dot(kg_sub(point, origin), direction) - COVER * s->state->size;
}

/* What two candidates differ in: seen, nearer to the pointer by a pixel or more, nearer to the eye.
 */
typedef struct candidate {
    bool hidden;
    double px, depth;
} candidate;

static bool is_better(candidate a, candidate b) {
    if (a.hidden != b.hidden)
        return b.hidden;
    if (fabs(a.px - b.px) >= 1)
        return a.px < b.px;
    return a.depth < b.depth;
}

static double depth_of(const kg_editor *e, kg_vec3 point) {
    kg_vec3 right, up, back;
    kg_camera_axes(&e->pane.camera, &right, &up, &back);
    return -kg_dot(point, back);
}

bool kg_sheets_nearest_vertex(const kg_editor *e, kg_vec2 px, double radius_px,
                              kg_sheet_corner *out) {
    const kg_sheets *s = kg_sheets_of(e);
    candidate best = {true, INFINITY, INFINITY};
    bool found = false;
    for (int32_t h = 0; s->state && (size_t)h < s->state->halves.count; h++) {
        const kg_half_edge *half = &s->state->halves.items[h];
        kg_vec2 at;
        if (half->loop < 0 || !kg_pane_project(&e->pane, s->drawn[h], &at) ||
            kg_dist2(at, px) > radius_px)
            continue;
        candidate c = {is_hidden(e, at, s->drawn[h]), kg_dist2(at, px), depth_of(e, s->drawn[h])};
        if (found && !is_better(c, best))
            continue;
        best = c;
        found = true;
        *out = (kg_sheet_corner){half->origin, h, half->loop, s->drawn[h], c.px, c.hidden};
    }
    return found;
}

bool kg_sheets_nearest_edge(const kg_editor *e, kg_vec2 px, double radius_px, kg_sheet_side *out) {
    const kg_sheets *s = kg_sheets_of(e);
    candidate best = {true, INFINITY, INFINITY};
    bool found = false;
    for (int32_t h = 0; s->state && (size_t)h < s->state->halves.count; h++) {
        const kg_half_edge *half = &s->state->halves.items[h];
        kg_vec2 a, b;
        if (half->loop < 0 || s->state->edges.items[h / 2].kind == KG_PAPER_JOIN)
            continue;
        kg_vec3 p = s->drawn[h], q = s->drawn[half->next];
        if (!kg_pane_project(&e->pane, p, &a) || !kg_pane_project(&e->pane, q, &b))
            continue;
        double t, distance = kg_segment_distance(px, a, b, &t);
        if (distance > radius_px)
            continue;
        kg_vec3 drawn = kg_lerp(p, q, t);
        candidate c = {is_hidden(e, kg_lerp2(a, b, t), drawn), distance, depth_of(e, drawn)};
        if (found && !is_better(c, best))
            continue;
        best = c;
        found = true;
        kg_vec3 position = kg_lerp(s->positions[half->origin],
                                   s->positions[s->state->halves.items[half->next].origin], t);
        *out = (kg_sheet_side){h / 2, h, half->loop, t, drawn, position, c.px, c.hidden};
    }
    return found;
}
