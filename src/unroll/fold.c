#include "unroll/fold.h"

#include <stdlib.h>

/* The front normal of the partner at a point of the stretch. */
static kg_vec3 partner_normal(const kg_pieces *all, const kg_stretch *s, const kg_cross_point *at) {
    const kg_patch *b = kg_piece_patch(all, s->partner.piece);
    double u, v = at->t; /* (s, t) are the partner's where it made the cut */
    const kg_region_edge *e = kg_piece_edge(all, s->edge);
    if (e->kind == KG_EDGE_SPLIT)
        v = at->v;
    else if (all->items[s->partner.piece].patch->id != e->source)
        kg_patch_closest(b, at->x, &u, &v);
    return kg_patch_normal(b, v);
}

/* The fold at one point. `lean`: the direction that the tab had on the other part at the point
 * before, zero at the first. */
static double fold_at(const kg_pieces *all, const kg_stretch *s, double position, kg_vec3 *lean) {
    const kg_patch *a = kg_piece_patch(all, s->edge.piece);
    const kg_patch *b = kg_piece_patch(all, s->partner.piece);
    kg_cross_point slope, at = kg_piece_point(all, s->edge, position, &slope);
    kg_vec3 along = kg_unit(slope.x), front = kg_patch_normal(a, at.v);
    /* paper lies on the left of the loop in the (u,v) plane, which is seen from the back of an
     * unflipped patch */
    kg_vec3 out = kg_scale(kg_cross(front, along), a->flip ? -1 : 1);
    kg_vec3 onto = kg_unit(kg_cross(partner_normal(all, s, &at), along));
    double sign;
    if (s->seam) /* into the mate's paper: left of its own direction */
        sign = (b->flip ? 1 : -1) * (s->mate_reversed ? -1 : 1);
    else if (kg_dot(*lean, *lean) > 0)
        sign = kg_dot(onto, *lean) < 0 ? -1 : 1;
    else
        sign = kg_dot(onto, out) < 0 ? -1 : 1;
    *lean = onto = kg_scale(onto, sign);
    return atan2(kg_dot(onto, front), kg_dot(onto, out));
}

double kg_stretch_fold(const kg_pieces *all, size_t stretch) {
    enum { SAMPLES = 8 };
    const kg_stretch *s = &all->stretches[stretch];
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

kg_status kg_stretch_bends(const kg_pieces *all, size_t stretch, double **out) {
    const kg_stretch *s = &all->stretches[stretch];
    double *bends = calloc(s->count, sizeof *bends);
    if (!bends)
        return KG_ERR_MEMORY;
    kg_vec3 before = kg_v3(0, 0, 0);
    double position = s->from, sum = 0;
    for (size_t i = 0; i < s->count; i++) {
        kg_cross_point slope;
        kg_piece_point(all, s->edge, position, &slope);
        kg_vec3 along = kg_unit(slope.x);
        if (i > 0)
            sum += atan2(kg_len(kg_cross(before, along)), kg_dot(before, along));
        bends[i] = sum;
        before = along;
        position = fmin(floor(position) + 1, s->to);
    }
    if (kg_piece_patch(all, s->edge.piece)->flip) /* the net runs the other way */
        for (size_t i = 0; i < (s->count + 1) / 2; i++) {
            size_t j = s->count - 1 - i;
            double a = sum - bends[i], b = sum - bends[j];
            bends[i] = b, bends[j] = a;
        }
    *out = bends;
    return KG_OK;
}
