/* glTF files that other programs write: base64 buffers, node trees, strips, sparse accessors. */
#include "tests/mesh/samples.h"

#include <stdlib.h>
#include <unistd.h>

/* A buffer of 76 bytes: the floats 0 0 0, 1 0 0, 0 1 0, 1 1 0 (48 bytes), the same shifted to
 * z = 5 for the last one only (12 bytes: 1 1 5), unsigned shorts 0 1 2 2 1 3 (12 bytes), a short 3
 * (2 bytes) and padding. */
#define BUFFER                                                                                     \
    "data:application/octet-stream;base64,"                                                        \
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAA"                             \
    "AACAPwAAgD8AAKBAAAABAAIAAgABAAMAAwAAAA=="

#define BUFFERS                                                                                    \
    "\"asset\":{\"version\":\"2.0\"},"                                                             \
    "\"buffers\":[{\"byteLength\":76,\"uri\":\"" BUFFER "\"}],"                                    \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},"                                           \
    "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12},"                                          \
    "{\"buffer\":0,\"byteOffset\":60,\"byteLength\":12},"                                          \
    "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":2}],"

#define POINTS "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}"
#define INDICES "{\"bufferView\":2,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}"
#define ACCESSORS "\"accessors\":[" POINTS "," INDICES "],"

static kg_mesh *load(const char *json) {
    kg_error error;
    kg_mesh *mesh = kg_sample_read(json, strlen(json), KG_MESH_GLTF, &error);
    if (!mesh)
        fail_msg("%s", error.message);
    return mesh;
}

static void refuse(const char *json, const char *words) {
    kg_error error;
    assert_null(kg_sample_read(json, strlen(json), KG_MESH_GLTF, &error));
    if (!strstr(error.message, words))
        fail_msg("\"%s\" does not say \"%s\"", error.message, words);
}

static void assert_at(kg_vec3 p, double x, double y, double z) {
    assert_near(kg_dist(p, kg_v3(x, y, z)), 0, 1e-12);
}

static void base64_buffers_load_and_y_up_becomes_z_up(void **state) {
    (void)state;
    kg_mesh *mesh = load("{" BUFFERS ACCESSORS
                         "\"meshes\":[{\"name\":\"m\",\"primitives\":[{\"attributes\":{\"POSITION\""
                         ":0},\"indices\":1}]}],\"nodes\":[{\"mesh\":0}],"
                         "\"scenes\":[{\"nodes\":[0]}]}");
    assert_int_equal(mesh->vertex_count, 4);
    assert_int_equal(mesh->face_count, 2);
    assert_int_equal(mesh->face_corners[5], 3);
    assert_at(mesh->positions[2], 0, 0, 1);
    assert_int_equal(mesh->group_count, 1);
    assert_string_equal(mesh->groups[0].name, "m");
    kg_mesh_destroy(mesh);
}

static void node_transforms_of_all_scenes_are_applied(void **state) {
    (void)state;
    /* A child turned by 90° about z, scaled by 2, under a parent moved by (10,0,0); and in another
     * scene a mirrored node. */
    kg_mesh *mesh =
        load("{" BUFFERS ACCESSORS
             "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0.5,1]}}],"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,"
             "\"material\":0}]}],"
             "\"nodes\":[{\"children\":[1],\"translation\":[10,0,0]},"
             "{\"name\":\"turned\",\"mesh\":0,\"rotation\":[0,0,0.7071067811865476,"
             "0.7071067811865476],\"scale\":[2,2,2]},"
             "{\"name\":\"mirrored\",\"mesh\":0,\"matrix\":[-1,0,0,0,0,1,0,0,0,0,1,0,0,7,0,1]}],"
             "\"scenes\":[{\"nodes\":[0]},{\"nodes\":[2]}]}");
    assert_int_equal(mesh->vertex_count, 8);
    assert_at(mesh->positions[1], 10, 0, 2); /* x -> y of glTF = z here */
    assert_at(mesh->positions[2], 8, 0, 0);
    assert_at(mesh->positions[5], -1, 0, 7);
    assert_string_equal(mesh->groups[0].name, "turned");
    assert_string_equal(mesh->groups[1].name, "mirrored");
    assert_near(mesh->groups[0].color[2], 0.5, 1e-7);
    /* Both show their front to glTF's +z, our -y. */
    for (size_t f = 0; f < 4; f++) {
        const uint32_t *c = mesh->face_corners + 3 * f;
        kg_vec3 n = kg_cross(kg_sub(mesh->positions[c[1]], mesh->positions[c[0]]),
                             kg_sub(mesh->positions[c[2]], mesh->positions[c[0]]));
        assert_true(n.y < 0);
    }
    kg_mesh_destroy(mesh);
}

static void strips_fans_and_unindexed_triangles_load(void **state) {
    (void)state;
    kg_mesh *mesh = load("{" BUFFERS ACCESSORS "\"meshes\":[{\"primitives\":["
                         "{\"attributes\":{\"POSITION\":0},\"mode\":5},"
                         "{\"attributes\":{\"POSITION\":0},\"mode\":6},"
                         "{\"attributes\":{\"POSITION\":0},\"mode\":4},"
                         "{\"attributes\":{\"POSITION\":0},\"mode\":1}]}],"
                         "\"nodes\":[{\"mesh\":0}]}");
    const uint32_t want[] = {0, 1, 2, 1, 3, 2, 4, 5, 6, 4, 6, 7, 8, 9, 10};
    assert_int_equal(mesh->face_count, 5);
    assert_memory_equal(mesh->face_corners, want, sizeof want);
    kg_mesh_destroy(mesh);
}

static void sparse_accessors_change_their_items(void **state) {
    (void)state;
    kg_mesh *mesh = load(
        "{" BUFFERS
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\","
        "\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":3,\"componentType\":5123},"
        "\"values\":{\"bufferView\":1}}}," INDICES "],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}]}");
    assert_at(mesh->positions[3], 1, -5, 1);
    assert_at(mesh->positions[1], 1, 0, 0);
    kg_mesh_destroy(mesh);
}

static void a_node_that_is_its_own_parent_ends(void **state) {
    (void)state;
    kg_mesh *mesh = load("{" BUFFERS ACCESSORS
                         "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                         "\"nodes\":[{\"mesh\":0,\"children\":[1]},{\"children\":[0,1]}],"
                         "\"scenes\":[{\"nodes\":[0]}]}");
    assert_int_equal(mesh->face_count, 1);
    kg_mesh_destroy(mesh);
}

#define ONE_MESH "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}]}"

static void references_and_ranges_that_lie_are_refused(void **state) {
    (void)state;
    refuse("", "sample: ");
    refuse("{", "sample: ");
    refuse("[]", "sample: ");
    refuse("{\"asset\":{\"version\":\"2.0\"}}", "no faces");
    refuse("{" BUFFERS "\"accessors\":[" POINTS "]," ONE_MESH, "accessor out of bounds");
    refuse("{" BUFFERS "\"accessors\":[{\"bufferView\":9,\"componentType\":5126,\"count\":4,"
           "\"type\":\"VEC3\"}," INDICES "]," ONE_MESH,
           "");
    refuse("{" BUFFERS "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":5,"
           "\"type\":\"VEC3\"}," INDICES "]," ONE_MESH,
           "ends behind its bufferView");
    refuse("{" BUFFERS "\"accessors\":[{\"componentType\":5126,\"count\":4000000000,"
           "\"type\":\"VEC3\"}," INDICES "]," ONE_MESH,
           "too many items");
    refuse("{" BUFFERS "\"accessors\":[{\"bufferView\":1,\"componentType\":5126,\"count\":1,"
           "\"type\":\"VEC3\"}," INDICES "]," ONE_MESH,
           "vertex that does not exist");
    refuse("{" BUFFERS "\"accessors\":[" INDICES "," INDICES "]," ONE_MESH, "another type");
    refuse("{" BUFFERS ACCESSORS "\"nodes\":[{\"mesh\":4}]," ONE_MESH, "mesh that does not exist");
}

static void deep_nesting_is_refused_and_not_walked(void **state) {
    (void)state;
    size_t depth = 200000;
    char *json = malloc(2 * depth + 64);
    int n = sprintf(json, "{\"extras\":");
    memset(json + n, '[', depth);
    memset(json + n + depth, ']', depth);
    memcpy(json + n + 2 * depth, "}", 2);
    refuse(json, "nests too deeply");
    free(json);
}

static void buffers_beside_the_file_are_found_there_only(void **state) {
    (void)state;
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":48,\"uri\":\"b.bin\"}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48}],\"accessors\":[" POINTS "],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]}";
    const float points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    char folder[] = "/tmp/katagami-gltf-XXXXXX", path[64], bin[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.gltf", folder);
    snprintf(bin, sizeof bin, "%s/b.bin", folder);
    FILE *f = fopen(path, "wb");
    fwrite(json, 1, sizeof json - 1, f);
    fclose(f);
    kg_mesh *mesh = NULL;
    kg_error error;
    assert_int_equal(kg_mesh_read(path, &mesh, &error), KG_ERR_PARSE);
    assert_non_null(strstr(error.message, "b.bin"));
    f = fopen(bin, "wb");
    fwrite(points, 1, sizeof points, f);
    fclose(f);
    assert_int_equal(kg_mesh_read(path, &mesh, &error), KG_OK);
    assert_int_equal(mesh->vertex_count, 4);
    kg_mesh_destroy(mesh);
    refuse(json, "b.bin"); /* from memory there is no folder to look in */
    unlink(path);
    unlink(bin);
    rmdir(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(base64_buffers_load_and_y_up_becomes_z_up),
        cmocka_unit_test(node_transforms_of_all_scenes_are_applied),
        cmocka_unit_test(strips_fans_and_unindexed_triangles_load),
        cmocka_unit_test(sparse_accessors_change_their_items),
        cmocka_unit_test(a_node_that_is_its_own_parent_ends),
        cmocka_unit_test(references_and_ranges_that_lie_are_refused),
        cmocka_unit_test(deep_nesting_is_refused_and_not_walked),
        cmocka_unit_test(buffers_beside_the_file_are_found_there_only),
    };
    return cmocka_run_group_tests_name("glTF", tests, NULL, NULL);
}
