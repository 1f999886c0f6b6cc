#include "katagami/mesh.h"
#include "katagami/unroll.h"
#include "tests/check.h"

#include <stdlib.h>

/* The strips of the body come first in the model. */
enum { BODY_STRIPS = 8 };

typedef struct dolphin {
    kg_model *model;
    kg_solution *solution;
    kg_mesh *reference;
} dolphin;

static int load(void **state) {
    static dolphin d;
    kg_error error;
    if (kg_model_read(KG_SAMPLES "/dolphin.katagami", &d.model, &error) != KG_OK ||
        kg_solution_create(d.model, 0.002, NULL, &d.solution, &error) != KG_OK ||
        kg_mesh_read(KG_SAMPLES "/dolphin.obj", &d.reference, &error) != KG_OK) {
        print_error("%s\n", error.message);
        return -1;
    }
    *state = &d;
    return 0;
}

static int unload(void **state) {
    dolphin *d = *state;
    kg_solution_destroy(d->solution);
    kg_model_destroy(d->model);
    kg_mesh_destroy(d->reference);
    return 0;
}

/* ---- silhouettes ----------------------------------------------------------------------- */

/* Covered cells of a square grid around the origin. */
enum { GRID = 560 };
static const double CELL = 0.5; /* mm */

typedef unsigned char shadow[GRID][GRID];

static int cell_of(double x) {
    double i = floor(x / CELL) + GRID / 2;
    return (int)fmin(fmax(i, 0), GRID - 1);
}

static void cover(shadow cells, const kg_vec2 t[3]) {
    kg_box2 box = kg_box2_empty();
    for (int i = 0; i < 3; i++)
        kg_box2_add(&box, t[i]);
    double area = kg_cross2(kg_sub2(t[1], t[0]), kg_sub2(t[2], t[0]));
    for (int y = cell_of(box.lo.y); y <= cell_of(box.hi.y); y++)
        for (int x = cell_of(box.lo.x); x <= cell_of(box.hi.x); x++) {
            kg_vec2 p = kg_v2((x - GRID / 2 + 0.5) * CELL, (y - GRID / 2 + 0.5) * CELL);
            bool inside = area != 0;
            for (int i = 0; i < 3; i++) {
                kg_vec2 along = kg_sub2(t[(i + 1) % 3], t[i]);
                inside = inside && kg_cross2(along, kg_sub2(p, t[i])) * area >= 0;
            }
            if (inside)
                cells[y][x] = 1;
        }
}

/* As seen along the axis: 0 from the front, 1 from the side, 2 from above. */
static kg_vec2 seen_along(int axis, kg_vec3 p) {
    return axis == 0 ? kg_v2(p.y, p.z) : axis == 1 ? kg_v2(p.x, p.z) : kg_v2(p.x, p.y);
}

static void cast_mesh(const kg_mesh *mesh, int axis, shadow cells) {
    size_t count = kg_mesh_triangle_count(mesh);
    uint32_t *corners = malloc(3 * count * sizeof *corners);
    assert_non_null(corners);
    assert_int_equal(kg_mesh_triangulate(mesh, corners, NULL, NULL), KG_OK);
    for (size_t i = 0; i < count; i++) {
        kg_vec2 t[3];
        for (int k = 0; k < 3; k++)
            t[k] = seen_along(axis, mesh->positions[corners[3 * i + (size_t)k]]);
        cover(cells, t);
    }
    free(corners);
}

static void cast_patch(const kg_solved_patch *p, int axis, shadow cells) {
    for (size_t r = 0; r < p->regions.count; r++) {
        kg_tessellation t;
        assert_int_equal(kg_region_tessellate(&p->patch, &p->regions.items[r], &t, NULL), KG_OK);
        for (size_t i = 0; i < t.triangle_count; i++) {
            kg_vec2 c[3];
            for (int k = 0; k < 3; k++)
                c[k] = seen_along(axis, t.vertices[t.triangles[3 * i + (size_t)k]].position);
            cover(cells, c);
        }
        kg_tessellation_clear(&t);
    }
}

/* Intersection over union of the two silhouettes. */
static double overlap(const dolphin *d, int axis) {
    static shadow paper, shape;
    memset(paper, 0, sizeof paper);
    memset(shape, 0, sizeof shape);
    cast_mesh(d->reference, axis, shape);
    for (size_t i = 0; i < kg_solution_count(d->solution); i++)
        cast_patch(kg_solution_patch(d->solution, i), axis, paper);
    int both = 0, either = 0;
    for (int y = 0; y < GRID; y++)
        for (int x = 0; x < GRID; x++) {
            both += paper[y][x] && shape[y][x];
            either += paper[y][x] || shape[y][x];
        }
    print_message("axis %d: %.3f\n", axis, (double)both / either);
    return (double)both / either;
}

static void silhouettes_are_those_of_the_reference(void **state) {
    assert_true(overlap(*state, 0) > 0.85);
    assert_true(overlap(*state, 1) > 0.92);
    assert_true(overlap(*state, 2) > 0.92);
}

/* ---- patches --------------------------------------------------------------------------- */

static void nothing_to_complain_of(void **state) {
    const dolphin *d = *state;
    for (size_t i = 0; i < kg_solution_issue_count(d->solution); i++)
        print_error("%s\n", kg_solution_issue(d->solution, i)->message);
    assert_int_equal(kg_solution_issue_count(d->solution), 0);
}

static void every_patch_is_one_trimmed_piece(void **state) {
    const dolphin *d = *state;
    assert_true(kg_solution_count(d->solution) >= 10);
    for (size_t i = 0; i < kg_solution_count(d->solution); i++) {
        assert_true(d->model->patches[i].trim_count > 0);
        assert_int_equal(kg_solution_patch(d->solution, i)->regions.count, 1);
    }
}

static double area(const dolphin *d, size_t i) {
    const kg_solved_patch *p = kg_solution_patch(d->solution, i);
    return kg_region_measure(&p->patch, &p->regions.items[0], kg_solution_finder(d->solution))
        .paper_moment;
}

static void left_and_right_are_alike(void **state) {
    const dolphin *d = *state;
    int pairs = 0;
    for (size_t i = 0; i + 1 < d->model->patch_count; i++)
        if (strstr(d->model->patches[i].name, "left")) {
            assert_non_null(strstr(d->model->patches[i + 1].name, "right"));
            assert_near(area(d, i), area(d, i + 1), 1e-3 * area(d, i));
            pairs++;
        }
    assert_int_equal(pairs, 5);
}

/* Least distance from a point to the trimmed surfaces first … last, all but `self`. */
static double distance_to(const dolphin *d, size_t first, size_t last, size_t self, kg_vec3 x) {
    double least = INFINITY;
    for (size_t i = first; i <= last; i++) {
        const kg_solved_patch *p = kg_solution_patch(d->solution, i);
        if (i != self)
            least = fmin(least, kg_region_distance(&p->patch, &p->regions.items[0], x));
    }
    return least;
}

/* Edges in the order of the loops; only a hole may be open. */
static void body_strips_meet_edge_to_edge(void **state) {
    const dolphin *d = *state;
    for (size_t i = 0; i < BODY_STRIPS; i++) {
        const kg_solved_patch *p = kg_solution_patch(d->solution, i);
        const kg_region_loop *loop = &p->regions.items[0].loops[0];
        for (size_t e = 0; e < loop->edge_count; e++)
            assert_int_equal(loop->edges[e].kind, KG_EDGE_CUT);
        for (size_t k = 0; k < loop->point_count; k += 7)
            assert_near(distance_to(d, 0, BODY_STRIPS - 1, i, loop->points[k].x), 0, 0.05);
    }
}

static void fins_and_beak_stand_on_the_body(void **state) {
    const dolphin *d = *state;
    for (size_t i = BODY_STRIPS; i < kg_solution_count(d->solution); i++) {
        const kg_solved_patch *p = kg_solution_patch(d->solution, i);
        const kg_region_loop *loop = &p->regions.items[0].loops[0];
        size_t on_body = 0;
        for (size_t e = 0; e < loop->edge_count; e++) {
            const kg_region_edge *edge = &loop->edges[e];
            if (edge->kind != KG_EDGE_CUT || edge->source > BODY_STRIPS)
                continue;
            for (size_t k = 0; k <= edge->count; k++) {
                kg_vec3 x = kg_region_edge_point(loop, edge, k).x;
                on_body += distance_to(d, 0, BODY_STRIPS - 1, i, x) < 0.05;
            }
        }
        if (on_body < 2)
            print_error("patch %zu touches the body in %zu points\n", i + 1, on_body);
        assert_true(on_body >= 2);
    }
}

/* Strips touch the shape along a line and stand off at their edges, as flat paper must. */
static void body_strips_follow_the_shape(void **state) {
    const dolphin *d = *state;
    kg_mesh_query *query;
    assert_int_equal(kg_mesh_query_create(d->reference, NULL, &query, NULL), KG_OK);
    double sum = 0, most = 0;
    size_t count = 0;
    for (size_t i = 0; i < BODY_STRIPS; i++) {
        const kg_solved_patch *p = kg_solution_patch(d->solution, i);
        for (int a = 1; a < 60; a++)
            for (int b = 1; b < 60; b++) {
                const double *extent = p->patch.extent;
                double u = extent[0] + (extent[1] - extent[0]) * b / 60, v = a / 60.0;
                if (!kg_region_contains(&p->regions.items[0], u, v))
                    continue;
                kg_mesh_hit hit;
                assert_true(kg_mesh_query_closest(query, kg_patch_point(&p->patch, u, v), &hit));
                sum += hit.distance;
                most = fmax(most, hit.distance);
                count++;
            }
    }
    kg_mesh_query_destroy(query);
    print_message("%zu points, mean %.3f mm, most %.3f mm\n", count, sum / (double)count, most);
    assert_true(count > 1000);
    assert_true(sum / (double)count < 1);
    assert_true(most < 6);
}

/* ---- net ------------------------------------------------------------------------------- */

static void parts_fit_two_pages_and_join_as_meant(void **state) {
    const dolphin *d = *state;
    kg_unrolled *unrolled;
    assert_int_equal(kg_unroll(d->model, d->solution, &unrolled, NULL), KG_OK);
    const kg_net *net = unrolled->net;
    assert_int_equal(net->part_count, d->model->patch_count);
    double seams = 0;
    int contacts = 0;
    for (size_t i = 0; i < net->join_count; i++) {
        const kg_net_join *join = &net->joins[i];
        bool body = join->sources[0] <= BODY_STRIPS && join->sources[1] <= BODY_STRIPS;
        assert_true(!body || join->kind == KG_JOIN_SEAM);
        if (join->kind == KG_JOIN_SEAM) {
            assert_near(join->sides[0].length, join->sides[1].length, 1e-6 * join->sides[0].length);
            assert_true(join->sides[0].length > 4); /* nothing too short to glue */
            seams += join->sides[0].length;
        } else {
            contacts++;
        }
    }
    assert_true(seams > 1800);     /* eight edges of the long strips, 225 to 235 mm each */
    assert_int_equal(contacts, 7); /* five fins, beak and jaw */
    kg_net_options options = kg_net_options_default();
    kg_net_layout *layout;
    assert_int_equal(kg_net_layout_create(net, &options, NULL, &layout, NULL), KG_OK);
    assert_in_range(layout->page_count, 1, 2);
    kg_net_layout_destroy(layout);
    kg_unrolled_destroy(unrolled);
}

/* ---- reference ------------------------------------------------------------------------- */

typedef struct half_edge {
    uint32_t from, to;
} half_edge;

static int by_ends(const void *a, const void *b) {
    const half_edge *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

static void reference_is_closed_outward_and_250_mm_long(void **state) {
    const kg_mesh *m = ((const dolphin *)*state)->reference;
    assert_in_range(m->face_count, 3000, 6000);
    kg_box3 box = kg_mesh_bounds(m);
    assert_near(box.hi.x - box.lo.x, 250, 0.5);
    assert_near(box.hi.y + box.lo.y, 0, 1e-9);
    size_t count = m->face_starts[m->face_count];
    half_edge *edges = malloc(count * sizeof *edges);
    assert_non_null(edges);
    double volume = 0;
    for (size_t f = 0; f < m->face_count; f++) {
        uint32_t first = m->face_starts[f], last = m->face_starts[f + 1] - 1;
        for (uint32_t k = first; k <= last; k++) {
            uint32_t next = m->face_corners[k < last ? k + 1 : first];
            edges[k] = (half_edge){m->face_corners[k], next};
            volume += kg_det(m->positions[m->face_corners[first]], m->positions[m->face_corners[k]],
                             m->positions[next]) /
                      6;
        }
    }
    assert_true(volume > 0);
    qsort(edges, count, sizeof *edges, by_ends);
    for (size_t i = 0; i < count; i++) {
        half_edge back = {edges[i].to, edges[i].from};
        assert_non_null(bsearch(&back, edges, count, sizeof *edges, by_ends));
        assert_true(i == 0 || by_ends(&edges[i - 1], &edges[i]) != 0);
    }
    free(edges);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silhouettes_are_those_of_the_reference),
        cmocka_unit_test(nothing_to_complain_of),
        cmocka_unit_test(every_patch_is_one_trimmed_piece),
        cmocka_unit_test(left_and_right_are_alike),
        cmocka_unit_test(body_strips_meet_edge_to_edge),
        cmocka_unit_test(fins_and_beak_stand_on_the_body),
        cmocka_unit_test(body_strips_follow_the_shape),
        cmocka_unit_test(parts_fit_two_pages_and_join_as_meant),
        cmocka_unit_test(reference_is_closed_outward_and_250_mm_long),
    };
    return cmocka_run_group_tests(tests, load, unload);
}
