/* Random patches of every kind for the property tests. */
#ifndef KG_TESTS_RANDOM_PATCH_H
#define KG_TESTS_RANDOM_PATCH_H

#include "katagami/patch.h"
#include "tests/check.h"

/* Coordinates drawn one after the other: compilers call the arguments of a function in different
 * orders, and models should be the same with all of them. `range`: lo, hi of x, then y, then z. */
static inline kg_vec3 kg_random_v3(kg_random *r, const double range[6]) {
    kg_vec3 v;
    v.x = kg_random_in(r, range[0], range[1]);
    v.y = kg_random_in(r, range[2], range[3]);
    v.z = kg_random_in(r, range[4], range[5]);
    return v;
}
static inline kg_vec2 kg_random_v2(kg_random *r, const double range[4]) {
    kg_vec2 v;
    v.x = kg_random_in(r, range[0], range[1]);
    v.y = kg_random_in(r, range[2], range[3]);
    return v;
}

static inline kg_vec3 random_direction(kg_random *r) {
    kg_vec3 d;
    do
        d = kg_random_v3(r, (double[6]){-1, 1, -1, 1, -1, 1});
    while (kg_len(d) > 1 || kg_len(d) < 0.1);
    return kg_unit(d);
}

typedef enum patch_kind {
    ANY,    /* control points anywhere */
    ARC,    /* a twisted arc: what models are made of */
    PLANAR, /* in a plane, inflections included */
    STRAIGHT,
    KIND_COUNT
} patch_kind;

static inline kg_patch_input random_input(kg_random *r, patch_kind kind, size_t count) {
    kg_patch_input in = {.point_count = count};
    kg_vec3 x = random_direction(r), z, y;
    do
        z = kg_cross(x, random_direction(r));
    while (kg_len(z) < 0.1);
    z = kg_unit(z);
    y = kg_cross(z, x);
    for (size_t i = 0; i < count; i++) {
        double t = (double)i / (double)(count - 1), a = 0, b = 0, c = 0;
        switch (kind) {
        case ANY:
            a = kg_random_in(r, -50, 50), b = kg_random_in(r, -50, 50);
            c = kg_random_in(r, -50, 50);
            break;
        case ARC:
            a = 100 * t + kg_random_in(r, -8, 8);
            b = 100 * t * (1 - t) + kg_random_in(r, -4, 4), c = kg_random_in(r, -3, 3);
            break;
        case PLANAR:
            a = 100 * t + kg_random_in(r, -15, 15), b = kg_random_in(r, -40, 40);
            break;
        default:
            a = 100 * t + kg_random_in(r, -15, 15);
        }
        in.points[i] = kg_madd(kg_madd(kg_madd(kg_v3(10, 20, -30), a, x), b, y), c, z);
    }
    in.extent[0] = kg_random_in(r, -30, -1);
    in.extent[1] = kg_random_in(r, 1, 30);
    in.flip = kg_random_bits(r) & 1;
    return in;
}

/* The next patch that can be made; the kind and degree change with `round`. */
static inline kg_patch random_patch(kg_random *r, int round) {
    kg_patch p;
    kg_patch_input in;
    do
        in = random_input(r, (patch_kind)(round % KIND_COUNT), round / KIND_COUNT & 1 ? 6 : 4);
    while (kg_patch_init(&in, &p, NULL) != KG_OK);
    return p;
}

static inline void assert_near3(kg_vec3 a, kg_vec3 b, double tolerance) {
    assert_near(a.x, b.x, tolerance);
    assert_near(a.y, b.y, tolerance);
    assert_near(a.z, b.z, tolerance);
}

#endif
