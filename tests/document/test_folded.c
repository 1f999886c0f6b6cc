/* Sheets as documents: their motion, and the net object of their files. */
#include "document/folded.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static kg_document *read(const char *name) {
    char path[512];
    kg_document *d;
    kg_error error;
    snprintf(path, sizeof path, "%s/data/%s", SOURCE_ROOT, name);
    if (kg_document_read(path, &d, &error))
        fail_msg("%s", error.message);
    return d;
}

static kg_vec3 at_key(const kg_mesh *mesh, const kg_mesh_motion *m, size_t key, size_t vertex) {
    kg_vec3 p = mesh->positions[vertex];
    for (size_t i = 0; i < m->target_count; i++)
        p = kg_madd(p, m->weights[key * m->target_count + i], m->displacements[i][vertex]);
    return p;
}

static void check_motion(const char *name) {
    kg_document *d = read(name);
    kg_folded *folded = kg_folded_create(kg_origami_copy(kg_document_origami(d)));
    kg_mesh *mesh, *pose;
    kg_mesh_motion *m;
    assert_int_equal(kg_folded_motion(folded, &mesh, &m, NULL), KG_OK);
    assert_int_equal(kg_folded_mesh(folded, &pose, NULL), KG_OK);
    assert_int_equal(m->target_count, 3 * kg_origami_step(folded->origami));
    size_t last = m->key_count - 1;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        assert_true(kg_dist(at_key(mesh, m, last, v), pose->positions[v]) < 1e-9);
        assert_near(at_key(mesh, m, 0, v).z, 0, 1e-9); /* flat sheets */
    }
    for (size_t k = 1; k < m->key_count; k++)
        assert_true(m->times[k] > m->times[k - 1]);
    /* faces keep their shape at all keys, but for the layers' way apart */
    for (size_t k = 0; k < m->key_count; k++)
        for (size_t f = 0; f < mesh->face_count; f++) {
            size_t a = mesh->face_starts[f], n = mesh->face_starts[f + 1] - a;
            for (size_t i = 1; i < n; i++) {
                double now = kg_dist(at_key(mesh, m, k, a), at_key(mesh, m, k, a + i));
                assert_near(now, kg_dist(mesh->positions[a], mesh->positions[a + i]), 1e-9);
            }
        }
    kg_mesh_motion_destroy(m);
    kg_mesh_destroy(mesh);
    kg_mesh_destroy(pose);
    kg_folded_destroy(folded);
    kg_document_destroy(d);
}

static void test_the_motion_ends_at_the_pose_and_bends_no_face(void **user) {
    (void)user;
    check_motion("cup.katagami");
    check_motion("boat.katagami");
    check_motion("unit.katagami");
}

static void test_a_fold_under_way_begins_and_ends_at_the_states(void **user) {
    (void)user;
    kg_document *d = read("boat.katagami");
    kg_mesh *before, *begun, *half, *done, *after;
    assert_int_equal(kg_document_set_step(d, 3, NULL), KG_OK);
    assert_int_equal(kg_document_mesh(d, NULL, &before, NULL), KG_OK);
    kg_document_set_fraction(d, 1e-12);
    assert_int_equal(kg_document_mesh(d, NULL, &begun, NULL), KG_OK);
    kg_document_set_fraction(d, 0.5);
    assert_int_equal(kg_document_mesh(d, NULL, &half, NULL), KG_OK);
    kg_document_set_fraction(d, 1);
    assert_int_equal(kg_document_mesh(d, NULL, &done, NULL), KG_OK);
    kg_document_set_fraction(d, 0);
    assert_int_equal(kg_document_set_step(d, 4, NULL), KG_OK);
    assert_int_equal(kg_document_mesh(d, NULL, &after, NULL), KG_OK);
    assert_int_equal(done->vertex_count, after->vertex_count);
    for (size_t i = 0; i < done->vertex_count; i++)
        assert_true(kg_dist(done->positions[i], after->positions[i]) < 1e-9);
    kg_box3 a = kg_mesh_bounds(before), b = kg_mesh_bounds(begun), c = kg_mesh_bounds(half),
            e = kg_mesh_bounds(after);
    assert_true(kg_dist(a.lo, b.lo) < 1e-9 && kg_dist(a.hi, b.hi) < 1e-9);
    /* the sail, half way to upright, stands at 45 degrees */
    assert_true(c.hi.z > 0.6 * e.hi.z && c.hi.z < 0.8 * e.hi.z);
    kg_mesh_destroy(before);
    kg_mesh_destroy(begun);
    kg_mesh_destroy(half);
    kg_mesh_destroy(done);
    kg_mesh_destroy(after);
    kg_document_destroy(d);
}

static kg_vec2 paper_of(kg_vec2 sheet, double scale, const char *named) {
    kg_document *d;
    kg_net_options options;
    double tab_width;
    assert_int_equal(kg_document_new_sheet(sheet, 0, 0, &d, NULL), KG_OK);
    kg_document_net_settings(d)->scale = scale;
    kg_document_net_settings(d)->paper = named ? strdup(named) : NULL;
    assert_int_equal(kg_document_net_options(d, &options, &tab_width, NULL), KG_OK);
    kg_document_destroy(d);
    return options.paper;
}

static void test_the_net_of_a_sheet_is_on_paper_that_holds_it(void **user) {
    (void)user;
    assert_near(paper_of(kg_v2(150, 150), 1, NULL).x, 210, 0);
    assert_near(paper_of(kg_v2(194, 281), 1, NULL).x, 210, 0);
    assert_near(paper_of(kg_v2(281, 194), 1, NULL).x, 210, 0); /* across */
    assert_near(paper_of(kg_v2(210, 297), 1, NULL).x, 297, 0);
    assert_near(paper_of(kg_v2(210, 297), 0.9, NULL).x, 210, 0);
    assert_near(paper_of(kg_v2(400, 400), 1, NULL).x, 420, 0);
    assert_near(paper_of(kg_v2(5000, 400), 1, NULL).x, 210, 0); /* none does: refused there */
    assert_near(paper_of(kg_v2(210, 297), 1, "A4").x, 210, 0);
    assert_near(paper_of(kg_v2(210, 297), 1, "none").x, 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_motion_ends_at_the_pose_and_bends_no_face),
        cmocka_unit_test(test_the_net_of_a_sheet_is_on_paper_that_holds_it),
        cmocka_unit_test(test_a_fold_under_way_begins_and_ends_at_the_states),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
