#include "patch/strain.h"

enum { SAMPLES = 48 };

kg_strain kg_cubic_strain(const kg_vec3 points[4], const double extent[2]) {
    kg_strain s = {0, acos(0)};
    kg_vec3 e[3];
    for (int i = 0; i < 3; i++)
        e[i] = kg_scale(kg_sub(points[i + 1], points[i]), 3);
    kg_vec3 f0 = kg_scale(kg_sub(e[1], e[0]), 2), f1 = kg_scale(kg_sub(e[2], e[1]), 2);
    kg_vec3 third = kg_sub(f1, f0);
    for (int i = 0; i <= SAMPLES; i++) {
        double v = (double)i / SAMPLES, w = 1 - v;
        kg_vec3 d1 =
            kg_add(kg_scale(e[0], w * w), kg_add(kg_scale(e[1], 2 * v * w), kg_scale(e[2], v * v)));
        kg_vec3 d2 = kg_lerp(f0, f1, v), c = kg_cross(d1, d2);
        double s2 = kg_dot(d1, d1), c2 = kg_dot(c, c), q2 = s2 / c2, q3 = q2 * sqrt(q2);
        double eta = kg_dot(c, third) * q3;
        double growth = kg_dot(d1, d2) / s2 - kg_dot(c, kg_cross(d1, third)) / c2;
        /* 1/u = θ'/(|p'| sin θ) with cot θ = η */
        double inverse = -3 * eta * growth / sqrt(s2 * (1 + eta * eta));
        s.reach = fmax(s.reach, fmax(extent[0] * inverse, extent[1] * inverse));
        s.theta = fmin(s.theta, atan2(1, fabs(eta)));
        if (!isfinite(inverse))
            return (kg_strain){(double)NAN, (double)NAN};
    }
    return s;
}
