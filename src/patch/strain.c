#include "patch/strain.h"

enum { SAMPLES = 48 };

typedef struct frame {
    kg_vec3 p, d1, d2, c; /* p, p', p'', p'×p'' */
    double s2, c2, q3;    /* |p'|², |c|², (|p'|/|c|)³ */
    double eta;           /* cot θ */
} frame;

static frame frame_at(const kg_vec3 points[4], double v) {
    double w = 1 - v;
    frame f;
    kg_vec3 a = kg_lerp(points[0], points[1], v), b = kg_lerp(points[1], points[2], v),
            c = kg_lerp(points[2], points[3], v);
    kg_vec3 ab = kg_lerp(a, b, v), bc = kg_lerp(b, c, v);
    kg_vec3 f0 = kg_sub(kg_add(points[0], points[2]), kg_scale(points[1], 2)),
            f1 = kg_sub(kg_add(points[1], points[3]), kg_scale(points[2], 2));
    f.p = kg_lerp(ab, bc, v);
    f.d1 = kg_scale(kg_sub(bc, ab), 3);
    f.d2 = kg_add(kg_scale(f0, 6 * w), kg_scale(f1, 6 * v));
    f.c = kg_cross(f.d1, f.d2);
    f.s2 = kg_dot(f.d1, f.d1);
    f.c2 = kg_dot(f.c, f.c);
    double q2 = f.s2 / f.c2;
    f.q3 = q2 * sqrt(q2);
    f.eta = kg_dot(f.c, kg_scale(kg_sub(f1, f0), 6)) * f.q3;
    return f;
}

kg_strain kg_cubic_strain(const kg_vec3 points[4], const double extent[2]) {
    kg_strain s = {0, KG_PI / 2};
    kg_vec3 third = kg_scale(
        kg_add(kg_sub(points[3], points[0]), kg_scale(kg_sub(points[1], points[2]), 3)), 6);
    for (int i = 0; i <= SAMPLES; i++) {
        frame f = frame_at(points, (double)i / SAMPLES);
        double growth = kg_dot(f.d1, f.d2) / f.s2 - kg_dot(f.c, kg_cross(f.d1, third)) / f.c2;
        /* 1/u = θ'/(|p'| sin θ) with cot θ = η */
        double inverse = -3 * f.eta * growth / sqrt(f.s2 * (1 + f.eta * f.eta));
        s.reach = fmax(s.reach, fmax(extent[0] * inverse, extent[1] * inverse));
        s.theta = fmin(s.theta, atan2(1, fabs(f.eta)));
        if (!isfinite(inverse))
            return (kg_strain){(double)NAN, (double)NAN};
    }
    return s;
}

double kg_cubic_reach_back(const kg_vec3 points[4], const double extent[2], kg_vec3 at,
                           kg_vec3 line, kg_vec3 normal, double depth) {
    double most = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        frame f = frame_at(points, (double)i / SAMPLES);
        kg_vec3 d = kg_unit(kg_madd(kg_scale(f.c, 1 / sqrt(f.c2)), f.eta / sqrt(f.s2), f.d1));
        double off = kg_dot(normal, kg_sub(f.p, at)), inverse = -kg_dot(normal, d) / off;
        double reach = fmax(extent[0] * inverse, extent[1] * inverse);
        kg_vec3 x = kg_sub(kg_madd(f.p, 1 / inverse, d), at);
        if (fabs(off) > 1e-6 * depth && kg_len(kg_cross(x, line)) < depth && reach > most)
            most = reach;
    }
    return most;
}
