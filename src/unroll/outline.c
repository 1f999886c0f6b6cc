#include "unroll/outline.h"

#include "base/array.h"

#include <stdlib.h>

/* Where the outline turns by less than this (radians) at a joint, it is smooth to the eye and to a
 * blade, and is fitted as one curve. */
#define SMOOTH 0.02

kg_status kg_outline_add(kg_outline *o, kg_vec2 at, bool corner) {
    if (!kg_reserve_bytes((void **)&o->points, &o->point_capacity, o->count + 1, sizeof at) ||
        !kg_reserve_bytes((void **)&o->corners, &o->corner_capacity, o->count + 1, 1))
        return KG_ERR_MEMORY;
    o->points[o->count] = at;
    o->corners[o->count++] = corner;
    return KG_OK;
}

void kg_outline_clear(kg_outline *o) {
    free(o->points);
    free(o->corners);
    *o = (kg_outline){0};
}

kg_vec2 kg_on_paper(const kg_patch *p, double u, double v) {
    kg_vec2 q = kg_patch_unroll(p, u, v);
    if (p->flip)
        q.x = -q.x;
    return q;
}

kg_vec2 kg_paper_direction(const kg_patch *p, double u, double v, double du, double dv) {
    kg_vec2 by_u, by_v;
    kg_patch_unroll_derivatives(p, u, v, &by_u, &by_v);
    kg_vec2 d = kg_add2(kg_scale2(by_u, du), kg_scale2(by_v, dv));
    if (p->flip)
        d.x = -d.x;
    return d;
}

static bool turns(kg_vec2 in, kg_vec2 out) {
    return fabs(atan2(kg_cross2(in, out), kg_dot2(in, out))) > SMOOTH;
}

static kg_vec2 direction_at(const kg_pieces *all, kg_edge_ref edge, double position) {
    kg_cross_point slope, at = kg_piece_point(all, edge, position, &slope);
    return kg_paper_direction(kg_piece_patch(all, edge.piece), at.u, at.v, slope.u, slope.v);
}

/* Does the outline break at the start of an edge? */
static bool breaks_at_joint(const kg_pieces *all, kg_edge_ref edge) {
    size_t edges = kg_piece_loop(all, edge)->edge_count;
    kg_edge_ref before = {edge.piece, edge.loop, (edge.edge + edges - 1) % edges};
    return turns(direction_at(all, before, (double)kg_piece_edge(all, before)->count),
                 direction_at(all, edge, 0));
}

/* Does a contour break at its point i? Its sides are straight in (u,v). */
static bool breaks_at_corner(const kg_pieces *all, kg_edge_ref edge, size_t i) {
    const kg_region_loop *l = kg_piece_loop(all, edge);
    const kg_region_edge *e = kg_piece_edge(all, edge);
    const kg_patch *p = kg_piece_patch(all, edge.piece);
    kg_cross_point a = kg_region_edge_point(l, e, i - 1), b = kg_region_edge_point(l, e, i),
                   c = kg_region_edge_point(l, e, i + 1);
    return turns(kg_paper_direction(p, b.u, b.v, b.u - a.u, b.v - a.v),
                 kg_paper_direction(p, b.u, b.v, c.u - b.u, c.v - b.v));
}

/* Adds the inner points of an edge and its start, with the ends of its stretches among them. */
static kg_status add_edge(kg_pieces *all, kg_edge_ref edge, kg_outline *o) {
    const kg_region_edge *e = kg_piece_edge(all, edge);
    const kg_patch *p = kg_piece_patch(all, edge.piece);
    size_t first, end;
    kg_piece_stretches(all, edge, &first, &end);
    double position = 0, last = (double)e->count;
    while (position < last) {
        double next = floor(position) + 1;
        for (size_t i = first; i < end; i++) {
            kg_stretch *s = &all->stretches[i];
            const double ends[3] = {s->from, s->to, s->to - last};
            for (int k = 0; k < 3; k++)
                if (ends[k] > position)
                    next = fmin(next, ends[k]);
            if (s->from == position)
                s->first = o->count;
            s->count += s->from <= position && position <= s->to;
            /* the edge's end is the next one's first point, and beyond it a closed edge goes on */
            s->count += position + last <= s->to;
        }
        bool corner = false;
        if (position == 0)
            corner = breaks_at_joint(all, edge);
        else if (position == floor(position) && e->kind == KG_EDGE_CONTOUR)
            corner = breaks_at_corner(all, edge, (size_t)position);
        kg_cross_point at = kg_piece_point(all, edge, position, NULL);
        kg_status status = kg_outline_add(o, kg_on_paper(p, at.u, at.v), corner);
        if (status)
            return status;
        position = next;
    }
    return KG_OK;
}

/* A mirrored outline runs the other way round: turned back, with the stretches. */
static void reverse(kg_pieces *all, size_t piece, size_t loop, kg_outline *o) {
    for (size_t i = 0, j = o->count - 1; i < j; i++, j--) {
        kg_vec2 p = o->points[i];
        unsigned char c = o->corners[i];
        o->points[i] = o->points[j], o->corners[i] = o->corners[j];
        o->points[j] = p, o->corners[j] = c;
    }
    for (size_t e = 0; e < all->items[piece].region->loops[loop].edge_count; e++) {
        size_t first, end;
        kg_piece_stretches(all, (kg_edge_ref){piece, loop, e}, &first, &end);
        for (size_t i = first; i < end; i++) {
            kg_stretch *s = &all->stretches[i];
            s->first = (2 * o->count - s->first - s->count) % o->count;
        }
    }
}

kg_status kg_outline_of_loop(kg_pieces *all, size_t piece, size_t loop, kg_outline *out) {
    kg_outline o = {0};
    kg_status status = KG_OK;
    for (size_t e = 0; e < all->items[piece].region->loops[loop].edge_count && !status; e++)
        status = add_edge(all, (kg_edge_ref){piece, loop, e}, &o);
    if (status) {
        kg_outline_clear(&o);
        return status;
    }
    if (kg_piece_patch(all, piece)->flip)
        reverse(all, piece, loop, &o);
    *out = o;
    return KG_OK;
}
