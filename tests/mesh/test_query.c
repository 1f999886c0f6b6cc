/* Rays and nearest points against a search through all triangles. */
#include "tests/mesh/samples.h"

#include <stdlib.h>

/* Cramer's rule for origin + t direction = a + u (b - a) + v (c - a). */
static bool brute_ray(const kg_mesh *mesh, kg_vec3 origin, kg_vec3 direction, double *out_t) {
    bool found = false;
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *c = mesh->face_corners + mesh->face_starts[f];
        kg_vec3 a = mesh->positions[c[0]], e1 = kg_sub(mesh->positions[c[1]], a),
                e2 = kg_sub(mesh->positions[c[2]], a), s = kg_sub(origin, a);
        double det = kg_det(kg_neg(direction), e1, e2);
        if (det == 0)
            continue;
        double t = kg_det(s, e1, e2) / det, u = kg_det(kg_neg(direction), s, e2) / det,
               v = kg_det(kg_neg(direction), e1, s) / det;
        if (t >= 0 && u >= 0 && v >= 0 && u + v <= 1 && (!found || t < *out_t)) {
            *out_t = t;
            found = true;
        }
    }
    return found;
}

/* The distance by cases: inside the prism over the triangle, else to its three sides. */
static double brute_distance(const kg_mesh *mesh, kg_vec3 p) {
    double best = INFINITY;
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *c = mesh->face_corners + mesh->face_starts[f];
        kg_vec3 q[3] = {mesh->positions[c[0]], mesh->positions[c[1]], mesh->positions[c[2]]};
        kg_vec3 n = kg_unit(kg_cross(kg_sub(q[1], q[0]), kg_sub(q[2], q[0])));
        kg_vec3 foot = kg_madd(p, -kg_dot(kg_sub(p, q[0]), n), n);
        double whole = kg_len(kg_cross(kg_sub(q[1], q[0]), kg_sub(q[2], q[0]))), parts = 0;
        for (int i = 0; i < 3; i++) {
            kg_vec3 a = q[i], b = q[(i + 1) % 3], d = kg_sub(b, a);
            parts += kg_len(kg_cross(kg_sub(a, foot), kg_sub(b, foot)));
            double t = kg_dot(d, d) > 0 ? kg_dot(kg_sub(p, a), d) / kg_dot(d, d) : 0;
            best = fmin(best, kg_dist(p, kg_lerp(a, b, fmin(fmax(t, 0), 1))));
        }
        if (whole > 0 && parts <= whole * (1 + 1e-9))
            best = fmin(best, kg_dist(p, foot));
    }
    return best;
}

static kg_vec3 random_point(kg_random *random, double size) {
    kg_vec3 p;
    p.x = kg_random_in(random, -size, size);
    p.y = kg_random_in(random, -size, size);
    p.z = kg_random_in(random, -size, size);
    return p;
}

static kg_mesh_query *query_of(const kg_mesh *mesh) {
    kg_mesh_query *query = NULL;
    kg_error error;
    if (kg_mesh_query_create(mesh, NULL, &query, &error))
        fail_msg("%s", error.message);
    return query;
}

static void rays_meet_what_a_search_through_all_triangles_meets(void **state) {
    (void)state;
    kg_random random = {11};
    size_t met = 0;
    for (int round = 0; round < 20; round++) {
        kg_mesh *soup = kg_sample_soup(&random, 1 + (size_t)round * 8);
        kg_mesh_query *query = query_of(soup);
        for (int i = 0; i < 500; i++) {
            kg_vec3 origin = random_point(&random, i % 2 ? 1 : 50);
            kg_vec3 direction = kg_sub(random_point(&random, 1), i % 2 ? kg_v3(0, 0, 0) : origin);
            kg_mesh_hit hit;
            double t;
            bool expected = brute_ray(soup, origin, direction, &t);
            assert_int_equal(kg_mesh_query_ray(query, origin, direction, &hit), expected);
            if (!expected)
                continue;
            met++;
            assert_near(hit.distance, t * kg_len(direction), 1e-10 * (1 + hit.distance));
            assert_near(kg_dist(hit.point, kg_madd(origin, t, direction)), 0,
                        1e-10 * (1 + hit.distance));
            assert_near(kg_len(hit.normal), 1, 1e-12);
        }
        kg_mesh_query_destroy(query);
        kg_mesh_destroy(soup);
    }
    assert_true(met > 2000);
}

static void nearest_points_are_those_of_a_search_through_all_triangles(void **state) {
    (void)state;
    kg_random random = {12};
    const double sizes[] = {1, 1.5, 30, 900, 1e5};
    for (int round = 0; round < 20; round++) {
        kg_mesh *soup = kg_sample_soup(&random, 1 + (size_t)round * 8);
        kg_mesh_query *query = query_of(soup);
        for (int i = 0; i < 300; i++) {
            kg_vec3 p = random_point(&random, sizes[i % 5]);
            kg_mesh_hit hit;
            assert_true(kg_mesh_query_closest(query, p, &hit));
            double expected = brute_distance(soup, p);
            assert_near(hit.distance, expected, 1e-10 * (1 + expected));
            assert_near(kg_dist(p, hit.point), expected, 1e-10 * (1 + expected));
            assert_true(hit.face < soup->face_count);
        }
        kg_mesh_query_destroy(query);
        kg_mesh_destroy(soup);
    }
}

static void no_ray_slips_through_edges_and_corners(void **state) {
    (void)state;
    kg_random random = {13};
    kg_mesh *cube = kg_sample_cube();
    kg_mesh_query *query = query_of(cube);
    for (int i = 0; i < 2000; i++) {
        kg_vec3 origin = random_point(&random, 0.9), to = cube->positions[i % 8];
        if (i % 3 == 0)
            to = kg_lerp(to, cube->positions[(i % 8) ^ 1], kg_random_in(&random, 0, 1));
        if (i % 3 == 1) /* the diagonals of the quads */
            to = kg_lerp(cube->positions[0], cube->positions[3], kg_random_in(&random, 0, 1));
        kg_mesh_hit hit;
        assert_true(kg_mesh_query_ray(query, origin, kg_sub(to, origin), &hit));
        assert_near(kg_dist(hit.point, to), 0, 1e-12);
    }
    kg_mesh_query_destroy(query);
    kg_mesh_destroy(cube);
}

static void hits_name_the_face_and_its_front(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    kg_mesh_query *query = query_of(cube);
    kg_mesh_hit hit;
    assert_true(kg_mesh_query_ray(query, kg_v3(0.3, 0.2, 1e9), kg_v3(0, 0, -5), &hit));
    assert_near(hit.distance, 1e9 - 1, 1e-6);
    assert_int_equal(hit.face, 1);
    assert_near(hit.point.z, 1, 0);
    assert_near(hit.normal.z, 1, 0);
    assert_true(kg_mesh_query_ray(query, kg_v3(0, 0, 0), kg_v3(0, 0, -1), &hit));
    assert_int_equal(hit.face, 0);
    assert_near(hit.normal.z, -1, 0); /* the front is outside though the ray comes from inside */
    assert_false(kg_mesh_query_ray(query, kg_v3(0, 0, 3), kg_v3(0, 0, 1), &hit));
    assert_false(kg_mesh_query_ray(query, kg_v3(0, 5, 3), kg_v3(0, 0, -1), &hit));
    assert_false(kg_mesh_query_ray(query, kg_v3(0, 0, 3), kg_v3(0, 0, 0), &hit));
    assert_false(kg_mesh_query_ray(query, kg_v3(0, 0, NAN), kg_v3(0, 0, -1), &hit));
    assert_true(kg_mesh_query_closest(query, kg_v3(0.5, -7, 0.25), &hit));
    assert_int_equal(hit.face, 2);
    assert_near(hit.distance, 6, 0);
    assert_false(kg_mesh_query_closest(query, kg_v3(0, INFINITY, 0), &hit));
    kg_mesh_query_destroy(query);
    kg_mesh_destroy(cube);
}

static void size_and_place_of_the_mesh_do_not_matter(void **state) {
    (void)state;
    const double sizes[] = {1e-30, 1e-3, 1e6, 1e30};
    for (size_t i = 0; i < 4; i++) {
        double s = sizes[i];
        const double m[16] = {s, 0, 0, 3 * s, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1};
        kg_mesh *cube = kg_sample_cube();
        assert_int_equal(kg_mesh_transform(cube, m, NULL), KG_OK);
        kg_mesh_query *query = query_of(cube);
        kg_mesh_hit hit;
        assert_true(kg_mesh_query_ray(query, kg_v3(0, 0, 0), kg_v3(1, 0, 0), &hit));
        assert_near(hit.distance / s, 2, 1e-15);
        assert_true(kg_mesh_query_closest(query, kg_v3(0, 0, 0), &hit));
        assert_near(hit.distance / s, 2, 1e-15);
        kg_mesh_query_destroy(query);
        kg_mesh_destroy(cube);
    }
}

static void a_mesh_that_is_one_point_or_empty_has_answers(void **state) {
    (void)state;
    const kg_vec3 p[] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    const uint32_t corners[] = {0, 1, 2}, size = 3;
    kg_mesh *mesh = kg_sample_mesh(p, 3, corners, &size, 1);
    kg_mesh_query *query = query_of(mesh);
    kg_mesh_hit hit;
    assert_true(kg_mesh_query_closest(query, kg_v3(1, 2, 5), &hit));
    assert_near(hit.distance, 2, 0);
    assert_near(kg_len(hit.normal), 0, 0);
    assert_false(kg_mesh_query_ray(query, kg_v3(1, 2, 5), kg_v3(0, 0, -1), &hit));
    kg_mesh_query_destroy(query);
    kg_mesh_destroy(mesh);
    mesh = kg_mesh_create();
    kg_error error;
    query = NULL;
    assert_int_equal(kg_mesh_query_create(mesh, NULL, &query, &error), KG_ERR_INPUT);
    assert_null(query);
    kg_mesh_destroy(mesh);
}

static void points_of_the_bunny_are_found_on_it(void **state) {
    (void)state;
    kg_mesh *bunny = kg_sample_real("stanford-bunny.obj");
    if (!bunny)
        skip();
    assert_int_equal(kg_mesh_fit(bunny, 100, NULL), KG_OK);
    kg_mesh_query *query = query_of(bunny);
    for (size_t f = 0; f < bunny->face_count; f += 97) {
        const uint32_t *c = bunny->face_corners + bunny->face_starts[f];
        kg_vec3 p = kg_lerp(kg_lerp(bunny->positions[c[0]], bunny->positions[c[1]], 0.3),
                            bunny->positions[c[2]], 0.4);
        kg_mesh_hit hit;
        assert_true(kg_mesh_query_closest(query, p, &hit));
        assert_near(hit.distance, 0, 1e-12);
        if (f % (97 * 40) == 0) {
            kg_vec3 from = kg_scale(p, 3);
            assert_true(kg_mesh_query_closest(query, from, &hit));
            assert_near(hit.distance, brute_distance(bunny, from), 1e-10);
        }
    }
    kg_mesh_query_destroy(query);
    kg_mesh_destroy(bunny);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_meet_what_a_search_through_all_triangles_meets),
        cmocka_unit_test(nearest_points_are_those_of_a_search_through_all_triangles),
        cmocka_unit_test(no_ray_slips_through_edges_and_corners),
        cmocka_unit_test(hits_name_the_face_and_its_front),
        cmocka_unit_test(size_and_place_of_the_mesh_do_not_matter),
        cmocka_unit_test(a_mesh_that_is_one_point_or_empty_has_answers),
        cmocka_unit_test(points_of_the_bunny_are_found_on_it),
    };
    return cmocka_run_group_tests_name("mesh query", tests, NULL, NULL);
}
