/* Single-surface trims: the pieces partition what was there, and GEOS finds the same ones. */
#include "tests/trim/regions.h"

#include <stdlib.h>

static void assert_partition(const scene *s, size_t a, const kg_regions *before,
                             const kg_regions *after, const char *name) {
    kg_measure x = total(s, a, before), y = total(s, a, after);
    double scale = fabs(x.space_moment);
    if (!(fabs(x.space_moment - y.space_moment) <= 1e-6 * scale &&
          fabs(x.paper_moment - y.paper_moment) <= 1e-6 * scale &&
          fabs(y.paper_moment - y.space_moment) <= 1e-6 * scale))
        fail_msg("%s: %zu pieces have %.9g mm2 in space and %.9g on paper, together they had %.9g "
                 "and %.9g",
                 name, after->count, y.space_moment, y.paper_moment, x.space_moment,
                 x.paper_moment);
}

static void assert_same_areas(const kg_patch *p, const kg_regions *pieces, const double *areas,
                              size_t count, const char *name) {
    double own[PIECES_MAX];
    size_t n = areas_of(p, pieces, own);
    for (size_t i = 0; i < n || i < count; i++)
        if (i >= n || i >= count || fabs(own[i] - areas[i]) > 5e-3 + 1e-5 * areas[0])
            fail_msg("%s: piece %zu of %zu has %.9g mm2; GEOS finds %zu, this with %.9g", name, i,
                     n, i < n ? own[i] : 0, count, i < count ? areas[i] : 0);
}

/* All branches of a cut whose ends need no prolonging. */
static bool branches_end_on_the_outline(const kg_crossings *c) {
    for (size_t i = 0; i < c->count; i++)
        for (int e = 0; e < 2; e++)
            if (!c->branches[i].closed && !(c->branches[i].ends[e] & KG_SIDES_A))
                return false;
    return true;
}

static scene random_pair(kg_random *r) {
    scene s = {.count = 2};
    s.patches[0] = random_patch(r, (pair_kind)(kg_random_bits(r) % PAIR_KINDS), kg_v3(0, 0, 0));
    kg_vec3 shift = {kg_random_in(r, -25, 25), kg_random_in(r, -25, 25), kg_random_in(r, -25, 25)};
    s.patches[1] = random_patch(r, (pair_kind)(kg_random_bits(r) % PAIR_KINDS), shift);
    return s;
}

static void pieces_partition_the_rectangle_and_agree_with_geos(void **state) {
    (void)state;
    kg_random r = {71};
    size_t done = 0, compared = 0, several = 0, prolonged = 0;
    for (int round = 0; done < 1000; round++) {
        char name[32];
        snprintf(name, sizeof name, "pair %d", round);
        scene s = random_pair(&r);
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count > 0) {
            kg_regions before = whole(&s, 0), after;
            kg_trim_notes notes = {0};
            kg_trim trim = scene_trim(&s, 0, &notes);
            kg_error error;
            if (kg_trim_by(&trim, &before, &cut, NULL, 0, &after, &error))
                fail_msg("%s: %s", name, error.message);
            check_regions(&s, 0, &after, name);
            assert_partition(&s, 0, &before, &after, name);
            if (branches_end_on_the_outline(cut.crossings)) {
                lines l = {0};
                for (size_t i = 0; i < cut.crossings->count; i++)
                    lines_add(&l, cut.crossings->branches[i].count,
                              cut.crossings->branches[i].points);
                double areas[PIECES_MAX];
                size_t n = pieces_by_geos(&s.patches[0], &before, &l, areas);
                assert_same_areas(&s.patches[0], &after, areas, n, name);
                assert_int_equal(notes.count, 0);
                compared++;
            }
            for (size_t i = 0; i < notes.count; i++)
                prolonged += notes.items[i].kind == KG_NOTE_PROLONGED;
            several += after.count > 2;
            done++;
            free(notes.items);
            kg_regions_clear(&before);
            kg_regions_clear(&after);
        }
        scene_clear(&s);
    }
    print_message("%zu compared, %zu with more than 2 pieces, %zu prolonged\n", compared, several,
                  prolonged);
    assert_true(compared > 150 && several > 5 && prolonged > 300);
}

static void chains_of_trims_partition_the_rectangle(void **state) {
    (void)state;
    kg_random r = {72};
    size_t most = 0;
    for (int round = 0; round < 300; round++) {
        char name[32];
        snprintf(name, sizeof name, "chain %d", round);
        size_t count = 2 + kg_random_bits(&r) % 4;
        scene s = random_scene(&r, count, kg_v3(15, 15, 15));
        kg_regions first = whole(&s, 0), now = whole(&s, 0);
        kg_trim trim = scene_trim(&s, 0, NULL);
        for (size_t k = 1; k < s.count; k++) {
            kg_cut cut;
            if (!scene_cut(&s, 0, k, &cut) || cut.crossings->count == 0)
                continue;
            kg_regions next;
            assert_int_equal(kg_trim_by(&trim, &now, &cut, NULL, 0, &next, NULL), KG_OK);
            check_regions(&s, 0, &next, name);
            assert_partition(&s, 0, &first, &next, name);
            kg_regions_clear(&now);
            now = next;
        }
        most = now.count > most ? now.count : most;
        kg_regions_clear(&first);
        kg_regions_clear(&now);
        scene_clear(&s);
    }
    assert_true(most >= 8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_partition_the_rectangle_and_agree_with_geos),
        cmocka_unit_test(chains_of_trims_partition_the_rectangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
