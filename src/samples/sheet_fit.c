#include "samples/sheet_fit.h"

#include <cminpack.h>
#include <string.h>

enum {
    STATIONS = 40,                         /* places along the geodesic where it is compared */
    PER_STATION = 6,                       /* residuals at each */
    BENDS = 3 * (KG_CURVE_MAX_POINTS - 2), /* second differences of the control points */
    RESIDUALS = STATIONS * PER_STATION + 2 + BENDS,
    UNKNOWNS = 3 * KG_CURVE_MAX_POINTS,
    PLACES = 100 /* on the line, where the search for the nearest point starts */
};

typedef struct fit {
    const sheet_wish *wish;
    kg_vec3 places[PLACES + 1];
} fit;

static const double LEAD = 0.1; /* of s */

/* A geodesic off the surface is bad, one that leaves the line within the surface hardly. */
static const double SIDEWAYS = 0.03;
/* mm: what a radian between the normals costs; about half the width of a strip, so that its edges
 * are as good as its middle. */
static const double HALF_WIDTH = 10;
/* Cost of unevenly placed control points: little, but without it those of a quintic may slide along
 * a flat curve and the fit never comes to rest. */
static const double UNEVEN = 0.003;
/* mm: residual of control points that make no patch; far beyond any that do */
static const double HOPELESS = 1e3;

static void points_of(const sheet_wish *w, const double *x, kg_patch_input *in) {
    in->point_count = w->point_count;
    in->extent[0] = -1;
    in->extent[1] = 1;
    for (size_t i = 0; i < w->point_count; i++)
        in->points[i] =
            w->planar ? kg_madd(kg_madd(w->origin, x[2 * i], w->along), x[2 * i + 1], w->across)
                      : kg_v3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
}

/* A point in the coordinates of the plane. */
static kg_vec2 in_plane(const sheet_wish *w, kg_vec3 p) {
    p = kg_sub(p, w->origin);
    return kg_v2(kg_dot(p, w->along), kg_dot(p, w->across));
}

/* The line with its leads, which take up LEAD of s each; that of a planar geodesic as seen along
 * the rulings. */
static void line_at(const sheet_wish *w, double s, kg_vec3 *out_point, kg_vec3 *out_normal) {
    const double step = 1e-4;
    double on_line = fmin(fmax((s - LEAD) / (1 - 2 * LEAD), 0), 1);
    w->line(w->user, on_line, out_point, out_normal);
    double lead = s < LEAD ? w->front * (1 - s / LEAD) : w->behind * (s - 1 + LEAD) / LEAD;
    if (s < LEAD || s > 1 - LEAD) {
        kg_vec3 inside, unused;
        w->line(w->user, on_line < 0.5 ? step : 1 - step, &inside, &unused);
        *out_point = kg_madd(*out_point, lead, kg_unit(kg_sub(*out_point, inside)));
    }
    if (w->planar) {
        kg_vec2 p = in_plane(w, *out_point);
        *out_point = kg_madd(kg_madd(w->origin, p.x, w->along), p.y, w->across);
    }
}

/* The s of the line's point nearest to p: the best of a row of places, then Gauss-Newton steps. */
static double nearest(const fit *f, kg_vec3 p) {
    const double step = 1e-5;
    int best = 0;
    for (int i = 1; i <= PLACES; i++)
        if (kg_dist(p, f->places[i]) < kg_dist(p, f->places[best]))
            best = i;
    double s = (double)best / PLACES;
    for (int i = 0; i < 5; i++) {
        double s0 = fmax(0, s - step), s1 = fmin(1, s + step);
        kg_vec3 q, q0, q1, normal;
        line_at(f->wish, s, &q, &normal);
        line_at(f->wish, s0, &q0, &normal);
        line_at(f->wish, s1, &q1, &normal);
        kg_vec3 slope = kg_scale(kg_sub(q1, q0), 1 / (s1 - s0));
        double move = kg_dot(kg_sub(p, q), slope) / kg_dot(slope, slope);
        s = fmin(fmax(s + move, 0), 1);
    }
    return s;
}

static int residuals(void *user, int count, int unknowns, const double *x, double *out, int flag) {
    const fit *f = user;
    const sheet_wish *w = f->wish;
    (void)unknowns, (void)flag;
    kg_patch_input in = {0};
    kg_patch patch;
    points_of(w, x, &in);
    if (kg_patch_init(&in, &patch, NULL) != KG_OK) {
        for (int i = 0; i < count; i++)
            out[i] = HOPELESS;
        return 0;
    }
    double *bends = out + STATIONS * PER_STATION + 2;
    for (int i = 0; i < BENDS; i++)
        bends[i] = 0;
    for (size_t i = 0; i + 2 < in.point_count; i++) {
        const kg_vec3 *p = in.points + i;
        kg_vec3 bend = kg_scale(kg_add(kg_sub(p[0], p[1]), kg_sub(p[2], p[1])), UNEVEN);
        bends[3 * i] = bend.x, bends[3 * i + 1] = bend.y, bends[3 * i + 2] = bend.z;
    }
    for (int i = 0; i < STATIONS; i++) {
        kg_ruling r = kg_patch_ruling(&patch, i / (STATIONS - 1.0));
        kg_vec3 point, normal;
        line_at(w, nearest(f, r.p), &point, &normal);
        kg_vec3 off = kg_sub(r.p, point);
        double away = kg_dot(off, normal);
        kg_vec3 within = kg_madd(off, -away, normal);
        kg_vec3 turned = kg_cross(r.normal, normal);
        if (kg_dot(r.normal, normal) < 0)
            turned = kg_neg(turned);
        double *o = out + i * PER_STATION;
        kg_vec3 place = kg_madd(kg_scale(within, SIDEWAYS), away, normal);
        o[0] = place.x, o[1] = place.y, o[2] = place.z;
        o[3] = HALF_WIDTH * turned.x, o[4] = HALF_WIDTH * turned.y, o[5] = HALF_WIDTH * turned.z;
        if (i == 0 || i == STATIONS - 1) { /* the ends stay at the ends */
            line_at(w, i == 0 ? 0 : 1, &point, &normal);
            out[STATIONS * PER_STATION + (i > 0)] = kg_dot(kg_sub(r.p, point), r.dp) / r.speed;
        }
    }
    return 0;
}

static double rounded(double x, double unit) {
    return round(x / unit) * unit;
}

kg_status sheet_fit(const sheet_wish *wish, kg_patch_input *out_input, kg_error *error) {
    double x[UNKNOWNS], diag[UNKNOWNS], jacobian[UNKNOWNS * RESIDUALS], qtf[UNKNOWNS];
    double w1[UNKNOWNS], w2[UNKNOWNS], w3[UNKNOWNS], w4[RESIDUALS], out[RESIDUALS];
    int pivots[UNKNOWNS], evaluations;
    fit f = {.wish = wish};
    for (int i = 0; i <= PLACES; i++) {
        kg_vec3 normal;
        line_at(wish, (double)i / PLACES, &f.places[i], &normal);
    }
    int per_point = wish->planar ? 2 : 3, unknowns = per_point * (int)wish->point_count;
    for (size_t i = 0; i < wish->point_count; i++) {
        kg_vec3 p, n;
        line_at(wish, (double)i / (double)(wish->point_count - 1), &p, &n);
        double *at = x + per_point * (int)i;
        kg_vec2 q = in_plane(wish, p);
        if (wish->planar)
            at[0] = q.x, at[1] = q.y;
        else
            at[0] = p.x, at[1] = p.y, at[2] = p.z;
    }
    int info = lmdif(residuals, &f, RESIDUALS, unknowns, x, out, 1e-10, 1e-10, 0, 4000, 1e-12, diag,
                     1, 100, 0, &evaluations, jacobian, RESIDUALS, pivots, qtf, w1, w2, w3, w4);
    if (info < 1 || info > 4)
        return kg_fail(error, KG_ERR_INPUT, "the fit does not come to rest (MINPACK says %d)",
                       info);
    for (int i = 0; i < unknowns; i++)
        x[i] = rounded(x[i], wish->planar ? 1e-3 : 1e-4);
    points_of(wish, x, out_input);
    kg_patch patch;
    return kg_patch_init(out_input, &patch, error);
}
