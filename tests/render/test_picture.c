#include "katagami/render.h"
#include "tests/check.h"

#include <cairo.h>
#include <stdlib.h>
#include <unistd.h>

static const double PI = 3.14159265358979323846;

enum { SIZE = 200 }; /* px: pictures of 200 x 200, 1 mm to a pixel */

static kg_renderer *renderer;

static const kg_color red = {1, 0, 0, 1}, green = {0, 1, 0, 1}, blue = {0, 0, 1, 1},
                      white = {1, 1, 1, 1};

/* ---- scenes ----------------------------------------------------------------------------- */

/* From the front, parallel, one pixel to a millimetre, the origin in the middle. */
static kg_camera front_camera(void) {
    kg_camera c = kg_camera_default();
    kg_camera_look(&c, KG_VIEW_FRONT);
    c.center = kg_v3(0, 0, 0);
    c.ortho = true;
    c.field_of_view = 2 * atan(0.5);
    c.distance = SIZE;
    return c;
}

static kg_scene scene_of(const kg_item *items, size_t count) {
    kg_scene s = {.items = items, .item_count = count};
    s.background_top = s.background_bottom = white;
    return s;
}

static kg_shape *surface(kg_vec3 *positions, size_t vertices, uint32_t *triangles, size_t count) {
    kg_surface s = {vertices, positions, NULL, count, triangles};
    kg_shape *shape = NULL;
    assert_int_equal(kg_shape_from_surface(&s, &shape, NULL), KG_OK);
    return shape;
}

/* A square of edge 2h in the plane y, its front towards the front camera. */
static kg_shape *square_at(double y, double h) {
    kg_vec3 p[4] = {kg_v3(-h, y, -h), kg_v3(h, y, -h), kg_v3(h, y, h), kg_v3(-h, y, h)};
    uint32_t t[6] = {0, 1, 2, 0, 2, 3};
    return surface(p, 4, t, 2);
}

static kg_shape *cube(double h) {
    kg_vec3 p[8];
    for (int i = 0; i < 8; i++)
        p[i] = kg_v3(i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h);
    uint32_t t[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return surface(p, 8, t, 12);
}

static kg_shape *line(kg_vec3 a, kg_vec3 b) {
    kg_vec3 p[2] = {a, b};
    uint32_t starts[2] = {0, 2};
    kg_lines lines = {p, starts, 1};
    kg_shape *shape = NULL;
    assert_int_equal(kg_shape_from_lines(&lines, &shape, NULL), KG_OK);
    return shape;
}

static kg_item item_of(const kg_shape *shape, kg_color color, uint32_t id) {
    kg_item item = {shape, kg_style_default(color), id};
    item.style.unlit = true;
    return item;
}

static kg_image picture(const kg_scene *scene, const kg_camera *camera) {
    kg_image image = {0};
    kg_error e = {0};
    if (kg_renderer_picture(renderer, scene, camera, SIZE, SIZE, 1, &image, &e))
        fail_msg("%s", e.message);
    return image;
}

static const uint8_t *at(const kg_image *image, int x, int y) {
    return image->pixels + 4 * (y * image->width + x);
}

static void assert_pixel(const kg_image *image, int x, int y, kg_color c) {
    const uint8_t *p = at(image, x, y);
    assert_near(p[0], 255 * (double)c.r, 1);
    assert_near(p[1], 255 * (double)c.g, 1);
    assert_near(p[2], 255 * (double)c.b, 1);
}

/* How much of the picture is dark, in pixels: black counts 1, white 0. */
static double darkness(const kg_image *image) {
    double sum = 0;
    for (int i = 0; i < image->width * image->height; i++)
        sum += 1 - image->pixels[4 * i + 1] / 255.0;
    return sum;
}

static double darkness_of(const kg_item *items, size_t count, const kg_camera *camera) {
    kg_scene scene = scene_of(items, count);
    kg_image image = picture(&scene, camera);
    double sum = darkness(&image);
    kg_image_destroy(&image);
    return sum;
}

/* ---- surfaces --------------------------------------------------------------------------- */

static void silhouette_of_a_cube_has_its_area(void **state) {
    (void)state;
    kg_shape *c = cube(30);
    kg_item item = item_of(c, white, 1); /* its own colour must not matter */
    kg_scene scene = scene_of(&item, 1);
    scene.silhouette = true;
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    assert_near(darkness(&image), 60 * 60, 60);
    kg_image_destroy(&image);
    camera.yaw = 0.25 * PI; /* a diagonal wide */
    image = picture(&scene, &camera);
    assert_near(darkness(&image), 60 * 60 * sqrt(2), 2 * 60);
    for (int i = 0; i < SIZE * SIZE; i++)
        assert_true(image.pixels[4 * i] == 0 || image.pixels[4 * i] == 255);
    kg_image_destroy(&image);
    kg_shape_destroy(c);
}

static void both_sides_have_their_own_colour(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 50);
    kg_item item = item_of(s, red, 1);
    item.style.back = blue;
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    assert_pixel(&image, 100, 100, red);
    assert_pixel(&image, 10, 10, white);
    kg_image_destroy(&image);
    camera.yaw = PI;
    image = picture(&scene, &camera);
    assert_pixel(&image, 100, 100, blue);
    kg_image_destroy(&image);
    kg_shape_destroy(s);
}

static void shaded_fronts_are_darker_than_backs(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 80);
    kg_item item = item_of(s, kg_palette(0), 1);
    item.style.unlit = false;
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = front_camera();
    for (double turn = -1.2; turn < 1.3; turn += 0.3) {
        int sum[2] = {0};
        for (int side = 0; side < 2; side++) {
            camera.yaw = turn + side * PI;
            kg_image image = picture(&scene, &camera);
            for (int c = 0; c < 3; c++)
                sum[side] += at(&image, 100, 100)[c];
            kg_image_destroy(&image);
        }
        assert_true(sum[0] + 30 < sum[1]);
    }
    kg_shape_destroy(s);
}

static void nearer_surfaces_hide_farther_ones_in_any_order(void **state) {
    (void)state;
    kg_shape *near = square_at(-20, 30), *far = square_at(20, 60);
    for (int order = 0; order < 2; order++) {
        kg_item items[2] = {item_of(order ? near : far, order ? red : blue, 1),
                            item_of(order ? far : near, order ? blue : red, 2)};
        kg_scene scene = scene_of(items, 2);
        kg_camera camera = front_camera();
        kg_image image = picture(&scene, &camera);
        assert_pixel(&image, 100, 100, red);
        assert_pixel(&image, 145, 100, blue);
        kg_image_destroy(&image);
    }
    kg_shape_destroy(near);
    kg_shape_destroy(far);
}

static void see_through_surfaces_mix_from_far_to_near(void **state) {
    (void)state;
    kg_shape *shapes[3] = {square_at(20, 60), square_at(0, 60), square_at(-20, 60)};
    kg_item items[3] = {item_of(shapes[0], blue, 1), item_of(shapes[1], red, 2),
                        item_of(shapes[2], green, 3)};
    items[1].style.color.a = items[2].style.color.a = 0.5f;
    const kg_color expected = {0.25f, 0.5f, 0.25f, 1};
    static const int orders[3][3] = {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}};
    for (int k = 0; k < 3; k++) {
        kg_item shuffled[3] = {items[orders[k][0]], items[orders[k][1]], items[orders[k][2]]};
        kg_scene scene = scene_of(shuffled, 3);
        kg_camera camera = front_camera();
        kg_image image = picture(&scene, &camera);
        assert_pixel(&image, 100, 100, expected);
        kg_image_destroy(&image);
    }
    for (int i = 0; i < 3; i++)
        kg_shape_destroy(shapes[i]);
}

static void highlight_tints_a_surface(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 50);
    kg_item item = item_of(s, blue, 1);
    item.style.highlight = (kg_color){1, 1, 0, 0.25f};
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    assert_pixel(&image, 100, 100, (kg_color){0.25f, 0.25f, 0.75f, 1});
    kg_image_destroy(&image);
    kg_shape_destroy(s);
}

static void shapes_far_from_zero_keep_their_shape(void **state) {
    (void)state;
    const double far = 1e8; /* where floats are 8 apart */
    kg_vec3 p[3] = {kg_v3(far, 0, 0), kg_v3(far + 50, 0, 0), kg_v3(far, 0, 50)};
    uint32_t t[3] = {0, 1, 2};
    kg_shape *s = surface(p, 3, t, 1);
    kg_item item = item_of(s, (kg_color){0, 0, 0, 1}, 1);
    kg_camera camera = front_camera();
    camera.center = kg_v3(far, 0, 0);
    assert_near(darkness_of(&item, 1, &camera), 0.5 * 50 * 50, 50);
    kg_shape_destroy(s);
}

/* ---- lines and points ------------------------------------------------------------------- */

static const kg_color black = {0, 0, 0, 1};

static void a_line_has_its_width_and_dashes(void **state) {
    (void)state;
    kg_shape *l = line(kg_v3(-60, 0, -20), kg_v3(60, 0, 30));
    kg_item item = item_of(l, black, 1);
    kg_camera camera = front_camera();
    for (float width = 1; width < 9; width *= 2) {
        item.style.size_px = width;
        double round_ends = 0.25 * PI * (double)(width * width);
        assert_near(darkness_of(&item, 1, &camera), 130 * (double)width + round_ends, 8);
    }
    item.style.size_px = 2;
    item.style.dashes_px[0] = item.style.dashes_px[1] = 5;
    assert_near(darkness_of(&item, 1, &camera), 130, 10);
    item.style.dashes_px[2] = 1, item.style.dashes_px[3] = 2; /* 6 of 13 */
    assert_near(darkness_of(&item, 1, &camera), 130 * 2 * 6 / 13.0, 10);
    kg_shape_destroy(l);
}

static void outlines_stay_whole_on_tilted_surfaces(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 80), *l = line(kg_v3(-60, 0, -50), kg_v3(70, 0, 60));
    kg_item items[2] = {item_of(l, black, 1), item_of(s, white, 2)};
    items[0].style.size_px = 3;
    items[1].style.back = white;
    for (int i = 0; i < 2 * 7 * 7; i++) {
        kg_camera camera = front_camera();
        camera.yaw = -1.2 + 0.4 * (i % 7);
        camera.pitch = -1.2 + 0.4 * (i / 7 % 7);
        camera.ortho = i >= 7 * 7;
        double alone = darkness_of(items, 1, &camera);
        assert_near(darkness_of(items, 2, &camera) / alone, 1, 0.02);
    }
    kg_shape_destroy(s);
    kg_shape_destroy(l);
}

static void hidden_lines_show_as_faintly_as_asked(void **state) {
    (void)state;
    kg_shape *s = square_at(-20, 80), *l = line(kg_v3(-50, 0, 0), kg_v3(50, 0, 0));
    kg_item items[2] = {item_of(s, white, 1), item_of(l, black, 2)};
    items[1].style.size_px = 4;
    kg_camera camera = front_camera();
    double alone = darkness_of(items + 1, 1, &camera);
    assert_near(darkness_of(items, 2, &camera), 0, 0);
    items[1].style.hidden = 0.25f;
    assert_near(darkness_of(items, 2, &camera) / alone, 0.25, 0.02);
    items[1].style.hidden = 1;
    assert_near(darkness_of(items, 2, &camera) / alone, 1, 0.02);
    kg_shape_destroy(s);
    kg_shape_destroy(l);
}

static void a_line_through_the_eye_is_cut_at_it(void **state) {
    (void)state;
    kg_camera camera = front_camera();
    camera.ortho = false;
    /* From the middle of the picture, through a pixel of the right half, to far behind the eye. */
    kg_vec3 start = kg_v3(0, 0, 0), beyond = kg_v3(80, -5 * camera.distance, 0);
    kg_shape *l = line(start, beyond), *s = square_at(0, 90);
    kg_item items[2] = {item_of(l, black, 1), item_of(s, white, 2)};
    items[0].style.size_px = 4;
    kg_scene scene = scene_of(items, 2);
    kg_image image = picture(&scene, &camera);
    assert_pixel(&image, 104, 100, black);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            bool near_line = x >= 97 && y >= 97 && y < 103;
            assert_true(near_line || at(&image, x, y)[1] == 255);
        }
    }
    kg_image_destroy(&image);
    kg_shape_destroy(s);
    kg_shape_destroy(l);
}

static void points_are_discs_or_squares(void **state) {
    (void)state;
    kg_vec3 p[3] = {kg_v3(-50, 0, 0), kg_v3(0, 0, 30), kg_v3(50, 0, 0)};
    kg_shape *s = NULL;
    assert_int_equal(kg_shape_from_points(p, 3, &s, NULL), KG_OK);
    kg_item item = item_of(s, black, 1);
    kg_camera camera = front_camera();
    item.style.size_px = 12;
    assert_near(darkness_of(&item, 1, &camera), 3 * 36 * PI, 6);
    item.style.square = true;
    assert_near(darkness_of(&item, 1, &camera), 3 * 144, 6);
    kg_shape_destroy(s);
}

/* ---- picking ---------------------------------------------------------------------------- */

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
    camera.yaw = PI;
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

/* ---- pictures --------------------------------------------------------------------------- */

static void the_same_scene_gives_the_same_bytes(void **state) {
    (void)state;
    kg_shape *c = cube(40), *l = line(kg_v3(-90, -50, -70), kg_v3(90, -50, 80));
    kg_item items[2] = {item_of(c, kg_palette(1), 1), item_of(l, kg_palette(2), 2)};
    items[0].style.unlit = false;
    kg_scene scene = scene_of(items, 2);
    scene.axes = true;
    kg_camera camera = kg_camera_default();
    kg_image a = picture(&scene, &camera), b = picture(&scene, &camera);
    assert_memory_equal(a.pixels, b.pixels, SIZE * SIZE * 4);
    kg_image_destroy(&a);
    kg_image_destroy(&b);
    kg_shape_destroy(c);
    kg_shape_destroy(l);
}

/* One wide picture drawn in tiles that meet at other places must look the same. */
static void tiles_join_without_a_seam(void **state) {
    (void)state;
    enum { WIDTH = 1200, HEIGHT = 40 };
    kg_shape *c = cube(1);
    kg_item item = item_of(c, kg_palette(1), 1);
    item.style.unlit = false;
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = kg_camera_default();
    camera.distance = 2; /* the cube fills much more than the height */
    kg_image fine = {0}, coarse = {0};
    assert_int_equal(
        kg_renderer_picture(renderer, &scene, &camera, 2 * WIDTH, 2 * HEIGHT, 1, &fine, NULL),
        KG_OK);
    assert_int_equal(
        kg_renderer_picture(renderer, &scene, &camera, WIDTH, HEIGHT, 2, &coarse, NULL), KG_OK);
    int differ = 0;
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            int mean = (at(&fine, 2 * x, 2 * y)[0] + at(&fine, 2 * x + 1, 2 * y)[0] +
                        at(&fine, 2 * x, 2 * y + 1)[0] + at(&fine, 2 * x + 1, 2 * y + 1)[0] + 2) /
                       4;
            differ += abs(mean - at(&coarse, x, y)[0]) > 1;
        }
    }
    assert_true(differ < WIDTH * HEIGHT / 1000);
    kg_image_destroy(&fine);
    kg_image_destroy(&coarse);
    kg_shape_destroy(c);
}

static void axes_stay_in_their_corner(void **state) {
    (void)state;
    kg_scene scene = scene_of(NULL, 0);
    kg_camera camera = kg_camera_default();
    scene.axes = true;
    kg_image image = picture(&scene, &camera);
    double dark = darkness(&image);
    assert_true(dark > 60 && dark < 600);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++)
            assert_true((x < 90 && y >= SIZE - 90) || at(&image, x, y)[1] == 255);
    }
    kg_image_destroy(&image);
}

static void png_files_hold_the_picture_with_its_transparency(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 50);
    kg_item item = item_of(s, red, 1);
    item.style.color.a = 0.5f;
    kg_scene scene = {.items = &item, .item_count = 1};
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    char path[] = "/tmp/katagami-test-XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    kg_error e = {0};
    assert_int_equal(kg_image_write_png(&image, path, &e), KG_OK);
    cairo_surface_t *read = cairo_image_surface_create_from_png(path);
    assert_int_equal(cairo_surface_status(read), CAIRO_STATUS_SUCCESS);
    assert_int_equal(cairo_image_surface_get_width(read), SIZE);
    const unsigned char *rows = cairo_image_surface_get_data(read);
    uint32_t middle, corner;
    memcpy(&middle, rows + 100 * cairo_image_surface_get_stride(read) + 400, 4);
    memcpy(&corner, rows, 4);
    assert_near(middle >> 24, 128, 1);
    assert_near(middle >> 16 & 255, 128, 1); /* premultiplied */
    assert_int_equal(middle & 0xffff, 0);
    assert_int_equal(corner, 0);
    cairo_surface_destroy(read);
    unlink(path);
    assert_int_equal(kg_image_write_png(&image, "/nonexistent/x.png", &e), KG_ERR_IO);
    kg_image_destroy(&image);
    kg_shape_destroy(s);
}

/* ---- refusals --------------------------------------------------------------------------- */

static void impossible_sizes_are_refused(void **state) {
    (void)state;
    static const int sizes[][3] = {{0, 10, 1},  {10, -1, 1},    {1 << 30, 10, 1}, {10, 1 << 20, 1},
                                   {10, 10, 0}, {10, 10, 1000}, {16000, 10, 8}};
    kg_scene scene = kg_scene_default();
    kg_camera camera = kg_camera_default();
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        kg_image image = {1, 2, NULL};
        kg_error e = {0};
        assert_int_equal(kg_renderer_picture(renderer, &scene, &camera, sizes[i][0], sizes[i][1],
                                             sizes[i][2], &image, &e),
                         KG_ERR_INPUT);
        assert_true(strlen(e.message) > 20);
        assert_int_equal(image.width, 1);
    }
}

static void bad_coordinates_and_indices_are_refused(void **state) {
    (void)state;
    kg_vec3 p[3] = {kg_v3(0, 0, 0), kg_v3(1, NAN, 0), kg_v3(0, 0, 1)};
    uint32_t t[3] = {0, 1, 2};
    kg_surface s = {3, p, NULL, 1, t};
    kg_shape *shape = NULL;
    kg_error e = {0};
    assert_int_equal(kg_shape_from_surface(&s, &shape, &e), KG_ERR_INPUT);
    assert_non_null(strstr(e.message, "point 1"));
    p[1] = kg_v3(1, 0, 0);
    t[2] = 3;
    assert_int_equal(kg_shape_from_surface(&s, &shape, &e), KG_ERR_INPUT);
    assert_non_null(strstr(e.message, "triangle 0"));
    p[1].x = INFINITY;
    assert_int_equal(kg_shape_from_points(p, 3, &shape, &e), KG_ERR_INPUT);
    assert_int_equal(kg_shape_grid(p[0], 0, 10, &shape, &e), KG_ERR_INPUT);
    assert_int_equal(kg_shape_grid(p[0], 1, 0, &shape, &e), KG_ERR_INPUT);
    assert_null(shape);
}

static void empty_shapes_draw_nothing(void **state) {
    (void)state;
    kg_surface none = {0};
    kg_lines no_lines = {0};
    kg_shape *shapes[3] = {NULL};
    assert_int_equal(kg_shape_from_surface(&none, &shapes[0], NULL), KG_OK);
    assert_int_equal(kg_shape_from_lines(&no_lines, &shapes[1], NULL), KG_OK);
    assert_int_equal(kg_shape_from_points(NULL, 0, &shapes[2], NULL), KG_OK);
    kg_item items[3];
    for (int i = 0; i < 3; i++)
        items[i] = item_of(shapes[i], black, 1);
    items[0].style.color.a = 0.5f;
    kg_camera camera = front_camera();
    assert_near(darkness_of(items, 3, &camera), 0, 0);
    assert_int_equal(pick_at(items, 3, &camera, 100, 100, 5).id, 0);
    for (int i = 0; i < 3; i++)
        kg_shape_destroy(shapes[i]);
    kg_shape_destroy(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silhouette_of_a_cube_has_its_area),
        cmocka_unit_test(both_sides_have_their_own_colour),
        cmocka_unit_test(shaded_fronts_are_darker_than_backs),
        cmocka_unit_test(nearer_surfaces_hide_farther_ones_in_any_order),
        cmocka_unit_test(see_through_surfaces_mix_from_far_to_near),
        cmocka_unit_test(highlight_tints_a_surface),
        cmocka_unit_test(shapes_far_from_zero_keep_their_shape),
        cmocka_unit_test(a_line_has_its_width_and_dashes),
        cmocka_unit_test(outlines_stay_whole_on_tilted_surfaces),
        cmocka_unit_test(hidden_lines_show_as_faintly_as_asked),
        cmocka_unit_test(a_line_through_the_eye_is_cut_at_it),
        cmocka_unit_test(points_are_discs_or_squares),
        cmocka_unit_test(picking_finds_the_nearest_item_and_its_place),
        cmocka_unit_test(picked_places_lie_on_steep_surfaces_too),
        cmocka_unit_test(points_win_over_lines_and_lines_over_surfaces),
        cmocka_unit_test(picking_agrees_with_the_picture_at_every_pixel),
        cmocka_unit_test(the_same_scene_gives_the_same_bytes),
        cmocka_unit_test(tiles_join_without_a_seam),
        cmocka_unit_test(axes_stay_in_their_corner),
        cmocka_unit_test(png_files_hold_the_picture_with_its_transparency),
        cmocka_unit_test(impossible_sizes_are_refused),
        cmocka_unit_test(bad_coordinates_and_indices_are_refused),
        cmocka_unit_test(empty_shapes_draw_nothing),
    };
    kg_offscreen *offscreen = NULL;
    kg_error e = {0};
    if (kg_offscreen_create(&offscreen, &e) || kg_renderer_create(&renderer, &e)) {
        kg_offscreen_destroy(offscreen);
        print_message("skipped: %s\n", e.message);
        return 77;
    }
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    kg_renderer_destroy(renderer);
    kg_offscreen_destroy(offscreen);
    return failed;
}
