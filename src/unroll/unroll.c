#include "katagami/unroll.h"

#include "net/settings.h"
#include "unroll/course.h"
#include "unroll/fold.h"
#include "unroll/outline.h"
#include "unroll/stretch.h"
#include "unroll/tick.h"

#include <stdlib.h>
#include <string.h>

/* ---- parts ------------------------------------------------------------------------------ */

static void measure_part(const kg_pieces *all, size_t piece, kg_net_part *part) {
    const kg_region *region = all->items[piece].region;
    for (size_t k = 0; k < region->loop_count; k++)
        for (size_t e = 0; e < region->loops[k].edge_count; e++) {
            kg_measure m = kg_piece_measure(all, (kg_edge_ref){piece, k, e}, 0,
                                            (double)region->loops[k].edges[e].count);
            part->surface += m.space_moment;
            part->area += m.paper_moment;
            part->perimeter += m.paper_length;
            if (m.space_length > 0)
                part->isometry_error = fmax(part->isometry_error,
                                            fabs(m.paper_length - m.space_length) / m.space_length);
        }
}

static kg_status add_part(kg_pieces *all, size_t piece, kg_net *net, kg_error *error) {
    const kg_piece *p = &all->items[piece];
    size_t index;
    kg_status status = kg_net_add_part(net, p->patch->id, p->model->name, &index, error);
    for (size_t k = 0; k < p->region->loop_count && !status; k++) {
        kg_outline o = {0};
        status = kg_outline_of_loop(all, piece, k, &o);
        if (!status)
            status = kg_net_add_loop(net, piece, o.points, o.corners, o.count, error);
        kg_outline_clear(&o);
    }
    if (!status)
        measure_part(all, piece, &net->parts[index]);
    return status;
}

/* ---- joins ------------------------------------------------------------------------------ */

static kg_net_side outline_side(const kg_stretch *s) {
    return (kg_net_side){.part = (int)s->edge.piece,
                         .loop = (int)s->edge.loop,
                         .first = s->first,
                         .count = s->count,
                         .line = -1,
                         .length = s->measure.paper_length};
}

/* Length on paper of a stretch's curve drawn on its partner. */
static double mark_length(const kg_pieces *all, const kg_stretch *s) {
    const kg_solved_patch *a = all->items[s->edge.piece].patch;
    const kg_patch *b = kg_piece_patch(all, s->partner.piece);
    const kg_region_loop *l = kg_piece_loop(all, s->edge);
    const kg_region_edge *e = kg_piece_edge(all, s->edge);
    double sum = 0;
    for (size_t i = (size_t)floor(s->from); (double)i < s->to; i++) {
        double lo = fmax(s->from, (double)i), hi = fmin(s->to, (double)i + 1);
        size_t k0 = i % e->count; /* around a closed edge */
        kg_cross_point span[2] = {kg_region_edge_point(l, e, k0),
                                  kg_region_edge_point(l, e, k0 + 1)};
        for (int k = 0; k < 2; k++) { /* the roles of the patches exchanged */
            kg_cross_point q = span[k];
            span[k] = (kg_cross_point){q.s, q.t, q.u, q.v, q.x};
        }
        kg_region_loop loop = {.point_count = 2, .points = span, .edge_count = 1};
        kg_region_edge edge = {KG_EDGE_CUT, a->id, 0, 1};
        loop.edges = &edge;
        loop.ends = &span[1];
        sum += kg_region_edge_measure(b, &loop, &edge, &a->patch, lo - (double)i, hi - (double)i)
                   .paper_length;
    }
    return sum;
}

/* Draws a stretch's curve on its partner. */
static kg_status add_mark(const kg_pieces *all, const kg_stretch *s, kg_net *net, int join,
                          size_t *out_line, kg_error *error) {
    const kg_patch *b = kg_piece_patch(all, s->partner.piece);
    kg_outline o = {0};
    kg_status status = KG_OK;
    for (double position = s->from; !status;) {
        kg_cross_point at = kg_piece_point(all, s->edge, position, NULL);
        status = kg_outline_add(&o, kg_on_paper(b, at.s, at.t),
                                position == s->from || position == s->to);
        if (position == s->to)
            break;
        position = fmin(floor(position) + 1, s->to);
    }
    kg_net_line line = {.kind = KG_NET_MARK,
                        .count = o.count,
                        .points = o.points,
                        .corners = o.corners,
                        .contact = all->items[s->edge.piece].patch->id,
                        .join = join};
    if (!status)
        status = kg_net_add_line(net, s->partner.piece, &line, out_line, error);
    kg_outline_clear(&o);
    return status;
}

/* The other edge of a seam. */
static kg_status join_edge(const kg_pieces *all, const kg_stretch *s, kg_net_join *join,
                           double **out_bends) {
    const kg_stretch *mate = &all->stretches[s->mate];
    join->kind = KG_JOIN_SEAM;
    join->sides[1] = outline_side(mate);
    join->sides[1].reversed = s->mate_reversed ^ kg_piece_patch(all, s->edge.piece)->flip ^
                              kg_piece_patch(all, mate->edge.piece)->flip;
    join->fold[1] = kg_stretch_fold(all, s->mate);
    return kg_stretch_bends(all, s->mate, out_bends);
}

/* The mark of a contact. */
static kg_status join_mark(const kg_pieces *all, const kg_stretch *s, kg_net *net,
                           kg_net_join *join, kg_error *error) {
    size_t line = 0;
    kg_status status = add_mark(all, s, net, (int)net->join_count, &line, error);
    join->kind = KG_JOIN_CONTACT;
    join->sides[1] = (kg_net_side){.part = (int)s->partner.piece,
                                   .loop = -1,
                                   .line = (int)line,
                                   .length = mark_length(all, s),
                                   .reversed = kg_piece_patch(all, s->edge.piece)->flip};
    return status;
}

/* What the user wishes for a join. */
static void apply_wish(const kg_model_join *wish, kg_net_join *join) {
    bool turned = wish->patches[0] != join->sources[0];
    join->tab_side = turned ? kg_net_tab_turned(wish->tab) : wish->tab;
    join->tab_shape = wish->shape;
    join->tab_width = wish->width;
    if (wish->has_at) {
        join->at_side = wish->patches[0] != join->sources[0];
        join->at = wish->at;
    }
}

static kg_status apply_wishes(const kg_model *model, const kg_solution *solution,
                              kg_unrolled *out) {
    out->wishes = calloc(out->net->join_count + 1, sizeof *out->wishes);
    if (!out->wishes)
        return KG_ERR_MEMORY;
    kg_unroll_wishes(model, solution, out->net, out->wishes);
    for (size_t i = 0; i < out->net->join_count; i++)
        if (out->wishes[i] < model->join_count)
            apply_wish(&model->joins[out->wishes[i]], &out->net->joins[i]);
    return KG_OK;
}

static kg_status add_join(const kg_pieces *all, size_t index, kg_unrolled *out, kg_error *error) {
    const kg_stretch *s = &all->stretches[index];
    size_t number = out->net->join_count;
    if (s->single || (s->mate < index && all->stretches[s->mate].mate == index))
        return KG_OK;
    kg_net_join join = {
        .sides = {outline_side(s), {0}},
        .sources = {all->items[s->edge.piece].patch->id, all->items[s->partner.piece].patch->id},
        .fold = {kg_stretch_fold(all, index), 0}};
    kg_course_of_stretch(all, s, &join);
    double **bends = &out->bends[2 * number];
    kg_status status = kg_stretch_bends(all, index, &bends[0]);
    if (!status)
        status = s->seam ? join_edge(all, s, &join, &bends[1])
                         : join_mark(all, s, out->net, &join, error);
    if (!status)
        status = kg_net_add_join(out->net, &join, NULL, error);
    if (!status)
        status = kg_ticks_add(all, index, (int)number, out->net, error);
    return status;
}

kg_status kg_unroll(const kg_model *model, const kg_solution *solution, kg_unrolled **out_unrolled,
                    kg_error *error) {
    return kg_unroll_to_fit(model, solution, kg_v2(0, 0), out_unrolled, error);
}

kg_status kg_unroll_to_fit(const kg_model *model, const kg_solution *solution, kg_vec2 room,
                           kg_unrolled **out_unrolled, kg_error *error) {
    kg_pieces all = {0};
    kg_unrolled *out = calloc(1, sizeof *out);
    kg_status status = out && (out->net = kg_net_create()) ? KG_OK : KG_ERR_MEMORY;
    if (!status)
        status = kg_pieces_create(model, solution, room, &all);
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
    if (!status)
        status = apply_wishes(model, solution, out);
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
    free(unrolled->wishes);
    kg_net_destroy(unrolled->net);
    free(unrolled);
}
