/* Isometry, frames, sides and signs. */
#include "curve/bernstein.h"
#include "curve/quadrature.h"
#include "random_patch.h"

enum { ROUNDS = 1000 };

/* ---- lengths and areas, in space from X alone, on paper from the net alone --------------- */

/* Speeds are central differences of points, of fourth order: rounding, 1e-16 of the size over the
 * step, and truncation where rulings swing round within a hundredth of the curve both stay below
 * 1e-9 of the length. */
#define STEP 1e-4

typedef struct path { /* a straight line in (u,v) */
    double u0, v0, u1, v1;
} path;

/* Fourth-order central difference of position along a path, in space or on paper. */
static void path_velocity(const kg_patch *p, path l, double t, kg_vec3 *space, kg_vec2 *paper) {
    static const double weight[4] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
    *space = kg_v3(0, 0, 0);
    *paper = kg_v2(0, 0);
    double step = fmin(STEP, 0.4 * fmin(t, 1 - t));
    for (int i = 0; i < 4; i++) {
        double s = t + step * (i < 2 ? i - 2 : i - 1);
        double u = l.u0 + (l.u1 - l.u0) * s, v = l.v0 + (l.v1 - l.v0) * s;
        *space = kg_madd(*space, weight[i] / step, kg_patch_point(p, u, v));
        *paper = kg_add2(*paper, kg_scale2(kg_patch_unroll(p, u, v), weight[i] / step));
    }
}

/* Both by the same Gauss points in equal cells. */
static void path_lengths(const kg_patch *p, path l, int cells, double *space, double *paper) {
    *space = *paper = 0;
    for (int i = 0; i < cells; i++)
        for (int k = 0; k < KG_GAUSS_COUNT; k++) {
            kg_vec3 a;
            kg_vec2 b;
            path_velocity(p, l, (i + kg_gauss_node[k]) / cells, &a, &b);
            *space += kg_gauss_weight[k] / cells * kg_len(a);
            *paper += kg_gauss_weight[k] / cells * kg_len2(b);
        }
}

static void every_boundary_is_as_long_on_paper_as_in_space(void **state) {
    (void)state;
    kg_random r = {1};
    double worst = 0;
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        const double *e = p.extent;
        double w0 = kg_random_in(&r, 0, 1), w1 = kg_random_in(&r, 0, 1);
        const path paths[] = {
            {e[0], 0, e[0], 1}, {e[1], 0, e[1], 1},   {e[0], 0, e[1], 0},
            {e[0], 1, e[1], 1}, {e[0], w0, e[1], w1}, /* a diagonal */
        };
        for (size_t i = 0; i < 5; i++) {
            /* a ruling is straight: one cell is exact */
            double space, paper;
            path_lengths(&p, paths[i], paths[i].v0 == paths[i].v1 ? 1 : 12, &space, &paper);
            worst = fmax(worst, fabs(paper / space - 1));
            assert_near(paper / space, 1, 1e-7); /* nets promise 1e-6 */
        }
    }
    print_message("worst relative length error %.2g\n", worst);
}

static void areas_agree_too(void **state) {
    (void)state;
    kg_random r = {2};
    double worst = 0;
    for (int round = 0; round < ROUNDS / 2; round++) {
        kg_patch p = random_patch(&r, round);
        double space = 0, paper = 0;
        for (int i = 0; i < 6 * KG_GAUSS_COUNT; i++)
            for (int j = 0; j < 3; j++) {
                double v = (i / KG_GAUSS_COUNT + kg_gauss_node[i % KG_GAUSS_COUNT]) / 6;
                double u = p.extent[0] + (p.extent[1] - p.extent[0]) * j / 2;
                double w =
                    kg_gauss_weight[i % KG_GAUSS_COUNT] * (j == 1 ? 4 : 1); /* Simpson in u */
                const path along = {u, 0, u, 1};
                kg_vec3 xv,
                    xu = kg_sub(kg_patch_point(&p, u + 0.5, v), kg_patch_point(&p, u - 0.5, v));
                kg_vec2 yv,
                    yu = kg_sub2(kg_patch_unroll(&p, u + 0.5, v), kg_patch_unroll(&p, u - 0.5, v));
                path_velocity(&p, along, v, &xv, &yv);
                space += w * kg_len(kg_cross(xu, xv));
                paper += w * kg_cross2(yu, yv); /* signed: a fold on paper would cancel */
            }
        worst = fmax(worst, fabs(paper / space - 1));
        assert_near(paper / space, 1, 1e-7);
    }
    print_message("worst relative area error %.2g\n", worst);
}

/* The test of the test: with rulings p''×p''' in derivatives by v, one constant vector for a
 * cubic, the same comparison is wrong by percents. */
static void the_parameter_derivative_ruling_fails_by_percents(void **state) {
    (void)state;
    kg_random r = {3};
    int wrong = 0, rounds = 200;
    for (int round = 0; round < rounds; round++) {
        kg_patch_input in;
        kg_patch p;
        do
            in = random_input(&r, ARC, 4);
        while (kg_patch_init(&in, &p, NULL) != KG_OK);
        kg_vec3 d[4];
        kg_curve_derivatives(&p.geodesic, 0, 3, d);
        p.rulings[0] = kg_unit(kg_cross(d[2], d[3]));
        p.ruling_degree = 0;
        double space, paper;
        path_lengths(&p, (path){p.extent[1], 0, p.extent[1], 1}, 12, &space, &paper);
        wrong += fabs(paper / space - 1) > 0.01;
    }
    assert_true(wrong > rounds / 4);
}

static void the_geodesic_unrolls_to_a_vertical_line_of_its_length(void **state) {
    (void)state;
    kg_random r = {4};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double v = kg_random_in(&r, 0, 1);
        kg_vec2 q = kg_patch_unroll(&p, 0, v);
        assert_true(q.x == 0);
        assert_near(q.y, kg_curve_length(&p.geodesic, 0, v), 1e-12 * q.y);
        /* p'' has no part in the tangent plane across p': a geodesic in space as well */
        kg_ruling g = kg_patch_ruling(&p, v);
        kg_vec3 across = kg_cross(g.normal, g.dp);
        assert_near(kg_dot(g.ddp, across) / (kg_len(g.ddp) * kg_len(across)), 0, 1e-8);
    }
}

/* ---- derivatives, normals, sides --------------------------------------------------------- */

static void derivatives_agree_with_differences(void **state) {
    (void)state;
    kg_random r = {5};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double u = kg_random_in(&r, p.extent[0], p.extent[1]), v = kg_random_in(&r, 0.05, 0.95);
        kg_vec3 du, dv, space;
        kg_vec2 qu, qv, paper;
        assert_near3(kg_patch_derivatives(&p, u, v, &du, &dv), kg_patch_point(&p, u, v), 1e-9);
        kg_vec2 q = kg_patch_unroll_derivatives(&p, u, v, &qu, &qv);
        assert_near(kg_dist2(q, kg_patch_unroll(&p, u, v)), 0, 1e-12);
        path_velocity(&p, (path){u, 0, u, 1}, v, &space, &paper);
        /* of lengths: |X_v| is the scale; sharp rulings turn within a few steps */
        assert_near(kg_dist(space, dv) / kg_len(kg_patch_ruling(&p, v).dp), 0, 1e-5);
        assert_near(kg_dist2(paper, qv) / kg_len(kg_patch_ruling(&p, v).dp), 0, 1e-5);
        assert_near3(kg_sub(kg_patch_point(&p, u + 1, v), kg_patch_point(&p, u, v)), du, 1e-12);
        /* first fundamental forms: the isometry itself, pointwise */
        assert_near(kg_dot(dv, dv), kg_dot2(qv, qv), 1e-8 * kg_dot(dv, dv));
        assert_near(kg_dot(du, dv), kg_dot2(qu, qv), 1e-8 * kg_len(dv));
        assert_near(kg_dot(du, du), kg_dot2(qu, qu), 1e-12);
    }
}

static void normals_are_unit_square_to_the_surface_and_turned_by_flip(void **state) {
    (void)state;
    kg_random r = {6};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double u = kg_random_in(&r, p.extent[0], p.extent[1]), v = kg_random_in(&r, 0, 1);
        kg_vec3 n = kg_patch_normal(&p, v), du, dv;
        kg_patch_derivatives(&p, u, v, &du, &dv);
        assert_near(kg_len(n), 1, 1e-12);
        assert_near(kg_dot(n, du), 0, 1e-9);
        assert_near(kg_dot(n, kg_unit(dv)), 0, 1e-7);
        /* X_v × X_u points to the front, all over the rectangle */
        assert_true(kg_dot(kg_cross(dv, du), n) * (p.flip ? -1 : 1) > 0);
        p.flip = !p.flip;
        assert_near3(kg_patch_normal(&p, v), kg_neg(n), 0);
    }
}

/* Paper has x to the right and y down. Someone who looks at the front (against the normal) sees the
 * surface the same way: right × down points away from him. A flipped patch shows its other side,
 * where the same drawing has to be mirrored in x. */
static void the_paper_frame_is_not_mirrored_on_the_front(void **state) {
    (void)state;
    kg_random r = {7};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double u = kg_random_in(&r, p.extent[0], p.extent[1]), v = kg_random_in(&r, 0, 1);
        kg_vec3 du, dv;
        kg_vec2 qu, qv;
        kg_patch_derivatives(&p, u, v, &du, &dv);
        kg_patch_unroll_derivatives(&p, u, v, &qu, &qv);
        if (p.flip) /* what the net does to a flipped part */
            qu.x = -qu.x, qv.x = -qv.x;
        /* the directions in space of the paper's x and y axes: solve [qu qv] [a b]' = axis */
        double det = kg_cross2(qu, qv);
        kg_vec3 right = kg_scale(kg_madd(kg_scale(du, qv.y), -qu.y, dv), 1 / det);
        kg_vec3 down = kg_scale(kg_madd(kg_scale(dv, qu.x), -qv.x, du), 1 / det);
        assert_near(kg_len(right), 1, 1e-7);
        assert_near(kg_dot(right, down), 0, 1e-7);
        assert_near3(kg_cross(right, down), kg_neg(kg_patch_normal(&p, v)), 1e-6);
        /* the geodesic runs down, the ruling to the right of it on an unflipped part */
        assert_true(kg_dot(down, kg_patch_ruling(&p, v).dp) > 0);
        assert_true((p.flip ? -1 : 1) * kg_dot(right, du) > 0);
    }
}

/* ---- the sign of d ---------------------------------------------------------------------- */

static void rulings_start_along_d_and_never_jump(void **state) {
    (void)state;
    kg_random r = {8};
    for (int round = 0; round < 400; round++) {
        kg_patch p = random_patch(&r, round);
        kg_vec3 d[4];
        kg_curve_derivatives(&p.geodesic, 0, 3, d);
        kg_vec3 c = kg_cross(d[1], d[2]);
        kg_vec3 axis =
            kg_add(kg_scale(d[1], kg_dot(d[1], d[1]) * kg_dot(c, d[3])), kg_scale(c, kg_dot(c, c)));
        kg_vec3 before = kg_patch_ruling(&p, 0).d;
        assert_near(kg_len(before), 1, 1e-12);
        if (p.shape != KG_CURVE_STRAIGHT)
            assert_true(kg_dot(before, axis) > 0);
        for (int i = 1; i <= 300; i++) {
            kg_ruling g = kg_patch_ruling(&p, i / 300.0);
            assert_near(kg_len(g.d), 1, 1e-12);
            assert_near(kg_dot(g.d, g.dd), 0, 1e-9 * (1 + kg_len(g.dd)));
            /* swings stay under the integral of |d'|; a jump of sign would be 2 */
            assert_true(kg_dist(g.d, before) < 1.9 || kg_len(g.dd) > 100);
            before = g.d;
        }
    }
}

static void the_stored_polynomial_points_along_d(void **state) {
    (void)state;
    kg_random r = {9};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double v = kg_random_in(&r, 0, 1), largest = 0;
        for (int i = 0; i <= p.ruling_degree; i++)
            largest = fmax(largest, kg_len(p.rulings[i]));
        assert_near(largest, 1, 1e-12);
        kg_vec3 value = kg_bernstein_eval3(p.rulings, p.ruling_degree, v);
        /* coefficients hold 1e-13 of the largest, which is 1 */
        assert_near3(value, kg_scale(kg_patch_ruling(&p, v).d, kg_len(value)), 1e-13);
    }
}

static void lengths_come_from_cells_as_exactly_as_from_the_start(void **state) {
    (void)state;
    kg_random r = {10};
    for (int round = 0; round < ROUNDS; round++) {
        kg_patch p = random_patch(&r, round);
        double whole = kg_curve_length(&p.geodesic, 0, 1);
        const double places[] = {0, 1, 0.5, 1.0 / 64, kg_random_in(&r, 0, 1)};
        for (size_t i = 0; i < 5; i++)
            assert_near(kg_patch_length(&p, places[i]), kg_curve_length(&p.geodesic, 0, places[i]),
                        1e-13 * whole);
    }
}

/* Bends to both sides of its middle. */
static void a_planar_inflection_keeps_the_sign_of_its_start(void **state) {
    (void)state;
    const kg_vec3 left_first[4] = {{0, 0, 0}, {10, 10, 0}, {20, -10, 0}, {30, 0, 0}};
    for (int mirror = 0; mirror < 2; mirror++) {
        kg_patch_input in = {.point_count = 4, .extent = {-5, 5}};
        for (int i = 0; i < 4; i++)
            in.points[i] = kg_v3(left_first[i].x, left_first[i].y * (mirror ? -1 : 1), 0);
        kg_patch p;
        assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
        assert_int_equal(p.shape, KG_CURVE_PLANAR);
        assert_int_equal(p.ruling_degree, 0);
        for (int i = 0; i <= 10; i++)
            assert_near3(kg_patch_ruling(&p, i / 10.0).d, kg_v3(0, 0, mirror ? 1 : -1), 1e-15);
        assert_true(isinf(p.regression[0]) && isinf(p.regression[1]) && !p.clamped);
        assert_true(isnan(p.regression_v[0]) && isnan(p.regression_v[1]));
    }
}

/* ---- twisted inflections ----------------------------------------------------------------- */

/* A quintic through an inflection with twist at v0: p = sum of a[k] (v-v0)^k with a2 ∥ a1 (p'×p''
 * = 0) and a4 in the plane of a1, a3 (det(p',p''',p'''') = 0), a5 free. */
static kg_patch_input twisted_inflection(double v0, double fourth) {
    const kg_vec3 a[6] = {{0, 0, 0}, {60, 0, 0}, {6, 0, 0}, {2, 30, 0}, {1, 2, fourth}, {4, 8, 9}};
    kg_patch_input in = {.point_count = 6, .extent = {-3, 4}};
    /* blossom of each power (v - v0)^k at (0,…,0,1,…,1) with j ones */
    for (int j = 0; j <= 5; j++)
        for (int k = 0; k <= 5; k++) {
            /* elementary symmetric polynomial of degree k of j values 1-v0 and 5-j values -v0 */
            double e = 0;
            for (int i = 0; i <= k; i++)
                if (i <= j && k - i <= 5 - j)
                    e += kg_binomial(j, i) * kg_binomial(5 - j, k - i) * pow(1 - v0, i) *
                         pow(-v0, k - i);
            in.points[j] = kg_madd(in.points[j], e / kg_binomial(5, k), a[k]);
        }
    return in;
}

static void a_quintic_goes_through_a_twisted_inflection(void **state) {
    (void)state;
    const double places[] = {0, 0.3, 0.5, 0.71, 1};
    for (size_t k = 0; k < 5; k++) {
        double v0 = places[k];
        kg_patch_input in = twisted_inflection(v0, 0);
        kg_patch p;
        kg_error error;
        assert_int_equal(kg_patch_init(&in, &p, &error), KG_OK);
        assert_int_equal(p.shape, KG_CURVE_SPATIAL);
        assert_int_equal(p.ruling_degree, 15);
        assert_false(p.clamped);
        double space, paper;
        path_lengths(&p, (path){p.extent[0], 0, p.extent[1], 1}, 12, &space, &paper);
        assert_near(paper / space, 1, 1e-9);
        kg_vec3 before = kg_patch_ruling(&p, 0).d;
        for (int i = 1; i <= 200; i++) {
            double v = i / 200.0;
            kg_ruling g = kg_patch_ruling(&p, v);
            assert_true(kg_dist(g.d, before) < 0.1);
            before = g.d;
            /* d is D's direction before the inflection, the opposite behind it */
            kg_vec3 d[4];
            kg_curve_derivatives(&p.geodesic, v, 2, d);
            double side = kg_dot(g.d, kg_cross(d[1], d[2]));
            if (fabs(v - v0) > 0.01)
                assert_true(v0 > 0 && v > v0 ? side < 0 : side > 0);
        }
    }
}

/* Files round decimals: the inflection is then only nearly one. */
static void a_twisted_inflection_survives_rounded_decimals(void **state) {
    (void)state;
    kg_patch_input in = twisted_inflection(0.4, 0);
    for (int i = 0; i < 6; i++)
        in.points[i] = kg_v3(round(in.points[i].x * 1e8) * 1e-8, round(in.points[i].y * 1e8) * 1e-8,
                             round(in.points[i].z * 1e8) * 1e-8);
    kg_patch p;
    assert_int_equal(kg_patch_init(&in, &p, NULL), KG_OK);
    assert_int_equal(p.ruling_degree, 15);
    double space, paper;
    path_lengths(&p, (path){p.extent[0], 0, p.extent[1], 1}, 12, &space, &paper);
    assert_near(paper / space, 1, 1e-8);
}

static void another_twisted_inflection_is_an_error_that_says_where(void **state) {
    (void)state;
    kg_patch_input in = twisted_inflection(0.3, 5);
    kg_patch p;
    kg_error error;
    assert_int_equal(kg_patch_init(&in, &p, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "v = 0.3"));
    assert_non_null(strstr(error.message, "bend it one way only"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_boundary_is_as_long_on_paper_as_in_space),
        cmocka_unit_test(areas_agree_too),
        cmocka_unit_test(the_parameter_derivative_ruling_fails_by_percents),
        cmocka_unit_test(the_geodesic_unrolls_to_a_vertical_line_of_its_length),
        cmocka_unit_test(derivatives_agree_with_differences),
        cmocka_unit_test(normals_are_unit_square_to_the_surface_and_turned_by_flip),
        cmocka_unit_test(the_paper_frame_is_not_mirrored_on_the_front),
        cmocka_unit_test(rulings_start_along_d_and_never_jump),
        cmocka_unit_test(the_stored_polynomial_points_along_d),
        cmocka_unit_test(lengths_come_from_cells_as_exactly_as_from_the_start),
        cmocka_unit_test(a_planar_inflection_keeps_the_sign_of_its_start),
        cmocka_unit_test(a_quintic_goes_through_a_twisted_inflection),
        cmocka_unit_test(a_twisted_inflection_survives_rounded_decimals),
        cmocka_unit_test(another_twisted_inflection_is_an_error_that_says_where),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
