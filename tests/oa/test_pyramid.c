#include "reference.h"

#include <stdlib.h>

static kg_oa *card(int w, int d, int h, const char *const *columns) {
    kg_oa *oa;
    assert_int_equal(kg_oa_create(w, d, h, 1, &oa, NULL), KG_OK);
    for (int x = 0; x < w; x++)
        for (int z = 0; z < h; z++)
            oa->depth[x * h + z] = columns[x][z] - '0';
    assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
    oa->diagonals = true;
    return oa;
}

static kg_oa_sheet *sheet_of(const kg_oa *oa) {
    kg_oa_sheet *sheet;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    return sheet;
}

/* ---- exact verification ----------------------------------------------------------------- */

/* The piece of a cell that has its left or right edge is placed by an isometry, at every angle. */
static void check_isometry(const kg_oa_piece *piece) {
    kg_oa_tuple o = kg_oa_piece_point(piece, 0, 0);
    kg_oa_tuple x = kg_oa_piece_point(piece, 1, 0), t = kg_oa_piece_point(piece, 0, 1);
    for (int deg = 0; deg <= 180; deg += 20) {
        kg_vec3 axes[5], u = {0, 0, 0}, v = {0, 0, 0};
        kg_oa_axes(deg * KG_PI / 180, axes);
        for (int i = 0; i < 5; i++) {
            u = kg_madd(u, x.v[i] - o.v[i], axes[i]);
            v = kg_madd(v, t.v[i] - o.v[i], axes[i]);
        }
        assert_near(kg_dot(u, u), 1, 1e-12);
        assert_near(kg_dot(v, v), 1, 1e-12);
        assert_near(kg_dot(u, v), 0, 1e-12);
    }
}

/* Walks down the left or right edge of every column in tuples: from (x, 0, H) to (x, D, 0). */
static void check_walks(const kg_oa_sheet *s) {
    for (int x = 0; x < s->width; x++)
        for (int side = 0; side < 2; side++) {
            kg_oa_tuple at = {{x + side, 0, s->height, 0, 0}};
            for (int row = 0; row < s->rows; row++) {
                kg_oa_piece piece = kg_oa_cell_piece(s, x, row, side);
                kg_oa_tuple from = kg_oa_piece_point(&piece, side, 0);
                kg_oa_tuple to = kg_oa_piece_point(&piece, side, -1);
                check_isometry(&piece);
                for (int i = 0; i < 5; i++) {
                    assert_int_equal(at.v[i], from.v[i]); /* nothing is torn on the way */
                    at.v[i] = to.v[i];
                }
            }
            const int end[5] = {x + side, s->depth, 0, 0, 0};
            assert_memory_equal(at.v, end, sizeof end);
        }
}

/* Cut length in cells, horizontal and vertical unit lines. */
static double cut_length(const kg_oa *oa) {
    kg_oa_sheet *s = sheet_of(oa);
    kg_oa_line *lines;
    size_t count;
    double sum = 0;
    assert_int_equal(kg_oa_lines(s, &lines, &count, NULL), KG_OK);
    for (size_t i = 0; i < count; i++)
        if (lines[i].kind == KG_OA_CUT)
            sum += hypot(lines[i].x1 - lines[i].x0, lines[i].row1 - lines[i].row0);
    free(lines);
    kg_oa_sheet_destroy(s);
    return sum;
}

static void check_cuts(kg_oa *oa, double steps, double pyramids) {
    oa->diagonals = false;
    assert_near(cut_length(oa), steps, 1e-12);
    oa->diagonals = true;
    assert_near(cut_length(oa), pyramids, 1e-12);
}

/* Is there this line, given by x and z - y? */
static void check_line(const kg_oa_sheet *s, kg_oa_edge kind, int x0, int t0, int x1, int t1) {
    kg_oa_line *lines;
    size_t count, found = 0;
    int row0 = s->height - t0, row1 = s->height - t1;
    assert_int_equal(kg_oa_lines(s, &lines, &count, NULL), KG_OK);
    for (size_t i = 0; i < count; i++) {
        const kg_oa_line *l = &lines[i];
        bool there = l->x0 == x0 && l->row0 == row0 && l->x1 == x1 && l->row1 == row1;
        bool back = l->x0 == x1 && l->row0 == row1 && l->x1 == x0 && l->row1 == row0;
        found += l->kind == kind && (there || back);
    }
    free(lines);
    assert_int_equal(found, 1);
}

/* Does a piece put the point (x, z - y) of the sheet there when the card stands (y to the front)?
 */
static void check_point(const kg_oa_sheet *s, int x, int t, double px, double py, double pz) {
    kg_vec3 axes[5];
    bool found = false;
    kg_oa_axes(KG_PI / 2, axes);
    for (int dx = -1; dx <= 0; dx++)
        for (int dr = -1; dr <= 0; dr++)
            for (int side = 0; side < 2; side++) {
                int cell_x = x + dx, row = s->height - t + dr;
                if (cell_x < 0 || row < 0 || cell_x >= s->width || row >= s->rows)
                    continue;
                kg_oa_piece piece = kg_oa_cell_piece(s, cell_x, row, side);
                kg_oa_tuple tuple = kg_oa_piece_point(&piece, -dx, dr);
                kg_vec3 p = {0, 0, 0};
                for (int i = 0; i < 5; i++)
                    p = kg_madd(p, tuple.v[i], axes[i]);
                found |= kg_dist(p, kg_v3(px, py, pz)) < 1e-12;
            }
    assert_true(found);
}

/* Held, one degree of freedom, lengths kept, flat when closed. */
static void check_folds(const kg_oa *oa, const kg_oa_sheet *s) {
    size_t missing;
    unsigned char *reached = malloc((size_t)s->width * (size_t)s->rows);
    assert_int_equal(kg_oa_flood(s, reached, &missing, NULL), KG_OK);
    assert_int_equal(missing, 0);
    free(reached);
    kg_oa_stability *stability;
    int degrees;
    assert_int_equal(kg_oa_stability_create(s, &stability, NULL), KG_OK);
    assert_int_equal(kg_oa_mobility(stability, &degrees, NULL), KG_OK);
    assert_int_equal(degrees, 1);
    assert_int_equal(stability->loose_count, 0);
    kg_oa_stability_destroy(stability);
    for (int deg = 0; deg <= 180; deg += 5) {
        kg_mesh *mesh;
        assert_int_equal(kg_oa_pose(oa, s, NULL, deg * KG_PI / 180, &mesh, NULL), KG_OK);
        for (size_t f = 0; f < mesh->face_count; f++) {
            uint32_t from = mesh->face_starts[f], n = mesh->face_starts[f + 1] - from;
            for (uint32_t i = 0; i < n; i++) {
                double d = kg_dist(mesh->positions[mesh->face_corners[from + i]],
                                   mesh->positions[mesh->face_corners[from + (i + 1) % n]]);
                assert_near(d, d > 1.2 ? sqrt(2) : 1, 1e-9);
            }
        }
        kg_box3 box = kg_mesh_bounds(mesh);
        if (deg == 0 || deg == 180)
            assert_near(box.hi.z - box.lo.z, 0, 1e-9);
        kg_mesh_destroy(mesh);
    }
}

/* ---- examples --------------------------------------------------------------------------- */

static void pyramid_on_growing_blocks(void **state) {
    (void)state;
    static const char *const columns[] = {"0000", "1000", "2200", "3330", "0000", "0000"};
    kg_oa *oa = card(6, 4, 4, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 1);
    check_line(s, KG_OA_VALLEY, 1, 0, 4, 3);
    check_line(s, KG_OA_VALLEY, 1, 0, 4, -3);
    check_line(s, KG_OA_MOUNTAIN, 1, 0, 4, 0);
    check_line(s, KG_OA_CUT, 4, -3, 4, 3);
    check_point(s, 4, 3, 4, 0, 3);
    check_point(s, 4, -3, 4, 3, 0);
    check_point(s, 4, 0, 2, 2, 2);
    check_walks(s);
    check_folds(oa, s);
    check_cuts(oa, 18, 6);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void two_pyramids_share_the_cut_between_them(void **state) {
    (void)state;
    static const char *const columns[] = {"0000", "1000", "2200", "3330", "2200", "1000", "0000"};
    kg_oa *oa = card(7, 4, 4, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 2);
    check_line(s, KG_OA_VALLEY, 6, 0, 4, 2);
    check_line(s, KG_OA_VALLEY, 6, 0, 4, -2);
    check_line(s, KG_OA_MOUNTAIN, 1, 0, 6, 0); /* both spines: one straight line */
    check_line(s, KG_OA_CUT, 4, -3, 4, 3);
    check_point(s, 4, 0, 2, 2, 2);
    check_point(s, 4, 0, 16.0 / 3, 4.0 / 3, 4.0 / 3);
    check_walks(s);
    check_folds(oa, s);
    check_cuts(oa, 24, 6);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void notch_in_a_block(void **state) {
    (void)state;
    static const char *const columns[] = {"00000", "44440", "44430", "44220", "44440", "00000"};
    kg_oa *oa = card(6, 5, 5, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 1);
    assert_true(s->pyramids[0].notch);
    check_line(s, KG_OA_MOUNTAIN, 2, 0, 4, 2);
    check_line(s, KG_OA_MOUNTAIN, 2, 0, 4, -2);
    check_line(s, KG_OA_VALLEY, 2, 0, 4, 0);
    check_point(s, 2, 0, 2, 4, 4);
    check_point(s, 4, 2, 4, 2, 4);
    check_point(s, 4, -2, 4, 4, 2);
    check_point(s, 4, 0, 8.0 / 3, 8.0 / 3, 8.0 / 3);
    check_walks(s);
    check_folds(oa, s);
    check_cuts(oa, 26, 20);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void apexes_that_meet_join_their_diagonals(void **state) {
    (void)state;
    static const char *const columns[] = {"0000", "2200", "1000", "1000", "2200", "0000"};
    kg_oa *oa = card(6, 4, 4, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 2);
    check_line(s, KG_OA_VALLEY, 1, 2, 5, -2);
    check_line(s, KG_OA_VALLEY, 1, -2, 5, 2);
    check_line(s, KG_OA_MOUNTAIN, 1, 0, 5, 0);
    check_walks(s);
    check_folds(oa, s);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void pyramids_never_share_a_box(void **state) {
    (void)state;
    static const char *const columns[] = {"0000", "3330", "2200", "0000", "2200", "3330", "0000"};
    kg_oa *oa = card(7, 4, 4, columns); /* virtual apexes behind each other's */
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 1);
    check_walks(s);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void virtual_apex_folds_as_well(void **state) {
    (void)state;
    static const char *const columns[] = {"00000", "00000", "22000", "33300", "44440", "00000"};
    kg_oa *oa = card(6, 5, 5, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 1);
    assert_int_equal(s->pyramids[0].apex, 1);
    check_line(s, KG_OA_VALLEY, 2, 1, 5, 4);
    check_line(s, KG_OA_VALLEY, 2, -1, 5, -4);
    check_line(s, KG_OA_MOUNTAIN, 2, 0, 5, 0);
    check_walks(s);
    check_folds(oa, s);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void refused(int w, int d, int h, const char *const *columns) {
    kg_oa *oa = card(w, d, h, columns);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 0);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

static void what_does_not_fold_keeps_its_steps(void **state) {
    (void)state;
    /* a stepped roof of depth 1: top and mountain diagonal only */
    refused(6, 4, 5, (const char *const[]){"00000", "10000", "11000", "11100", "00000", "00000"});
    /* a front of height 2 and depths 1, 2, 3 */
    refused(6, 5, 4, (const char *const[]){"0000", "1100", "2200", "3300", "0000", "0000"});
    /* heights 1, 2, 2, 1 with a joined ridge: only runs of one column are left */
    refused(6, 4, 4, (const char *const[]){"0000", "1000", "2200", "2200", "1000", "0000"});
    /* the upper diagonal alone: the depth does not grow with the height */
    refused(5, 5, 5, (const char *const[]){"00000", "33000", "33300", "33330", "00000"});
    /* something stands in the box of a virtual apex */
    refused(6, 5, 5, (const char *const[]){"00000", "10000", "33300", "44440", "00000", "00000"});
}

static void windows_and_omitted_tops_keep_their_steps(void **state) {
    (void)state;
    static const char *const columns[] = {"0000", "1000", "2200", "3330", "0000", "0000"};
    kg_oa *oa = card(6, 4, 4, columns);
    kg_oa_set_window(oa, 3, 1, true);
    kg_oa_sheet *s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 0);
    kg_oa_sheet_destroy(s);
    kg_oa_set_window(oa, 3, 1, false);
    kg_oa_set_omitted(oa, 2, 2, true);
    s = sheet_of(oa);
    assert_int_equal(s->pyramid_count, 0);
    kg_oa_sheet_destroy(s);
    kg_oa_destroy(oa);
}

/* Whatever is found passes the exact walk, adds no cut, and folds. */
static void found_at_random_all_fold(void **state) {
    (void)state;
    kg_random r = {31};
    size_t found = 0, cards = 0;
    for (int i = 0; i < 200000 && cards < 300; i++) {
        kg_oa *oa;
        int w = whole(&r, 4, 8), h = whole(&r, 3, 6), d = whole(&r, 3, 6);
        assert_int_equal(kg_oa_create(w, d, h, 1, &oa, NULL), KG_OK);
        for (int x = 1, k = 0; x < w - 1; x++) {
            k += whole(&r, -1, 1);
            k = k < 0 ? 0 : k;
            int wide = k < d - 1 ? k : d - 1, high = k < h - 1 ? k : h - 1;
            if (chance(&r, 0.3)) /* a step below or behind */
                kg_oa_add(oa, x, whole(&r, 0, d - 2), 0);
            if (wide > 0 && high > 0)
                kg_oa_add(oa, x, wide - 1, high - 1);
        }
        oa->diagonals = true;
        kg_oa_sheet *s = sheet_of(oa);
        if (s->pyramid_count > 0) {
            check_walks(s);
            double bent = cut_length(oa);
            kg_oa_stability *stability;
            int degrees[2];
            size_t loose;
            assert_int_equal(kg_oa_stability_create(s, &stability, NULL), KG_OK);
            assert_int_equal(kg_oa_mobility(stability, &degrees[0], NULL), KG_OK);
            loose = stability->loose_count;
            kg_oa_stability_destroy(stability);
            assert_int_equal(loose == 0, degrees[0] == 1);
            oa->diagonals = false;
            assert_true(bent < cut_length(oa));
            found += s->pyramid_count;
            cards++;
        }
        kg_oa_sheet_destroy(s);
        kg_oa_destroy(oa);
    }
    assert_true(cards == 300 && found > 300);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pyramid_on_growing_blocks),
        cmocka_unit_test(two_pyramids_share_the_cut_between_them),
        cmocka_unit_test(notch_in_a_block),
        cmocka_unit_test(apexes_that_meet_join_their_diagonals),
        cmocka_unit_test(pyramids_never_share_a_box),
        cmocka_unit_test(virtual_apex_folds_as_well),
        cmocka_unit_test(what_does_not_fold_keeps_its_steps),
        cmocka_unit_test(windows_and_omitted_tops_keep_their_steps),
        cmocka_unit_test(found_at_random_all_fold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
