#include "unroll/tick.h"

#include "unroll/outline.h"
#include "unroll/stretch.h"

#include <stdlib.h>

/* Joins longer than this, mm, get ticks, at most SPACING apart. */
#define LONG_JOIN 60.0
#define SPACING 30.0

/* Length of a tick, mm. */
#define TICK 2.0

/* Is a point within the part's contours? By counting the lines to its right. */
static bool part_contains(const kg_net_part *part, kg_vec2 p) {
    bool inside = false;
    for (size_t k = 0; k < part->loop_count; k++) {
        const kg_net_line *l = &part->loops[k].line;
        for (size_t i = 0, j = l->count - 1; i < l->count; j = i++) {
            kg_vec2 a = l->points[j], b = l->points[i];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)))
                inside = !inside;
        }
    }
    return inside;
}

/* Draws a tick unless it leaves the part. */
static kg_status add_tick(kg_net *net, size_t part, kg_vec2 from, kg_vec2 to, int join,
                          kg_error *error) {
    kg_vec2 points[2] = {from, to};
    unsigned char corners[2] = {1, 1};
    kg_net_line line = {
        .kind = KG_NET_MARK, .count = 2, .points = points, .corners = corners, .join = join};
    if (!part_contains(&net->parts[part], to) ||
        !part_contains(&net->parts[part], kg_lerp2(from, to, 0.01)))
        return KG_OK;
    return kg_net_add_line(net, part, &line, NULL, error);
}

/* From an edge into its part, square to the edge. */
static kg_status tick_edge(const kg_pieces *all, kg_edge_ref edge, double position, int join,
                           kg_net *net, kg_error *error) {
    const kg_patch *p = kg_piece_patch(all, edge.piece);
    kg_cross_point slope, at = kg_piece_point(all, edge, position, &slope);
    kg_vec2 d = kg_paper_direction(p, at.u, at.v, slope.u, slope.v);
    /* the paper is on the left of the loop, on the right of a mirrored one */
    kg_vec2 in = kg_scale2(kg_v2(-d.y, d.x), (p->flip ? -TICK : TICK) / kg_len2(d));
    kg_vec2 from = kg_on_paper(p, at.u, at.v);
    return add_tick(net, edge.piece, from, kg_add2(from, in), join, error);
}

/* Across the mark line on the partner. */
static kg_status tick_mark(const kg_pieces *all, const kg_stretch *s, double position, int join,
                           kg_net *net, kg_error *error) {
    const kg_patch *p = kg_piece_patch(all, s->partner.piece);
    kg_cross_point slope, at = kg_piece_point(all, s->edge, position, &slope);
    kg_vec2 d = kg_paper_direction(p, at.s, at.t, slope.s, slope.t);
    kg_vec2 half = kg_scale2(kg_v2(-d.y, d.x), TICK / 2 / kg_len2(d));
    kg_vec2 middle = kg_on_paper(p, at.s, at.t);
    return add_tick(net, s->partner.piece, kg_sub2(middle, half), kg_add2(middle, half), join,
                    error);
}

kg_status kg_ticks_add(const kg_pieces *all, size_t stretch, int join, kg_net *net,
                       kg_error *error) {
    const kg_stretch *s = &all->stretches[stretch], *mate = &all->stretches[s->mate];
    double length = net->joins[join].sides[0].length;
    if (length <= LONG_JOIN)
        return KG_OK;
    int count = (int)ceil(length / SPACING);
    double *own = calloc((size_t)count, sizeof *own), *other = calloc((size_t)count, sizeof *other);
    kg_status status = own && other ? KG_OK : KG_ERR_MEMORY;
    if (!status) {
        kg_stretch_divide(all, s, count, own);
        kg_stretch_divide(all, mate, count, other);
    }
    for (int i = 0; i < count - 1 && !status; i++) {
        status = tick_edge(all, s->edge, own[i], join, net, error);
        if (!status && !s->seam)
            status = tick_mark(all, s, own[i], join, net, error);
        else if (!status)
            status = tick_edge(all, mate->edge, other[s->mate_reversed ? count - 2 - i : i], join,
                               net, error);
    }
    free(own);
    free(other);
    return status;
}
