#include "patch/mend.h"

/* With the parts a_i of the inner points across the chord, in any two directions x, y across it,
 * the angle of the plane is that of the main axis of Σ a_i a_iᵀ: tan 2φ = 2 Σxy / (Σx² − Σy²). */
kg_status kg_patch_flatten(const kg_patch_input *input, kg_patch_input *out, kg_error *error) {
    kg_patch_input in = *input;
    kg_vec3 first = in.points[0], chord = kg_sub(in.points[in.point_count - 1], first);
    if (!(kg_len(chord) > 0))
        return kg_fail(error, KG_ERR_INPUT,
                       "ends where it begins: it has no chord to be flattened along");
    chord = kg_unit(chord);
    kg_vec3 aside = fabs(chord.x) < 0.6 ? kg_v3(1, 0, 0) : kg_v3(0, 1, 0);
    kg_vec3 x = kg_unit(kg_cross(chord, aside)), y = kg_cross(chord, x);
    double xx = 0, xy = 0, yy = 0;
    for (size_t i = 1; i + 1 < in.point_count; i++) {
        kg_vec3 a = kg_sub(in.points[i], first);
        xx += kg_dot(a, x) * kg_dot(a, x);
        xy += kg_dot(a, x) * kg_dot(a, y);
        yy += kg_dot(a, y) * kg_dot(a, y);
    }
    double angle = 0.5 * atan2(2 * xy, xx - yy);
    kg_vec3 normal = kg_add(kg_scale(x, -sin(angle)), kg_scale(y, cos(angle)));
    for (size_t i = 1; i + 1 < in.point_count; i++) {
        double off = kg_dot(kg_sub(in.points[i], first), normal);
        in.points[i] = kg_madd(in.points[i], -off, normal);
    }
    *out = in;
    return KG_OK;
}
