/* A point inside a span of a branch, by Newton's method in the plane square to the chord. */
#include "trim/crossing.h"

enum { STEPS = 20 };

/* Solves a 4×4 system with two right sides in place, by elimination with pivoting; false where it
 * is singular. */
static bool solve(double m[4][6]) {
    for (int k = 0; k < 4; k++) {
        int best = k;
        for (int i = k + 1; i < 4; i++)
            if (fabs(m[i][k]) > fabs(m[best][k]))
                best = i;
        if (!(fabs(m[best][k]) > 1e-14))
            return false;
        for (int j = 0; j < 6; j++) {
            double swap = m[k][j];
            m[k][j] = m[best][j];
            m[best][j] = swap;
        }
        for (int i = 0; i < 4; i++) {
            double factor = i == k ? 0 : m[i][k] / m[k][k];
            for (int j = k; j < 6; j++)
                m[i][j] -= factor * m[k][j];
        }
    }
    for (int i = 0; i < 4; i++)
        for (int j = 4; j < 6; j++)
            m[i][j] /= m[i][i];
    return true;
}

static kg_ruled seen_from(const kg_patch *patch, kg_vec3 origin) {
    kg_ruled r = {.patch = patch, .origin = origin};
    for (int i = 0; i <= patch->geodesic.degree; i++)
        r.p[i] = kg_sub(patch->geodesic.points[i], origin);
    return r;
}

static kg_cross_point mix(const kg_cross_point *p, const kg_cross_point *q, double x) {
    return (kg_cross_point){p->u + x * (q->u - p->u), p->v + x * (q->v - p->v),
                            p->s + x * (q->s - p->s), p->t + x * (q->t - p->t),
                            kg_lerp(p->x, q->x, x)};
}

/* Where Newton's method fails: the crossing with the ruling at `fraction` of the span, by F alone,
 * whose roots may be multiple there: slow, but F and with it the distance of the rulings vanish. */
static kg_cross_point along_rulings(const kg_ruled *a, const kg_ruled *b, const kg_cross_point *p,
                                    const kg_cross_point *q, double fraction) {
    kg_cross_point at = mix(p, q, fraction);
    bool over_v = fabs(q->v - p->v) >= fabs(q->t - p->t);
    double reach = fmax(fabs(q->v - p->v), fabs(q->t - p->t)), v = at.v, t = at.t;
    for (int i = 0; i < 100; i++) {
        kg_line x = kg_ruled_line(a, v), y = kg_ruled_line(b, t);
        double fv, ft, f = kg_cross_value(&x, &y, &fv, &ft), step = f / (over_v ? ft : fv);
        if (f == 0 || !isfinite(step))
            break;
        *(over_v ? &t : &v) -= step;
        if (fabs(step) < 1e-14)
            break;
    }
    kg_ruled_pair pair = {*a, *b, 0, 0};
    kg_sample s = kg_cross_sample(&pair, v, t, KG_ARC_OVER_V, 1);
    bool near = fabs(v - at.v) <= reach && fabs(t - at.t) <= reach;
    return near && kg_dist(s.at.x, at.x) <= kg_dist(p->x, q->x) ? s.at : at;
}

kg_cross_point kg_crossing_at(const kg_patch *a, const kg_patch *b, const kg_crossing *branch,
                              size_t i, double fraction, kg_cross_point *out_slope) {
    const kg_cross_point *p = &branch->points[i], *q = &branch->points[i + 1];
    kg_cross_point straight = mix(p, q, fraction), at = straight;
    kg_cross_point slope = {q->u - p->u, q->v - p->v, q->s - p->s, q->t - p->t, kg_sub(q->x, p->x)};
    double size = fmax(a->size, b->size), length = kg_len(slope.x);
    kg_vec3 along = kg_unit(slope.x);
    kg_ruled ra = seen_from(a, p->x), rb = seen_from(b, p->x);
    /* Unknowns: u/size, v, s/size, t; equations: X_A = X_B and the plane, all divided by size. */
    bool converged = false;
    for (int step = 0; step < STEPS; step++) {
        kg_line x = kg_ruled_line(&ra, at.v), y = kg_ruled_line(&rb, at.t);
        kg_vec3 dx, ddx, dy, ddy;
        kg_line_unit(&x, &dx, &ddx);
        kg_line_unit(&y, &dy, &ddy);
        kg_vec3 point = kg_madd(x.p, at.u, dx), gap = kg_sub(kg_madd(y.p, at.s, dy), point);
        kg_vec3 xv = kg_madd(x.dp, at.u, ddx), yt = kg_madd(y.dp, at.s, ddy);
        double scale = 1 / size;
        double m[4][6] = {
            {dx.x, xv.x * scale, -dy.x, -yt.x * scale, gap.x * scale, 0},
            {dx.y, xv.y * scale, -dy.y, -yt.y * scale, gap.y * scale, 0},
            {dx.z, xv.z * scale, -dy.z, -yt.z * scale, gap.z * scale, 0},
            {kg_dot(along, dx), kg_dot(along, xv) * scale, 0, 0,
             (fraction * length - kg_dot(along, point)) * scale, length * scale},
        };
        if (!solve(m))
            break;
        at.u += size * m[0][4], at.v += m[1][4], at.s += size * m[2][4], at.t += m[3][4];
        double change = fabs(m[0][4]) + fabs(m[1][4]) + fabs(m[2][4]) + fabs(m[3][4]);
        if (converged || change == 0) {
            point = kg_madd(kg_add(point, kg_scale(gap, 0.5)), size * m[0][4], dx);
            at.x = kg_add(kg_madd(point, m[1][4], xv), p->x);
            slope = (kg_cross_point){size * m[0][5], m[1][5], size * m[2][5], m[3][5],
                                     kg_madd(kg_scale(dx, size * m[0][5]), m[1][5], xv)};
            converged = true;
            break;
        }
        if (!(change < 1))
            break;
        converged = change < 1e-8; /* one more step makes it exact */
    }
    /* Where the surfaces touch, or branches meet, the system is singular. */
    if (!converged || !(kg_dist(at.x, straight.x) <= length)) {
        at = along_rulings(&ra, &rb, p, q, fraction);
        slope = (kg_cross_point){q->u - p->u, q->v - p->v, q->s - p->s, q->t - p->t,
                                 kg_sub(q->x, p->x)};
    }
    if (out_slope)
        *out_slope = slope;
    return at;
}
