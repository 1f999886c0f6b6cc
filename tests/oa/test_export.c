#include "base/json.h"
#include "reference.h"

#include "base/file.h"

#include <stdlib.h>
#include <unistd.h>

/* A card written with its motion and what the file's text says. */
static json_t *written(const kg_oa *oa, double open, kg_mesh **out_read) {
    char path[] = "/tmp/katagami-oa-XXXXXX.gltf", *text;
    size_t size;
    kg_oa_sheet *sheet;
    kg_mesh *mesh;
    kg_mesh_motion *motion;
    int fd = mkstemps(path, 5);
    assert_true(fd >= 0);
    close(fd);
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_motion(oa, sheet, NULL, open, &mesh, &motion, NULL), KG_OK);
    assert_int_equal(kg_mesh_write_moving(path, mesh, motion, NULL), KG_OK);
    assert_int_equal(kg_mesh_write_moving("card.obj", mesh, motion, NULL), KG_ERR_INPUT);
    assert_int_equal(kg_mesh_read(path, out_read, NULL), KG_OK);
    assert_int_equal((*out_read)->vertex_count, mesh->vertex_count);
    assert_int_equal(kg_file_read(path, &text, &size, NULL), KG_OK);
    json_t *root = json_loads(text, 0, NULL);
    free(text);
    unlink(path);
    kg_mesh_destroy(mesh);
    kg_mesh_motion_destroy(motion);
    kg_oa_sheet_destroy(sheet);
    return root;
}

static json_t *accessor(json_t *root, json_t *index) {
    return json_array_get(json_object_get(root, "accessors"), (size_t)json_integer_value(index));
}

static json_int_t count_of(json_t *a) {
    return json_integer_value(json_object_get(a, "count"));
}

static void gltf_folds_up_by_morph_targets(void **state) {
    (void)state;
    for (int diagonals = 0; diagonals < 2; diagonals++) {
        kg_oa *oa;
        kg_mesh *read;
        assert_int_equal(kg_oa_create(6, 4, 4, 2, &oa, NULL), KG_OK);
        for (int k = 1; k <= 3; k++)
            kg_oa_add(oa, k, k - 1, k - 1);
        oa->diagonals = diagonals;
        json_t *root = written(oa, KG_PI / 2, &read);
        kg_box3 box = kg_mesh_bounds(read);
        assert_near(box.hi.z, 8, 1e-6); /* without its animation the card stands */
        assert_near(box.lo.y, -8, 1e-6);
        json_t *primitive = json_array_get(
            json_object_get(json_array_get(json_object_get(root, "meshes"), 0), "primitives"), 0);
        size_t targets = json_array_size(json_object_get(primitive, "targets"));
        assert_int_equal(targets, diagonals ? 5 : 2);
        json_t *animation = json_array_get(json_object_get(root, "animations"), 0);
        json_t *sampler = json_array_get(json_object_get(animation, "samplers"), 0);
        json_int_t keys = count_of(accessor(root, json_object_get(sampler, "input")));
        assert_true(keys > 100);
        assert_int_equal(count_of(accessor(root, json_object_get(sampler, "output"))),
                         keys * (json_int_t)targets);
        json_t *target =
            json_object_get(json_array_get(json_object_get(animation, "channels"), 0), "target");
        assert_string_equal(json_string_value(json_object_get(target, "path")), "weights");
        json_decref(root);
        kg_mesh_destroy(read);
        kg_oa_destroy(oa);
    }
}

static void loose_patches_are_a_group_of_their_own(void **state) {
    (void)state;
    kg_oa *oa;
    kg_oa_sheet *sheet;
    kg_oa_stability *stability;
    kg_mesh *mesh;
    assert_int_equal(kg_oa_create(3, 5, 5, 1, &oa, NULL), KG_OK);
    kg_oa_add(oa, 1, 0, 3);
    kg_oa_add(oa, 1, 2, 1);
    assert_int_equal(kg_oa_sheet_create(oa, &sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(sheet, &stability, NULL), KG_OK);
    assert_int_equal(kg_oa_pose(oa, sheet, stability, 1, &mesh, NULL), KG_OK);
    assert_int_equal(mesh->group_count, 2);
    assert_string_equal(mesh->groups[1].name, "loose");
    assert_int_equal(mesh->groups[1].face_count, 7); /* 1 + 2 + 2 + 2 cells */
    assert_int_equal(mesh->groups[0].face_count + 7, 30);
    kg_mesh_destroy(mesh);
    kg_oa_stability_destroy(stability);
    kg_oa_sheet_destroy(sheet);
    kg_oa_destroy(oa);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gltf_folds_up_by_morph_targets),
        cmocka_unit_test(loose_patches_are_a_group_of_their_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
