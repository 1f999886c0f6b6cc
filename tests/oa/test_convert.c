#include "reference.h"

#include <stdlib.h>

/* A mesh of boxes given by two corners each. */
static kg_mesh *boxes(const double (*b)[6], size_t count) {
    static const uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    kg_mesh *mesh = kg_mesh_create();
    mesh->vertex_count = 8 * count;
    mesh->face_count = 6 * count;
    mesh->positions = calloc(mesh->vertex_count, sizeof *mesh->positions);
    mesh->face_starts = calloc(mesh->face_count + 1, sizeof *mesh->face_starts);
    mesh->face_corners = calloc(4 * mesh->face_count, sizeof *mesh->face_corners);
    for (size_t i = 0; i < count; i++) {
        for (size_t v = 0; v < 8; v++)
            mesh->positions[8 * i + v] =
                kg_v3(b[i][v & 1 ? 3 : 0], b[i][v & 2 ? 4 : 1], b[i][v & 4 ? 5 : 2]);
        for (size_t f = 0; f < 6; f++) {
            mesh->face_starts[6 * i + f + 1] = (uint32_t)(4 * (6 * i + f + 1));
            for (size_t k = 0; k < 4; k++)
                mesh->face_corners[4 * (6 * i + f) + k] = (uint32_t)(8 * i) + sides[f][k];
        }
    }
    return mesh;
}

static kg_oa_options sized(int w, int d, int h) {
    kg_oa_options o = kg_oa_options_default();
    o.width = w;
    o.depth = d;
    o.height = h;
    o.smooth = 0;
    return o;
}

static bool is_valid(const kg_oa *oa) {
    face *faces = faces_of(oa);
    bool valid = flood_fill(oa, faces) == 0;
    free(faces);
    return valid;
}

/* Two steps, y up and z to the front: 10 wide, 10 high, 20 deep, the lower one in front. */
static void steps_become_steps(void **state) {
    (void)state;
    static const double steps[][6] = {{0, 0, -10, 10, 10, 5}, {0, 0, -10, 10, 5, 10}};
    kg_mesh *mesh = boxes(steps, 2);
    kg_oa_options o = sized(12, 11, 11);
    kg_oa *oa;
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_OK);
    for (int x = 0; x < 12; x++)
        for (int z = 0; z < 11; z++)
            assert_int_equal(kg_oa_depth(oa, x, z), x == 0 || x == 11 || z == 10 ? 0
                                                    : z < 5                      ? 10
                                                                                 : 5);
    kg_oa_destroy(oa);
    kg_mesh_destroy(mesh);
}

static void any_axes_give_the_same_card(void **state) {
    (void)state;
    static const double steps[][6] = {{0, 0, -10, 10, 10, 5}, {0, 0, -10, 4, 5, 10}};
    static const kg_vec3 axes[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    kg_mesh *mesh = boxes(steps, 2);
    kg_oa_options o = sized(14, 9, 11);
    int wanted[14 * 11], depth[14 * 11];
    assert_int_equal(kg_oa_depth_map(mesh, &o, NULL, wanted, NULL), KG_OK);
    kg_mesh_destroy(mesh);
    for (int u = 0; u < 6; u++)
        for (int f = 0; f < 6; f++) {
            if (kg_dot(axes[u], axes[f]) != 0)
                continue;
            mesh = boxes(steps, 2);
            kg_vec3 right = kg_cross(axes[u], axes[f]);
            for (size_t v = 0; v < mesh->vertex_count; v++) { /* turned: y is up, z front */
                kg_vec3 p = mesh->positions[v];
                mesh->positions[v] =
                    kg_madd(kg_madd(kg_scale(right, p.x), p.y, axes[u]), p.z, axes[f]);
            }
            o.up = axes[u];
            o.front = axes[f];
            assert_int_equal(kg_oa_depth_map(mesh, &o, NULL, depth, NULL), KG_OK);
            assert_memory_equal(depth, wanted, sizeof depth);
            kg_mesh_destroy(mesh);
        }
}

/* A gate: two posts and a lintel; the staircase fills the gateway, the windows open it again. */
static void gateway_is_opened(void **state) {
    (void)state;
    static const double gate[][6] = {
        {0, 0, -6, 4, 12, 6}, {16, 0, -6, 20, 12, 6}, {0, 12, -6, 20, 16, 6}};
    kg_mesh *mesh = boxes(gate, 3);
    kg_oa_options o = sized(22, 10, 17);
    kg_oa *oa;
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_OK);
    assert_true(is_valid(oa));
    for (int x = 5; x < 17; x++)
        for (int z = 0; z < 12; z++)
            assert_true(kg_oa_window(oa, x, z));
    for (int x = 1; x < 5; x++)
        for (int z = 0; z < 16; z++)
            assert_false(kg_oa_window(oa, x, z));
    kg_oa_destroy(oa);
    o.windows = false;
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_OK);
    for (int i = 0; i < 22 * 17; i++)
        assert_int_equal(oa->window[i], 0);
    kg_oa_destroy(oa);
    kg_mesh_destroy(mesh);
}

static void proportions_stay_unless_stretched(void **state) {
    (void)state;
    static const double box[][6] = {{0, 0, 0, 10, 30, 20}};
    kg_mesh *mesh = boxes(box, 1);
    kg_oa_options o = sized(42, 41, 31);
    int depth[42 * 31], widest = 0;
    for (int stretch = 0; stretch < 2; stretch++) {
        o.stretch = stretch;
        assert_int_equal(kg_oa_depth_map(mesh, &o, NULL, depth, NULL), KG_OK);
        widest = 0;
        for (int x = 0; x < 42; x++)
            widest += depth[x * 31] > 0;
        assert_int_equal(widest, stretch ? 40 : 10);
        assert_int_equal(depth[21 * 31], stretch ? 40 : 10);
        assert_int_equal(depth[21 * 31 + 29] > 0, 1);
        assert_int_equal(depth[21 * 31 + 30], 0);
    }
    kg_mesh_destroy(mesh);
}

static void smoothing_takes_thin_ledges_and_slots(void **state) {
    (void)state;
    /* a ledge two levels high goes, a slot of two is filled, three of each stay */
    int column[20] = {5, 5, 5, 5, 8, 8, 5, 5, 5, 5, 2, 2, 5, 5, 5, 5, 2, 2, 2, 2};
    static const int smooth[20] = {5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 2, 2, 2, 2};
    int thick[14] = {4, 4, 4, 7, 7, 7, 4, 4, 4, 1, 1, 1, 4, 4}, before[14];
    memcpy(before, thick, sizeof thick);
    assert_int_equal(kg_oa_smooth(column, 1, 20, 3, NULL), KG_OK);
    assert_memory_equal(column, smooth, sizeof smooth);
    assert_int_equal(kg_oa_smooth(thick, 1, 14, 3, NULL), KG_OK);
    before[12] = before[13] = 1; /* two levels below nothing are thin as well */
    for (int z = 0; z < 12; z++)
        assert_int_equal(thick[z], before[z]);
}

/* The 3x3 square in the section itself, pixel by pixel. */
static void smoothing_is_opening_and_closing_of_sections(void **state) {
    (void)state;
    enum { H = 12, PAD = 8, N = H + 2 * PAD };
    kg_random r = {51};
    for (int round = 0; round < 200; round++) {
        int column[H];
        bool image[4][N][N], *at; /* [z][y], y and z from -PAD */
        for (int z = 0; z < H; z++)
            column[z] = whole(&r, 0, 9);
        for (int z = 0; z < N; z++)
            for (int y = 0; y < N; y++) {
                int level = z < PAD ? 0 : z - PAD;
                image[0][z][y] = y - PAD < (level < H ? column[level] : 0);
            }
        static const bool dilate[4] = {false, true, true, false};
        for (int step = 0; step < 4; step++)
            for (int z = 0; z < N; z++)
                for (int y = 0; y < N; y++) {
                    at = &image[(step + 1) % 4][z][y];
                    *at = !dilate[step];
                    for (int k = 0; k < 9; k++) {
                        int zz = z + k / 3 - 1, yy = y + k % 3 - 1;
                        zz = zz < 0 ? 0 : zz >= N ? N - 1 : zz;
                        bool here = yy < 0 || (yy < N && image[step][zz][yy]);
                        *at = dilate[step] ? *at || here : *at && here;
                    }
                }
        assert_int_equal(kg_oa_smooth(column, 1, H, 3, NULL), KG_OK);
        for (int z = 0; z < H; z++)
            for (int y = 0; y < 12; y++)
                assert_int_equal(image[0][z + PAD][y + PAD], y < column[z]);
    }
}

static void useless_options_are_refused(void **state) {
    (void)state;
    static const double flat[][6] = {{0, 0, 0, 10, 0, 0}};
    static const double box[][6] = {{0, 0, 0, 1, 1, 1}};
    kg_mesh *line = boxes(flat, 1), *mesh = boxes(box, 1);
    kg_oa *oa;
    kg_oa_options o = sized(10, 10, 10);
    assert_int_equal(kg_oa_convert(line, &o, NULL, &oa, NULL), KG_ERR_INPUT);
    o.smooth = 4;
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_ERR_INPUT);
    o = sized(2, 10, 10);
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_ERR_INPUT);
    o = sized(10, 0, 10);
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_ERR_INPUT);
    o = sized(10, 10, KG_OA_MAX_SIZE + 1);
    assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_ERR_INPUT);
    kg_mesh_destroy(line);
    kg_mesh_destroy(mesh);
}

static void castle_becomes_a_valid_card(void **state) {
    (void)state;
    const char *folder = getenv("KATAGAMI_DATA");
    char path[4096];
    kg_mesh *mesh;
    snprintf(path, sizeof path, "%s/castle.obj", folder ? folder : DATA);
    if (kg_mesh_read(path, &mesh, NULL))
        skip();
    for (int scale = 1; scale <= 2; scale++) {
        kg_oa_options o = kg_oa_options_default();
        o.width *= scale;
        o.depth *= scale;
        o.height *= scale;
        kg_oa *oa;
        assert_int_equal(kg_oa_convert(mesh, &o, NULL, &oa, NULL), KG_OK);
        assert_int_equal(kg_oa_check(oa, NULL), KG_OK);
        assert_true(is_valid(oa));
        size_t windows = 0;
        for (int i = 0; i < o.width * o.height; i++)
            windows += oa->window[i];
        assert_true(windows > 30);
        kg_oa_destroy(oa);
    }
    kg_mesh_destroy(mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_become_steps),
        cmocka_unit_test(any_axes_give_the_same_card),
        cmocka_unit_test(gateway_is_opened),
        cmocka_unit_test(proportions_stay_unless_stretched),
        cmocka_unit_test(smoothing_takes_thin_ledges_and_slots),
        cmocka_unit_test(smoothing_is_opening_and_closing_of_sections),
        cmocka_unit_test(useless_options_are_refused),
        cmocka_unit_test(castle_becomes_a_valid_card),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
