/* Single points of a crossing: two rulings that meet, and the curve's tangent there. */
#include "trim/crossing.h"

/* Sums w_i a_i and w_i b_i with the weights C(m,i) r^i, where b follows a, from `first` on in steps
 * of 1 or -1. */
static inline void sum_halves(const kg_vec3 *a, int m, int first, int step, double r,
                              kg_vec3 *out_a, kg_vec3 *out_b) {
    static const double inverse[KG_PLUCKER_MAX] = {
        0,        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
        1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15,
        1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23};
    kg_vec3 x = a[first], y = a[first + 1];
    double w = 1;
    for (int i = 1; i <= m; i++) {
        w *= r * (m - i + 1) * inverse[i];
        x = kg_madd(x, w, a[first + step * i]);
        y = kg_madd(y, w, a[first + step * i + 1]);
    }
    *out_a = x;
    *out_b = y;
}

/* Value and derivative of a Bernstein polynomial from the two halves of the last de Casteljau
 * step, by Horner's scheme as kg_bernstein_eval3. n is a constant where this is called most, so
 * that the loops unroll. */
static inline void evaluate(const kg_vec3 *a, int n, double t, kg_vec3 *out_value,
                            kg_vec3 *out_slope) {
    if (n == 0) {
        *out_value = a[0];
        *out_slope = kg_v3(0, 0, 0);
        return;
    }
    int m = n - 1;
    double scale = t <= 0.5 ? 1 - t : t, power = 1;
    kg_vec3 x, y;
    if (t <= 0.5)
        sum_halves(a, m, 0, 1, t / scale, &x, &y);
    else
        sum_halves(a, m, m, -1, (1 - t) / scale, &x, &y);
    for (int i = 1; i <= m; i++)
        power *= scale;
    *out_value = kg_scale(kg_lerp(x, y, t), power);
    *out_slope = kg_scale(kg_sub(y, x), n * power);
}

static void evaluate_curve(const kg_ruled *ruled, double v, kg_vec3 *out_p, kg_vec3 *out_dp) {
    if (ruled->patch->geodesic.degree == 3)
        evaluate(ruled->p, 3, v, out_p, out_dp);
    else
        evaluate(ruled->p, ruled->patch->geodesic.degree, v, out_p, out_dp);
}

kg_line kg_ruled_line(const kg_ruled *ruled, double v) {
    kg_line l;
    evaluate_curve(ruled, v, &l.p, &l.dp);
    if (ruled->patch->ruling_degree == 6)
        evaluate(ruled->patch->rulings, 6, v, &l.r, &l.dr);
    else
        evaluate(ruled->patch->rulings, ruled->patch->ruling_degree, v, &l.r, &l.dr);
    return l;
}

double kg_cross_value(const kg_line *a, const kg_line *b, double *out_v, double *out_t) {
    kg_vec3 gap = kg_sub(b->p, a->p), rr = kg_cross(a->r, b->r);
    *out_v = kg_dot(kg_cross(a->dr, b->r), gap) - kg_dot(rr, a->dp);
    *out_t = kg_dot(kg_cross(a->r, b->dr), gap) + kg_dot(rr, b->dp);
    return kg_dot(rr, gap);
}

void kg_line_unit(const kg_line *l, kg_vec3 *out_d, kg_vec3 *out_dd) {
    double inverse = 1 / kg_len(l->r);
    *out_d = kg_scale(l->r, inverse);
    *out_dd = kg_scale(kg_madd(l->dr, -kg_dot(l->dr, *out_d), *out_d), inverse);
}

/* A tangent of the surface as a direction on paper, and the point at length u of the ruling from
 * its foot: there p' points along y, d along (sin θ, cos θ), and e ⊥ d on the side of p' along
 * (-cos θ, sin θ). */
static void lay_on_paper(kg_sample *sample, int which, const kg_line *l, kg_vec3 d, double u) {
    double speed = kg_len(l->dp), c = kg_dot(l->dp, d) / speed;
    kg_vec3 e = kg_madd(kg_scale(l->dp, 1 / speed), -c, d), tangent = sample->slope.x;
    double s = kg_len(e), x = kg_dot(tangent, d), y = kg_dot(tangent, e) / s;
    sample->paper[which] = kg_v2(x * s - y * c, x * c + y * s);
    sample->off[which] = kg_v2(u * s, u * c);
    sample->speed[which] = speed;
}

double kg_ruled_speed(const kg_ruled *ruled, double v) {
    kg_vec3 p, dp;
    evaluate_curve(ruled, v, &p, &dp);
    return kg_len(dp);
}

static double onto_side(double x, const double side[2], double slack) {
    return fabs(x - side[0]) <= slack ? side[0] : fabs(x - side[1]) <= slack ? side[1] : x;
}

static unsigned beyond(double x, const double side[2], unsigned lo) {
    return x < side[0] ? lo : x > side[1] ? lo << 1 : 0;
}

static const double unit_side[2] = {0, 1};

double kg_on_unit_side(const kg_ruled_pair *pair, double v) {
    return onto_side(v, unit_side, pair->slack);
}

kg_sample kg_cross_sample(const kg_ruled_pair *pair, double v, double t, kg_arc_kind kind,
                          int direction) {
    v = kg_on_unit_side(pair, v);
    t = kg_on_unit_side(pair, t);
    kg_line a = kg_ruled_line(&pair->a, v), b = kg_ruled_line(&pair->b, t);
    return kg_cross_lines(pair, v, &a, t, &b, kind, direction);
}

kg_sample kg_cross_lines(const kg_ruled_pair *pair, double v, const kg_line *a, double t,
                         const kg_line *b, kg_arc_kind kind, int direction) {
    kg_vec3 da, dda, db, ddb;
    kg_line_unit(a, &da, &dda);
    kg_line_unit(b, &db, &ddb);
    kg_sample s = {.across = kg_cross(da, db)};
    double n2 = kg_max(kg_dot(s.across, s.across), 1e-30);
    kg_vec3 to_u = kg_scale(kg_cross(db, s.across), 1 / n2);
    kg_vec3 to_s = kg_scale(kg_cross(da, s.across), 1 / n2);
    kg_vec3 gap = kg_sub(b->p, a->p);
    const double *ua = pair->a.patch->extent, *ub = pair->b.patch->extent;
    kg_cross_point *at = &s.at;
    at->v = v, at->t = t;
    at->u = onto_side(kg_dot(gap, to_u), ua, pair->slack * pair->a.size);
    at->s = onto_side(kg_dot(gap, to_s), ub, pair->slack * pair->a.size);
    kg_vec3 xa = kg_madd(a->p, at->u, da), xb = kg_madd(b->p, at->s, db);
    at->x = kg_madd(pair->a.origin, 0.5, kg_add(xa, xb));
    s.out = beyond(at->u, ua, KG_SIDE_A_U_LO) | beyond(v, unit_side, KG_SIDE_A_V_LO) |
            beyond(at->s, ub, KG_SIDE_B_U_LO) | beyond(t, unit_side, KG_SIDE_B_V_LO);
    if (!(kg_dist(xa, xb) <= KG_CROSSING_EXACT * pair->a.size))
        s.out |= KG_SIDE_FALSE;

    /* along F = const: (v', t') ∥ (-F_t, F_v); u', s' from the equal tangent of both surfaces */
    double fv, ft;
    kg_cross_value(a, b, &fv, &ft);
    double dv = -ft, dt = fv;
    if ((kind == KG_ARC_OVER_V ? dv : dt) * direction < 0)
        dv = -dv, dt = -dt;
    kg_vec3 xv = kg_madd(a->dp, at->u, dda), xt = kg_madd(b->dp, at->s, ddb);
    kg_vec3 drift = kg_sub(kg_scale(xt, dt), kg_scale(xv, dv));
    double du = kg_dot(drift, to_u), ds = kg_dot(drift, to_s);
    kg_vec3 tangent = kg_madd(kg_scale(xv, dv), du, da);
    double speed = kg_len(tangent);
    if (!(speed > 0) || !isfinite(speed))
        return s;
    s.slope = (kg_cross_point){du / speed, dv / speed, ds / speed, dt / speed,
                               kg_scale(tangent, 1 / speed)};
    lay_on_paper(&s, 0, a, da, at->u);
    lay_on_paper(&s, 1, b, db, at->s);
    return s;
}
