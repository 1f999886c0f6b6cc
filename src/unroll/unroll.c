#include "katagami/unroll.h"

#include "base/array.h"
#include "unroll/piece.h"

#include <stdlib.h>
#include <string.h>

/* Where the outline turns by less than this (radians) at a joint, it is smooth to the eye and to a
 * blade, and is fitted as one curve. */
#define SMOOTH 0.02

typedef struct outline {
    kg_vec2 *points;
    unsigned char *corners;
    size_t count, capacity;
} outline;

/* Paper coordinates of the printed side: flipping a patch mirrors x and nothing else. */
static kg_vec2 on_paper(const kg_patch *p, double u, double v) {
    kg_vec2 q = kg_patch_unroll(p, u, v);
    if (p->flip)
        q.x = -q.x;
    return q;
}

static kg_vec2 paper_direction(const kg_patch *p, const kg_cross_point *at,
                               const kg_cross_point *slope) {
    kg_vec2 du, dv;
    kg_patch_unroll_derivatives(p, at->u, at->v, &du, &dv);
    return kg_add2(kg_scale2(du, slope->u), kg_scale2(dv, slope->v));
}

static bool turns(kg_vec2 in, kg_vec2 out) {
    return fabs(atan2(kg_cross2(in, out), kg_dot2(in, out))) > SMOOTH;
}

/* Does the outline break at the start of an edge? */
static bool breaks_at_joint(const kg_pieces *all, size_t piece, size_t loop, size_t edge) {
    const kg_region_loop *l = &all->items[piece].region->loops[loop];
    const kg_patch *p = &all->items[piece].patch->patch;
    size_t before = (edge + l->edge_count - 1) % l->edge_count;
    kg_cross_point slope, at;
    at = kg_piece_point(all, piece, loop, before, (double)l->edges[before].count, &slope);
    kg_vec2 in = paper_direction(p, &at, &slope);
    at = kg_piece_point(all, piece, loop, edge, 0, &slope);
    return turns(in, paper_direction(p, &at, &slope));
}

/* Does a contour break at its point i? Its sides are straight in (u,v). */
static bool breaks_at_corner(const kg_patch *p, const kg_region_loop *l, const kg_region_edge *e,
                             size_t i) {
    kg_cross_point a = kg_region_edge_point(l, e, i - 1), b = kg_region_edge_point(l, e, i),
                   c = kg_region_edge_point(l, e, i + 1);
    kg_cross_point in = {.u = b.u - a.u, .v = b.v - a.v}, out = {.u = c.u - b.u, .v = c.v - b.v};
    return turns(paper_direction(p, &b, &in), paper_direction(p, &b, &out));
}

static kg_status add_point(outline *o, kg_vec2 at, bool corner) {
    size_t capacity = o->capacity;
    if (!kg_reserve_bytes((void **)&o->points, &capacity, o->count + 1, sizeof at) ||
        !kg_reserve_bytes((void **)&o->corners, &o->capacity, o->count + 1, 1))
        return KG_ERR_MEMORY;
    if (o->capacity > capacity)
        o->capacity = capacity;
    o->points[o->count] = at;
    o->corners[o->count++] = corner;
    return KG_OK;
}

/* ---- parts ------------------------------------------------------------------------------ */

/* Adds the inner points of an edge and its start, with the ends of its stretches among them. */
static kg_status add_edge(kg_pieces *all, size_t piece, size_t loop, size_t edge, outline *o) {
    const kg_region_loop *l = &all->items[piece].region->loops[loop];
    const kg_region_edge *e = &l->edges[edge];
    const kg_patch *p = &all->items[piece].patch->patch;
    double position = 0;
    while (position < (double)e->count) {
        double next = floor(position) + 1;
        for (size_t i = 0; i < all->stretch_count; i++) {
            kg_stretch *s = &all->stretches[i];
            if (s->piece != piece || s->loop != loop || s->edge != edge)
                continue;
            if (s->from == position)
                s->first = o->count;
            if (s->from > position)
                next = fmin(next, s->from);
            if (s->to > position)
                next = fmin(next, s->to);
            if (s->from <= position && position <= s->to)
                s->count++;
        }
        bool whole = position == floor(position), corner = false;
        if (position == 0)
            corner = breaks_at_joint(all, piece, loop, edge);
        else if (whole && e->kind == KG_EDGE_CONTOUR)
            corner = breaks_at_corner(p, l, e, (size_t)position);
        kg_cross_point at = kg_piece_point(all, piece, loop, edge, position, NULL);
        kg_status status = add_point(o, on_paper(p, at.u, at.v), corner);
        if (status)
            return status;
        position = next;
    }
    /* stretches that run to the edge's end include the next edge's first point */
    for (size_t i = 0; i < all->stretch_count; i++) {
        kg_stretch *s = &all->stretches[i];
        s->count +=
            s->piece == piece && s->loop == loop && s->edge == edge && s->to == (double)e->count;
    }
    return KG_OK;
}

/* A mirrored outline runs the other way round: turned back, with the stretches. */
static void reverse(kg_pieces *all, size_t piece, size_t loop, outline *o) {
    for (size_t i = 0, j = o->count - 1; i < j; i++, j--) {
        kg_vec2 p = o->points[i];
        unsigned char c = o->corners[i];
        o->points[i] = o->points[j], o->corners[i] = o->corners[j];
        o->points[j] = p, o->corners[j] = c;
    }
    for (size_t i = 0; i < all->stretch_count; i++) {
        kg_stretch *s = &all->stretches[i];
        if (s->piece == piece && s->loop == loop)
            s->first = (2 * o->count - s->first - s->count) % o->count;
    }
}

static kg_status add_loop(kg_pieces *all, size_t piece, size_t loop, kg_net *net, kg_error *error) {
    const kg_region_loop *l = &all->items[piece].region->loops[loop];
    outline o = {0};
    kg_status status = KG_OK;
    for (size_t e = 0; e < l->edge_count && !status; e++)
        status = add_edge(all, piece, loop, e, &o);
    if (!status && all->items[piece].patch->patch.flip)
        reverse(all, piece, loop, &o);
    if (!status)
        status = kg_net_add_loop(net, piece, o.points, o.corners, o.count, error);
    free(o.points);
    free(o.corners);
    return status;
}

static void measure_part(const kg_pieces *all, size_t piece, kg_net_part *part) {
    const kg_piece *p = &all->items[piece];
    for (size_t k = 0; k < p->region->loop_count; k++)
        for (size_t e = 0; e < p->region->loops[k].edge_count; e++) {
            const kg_region_loop *l = &p->region->loops[k];
            kg_measure m = kg_region_edge_measure(&p->patch->patch, l, &l->edges[e],
                                                  kg_piece_cutter(all, &l->edges[e]), 0,
                                                  (double)l->edges[e].count);
            part->surface += m.space_moment;
            part->area += m.paper_moment;
            part->perimeter += m.paper_length;
            part->isometry_error =
                fmax(part->isometry_error, fabs(m.paper_length - m.space_length) / m.space_length);
        }
}

static kg_status add_part(kg_pieces *all, size_t piece, kg_net *net, kg_error *error) {
    const kg_piece *p = &all->items[piece];
    size_t index;
    kg_status status = kg_net_add_part(net, p->patch->id, p->model->name, &index, error);
    for (size_t k = 0; k < p->region->loop_count && !status; k++)
        status = add_loop(all, piece, k, net, error);
    if (!status)
        measure_part(all, piece, &net->parts[index]);
    return status;
}

/* ---- joins ------------------------------------------------------------------------------ */

/* How a tab on a stretch folds from its part's plane onto the other part, at one point of it.
 * `lean`: the direction it had on the other part at the point before, zero at the first. */
static double fold_at(const kg_pieces *all, const kg_stretch *s, double position, kg_vec3 *lean) {
    const kg_patch *a = &all->items[s->piece].patch->patch;
    const kg_patch *b = &all->items[s->partner].patch->patch;
    kg_cross_point slope, at = kg_piece_point(all, s->piece, s->loop, s->edge, position, &slope);
    kg_vec3 along = kg_unit(slope.x), front = kg_patch_normal(a, at.v);
    /* paper lies on the left of the loop in the (u,v) plane, which is seen from the back of an
     * unflipped patch */
    kg_vec3 out = kg_scale(kg_cross(front, along), a->flip ? -1 : 1);
    kg_vec3 onto = kg_unit(kg_cross(kg_patch_normal(b, at.t), along));
    double sign;
    if (s->mate != (size_t)(s - all->stretches)) {
        /* into the mate's paper: left of its own direction */
        sign = (b->flip ? 1 : -1) * (s->mate_reversed ? -1 : 1);
    } else if (kg_dot(*lean, *lean) > 0) {
        sign = kg_dot(onto, *lean) < 0 ? -1 : 1;
    } else {
        sign = kg_dot(onto, out) < 0 ? -1 : 1;
    }
    *lean = onto = kg_scale(onto, sign);
    return atan2(kg_dot(onto, front), kg_dot(onto, out));
}

static double fold_of(const kg_pieces *all, const kg_stretch *s) {
    enum { SAMPLES = 8 };
    kg_vec3 lean = kg_v3(0, 0, 0);
    double largest = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double f = (i + 0.5) / SAMPLES;
        double angle = fold_at(all, s, s->from + f * (s->to - s->from), &lean);
        if (fabs(angle) > fabs(largest))
            largest = angle;
    }
    return largest;
}

static kg_net_side outline_side(const kg_pieces *all, const kg_stretch *s) {
    const kg_piece *p = &all->items[s->piece];
    const kg_region_loop *l = &p->region->loops[s->loop];
    const kg_region_edge *e = &l->edges[s->edge];
    return (kg_net_side){.part = (int)s->piece,
                         .loop = (int)s->loop,
                         .first = s->first,
                         .count = s->count,
                         .line = -1,
                         .length = kg_region_edge_measure(&p->patch->patch, l, e,
                                                          kg_piece_cutter(all, e), s->from, s->to)
                                       .paper_length};
}

/* Length on paper of a stretch's curve drawn on its partner. */
static double mark_length(const kg_pieces *all, const kg_stretch *s) {
    const kg_piece *p = &all->items[s->piece];
    const kg_region_loop *l = &p->region->loops[s->loop];
    const kg_patch *b = &all->items[s->partner].patch->patch;
    /* the same points with the roles of the patches exchanged */
    const kg_region_edge *e = &l->edges[s->edge];
    double sum = 0;
    for (size_t i = (size_t)floor(s->from); (double)i < s->to; i++) {
        double lo = fmax(s->from, (double)i), hi = fmin(s->to, (double)i + 1);
        kg_cross_point span[2] = {kg_region_edge_point(l, e, i), kg_region_edge_point(l, e, i + 1)};
        for (int k = 0; k < 2; k++) {
            kg_cross_point q = span[k];
            span[k] = (kg_cross_point){q.s, q.t, q.u, q.v, q.x};
        }
        kg_region_loop loop = {.point_count = 2, .points = span, .edge_count = 1};
        kg_region_edge edge = {KG_EDGE_CUT, p->patch->id, 0, 1};
        loop.edges = &edge;
        loop.ends = &span[1];
        sum += kg_region_edge_measure(b, &loop, &edge, &p->patch->patch, lo - (double)i,
                                      hi - (double)i)
                   .paper_length;
    }
    return sum;
}

/* Draws a stretch's curve on its partner. */
static kg_status add_mark(const kg_pieces *all, const kg_stretch *s, kg_net *net, int join,
                          size_t *out_line, kg_error *error) {
    const kg_patch *b = &all->items[s->partner].patch->patch;
    outline o = {0};
    kg_status status = KG_OK;
    for (double position = s->from; !status;) {
        kg_cross_point at = kg_piece_point(all, s->piece, s->loop, s->edge, position, NULL);
        status = add_point(&o, on_paper(b, at.s, at.t), position == s->from || position == s->to);
        if (position == s->to)
            break;
        position = fmin(floor(position) + 1, s->to);
    }
    kg_net_line line = {.kind = KG_NET_MARK,
                        .count = o.count,
                        .points = o.points,
                        .corners = o.corners,
                        .contact = all->items[s->piece].patch->id,
                        .join = join};
    if (!status)
        status = kg_net_add_line(net, s->partner, &line, out_line, error);
    free(o.points);
    free(o.corners);
    return status;
}

/* Turning in space from the stretch's start to each of its points, in the order of the net. */
static kg_status bends_of(const kg_pieces *all, const kg_stretch *s, double **out) {
    double *bends = calloc(s->count, sizeof *bends);
    if (!bends)
        return KG_ERR_MEMORY;
    kg_vec3 before = kg_v3(0, 0, 0);
    double position = s->from, sum = 0;
    for (size_t i = 0; i < s->count; i++) {
        kg_cross_point slope;
        kg_piece_point(all, s->piece, s->loop, s->edge, position, &slope);
        kg_vec3 along = kg_unit(slope.x);
        if (i > 0)
            sum += atan2(kg_len(kg_cross(before, along)), kg_dot(before, along));
        bends[i] = sum;
        before = along;
        position = fmin(floor(position) + 1, s->to);
    }
    if (all->items[s->piece].patch->patch.flip)
        for (size_t i = 0, j = s->count - 1; i <= j; i++, j--) {
            double a = sum - bends[i], b = sum - bends[j];
            bends[i] = b, bends[j] = a;
            if (j == 0)
                break;
        }
    *out = bends;
    return KG_OK;
}

static kg_status add_join(const kg_pieces *all, size_t index, kg_unrolled *out, kg_error *error) {
    const kg_stretch *s = &all->stretches[index];
    bool seam = s->mate != index;
    if (seam && s->mate < index)
        return KG_OK;
    int number = (int)out->net->join_count;
    kg_net_join join = {
        .kind = seam ? KG_JOIN_SEAM : KG_JOIN_CONTACT,
        .sides = {outline_side(all, s), {0}},
        .sources = {all->items[s->piece].patch->id, all->items[s->partner].patch->id},
        .fold = {fold_of(all, s), 0}};
    double **bends = &out->bends[2 * (size_t)number];
    kg_status status = bends_of(all, s, &bends[0]);
    if (seam) {
        const kg_stretch *mate = &all->stretches[s->mate];
        join.sides[1] = outline_side(all, mate);
        join.sides[1].reversed = s->mate_reversed ^ all->items[s->piece].patch->patch.flip ^
                                 all->items[s->partner].patch->patch.flip;
        join.fold[1] = fold_of(all, mate);
        if (!status)
            status = bends_of(all, mate, &bends[1]);
    } else {
        size_t line = 0;
        if (!status)
            status = add_mark(all, s, out->net, number, &line, error);
        join.sides[1] = (kg_net_side){.part = (int)s->partner,
                                      .loop = -1,
                                      .line = (int)line,
                                      .length = mark_length(all, s),
                                      .reversed = all->items[s->piece].patch->patch.flip};
    }
    if (!status)
        status = kg_net_add_join(out->net, &join, NULL, error);
    return status;
}

kg_status kg_unroll(const kg_model *model, const kg_solution *solution, kg_unrolled **out_unrolled,
                    kg_error *error) {
    kg_pieces all = {0};
    kg_unrolled *out = calloc(1, sizeof *out);
    kg_status status = out && (out->net = kg_net_create()) ? KG_OK : KG_ERR_MEMORY;
    if (!status)
        status = kg_pieces_create(model, solution, &all);
    if (!status)
        status = kg_pieces_find_stretches(&all);
    for (size_t i = 0; i < all.count && !status; i++)
        status = add_part(&all, i, out->net, error);
    if (!status) {
        out->bend_count = 2 * all.stretch_count;
        out->bends = calloc(out->bend_count + 1, sizeof *out->bends);
        free(out->net->title);
        out->net->title = strdup(model->title);
        status = out->bends && out->net->title ? KG_OK : KG_ERR_MEMORY;
    }
    for (size_t i = 0; i < all.stretch_count && !status; i++)
        status = add_join(&all, i, out, error);
    kg_pieces_clear(&all);
    if (status) {
        kg_unrolled_destroy(out);
        return kg_fail(error, status, "out of memory");
    }
    *out_unrolled = out;
    return KG_OK;
}

void kg_unrolled_destroy(kg_unrolled *unrolled) {
    if (!unrolled)
        return;
    for (size_t i = 0; i < unrolled->bend_count && unrolled->bends; i++)
        free(unrolled->bends[i]);
    free(unrolled->bends);
    kg_net_destroy(unrolled->net);
    free(unrolled);
}
