#include "origami/outline.h"

#include "origami/convex.h"

#include <stdlib.h>
#include <string.h>

/* Turns a loop's corners counter-clockwise and measures it. */
static void measure(kg_outlines *o, size_t i, double touch) {
    kg_vec2 *p = o->points + o->starts[i];
    kg_outline_side *sides = o->sides + o->starts[i];
    size_t count = o->starts[i + 1] - o->starts[i];
    o->facing[i] = kg_polygon_area(p, count) >= 0 ? 1 : -1;
    for (size_t a = 0, b = count - 1; o->facing[i] < 0 && a < b; a++, b--) {
        kg_vec2 swap = p[a];
        p[a] = p[b], p[b] = swap;
    }
    o->boxes[i] = kg_box2_empty();
    for (size_t k = 0; k < count; k++) {
        kg_box2_add(&o->boxes[i], p[k]);
        o->middles[i] = kg_add2(o->middles[i], kg_scale2(p[k], 1 / (double)count));
        kg_vec2 d = kg_sub2(p[k + 1 < count ? k + 1 : 0], p[k]);
        double length = kg_len2(d);
        kg_vec2 inward = kg_scale2(kg_v2(-d.y, d.x), 1 / length);
        sides[k] = length > touch ? (kg_outline_side){inward, kg_dot2(inward, p[k])}
                                  : (kg_outline_side){kg_v2(0, 0), -INFINITY};
    }
}

static double depth(const kg_outline_side *side, kg_vec2 p) {
    return kg_dot2(side->inward, p) - side->offset;
}

/* The point is inside a loop, farther than `tolerance` from every side. */
static bool holds(const kg_outlines *o, int32_t loop, kg_vec2 p, double tolerance) {
    const kg_outline_side *sides = o->sides + o->starts[loop];
    size_t n = kg_outline_size(o, loop), i = 0;
    while (i < n && depth(&sides[i], p) > tolerance)
        i++;
    return i == n;
}

kg_status kg_outlines_create(const kg_origami_state *s, kg_outlines *out) {
    size_t n = s->loops.count;
    kg_outlines o = {.starts = calloc(n + 1, sizeof *o.starts),
                     .points = malloc((s->halves.count + 1) * sizeof *o.points),
                     .sides = malloc((s->halves.count + 1) * sizeof *o.sides),
                     .boxes = malloc((n + 1) * sizeof *o.boxes),
                     .middles = calloc(n + 1, sizeof *o.middles),
                     .probes = calloc(n + 1, sizeof *o.probes),
                     .facing = calloc(n + 1, 1)};
    if (!o.starts || !o.points || !o.sides || !o.boxes || !o.middles || !o.probes || !o.facing) {
        kg_outlines_clear(&o);
        return KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < n; i++) {
        kg_vec3 u, v;
        kg_plane_axes(s->groups.items[s->loops.items[i].group].normal, &u, &v);
        o.starts[i + 1] =
            o.starts[i] + kg_state_polygon(s, (int32_t)i, &u, &v, o.points + o.starts[i]);
        measure(&o, i, s->touch);
    }
    *out = o;
    return KG_OK;
}

void kg_outlines_clear(kg_outlines *o) {
    free(o->starts);
    free(o->points);
    free(o->sides);
    free(o->boxes);
    free(o->middles);
    free(o->probes);
    free(o->facing);
    *o = (kg_outlines){0};
}

/* Probes are middles of loops: most of them where most loops lie. */
void kg_outlines_probe(kg_outlines *o, const kg_origami_state *s) {
    size_t loops = s->loops.count, count = loops < KG_PROBES ? loops : KG_PROBES;
    for (size_t k = 0; k < count; k++) {
        kg_vec2 p = o->middles[k * loops / count];
        for (size_t i = 0; i < loops; i++) {
            const kg_box2 *box = &o->boxes[i];
            if (p.x > box->lo.x && p.x < box->hi.x && p.y > box->lo.y && p.y < box->hi.y &&
                holds(o, (int32_t)i, p, s->touch))
                o->probes[i].words[k / 64] |= (uint64_t)1 << k % 64;
        }
    }
}

/* Some side of loop a has all of b on its outside, or less than `tolerance` deep inside. */
static bool side_separates(const kg_outlines *o, int32_t a, int32_t b, double tolerance) {
    const kg_outline_side *sides = o->sides + o->starts[a];
    const kg_vec2 *q = kg_outline_points(o, b);
    size_t sides_count = kg_outline_size(o, a), count = kg_outline_size(o, b);
    for (size_t i = 0; i < sides_count; i++) {
        size_t k = 0;
        while (k < count && depth(&sides[i], q[k]) <= tolerance)
            k++;
        if (k == count)
            return true;
    }
    return false;
}

bool kg_outlines_meet(const kg_outlines *o, int32_t a, int32_t b, double tolerance) {
    return !side_separates(o, a, b, tolerance) && !side_separates(o, b, a, tolerance);
}

/* ---- orders ----------------------------------------------------------------------------- */

kg_status kg_layer_rows_create(const kg_origami_state *s, const kg_outlines *o,
                               kg_layer_rows *out) {
    size_t n = s->loops.count, pairs = s->orders.count;
    kg_layer_rows r = {calloc(n + 2, sizeof *r.starts),
                       malloc((2 * pairs + 1) * sizeof *r.entries)};
    if (!r.starts || !r.entries) {
        kg_layer_rows_clear(&r);
        return KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < pairs; i++) {
        r.starts[s->orders.items[i].a + 2]++;
        r.starts[s->orders.items[i].b + 2]++;
    }
    for (size_t i = 2; i < n + 2; i++)
        r.starts[i] += r.starts[i - 1];
    /* Orders are sorted: first what is smaller than a loop, then what is greater, each by number.
     */
    for (size_t i = 0; i < pairs; i++) {
        const kg_layer_order *p = &s->orders.items[i];
        r.entries[r.starts[p->b + 1]++] = 2 * p->a + (p->side != o->facing[p->a]);
    }
    for (size_t i = 0; i < pairs; i++) {
        const kg_layer_order *p = &s->orders.items[i];
        r.entries[r.starts[p->a + 1]++] = 2 * p->b + (p->side == o->facing[p->a]);
    }
    *out = r;
    return KG_OK;
}

void kg_layer_rows_clear(kg_layer_rows *r) {
    free(r->starts);
    free(r->entries);
    *r = (kg_layer_rows){0};
}

kg_status kg_orders_add(kg_origami_state *s, const kg_outlines *o, int32_t a, int32_t b,
                        int above) {
    kg_layer_order order = a < b ? (kg_layer_order){a, b, above * o->facing[a]}
                                 : (kg_layer_order){b, a, -above * o->facing[b]};
    return kg_push(&s->orders, order) ? KG_OK : KG_ERR_MEMORY;
}

kg_status kg_orders_sort(kg_origami_state *s) {
    size_t n = s->orders.count, loops = s->loops.count;
    kg_layer_order *other = malloc((n + 1) * sizeof *other);
    size_t *starts = malloc((loops + 1) * sizeof *starts);
    if (!other || !starts) {
        free(other);
        free(starts);
        return KG_ERR_MEMORY;
    }
    for (int pass = 0; pass < 2; pass++) { /* stable: by b, then by a */
        const kg_layer_order *from = pass ? other : s->orders.items;
        kg_layer_order *to = pass ? s->orders.items : other;
        memset(starts, 0, (loops + 1) * sizeof *starts);
        for (size_t i = 0; i < n; i++)
            starts[(pass ? from[i].a : from[i].b) + 1]++;
        for (size_t i = 1; i <= loops; i++)
            starts[i] += starts[i - 1];
        for (size_t i = 0; i < n; i++)
            to[starts[pass ? from[i].a : from[i].b]++] = from[i];
    }
    free(other);
    free(starts);
    return KG_OK;
}
