#include "trim/noding.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

/* Blocks of segments whose boxes are compared first. */
enum { BLOCK = 8 };

/* Halvings after which chords that cross count as curves that do: more than tangent curves need,
 * few enough for curves that run side by side below what can be told apart. */
enum { MAX_HALVINGS = 200 };

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
        kg_vec2 q = kg_sub2(kg_chain_plane(p, cut, i + (size_t)k), from);
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

/* An event at a point of a chain, sought from `segment` on: polishing may have moved it to a
 * neighbouring one. At a segment's end it belongs to the vertex there. */
static kg_status add_event(kg_arrangement *a, kg_events *events, size_t chain, size_t segment,
                           kg_cross_point point, size_t node) {
    const kg_chain *c = &a->chains->items[chain];
    const kg_patch *p = a->patch;
    kg_vec2 at = kg_plane(p, point.u, point.v);
    double fraction = 0;
    for (int moved = 0, last = 0; moved < 8; moved++) {
        fraction = kg_nearest_fraction(at, kg_chain_plane(p, c, segment),
                                       kg_chain_plane(p, c, segment + 1));
        int step = fraction <= 0 ? -1 : fraction >= 1 ? 1 : 0;
        bool edge = step < 0 ? segment == 0 : segment + 2 == c->count;
        if (step == 0 || step == -last || (edge && !c->closed))
            break;
        segment = !edge ? (step < 0 ? segment - 1 : segment + 1) : step < 0 ? c->count - 2 : 0;
        last = step;
    }
    for (size_t k = 0; k < 2; k++)
        if (kg_dist2(kg_chain_plane(p, c, segment + k), a->nodes[node]) <= a->snap) {
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

/* A segment of a chain with its ends in the plane. */
typedef struct segment {
    size_t chain, index;
    const kg_chain *c;
    kg_vec2 end[2];
} segment;

static segment segment_of(const kg_arrangement *a, size_t chain, size_t index) {
    const kg_chain *c = &a->chains->items[chain];
    return (segment){chain,
                     index,
                     c,
                     {kg_chain_plane(a->patch, c, index), kg_chain_plane(a->patch, c, index + 1)}};
}

/* A node where the point p of x's chain and the point q of y's are one. */
static kg_status add_pair(kg_arrangement *a, kg_events *events, const segment *x, kg_cross_point p,
                          const segment *y, kg_cross_point q) {
    size_t node;
    kg_status status = node_at(a, kg_plane(a->patch, p.u, p.v), &node);
    if (!status)
        status = add_event(a, events, x->chain, x->index, p, node);
    if (!status)
        status = add_event(a, events, y->chain, y->index, q, node);
    return status;
}

/* Adds nodes where an end of x lies on y. */
static kg_status touch_segments(kg_arrangement *a, kg_events *events, const segment *x,
                                const segment *y, bool *out_touching) {
    for (size_t k = 0; k < 2; k++) {
        double f;
        kg_cross_point p = x->c->points[x->index + k], q;
        if (!kg_chain_passes(a->patch, y->c, y->index, x->end[k], &f, &q))
            continue;
        *out_touching = true;
        kg_status status = add_pair(a, events, x, p, y, q);
        if (status)
            return status;
    }
    return KG_OK;
}

/* Halves a segment that bends, with an exact point. */
static kg_status halve(const kg_patch *patch, kg_chain *c, size_t i) {
    kg_cross_point middle = kg_chain_at(patch, c, i, 0.5, NULL);
    size_t capacity = c->count;
    if (!kg_reserve_bytes((void **)&c->points, &capacity, c->count + 1, sizeof middle))
        return KG_ERR_MEMORY;
    memmove(c->points + i + 2, c->points + i + 1, (c->count - i - 1) * sizeof middle);
    c->points[i + 1] = middle;
    c->count++;
    return KG_OK;
}

/* The exact point where two cuts cross near fractions fx and fy of their segments; false if they
 * cross nowhere near, only their chords do. */
static bool polish_cuts(const kg_patch *patch, const segment *x, double fx, const segment *y,
                        double fy, kg_cross_point *out_p, kg_cross_point *out_q) {
    kg_cross_point p = kg_chain_at(patch, x->c, x->index, fx, NULL);
    kg_cross_point q = kg_chain_at(patch, y->c, y->index, fy, NULL);
    *out_p = *out_q = p;
    out_q->s = q.s, out_q->t = q.t;
    double reach = fmax(kg_dist2(x->end[0], x->end[1]), kg_dist2(y->end[0], y->end[1]));
    kg_vec2 near = kg_lerp2(x->end[0], x->end[1], fx);
    if (!polish_triple(patch, x->c->other, y->c->other, &p, &q) ||
        kg_dist2(kg_plane(patch, p.u, p.v), near) > reach)
        return false;
    *out_p = p;
    *out_q = q;
    return true;
}

static kg_status cross_segments(kg_arrangement *a, kg_events *events, const segment *x,
                                const segment *y) {
    const kg_patch *patch = a->patch;
    bool touching = false;
    kg_status status = touch_segments(a, events, x, y, &touching);
    if (!status)
        status = touch_segments(a, events, y, x, &touching);
    if (status || touching)
        return status;
    kg_vec2 d = kg_sub2(x->end[1], x->end[0]), e = kg_sub2(y->end[1], y->end[0]);
    kg_vec2 g = kg_sub2(y->end[0], x->end[0]);
    double den = kg_cross2(d, e);
    if (den == 0)
        return KG_OK;
    double fx = kg_cross2(g, e) / den, fy = kg_cross2(g, d) / den;
    if (!(fx >= 0 && fx <= 1 && fy >= 0 && fy <= 1))
        return KG_OK;
    kg_cross_point p, q;
    if (kg_chain_is_straight(x->c) && kg_chain_is_straight(y->c)) {
        p = q = kg_chain_at(patch, x->c, x->index, fx, NULL);
    } else if (kg_chain_is_straight(y->c)) {
        p = q = polish_on_line(patch, x->c, x->index, fx, y->end[0], y->end[1]);
    } else if (kg_chain_is_straight(x->c)) {
        p = q = polish_on_line(patch, y->c, y->index, fy, x->end[0], x->end[1]);
    } else if (!polish_cuts(patch, x, fx, y, fy, &p, &q) &&
               fmax(kg_len2(d), kg_len2(e)) > 4 * a->snap && a->halvings < MAX_HALVINGS) {
        a->halvings++;
        status = halve(patch, &a->chains->items[y->chain], y->index); /* may be x's, further on */
        return status ? status : halve(patch, &a->chains->items[x->chain], x->index);
    }
    return add_pair(a, events, x, p, y, q);
}

static kg_box2 span_box(const kg_patch *p, const kg_chain *c, size_t first, size_t last,
                        double margin) {
    kg_box2 b = kg_box2_empty();
    for (size_t k = first; k <= last; k++)
        kg_box2_add(&b, kg_chain_plane(p, c, k));
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
    size_t halvings = a->halvings;
    kg_box2 whole = span_box(p, cj, 0, cj->count - 1, a->snap);
    for (size_t bi = 0; bi + 1 < ci->count; bi += BLOCK) {
        size_t ei = bi + BLOCK < ci->count ? bi + BLOCK : ci->count - 1;
        kg_box2 boxi = span_box(p, ci, bi, ei, a->snap);
        if (apart(boxi, whole))
            continue;
        for (size_t bj = 0; bj + 1 < cj->count; bj += BLOCK) {
            size_t ej = bj + BLOCK < cj->count ? bj + BLOCK : cj->count - 1;
            kg_box2 boxj = span_box(p, cj, bj, ej, 0);
            if (apart(boxi, boxj) || (i == j && ej <= bi))
                continue;
            for (size_t si = bi; si < ei; si++) {
                kg_box2 seg = span_box(p, ci, si, si + 1, a->snap);
                if (apart(seg, boxj))
                    continue;
                for (size_t sj = bj; sj < ej; sj++) {
                    if (i == j && (sj <= si + 1 || (ci->closed && si == 0 && sj == ci->count - 2)))
                        continue; /* neighbours meet in their common point only */
                    if (apart(seg, span_box(p, cj, sj, sj + 1, 0)))
                        continue;
                    segment x = segment_of(a, i, si), y = segment_of(a, j, sj);
                    kg_status status = cross_segments(a, events, &x, &y);
                    if (status || a->halvings != halvings)
                        return status;
                }
            }
        }
    }
    return KG_OK;
}

/* A chain that only rises or only falls in u or in v does not cross itself. */
static bool is_monotone(const kg_chain *c) {
    bool up[2] = {true, true}, down[2] = {true, true};
    for (size_t i = 1; i < c->count; i++) {
        double step[2] = {c->points[i].u - c->points[i - 1].u, c->points[i].v - c->points[i - 1].v};
        for (int k = 0; k < 2; k++) {
            up[k] = up[k] && step[k] > 0;
            down[k] = down[k] && step[k] < 0;
        }
    }
    return up[0] || up[1] || down[0] || down[1];
}

/* Can chains i <= j cross? The sides of what was left before meet at their ends only; the cut of a
 * patch that crosses itself may cross itself. */
static bool may_cross(const kg_chain *ci, const kg_chain *cj) {
    if (ci->labels & cj->labels & KG_LABEL_REGION)
        return false;
    return ci != cj || (ci->kind == KG_EDGE_CUT && !is_monotone(ci));
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

static kg_status node_all(kg_arrangement *a, kg_events *events) {
    kg_status status = KG_OK;
    size_t n = a->chains->count, halvings = a->halvings;
    for (size_t i = 0; i < n && !status; i++) {
        const kg_chain *c = &a->chains->items[i];
        for (size_t k = 0; k < (c->closed ? 1 : 2) && !status; k++) {
            size_t at = k ? c->count - 1 : 0, node;
            status = node_at(a, kg_chain_plane(a->patch, c, at), &node);
            kg_event e = {i, at, node, 0, c->points[at]};
            if (!status && !kg_push(events, e))
                status = KG_ERR_MEMORY;
        }
    }
    for (size_t i = 0; i < n && !status; i++)
        for (size_t j = i; j < n && !status && a->halvings == halvings; j++)
            if (may_cross(&a->chains->items[i], &a->chains->items[j]))
                status = cross_chains(a, events, i, j);
    return status;
}

kg_status kg_node_chains(kg_arrangement *a, kg_events *out_events) {
    kg_events events = {0};
    kg_status status = KG_OK;
    size_t before = SIZE_MAX;
    for (a->halvings = 0; a->halvings != before;) {
        before = a->halvings;
        a->node_count = events.count = 0;
        if ((status = node_all(a, &events)))
            break;
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
