/* Random patches that rulings make unsound. */
#ifndef KG_TESTS_BAD_PATCH_H
#define KG_TESTS_BAD_PATCH_H

#include "patch/mend.h"
#include "tests/patch/random_patch.h"

/* Arcs and S-curves, twisted, with extents that most of them cannot carry. */
static inline kg_patch_input random_bad(kg_random *r, bool both_ways) {
    kg_patch_input in;
    do {
        in = (kg_patch_input){.point_count = 4};
        double up = kg_random_in(r, 8, 40), down = kg_random_in(r, 8, 40);
        for (size_t i = 0; i < 4; i++)
            in.points[i] = kg_v3(100 * (double)i / 3, 0, 0);
        in.points[1] = kg_add(in.points[1], kg_random_v3(r, (double[6]){-15, 15, -25, 25, 0, 0}));
        in.points[2] = kg_add(in.points[2], kg_random_v3(r, (double[6]){-15, 15, -25, 25, 0, 0}));
        in.points[1].z = up;
        in.points[2].z = both_ways ? -down : down;
        in.extent[0] = kg_random_in(r, -20, -5);
        in.extent[1] = kg_random_in(r, 5, 20);
        in.flip = kg_random_bits(r) & 1;
    } while (kg_patch_is_sound(&in));
    return in;
}

#endif
