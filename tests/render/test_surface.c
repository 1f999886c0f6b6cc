#include "katagami/render.h"
#include "tests/check.h"

#include <stdlib.h>

/* A cube of edge 2 as six quads, counter-clockwise from outside. */
static kg_vec3 cube_positions[8] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
static uint32_t cube_corners[24] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                    1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
static uint32_t cube_starts[7] = {0, 4, 8, 12, 16, 20, 24};

static kg_mesh cube(void) {
    kg_mesh m = {.vertex_count = 8, .positions = cube_positions, .face_count = 6};
    m.face_starts = cube_starts;
    m.face_corners = cube_corners;
    return m;
}

static kg_surface converted(const kg_mesh *mesh, size_t first, size_t count, double crease) {
    kg_surface s;
    kg_error e = {0};
    if (kg_surface_from_mesh(mesh, first, count, crease, NULL, &s, &e))
        fail_msg("%s", e.message);
    for (size_t i = 0; i < 3 * s.triangle_count; i++)
        assert_true(s.triangles[i] < s.vertex_count);
    return s;
}

static kg_vec3 triangle_normal(const kg_surface *s, size_t t) {
    kg_vec3 a = s->positions[s->triangles[3 * t]], b = s->positions[s->triangles[3 * t + 1]];
    return kg_cross(kg_sub(b, a), kg_sub(s->positions[s->triangles[3 * t + 2]], a));
}

static void flat_faces_keep_their_own_normals(void **state) {
    (void)state;
    kg_mesh m = cube();
    double creases[] = {0, 1.5}; /* the cube's edges are bent by π/2 */
    for (int i = 0; i < 2; i++) {
        kg_surface s = converted(&m, 0, 6, creases[i]);
        assert_int_equal(s.vertex_count, 24);
        assert_int_equal(s.triangle_count, 12);
        for (size_t k = 0; k < 36; k++) {
            kg_vec3 n = kg_unit(triangle_normal(&s, k / 3));
            assert_near(kg_dist(s.normals[s.triangles[k]], n), 0, 1e-12);
        }
        kg_surface_destroy(&s);
    }
}

static void smooth_edges_share_their_normals(void **state) {
    (void)state;
    kg_mesh m = cube();
    kg_surface s = converted(&m, 0, 6, 1.6);
    assert_int_equal(s.vertex_count, 8);
    for (size_t i = 0; i < 8; i++)
        assert_near(kg_dist(s.normals[i], kg_unit(s.positions[i])), 0, 1e-12);
    kg_surface_destroy(&s);
}

static void own_normals_are_kept(void **state) {
    (void)state;
    kg_mesh m = cube();
    kg_vec3 normals[8];
    for (int i = 0; i < 8; i++)
        normals[i] = kg_v3(0, 0.6, 0.8);
    m.normals = normals;
    kg_surface s = converted(&m, 0, 6, 0.5);
    assert_int_equal(s.vertex_count, 8);
    for (size_t i = 0; i < 8; i++)
        assert_near(kg_dist(s.normals[i], normals[0]), 0, 1e-12);
    kg_surface_destroy(&s);
    s = converted(&m, 0, 6, 0);
    assert_int_equal(s.vertex_count, 24);
    kg_surface_destroy(&s);
}

static void a_range_of_faces_stands_alone(void **state) {
    (void)state;
    kg_mesh m = cube();
    kg_surface s = converted(&m, 2, 2, 3);
    assert_int_equal(s.vertex_count, 6);
    assert_int_equal(s.triangle_count, 4);
    for (size_t i = 0; i < s.vertex_count; i++) /* no corner of x = -1, y = 1 in these faces */
        assert_false(s.positions[i].x < 0 && s.positions[i].y > 0);
    kg_surface_destroy(&s);
    s = converted(&m, 6, 0, 3);
    assert_int_equal(s.triangle_count, 0);
    kg_surface_destroy(&s);
}

static void faces_turned_against_each_other_stay_sharp(void **state) {
    (void)state;
    kg_vec3 positions[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    uint32_t corners[6] = {0, 1, 2, 1, 2, 3}, starts[3] = {0, 3, 6};
    kg_mesh m = {.vertex_count = 4, .positions = positions, .face_count = 2};
    m.face_starts = starts;
    m.face_corners = corners;
    kg_surface s = converted(&m, 0, 2, 3.2);
    assert_int_equal(s.vertex_count, 6);
    kg_surface_destroy(&s);
}

/* A fan of faces around one vertex: the time must not grow with the square of its size. */
static void a_vertex_of_many_faces_is_quick(void **state) {
    (void)state;
    enum { N = 200000 };
    kg_mesh m = {.vertex_count = N + 1, .face_count = N};
    m.positions = calloc(N + 1, sizeof *m.positions);
    m.face_starts = calloc(N + 1, sizeof *m.face_starts);
    m.face_corners = calloc(3 * N, sizeof *m.face_corners);
    assert_true(m.positions && m.face_starts && m.face_corners);
    for (uint32_t i = 0; i < N; i++) {
        m.positions[i + 1] =
            kg_v3(cos(i * 6.28318530717958647 / N), sin(i * 6.28318530717958647 / N), 0);
        m.face_starts[i + 1] = 3 * i + 3;
        m.face_corners[3 * i + 1] = i + 1;
        m.face_corners[3 * i + 2] = (i + 1) % N + 1;
    }
    kg_surface s = converted(&m, 0, N, 1);
    assert_int_equal(s.vertex_count, N + 1);
    for (size_t i = 0; i <= N; i++)
        assert_near(s.normals[i].z, 1, 1e-12);
    kg_surface_destroy(&s);
    free(m.positions);
    free(m.face_starts);
    free(m.face_corners);
}

static void degenerate_faces_give_no_nan(void **state) {
    (void)state;
    kg_vec3 positions[3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    uint32_t corners[3] = {0, 1, 2}, starts[2] = {0, 3};
    kg_mesh m = {.vertex_count = 3, .positions = positions, .face_count = 1};
    m.face_starts = starts;
    m.face_corners = corners;
    kg_surface s = converted(&m, 0, 1, 1);
    for (size_t i = 0; i < s.vertex_count; i++)
        assert_near(kg_len(s.normals[i]), 0, 0);
    kg_surface_destroy(&s);
}

static bool stop_in_time(void *left, double fraction, const char *what) {
    assert_true(fraction >= 0 && fraction <= 1 && what[0]);
    return --*(int *)left != 0;
}

static void a_surface_that_is_cancelled_leaves_what_was_there(void **state) {
    (void)state;
    kg_mesh m = cube();
    kg_surface s = {.vertex_count = 99};
    kg_status status = KG_ERR_CANCELLED;
    int words = 0;
    while (status) { /* stopped at its first word, at its second, … */
        int left = ++words;
        kg_progress progress = {stop_in_time, &left};
        status = kg_surface_from_mesh(&m, 0, 6, 1.6, &progress, &s, NULL);
        assert_true(!status || (status == KG_ERR_CANCELLED && left == 0 && s.vertex_count == 99));
    }
    assert_true(words > 2);
    assert_int_equal(s.vertex_count, 8);
    kg_surface_destroy(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flat_faces_keep_their_own_normals),
        cmocka_unit_test(smooth_edges_share_their_normals),
        cmocka_unit_test(own_normals_are_kept),
        cmocka_unit_test(a_range_of_faces_stands_alone),
        cmocka_unit_test(faces_turned_against_each_other_stay_sharp),
        cmocka_unit_test(a_vertex_of_many_faces_is_quick),
        cmocka_unit_test(degenerate_faces_give_no_nan),
        cmocka_unit_test(a_surface_that_is_cancelled_leaves_what_was_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
