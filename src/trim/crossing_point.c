/* A point inside a span of a branch, by Newton's method in the plane square to the chord. */
#include "trim/crossing.h"

enum { STEPS = 20 };

/* Pivots below this, of unit vectors, are rounding: the system is singular. */
#define LEAST_PIVOT 1e-14

/* After a step this small the next one is exact; so is this one where it shrank by SHRINKS against
 * the one before: errors go with the square of steps, so the point is then off by a share of
 * SHRINKS² of the step, and the tangents, from before the step, by about SHRINKS². */
#define NEAR 1e-8
#define SHRINKS 1e-5

/* A step in u, v on A and s, t on B. */
typedef struct increment {
    double u, v, s, t;
} increment;

/* The two surfaces at points that are to become one: tangents by u and v, by s and t. */
typedef struct tangents {
    kg_vec3 xu, xv, xs, xt;
    kg_vec3 normal; /* X_s × X_t, a unit vector */
    double area;    /* its length before */
} tangents;

/* The step with X_u u + X_v v - X_s s - X_t t = gap that goes `way` along a direction. The normal
 * of B takes s and t out of it, which leaves two equations for u and v. */
static bool step_to(const tangents *x, kg_vec3 along, kg_vec3 gap, double way, increment *out) {
    double a = kg_dot(x->normal, x->xu), b = kg_dot(x->normal, x->xv), r = kg_dot(x->normal, gap);
    double c = kg_dot(along, x->xu), d = kg_dot(along, x->xv), det = a * d - b * c;
    if (!(fabs(det) > LEAST_PIVOT))
        return false;
    out->u = (r * d - b * way) / det;
    out->v = (a * way - r * c) / det;
    kg_vec3 w = kg_sub(kg_madd(kg_scale(x->xu, out->u), out->v, x->xv), gap);
    out->s = kg_dot(kg_cross(w, x->xt), x->normal) / x->area;
    out->t = kg_dot(kg_cross(x->xs, w), x->normal) / x->area;
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
    double size = kg_max(a->size, b->size), scale = 1 / size, length = kg_len(slope.x);
    kg_vec3 along = kg_unit(slope.x);
    kg_ruled ra = seen_from(a, p->x), rb = seen_from(b, p->x);
    /* u, s and all equations are divided by the size. */
    bool converged = false;
    double before = NEAR;
    for (int k = 0; k < STEPS; k++) {
        kg_line x = kg_ruled_line(&ra, at.v), y = kg_ruled_line(&rb, at.t);
        kg_vec3 ddx, ddy;
        tangents on;
        kg_line_unit(&x, &on.xu, &ddx);
        kg_line_unit(&y, &on.xs, &ddy);
        kg_vec3 point = kg_madd(x.p, at.u, on.xu), gap = kg_sub(kg_madd(y.p, at.s, on.xs), point);
        kg_vec3 xv = kg_madd(x.dp, at.u, ddx);
        on.xv = kg_scale(xv, scale);
        on.xt = kg_scale(kg_madd(y.dp, at.s, ddy), scale);
        kg_vec3 normal = kg_cross(on.xs, on.xt);
        on.area = kg_len(normal);
        if (!(on.area > LEAST_PIVOT))
            break;
        on.normal = kg_scale(normal, 1 / on.area);
        double way = fraction * length - kg_dot(along, point);
        increment to, ahead;
        if (!step_to(&on, along, kg_scale(gap, scale), way * scale, &to))
            break;
        at.u += size * to.u, at.v += to.v, at.s += size * to.s, at.t += to.t;
        double change = fabs(to.u) + fabs(to.v) + fabs(to.s) + fabs(to.t);
        converged = converged || (change < NEAR && change <= SHRINKS * before);
        if (converged || change == 0) {
            point = kg_madd(kg_add(point, kg_scale(gap, 0.5)), size * to.u, on.xu);
            at.x = kg_add(kg_madd(point, to.v, xv), p->x);
            converged = true;
            if (out_slope && step_to(&on, along, kg_v3(0, 0, 0), length * scale, &ahead))
                slope = (kg_cross_point){size * ahead.u, ahead.v, size * ahead.s, ahead.t,
                                         kg_madd(kg_scale(on.xu, size * ahead.u), ahead.v, xv)};
            break;
        }
        if (!(change < 1))
            break;
        converged = change < NEAR;
        before = change;
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
