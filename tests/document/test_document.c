/* Documents: surfaces as meshes, and references where the model says they are. */
#include "base/file.h"
#include "katagami/document.h"
#include "model/edit.h"
#include "tests/model/random_model.h"

#include <unistd.h>

static kg_document *document_of(kg_model *model, const char *path) {
    kg_document *d = NULL;
    kg_error error;
    if (kg_document_from_model(model, path, &d, &error) ||
        kg_document_solve(d, KG_MESH_CHORD, &error))
        fail_msg("%s", error.message);
    return d;
}

static void color_by_group(size_t group, float out_rgba[4]) {
    out_rgba[0] = (float)group;
    out_rgba[1] = out_rgba[2] = out_rgba[3] = 1;
}

static double area_of_group(const kg_mesh *m, size_t group, const kg_vec3 *front) {
    double sum = 0;
    for (size_t f = 0; f < m->groups[group].face_count; f++) {
        const uint32_t *c = m->face_corners + m->face_starts[m->groups[group].first_face + f];
        kg_vec3 a = m->positions[c[0]], b = m->positions[c[1]], d = m->positions[c[2]];
        kg_vec3 n = kg_scale(kg_cross(kg_sub(b, a), kg_sub(d, a)), 0.5);
        assert_true(!front || kg_dot(n, *front) > 0);
        sum += kg_len(n);
    }
    return sum;
}

static void the_surface_has_a_group_for_every_part_patch(void **state) {
    (void)state;
    for (int flip = 0; flip < 2; flip++) {
        kg_model *model = checked(kg_model_create());
        kg_patch_input ground =
            flat_input(kg_v3(0, 0, 0), kg_v3(100, 0, 0), kg_v3(0, 1, 0), -50, 50);
        ground.flip = flip;
        add_patch(model, 5,
                  flat_input(kg_v3(50, 0, -20), kg_v3(50, 0, 60), kg_v3(0, 1, 0), -60, 60))
            ->construction = true;
        kg_model_patch *p = add_patch(model, 2, ground);
        free(p->name);
        p->name = checked(strdup("床"));
        insert_trim(p, 0, trim_by(5)); /* two pieces, one group */
        p = add_patch(model, 1,
                      flat_input(kg_v3(0, 0, 9), kg_v3(100, 0, 9), kg_v3(0, 1, 0), -5, 5));
        p->hidden = true;
        assert_int_equal(kg_model_set_patch_color(p, "#00ff80", NULL), KG_OK);
        kg_document *d = document_of(model, NULL);
        kg_mesh *mesh = NULL;
        assert_int_equal(kg_document_mesh(d, color_by_group, &mesh, NULL), KG_OK);
        assert_int_equal(mesh->group_count, 2);
        assert_string_equal(mesh->groups[0].name, "床");
        assert_string_equal(mesh->groups[1].name, "patch 1");
        assert_near((double)mesh->groups[0].color[0], 1,
                    0); /* of the palette, by its id less one */
        assert_near((double)mesh->groups[1].color[1], 1, 1e-6); /* its own */
        assert_near((double)mesh->groups[1].color[2], 0.2158605, 1e-6);
        kg_vec3 up = kg_v3(0, 0, flip ? -1 : 1); /* n = p' x d */
        assert_near(area_of_group(mesh, 0, &up), 1e4, 1e-6);
        assert_near(area_of_group(mesh, 1, NULL), 1e3, 1e-6);
        kg_mesh_destroy(mesh);
        kg_document_destroy(d);
    }
}

static void a_faulty_model_has_no_mesh_and_no_net(void **state) {
    (void)state;
    kg_model *model = checked(kg_model_create());
    kg_patch_input in = flat_input(kg_v3(0, 0, 0), kg_v3(0, 0, 0), kg_v3(0, 1, 0), -5, 5);
    add_patch(model, 3, in);
    kg_document *d = document_of(model, "a/b.katagami");
    kg_mesh *mesh = NULL;
    kg_document_net net = {0};
    kg_error error;
    assert_int_equal(kg_document_mesh(d, NULL, &mesh, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "a/b.katagami: patch 3: "));
    assert_int_equal(kg_document_unroll(d, 5, &net, &error), KG_ERR_INPUT);
    assert_true(!mesh && !net.net);
    kg_document_destroy(d);
}

/* A box of 2 x 4 x 6 in its own axes, in a folder of its own beside the model's. */
static void references_are_turned_scaled_and_moved(void **state) {
    (void)state;
    static const char box[] = "v 0 0 0\nv 2 0 0\nv 0 4 0\nv 0 0 6\nf 1 2 3\nf 1 3 4\n";
    char folder[] = "/tmp/katagami-XXXXXX", mesh_path[64], model_path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(mesh_path, sizeof mesh_path, "%s/box.obj", folder);
    snprintf(model_path, sizeof model_path, "%s/box.katagami", folder);
    assert_int_equal(kg_file_write(mesh_path, box, sizeof box - 1, NULL), KG_OK);
    for (int kind = 0; kind < 8; kind++) {
        kg_model *model = checked(kg_model_create());
        kg_reference *ref = &model->reference;
        ref->file = checked(strdup("box.obj"));
        ref->up_y = kind & 1;
        ref->size_mm = kind & 2 ? 60 : 0;
        ref->has_matrix = kind & 4;
        const double move[16] = {1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        memcpy(ref->matrix, move, sizeof move);
        kg_document *d = document_of(model, model_path);
        kg_mesh *mesh = NULL;
        kg_error error;
        if (kg_document_reference(d, NULL, &mesh, &error))
            fail_msg("%s", error.message);
        kg_box3 b = kg_box3_empty();
        for (size_t i = 0; i < mesh->vertex_count; i++)
            kg_box3_add(&b, mesh->positions[i]);
        double scale = kind & 2 ? 10 : 1, x = kind & 4 ? 100 : 0;
        assert_near(b.hi.x - b.lo.x, 2 * scale, 1e-4);
        assert_near(b.hi.z - b.lo.z, (kind & 1 ? 4 : 6) * scale, 1e-4);
        assert_near(0.5 * (b.lo.x + b.hi.x), x + (kind & 2 ? 0 : 1), 1e-4);
        if (!(kind & 2))
            assert_near(kind & 1 ? b.lo.y : b.hi.y, kind & 1 ? -6 : 4, 1e-4);
        kg_mesh_destroy(mesh);
        kg_document_destroy(d);
    }
    assert_int_equal(unlink(mesh_path), 0);
    assert_int_equal(rmdir(folder), 0);
}

static void a_missing_reference_is_named(void **state) {
    (void)state;
    kg_model *model = checked(kg_model_create());
    model->reference.file = checked(strdup("none/mesh.obj"));
    kg_document *d = document_of(model, "/tmp/model.katagami");
    kg_mesh *mesh = NULL;
    kg_error error;
    assert_int_equal(kg_document_reference(d, NULL, &mesh, &error), KG_ERR_IO);
    assert_non_null(strstr(error.message, "/tmp/none/mesh.obj"));
    kg_document_destroy(d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_surface_has_a_group_for_every_part_patch),
        cmocka_unit_test(a_faulty_model_has_no_mesh_and_no_net),
        cmocka_unit_test(references_are_turned_scaled_and_moved),
        cmocka_unit_test(a_missing_reference_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
