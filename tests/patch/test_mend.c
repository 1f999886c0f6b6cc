/* Mending: what comes out is sound, keeps the ends and moves little. */
#include "bad_patch.h"
#include "patch/mend.h"

static double movement(const kg_patch_input *a, const kg_patch_input *b) {
    double most = 0;
    for (size_t i = 0; i < a->point_count; i++)
        most = fmax(most, kg_dist(a->points[i], b->points[i]));
    return most;
}

static double turning(kg_vec3 a, kg_vec3 b) {
    return atan2(kg_len(kg_cross(a, b)), kg_dot(a, b));
}

static void bad_arcs_become_sound_with_their_ends_where_they_were(void **state) {
    (void)state;
    kg_random r = {1};
    enum { ROUNDS = 300 };
    int mended = 0, same_tangents = 0;
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch_input in = random_bad(&r, false), out;
        kg_error error;
        if (kg_patch_equalize(&in, &out, &error)) {
            assert_int_equal(error.status, KG_ERR_INPUT);
            continue;
        }
        mended++;
        assert_true(kg_patch_is_sound(&out));
        assert_near3(out.points[0], in.points[0], 0);
        assert_near3(out.points[3], in.points[3], 0);
        assert_memory_equal(out.extent, in.extent, sizeof in.extent);
        same_tangents += turning(kg_sub(out.points[1], out.points[0]),
                                 kg_sub(in.points[1], in.points[0])) < 1e-9 &&
                         turning(kg_sub(out.points[3], out.points[2]),
                                 kg_sub(in.points[3], in.points[2])) < 1e-9;
        /* no farther than it takes */
        kg_patch_input less = in;
        for (size_t i = 0; i < 4; i++)
            less.points[i] = kg_lerp(in.points[i], out.points[i], 0.9);
        kg_patch patch;
        bool wide = !kg_patch_init(&less, &patch, NULL) &&
                    0.93 * patch.regression[0] < in.extent[0] &&
                    0.93 * patch.regression[1] > in.extent[1] && patch.theta[0] > 0.12 &&
                    patch.theta[1] < KG_PI - 0.12;
        assert_false(wide && movement(&in, &out) > 1);
    }
    printf("equalized %d of %d, %d with their tangents\n", mended, ROUNDS, same_tangents);
    assert_true(mended > 0.7 * ROUNDS);
    assert_true(same_tangents > 0.8 * mended);
}

static void a_sound_arc_gets_equal_turning_angles(void **state) {
    (void)state;
    kg_patch_input in = {.points = {{0, 0, 0}, {30, 4, 20}, {75, -3, 25}, {100, 0, 0}},
                         .point_count = 4,
                         .extent = {-3, 3}},
                   out;
    assert_true(kg_patch_is_sound(&in));
    assert_int_equal(kg_patch_equalize(&in, &out, NULL), KG_OK);
    kg_vec3 e[3];
    for (int i = 0; i < 3; i++)
        e[i] = kg_sub(out.points[i + 1], out.points[i]);
    assert_near(turning(e[0], e[1]), turning(e[1], e[2]), 1e-12);
    kg_patch patch;
    assert_int_equal(kg_patch_init(&out, &patch, NULL), KG_OK);
    kg_ruling a = kg_patch_ruling(&patch, 0), b = kg_patch_ruling(&patch, 1);
    assert_near(a.cos_theta, b.cos_theta, 1e-12);
}

static kg_vec3 plane_normal(const kg_patch_input *plane) {
    kg_patch p;
    assert_int_equal(kg_patch_init(plane, &p, NULL), KG_OK);
    return kg_patch_normal(&p, 0);
}

/* Sound halves that touch the plane along a whole ruling, which lies in the cutter; one front. */
static void assert_parts(const kg_patch_input *in, const kg_patch_parts *parts) {
    kg_patch plane, half, cutter;
    assert_int_equal(kg_patch_init(&parts->plane, &plane, NULL), KG_OK);
    kg_vec3 n = plane_normal(&parts->plane), origin = parts->plane.points[0];
    for (int i = 0; i < 2; i++) {
        assert_true(kg_patch_is_sound(&parts->halves[i]));
        assert_int_equal(kg_patch_init(&parts->halves[i], &half, NULL), KG_OK);
        assert_int_equal(kg_patch_init(&parts->cutters[i], &cutter, NULL), KG_OK);
        double u, v, s;
        assert_near(kg_patch_closest(&half, kg_patch_point(&cutter, 0, 0.5), &u, &v), 0, 1e-6);
        assert_near(kg_dot(kg_patch_normal(&half, v), n), 1, 1e-9);
        kg_vec3 way = kg_sub(cutter.geodesic.points[0], cutter.geodesic.points[3]);
        assert_near(fabs(kg_dot(kg_unit(way), kg_patch_ruling(&half, v).d)), 1, 1e-9);
        for (int k = 0; k < 2; k++) {
            kg_vec3 x = kg_patch_point(&half, half.extent[k], v);
            assert_near(kg_dot(kg_sub(x, origin), n), 0, 1e-6);
            assert_near(kg_patch_closest(&plane, x, &u, &s), 0, 1e-6);
            assert_near(kg_patch_closest(&cutter, x, &u, &s), 0, 1e-6);
        }
        assert_true(kg_patch_closest(&half, parts->keep[i], &u, &s) < 1e-6);
        assert_true(i ? v > 1e-3 && v < 0.3 : v > 0.7 && v < 0.999); /* both reach beyond it */
        size_t end = i ? 3 : 0, last = i ? in->point_count - 1 : 0, next = i ? last - 1 : 1;
        assert_near3(parts->halves[i].points[end], in->points[last], 1e-9);
        assert_near(
            turning(kg_sub(parts->halves[i].points[i ? 2 : 1], parts->halves[i].points[end]),
                    kg_sub(in->points[next], in->points[last])),
            0, 1e-7);
    }
    /* the contour is a simple quadrilateral within the plane's rectangle */
    for (int i = 0; i < 4; i++) {
        kg_vec2 a = parts->contour[i], b = parts->contour[(i + 1) % 4],
                c = parts->contour[(i + 2) % 4];
        assert_true(a.x > plane.extent[0] && a.x < plane.extent[1] && a.y > 0 && a.y < 1);
        assert_true(kg_cross2(kg_sub2(b, a), kg_sub2(c, b)) < 0);
    }
}

static void divided_patches_are_sound_and_smooth(void **state) {
    (void)state;
    kg_random r = {2};
    enum { ROUNDS = 40 };
    int divided = 0;
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch_input in = random_bad(&r, round % 4 != 0);
        kg_patch_parts parts;
        kg_error error;
        if (kg_patch_divide(&in, &parts, &error)) {
            assert_int_equal(error.status, KG_ERR_INPUT);
            continue;
        }
        divided++;
        assert_parts(&in, &parts);
    }
    printf("divided %d of %d\n", divided, ROUNDS);
    assert_true(divided > 0.9 * ROUNDS);
}

static void what_cannot_be_mended_is_refused_and_left_alone(void **state) {
    (void)state;
    kg_patch_input planar = {.points = {{0, 0, 0}, {30, 20, 0}, {70, 20, 0}, {100, 0, 0}},
                             .point_count = 4,
                             .extent = {-5, 5}};
    kg_patch_input six = {
        .points = {{0, 0, 0}, {20, 20, 1}, {40, 30, -2}, {60, 30, 3}, {80, 20, 0}, {100, 0, 0}},
        .point_count = 6,
        .extent = {-5, 5}};
    kg_patch_input point = {.point_count = 4, .extent = {-5, 5}}, out;
    kg_patch_input loop = six;
    loop.points[5] = loop.points[0];
    memset(&out, 0x5a, sizeof out);
    kg_patch_input before = out;
    kg_patch_parts parts;
    kg_error error;
    assert_int_equal(kg_patch_equalize(&planar, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "plane"));
    assert_int_equal(kg_patch_equalize(&six, &out, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "six"));
    assert_int_equal(kg_patch_equalize(&point, &out, &error), KG_ERR_INPUT);
    assert_int_equal(kg_patch_flatten(&loop, &out, &error), KG_ERR_INPUT);
    assert_int_equal(kg_patch_divide(&planar, &parts, &error), KG_ERR_INPUT);
    assert_int_equal(kg_patch_divide(&point, &parts, &error), KG_ERR_INPUT);
    assert_memory_equal(&out, &before, sizeof out);
    for (int i = 0; i < 4; i++) {
        kg_patch_input odd = planar;
        odd.points[i].z = i % 2 ? NAN : INFINITY;
        assert_int_equal(kg_patch_equalize(&odd, &out, &error), KG_ERR_INPUT);
        assert_int_equal(kg_patch_divide(&odd, &parts, &error), KG_ERR_INPUT);
    }
}

static void anything_at_all_is_mended_or_refused(void **state) {
    (void)state;
    kg_random r = {3};
    for (int round = 0; round < 24; round++) {
        kg_patch_input in = random_input(&r, (patch_kind)(round % KIND_COUNT),
                                         round / KIND_COUNT & 1 ? 6 : 4),
                       out;
        kg_patch_parts parts;
        if (!kg_patch_equalize(&in, &out, NULL))
            assert_true(kg_patch_is_sound(&out));
        if (!kg_patch_divide(&in, &parts, NULL))
            assert_parts(&in, &parts);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_arcs_become_sound_with_their_ends_where_they_were),
        cmocka_unit_test(a_sound_arc_gets_equal_turning_angles),
        cmocka_unit_test(divided_patches_are_sound_and_smooth),
        cmocka_unit_test(what_cannot_be_mended_is_refused_and_left_alone),
        cmocka_unit_test(anything_at_all_is_mended_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
