/* Contours: what is inside and what is outside of them make up the whole, wherever they run. */
#include "tests/trim/regions.h"

#include <stdlib.h>

/* A plane patch: u in [-30, 30], v along 100 mm of x. */
static scene plane_scene(void) {
    const kg_vec3 p[4] = {{0, 0, 0}, {100.0 / 3, 0, 0}, {200.0 / 3, 0, 0}, {100, 0, 0}},
                  y = {0, 1, 0};
    scene s = {.count = 1};
    s.patches[0] = make_patch(p, 4, -30, 30, &y);
    return s;
}

static kg_status contour(const scene *s, const kg_regions *in, const kg_vec2 *p, size_t n,
                         bool inside, kg_regions *out) {
    kg_trim trim = scene_trim(s, 0, NULL);
    kg_error error = {0};
    kg_status status = kg_trim_contour(&trim, in, p, n, inside, 7, out, &error);
    if (status)
        assert_true(status == KG_ERR_INPUT && error.message[0] != 0);
    else
        check_regions(s, 0, out, "contour");
    return status;
}

/* Areas inside and outside of a contour on the plane; -1: nothing there. */
static void assert_areas(const kg_vec2 *p, size_t n, double inside, double outside, size_t holes) {
    scene s = plane_scene();
    kg_regions all = whole(&s, 0), out;
    for (int turn = 0; turn < 2; turn++) {
        kg_vec2 q[16];
        for (size_t i = 0; i < n; i++)
            q[i] = p[turn ? n - 1 - i : i];
        if (inside < 0) {
            assert_int_equal(contour(&s, &all, q, n, true, &out), KG_ERR_INPUT);
        } else {
            assert_int_equal(contour(&s, &all, q, n, true, &out), KG_OK);
            assert_near(total(&s, 0, &out).space_moment, inside, 1e-6);
            kg_regions_clear(&out);
        }
        if (outside < 0) {
            assert_int_equal(contour(&s, &all, q, n, false, &out), KG_ERR_INPUT);
        } else {
            assert_int_equal(contour(&s, &all, q, n, false, &out), KG_OK);
            assert_near(total(&s, 0, &out).paper_moment, outside, 1e-6);
            assert_int_equal(out.items[0].loop_count, 1 + holes);
            kg_regions_clear(&out);
        }
    }
    kg_regions_clear(&all);
}

static void areas_are_those_of_the_plane_polygons(void **state) {
    (void)state;
    const kg_vec2 hole[4] = {{-10, 0.2}, {10, 0.2}, {10, 0.4}, {-10, 0.4}};
    assert_areas(hole, 4, 400, 5600, 1);
    const kg_vec2 notch[4] = {{-40, 0.2}, {10, 0.2}, {10, 0.4}, {-40, 0.4}};
    assert_areas(notch, 4, 800, 5200, 0);
    const kg_vec2 along[4] = {{-30, 0.2}, {10, 0.2}, {10, 0.4}, {-30, 0.4}};
    assert_areas(along, 4, 800, 5200, 0);
    const kg_vec2 corner[4] = {{-30, 0}, {10, 0}, {10, 0.4}, {-30, 0.4}};
    assert_areas(corner, 4, 1600, 4400, 0);
    const kg_vec2 touching[3] = {{-30, 0.5}, {0, 0.3}, {0, 0.7}}; /* a corner on the outline */
    assert_areas(touching, 3, 600, 5400, 1);
    const kg_vec2 through_corner[3] = {{-60, 0}, {0, 0}, {-30, 0.5}};
    assert_areas(through_corner, 3, 750, 5250, 0);
    const kg_vec2 same[4] = {{-30, 0}, {30, 0}, {30, 1}, {-30, 1}};
    assert_areas(same, 4, 6000, -1, 0);
    const kg_vec2 around[4] = {{-300, -5}, {300, -5}, {300, 10}, {-300, 10}};
    assert_areas(around, 4, 6000, -1, 0);
    const kg_vec2 away[3] = {{50, 0}, {60, 0}, {50, 1}};
    assert_areas(away, 3, -1, 6000, 0);
    const kg_vec2 beside[3] = {{30, 0.2}, {60, 0.4}, {30, 0.6}}; /* touches from outside */
    assert_areas(beside, 3, -1, 6000, 0);
    const kg_vec2 repeated[6] = {{-10, 0.2}, {-10, 0.2}, {10, 0.2},
                                 {10, 0.4},  {-10, 0.4}, {-10, 0.2}};
    assert_areas(repeated, 6, 400, 5600, 1);
    const kg_vec2 huge[3] = {{-1e6, -1e6}, {1e6, -1e6}, {0, 1e6}};
    assert_areas(huge, 3, 6000, -1, 0);
    const kg_vec2 half[4] = {{0, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {0, 1e6}};
    assert_areas(half, 4, 3000, 3000, 0);
}

static void a_contour_that_is_no_polygon_is_refused(void **state) {
    (void)state;
    scene s = plane_scene();
    kg_regions all = whole(&s, 0), out = {7, NULL};
    const kg_vec2 bad[][6] = {
        {{0, 0}, {10, 1}, {10, 0}, {0, 1}, {0, 1}, {0, 1}},           /* crosses itself */
        {{0, 0}, {10, 0.2}, {0, 0.4}, {0, 0.4}, {0, 0.2}, {10, 0.2}}, /* touches a corner */
        {{0, 0}, {10, 0}, {10, 0.5}, {5, 0}, {0, 0.5}, {0, 0.5}},     /* touches a side */
        {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {40, 0}, {50, 0}},        /* no area */
        {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},             /* one point */
        {{0, 0}, {10, 0}, {10, 0.5}, {20, 0.5}, {10, 0.5}, {0, 0.5}}, /* a spike */
        {{0, 0}, {10, 0}, {10, NAN}, {5, 0}, {0, 0.5}, {0, 0.5}},
        {{0, 0}, {10, 0}, {10, INFINITY}, {5, 0}, {0, 0.5}, {0, 0.5}},
        {{0, 0}, {10, 0}, {10, 2e6}, {5, 0}, {0, 0.5}, {0, 0.5}},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int inside = 0; inside < 2; inside++) {
            assert_int_equal(contour(&s, &all, bad[i], 6, inside, &out), KG_ERR_INPUT);
            assert_int_equal(out.count, 7);
        }
    assert_int_equal(contour(&s, &all, bad[0], 2, true, &out), KG_ERR_INPUT);
    kg_regions_clear(&all);
}

/* Random stars, mostly across cuts and outlines, on trimmed random patches. */
static void inside_and_outside_make_up_the_whole(void **state) {
    (void)state;
    kg_random r = {91};
    size_t done = 0;
    for (int round = 0; round < 400; round++) {
        scene s = random_scene(&r, 2, kg_v3(0, 0, 0));
        kg_regions now = whole(&s, 0);
        kg_trim trim = scene_trim(&s, 0, NULL);
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count) {
            kg_regions next;
            assert_int_equal(kg_trim_by(&trim, &now, &cut, NULL, 0, &next, NULL), KG_OK);
            kg_regions_clear(&now);
            now = next;
        }
        kg_vec2 star[12];
        size_t n = 3 + kg_random_bits(&r) % 10;
        double lo = s.patches[0].extent[0], hi = s.patches[0].extent[1];
        double cu = kg_random_in(&r, lo, hi), cv = kg_random_in(&r, 0, 1);
        for (size_t i = 0; i < n; i++) {
            double turn = 6.283185 * (double)i / (double)n, reach = kg_random_in(&r, 0.05, 0.7);
            star[i] = kg_v2(cu + reach * (hi - lo) * cos(turn), cv + reach * sin(turn));
            if (kg_random_in(&r, 0, 1) < 0.2) /* on the outline */
                star[i].x = fmin(fmax(star[i].x, lo), hi);
            if (kg_random_in(&r, 0, 1) < 0.2)
                star[i].y = fmin(fmax(star[i].y, 0), 1);
        }
        kg_regions in = {0}, out = {0};
        kg_status got = contour(&s, &now, star, n, true, &in);
        if (got == KG_OK && contour(&s, &now, star, n, false, &out) == KG_OK) {
            kg_measure before = total(&s, 0, &now), x = total(&s, 0, &in), y = total(&s, 0, &out);
            assert_near(x.space_moment + y.space_moment, before.space_moment,
                        2e-6 * before.space_moment);
            assert_near(x.paper_moment + y.paper_moment, before.paper_moment,
                        2e-6 * before.paper_moment);
            done++;
        }
        kg_regions_clear(&in);
        kg_regions_clear(&out);
        kg_regions_clear(&now);
        scene_clear(&s);
    }
    assert_true(done > 250);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_are_those_of_the_plane_polygons),
        cmocka_unit_test(a_contour_that_is_no_polygon_is_refused),
        cmocka_unit_test(inside_and_outside_make_up_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
