/* Every format read and written, and the ugly files that people have. */
#include "tests/mesh/samples.h"

#include <locale.h>
#include <stdlib.h>
#include <unistd.h>

static const kg_mesh_format all_formats[] = {KG_MESH_OBJ, KG_MESH_PLY,  KG_MESH_STL,
                                             KG_MESH_OFF, KG_MESH_GLTF, KG_MESH_GLB};
static const char *const extensions[] = {"obj", "ply", "stl", "off", "gltf", "glb"};

static kg_mesh *read_text(const char *text, kg_mesh_format format) {
    kg_error error;
    kg_mesh *mesh = kg_sample_read(text, strlen(text), format, &error);
    if (!mesh)
        fail_msg("%s", error.message);
    return mesh;
}

static void refuse_text(const char *text, kg_mesh_format format, const char *words) {
    kg_error error;
    kg_mesh *mesh = kg_sample_read(text, strlen(text), format, &error);
    assert_null(mesh);
    if (!strstr(error.message, words))
        fail_msg("\"%s\" does not say \"%s\"", error.message, words);
}

static kg_mesh *round_trip(const kg_mesh *mesh, kg_mesh_format format) {
    char *data;
    size_t size;
    kg_error error = {0};
    if (kg_mesh_write_memory(mesh, format, &data, &size, &error))
        fail_msg("%s", error.message);
    kg_mesh *again = kg_sample_read(data, size, format, &error);
    free(data);
    if (!again)
        fail_msg("%s: %s", extensions[format], error.message);
    return again;
}

/* The same points in the same order of faces and corners, whatever the numbering. */
static void assert_same_faces(const kg_mesh *a, const kg_mesh *b, double tolerance) {
    assert_int_equal(a->face_count, b->face_count);
    for (size_t f = 0; f <= a->face_count; f++)
        assert_int_equal(a->face_starts[f], b->face_starts[f]);
    for (size_t c = 0; c < a->face_starts[a->face_count]; c++)
        assert_near(kg_dist(a->positions[a->face_corners[c]], b->positions[b->face_corners[c]]), 0,
                    tolerance);
}

/* The faces of `mesh` as kg_mesh_triangulate cuts them. */
static kg_mesh *triangulated(const kg_mesh *mesh) {
    size_t n = kg_mesh_triangle_count(mesh);
    uint32_t *corners = malloc(3 * n * sizeof *corners), *sizes = malloc(n * sizeof *sizes);
    assert_int_equal(kg_mesh_triangulate(mesh, corners, NULL, NULL), KG_OK);
    for (size_t i = 0; i < n; i++)
        sizes[i] = 3;
    kg_mesh *made = kg_sample_mesh(mesh->positions, mesh->vertex_count, corners, sizes, n);
    free(corners);
    free(sizes);
    return made;
}

static void assert_round_trips(const kg_mesh *mesh, double tolerance) {
    kg_mesh *triangles = triangulated(mesh);
    for (size_t i = 0; i < 6; i++) {
        kg_mesh_format format = all_formats[i];
        kg_mesh *again = round_trip(mesh, format);
        bool cuts = format == KG_MESH_STL || format == KG_MESH_GLTF || format == KG_MESH_GLB;
        assert_same_faces(cuts ? triangles : mesh, again, tolerance);
        kg_mesh_destroy(again);
    }
    kg_mesh_destroy(triangles);
}

static void every_format_brings_back_what_it_wrote(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    assert_round_trips(cube, 0);
    kg_random random = {7};
    for (size_t v = 0; v < cube->vertex_count; v++) {
        cube->positions[v].x += kg_random_in(&random, -0.5, 0.5);
        cube->positions[v].z *= kg_random_in(&random, 1, 1e4);
    }
    assert_round_trips(cube, 1e4 * 1.2e-7);
    kg_mesh_destroy(cube);
}

static void normals_survive_where_the_format_has_them(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    assert_int_equal(kg_mesh_normals(cube, NULL), KG_OK);
    const kg_mesh_format with[] = {KG_MESH_OBJ, KG_MESH_PLY, KG_MESH_GLTF, KG_MESH_GLB};
    for (size_t i = 0; i < 4; i++) {
        kg_mesh *again = round_trip(cube, with[i]);
        assert_non_null(again->normals);
        for (size_t v = 0; v < again->vertex_count; v++)
            assert_near(kg_dist(again->normals[v], kg_unit(again->positions[v])), 0, 1e-6);
        kg_mesh_destroy(again);
    }
    kg_mesh_destroy(cube);
}

static void groups_keep_names_order_and_color(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    const kg_mesh_format with[] = {KG_MESH_OBJ, KG_MESH_GLTF, KG_MESH_GLB};
    for (size_t i = 0; i < 3; i++) {
        kg_mesh *again = round_trip(cube, with[i]);
        assert_int_equal(again->group_count, 3);
        assert_string_equal(again->groups[0].name, "floor");
        assert_string_equal(again->groups[1].name, "屋根");
        assert_string_equal(again->groups[2].name, "walls");
        size_t triangles_per_face = with[i] == KG_MESH_OBJ ? 1 : 2;
        assert_int_equal(again->groups[2].first_face, 2 * triangles_per_face);
        assert_int_equal(again->groups[2].face_count, 4 * triangles_per_face);
        if (with[i] != KG_MESH_OBJ)
            assert_near(again->groups[1].color[1], 0.25, 1e-6);
        kg_mesh_destroy(again);
    }
    kg_mesh_destroy(cube);
}

static void names_with_spaces_and_line_ends_break_no_file(void **state) {
    (void)state;
    static const char *const names[] = {"two words", "line\nv 1 2 3", "", "a\\", "#5 \"x\"\t\r"};
    for (size_t n = 0; n < 5; n++) {
        kg_mesh *cube = kg_sample_cube();
        kg_sample_group(cube, names[n], 6, 0);
        cube->groups[3].first_face = 4;
        cube->groups[2].face_count = 2;
        cube->groups[3].face_count = 1; /* and the last face is in no group */
        for (size_t i = 0; i < 6; i++) {
            kg_mesh *again = round_trip(cube, all_formats[i]);
            bool grouped = all_formats[i] == KG_MESH_OBJ || all_formats[i] >= KG_MESH_GLTF;
            assert_int_equal(again->group_count, grouped ? 5 : 0);
            if (all_formats[i] >= KG_MESH_GLTF && *names[n])
                assert_string_equal(again->groups[3].name, names[n]);
            if (grouped)
                assert_string_equal(again->groups[4].name, "default");
            kg_mesh_destroy(again);
        }
        kg_mesh_destroy(cube);
    }
}

static void obj_lists_one_g_line_per_group_and_no_o_line(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    char *data;
    size_t size;
    assert_int_equal(kg_mesh_write_memory(cube, KG_MESH_OBJ, &data, &size, NULL), KG_OK);
    size_t g = 0, o = 0;
    for (size_t i = 0; i + 1 < size; i++) {
        if (i == 0 || data[i - 1] == '\n') {
            g += data[i] == 'g' && data[i + 1] == ' ';
            o += data[i] == 'o';
        }
    }
    assert_int_equal(g, 3);
    assert_int_equal(o, 0);
    free(data);
    kg_mesh_destroy(cube);
}

static void numbers_are_written_with_points_whatever_the_locale(void **state) {
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8"))
        skip(); /* no such locale on this machine */
    kg_mesh *cube = kg_sample_cube();
    cube->positions[0].x = -1.5;
    kg_mesh *again = round_trip(cube, KG_MESH_OBJ);
    setlocale(LC_ALL, "C");
    assert_near(again->positions[0].x, -1.5, 0);
    kg_mesh_destroy(again);
    kg_mesh_destroy(cube);
}

/* ---- ugly OBJ -------------------------------------------------------------------------- */

#define QUAD "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

static void obj_negative_indices_count_from_the_last_vertex(void **state) {
    (void)state;
    kg_mesh *mesh = read_text(QUAD "f -4 -3 -2 -1\nv 5 5 5\nf -2 -1 1\n", KG_MESH_OBJ);
    const uint32_t want[] = {0, 1, 2, 3, 3, 4, 0};
    assert_int_equal(mesh->face_count, 2);
    assert_memory_equal(mesh->face_corners, want, sizeof want);
    kg_mesh_destroy(mesh);
}

static void obj_with_everything_in_it_loads(void **state) {
    (void)state;
    kg_mesh *mesh = read_text("# made by hand\r\n\r\nmtllib no such file.mtl\r\no thing\r\n"
                              "v 0 0 0 1 0.5 0\r\n\tv 1 0 0 1 0 0\r\nv 1 1 0\r\nv 0 1 0 1\r\n"
                              "vt 0 0\r\nvt 1 1 0\r\nvn 0 0 1\r\ns off\r\nusemtl red\r\n"
                              "g front side\r\nf 1/1 2/2/ 3//1 \\\r\n  4/1/1 # quad\r\n"
                              "l 1 2\r\np 1\r\ng\r\nf 1 3 4",
                              KG_MESH_OBJ);
    const uint32_t want[] = {0, 1, 2, 3, 0, 2, 3};
    assert_int_equal(mesh->vertex_count, 4);
    assert_int_equal(mesh->face_count, 2);
    assert_memory_equal(mesh->face_corners, want, sizeof want);
    assert_null(mesh->normals); /* not every corner has one */
    assert_int_equal(mesh->group_count, 2);
    assert_string_equal(mesh->groups[0].name, "front side");
    assert_string_equal(mesh->groups[1].name, "default");
    kg_mesh_destroy(mesh);
}

static void obj_faces_may_stand_before_their_vertices(void **state) {
    (void)state;
    kg_mesh *mesh = read_text("f 1 2 3\n" QUAD, KG_MESH_OBJ);
    assert_int_equal(mesh->face_count, 1);
    kg_mesh_destroy(mesh);
}

static void obj_normals_that_differ_within_a_vertex_are_dropped(void **state) {
    (void)state;
    kg_mesh *mesh =
        read_text(QUAD "vn 0 0 2\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n", KG_MESH_OBJ);
    assert_non_null(mesh->normals);
    assert_near(mesh->normals[3].z, 1, 0);
    kg_mesh_destroy(mesh);
    mesh = read_text(QUAD "vn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n", KG_MESH_OBJ);
    assert_null(mesh->normals);
    kg_mesh_destroy(mesh);
}

static void bad_obj_lines_are_named(void **state) {
    (void)state;
    refuse_text(QUAD "f 1 2 9\n", KG_MESH_OBJ, "sample:5: the face names a vertex");
    refuse_text(QUAD "f 1 2 -9\n", KG_MESH_OBJ, "sample:5: the face names a vertex");
    refuse_text(QUAD "f 0 1 2\n", KG_MESH_OBJ, "sample:5: \"0\" is not a corner");
    refuse_text(QUAD "f 1 x 2\n", KG_MESH_OBJ, "sample:5: \"x\" is not a corner");
    refuse_text(QUAD "f 99999999999999999999 1 2\n", KG_MESH_OBJ, "sample:5: ");
    refuse_text("v 0 0\n", KG_MESH_OBJ, "sample:1: a vertex needs three numbers");
    refuse_text("\nv 0 0 nan\n", KG_MESH_OBJ, "sample:2: a coordinate of vertex 1 is not a finite");
    refuse_text("v 0 0 1e999\n", KG_MESH_OBJ, "not a finite");
    refuse_text(QUAD, KG_MESH_OBJ, "no faces");
    refuse_text("", KG_MESH_OBJ, "no faces");
    refuse_text(QUAD "f\n", KG_MESH_OBJ, "three different corners");
    refuse_text(QUAD "f 1 2\nf 1 2 2\n", KG_MESH_OBJ, "three different corners");
}

static void unusable_faces_are_skipped_and_counted(void **state) {
    (void)state;
    const char *text = QUAD "g a\nf 1 2\nf 1 1 2\ng b\nf 1 2 3 1\nf\nf 1 2 3\ng c\nf 4 4 4 4\n";
    kg_mesh *mesh;
    assert_int_equal(kg_mesh_read_memory(text, strlen(text), KG_MESH_OBJ, "x", &mesh, NULL), KG_OK);
    assert_int_equal(mesh->face_count, 1);
    assert_int_equal(mesh->skipped_faces, 5);
    char said[200];
    assert_true(kg_mesh_say_skipped(mesh, "x.obj", said, sizeof said));
    assert_memory_equal(said, "x.obj: faces that were skipped: 5; ", 35);
    mesh->skipped_faces = 0;
    assert_false(kg_mesh_say_skipped(mesh, "x.obj", said, sizeof said));
    assert_string_equal(said, "");
    assert_int_equal(mesh->group_count, 1);
    assert_string_equal(mesh->groups[0].name, "b");
    kg_mesh_destroy(mesh);
}

/* ---- shapes that half-edges cannot hold -------------------------------------------------- */

static void assert_survives(const char *obj, size_t vertices, size_t faces) {
    kg_mesh *mesh = read_text(obj, KG_MESH_OBJ);
    assert_int_equal(mesh->vertex_count, vertices);
    assert_int_equal(mesh->face_count, faces);
    assert_round_trips(mesh, 0);
    kg_mesh_destroy(mesh);
}

static void an_edge_with_three_faces_loads(void **state) {
    (void)state;
    assert_survives("v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n", 5,
                    3);
}

static void two_components_load(void **state) {
    (void)state;
    assert_survives(QUAD "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3 4\nf 5 6 7\n", 7, 2);
}

static void a_bow_tie_vertex_loads(void **state) {
    (void)state;
    assert_survives("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n", 5, 2);
}

static void faces_turned_against_each_other_load(void **state) {
    (void)state;
    assert_survives(QUAD "f 1 2 3\nf 1 3 4\nf 3 2 1\nf 1 2 3 4\n", 4, 4);
}

static void a_concave_polygon_loads(void **state) {
    (void)state;
    assert_survives("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n", 5, 1);
}

/* ---- PLY, STL, OFF ---------------------------------------------------------------------- */

static void ply_text_with_lists_colors_and_strange_elements_loads(void **state) {
    (void)state;
    kg_mesh *mesh = read_text("ply\r\nformat ascii 1.0\r\ncomment a b\r\nobj_info c\r\n"
                              "element material 1\r\nproperty list uchar float weights\r\n"
                              "element vertex 4\r\nproperty uchar red\r\nproperty double x\r\n"
                              "property double z\r\nproperty double y\r\n"
                              "element nothing 1000000000000\r\n"
                              "element face 2\r\nproperty list uchar float uv\r\n"
                              "property list ushort uint vertex_index\r\nproperty int flags\r\n"
                              "end_header\r\n3 .1 .2 .3\r\n255 0 5 0\r\n0 1 5 0\r\n0 1 5 1\r\n"
                              "0 0.123456789012 5 1\r\n0 4 0 1 2 3 7\r\n2 .5 .5 3 0 1 2 8\r\n",
                              KG_MESH_PLY);
    assert_int_equal(mesh->vertex_count, 4);
    assert_int_equal(mesh->face_count, 2);
    assert_near(mesh->positions[3].x, 0.123456789012, 0);
    assert_near(mesh->positions[3].y, 1, 0);
    assert_near(mesh->positions[3].z, 5, 0);
    kg_mesh_destroy(mesh);
}

static void ply_of_both_byte_orders_loads(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    char *data;
    size_t size;
    assert_int_equal(kg_mesh_write_memory(cube, KG_MESH_PLY, &data, &size, NULL), KG_OK);
    static const char little[] = "format binary_little_endian", end[] = "end_header\n";
    char *at = strstr(data, little), *body = strstr(data, end) + strlen(end);
    assert_non_null(at);
    /* The same file of the other byte order: "   big" keeps the length of "little". */
    memcpy(at, "format    binary_big_endian", strlen(little));
    char *q = body;
    for (size_t i = 0; i < 3 * 8; i++, q += 4) {
        char swapped[4] = {q[3], q[2], q[1], q[0]};
        memcpy(q, swapped, 4);
    }
    for (size_t f = 0; f < 6; f++) {
        q++;
        for (size_t i = 0; i < 4; i++, q += 4) {
            char swapped[4] = {q[3], q[2], q[1], q[0]};
            memcpy(q, swapped, 4);
        }
    }
    assert_true(q == data + size);
    kg_error error;
    kg_mesh *mesh = kg_sample_read(data, size, KG_MESH_PLY, &error);
    assert_non_null(mesh);
    assert_same_faces(cube, mesh, 0);
    kg_mesh_destroy(mesh);
    kg_mesh_destroy(cube);
    free(data);
}

static void ply_faces_of_300_corners_are_written(void **state) {
    (void)state;
    kg_vec3 p[300];
    uint32_t corners[300];
    const uint32_t size = 300;
    for (uint32_t i = 0; i < 300; i++) {
        p[i] = kg_v3(cos(i * 0.0209), sin(i * 0.0209), 0);
        corners[i] = i;
    }
    kg_mesh *mesh = kg_sample_mesh(p, 300, corners, &size, 1);
    assert_round_trips(mesh, 1e-7);
    kg_mesh_destroy(mesh);
}

static void lying_ply_headers_are_refused(void **state) {
    (void)state;
#define PLY "ply\nformat ascii 1.0\n"
#define XYZ "property float x\nproperty float y\nproperty float z\n"
    refuse_text("plx\n", KG_MESH_PLY, "sample:1: not a PLY file");
    refuse_text(PLY "element vertex 3\nproperty float x\nend_header\n", KG_MESH_PLY, "lack x, y");
    refuse_text(PLY "element vertex 999999999\n" XYZ "end_header\n0 0 0\n", KG_MESH_PLY,
                "the file ends");
    refuse_text(PLY "element vertex 3\nproperty foo x\n", KG_MESH_PLY, "sample:4: not a property");
    refuse_text(PLY "element vertex 3\n" XYZ "element face 1\nproperty list uchar int "
                    "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
                KG_MESH_PLY, "sample:13: the face names a vertex");
    refuse_text(PLY "element vertex 1\n" XYZ "end_header\n0 0 inf\n", KG_MESH_PLY,
                "sample:8: a coordinate of vertex 1");
    refuse_text("ply\nformat ebcdic 1.0\n", KG_MESH_PLY, "sample:2: unknown format");
}

static void stl_text_welds_equal_corners(void **state) {
    (void)state;
    kg_mesh *mesh = read_text("solid a b\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n"
                              "  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n"
                              "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 1 0 -0\nVERTEX 1 1 0\n"
                              "VERTEX 0 1 0\nENDLOOP\nENDFACET\nendsolid\n",
                              KG_MESH_STL);
    assert_int_equal(mesh->vertex_count, 4);
    assert_int_equal(mesh->face_count, 2);
    kg_mesh_destroy(mesh);
    refuse_text("solid\nouter loop\nvertex 0 0 0\nvertex 0 1\n", KG_MESH_STL,
                "sample:4: a vertex needs three numbers");
    refuse_text("solid\nouter loop\nvertex 0 0 0\n", KG_MESH_STL, "ends within a triangle");
    refuse_text("solid\nouter loop\nvertex 0 0 0\nendloop\n", KG_MESH_STL, "sample:4: a loop");
    refuse_text("solid\nendsolid\n", KG_MESH_STL, "no faces");
}

static void binary_stl_that_starts_with_solid_loads(void **state) {
    (void)state;
    kg_mesh *cube = kg_sample_cube();
    char *data;
    size_t size;
    assert_int_equal(kg_mesh_write_memory(cube, KG_MESH_STL, &data, &size, NULL), KG_OK);
    memcpy(data, "solid cube", 10);
    kg_error error;
    kg_mesh *mesh = kg_sample_read(data, size, KG_MESH_STL, &error);
    assert_non_null(mesh);
    assert_int_equal(mesh->face_count, 12);
    assert_int_equal(mesh->vertex_count, 8);
    kg_mesh_destroy(mesh);
    memcpy(data, "binary cub", 10);
    memset(data + 80, 0xff, 4);
    assert_null(kg_sample_read(data, size, KG_MESH_STL, &error));
    assert_non_null(strstr(error.message, "counts 4294967295 triangles and there is room for 12"));
    kg_mesh_destroy(cube);
    free(data);
}

static void off_variants_load(void **state) {
    (void)state;
    kg_mesh *mesh = read_text("# c\n\nOFF # c\n# c\n4 1 4\n\n0 0 0\n1 0 0 # c\n1 1 0\n0 1 0\n"
                              "4 0 1 2 3 255 0 0\n",
                              KG_MESH_OFF);
    assert_int_equal(mesh->face_count, 1);
    assert_int_equal(mesh->face_starts[1], 4);
    kg_mesh_destroy(mesh);
    mesh = read_text("CNOFF 3 1 0\n0 0 0 0 0 2 .5 .5 .5 1\n1 0 0 0 0 2\n1 1 0 0 0 2\n3 0 1 2\n",
                     KG_MESH_OFF);
    assert_non_null(mesh->normals);
    assert_near(mesh->normals[0].z, 1, 0);
    kg_mesh_destroy(mesh);
    refuse_text("OFF BINARY\n", KG_MESH_OFF, "binary OFF is not supported");
    refuse_text("OFF\n3 1 0\n0 0 0\n0 1 0\n", KG_MESH_OFF, "the file ends");
    refuse_text("OFF\n3 1 0\n0 0 0\n0 1 0\n1 1 1\n3 0 1 3\n", KG_MESH_OFF,
                "sample:6: the face names a vertex");
    refuse_text("OFF\n3 1 0\n0 0 0\n0 1 0\n1 1 1\n900000000 0 1 2\n", KG_MESH_OFF,
                "sample:6: the face has fewer");
    refuse_text("OFF\n-3 1 0\n", KG_MESH_OFF, "not an OFF file");
}

/* ---- names of files ---------------------------------------------------------------------- */

static void the_extension_names_the_format_in_any_case(void **state) {
    (void)state;
    kg_mesh_format format;
    kg_error error;
    assert_int_equal(kg_mesh_format_of("a.b/c.OBJ", &format, NULL), KG_OK);
    assert_int_equal(format, KG_MESH_OBJ);
    assert_int_equal(kg_mesh_format_of("x.GlTf", &format, NULL), KG_OK);
    assert_int_equal(format, KG_MESH_GLTF);
    assert_int_equal(kg_mesh_format_of("x.ob", &format, &error), KG_ERR_INPUT);
    assert_int_equal(kg_mesh_format_of("x.objx", &format, &error), KG_ERR_INPUT);
    assert_int_equal(kg_mesh_format_of("obj", &format, &error), KG_ERR_INPUT);
    assert_non_null(strstr(error.message, "obj: not a mesh file by its name"));
}

static void files_are_written_whole_and_read_back(void **state) {
    (void)state;
    char folder[] = "/tmp/katagami-mesh-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    kg_mesh *cube = kg_sample_cube(), *again;
    kg_error error;
    for (size_t i = 0; i < 6; i++) {
        snprintf(path, sizeof path, "%s/cube.%s", folder, extensions[i]);
        assert_int_equal(kg_mesh_write(path, cube, &error), KG_OK);
        assert_int_equal(kg_mesh_read(path, &again, &error), KG_OK);
        assert_int_equal(kg_mesh_triangle_count(again), 12);
        kg_mesh_destroy(again);
        assert_int_equal(unlink(path), 0);
    }
    assert_int_equal(rmdir(folder), 0); /* nothing else was left behind */
    snprintf(path, sizeof path, "%s/none.obj", folder);
    assert_int_equal(kg_mesh_read(path, &again, &error), KG_ERR_IO);
    assert_int_equal(kg_mesh_write(path, cube, &error), KG_ERR_IO);
    kg_mesh_destroy(cube);
}

static void meshes_that_no_file_can_hold_are_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < 6; i++) {
        char *data = NULL;
        size_t size;
        kg_error error;
        kg_mesh *cube = kg_sample_cube();
        cube->positions[3].y = 1e39;
        assert_int_equal(kg_mesh_write_memory(cube, all_formats[i], &data, &size, &error),
                         KG_ERR_INPUT);
        cube->positions[3].y = NAN;
        assert_int_equal(kg_mesh_write_memory(cube, all_formats[i], &data, &size, &error),
                         KG_ERR_INPUT);
        cube->positions[3].y = 1;
        cube->face_corners[5] = 8;
        assert_int_equal(kg_mesh_write_memory(cube, all_formats[i], &data, &size, &error),
                         KG_ERR_INPUT);
        kg_mesh_destroy(cube);
        kg_mesh *empty = kg_mesh_create();
        assert_int_equal(kg_mesh_write_memory(empty, all_formats[i], &data, &size, &error),
                         KG_ERR_INPUT);
        assert_non_null(strstr(error.message, "no faces"));
        kg_mesh_destroy(empty);
        assert_null(data);
    }
}

/* ---- real meshes ------------------------------------------------------------------------- */

static void real_meshes_load_whole_and_survive_every_format(void **state) {
    (void)state;
    const struct {
        const char *name;
        size_t vertices, faces;
    } real[] = {{"dolphin.obj", 284, 561},
                {"castle.obj", 6620, 6493},
                {"stanford-bunny.obj", 35947, 69451}};
    for (size_t i = 0; i < 3; i++) {
        kg_mesh *mesh = kg_sample_real(real[i].name);
        if (!mesh)
            skip();
        assert_int_equal(mesh->vertex_count, real[i].vertices);
        assert_int_equal(mesh->face_count, real[i].faces);
        assert_int_equal(kg_mesh_fit(mesh, 100, NULL), KG_OK);
        assert_round_trips(mesh, 1e-5);
        kg_mesh_destroy(mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_brings_back_what_it_wrote),
        cmocka_unit_test(normals_survive_where_the_format_has_them),
        cmocka_unit_test(groups_keep_names_order_and_color),
        cmocka_unit_test(names_with_spaces_and_line_ends_break_no_file),
        cmocka_unit_test(obj_lists_one_g_line_per_group_and_no_o_line),
        cmocka_unit_test(numbers_are_written_with_points_whatever_the_locale),
        cmocka_unit_test(obj_negative_indices_count_from_the_last_vertex),
        cmocka_unit_test(obj_with_everything_in_it_loads),
        cmocka_unit_test(obj_faces_may_stand_before_their_vertices),
        cmocka_unit_test(obj_normals_that_differ_within_a_vertex_are_dropped),
        cmocka_unit_test(bad_obj_lines_are_named),
        cmocka_unit_test(unusable_faces_are_skipped_and_counted),
        cmocka_unit_test(an_edge_with_three_faces_loads),
        cmocka_unit_test(two_components_load),
        cmocka_unit_test(a_bow_tie_vertex_loads),
        cmocka_unit_test(faces_turned_against_each_other_load),
        cmocka_unit_test(a_concave_polygon_loads),
        cmocka_unit_test(ply_text_with_lists_colors_and_strange_elements_loads),
        cmocka_unit_test(ply_of_both_byte_orders_loads),
        cmocka_unit_test(ply_faces_of_300_corners_are_written),
        cmocka_unit_test(lying_ply_headers_are_refused),
        cmocka_unit_test(stl_text_welds_equal_corners),
        cmocka_unit_test(binary_stl_that_starts_with_solid_loads),
        cmocka_unit_test(off_variants_load),
        cmocka_unit_test(the_extension_names_the_format_in_any_case),
        cmocka_unit_test(files_are_written_whole_and_read_back),
        cmocka_unit_test(meshes_that_no_file_can_hold_are_refused),
        cmocka_unit_test(real_meshes_load_whole_and_survive_every_format),
    };
    return cmocka_run_group_tests_name("mesh formats", tests, NULL, NULL);
}
