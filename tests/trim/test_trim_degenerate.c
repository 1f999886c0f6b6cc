/* Patches on a small integer grid, where curves run through corners, along edges and through each
 * other's ends: never a crash, a wrong partition or a loop that is not simple. */
#include "tests/trim/regions.h"

#include <stdlib.h>

static double whole_number(kg_random *r, int lo, int hi) {
    return lo + (double)(kg_random_bits(r) % (uint64_t)(hi - lo + 1));
}

static kg_vec3 grid_point(kg_random *r) {
    return kg_v3(10 * whole_number(r, -1, 1), 10 * whole_number(r, -1, 1),
                 10 * whole_number(r, -1, 1));
}

/* Mostly planes and arcs in coordinate planes, with rulings along the axes. */
static kg_patch grid_patch(kg_random *r) {
    for (;;) {
        kg_patch_input in = {.point_count = kg_random_bits(r) % 4 ? 4 : 6};
        kg_vec3 p = grid_point(r), step = kg_v3(0, 0, 0);
        int axis = (int)(kg_random_bits(r) % 3), kind = (int)(kg_random_bits(r) % 4);
        for (size_t i = 0; i < in.point_count; i++) {
            in.points[i] = p;
            if (i == 0 || kind >= 2)
                step = kg_scale(grid_point(r), 0.5);
            if (kind >= 1) { /* stay in a coordinate plane */
                if (axis == 0)
                    step.x = kind == 3 ? step.x : 0;
                else if (axis == 1)
                    step.y = 0;
                else
                    step.z = 0;
            }
            p = kg_add(p, step);
        }
        in.extent[0] = 5 * whole_number(r, -4, 1);
        in.extent[1] = in.extent[0] + 5 * whole_number(r, 1, 6);
        in.has_ruling = kg_random_bits(r) & 1;
        in.ruling = grid_point(r);
        kg_patch patch;
        if (kg_patch_init(&in, &patch, NULL) == KG_OK)
            return patch;
    }
}

static void coincidences_on_a_grid_never_break_the_partition(void **state) {
    (void)state;
    kg_random r = {81};
    size_t trims = 0, split = 0;
    for (int round = 0; round < 1500; round++) {
        char name[32];
        snprintf(name, sizeof name, "round %d", round);
        scene s = {.count = 5};
        for (size_t i = 0; i < s.count; i++)
            s.patches[i] = grid_patch(&r);
        kg_regions now = whole(&s, 0);
        kg_measure before = total(&s, 0, &now);
        kg_trim trim = scene_trim(&s, 0, NULL);
        for (size_t k = 1; k < s.count; k++) {
            kg_cut cut;
            kg_regions next;
            if (!scene_cut(&s, 0, k, &cut) || cut.crossings->count == 0)
                continue;
            char at[64];
            snprintf(at, sizeof at, "%s trim %zu", name, k);
            assert_int_equal(kg_trim_by(&trim, &now, &cut, NULL, 0, &next, NULL), KG_OK);
            check_regions(&s, 0, &next, at);
            kg_measure after = total(&s, 0, &next);
            if (!(fabs(after.space_moment - before.space_moment) <= 2e-6 * before.space_moment))
                fail_msg("%s: %zu pieces have %g of %g mm2", at, next.count, after.space_moment,
                         before.space_moment);
            trims++;
            split += next.count > now.count;
            kg_regions_clear(&now);
            now = next;
        }
        kg_regions_clear(&now);
        scene_clear(&s);
    }
    print_message("%zu trims, %zu split\n", trims, split);
    assert_true(trims > 500 && split > 300);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coincidences_on_a_grid_never_break_the_partition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
