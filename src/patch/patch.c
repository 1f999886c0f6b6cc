#include "katagami/patch.h"

#include "curve/bernstein.h"
#include "patch/prepare.h"

#include <string.h>

/* ---- evaluation ------------------------------------------------------------------------ */

/* Degree of the Darboux polynomial; with less, R has inflections divided out and d comes from R. */
static bool is_darboux(const kg_patch *p) {
    return p->ruling_degree == (p->geodesic.degree == 3 ? 6 : 18);
}

/* η = τ/κ = δ |p'|³ / |c|³ with c = p'×p'', δ = det(p',p'',p'''). Directly from the derivatives it
 * keeps digits where D, of degree 6 or 18, is small against its coefficients. */
static double slant(kg_vec3 c, double speed, kg_vec3 dddp) {
    double q = speed / kg_len(c);
    return kg_dot(c, dddp) * (q * q * q);
}

/* d = cos θ T + sin θ B with cot θ = η. In the tangent plane of the rectifying developable
 * d' = θ' (cos θ B - sin θ T), with nothing out of it: T' and B' cancel. */
static void darboux_ruling(const kg_curve *curve, double v, kg_ruling *r) {
    kg_vec3 p[5];
    kg_curve_derivatives(curve, v, curve->degree == 3 ? 3 : 4, p);
    if (curve->degree == 3)
        p[4] = kg_v3(0, 0, 0);
    r->p = p[0], r->dp = p[1], r->ddp = p[2];
    kg_vec3 c = kg_cross(p[1], p[2]);
    double s2 = kg_dot(p[1], p[1]), c2 = kg_dot(c, c), delta = kg_dot(c, p[3]);
    r->speed = sqrt(s2);
    double q = r->speed / sqrt(c2), q3 = q * q * q, eta = delta * q3;
    double growth = kg_dot(p[1], p[2]) / s2 - kg_dot(c, kg_cross(p[1], p[3])) / c2; /* q'/q */
    double deta = q3 * (kg_dot(c, p[4]) + 3 * delta * growth);
    r->sin_theta = 1 / sqrt(1 + eta * eta);
    r->cos_theta = eta * r->sin_theta;
    r->dtheta = -deta * r->sin_theta * r->sin_theta;
    kg_vec3 tangent = kg_scale(p[1], 1 / r->speed), binormal = kg_scale(c, 1 / sqrt(c2));
    r->d = kg_madd(kg_scale(tangent, r->cos_theta), r->sin_theta, binormal);
    r->dd =
        kg_madd(kg_scale(tangent, -r->sin_theta * r->dtheta), r->cos_theta * r->dtheta, binormal);
    r->normal = kg_cross(tangent, binormal);
}

/* d = R/|R| of a polynomial or constant R. */
static void polynomial_ruling(const kg_patch *patch, double v, kg_ruling *r) {
    kg_vec3 c[3];
    kg_curve_derivatives(&patch->geodesic, v, 2, c);
    r->p = c[0], r->dp = c[1], r->ddp = c[2];
    r->speed = kg_len(r->dp);
    int n = patch->ruling_degree;
    if (n == 0) {
        r->d = patch->rulings[0];
    } else {
        /* the two halves of the last de Casteljau step give value and derivative together */
        kg_vec3 a = kg_bernstein_eval3(patch->rulings, n - 1, v);
        kg_vec3 b = kg_bernstein_eval3(patch->rulings + 1, n - 1, v);
        kg_vec3 value = kg_lerp(a, b, v), slope = kg_scale(kg_sub(b, a), n);
        double inverse = 1 / kg_len(value);
        r->d = kg_scale(value, inverse);
        r->dd = kg_scale(kg_madd(slope, -kg_dot(slope, r->d), r->d), inverse);
    }
    kg_vec3 across = kg_cross(r->dp, r->d);
    double cross = kg_len(across);
    r->sin_theta = cross / r->speed;
    r->cos_theta = kg_dot(r->dp, r->d) / r->speed;
    r->normal = kg_scale(across, 1 / cross);
    /* (p'·d)' = p''·d + p'·d' and (cos θ)' = -sin θ θ' */
    double dspeed = kg_dot(r->dp, r->ddp) / r->speed;
    double dcos = (kg_dot(r->ddp, r->d) + kg_dot(r->dp, r->dd) - r->cos_theta * dspeed) / r->speed;
    r->dtheta = -dcos / r->sin_theta;
}

kg_ruling kg_patch_ruling(const kg_patch *patch, double v) {
    kg_ruling r = {.v = v};
    if (is_darboux(patch))
        darboux_ruling(&patch->geodesic, v, &r);
    else
        polynomial_ruling(patch, v, &r);
    if (patch->flip)
        r.normal = kg_neg(r.normal);
    return r;
}

kg_vec3 kg_patch_line(const kg_patch *patch, double v, kg_vec3 *out_d) {
    kg_vec3 p[4], d = patch->rulings[0];
    bool darboux = is_darboux(patch);
    kg_curve_derivatives(&patch->geodesic, v, darboux ? 3 : 0, p);
    if (darboux) {
        kg_vec3 c = kg_cross(p[1], p[2]);
        double speed = kg_len(p[1]);
        d = kg_unit(kg_madd(kg_unit(c), slant(c, speed, p[3]) / speed, p[1]));
    } else if (patch->ruling_degree > 0) {
        d = kg_unit(kg_bernstein_eval3(patch->rulings, patch->ruling_degree, v));
    }
    *out_d = d;
    return p[0];
}

kg_vec3 kg_patch_point(const kg_patch *patch, double u, double v) {
    kg_vec3 d, p = kg_patch_line(patch, v, &d);
    return kg_madd(p, u, d);
}

kg_vec3 kg_patch_derivatives(const kg_patch *patch, double u, double v, kg_vec3 *out_du,
                             kg_vec3 *out_dv) {
    kg_ruling r = kg_patch_ruling(patch, v);
    *out_du = r.d;
    *out_dv = kg_madd(r.dp, u, r.dd);
    return kg_madd(r.p, u, r.d);
}

kg_vec3 kg_patch_normal(const kg_patch *patch, double v) {
    return kg_patch_ruling(patch, v).normal;
}

void kg_patch_regression(const kg_patch *patch, double v, double *out_lo, double *out_hi) {
    /* d' = c w with w = sin θ T - cos θ B across d, c = -θ', and p' = … + |p'| sin θ w */
    kg_ruling r = kg_patch_ruling(patch, v);
    double b = r.speed * r.sin_theta;
    bool folds = patch->ruling_degree > 0 && r.dtheta != 0;
    *out_lo = folds && r.dtheta < 0 ? b / r.dtheta : -HUGE_VAL;
    *out_hi = folds && r.dtheta > 0 ? b / r.dtheta : HUGE_VAL;
}

/* ---- unrolling ------------------------------------------------------------------------- */

double kg_patch_length(const kg_patch *patch, double v) {
    int i = (int)fmin(fmax(floor(v * KG_PATCH_CELLS + 0.5), 0), KG_PATCH_CELLS);
    double from = (double)i / KG_PATCH_CELLS;
    return patch->length_at[i] + (v == from ? 0 : kg_curve_length(&patch->geodesic, from, v));
}

kg_vec2 kg_patch_unroll(const kg_patch *patch, double u, double v) {
    kg_ruling r = kg_patch_ruling(patch, v);
    return kg_v2(u * r.sin_theta, u * r.cos_theta + kg_patch_length(patch, v));
}

kg_vec2 kg_patch_unroll_derivatives(const kg_patch *patch, double u, double v, kg_vec2 *out_du,
                                    kg_vec2 *out_dv) {
    kg_ruling r = kg_patch_ruling(patch, v);
    *out_du = kg_v2(r.sin_theta, r.cos_theta);
    *out_dv = kg_v2(u * r.cos_theta * r.dtheta, r.speed - u * r.sin_theta * r.dtheta);
    return kg_v2(u * r.sin_theta, u * r.cos_theta + kg_patch_length(patch, v));
}

/* ---- preparation ----------------------------------------------------------------------- */

static void init_lengths(kg_patch *p) {
    p->length_at[0] = 0;
    for (int i = 0; i < KG_PATCH_CELLS; i++)
        p->length_at[i + 1] =
            p->length_at[i] + kg_curve_length(&p->geodesic, (double)i / KG_PATCH_CELLS,
                                              (double)(i + 1) / KG_PATCH_CELLS);
}

/* A box around p + u d: p is in the hull of its control points, d among the unit vectors. */
static void init_box(kg_patch *p) {
    kg_box3 box = kg_box3_empty();
    const kg_curve *c = &p->geodesic;
    /* d lies in the convex cone of the coefficients of R: within `spread` of their mean. */
    kg_vec3 mean = kg_v3(0, 0, 0);
    for (int i = 0; i <= p->ruling_degree; i++)
        mean = kg_add(mean, kg_unit(p->rulings[i]));
    mean = kg_unit(mean);
    double spread = 0;
    for (int i = 0; i <= p->ruling_degree; i++)
        spread = fmax(spread, kg_dist(kg_unit(p->rulings[i]), mean));
    for (int i = 0; i <= c->degree; i++)
        for (int k = 0; k < 2; k++) {
            double u = p->extent[k], r = spread < 1 ? fabs(u) * spread : 0;
            kg_vec3 q = kg_madd(c->points[i], spread < 1 ? u : 0, mean);
            if (spread >= 1)
                r = fabs(u);
            kg_box3_add(&box, kg_sub(q, kg_v3(r, r, r)));
            kg_box3_add(&box, kg_add(q, kg_v3(r, r, r)));
        }
    p->box = box;
    p->size = kg_curve_size(c);
    kg_vec3 corner[4];
    for (int i = 0; i < 4; i++) {
        corner[i] = kg_patch_point(p, p->extent[i & 1], i >> 1);
        for (int j = 0; j < i; j++)
            p->size = fmax(p->size, kg_dist(corner[i], corner[j]));
    }
}

kg_status kg_patch_init(const kg_patch_input *input, kg_patch *out_patch, kg_error *error) {
    kg_patch p;
    memset(&p, 0, sizeof p);
    kg_status status = kg_curve_init(input->points, input->point_count, &p.geodesic, error);
    if (status)
        return status;
    p.shape = kg_curve_classify(&p.geodesic);
    p.flip = input->flip;
    if ((status = kg_patch_init_rulings(input, &p, error)) ||
        (status = kg_patch_init_extent(input, &p, error)))
        return status;
    init_lengths(&p);
    init_box(&p);
    *out_patch = p;
    return KG_OK;
}
