/* Line drawings: what is hidden of facets that have many corners, or cover each other in a ring. */
#include "guide/figure.h"
#include "tests/check.h"

enum { MANY = 300 };

static void add(kg_figure *f, const kg_vec3 *points, size_t count, kg_side_look first, int32_t id) {
    unsigned char looks[MANY + 2] = {(unsigned char)first};
    assert_int_equal(kg_figure_add(f, points, looks, count, id ? 0x808080 : 0xffffff, id), KG_OK);
}

/* The ground, 0, lies under all blades but over the bar, MANY + 1, which lies over blade 1. */
static int in_a_ring(const void *user, int32_t id, int32_t other) {
    (void)user;
    if (id == 0)
        return other <= MANY ? -1 : 1;
    return id == 1 && other == MANY + 1 ? -1 : 0;
}

/* Every blade covers what is outside of one tangent of a circle: a polygon with as many sides. */
static void pieces_may_get_any_number_of_corners(void **state) {
    const double radius = 9, far = 1000;
    kg_figure f = {0};
    kg_vec3 ground[] = {{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}},
            bar[] = {{-1, -1, 0}, {20, -1, 0}, {20, 1, 0}, {-1, 1, 0}};
    (void)state;
    add(&f, ground, 4, KG_SIDE_NONE, 0);
    for (int32_t i = 0; i < MANY; i++) {
        double angle = 2 * KG_PI * i / MANY;
        kg_vec3 out = kg_v3(cos(angle), sin(angle), 0), along = kg_v3(-out.y, out.x, 0),
                foot = kg_scale(out, radius);
        kg_vec3 blade[] = {kg_madd(foot, -far, along), kg_madd(foot, far, out),
                           kg_madd(foot, far, along)};
        add(&f, blade, 3, KG_SIDE_NONE, i + 1);
    }
    add(&f, bar, 4, KG_SIDE_NONE, MANY + 1);
    assert_int_equal(kg_figure_sort(&f, in_a_ring, NULL), KG_OK);
    const kg_facet *a = &f.facets.items[0];
    assert_true(a->clipped);
    double area = 0;
    for (size_t k = a->first_piece; k < a->first_piece + a->piece_count; k++) {
        size_t begin = f.pieces.items[k - 1], n = f.pieces.items[k] - begin;
        for (size_t i = 0; i < n; i++)
            area += kg_cross2(f.corners.items[begin + i], f.corners.items[begin + (i + 1) % n]) / 2;
    }
    assert_near(area, MANY * radius * radius * tan(KG_PI / MANY), 1e-6);
    kg_figure_clear(&f);
}

static int by_depth(const void *user, int32_t id, int32_t other) {
    (void)user, (void)id, (void)other;
    return 0;
}

/* How many dark pixels are seen where a fold lies just under the edge of a higher facet. */
static int fold_under_an_edge(size_t corners) {
    kg_figure f = {0};
    kg_vec3 half_disc[MANY], above[] = {{-9, -3, 1}, {9, -3, 1}, {9, 0.5, 1}, {-9, 0.5, 1}};
    for (size_t i = 0; i < corners; i++) { /* its first side is the diameter */
        double angle = KG_PI * (double)(i ? i - 1 : corners - 1) / (double)(corners - 1);
        half_disc[i] = kg_v3(8 * cos(angle), 8 * sin(angle), 0);
    }
    half_disc[0] = kg_v3(-8, 0, 0);
    half_disc[1] = kg_v3(8, 0, 0);
    add(&f, half_disc, corners, KG_SIDE_VALLEY, 0);
    add(&f, above, 4, KG_SIDE_NONE, 1);
    assert_int_equal(kg_figure_sort(&f, by_depth, NULL), KG_OK);
    cairo_surface_t *page = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 200, 200);
    cairo_t *cr = cairo_create(page);
    cairo_scale(cr, 10, 10);
    kg_figure_paint(&f, cr, 1, kg_v2(10, 10), kg_v2(0, 0));
    cairo_surface_flush(page);
    int dark = 0;
    for (int y = 90; y < 110; y++)
        for (int x = 25; x < 175; x++)
            dark += cairo_image_surface_get_data(
                        page)[y * cairo_image_surface_get_stride(page) + 4 * x] < 64;
    cairo_destroy(cr);
    cairo_surface_destroy(page);
    kg_figure_clear(&f);
    return dark;
}

static void folds_under_an_edge_are_repeated_on_facets_of_many_corners(void **state) {
    (void)state;
    int few = fold_under_an_edge(20);
    assert_in_range(few, 100, 1000);
    assert_int_equal(fold_under_an_edge(MANY), few);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_may_get_any_number_of_corners),
        cmocka_unit_test(folds_under_an_edge_are_repeated_on_facets_of_many_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
