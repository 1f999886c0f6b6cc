#include "katagami/render.h"
#include "tests/check.h"

static kg_camera random_camera(kg_random *r) {
    kg_camera c = kg_camera_default();
    c.center =
        kg_v3(kg_random_in(r, -500, 500), kg_random_in(r, -500, 500), kg_random_in(r, -500, 500));
    c.distance = kg_random_in(r, 10, 1000);
    c.yaw = kg_random_in(r, -7, 7);
    c.pitch = kg_random_in(r, -1.5, 1.5);
    c.field_of_view = kg_random_in(r, 0.1, 2);
    c.ortho = kg_random_bits(r) & 1;
    return c;
}

static void a_projected_point_lies_on_the_ray_of_its_pixel(void **state) {
    (void)state;
    kg_random r = {1};
    for (int i = 0; i < 2000; i++) {
        kg_camera c = random_camera(&r);
        kg_vec2 pixel = kg_v2(kg_random_in(&r, 0, 1200), kg_random_in(&r, 0, 800));
        kg_vec3 origin, direction, back;
        kg_camera_ray(&c, 1200, 800, pixel, &origin, &direction);
        assert_near(kg_len(direction), 1, 1e-12);
        double along = kg_random_in(&r, 1, 2000);
        kg_vec3 p = kg_madd(origin, along, direction), seen;
        assert_true(kg_camera_project(&c, 1200, 800, p, &seen));
        assert_near(seen.x, pixel.x, 1e-6);
        assert_near(seen.y, pixel.y, 1e-6);
        kg_vec3 right, up;
        kg_camera_axes(&c, &right, &up, &back);
        assert_near(seen.z, -along * kg_dot(direction, back), 1e-9 * 2000);
    }
}

static void points_behind_a_perspective_eye_are_not_projected(void **state) {
    (void)state;
    kg_camera c = kg_camera_default();
    kg_camera_look(&c, KG_VIEW_FRONT);
    kg_vec3 behind = kg_v3(0, -c.distance - 1, 0), seen = kg_v3(7, 7, 7);
    assert_false(kg_camera_project(&c, 100, 100, behind, &seen));
    assert_near(seen.x, 7, 0);
    c.ortho = true;
    assert_true(kg_camera_project(&c, 100, 100, behind, &seen));
    assert_near(seen.z, -1, 1e-9);
}

static void named_views_look_the_way_their_names_say(void **state) {
    (void)state;
    static const struct {
        const char *name;
        kg_vec3 sight, up;
    } views[] = {
        {"front", {0, 1, 0}, {0, 0, 1}}, {"back", {0, -1, 0}, {0, 0, 1}},
        {"left", {1, 0, 0}, {0, 0, 1}},  {"right", {-1, 0, 0}, {0, 0, 1}},
        {"top", {0, 0, -1}, {0, 1, 0}},  {"bottom", {0, 0, 1}, {0, -1, 0}},
    };
    kg_camera c = kg_camera_default();
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        kg_view view;
        assert_true(kg_view_parse(views[i].name, &view));
        assert_string_equal(kg_view_name(view), views[i].name);
        kg_camera_look(&c, view);
        kg_vec3 right, up, back;
        kg_camera_axes(&c, &right, &up, &back);
        assert_near(kg_dist(kg_neg(back), views[i].sight), 0, 1e-12);
        if (view != KG_VIEW_BOTTOM) /* up there is a matter of taste */
            assert_near(kg_dist(up, views[i].up), 0, 1e-12);
        assert_near(kg_dist(kg_cross(right, up), back), 0, 1e-12);
    }
    kg_view untouched = KG_VIEW_TOP;
    assert_false(kg_view_parse("sideways", &untouched));
    assert_false(kg_view_parse("", &untouched));
    assert_int_equal(untouched, KG_VIEW_TOP);
}

/* The box's corners nearly touch an edge of the picture, and none leaves it. */
static void a_fitted_box_fills_the_picture(void **state) {
    (void)state;
    kg_random r = {2};
    for (int i = 0; i < 1000; i++) {
        kg_camera c = random_camera(&r);
        double width = kg_random_in(&r, 100, 1000), height = kg_random_in(&r, 100, 1000);
        kg_box3 box = kg_box3_empty();
        for (int k = 0; k < 3; k++)
            kg_box3_add(&box, kg_v3(kg_random_in(&r, -9, 9), kg_random_in(&r, -9, 9),
                                    kg_random_in(&r, -9, 9)));
        kg_camera_fit(&c, box, width / height);
        double most = 0; /* of the corners' distance from the middle, 1 at the edge */
        for (int k = 0; k < 8; k++) {
            kg_vec3 corner = kg_v3(k & 1 ? box.lo.x : box.hi.x, k & 2 ? box.lo.y : box.hi.y,
                                   k & 4 ? box.lo.z : box.hi.z);
            kg_vec3 seen;
            assert_true(kg_camera_project(&c, width, height, corner, &seen));
            most = fmax(most, fabs(2 * seen.x / width - 1));
            most = fmax(most, fabs(2 * seen.y / height - 1));
        }
        assert_near(most, 1 / 1.05, 1e-9);
    }
}

static void fitting_a_point_or_nothing_leaves_a_working_camera(void **state) {
    (void)state;
    kg_camera c = kg_camera_default(), before = c;
    kg_camera_fit(&c, kg_box3_empty(), 1);
    assert_near(c.distance, before.distance, 0);
    kg_box3 point = {kg_v3(3, 4, 5), kg_v3(3, 4, 5)};
    kg_camera_fit(&c, point, 1);
    assert_true(c.distance > 0);
    kg_vec3 seen;
    assert_true(kg_camera_project(&c, 100, 100, point.lo, &seen));
    assert_near(seen.x, 50, 1e-9);
    assert_near(seen.y, 50, 1e-9);
}

static void pixel_size_is_one_pixel_at_the_center(void **state) {
    (void)state;
    kg_random r = {3};
    for (int i = 0; i < 200; i++) {
        kg_camera c = random_camera(&r);
        kg_vec3 right, up, back, a, b;
        kg_camera_axes(&c, &right, &up, &back);
        double mm = kg_camera_pixel_size(&c, 800);
        assert_true(kg_camera_project(&c, 1200, 800, c.center, &a));
        assert_true(kg_camera_project(&c, 1200, 800, kg_madd(c.center, mm, right), &b));
        assert_near(b.x - a.x, 1, 1e-8);
    }
}

static double brightness(kg_color c) {
    return 0.2126 * (double)c.r + 0.7152 * (double)c.g + 0.0722 * (double)c.b;
}

static void palette_colors_differ_and_repeat(void **state) {
    (void)state;
    for (size_t i = 0; i < 24; i++) {
        kg_color a = kg_palette(i), again = kg_palette(i + 24);
        assert_memory_equal(&a, &again, sizeof a);
        assert_true(brightness(a) > 0.1 && brightness(a) < 0.95);
        for (size_t k = 0; k < i; k++) {
            kg_color b = kg_palette(k);
            assert_true(fabsf(a.r - b.r) + fabsf(a.g - b.g) + fabsf(a.b - b.b) > 0.1f);
        }
    }
}

static void linear_colors_become_srgb(void **state) {
    (void)state;
    kg_color c = kg_color_from_linear((const float[4]){0.214041f, 1, -1, 0.5f});
    assert_near((double)c.r, 0.5, 1e-4);
    assert_near((double)c.g, 1, 0);
    assert_near((double)c.b, 0, 0);
    assert_near((double)c.a, 0.5, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_projected_point_lies_on_the_ray_of_its_pixel),
        cmocka_unit_test(points_behind_a_perspective_eye_are_not_projected),
        cmocka_unit_test(named_views_look_the_way_their_names_say),
        cmocka_unit_test(a_fitted_box_fills_the_picture),
        cmocka_unit_test(fitting_a_point_or_nothing_leaves_a_working_camera),
        cmocka_unit_test(pixel_size_is_one_pixel_at_the_center),
        cmocka_unit_test(palette_colors_differ_and_repeat),
        cmocka_unit_test(linear_colors_become_srgb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
