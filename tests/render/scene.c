#include "tests/render/scene.h"

kg_renderer *renderer;

const kg_color black = {0, 0, 0, 1}, red = {1, 0, 0, 1}, green = {0, 1, 0, 1}, blue = {0, 0, 1, 1},
               white = {1, 1, 1, 1};

kg_camera front_camera(void) {
    kg_camera c = kg_camera_default();
    kg_camera_look(&c, KG_VIEW_FRONT);
    c.center = kg_v3(0, 0, 0);
    c.ortho = true;
    c.field_of_view = 2 * atan(0.5);
    c.distance = SIZE;
    return c;
}

kg_scene scene_of(const kg_item *items, size_t count) {
    kg_scene s = {.items = items, .item_count = count};
    s.background_top = s.background_bottom = white;
    return s;
}

kg_shape *surface(kg_vec3 *positions, size_t vertices, uint32_t *triangles, size_t count) {
    kg_surface s = {vertices, positions, NULL, count, triangles};
    kg_shape *shape = NULL;
    assert_int_equal(kg_shape_from_surface(&s, &shape, NULL), KG_OK);
    return shape;
}

kg_shape *square_at(double y, double h) {
    kg_vec3 p[4] = {kg_v3(-h, y, -h), kg_v3(h, y, -h), kg_v3(h, y, h), kg_v3(-h, y, h)};
    uint32_t t[6] = {0, 1, 2, 0, 2, 3};
    return surface(p, 4, t, 2);
}

kg_shape *cube(double h) {
    kg_vec3 p[8];
    for (int i = 0; i < 8; i++)
        p[i] = kg_v3(i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h);
    uint32_t t[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return surface(p, 8, t, 12);
}

kg_shape *line(kg_vec3 a, kg_vec3 b) {
    kg_vec3 p[2] = {a, b};
    uint32_t starts[2] = {0, 2};
    kg_lines lines = {p, starts, 1};
    kg_shape *shape = NULL;
    assert_int_equal(kg_shape_from_lines(&lines, &shape, NULL), KG_OK);
    return shape;
}

kg_item item_of(const kg_shape *shape, kg_color color) {
    kg_item item = {shape, kg_style_default(color)};
    item.style.unlit = true;
    return item;
}

kg_image picture(const kg_scene *scene, const kg_camera *camera) {
    kg_image image = {0};
    kg_error e = {0};
    if (kg_renderer_picture(renderer, scene, camera, SIZE, SIZE, 1, &image, &e))
        fail_msg("%s", e.message);
    return image;
}

const uint8_t *at(const kg_image *image, int x, int y) {
    return image->pixels + 4 * (y * image->width + x);
}

void assert_pixel(const kg_image *image, int x, int y, kg_color c) {
    const uint8_t *p = at(image, x, y);
    assert_near(p[0], 255 * (double)c.r, 1);
    assert_near(p[1], 255 * (double)c.g, 1);
    assert_near(p[2], 255 * (double)c.b, 1);
}

double darkness(const kg_image *image) {
    double sum = 0;
    for (int i = 0; i < image->width * image->height; i++)
        sum += 1 - image->pixels[4 * i + 1] / 255.0;
    return sum;
}

double darkness_of(const kg_item *items, size_t count, const kg_camera *camera) {
    kg_scene scene = scene_of(items, count);
    kg_image image = picture(&scene, camera);
    double sum = darkness(&image);
    kg_image_destroy(&image);
    return sum;
}

int run_with_renderer(const struct CMUnitTest *tests, size_t count) {
    kg_offscreen *offscreen = NULL;
    kg_error e = {0};
    if (kg_offscreen_create(&offscreen, &e) || kg_renderer_create(&renderer, &e)) {
        kg_offscreen_destroy(offscreen);
        print_message("skipped: %s\n", e.message);
        return 77;
    }
    int failed = _cmocka_run_group_tests("render", tests, count, NULL, NULL);
    kg_renderer_destroy(renderer);
    kg_offscreen_destroy(offscreen);
    return failed;
}
