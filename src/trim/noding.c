#include "trim/noding.h"

#include "base/array.h"

#include <stdlib.h>

/* Blocks of segments whose boxes are compared first. */
enum { BLOCK = 8 };

static kg_vec2 chain_plane(const kg_patch *p, const kg_chain *c, size_t i) {
    return kg_plane(p, c->points[i].u, c->points[i].v);
}

static bool straight(const kg_chain *c) {
    return c->kind != KG_EDGE_CUT;
}

kg_cross_point kg_chain_at(const kg_patch *patch, const kg_chain *chain, size_t i, double fraction,
                           kg_cross_point *out_slope) {
    const kg_cross_point *p = &chain->points[i];
    if (!straight(chain)) {
        kg_crossing span = {.count = 2, .points = chain->points + i};
        return kg_crossing_at(patch, chain->other, &span, 0, fraction, out_slope);
    }
    double du = p[1].u - p[0].u, dv = p[1].v - p[0].v;
    kg_cross_point r = {.u = p[0].u + fraction * du, .v = p[0].v + fraction * dv};
    if (!out_slope) {
        r.x = kg_patch_point(patch, r.u, r.v);
        return r;
    }
    kg_vec3 xu, xv;
    r.x = kg_patch_derivatives(patch, r.u, r.v, &xu, &xv);
    *out_slope = (kg_cross_point){.u = du, .v = dv};
    out_slope->x = kg_add(kg_scale(xu, du), kg_scale(xv, dv));
    return r;
}

/* ---- polishing a crossing onto the exact curves ---------------------------------------- */

/* Solves the 6 × 6 system m x = r by elimination with pivoting; false when singular. */
static bool solve6(double m[6][7]) {
    for (int c = 0; c < 6; c++) {
        int best = c;
        for (int r = c + 1; r < 6; r++)
            if (fabs(m[r][c]) > fabs(m[best][c]))
                best = r;
        if (!(fabs(m[best][c]) > 1e-14))
            return false;
        for (int k = 0; k < 7; k++) {
            double t = m[c][k];
            m[c][k] = m[best][k], m[best][k] = t;
        }
        for (int r = 0; r < 6; r++) {
            if (r == c)
                continue;
            double f = m[r][c] / m[c][c];
            for (int k = c; k < 7; k++)
                m[r][k] -= f * m[c][k];
        }
    }
    for (int c = 0; c < 6; c++)
        m[c][6] /= m[c][c];
    return true;
}

/* The point shared by three patches: Newton on X_A = X_B and X_A = X_C. v is scaled to
 * millimetres so that the matrix is balanced. */
static bool polish_triple(const kg_patch *a, const kg_patch *b, const kg_patch *c,
                          kg_cross_point *on_b, kg_cross_point *on_c) {
    double u = on_b->u, v = on_b->v, s = on_b->s, t = on_b->t, q = on_c->s, r = on_c->t;
    double la = a->length_at[KG_PATCH_CELLS], lb = b->length_at[KG_PATCH_CELLS],
           lc = c->length_at[KG_PATCH_CELLS];
    kg_vec3 xa = on_b->x;
    for (int i = 0; i < 12; i++) {
        kg_vec3 au, av, bs, bt, cq, cr;
        xa = kg_patch_derivatives(a, u, v, &au, &av);
        kg_vec3 xb = kg_patch_derivatives(b, s, t, &bs, &bt);
        kg_vec3 xc = kg_patch_derivatives(c, q, r, &cq, &cr);
        kg_vec3 gb = kg_sub(xb, xa), gc = kg_sub(xc, xa);
        if (kg_len(gb) + kg_len(gc) <= 1e-12 * a->size) {
            on_b->u = on_c->u = u, on_b->v = on_c->v = v, on_b->x = on_c->x = xa;
            on_b->s = s, on_b->t = t, on_c->s = q, on_c->t = r;
            return true;
        }
        av = kg_scale(av, 1 / la), bt = kg_scale(bt, 1 / lb), cr = kg_scale(cr, 1 / lc);
        double m[6][7] = {
            {au.x, av.x, -bs.x, -bt.x, 0, 0, gb.x}, {au.y, av.y, -bs.y, -bt.y, 0, 0, gb.y},
            {au.z, av.z, -bs.z, -bt.z, 0, 0, gb.z}, {au.x, av.x, 0, 0, -cq.x, -cr.x, gc.x},
            {au.y, av.y, 0, 0, -cq.y, -cr.y, gc.y}, {au.z, av.z, 0, 0, -cq.z, -cr.z, gc.z}};
        if (!solve6(m))
            return false;
        u += m[0][6], v += m[1][6] / la, s += m[2][6], t += m[3][6] / lb, q += m[4][6],
            r += m[5][6] / lc;
        if (!(v > -0.1 && v < 1.1 && t > -0.1 && t < 1.1 && r > -0.1 && r < 1.1))
            return false;
    }
    return false;
}

/* The exact point of a cut chain's segment on the line through two plane points. */
static kg_cross_point polish_on_line(const kg_patch *p, const kg_chain *cut, size_t i, double f,
                                     kg_vec2 from, kg_vec2 to) {
    kg_vec2 along = kg_sub2(to, from);
    double lo = 0, hi = 1, flo = 0, fhi = 0;
    for (int k = 0; k < 2; k++) {
        kg_vec2 q = kg_sub2(chain_plane(p, cut, i + (size_t)k), from);
        *(k ? &fhi : &flo) = kg_cross2(along, q);
    }
    kg_cross_point r = kg_chain_at(p, cut, i, f, NULL);
    if ((flo < 0) == (fhi < 0))
        return r;
    /* Illinois false position: the curve is nearly its chord, so a handful of steps suffice */
    int side = 0;
    for (int k = 0; k < 40; k++) {
        f = (lo * fhi - hi * flo) / (fhi - flo);
        r = kg_chain_at(p, cut, i, f, NULL);
        double g = kg_cross2(along, kg_sub2(kg_plane(p, r.u, r.v), from));
        if (fabs(g) <= 1e-12 * p->size * kg_len2(along) || hi - lo < 1e-15)
            break;
        if ((g < 0) == (flo < 0)) {
            lo = f, flo = g;
            if (side == -1)
                fhi /= 2;
            side = -1;
        } else {
            hi = f, fhi = g;
            if (side == 1)
                flo /= 2;
            side = 1;
        }
    }
    return r;
}

/* ---- nodes and events ------------------------------------------------------------------ */

static kg_status node_at(kg_arrangement *a, kg_vec2 at, size_t *out_node) {
    for (size_t i = 0; i < a->node_count; i++)
        if (kg_dist2(a->nodes[i], at) <= a->snap) {
            *out_node = i;
            return KG_OK;
        }
    if (!kg_reserve_bytes((void **)&a->nodes, &a->node_capacity, a->node_count + 1, sizeof at))
        return KG_ERR_MEMORY;
    a->nodes[a->node_count] = at;
    *out_node = a->node_count++;
    return KG_OK;
}

/* An event at a point of a chain; at a segment's end it belongs to the vertex there. */
static kg_status add_event(kg_arrangement *a, kg_events *events, size_t chain, size_t segment,
                           double fraction, kg_cross_point point, size_t node) {
    const kg_chain *c = &a->chains->items[chain];
    for (size_t k = 0; k < 2; k++)
        if (kg_dist2(chain_plane(a->patch, c, segment + k), a->nodes[node]) <= a->snap) {
            fraction = (double)k;
            point = c->points[segment + k];
        }
    if (fraction >= 1) {
        segment++;
        fraction = 0;
    }
    if (c->closed && segment == c->count - 1)
        segment = 0;
    kg_event e = {chain, segment, node, fraction, point};
    return kg_push(events, e) ? KG_OK : KG_ERR_MEMORY;
}

static kg_status add_pair(kg_arrangement *a, kg_events *events, size_t i, size_t si, double fi,
                          kg_cross_point pi, size_t j, size_t sj, double fj, kg_cross_point pj,
                          kg_vec2 at) {
    size_t node;
    kg_status status = node_at(a, at, &node);
    if (!status)
        status = add_event(a, events, i, si, fi, pi, node);
    if (!status)
        status = add_event(a, events, j, sj, fj, pj, node);
    return status;
}

/* Fraction of the segment nearest to p, and the distance. */
static double nearest_fraction(kg_vec2 p, kg_vec2 a, kg_vec2 b, double *out_distance) {
    kg_vec2 d = kg_sub2(b, a);
    double n = kg_dot2(d, d), f = n > 0 ? kg_dot2(kg_sub2(p, a), d) / n : 0;
    f = fmin(fmax(f, 0), 1);
    *out_distance = kg_dist2(p, kg_lerp2(a, b, f));
    return f;
}

/* A point of a chain's segment whose plane place is known to lie on it within the snap. */
static kg_cross_point touched(const kg_patch *p, const kg_chain *c, size_t segment, double f,
                              kg_cross_point at) {
    kg_cross_point r = kg_chain_at(p, c, segment, f, NULL);
    r.u = at.u, r.v = at.v, r.x = at.x;
    return r;
}

static kg_status cross_segments(kg_arrangement *a, kg_events *events, size_t i, size_t si, size_t j,
                                size_t sj) {
    const kg_patch *patch = a->patch;
    const kg_chain *ci = &a->chains->items[i], *cj = &a->chains->items[j];
    kg_vec2 p0 = chain_plane(patch, ci, si), p1 = chain_plane(patch, ci, si + 1);
    kg_vec2 q0 = chain_plane(patch, cj, sj), q1 = chain_plane(patch, cj, sj + 1);
    bool touching = false;
    kg_status status = KG_OK;
    for (size_t k = 0; k < 2 && !status; k++) {
        double gap, f = nearest_fraction(k ? p1 : p0, q0, q1, &gap);
        if (gap <= a->snap) {
            kg_cross_point at = ci->points[si + k];
            status = add_pair(a, events, i, si, (double)k, at, j, sj, f,
                              touched(patch, cj, sj, f, at), k ? p1 : p0);
            touching = true;
        }
        if (status)
            break;
        f = nearest_fraction(k ? q1 : q0, p0, p1, &gap);
        if (gap <= a->snap) {
            kg_cross_point at = cj->points[sj + k];
            status = add_pair(a, events, i, si, f, touched(patch, ci, si, f, at), j, sj, (double)k,
                              at, k ? q1 : q0);
            touching = true;
        }
    }
    if (status || touching)
        return status;
    kg_vec2 d = kg_sub2(p1, p0), e = kg_sub2(q1, q0), g = kg_sub2(q0, p0);
    double den = kg_cross2(d, e);
    if (den == 0)
        return KG_OK;
    double fi = kg_cross2(g, e) / den, fj = kg_cross2(g, d) / den;
    if (!(fi > 0 && fi < 1 && fj > 0 && fj < 1))
        return KG_OK;
    kg_cross_point pi, pj;
    if (straight(ci) && straight(cj)) {
        pi = pj = kg_chain_at(patch, ci, si, fi, NULL);
    } else if (straight(cj)) {
        pi = pj = polish_on_line(patch, ci, si, fi, q0, q1);
    } else if (straight(ci)) {
        pi = pj = polish_on_line(patch, cj, sj, fj, p0, p1);
    } else {
        pi = kg_chain_at(patch, ci, si, fi, NULL);
        pj = kg_chain_at(patch, cj, sj, fj, NULL);
        if (!polish_triple(patch, ci->other, cj->other, &pi, &pj))
            pj.u = pi.u, pj.v = pi.v, pj.x = pi.x; /* tangent cuts: no better point exists */
    }
    return add_pair(a, events, i, si, fi, pi, j, sj, fj, pj, kg_plane(patch, pi.u, pi.v));
}

static kg_box2 span_box(const kg_patch *p, const kg_chain *c, size_t first, size_t last,
                        double margin) {
    kg_box2 b = kg_box2_empty();
    for (size_t k = first; k <= last; k++)
        kg_box2_add(&b, chain_plane(p, c, k));
    b.lo = kg_sub2(b.lo, kg_v2(margin, margin));
    b.hi = kg_add2(b.hi, kg_v2(margin, margin));
    return b;
}

static bool apart(kg_box2 a, kg_box2 b) {
    return a.lo.x > b.hi.x || b.lo.x > a.hi.x || a.lo.y > b.hi.y || b.lo.y > a.hi.y;
}

static kg_status cross_chains(kg_arrangement *a, kg_events *events, size_t i, size_t j) {
    const kg_chain *ci = &a->chains->items[i], *cj = &a->chains->items[j];
    const kg_patch *p = a->patch;
    kg_box2 whole = span_box(p, cj, 0, cj->count - 1, a->snap);
    for (size_t bi = 0; bi + 1 < ci->count; bi += BLOCK) {
        size_t ei = bi + BLOCK < ci->count ? bi + BLOCK : ci->count - 1;
        kg_box2 boxi = span_box(p, ci, bi, ei, a->snap);
        if (apart(boxi, whole))
            continue;
        for (size_t bj = 0; bj + 1 < cj->count; bj += BLOCK) {
            size_t ej = bj + BLOCK < cj->count ? bj + BLOCK : cj->count - 1;
            kg_box2 boxj = span_box(p, cj, bj, ej, 0);
            if (apart(boxi, boxj))
                continue;
            for (size_t si = bi; si < ei; si++) {
                kg_box2 seg = span_box(p, ci, si, si + 1, a->snap);
                if (apart(seg, boxj))
                    continue;
                for (size_t sj = bj; sj < ej; sj++) {
                    if (apart(seg, span_box(p, cj, sj, sj + 1, 0)))
                        continue;
                    kg_status status = cross_segments(a, events, i, si, j, sj);
                    if (status)
                        return status;
                }
            }
        }
    }
    return KG_OK;
}

static int compare_events(const void *x, const void *y) {
    const kg_event *a = x, *b = y;
    if (a->chain != b->chain)
        return a->chain < b->chain ? -1 : 1;
    if (a->segment != b->segment)
        return a->segment < b->segment ? -1 : 1;
    if (a->fraction != b->fraction)
        return a->fraction < b->fraction ? -1 : 1;
    return a->node < b->node ? -1 : a->node > b->node;
}

kg_status kg_node_chains(kg_arrangement *a, kg_events *out_events) {
    kg_events events = {0};
    kg_status status = KG_OK;
    size_t n = a->chains->count;
    for (size_t i = 0; i < n && !status; i++) {
        const kg_chain *c = &a->chains->items[i];
        if (c->closed)
            continue;
        for (size_t k = 0; k < 2 && !status; k++) {
            size_t at = k ? c->count - 1 : 0, node;
            status = node_at(a, chain_plane(a->patch, c, at), &node);
            kg_event e = {i, at, node, 0, c->points[at]};
            if (!status && !kg_push(&events, e))
                status = KG_ERR_MEMORY;
        }
    }
    for (size_t i = 0; i < n && !status; i++)
        for (size_t j = i + 1; j < n && !status; j++) {
            /* the sides of what was left before meet at their ends only */
            if ((a->chains->items[i].labels & a->chains->items[j].labels & KG_LABEL_REGION) == 0)
                status = cross_chains(a, &events, i, j);
        }
    /* a closed chain that meets nothing still needs a node to start at */
    for (size_t i = 0; i < n && !status; i++) {
        bool met = !a->chains->items[i].closed;
        for (size_t k = 0; k < events.count && !met; k++)
            met = events.items[k].chain == i;
        size_t node;
        if (met || (status = node_at(a, chain_plane(a->patch, &a->chains->items[i], 0), &node)))
            continue;
        kg_event e = {i, 0, node, 0, a->chains->items[i].points[0]};
        if (!kg_push(&events, e))
            status = KG_ERR_MEMORY;
    }
    if (status) {
        free(events.items);
        return status;
    }
    if (events.count)
        qsort(events.items, events.count, sizeof *events.items, compare_events);
    *out_events = events;
    return KG_OK;
}
