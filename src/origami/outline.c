#include "origami/outline.h"

#include "origami/convex.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_outlines_create(const kg_origami_state *s, kg_outlines *out) {
    size_t n = s->loops.count;
    kg_outlines o = {.starts = calloc(n + 1, sizeof *o.starts),
                     .points = calloc(s->halves.count + 1, sizeof *o.points),
                     .boxes = calloc(n + 1, sizeof *o.boxes),
                     .middles = calloc(n + 1, sizeof *o.middles),
                     .facing = calloc(n + 1, 1)};
    if (!o.starts || !o.points || !o.boxes || !o.middles || !o.facing) {
        kg_outlines_clear(&o);
        return KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < n; i++) {
        kg_vec3 u, v;
        kg_plane_axes(s->groups.items[s->loops.items[i].group].normal, &u, &v);
        kg_vec2 *p = o.points + o.starts[i];
        size_t count = kg_state_polygon(s, (int32_t)i, &u, &v, p);
        o.starts[i + 1] = o.starts[i] + count;
        o.facing[i] = kg_polygon_area(p, count) >= 0 ? 1 : -1;
        for (size_t a = 0, b = count - 1; o.facing[i] < 0 && a < b; a++, b--) {
            kg_vec2 swap = p[a];
            p[a] = p[b], p[b] = swap;
        }
        o.boxes[i] = kg_box2_empty();
        for (size_t k = 0; k < count; k++) {
            kg_box2_add(&o.boxes[i], p[k]);
            o.middles[i] = kg_add2(o.middles[i], kg_scale2(p[k], 1 / (double)count));
        }
    }
    *out = o;
    return KG_OK;
}

void kg_outlines_clear(kg_outlines *o) {
    free(o->starts);
    free(o->points);
    free(o->boxes);
    free(o->middles);
    free(o->facing);
    *o = (kg_outlines){0};
}

bool kg_outlines_overlap(const kg_outlines *o, int32_t a, int32_t b, double tolerance) {
    const kg_box2 *x = &o->boxes[a], *y = &o->boxes[b];
    if (!(x->lo.x + tolerance < y->hi.x && y->lo.x + tolerance < x->hi.x &&
          x->lo.y + tolerance < y->hi.y && y->lo.y + tolerance < x->hi.y))
        return false;
    const kg_vec2 *p = kg_outline_points(o, a), *q = kg_outline_points(o, b);
    size_t n = kg_outline_size(o, a), m = kg_outline_size(o, b);
    /* in a stack most loops hold each other's middles */
    return kg_convex_holds(q, m, o->middles[a], tolerance) ||
           kg_convex_overlap(p, n, q, m, tolerance);
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
