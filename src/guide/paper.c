/* Painting the pictures of a folding sequence. */
#include "guide/diagram.h"

#include <stdlib.h>

/* mm on the page from one layer to the next, and of all layers together at most. */
#define LAYER_GAP 0.3
#define MOST_GAP 1.6
/* How a layer is shifted on the page, over its height: to the upper right. */
static const kg_vec2 shear = {0.75, 0.9};

typedef struct view {
    const kg_diagram *diagram;
    kg_moment moment;
    double thickness;
    kg_vec3 *normals; /* of the fronts of loops */
} view;

static kg_vec3 loop_normal(const kg_moment *m, size_t loop) {
    const kg_origami_state *s = m->topology;
    int32_t first = s->loops.items[loop].first, h = first;
    kg_vec3 sum = kg_v3(0, 0, 0), o = m->positions[s->halves.items[first].origin];
    do {
        int32_t next = s->halves.items[h].next;
        sum = kg_add(sum, kg_cross(kg_sub(m->positions[s->halves.items[h].origin], o),
                                   kg_sub(m->positions[s->halves.items[next].origin], o)));
        h = next;
    } while (h != first);
    return kg_unit(sum);
}

/* Where the origin of a half-edge is seen in its layer. */
static kg_vec3 corner(const view *v, int32_t half) {
    const kg_moment *m = &v->moment;
    const kg_half_edge *h = &m->topology->halves.items[half];
    const kg_diagram *d = v->diagram;
    int32_t group = m->layers->loops.items[m->parents[h->loop]].group;
    double lift = v->thickness * m->heights[half];
    kg_vec3 p = kg_madd(m->positions[h->origin], lift, m->layers->groups.items[group].normal);
    kg_vec3 out = kg_v3(kg_dot(d->right, p), kg_dot(d->up, p), kg_dot(d->back, p));
    if (!d->oblique) {
        double near = lift * kg_dot(m->layers->groups.items[group].normal, d->back);
        out.x += shear.x * near;
        out.y += shear.y * near;
    }
    return out;
}

static kg_side_look look_of(const view *v, int32_t half) {
    const kg_moment *m = &v->moment;
    const kg_origami_state *s = m->topology;
    int32_t x = s->halves.items[half].loop, y = s->halves.items[half ^ 1].loop;
    if (y < 0)
        return KG_SIDE_OUTLINE;
    if (m->moves[x] != m->moves[y])
        return v->diagram->behind ? KG_SIDE_MOUNTAIN : KG_SIDE_VALLEY;
    if (kg_dot(v->normals[x], v->normals[y]) < 1 - 1e-9)
        return KG_SIDE_OUTLINE;
    return s->edges.items[half / 2].kind == KG_PAPER_JOIN ? KG_SIDE_NONE : KG_SIDE_CREASE;
}

/* Slanting paper is a little darker. */
static uint32_t shade(uint32_t color, double light) {
    uint32_t out = 0;
    for (int shift = 0; shift <= 16; shift += 8)
        out |= (uint32_t)lround((double)(color >> shift & 255) * light) << shift;
    return out;
}

static kg_status add_loop(const view *v, size_t loop, kg_figure *f) {
    const kg_origami_state *s = v->moment.topology;
    int32_t first = s->loops.items[loop].first, h = first;
    size_t n = 0;
    uint32_t front, back;
    do
        n++;
    while ((h = s->halves.items[h].next) != first);
    kg_vec3 *points = malloc(n * sizeof *points);
    unsigned char *looks = malloc(n);
    kg_status status = points && looks ? KG_OK : KG_ERR_MEMORY;
    for (size_t i = 0; i < n && !status; i++, h = s->halves.items[h].next) {
        points[i] = corner(v, h);
        looks[i] = (unsigned char)look_of(v, h);
    }
    kg_origami_colors(v->diagram->origami, s->loops.items[loop].sheet, &front, &back);
    double facing = kg_dot(v->normals[loop], v->diagram->back);
    if (!status)
        status = kg_figure_add(f, points, looks, n,
                               shade(facing > 0 ? front : back, 0.78 + 0.22 * fabs(facing)),
                               (int32_t)loop);
    free(points);
    free(looks);
    return status;
}

/* The paper around a fold between layers that are drawn apart. */
static kg_status add_spine(const view *v, size_t edge, kg_figure *f) {
    static const unsigned char looks[4] = {KG_SIDE_NONE, KG_SIDE_OUTLINE, KG_SIDE_NONE,
                                           KG_SIDE_OUTLINE};
    const kg_origami_state *s = v->moment.topology;
    int32_t h = (int32_t)(2 * edge), x = s->halves.items[h].loop, y = s->halves.items[h + 1].loop;
    if (x < 0 || y < 0)
        return KG_OK;
    kg_vec3 points[4] = {corner(v, h), corner(v, s->halves.items[h].next), corner(v, h + 1),
                         corner(v, s->halves.items[h + 1].next)};
    if (kg_dist(points[0], points[3]) + kg_dist(points[1], points[2]) < 0.1 * v->thickness)
        return KG_OK;
    uint32_t front, back;
    kg_origami_colors(v->diagram->origami, s->loops.items[x].sheet, &front, &back);
    return kg_figure_add(f, points, looks, 4,
                         shade(s->edges.items[edge].angle > 0 ? back : front, 0.82), -1);
}

/* Loops of one plane lie as their order says, whatever their heights. */
static int order_of(const void *user, int32_t a, int32_t b) {
    const view *v = user;
    const kg_moment *m = &v->moment;
    if (a < 0 || b < 0)
        return 0;
    int32_t p = m->parents[a], q = m->parents[b];
    if (p == q || m->layers->loops.items[p].group != m->layers->loops.items[q].group)
        return 0;
    int front = kg_origami_order(m->layers, p, q); /* q on the front of p */
    return kg_dot(v->normals[a], v->diagram->back) > 0 ? -front : front;
}

static kg_status build(const view *v, kg_figure *f) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < v->moment.topology->loops.count && !status; i++)
        status = add_loop(v, i, f);
    for (size_t e = 0; e < v->moment.topology->edges.count && !status; e++)
        status = add_spine(v, e, f);
    return status ? status : kg_figure_sort(f, order_of, v);
}

kg_status kg_diagram_paint(const kg_diagram *d, cairo_t *cr, kg_vec2 at, double scale,
                           kg_error *error) {
    view v = {.diagram = d};
    kg_figure figure = {.shear = d->oblique ? kg_v2(0, 0) : shear};
    kg_status status = kg_moment_create(d->origami, d->step, &v.moment, error);
    if (status)
        return status;
    const kg_origami_state *s = v.moment.topology;
    double highest = 1;
    for (size_t h = 0; h < s->halves.count; h++)
        highest = fmax(highest, v.moment.heights[h]);
    v.thickness = fmin(LAYER_GAP, MOST_GAP / highest) / scale;
    v.normals = calloc(s->loops.count + 1, sizeof *v.normals);
    for (size_t i = 0; i < s->loops.count && v.normals; i++)
        v.normals[i] = loop_normal(&v.moment, i);
    status = v.normals ? build(&v, &figure) : KG_ERR_MEMORY;
    if (!status) {
        kg_vec2 middle = kg_lerp2(d->box.lo, d->box.hi, 0.5),
                offset = kg_v2(at.x - scale * middle.x, at.y + scale * middle.y);
        kg_figure_paint(&figure, cr, scale, offset, d->axis[0]);
    }
    kg_figure_clear(&figure);
    free(v.normals);
    kg_moment_clear(&v.moment);
    return status ? kg_fail(error, status, "out of memory") : KG_OK;
}
