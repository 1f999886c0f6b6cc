#include "tests/render/scene.h"

#include <cairo.h>
#include <stdlib.h>
#include <unistd.h>

/* ---- surfaces --------------------------------------------------------------------------- */

static void silhouette_of_a_cube_has_its_area(void **state) {
    (void)state;
    kg_shape *c = cube(30);
    kg_item item = item_of(c, white); /* its own colour must not matter */
    kg_scene scene = scene_of(&item, 1);
    scene.silhouette = true;
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    assert_near(darkness(&image), 60 * 60, 60);
    kg_image_destroy(&image);
    camera.yaw = 0.25 * KG_PI; /* a diagonal wide */
    image = picture(&scene, &camera);
    assert_near(darkness(&image), 60 * 60 * sqrt(2), 2 * 60);
    for (int i = 0; i < SIZE * SIZE; i++)
        assert_true(image.pixels[4 * i] == 0 || image.pixels[4 * i] == 255);
    kg_image_destroy(&image);
    kg_shape_destroy(c);
}

static void both_sides_have_their_own_color(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 50);
    kg_item item = item_of(s, red);
    item.style.back = blue;
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = front_camera();
    kg_image image = picture(&scene, &camera);
    assert_pixel(&image, 100, 100, red);
    assert_pixel(&image, 10, 10, white);
    kg_image_destroy(&image);
    camera.yaw = KG_PI;
    image = picture(&scene, &camera);
    assert_pixel(&image, 100, 100, blue);
    kg_image_destroy(&image);
    kg_shape_destroy(s);
}

static void shaded_fronts_are_darker_than_backs(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 80);
    kg_item item = item_of(s, kg_palette(0));
    item.style.unlit = false;
    kg_scene scene = scene_of(&item, 1);
    kg_camera camera = front_camera();
    for (double turn = -1.2; turn < 1.3; turn += 0.3) {
        int sum[2] = {0};
        for (int side = 0; side < 2; side++) {
            camera.yaw = turn + side * KG_PI;
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
        kg_item items[2] = {item_of(order ? near : far, order ? red : blue),
                            item_of(order ? far : near, order ? blue : red)};
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
    kg_item items[3] = {item_of(shapes[0], blue), item_of(shapes[1], red),
                        item_of(shapes[2], green)};
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
    kg_item item = item_of(s, blue);
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
    kg_item item = item_of(s, (kg_color){0, 0, 0, 1});
    kg_camera camera = front_camera();
    camera.center = kg_v3(far, 0, 0);
    assert_near(darkness_of(&item, 1, &camera), 0.5 * 50 * 50, 50);
    kg_shape_destroy(s);
}

/* ---- lines and points ------------------------------------------------------------------- */

static void a_line_has_its_width_and_dashes(void **state) {
    (void)state;
    kg_shape *l = line(kg_v3(-60, 0, -20), kg_v3(60, 0, 30));
    kg_item item = item_of(l, black);
    kg_camera camera = front_camera();
    for (float width = 1; width < 9; width *= 2) {
        item.style.size_px = width;
        double round_ends = 0.25 * KG_PI * (double)(width * width);
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
    kg_item items[2] = {item_of(l, black), item_of(s, white)};
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
    kg_item items[2] = {item_of(s, white), item_of(l, black)};
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
    kg_item items[2] = {item_of(l, black), item_of(s, white)};
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
    kg_item item = item_of(s, black);
    kg_camera camera = front_camera();
    item.style.size_px = 12;
    assert_near(darkness_of(&item, 1, &camera), 3 * 36 * KG_PI, 6);
    item.style.square = true;
    assert_near(darkness_of(&item, 1, &camera), 3 * 144, 6);
    kg_shape_destroy(s);
}

/* ---- edges ------------------------------------------------------------------------------ */

/* Dark pixels of the lines that `crease` leaves of a surface, which hides what is behind it. */
static double edge_darkness(const kg_surface *s, double crease, const kg_camera *camera) {
    kg_shape *shapes[2] = {NULL, NULL};
    assert_int_equal(kg_shape_from_surface(s, &shapes[0], NULL), KG_OK);
    assert_int_equal(kg_shape_from_edges(s, crease, &shapes[1], NULL), KG_OK);
    kg_item items[2] = {item_of(shapes[0], white), item_of(shapes[1], black)};
    items[0].style.back = white;
    items[1].style.size_px = 2;
    double sum = darkness_of(items, 2, camera);
    kg_shape_destroy(shapes[0]);
    kg_shape_destroy(shapes[1]);
    return sum;
}

static void a_cube_shows_creases_or_only_its_contour(void **state) {
    (void)state;
    /* Every face with corners of its own: they must be found to meet. */
    kg_vec3 p[24];
    uint32_t t[36];
    for (uint32_t f = 0; f < 6; f++) {
        for (uint32_t k = 0; k < 4; k++) {
            double c[3], side = f % 2 ? 40 : -40;
            c[f / 2] = side;
            c[(f / 2 + 1) % 3] = (k == 1 || k == 2) == (f % 2) ? 40 : -40;
            c[(f / 2 + 2) % 3] = k >= 2 ? 40 : -40;
            p[4 * f + k] = kg_v3(c[0], c[1], c[2]);
        }
        const uint32_t corners[6] = {0, 1, 2, 0, 2, 3};
        for (int k = 0; k < 6; k++)
            t[6 * f + (uint32_t)k] = 4 * f + corners[k];
    }
    kg_surface s = {24, p, NULL, 12, t};
    kg_camera camera = front_camera();
    camera.yaw = KG_PI / 4;
    camera.pitch = atan(sqrt(0.5)); /* all edges equally foreshortened */
    double edge = 80 * sqrt(2.0 / 3) * 2;
    assert_near(edge_darkness(&s, 1, &camera), 9 * edge, 0.4 * edge);
    assert_near(edge_darkness(&s, KG_PI, &camera), 6 * edge, 0.4 * edge);
}

static void an_open_sheet_shows_its_border(void **state) {
    (void)state;
    kg_vec3 p[4] = {kg_v3(-50, 0, -50), kg_v3(50, 0, -50), kg_v3(50, 0, 50), kg_v3(-50, 0, 50)};
    uint32_t t[6] = {0, 1, 2, 0, 2, 3};
    kg_surface s = {4, p, NULL, 2, t};
    kg_camera camera = front_camera();
    assert_near(edge_darkness(&s, KG_PI, &camera), 4 * 100 * 2, 20);
    t[4] = 3, t[5] = 2; /* the second triangle turned over: still no line between them */
    assert_near(edge_darkness(&s, KG_PI, &camera), 4 * 100 * 2, 20);
}

static void a_tube_shows_its_contour_from_every_side(void **state) {
    (void)state;
    enum { N = 90 };
    kg_vec3 p[2 * N];
    uint32_t t[6 * N];
    for (uint32_t i = 0; i < N; i++) {
        double a = 2 * KG_PI * i / N;
        p[2 * i] = kg_v3(30 * cos(a), 30 * sin(a), -60);
        p[2 * i + 1] = kg_v3(30 * cos(a), 30 * sin(a), 60);
        uint32_t b = 2 * i, n = 2 * ((i + 1) % N);
        const uint32_t corners[6] = {b, n, n + 1, b, n + 1, b + 1};
        memcpy(t + 6 * i, corners, sizeof corners);
    }
    kg_surface s = {2 * N, p, NULL, 2 * N, t};
    kg_camera camera = front_camera();
    for (int i = 0; i < 20; i++, camera.yaw += 0.3) /* two rims seen from the side, two contours */
        assert_near(edge_darkness(&s, 1, &camera), 2 * (2 * 60 + 2 * 120), 20);
}

/* ---- pictures --------------------------------------------------------------------------- */

static void the_same_scene_gives_the_same_bytes(void **state) {
    (void)state;
    kg_shape *c = cube(40), *l = line(kg_v3(-90, -50, -70), kg_v3(90, -50, 80));
    kg_item items[2] = {item_of(c, kg_palette(1)), item_of(l, kg_palette(2))};
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
    kg_item item = item_of(c, kg_palette(1));
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
            assert_true((x < 96 && y >= SIZE - 96) || at(&image, x, y)[1] == 255);
    }
    kg_image_destroy(&image);
}

static void png_files_hold_the_picture_with_its_transparency(void **state) {
    (void)state;
    kg_shape *s = square_at(0, 50);
    kg_item item = item_of(s, red);
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
        items[i] = item_of(shapes[i], black);
    items[0].style.color.a = 0.5f;
    kg_camera camera = front_camera();
    assert_near(darkness_of(items, 3, &camera), 0, 0);
    for (int i = 0; i < 3; i++)
        kg_shape_destroy(shapes[i]);
    kg_shape_destroy(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silhouette_of_a_cube_has_its_area),
        cmocka_unit_test(both_sides_have_their_own_color),
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
        cmocka_unit_test(a_cube_shows_creases_or_only_its_contour),
        cmocka_unit_test(an_open_sheet_shows_its_border),
        cmocka_unit_test(a_tube_shows_its_contour_from_every_side),
        cmocka_unit_test(the_same_scene_gives_the_same_bytes),
        cmocka_unit_test(tiles_join_without_a_seam),
        cmocka_unit_test(axes_stay_in_their_corner),
        cmocka_unit_test(png_files_hold_the_picture_with_its_transparency),
        cmocka_unit_test(impossible_sizes_are_refused),
        cmocka_unit_test(bad_coordinates_and_indices_are_refused),
        cmocka_unit_test(empty_shapes_draw_nothing),
    };
    return run_with_renderer(tests, sizeof tests / sizeof *tests);
}
