/* What sticks out of a closed card: the rule against the card posed shut. */
#include "reference.h"

#include <stdlib.h>

/* How far vertices of each cell's faces lie outside the outline of the two closed sheets, cells. */
static double *posed_outside(const kg_oa *oa, const kg_oa_sheet *sheet) {
    double *out = calloc((size_t)sheet->width * (size_t)sheet->rows, sizeof *out);
    double length =
        oa->margin_cells + (oa->height > oa->depth_limit ? oa->height : oa->depth_limit);
    double left = -oa->margin_cells, right = oa->width + oa->margin_cells;
    kg_mesh *mesh;
    size_t at_face = 0;
    assert_non_null(out);
    assert_int_equal(kg_oa_pose(oa, sheet, NULL, 0, &mesh, NULL), KG_OK);
    for (int row = 0; row < sheet->rows; row++)
        for (int x = 0; x < sheet->width; x++) {
            int sides = kg_oa_cell_shape(sheet, x, row) == KG_OA_WHOLE ? 1 : 2;
            for (; sides > 0; sides--, at_face++)
                for (uint32_t c = mesh->face_starts[at_face]; c < mesh->face_starts[at_face + 1];
                     c++) {
                    kg_vec3 p = kg_scale(mesh->positions[mesh->face_corners[c]], 1 / oa->cell_mm);
                    double most = fmax(fmax(-p.y - length, p.y), fmax(left - p.x, p.x - right));
                    double *at = &out[row * sheet->width + x];
                    assert_near(p.z, 0, 1e-9);
                    *at = fmax(*at, most > 1e-9 ? most : 0);
                }
        }
    assert_int_equal(at_face, mesh->face_count);
    kg_mesh_destroy(mesh);
    return out;
}

/* Every cell that sticks out is in one remark, which says how far; adjacent columns share it. */
static size_t check_card(const kg_oa *oa) {
    solved s = solve(oa);
    double *outside = posed_outside(oa, s.sheet), most = 0;
    size_t found = 0, cells = (size_t)s.sheet->width * (size_t)s.sheet->rows;
    int last = -1;
    for (size_t i = 0; i < s.remarks->count; i++) {
        const kg_oa_remark *r = &s.remarks->items[i];
        double length = 0;
        if (r->trouble != KG_OA_OVERHANG)
            continue;
        assert_true(r->x0 > last);
        last = r->x1;
        for (size_t k = 0; k < r->cells; k++) {
            int32_t cell = s.remarks->cells[r->first_cell + k];
            assert_true(outside[cell] > 0);
            length = fmax(length, outside[cell]);
            outside[cell] = 0;
            found++;
        }
        assert_near(r->mm, length * oa->cell_mm * oa->net.scale, 1e-9);
        most = fmax(most, length);
    }
    for (size_t i = 0; i < cells; i++)
        assert_true(outside[i] == 0); /* none is left out */
    assert_near(kg_oa_overhang(s.sheet), most, 1e-9);
    free(outside);
    clear(&s);
    return found;
}

/* So many more cells of margin cover the model, and not one less (but that a wider margin may let
 * another pyramid fold). */
static void check_margin(kg_oa *oa) {
    kg_oa_sheet *sheet;
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    int more = kg_oa_overhang(sheet);
    kg_oa_sheet_destroy(sheet);
    oa->margin_cells += more;
    assert_int_equal(check_card(oa), 0);
    if (more > 0 && !oa->diagonals) {
        oa->margin_cells--;
        assert_true(check_card(oa) > 0);
    }
}

static void remarks_equal_the_card_posed_shut(void **state) {
    (void)state;
    kg_random r = {41};
    size_t out = 0, within = 0;
    for (int n = 0; n < 600; n++) {
        kg_oa *oa = random_card(&r, n % 3 * 0.1, n % 4 * 0.1, n % 2);
        oa->margin_cells = whole(&r, 0, 3);
        oa->cell_mm = whole(&r, 1, 5);
        oa->net.scale = n % 5 == 0 ? 0.5 : 1;
        size_t cells = check_card(oa);
        out += cells > 0;
        within += cells == 0;
        check_margin(oa);
        kg_oa_destroy(oa);
    }
    assert_true(out > 100 && within > 100);
}

/* Pyramids, whose folds reach less far than the steps they stand for. */
static void pyramids_stick_out_less_than_their_steps(void **state) {
    (void)state;
    kg_random r = {42};
    size_t pyramids = 0, out = 0;
    for (int n = 0; n < 300; n++) {
        kg_oa *oa;
        int blocks = whole(&r, 2, 5), base = whole(&r, 0, 2), size = blocks + 2 + whole(&r, 0, 3);
        assert_int_equal(kg_oa_create(blocks + 3, size, size, 1, &oa, NULL), KG_OK);
        for (int k = 1; k <= blocks; k++) {
            int x = n % 2 ? 1 + k : blocks + 1 - k;
            if (base > 0)
                kg_oa_add(oa, x, base - 1, size - 1 - whole(&r, 0, 1));
            kg_oa_add(oa, x, base + k - 1, k - 1);
        }
        size_t steps = check_card(oa);
        oa->diagonals = true;
        size_t bent = check_card(oa);
        kg_oa_sheet *sheet;
        assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
        pyramids += sheet->pyramid_count;
        out += bent > 0;
        assert_true(bent <= steps);
        kg_oa_sheet_destroy(sheet);
        check_margin(oa);
        kg_oa_destroy(oa);
    }
    assert_true(pyramids > 50 && out > 10);
}

/* Each tower is named by itself, with its columns and how far it sticks out. */
static void towers_are_named_one_by_one(void **state) {
    (void)state;
    char text[512];
    kg_oa *oa;
    assert_int_equal(kg_oa_create(9, 6, 8, 5, &oa, NULL), KG_OK);
    for (int x = 1; x <= 2; x++)
        kg_oa_add(oa, x, 3, 6); /* to y + z = 11 */
    kg_oa_add(oa, 4, 2, 4);     /* to 8, the longer side */
    kg_oa_add(oa, 6, 4, 3);     /* to 9 */
    solved s = solve(oa);
    const kg_oa_remark *found[2];
    size_t count = 0;
    for (size_t i = 0; i < s.remarks->count; i++)
        if (s.remarks->items[i].trouble == KG_OA_OVERHANG) {
            assert_true(count < 2);
            found[count++] = &s.remarks->items[i];
        }
    assert_int_equal(count, 2);
    assert_true(found[0]->x0 == 1 && found[0]->x1 == 3 && found[1]->x0 == 6 && found[1]->x1 == 7);
    assert_near(found[0]->mm, 15, 1e-12);
    assert_near(found[1]->mm, 5, 1e-12);
    kg_oa_remark_say(found[0], text, sizeof text);
    assert_non_null(strstr(text, "columns 1-2"));
    assert_non_null(strstr(text, "15 mm: the model sticks out of the card when it is closed"));
    assert_false(kg_oa_is_fault(KG_OA_OVERHANG));
    assert_int_equal(kg_oa_overhang(s.sheet), 3);
    clear(&s);
    kg_oa_destroy(oa);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(remarks_equal_the_card_posed_shut),
        cmocka_unit_test(pyramids_stick_out_less_than_their_steps),
        cmocka_unit_test(towers_are_named_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
