#include "reference.h"

#include <stdlib.h>

enum { CARDS = 2000 };

static kg_oa_sheet *sheet_of(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    return sheet;
}

/* ---- nets ------------------------------------------------------------------------------- */

/* Unit lines of a net: [row * (width + 1) + x], horizontal to the right and vertical downwards. */
typedef struct units {
    int width, rows;
    unsigned char *right, *down; /* kg_oa_edge */
} units;

static void draw_unit(unsigned char *at, kg_oa_edge kind) {
    assert_int_equal(*at, KG_OA_NONE); /* no line twice */
    *at = (unsigned char)kind;
}

static void draw_line(units *u, const kg_net_line *line, double cell) {
    static const kg_oa_edge kinds[] = {KG_OA_CUT, KG_OA_MOUNTAIN, KG_OA_VALLEY, KG_OA_NONE};
    assert_int_equal(line->count, 2);
    int x = (int)lround(line->points[0].x / cell), row = (int)lround(line->points[0].y / cell);
    int x1 = (int)lround(line->points[1].x / cell), row1 = (int)lround(line->points[1].y / cell);
    assert_near(x * cell, line->points[0].x, 1e-9);
    assert_near(row1 * cell, line->points[1].y, 1e-9);
    assert_true((x == x1) != (row == row1));
    for (; x < x1; x++)
        draw_unit(&u->right[row * (u->width + 1) + x], kinds[line->kind]);
    for (; row < row1; row++)
        draw_unit(&u->down[row * (u->width + 1) + x], kinds[line->kind]);
    assert_true(x == x1 && row == row1);
}

/* Lines of one kind that go straight on are one line. */
static void check_joined(const kg_net_part *p) {
    for (size_t i = 0; i < p->line_count; i++)
        for (size_t k = 0; k < p->line_count; k++) {
            const kg_vec2 *a = p->lines[i].points, *b = p->lines[k].points;
            bool meet = kg_dist2(a[1], b[0]) < 1e-9;
            bool straight = fabs(kg_cross2(kg_sub2(a[1], a[0]), kg_sub2(b[1], b[0]))) < 1e-9;
            assert_false(meet && straight && p->lines[i].kind == p->lines[k].kind);
        }
}

static void check_net(const kg_oa *oa) {
    kg_oa_sheet *sheet = sheet_of(oa);
    face *faces = faces_of(oa);
    kg_net *net;
    assert_int_equal(kg_oa_net(oa, sheet, &net, NULL), KG_OK);
    assert_int_equal(kg_net_check(net, NULL), KG_OK);
    assert_int_equal(net->part_count, 1);
    units u = {.width = oa->width, .rows = oa->height + oa->depth_limit};
    size_t points = (size_t)(u.width + 1) * (size_t)(u.rows + 1);
    u.right = calloc(points, 1);
    u.down = calloc(points, 1);
    for (size_t i = 0; i < net->parts[0].line_count; i++)
        draw_line(&u, &net->parts[0].lines[i], oa->cell_mm);
    for (int row = 0; row <= u.rows; row++)
        for (int x = 0; x <= u.width; x++) {
            kg_oa_edge right = KG_OA_NONE, down = KG_OA_NONE; /* the border is the outline */
            if (x < u.width && row > 0 && row < u.rows)
                right = edge_below(oa, faces, x, row - 1);
            if (row < u.rows && x > 0 && x < u.width)
                down = edge_right(oa, faces, x - 1, row);
            assert_int_equal(u.right[row * (u.width + 1) + x], right);
            assert_int_equal(u.down[row * (u.width + 1) + x], down);
        }
    check_joined(&net->parts[0]);
    free(u.right);
    free(u.down);
    free(faces);
    kg_net_destroy(net);
    kg_oa_sheet_destroy(sheet);
}

static void net_equals_table_1_on_the_faces(void **state) {
    (void)state;
    kg_random r = {1};
    for (int i = 0; i < CARDS; i++) {
        kg_oa *oa = random_card(&r, i % 4 * 0.15, i % 3 == 0 ? 0.3 : 0, i % 2);
        oa->cell_mm = 0.25 + i % 7;
        check_net(oa);
        kg_oa_destroy(oa);
    }
}

static void margins_are_plain_sheet_around_the_same_net(void **state) {
    (void)state;
    kg_random r = {2};
    for (int i = 0; i < 200; i++) {
        kg_oa *oa = random_card(&r, 0.3, 0.2, false);
        kg_oa_sheet *bare = sheet_of(oa);
        int m = oa->margin_cells = whole(&r, 1, 3);
        kg_oa_sheet *wide = sheet_of(oa);
        assert_int_equal(wide->width, bare->width + 2 * m);
        assert_int_equal(wide->rows, bare->rows + 2 * m);
        for (int row = 0; row < wide->rows; row++)
            for (int x = 0; x < wide->width; x++) {
                int32_t place = wide->place[row * wide->width + x];
                bool inside = x >= m && x < m + bare->width && row >= m && row < m + bare->rows;
                int32_t plain = row < wide->height ? 0 : 2 * (row - wide->height) + 1;
                assert_int_equal(place,
                                 inside ? bare->place[(row - m) * bare->width + x - m] : plain);
            }
        kg_oa_sheet_destroy(bare);
        kg_oa_sheet_destroy(wide);
        kg_oa_destroy(oa);
    }
}

/* ---- validity --------------------------------------------------------------------------- */

static void validity_equals_flood_fill(void **state) {
    (void)state;
    kg_random r = {3};
    size_t valid = 0;
    for (int i = 0; i < CARDS; i++) {
        kg_oa *oa = random_card(&r, i % 4 * 0.1, i % 3 == 0 ? 0.1 : 0, i % 5 > 0);
        kg_oa_sheet *sheet = sheet_of(oa);
        face *faces = faces_of(oa);
        unsigned char *reached = malloc((size_t)sheet->width * (size_t)sheet->rows);
        size_t missing;
        assert_int_equal(kg_oa_flood(sheet, reached, &missing, NULL), KG_OK);
        assert_int_equal(missing, flood_fill(oa, faces));
        valid += missing == 0;
        free(reached);
        free(faces);
        kg_oa_sheet_destroy(sheet);
        kg_oa_destroy(oa);
    }
    assert_true(valid > CARDS / 5 && valid < CARDS * 9 / 10); /* both outcomes are common */
}

static void front_without_support_below_is_invalid(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(5, 4, 5, 1, &oa, NULL), KG_OK);
    for (int x = 1; x < 4; x++)
        kg_oa_add(oa, x, 1, 3);
    unsigned char reached[5 * 9];
    size_t missing;
    for (int step = 0; step < 2; step++) {
        kg_oa_sheet *sheet = sheet_of(oa);
        assert_int_equal(kg_oa_flood(sheet, reached, &missing, NULL), KG_OK);
        assert_int_equal(missing, step == 0 ? 0 : 9);
        kg_oa_sheet_destroy(sheet);
        for (int x = 1; x < 4; x++) /* the lowest row goes: nothing carries the rest */
            kg_oa_set_window(oa, x, 0, true);
    }
    kg_oa_destroy(oa);
}

/* ---- posing ----------------------------------------------------------------------------- */

static void check_edges(const kg_mesh *mesh, double cell) {
    for (size_t f = 0; f < mesh->face_count; f++) {
        uint32_t from = mesh->face_starts[f], n = mesh->face_starts[f + 1] - from;
        for (uint32_t i = 0; i < n; i++) {
            double length = kg_dist(mesh->positions[mesh->face_corners[from + i]],
                                    mesh->positions[mesh->face_corners[from + (i + 1) % n]]);
            double wanted = length > 1.2 * cell ? sqrt(2) * cell : cell;
            assert_near(length, wanted, 1e-9);
        }
    }
}

/* Cells on both sides of a fold, or of nothing, share its ends. */
static void check_whole(const kg_oa *oa, const kg_oa_sheet *s, const face *faces,
                        const kg_mesh *mesh) {
    enum { UPPER_LEFT, LOWER_LEFT, LOWER_RIGHT, UPPER_RIGHT };
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            const uint32_t *cell = mesh->face_corners + (size_t)4 * (size_t)(row * s->width + x);
            const uint32_t *right = cell + 4, *below = cell + (size_t)4 * (size_t)s->width;
            if (x + 1 < s->width && edge_right(oa, faces, x, row) != KG_OA_CUT)
                assert_true(cell[UPPER_RIGHT] == right[UPPER_LEFT] &&
                            cell[LOWER_RIGHT] == right[LOWER_LEFT]);
            if (row + 1 < s->rows && edge_below(oa, faces, x, row) != KG_OA_CUT)
                assert_true(cell[LOWER_LEFT] == below[UPPER_LEFT] &&
                            cell[LOWER_RIGHT] == below[UPPER_RIGHT]);
        }
}

static void valid_cards_open_and_close_flat(void **state) {
    (void)state;
    kg_random r = {4};
    size_t count = 0;
    for (int i = 0; i < CARDS; i++) {
        kg_oa *oa = random_card(&r, 0.15, 0.1, true);
        oa->cell_mm = 2.5;
        kg_oa_sheet *sheet = sheet_of(oa);
        face *faces = faces_of(oa);
        size_t missing = flood_fill(oa, faces);
        count += missing == 0;
        for (int deg = 0; deg <= 180 && missing == 0; deg += 15) {
            kg_mesh *mesh;
            assert_int_equal(kg_oa_pose(oa, sheet, NULL, deg * KG_PI / 180, &mesh, NULL), KG_OK);
            assert_int_equal(kg_mesh_check(mesh, NULL), KG_OK);
            assert_int_equal(mesh->face_count, sheet->width * sheet->rows);
            check_edges(mesh, 2.5);
            check_whole(oa, sheet, faces, mesh);
            kg_box3 box = kg_mesh_bounds(mesh);
            double height = box.hi.z - box.lo.z;
            if (deg == 0 || deg == 180)
                assert_near(height, 0, 1e-9);
            else
                assert_near(height, 2.5 * sheet->height * sin(deg * KG_PI / 180), 1e-9);
            if (deg == 180) /* the sheet as it was cut out */
                assert_near(box.hi.y - box.lo.y, 2.5 * sheet->rows, 1e-9);
            kg_mesh_destroy(mesh);
        }
        free(faces);
        kg_oa_sheet_destroy(sheet);
        kg_oa_destroy(oa);
    }
    assert_true(count > 300);
}

static void standing_card_is_the_voxels_own_surface(void **state) {
    (void)state;
    kg_oa *oa;
    assert_int_equal(kg_oa_create(3, 3, 3, 2, &oa, NULL), KG_OK);
    kg_oa_add(oa, 1, 0, 1);
    kg_oa_sheet *sheet = sheet_of(oa);
    kg_mesh *mesh;
    assert_int_equal(kg_oa_pose(oa, sheet, NULL, KG_PI / 2, &mesh, NULL), KG_OK);
    kg_box3 box = kg_mesh_bounds(mesh);
    assert_near(box.lo.y, -6, 1e-12); /* the front view looks along +y */
    assert_near(box.hi.y, 0, 1e-12);
    assert_near(box.hi.z, 6, 1e-12);
    kg_mesh_query *query;
    kg_mesh_hit hit;
    assert_int_equal(kg_mesh_query_create(mesh, NULL, &query, NULL), KG_OK);
    assert_true(kg_mesh_query_ray(query, kg_v3(3, -20, 1), kg_v3(0, 1, 0), &hit));
    assert_near(hit.point.y, -2, 1e-12);
    assert_near(hit.normal.y, -1, 1e-12); /* its printed side */
    assert_true(kg_mesh_query_ray(query, kg_v3(3, -1, 20), kg_v3(0, 0, -1), &hit));
    assert_near(hit.point.z, 4, 1e-12);
    assert_near(hit.normal.z, 1, 1e-12);
    kg_mesh_query_destroy(query);
    kg_mesh_destroy(mesh);
    kg_oa_sheet_destroy(sheet);
    kg_oa_destroy(oa);
}

static void motion_passes_through_every_pose(void **state) {
    (void)state;
    kg_random r = {5};
    for (int i = 0; i < 20; i++) {
        kg_oa *oa = random_card(&r, 0.2, 0, true);
        kg_oa_sheet *sheet = sheet_of(oa);
        kg_mesh *mesh, *pose;
        kg_mesh_motion *motion;
        assert_int_equal(kg_oa_motion(oa, sheet, NULL, 1.1, &mesh, &motion, NULL), KG_OK);
        for (size_t k = 0; k < motion->key_count; k += 7) {
            double open = KG_PI * fabs(1 - 2.0 * (double)k / (double)(motion->key_count - 1));
            assert_int_equal(kg_oa_pose(oa, sheet, NULL, open, &pose, NULL), KG_OK);
            for (size_t v = 0; v < mesh->vertex_count; v++) {
                kg_vec3 p = mesh->positions[v];
                for (size_t t = 0; t < motion->target_count; t++)
                    p = kg_madd(p, motion->weights[k * motion->target_count + t],
                                motion->displacements[t][v]);
                assert_near(kg_dist(p, pose->positions[v]), 0, 1e-12);
            }
            kg_mesh_destroy(pose);
        }
        kg_mesh_destroy(mesh);
        kg_mesh_motion_destroy(motion);
        kg_oa_sheet_destroy(sheet);
        kg_oa_destroy(oa);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(net_equals_table_1_on_the_faces),
        cmocka_unit_test(margins_are_plain_sheet_around_the_same_net),
        cmocka_unit_test(validity_equals_flood_fill),
        cmocka_unit_test(front_without_support_below_is_invalid),
        cmocka_unit_test(valid_cards_open_and_close_flat),
        cmocka_unit_test(standing_card_is_the_voxels_own_surface),
        cmocka_unit_test(motion_passes_through_every_pose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
