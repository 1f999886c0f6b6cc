/* Picking, against every face of the posed card. */
#include "reference.h"

#include <stdlib.h>

/* The nearest of all faces, by triangles; INFINITY: none. */
static double nearest(const kg_mesh *mesh, kg_vec3 origin, kg_vec3 direction) {
    double best = INFINITY;
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->face_corners + mesh->face_starts[f];
        uint32_t count = mesh->face_starts[f + 1] - mesh->face_starts[f];
        for (uint32_t i = 2; i < count; i++) {
            kg_vec3 a = mesh->positions[corner[0]];
            kg_vec3 u = kg_sub(mesh->positions[corner[i - 1]], a);
            kg_vec3 v = kg_sub(mesh->positions[corner[i]], a), from = kg_sub(origin, a);
            double det = kg_det(u, v, kg_neg(direction));
            double s = kg_det(from, v, kg_neg(direction)) / det;
            double t = kg_det(u, from, kg_neg(direction)) / det;
            double distance = kg_det(u, v, from) / det;
            if (s >= 0 && t >= 0 && s + t <= 1 && distance >= 0 && distance < best)
                best = distance;
        }
    }
    return best;
}

static kg_vec3 random_point(kg_random *r, double reach) {
    double x = kg_random_in(r, -reach, reach);
    double y = kg_random_in(r, -reach, reach);
    double z = kg_random_in(r, -reach, reach);
    return kg_v3(x, y, z);
}

/* The point that the hit says, by the cell's own piece, must be on the ray. */
static void check_cell(const kg_oa *oa, const kg_oa_sheet *s, double open, kg_vec3 point,
                       const kg_oa_hit *hit) {
    kg_oa_piece piece = kg_oa_cell_piece(s, hit->x, hit->row, hit->side);
    kg_vec3 axes[5], at[3];
    kg_oa_axes(open, axes);
    assert_int_equal(piece.plane, hit->plane);
    for (int i = 0; i < 3; i++) {
        kg_oa_tuple t = kg_oa_piece_point(&piece, i == 1, -(i == 2));
        at[i] = kg_v3(-s->margin, 0, 0);
        for (int k = 0; k < 5; k++)
            at[i] = kg_madd(at[i], t.v[k], axes[k]);
        at[i] = kg_scale(kg_v3(at[i].x, -at[i].y, at[i].z), oa->cell_mm);
    }
    kg_vec3 u = kg_sub(at[1], at[0]), v = kg_sub(at[2], at[0]), from = kg_sub(point, at[0]);
    double dx = kg_dot(from, u) / kg_dot(u, u), dt = kg_dot(from, v) / kg_dot(v, v);
    assert_near(kg_len(kg_sub(from, kg_add(kg_scale(u, dx), kg_scale(v, dt)))), 0, 1e-6);
    assert_true(dx > -1e-6 && dx < 1 + 1e-6 && dt > -1e-6 && dt < 1 + 1e-6);
}

static void rays_meet_the_nearest_face(void **state) {
    (void)state;
    kg_random r = {31};
    int hits = 0, bent = 0;
    for (int n = 0; n < 200; n++) {
        kg_oa *oa = random_card(&r, 0.3, 0.3, false);
        oa->cell_mm = kg_random_in(&r, 0.5, 4);
        oa->margin_cells = whole(&r, 0, 2);
        if (n % 2 == 0) { /* a pyramid */
            kg_oa_destroy(oa);
            assert_int_equal(kg_oa_create(6, 4, 4, 2, &oa, NULL), KG_OK);
            for (int k = 1; k <= 3; k++)
                kg_oa_add(oa, k, k - 1, k - 1);
            oa->diagonals = true;
            oa->margin_cells = whole(&r, 0, 2);
        }
        double open = kg_random_in(&r, 0.05, KG_PI - 0.05);
        kg_oa_sheet *s;
        kg_mesh *mesh;
        assert_int_equal(kg_oa_sheet_create(oa, &s, NULL), KG_OK);
        assert_int_equal(kg_oa_pose(oa, s, NULL, open, &mesh, NULL), KG_OK);
        for (int i = 0; i < 100; i++) {
            kg_vec3 origin = random_point(&r, 30);
            kg_vec3 box = kg_v3(oa->width / 2.0, -oa->depth_limit / 3.0, oa->height / 3.0);
            kg_vec3 aim = kg_add(kg_scale(box, oa->cell_mm), random_point(&r, 6));
            kg_vec3 direction = kg_sub(aim, origin);
            double wanted = nearest(mesh, origin, direction);
            kg_oa_hit hit;
            bool is = kg_oa_pick(oa, s, open, origin, direction, &hit);
            assert_int_equal(is, isfinite(wanted));
            if (!is)
                continue;
            hits++;
            bent += hit.plane > KG_OA_FLOOR;
            assert_near(hit.distance, wanted, 1e-7);
            check_cell(oa, s, open, kg_madd(origin, hit.distance, direction), &hit);
        }
        kg_mesh_destroy(mesh);
        kg_oa_sheet_destroy(s);
        kg_oa_destroy(oa);
    }
    assert_true(hits > 5000 && bent > 200);
}

/* Straight down and level rays name the voxels. */
static void hits_name_the_voxel(void **state) {
    (void)state;
    kg_oa *oa;
    kg_oa_sheet *s;
    kg_oa_hit hit;
    assert_int_equal(kg_oa_create(5, 4, 5, 10, &oa, NULL), KG_OK);
    kg_oa_add(oa, 2, 1, 2);
    kg_oa_set_window(oa, 2, 1, true);
    oa->margin_cells = 3;
    assert_int_equal(kg_oa_sheet_create(oa, &s, NULL), KG_OK);
    const kg_vec3 down = {0, 0, -1}, inward = {0, 1, 0};
    const double half = KG_PI / 2;
    assert_true(kg_oa_pick(oa, s, half, kg_v3(25, -5, 100), down, &hit)); /* the roof */
    assert_true(hit.voxel.top && hit.printed && hit.plane == KG_OA_FLOOR && hit.level < 0);
    assert_true(hit.voxel.x == 2 && hit.voxel.y == 0 && hit.voxel.z == 2);
    assert_near(hit.distance, 70, 1e-6);
    assert_true(kg_oa_pick(oa, s, half, kg_v3(25, -35, 100), down, &hit)); /* the base */
    assert_true(hit.voxel.top && hit.voxel.y == 3 && hit.voxel.z == -1);
    assert_true(kg_oa_pick(oa, s, half, kg_v3(25, -90, 25), inward, &hit)); /* the front */
    assert_true(!hit.voxel.top && hit.printed && hit.level == 2);
    assert_true(hit.voxel.x == 2 && hit.voxel.y == 1 && hit.voxel.z == 2);
    assert_true(kg_oa_pick(oa, s, half, kg_v3(15, -90, 25), inward, &hit)); /* the back sheet */
    assert_true(!hit.voxel.top && hit.voxel.y == -1 && hit.voxel.z == 2 && hit.level < 0);
    assert_true(kg_oa_pick(oa, s, half, kg_v3(15, 90, 25), kg_v3(0, -1, 0), &hit));
    assert_true(!hit.printed && hit.voxel.x == 1);
    assert_false(kg_oa_pick(oa, s, half, kg_v3(25, -90, 15), inward, &hit)); /* the window */
    assert_true(kg_oa_pick(oa, s, half, kg_v3(25, -25, 17), kg_v3(0, 1, -0.5), &hit));
    assert_true(hit.voxel.top && hit.voxel.z == 0 && hit.level == 1); /* what lies in it */
    assert_true(!kg_oa_pick(oa, s, half, kg_v3(25, -90, 85), inward, &hit));
    assert_true(!kg_oa_pick(oa, s, half, kg_v3(25, -90, 5), kg_v3(0, -1, 0), &hit));
    assert_true(!kg_oa_pick(oa, s, half, kg_v3(NAN, 0, 0), kg_v3(0, INFINITY, NAN), &hit));
    assert_true(!kg_oa_pick(oa, s, half, kg_v3(0, 0, 0), kg_v3(0, 0, 0), &hit));
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

/* Every cell is met in the middle on the flat card, and no ray slips through an edge. */
static void flat_and_closed_cards_are_met(void **state) {
    (void)state;
    kg_random r = {8};
    kg_oa *oa = random_card(&r, 0.2, 0.2, true);
    kg_oa_sheet *s;
    kg_oa_hit hit;
    assert_int_equal(kg_oa_sheet_create(oa, &s, NULL), KG_OK);
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            kg_vec3 middle = kg_v3(x + 0.5, s->height - row - 0.5, 9);
            assert_true(kg_oa_pick(oa, s, KG_PI, middle, kg_v3(0, 0, -1), &hit));
            assert_true(hit.x == x && hit.row == row && hit.printed);
            kg_vec3 corner = kg_v3(x, s->height - row, 9);
            assert_true(kg_oa_pick(oa, s, KG_PI, corner, kg_v3(0, 0, -1), &hit));
        }
    assert_true(kg_oa_pick(oa, s, 0, kg_v3(0.5, -0.5, 9), kg_v3(0, 0, -1), &hit));
    assert_true(hit.plane == KG_OA_BACK && !hit.printed && hit.voxel.y == -1);
    assert_true(kg_oa_pick(oa, s, 0, kg_v3(0.5, -0.5, -9), kg_v3(0, 0, 1), &hit));
    assert_true(hit.plane == KG_OA_FLOOR && !hit.printed && hit.voxel.z == -1);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rays_meet_the_nearest_face),
                                       cmocka_unit_test(hits_name_the_voxel),
                                       cmocka_unit_test(flat_and_closed_cards_are_met)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
