/* Bounds, matrices, normals, joining and triangles. */
#include "tests/mesh/samples.h"

#include <stdlib.h>

static double signed_volume(const kg_mesh *mesh) {
    size_t n = kg_mesh_triangle_count(mesh);
    uint32_t *t = malloc(3 * n * sizeof *t);
    assert_int_equal(kg_mesh_triangulate(mesh, t, NULL, NULL), KG_OK);
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += kg_det(mesh->positions[t[3 * i]], mesh->positions[t[3 * i + 1]],
                      mesh->positions[t[3 * i + 2]]);
    free(t);
    return sum / 6;
}

static void a_mirroring_matrix_keeps_fronts_in_front(void **state) {
    (void)state;
    const double mirror[16] = {-2, 0, 0, 5, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1};
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_normals(cube, NULL), KG_OK);
    assert_near(signed_volume(cube), 8, 1e-12);
    assert_int_equal(kg_mesh_transform(cube, mirror, NULL), KG_OK);
    assert_near(signed_volume(cube), 48, 1e-12);
    for (size_t v = 0; v < 8; v++) {
        kg_vec3 out = kg_sub(cube->positions[v], kg_v3(5, 0, 0));
        assert_true(kg_dot(out, cube->normals[v]) > 0);
        assert_near(kg_len(cube->normals[v]), 1, 1e-15);
        /* The inverse transpose: a normal (1,1,1) of the cube shrinks where the cube grows. */
        assert_near(fabs(cube->normals[v].y / cube->normals[v].x), 2, 1e-12);
        assert_near(fabs(cube->normals[v].y / cube->normals[v].z), 3, 1e-12);
    }
    kg_box3 box = kg_mesh_bounds(cube);
    assert_near(box.lo.x, 3, 0);
    assert_near(box.hi.x, 7, 0);
    assert_near(box.hi.z, 3, 0);
    kg_mesh_destroy(cube);
}

static void bad_matrices_leave_the_mesh_alone(void **state) {
    (void)state;
    double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0.5, 1};
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_transform(cube, m, NULL), KG_ERR_INPUT);
    m[14] = 0;
    m[3] = NAN;
    assert_int_equal(kg_mesh_transform(cube, m, NULL), KG_ERR_INPUT);
    m[3] = 1e308;
    m[0] = 1e308;
    assert_int_equal(kg_mesh_transform(cube, m, NULL), KG_ERR_INPUT);
    assert_near(signed_volume(cube), 8, 1e-12);
    kg_mesh_destroy(cube);
}

static void fitting_centers_and_scales_the_longest_side(void **state) {
    (void)state;
    const double m[16] = {1, 0, 0, 100, 0, 4, 0, -7, 0, 0, 2, 3, 0, 0, 0, 1};
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_transform(cube, m, NULL), KG_OK);
    assert_int_equal(kg_mesh_fit(cube, 250, NULL), KG_OK);
    kg_box3 box = kg_mesh_bounds(cube);
    assert_near(box.hi.y, 125, 1e-12);
    assert_near(box.lo.y, -125, 1e-12);
    assert_near(box.hi.x, 31.25, 1e-12);
    assert_near(box.lo.z, -62.5, 1e-12);
    assert_int_equal(kg_mesh_fit(cube, 0, NULL), KG_ERR_INPUT);
    assert_int_equal(kg_mesh_fit(cube, NAN, NULL), KG_ERR_INPUT);
    for (size_t v = 0; v < cube->vertex_count; v++)
        cube->positions[v] = kg_v3(1, 2, 3);
    assert_int_equal(kg_mesh_fit(cube, 250, NULL), KG_ERR_INPUT);
    kg_mesh_destroy(cube);
}

static void bounds_ignore_vertices_without_faces(void **state) {
    (void)state;
    const kg_vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {99, 99, 99}};
    const uint32_t corners[] = {0, 1, 2}, size = 3;
    kg_mesh *mesh = kg_sample_mesh(p, 4, corners, &size, 1);
    assert_near(kg_mesh_bounds(mesh).hi.x, 1, 0);
    kg_mesh_destroy(mesh);
}

static void joined_meshes_keep_faces_and_groups(void **state) {
    (void)state;
    kg_mesh *a = kg_sample_cube(), *b = kg_sample_cube();
    const double away[16] = {1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    assert_int_equal(kg_mesh_transform(b, away, NULL), KG_OK);
    assert_int_equal(kg_mesh_append(a, b, NULL), KG_OK);
    assert_int_equal(a->vertex_count, 16);
    assert_int_equal(a->face_count, 12);
    assert_int_equal(a->group_count, 6);
    assert_int_equal(a->groups[4].first_face, 7);
    assert_string_equal(a->groups[4].name, "屋根");
    assert_near(signed_volume(a), 16, 1e-12);
    assert_near(kg_mesh_bounds(a).hi.x, 11, 0);
    assert_int_equal(kg_mesh_check(a, NULL), KG_OK);
    assert_int_equal(kg_mesh_append(a, a, NULL), KG_OK); /* even to itself */
    assert_int_equal(a->face_count, 24);
    assert_int_equal(kg_mesh_check(a, NULL), KG_OK);
    kg_mesh *none = kg_mesh_create();
    assert_int_equal(kg_mesh_normals(b, NULL), KG_OK);
    assert_int_equal(kg_mesh_append(none, b, NULL), KG_OK);
    assert_non_null(none->normals);
    assert_int_equal(kg_mesh_append(none, a, NULL), KG_OK);
    assert_null(none->normals);
    kg_mesh_destroy(none);
    kg_mesh_destroy(a);
    kg_mesh_destroy(b);
}

/* ---- triangles --------------------------------------------------------------------------- */

static kg_vec3 area_vector(kg_vec3 a, kg_vec3 b, kg_vec3 c) {
    return kg_scale(kg_cross(kg_sub(b, a), kg_sub(c, a)), 0.5);
}

/* The triangles of a simple polygon all face its way and together have its area: then they cover
 * it once. */
static void assert_covered(const kg_vec3 *p, uint32_t n) {
    uint32_t *corners = malloc(n * sizeof *corners), *t = malloc(3 * n * sizeof *t);
    uint32_t *faces = malloc(n * sizeof *faces);
    for (uint32_t i = 0; i < n; i++)
        corners[i] = i;
    kg_mesh *mesh = kg_sample_mesh(p, n, corners, &n, 1);
    assert_int_equal(kg_mesh_triangle_count(mesh), n - 2);
    assert_int_equal(kg_mesh_triangulate(mesh, t, faces, NULL), KG_OK);
    kg_vec3 whole = kg_v3(0, 0, 0);
    for (uint32_t i = 1; i + 1 < n; i++)
        whole = kg_add(whole, area_vector(p[0], p[i], p[i + 1]));
    double sum = 0, area = kg_len(whole);
    for (uint32_t i = 0; i + 2 < n; i++) {
        kg_vec3 a = area_vector(p[t[3 * i]], p[t[3 * i + 1]], p[t[3 * i + 2]]);
        assert_true(kg_dot(a, whole) >= -1e-12 * area * area);
        assert_int_equal(faces[i], 0);
        sum += kg_len(a);
    }
    assert_near(sum, area, 1e-9 * area);
    kg_mesh_destroy(mesh);
    free(corners);
    free(faces);
    free(t);
}

/* A polygon in the plane, set into space in six ways. */
static void assert_covered_everywhere(const kg_vec2 *p, uint32_t n) {
    kg_vec3 *q = malloc(n * sizeof *q);
    const kg_vec3 axes[][2] = {{{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}},
                               {{0, 0, 1}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 0}},
                               {{1, 0, 0}, {0, 0, 1}}, {{0.6, 0.64, 0.48}, {-0.8, 0.48, 0.36}}};
    for (size_t k = 0; k < 6; k++) {
        for (uint32_t i = 0; i < n; i++)
            q[i] = kg_madd(kg_madd(kg_v3(3, -2, 1), p[i].x, axes[k][0]), p[i].y, axes[k][1]);
        assert_covered(q, n);
    }
    free(q);
}

static void concave_polygons_are_covered_once(void **state) {
    (void)state;
    const kg_vec2 arrow[] = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
    assert_covered_everywhere(arrow, 5);
    const kg_vec2 dart[] = {{0, 0}, {2, 1}, {4, 0}, {2, 4}};
    assert_covered_everywhere(dart, 4);
    const kg_vec2 comb[] = {{0, 0}, {7, 0}, {7, 5}, {6, 5}, {6, 1}, {5, 1}, {5, 5}, {4, 5},
                            {4, 1}, {3, 1}, {3, 5}, {2, 5}, {2, 1}, {1, 1}, {1, 5}, {0, 5}};
    assert_covered_everywhere(comb, 16);
}

static void corners_on_straight_sides_are_covered_once(void **state) {
    (void)state;
    const kg_vec2 p[] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {2, 3}, {0, 3}, {0, 2}};
    assert_covered_everywhere(p, 9);
}

static void a_polygon_bridged_to_its_hole_is_covered_once(void **state) {
    (void)state;
    const kg_vec2 p[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                         {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    assert_covered_everywhere(p, 10);
}

static void random_star_polygons_are_covered_once(void **state) {
    (void)state;
    kg_random random = {5};
    kg_vec2 p[60];
    for (int round = 0; round < 300; round++) {
        uint32_t n = 3 + (uint32_t)(kg_random_bits(&random) % 58);
        for (uint32_t i = 0; i < n; i++) {
            double angle = 2 * KG_PI * i / n, r = kg_random_in(&random, 0.05, 1);
            p[i] = kg_v2(r * cos(angle), r * sin(angle));
        }
        if (n > 4)
            assert_covered_everywhere(p, n);
    }
}

static void a_spiral_is_covered_once(void **state) {
    (void)state;
    kg_vec2 p[400];
    for (uint32_t i = 0; i < 200; i++) {
        double angle = 0.15 * i, r = 1 + 0.1 * i;
        p[i] = kg_v2((r + 0.5) * cos(angle), (r + 0.5) * sin(angle));
        p[399 - i] = kg_v2(r * cos(angle), r * sin(angle));
    }
    assert_covered_everywhere(p, 400);
}

static void degenerate_polygons_still_give_their_triangles(void **state) {
    (void)state;
    const kg_vec3 bow_tie[] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const kg_vec3 line[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    const kg_vec3 point[] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    const kg_vec3 star[] = {{0, 1, 0}, {0.6, -0.8, 0}, {-1, 0.3, 0}, {1, 0.3, 0}, {-0.6, -0.8, 0}};
    const struct {
        const kg_vec3 *p;
        uint32_t n;
    } shapes[] = {{bow_tie, 4}, {line, 5}, {point, 4}, {star, 5}};
    const uint32_t corners[] = {0, 1, 2, 3, 4};
    for (size_t s = 0; s < 4; s++) {
        kg_mesh *mesh = kg_sample_mesh(shapes[s].p, shapes[s].n, corners, &shapes[s].n, 1);
        uint32_t t[9], used[5] = {0};
        assert_int_equal(kg_mesh_triangulate(mesh, t, NULL, NULL), KG_OK);
        for (size_t i = 0; i < 3 * kg_mesh_triangle_count(mesh); i++) {
            assert_true(t[i] < shapes[s].n);
            used[t[i]]++;
        }
        for (uint32_t i = 0; i < shapes[s].n; i++)
            assert_true(used[i] > 0);
        kg_mesh_destroy(mesh);
    }
}

static void a_face_of_a_hundred_thousand_teeth_ends(void **state) {
    (void)state;
    uint32_t n = 100000;
    kg_vec3 *p = malloc(n * sizeof *p);
    uint32_t *corners = malloc(n * sizeof *corners), *t = malloc(3 * n * sizeof *t);
    for (uint32_t i = 0; i < n; i++) {
        double angle = 2 * KG_PI * i / n, r = i % 2 ? 1 : 2;
        p[i] = kg_v3(r * cos(angle), r * sin(angle), 0);
        corners[i] = i;
    }
    kg_mesh *mesh = kg_sample_mesh(p, n, corners, &n, 1);
    assert_int_equal(kg_mesh_triangulate(mesh, t, NULL, NULL), KG_OK);
    kg_mesh_destroy(mesh);
    free(p);
    free(corners);
    free(t);
}

static void checks_name_what_is_wrong(void **state) {
    (void)state;
    kg_error error;
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_check(cube, &error), KG_OK);
    cube->groups[1].first_face = 0;
    assert_int_equal(kg_mesh_check(cube, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "group 1"));
    cube->groups[1].first_face = 1;
    cube->groups[2].face_count = 5;
    assert_int_equal(kg_mesh_check(cube, &error), KG_ERR_INPUT);
    cube->groups[2].face_count = 4;
    uint32_t kept = cube->face_corners[9];
    cube->face_corners[9] = cube->face_corners[8];
    assert_int_equal(kg_mesh_check(cube, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "face 2 has vertex 0 twice"));
    cube->face_corners[9] = kept;
    cube->face_starts[3] = cube->face_starts[2] + 2;
    assert_int_equal(kg_mesh_check(cube, &error), KG_ERR_INPUT);
    kg_mesh_destroy(cube);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirroring_matrix_keeps_fronts_in_front),
        cmocka_unit_test(bad_matrices_leave_the_mesh_alone),
        cmocka_unit_test(fitting_centers_and_scales_the_longest_side),
        cmocka_unit_test(bounds_ignore_vertices_without_faces),
        cmocka_unit_test(joined_meshes_keep_faces_and_groups),
        cmocka_unit_test(concave_polygons_are_covered_once),
        cmocka_unit_test(corners_on_straight_sides_are_covered_once),
        cmocka_unit_test(a_polygon_bridged_to_its_hole_is_covered_once),
        cmocka_unit_test(random_star_polygons_are_covered_once),
        cmocka_unit_test(a_spiral_is_covered_once),
        cmocka_unit_test(degenerate_polygons_still_give_their_triangles),
        cmocka_unit_test(a_face_of_a_hundred_thousand_teeth_ends),
        cmocka_unit_test(checks_name_what_is_wrong),
    };
    return cmocka_run_group_tests_name("mesh shape", tests, NULL, NULL);
}
