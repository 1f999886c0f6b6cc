/* Triangles of regions: they cover them, follow the surface, and lie edge to edge. */
#include "tests/trim/regions.h"

#include <stdlib.h>

typedef struct quality {
    double area, plane_area, worst_gap, worst_facing;
} quality;

static double distance_along_ruling(const kg_patch *p, kg_vec2 uv, kg_vec3 x) {
    double u, v, d = kg_patch_closest(p, x, &u, &v);
    return fmin(d, kg_dist(kg_patch_point(p, uv.x, uv.y), x));
}

static quality measure(const kg_patch *p, const kg_region *region, bool gaps) {
    kg_tessellation t;
    quality q = {.worst_facing = 1};
    kg_error error;
    if (kg_region_tessellate(p, region, &t, &error))
        fail_msg("%s", error.message);
    for (size_t i = 0; i < t.triangle_count; i++) {
        const kg_vertex *v[3];
        for (int k = 0; k < 3; k++) {
            assert_true(t.triangles[3 * i + (size_t)k] < t.vertex_count);
            v[k] = &t.vertices[t.triangles[3 * i + (size_t)k]];
        }
        kg_vec3 n = kg_cross(kg_sub(v[1]->position, v[0]->position),
                             kg_sub(v[2]->position, v[0]->position));
        kg_vec2 e = kg_v2(v[1]->u - v[0]->u, v[1]->v - v[0]->v),
                f = kg_v2(v[2]->u - v[0]->u, v[2]->v - v[0]->v);
        double area = 0.5 * kg_len(n);
        q.area += area;
        q.plane_area += (p->flip ? 0.5 : -0.5) * kg_cross2(e, f);
        if (area > 1e-3)
            q.worst_facing = fmin(q.worst_facing, kg_dot(n, v[0]->normal) / kg_len(n));
        for (int k = 0; k < 3 && gaps; k++) {
            const kg_vertex *a = v[k], *b = v[(k + 1) % 3];
            q.worst_gap =
                fmax(q.worst_gap,
                     distance_along_ruling(p, kg_v2(0.5 * (a->u + b->u), 0.5 * (a->v + b->v)),
                                           kg_lerp(a->position, b->position, 0.5)));
        }
    }
    kg_tessellation_clear(&t);
    return q;
}

static kg_regions rectangle(const kg_patch *p, double tolerance) {
    kg_regions r;
    assert_int_equal(kg_regions_rectangle(p, tolerance, &r, NULL), KG_OK);
    return r;
}

static void triangles_cover_trimmed_regions_and_follow_the_surface(void **state) {
    (void)state;
    kg_random r = {121};
    size_t done = 0, holes = 0;
    double worst = 0;
    for (int round = 0; round < 250; round++) {
        scene s = random_scene(&r, 2, kg_v3(0, 0, 0));
        kg_regions now = whole(&s, 0), next;
        kg_trim trim = scene_trim(&s, 0, NULL);
        kg_cut cut;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count) {
            assert_int_equal(kg_trim_by(&trim, &now, &cut, NULL, 0, &next, NULL), KG_OK);
            kg_regions_clear(&now);
            now = next;
        }
        const double *e = s.patches[0].extent;
        double mid = 0.5 * (e[0] + e[1]), w = 0.2 * (e[1] - e[0]);
        const kg_vec2 hole[5] = {
            {mid - w, 0.4}, {mid, 0.3}, {mid + w, 0.45}, {mid + 0.5 * w, 0.7}, {mid - w, 0.6}};
        if (kg_trim_contour(&trim, &now, hole, 5, false, 1, &next, NULL) == KG_OK) {
            kg_regions_clear(&now);
            now = next;
        }
        double sum = 0, exact = total(&s, 0, &now).space_moment;
        for (size_t i = 0; i < now.count; i++) {
            quality q = measure(&s.patches[0], &now.items[i], true);
            double plane =
                plane_area(&s.patches[0], &now.items[i]) / s.patches[0].length_at[KG_PATCH_CELLS];
            assert_near(q.plane_area, plane, 1e-9 * s.patches[0].size);
            holes += now.items[i].loop_count > 1;
            sum += q.area;
            worst = fmax(worst, q.worst_gap);
            if (!(q.worst_gap < 10 * TOLERANCE))
                fail_msg("round %d: a triangle is %g off the surface", round, q.worst_gap);
            if (!(q.worst_facing > 0.9))
                fail_msg("round %d: a triangle faces by %g", round, q.worst_facing);
        }
        assert_near(sum, exact, 1e-4 * exact);
        done++;
        kg_regions_clear(&now);
        scene_clear(&s);
    }
    print_message("worst gap %g for chords of %g\n", worst, TOLERANCE);
    assert_true(holes > 100);
}

static void the_error_falls_with_the_tolerance(void **state) {
    (void)state;
    kg_random r = {122};
    for (int round = 0; round < 40; round++) {
        kg_patch p = random_patch(&r, (pair_kind)(round % PAIR_KINDS), kg_v3(0, 0, 0));
        p.flip = round & 1;
        for (double tolerance = 0.1; tolerance > 1e-4; tolerance *= 0.1) {
            kg_regions one = rectangle(&p, tolerance);
            quality q = measure(&p, &one.items[0], true);
            if (!(q.worst_gap <= 6 * tolerance))
                fail_msg("round %d: %g off at %g", round, q.worst_gap, tolerance);
            assert_true(q.worst_facing > 0.5);
            kg_regions_clear(&one);
        }
    }
}

/* Cones whose one side is a hundred times as long as the other. */
static void wide_patches_with_sparse_outlines_keep_to_the_surface(void **state) {
    (void)state;
    const kg_vec3 p[4] = {{0, 0, 0}, {40, 0, 25}, {60, 30, 35}, {50, 70, 30}};
    for (int side = 0; side < 2; side++) {
        kg_patch whole_patch = make_patch(p, 4, -1e5, 1e5, NULL);
        kg_patch q = make_patch(p, 4, side ? -10 : 0.9 * whole_patch.regression[0],
                                side ? 0.9 * whole_patch.regression[1] : 10, NULL);
        kg_regions one = rectangle(&q, 0.01);
        quality x = measure(&q, &one.items[0], true);
        assert_true(x.worst_gap < 0.05);
        kg_regions_clear(&one);
    }
}

static int compare_positions(const void *x, const void *y) {
    return memcmp(x, y, 3 * sizeof(double));
}

/* Seam points of both sides, bit for bit. */
static void both_sides_of_a_seam_share_their_vertices(void **state) {
    (void)state;
    kg_random r = {123};
    for (int done = 0; done < 50;) {
        scene s = {.count = 2};
        for (size_t i = 0; i < 2; i++)
            s.patches[i] = random_patch(&r, (pair_kind)(i % 2), kg_v3(0, 0, 0));
        kg_cut cut, back;
        if (scene_cut(&s, 0, 1, &cut) && cut.crossings->count == 1 &&
            cut.crossings->branches[0].ends[0] && cut.crossings->branches[0].ends[1]) {
            assert_true(scene_cut(&s, 1, 0, &back));
            kg_vec3 *vertices[2];
            size_t count[2];
            for (size_t k = 0; k < 2; k++) {
                kg_regions all = whole(&s, k), out;
                kg_trim trim = scene_trim(&s, k, NULL);
                assert_int_equal(kg_trim_by(&trim, &all, k ? &back : &cut, NULL, 0, &out, NULL),
                                 KG_OK);
                kg_tessellation t;
                assert_int_equal(kg_region_tessellate(&s.patches[k], &out.items[0], &t, NULL),
                                 KG_OK);
                count[k] = t.vertex_count;
                vertices[k] = calloc(t.vertex_count, sizeof *vertices[k]);
                for (size_t i = 0; i < t.vertex_count; i++)
                    vertices[k][i] = t.vertices[i].position;
                qsort(vertices[k], count[k], sizeof *vertices[k], compare_positions);
                kg_tessellation_clear(&t);
                kg_regions_clear(&all);
                kg_regions_clear(&out);
            }
            size_t shared = 0;
            for (size_t i = 0; i < count[0]; i++)
                shared += bsearch(&vertices[0][i], vertices[1], count[1], sizeof *vertices[1],
                                  compare_positions) != NULL;
            assert_true(shared + 2 >= cut.crossings->branches[0].count);
            free(vertices[0]);
            free(vertices[1]);
            done++;
        }
        scene_clear(&s);
    }
}

/* Plane polygons on a coarse grid: many equal heights, holes that touch. */
static void polygons_on_a_grid_are_covered_exactly(void **state) {
    (void)state;
    const kg_vec3 line[4] = {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {12, 0, 0}}, y = {0, 1, 0};
    scene s = {.count = 1};
    s.patches[0] = make_patch(line, 4, 0, 12, &y);
    kg_trim trim = scene_trim(&s, 0, NULL);
    kg_random r = {124};
    size_t done = 0;
    for (int round = 0; round < 600; round++) {
        kg_regions now = whole(&s, 0), next;
        double area = 144;
        for (int k = 0; k < 6; k++) {
            double u = (double)(kg_random_bits(&r) % 11), v = (double)(kg_random_bits(&r) % 11),
                   w = 1 + (double)(kg_random_bits(&r) % 4),
                   h = 1 + (double)(kg_random_bits(&r) % 4);
            const kg_vec2 box[4] = {
                {u, v / 12}, {u + w, v / 12}, {u + w, (v + h) / 12}, {u, (v + h) / 12}};
            const kg_vec2 diamond[4] = {{u, v / 12 + h / 24},
                                        {u + w / 2, v / 12},
                                        {u + w, v / 12 + h / 24},
                                        {u + w / 2, (v + h) / 12}};
            if (kg_trim_contour(&trim, &now, k & 1 ? box : diamond, 4, false, k, &next, NULL))
                continue;
            check_regions(&s, 0, &next, "grid");
            kg_regions_clear(&now);
            now = next;
        }
        area = 0;
        double covered = 0;
        for (size_t i = 0; i < now.count; i++) {
            area += plane_area(&s.patches[0], &now.items[i]);
            covered += measure(&s.patches[0], &now.items[i], false).area;
        }
        assert_near(covered, area, 1e-6);
        done++;
        kg_regions_clear(&now);
    }
    assert_int_equal(done, 600);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_cover_trimmed_regions_and_follow_the_surface),
        cmocka_unit_test(the_error_falls_with_the_tolerance),
        cmocka_unit_test(wide_patches_with_sparse_outlines_keep_to_the_surface),
        cmocka_unit_test(both_sides_of_a_seam_share_their_vertices),
        cmocka_unit_test(polygons_on_a_grid_are_covered_exactly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
