/* Patches: preparation, evaluation, unrolling. */
#include "bench/bench.h"
#include "tests/check.h"

static kg_vec3 any_direction(kg_random *r) {
    kg_vec3 d;
    do
        d = kg_v3(kg_random_in(r, -1, 1), kg_random_in(r, -1, 1), kg_random_in(r, -1, 1));
    while (kg_len(d) > 1 || kg_len(d) < 0.1);
    return kg_unit(d);
}

kg_patch_input bench_patch(int i) {
    /* A C-shaped cubic: two legs bent to one side and twisted a little against each other. */
    kg_random r = {(uint64_t)i * 7919 + 17};
    kg_vec3 along = any_direction(&r), side = kg_unit(kg_cross(along, any_direction(&r)));
    kg_vec3 up = kg_cross(along, side);
    kg_vec3 middle = kg_scale(any_direction(&r), kg_random_in(&r, 0, 15));
    double bend = kg_random_in(&r, 12, 30), twist = kg_random_in(&r, -3, 3);
    kg_patch_input in = {.point_count = 4, .extent = {-35, 35}};
    static const double at[4] = {-50, -17, 17, 50};
    for (int k = 0; k < 4; k++) {
        double high = k == 1 || k == 2 ? bend : 0;
        double off = k == 1 ? twist : k == 2 ? -twist : 0;
        in.points[k] = kg_madd(kg_madd(kg_madd(middle, at[k], along), high, side), off, up);
    }
    return in;
}

void bench_patches(void) {
    enum { PATCHES = 200, POINTS = 2000 };
    static kg_patch patches[PATCHES];
    int n = 0;
    double start = bench_work();
    for (int i = 0; i < PATCHES; i++) {
        kg_patch_input in = bench_patch(i);
        if (kg_patch_init(&in, &patches[n], NULL) == KG_OK)
            n++;
    }
    bench_row("patch: preparation of a cubic", (bench_work() - start) / PATCHES, "us", 0);
    double sum = 0;
    start = bench_work();
    for (int i = 0; i < n; i++)
        for (int k = 0; k < POINTS; k++)
            sum += kg_patch_point(&patches[i], 10, (double)k / POINTS).x;
    bench_row("patch: a point", (bench_work() - start) / n / POINTS, "ns", 0);
    start = bench_work();
    for (int i = 0; i < n; i++)
        for (int k = 0; k < POINTS; k++)
            sum += kg_patch_unroll(&patches[i], 10, (double)k / POINTS).y;
    bench_row("patch: a point on paper", (bench_work() - start) / n / POINTS, "ns", 0);
    if (isnan(sum)) /* keeps the loops above from being dropped */
        bench_row("not a number", sum, "ns", 0);
}
