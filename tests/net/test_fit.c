#include "tests/check.h"

#include "net/fit.h"

#include <stdlib.h>

typedef struct polyline {
    kg_vec2 *p;
    size_t count;
} polyline;

/* Distance from q to the nearest of the polyline's segments, by trying all. */
static double distance_to(polyline line, kg_vec2 q) {
    double best = INFINITY;
    for (size_t i = 0; i + 1 < line.count; i++) {
        kg_vec2 a = line.p[i], ab = kg_sub2(line.p[i + 1], a), aq = kg_sub2(q, a);
        double l2 = kg_dot2(ab, ab), t = l2 > 0 ? kg_dot2(ab, aq) / l2 : 0;
        best = fmin(best, kg_dist2(q, kg_add2(a, kg_scale2(ab, fmin(fmax(t, 0), 1)))));
    }
    return best;
}

static double one_sided(polyline from, polyline to) {
    double worst = 0;
    for (size_t i = 0; i < from.count; i++)
        worst = fmax(worst, distance_to(to, from.p[i]));
    return worst;
}

/* A path flattened so finely that its own chords do not matter. */
static polyline flattened(const kg_path *path, int steps) {
    polyline out = {calloc(path->count * (size_t)steps + 1, sizeof(kg_vec2)), 0};
    for (size_t i = 0; i < path->count; i++) {
        const kg_path_step *s = &path->items[i];
        if (s->verb == KG_PATH_CLOSE) {
            out.p[out.count++] = path->items[0].p[0];
        } else if (s->verb != KG_PATH_CURVE) {
            out.p[out.count++] = s->p[0];
        } else {
            kg_vec2 b[4] = {kg_path_end(s - 1), s->p[0], s->p[1], s->p[2]};
            for (int k = 1; k <= steps; k++)
                out.p[out.count++] = kg_bezier2(b, (double)k / steps);
        }
    }
    return out;
}

static int count_verb(const kg_path *path, kg_path_verb verb) {
    int n = 0;
    for (size_t i = 0; i < path->count; i++)
        n += path->items[i].verb == verb;
    return n;
}

/* Both one-sided distances between a fitted path and the true curve sampled densely. */
static double hausdorff(const kg_path *path, polyline truth) {
    polyline flat = flattened(path, 200);
    double d = fmax(one_sided(flat, truth), one_sided(truth, flat));
    free(flat.p);
    return d;
}

typedef kg_vec2 (*curve_fn)(void *user, double t);

/* Points on a curve whose chords stray less than `sag` from it, starting coarse. */
static polyline sampled(curve_fn curve, void *user, double sag) {
    for (size_t n = 4;; n *= 2) {
        polyline line = {calloc(n + 1, sizeof(kg_vec2)), n + 1};
        double worst = 0;
        for (size_t i = 0; i <= n; i++)
            line.p[i] = curve(user, (double)i / (double)n);
        for (size_t i = 0; i < n; i++) {
            polyline one = {line.p + i, 2};
            for (int k = 1; k < 4; k++)
                worst =
                    fmax(worst, distance_to(one, curve(user, ((double)i + k / 4.0) / (double)n)));
        }
        if (worst <= sag || n > 100000)
            return line;
        free(line.p);
    }
}

static kg_vec2 wave(void *user, double t) {
    const double *c = user;
    return kg_v2(200 * t + c[0] * sin(c[1] * t), c[2] * sin(c[3] * t) + c[4] * t * t);
}

static kg_vec2 blob(void *user, double t) {
    const double *c = user;
    double a = 2 * KG_PI * t;
    double r = 40 * (1 + c[0] * sin(2 * a + c[1]) + c[2] * sin(3 * a + c[3]) + c[4] * cos(5 * a));
    return kg_v2(r * cos(a), r * sin(a));
}

static unsigned char *flags(size_t count) {
    return calloc(count, 1);
}

static void random_open_curves_stay_within_the_tolerance(void **state) {
    (void)state;
    kg_random random = {1};
    int segments = 0;
    for (int n = 0; n < 30; n++) {
        double c[5] = {kg_random_in(&random, 0, 20), kg_random_in(&random, 0, 12),
                       kg_random_in(&random, 0, 30), kg_random_in(&random, 0, 12),
                       kg_random_in(&random, -50, 50)};
        double tolerance = n % 3 == 0 ? 0.1 : 0.01;
        polyline line = sampled(wave, c, tolerance / 10), truth = sampled(wave, c, 3e-4);
        unsigned char *corners = flags(line.count);
        kg_path path = {0};
        assert_int_equal(kg_fit(line.p, corners, line.count, false, tolerance, &path, NULL), KG_OK);
        double d = hausdorff(&path, truth);
        if (!(d <= tolerance))
            print_error("curve %d is off by %.4f\n", n, d);
        assert_true(d <= tolerance);
        kg_vec2 last = kg_path_end(&path.items[path.count - 1]);
        assert_true(kg_dist2(last, line.p[line.count - 1]) == 0);
        segments += (int)path.count - 1;
        kg_path_clear(&path);
        free(corners);
        free(line.p);
        free(truth.p);
    }
    print_message("%.1f segments a curve\n", segments / 30.0);
    assert_true(segments / 30 <= 14);
}

static void closed_smooth_loops_have_no_kink_at_the_seam(void **state) {
    (void)state;
    kg_random random = {2};
    int segments = 0;
    for (int n = 0; n < 15; n++) {
        double c[5] = {kg_random_in(&random, 0, 0.3), kg_random_in(&random, 0, 6),
                       kg_random_in(&random, 0, 0.2), kg_random_in(&random, 0, 6),
                       kg_random_in(&random, 0, 0.05)};
        polyline line = sampled(blob, c, 1e-3), truth = sampled(blob, c, 3e-4);
        unsigned char *corners = flags(line.count);
        kg_path path = {0};
        assert_int_equal(kg_fit(line.p, corners, line.count - 1, true, 0.01, &path, NULL), KG_OK);
        assert_int_equal(path.items[path.count - 1].verb, KG_PATH_CLOSE);
        double d = hausdorff(&path, truth);
        assert_true(d <= 0.01);
        /* Tangents agree across every joint, the closing one too. */
        size_t curves = path.count - 2;
        for (size_t i = 1; i <= curves; i++) {
            const kg_path_step *in = &path.items[i], *out = &path.items[i < curves ? i + 1 : 1];
            assert_int_equal(in->verb, KG_PATH_CURVE);
            kg_vec2 a = kg_sub2(in->p[2], in->p[1]), b = kg_sub2(out->p[0], in->p[2]);
            assert_near(atan2(kg_cross2(a, b), kg_dot2(a, b)), 0, 1e-6);
        }
        segments += (int)curves;
        kg_path_clear(&path);
        free(corners);
        free(line.p);
        free(truth.p);
    }
    print_message("%.1f segments a loop\n", segments / 15.0);
    assert_true(segments / 15 <= 22);
}

static kg_vec2 circle(void *user, double t) {
    double a = 2 * KG_PI * t, r = *(double *)user;
    return kg_v2(r * cos(a), r * sin(a));
}

static void circle_takes_few_curves(void **state) {
    (void)state;
    double r = 20;
    polyline line = sampled(circle, &r, 1e-3), truth = sampled(circle, &r, 1e-5);
    unsigned char *corners = flags(line.count);
    kg_path path = {0};
    assert_int_equal(kg_fit(line.p, corners, line.count - 1, true, 0.01, &path, NULL), KG_OK);
    assert_true(path.count <= 2 + 4);
    assert_true(hausdorff(&path, truth) <= 0.01);
    kg_path_clear(&path);
    free(corners);
    free(line.p);
    free(truth.p);
}

/* A rectangle of 60 x 30 with rounded corners of radius 5, smooth throughout. */
static void rounded_rectangle_keeps_its_straight_sides_and_round_corners(void **state) {
    (void)state;
    kg_vec2 p[64];
    const kg_vec2 center[4] = {{55, 25}, {5, 25}, {5, 5}, {55, 5}};
    for (int i = 0; i < 64; i++) {
        double a = KG_PI / 2 * (i / 16 + i % 16 / 15.0);
        p[i] = kg_add2(center[i / 16], kg_v2(5 * cos(a), 5 * sin(a)));
    }
    unsigned char *corners = flags(64);
    kg_path path = {0};
    assert_int_equal(kg_fit(p, corners, 64, true, 0.02, &path, NULL), KG_OK);
    /* The close is the fourth side. */
    assert_int_equal(count_verb(&path, KG_PATH_LINE), 3);
    assert_int_equal(count_verb(&path, KG_PATH_CURVE), 4);
    kg_path_clear(&path);
    free(corners);
}

static void corners_stay_and_straight_edges_are_lines(void **state) {
    (void)state;
    kg_vec2 p[40];
    for (int i = 0; i < 40; i++) {
        double t = i % 10 / 10.0;
        const kg_vec2 q[5] = {{0, 0}, {30, 0}, {30, 20}, {0, 20}, {0, 0}};
        p[i] = kg_lerp2(q[i / 10], q[i / 10 + 1], t);
    }
    unsigned char *corners = flags(40);
    for (int i = 0; i < 40; i += 10)
        corners[i] = 1;
    kg_path path = {0};
    assert_int_equal(kg_fit(p, corners, 40, true, 0.01, &path, NULL), KG_OK);
    assert_int_equal(count_verb(&path, KG_PATH_CURVE), 0);
    assert_int_equal(count_verb(&path, KG_PATH_LINE), 3);
    for (size_t i = 0; i < 4; i++)
        assert_true(kg_dist2(kg_path_end(&path.items[i]), p[10 * i]) == 0);
    kg_path_clear(&path);
    free(corners);
}

/* Whatever the input, the result must follow the polyline: cusps without flags, doubled points,
 * steps back on itself, clusters of tiny segments, huge and tiny sizes. */
static void hard_polylines_are_followed(void **state) {
    (void)state;
    kg_random random = {3};
    for (int n = 0; n < 400; n++) {
        kg_vec2 p[60];
        size_t count = 2 + (size_t)kg_random_in(&random, 0, 58);
        double size = pow(10, kg_random_in(&random, -3, 4));
        kg_vec2 at = {0, 0};
        double heading = 0;
        for (size_t i = 0; i < count; i++) {
            double kind = kg_random_in(&random, 0, 1);
            if (kind < 0.1)
                heading += KG_PI;
            else if (kind < 0.3)
                heading += kg_random_in(&random, -2, 2);
            else
                heading += kg_random_in(&random, -0.1, 0.1);
            double step = kind > 0.9 ? 0 : kind > 0.8 ? 1e-9 : kg_random_in(&random, 0, size);
            at = kg_add2(at, kg_scale2(kg_v2(cos(heading), sin(heading)), step));
            p[i] = at;
        }
        bool closed = n % 2 == 1;
        unsigned char *corners = flags(count);
        kg_path path = {0};
        assert_int_equal(kg_fit(p, corners, count, closed, 0.01, &path, NULL), KG_OK);
        if (path.count > 0) {
            kg_vec2 q[61];
            memcpy(q, p, count * sizeof *p);
            q[count] = p[0];
            polyline truth = {q, count + closed};
            double d = hausdorff(&path, truth);
            if (!(d <= 0.0101))
                print_error("polyline %d is off by %.4g\n", n, d);
            assert_true(d <= 0.0101);
        }
        kg_path_clear(&path);
        free(corners);
    }
}

/* A smooth curve as trimming leaves it: now and then two points that are hardly apart, all of them
 * off by rounding. */
static void noise_in_close_points_does_not_break_curves_up(void **state) {
    (void)state;
    kg_random random = {4};
    double r = 60;
    polyline line = sampled(circle, &r, 1e-3);
    kg_vec2 *p = calloc(2 * line.count, sizeof *p);
    size_t count = 0;
    for (size_t i = 0; i + 1 < line.count; i++) {
        for (int copy = 0; copy < (i % 5 == 0 ? 2 : 1); copy++) {
            double noise = 1e-7, near = copy * 2e-5;
            p[count++] = kg_v2(line.p[i].x + near + kg_random_in(&random, -noise, noise),
                               line.p[i].y - near + kg_random_in(&random, -noise, noise));
        }
    }
    unsigned char *corners = flags(count);
    kg_path path = {0};
    assert_int_equal(kg_fit(p, corners, count, true, 0.01, &path, NULL), KG_OK);
    assert_true(path.count <= 2 + 6);
    kg_path_clear(&path);
    free(corners);
    free(p);
    free(line.p);
}

static void points_without_length_become_nothing(void **state) {
    (void)state;
    kg_vec2 p[5] = {{1, 2}, {1, 2}, {1, 2}, {1, 2}, {1, 2}};
    kg_path path = {0};
    assert_int_equal(kg_fit(p, NULL, 5, true, 0.01, &path, NULL), KG_OK);
    assert_int_equal(kg_fit(p, NULL, 1, false, 0.01, &path, NULL), KG_OK);
    assert_int_equal(kg_fit(p, NULL, 0, false, 0.01, &path, NULL), KG_OK);
    assert_int_equal(path.count, 0);
    kg_path_clear(&path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_open_curves_stay_within_the_tolerance),
        cmocka_unit_test(closed_smooth_loops_have_no_kink_at_the_seam),
        cmocka_unit_test(circle_takes_few_curves),
        cmocka_unit_test(rounded_rectangle_keeps_its_straight_sides_and_round_corners),
        cmocka_unit_test(corners_stay_and_straight_edges_are_lines),
        cmocka_unit_test(hard_polylines_are_followed),
        cmocka_unit_test(noise_in_close_points_does_not_break_curves_up),
        cmocka_unit_test(points_without_length_become_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
