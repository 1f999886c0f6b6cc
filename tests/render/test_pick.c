#include "tests/render/scene.h"

static kg_pick pick_at(const kg_item *items, size_t count, const kg_camera *camera, double x,
                       double y, double radius) {
    kg_scene scene = scene_of(items, count);
    kg_viewport viewport = {0, 0, SIZE, SIZE, 1};
    kg_pick pick = {99, 99, kg_v3(0, 0, 0)};
    kg_error e = {0};
    if (kg_renderer_pick(renderer, &scene, camera, viewport, kg_v2(x, y), radius, &pick, &e))
        fail_msg("%s", e.message);
    return pick;
}

static void picking_finds_the_nearest_item_and_its_place(void **state) {
    (void)state;
    kg_shape *near = square_at(-20, 30), *far = square_at(20, 60);
    kg_item items[2] = {item_of(far, blue, 7), item_of(near, red, 0xfffffff0u)};
    items[1].style.color.a = 0.3f; /* see-through surfaces can be picked */
    for (int k = 0; k < 2; k++) {
        kg_camera camera = front_camera();
        camera.ortho = k;
        kg_pick p = pick_at(items, 2, &camera, 110.5, 80.5, 0);
        kg_vec3 seen;
        assert_int_equal(p.id, 0xfffffff0u);
        assert_int_equal(p.element, p.position.x < p.position.z);
        assert_near(p.position.y, -20, 0.01);
        assert_true(kg_camera_project(&camera, SIZE, SIZE, p.position, &seen));
        assert_near(seen.x, 110.5, 1e-3);
        assert_near(seen.y, 80.5, 1e-3);
        assert_int_equal(pick_at(items, 1, &camera, 110.5, 80.5, 0).id, 7);
        assert_int_equal(pick_at(items, 2, &camera, 2, 2, 5).id, 0);
        assert_int_equal(pick_at(items, 2, &camera, -1, 50, 5).id, 0);
        assert_int_equal(pick_at(items, 2, &camera, 50, NAN, 5).id, 0);
    }
    items[1].id = 0;
    kg_camera camera = front_camera();
    assert_int_equal(pick_at(items, 2, &camera, 100, 100, 3).id, 7);
    kg_shape_destroy(near);
    kg_shape_destroy(far);
}

static void picked_places_lie_on_steep_surfaces_too(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 80);
    kg_item item = item_of(s, blue, 1);
    kg_camera camera = front_camera();
    camera.yaw = 1.4, camera.pitch = 0.5, camera.ortho = false;
    kg_pick p = pick_at(&item, 1, &camera, 101.5, 107.5, 3);
    assert_int_equal(p.id, 1);
    assert_near(p.position.y, 0, 0.01);
    kg_shape_destroy(s);
}

static void points_win_over_lines_and_lines_over_surfaces(void **state) {
    (void)state;
    kg_vec3 p[2] = {kg_v3(-40, 0, 0), kg_v3(40, 0, 0)};
    kg_shape *s = square_at(0, 80), *l = line(p[0], p[1]), *points = NULL;
    assert_int_equal(kg_shape_from_points(p, 2, &points, NULL), KG_OK);
    kg_item items[3] = {item_of(points, red, 3), item_of(l, green, 2), item_of(s, blue, 1)};
    kg_camera camera = front_camera();
    kg_pick pick = pick_at(items, 3, &camera, 140, 106, 6);
    assert_int_equal(pick.id, 3);
    assert_int_equal(pick.element, 1);
    assert_int_equal(pick_at(items, 3, &camera, 100, 104, 6).id, 2);
    assert_int_equal(pick_at(items, 3, &camera, 100, 104, 0).id, 1);
    assert_int_equal(pick_at(items, 3, &camera, 100, 120, 6).id, 1);

    /* What the surface hides is out of reach, unless it shows through. */
    camera.yaw = KG_PI;
    kg_shape *cover = square_at(20, 80);
    kg_item covered[4] = {items[0], items[1], items[2], item_of(cover, blue, 9)};
    assert_int_equal(pick_at(covered, 4, &camera, 60, 100, 6).id, 9);
    covered[0].style.hidden = 0.3f;
    assert_int_equal(pick_at(covered, 4, &camera, 60, 100, 6).id, 3);
    kg_shape_destroy(cover);
    kg_shape_destroy(s);
    kg_shape_destroy(l);
    kg_shape_destroy(points);
}

static void picking_agrees_with_the_picture_at_every_pixel(void **state) {
    (void)state;
    kg_shape *c = cube(30);
    kg_item item = item_of(c, black, 5);
    kg_camera camera = front_camera();
    camera.yaw = 0.6, camera.pitch = 0.4, camera.ortho = false;
    kg_scene scene = scene_of(&item, 1);
    kg_image image = picture(&scene, &camera);
    kg_random r = {4};
    int hits = 0;
    for (int i = 0; i < 300; i++) {
        int x = (int)kg_random_in(&r, 0, SIZE), y = (int)kg_random_in(&r, 0, SIZE);
        bool hit = pick_at(&item, 1, &camera, x, y, 0).id == 5;
        assert_int_equal(hit, at(&image, x, y)[1] < 255 || at(&image, x, y)[0] < 255);
        hits += hit;
    }
    assert_true(hits > 30 && hits < 270);
    kg_image_destroy(&image);
    kg_shape_destroy(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(picking_finds_the_nearest_item_and_its_place),
        cmocka_unit_test(picked_places_lie_on_steep_surfaces_too),
        cmocka_unit_test(points_win_over_lines_and_lines_over_surfaces),
        cmocka_unit_test(picking_agrees_with_the_picture_at_every_pixel),
    };
    return run_with_renderer(tests, sizeof tests / sizeof *tests);
}
