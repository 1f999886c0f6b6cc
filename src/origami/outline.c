#include "origami/outline.h"

#include "origami/convex.h"

#include <stdlib.h>

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

kg_status kg_outlines_create(const kg_origami_state *s, kg_outlines *out) {
    size_t n = s->loops.count;
    kg_outlines o = {.starts = calloc(n + 1, sizeof *o.starts),
                     .points = malloc((s->halves.count + 1) * sizeof *o.points),
                     .sides = malloc((s->halves.count + 1) * sizeof *o.sides),
                     .boxes = malloc((n + 1) * sizeof *o.boxes),
                     .middles = calloc(n + 1, sizeof *o.middles),
                     .facing = calloc(n + 1, 1)};
    if (!o.starts || !o.points || !o.sides || !o.boxes || !o.middles || !o.facing) {
        kg_outlines_clear(&o);
        return KG_ERR_MEMORY;
    }
    kg_vec3 u, v;
    for (size_t i = 0; i < n; i++) {
        int32_t group = s->loops.items[i].group;
        if (i == 0 || group != s->loops.items[i - 1].group)
            kg_plane_axes(s->groups.items[group].normal, &u, &v);
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
    free(o->facing);
    *o = (kg_outlines){0};
}

/* Some side of loop a has all of b on its outside, or less than `tolerance` deep inside. */
static bool side_separates(const kg_outlines *o, int32_t a, int32_t b, double tolerance) {
    const kg_outline_side *sides = o->sides + o->starts[a];
    const kg_vec2 *q = kg_outline_points(o, b);
    size_t sides_count = kg_outline_size(o, a), count = kg_outline_size(o, b);
    for (size_t i = 0; i < sides_count; i++) {
        size_t k = 0;
        while (k < count && kg_outline_depth(&sides[i], q[k]) <= tolerance)
            k++;
        if (k == count)
            return true;
    }
    return false;
}

bool kg_outlines_meet(const kg_outlines *o, int32_t a, int32_t b, double tolerance) {
    return !side_separates(o, a, b, tolerance) && !side_separates(o, b, a, tolerance);
}
