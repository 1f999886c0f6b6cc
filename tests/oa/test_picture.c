/* Depths by rays agree with those that the graphics card finds. Leaves with 77, "skipped", where
 * the machine cannot draw. */
#include "katagami/oa.h"
#include "katagami/render.h"
#include "render/camera.h"
#include "render/target.h"

#include "check.h"

#include <stdlib.h>

enum { W = 48, D = 24, H = 32 };

static void rays_and_rendering_find_the_same_depths(void **state) {
    kg_offscreen **offscreen = (kg_offscreen **)state;
    assert_non_null(*offscreen);
    kg_mesh *mesh;
    assert_int_equal(kg_mesh_read(SAMPLES "/castle.obj", &mesh, NULL), KG_OK);
    static const double turn[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    assert_int_equal(kg_mesh_transform(mesh, turn, NULL), KG_OK); /* z up, front at -y */
    kg_oa_options o = kg_oa_options_default();
    o.width = W;
    o.depth = D;
    o.height = H;
    o.up = kg_v3(0, 0, 1);
    o.front = kg_v3(0, -1, 0);
    int depth[W * H];
    assert_int_equal(kg_oa_depth_map(mesh, &o, NULL, depth, NULL), KG_OK);

    /* one pixel for each cell, seen in parallel */
    kg_box3 box = kg_mesh_bounds(mesh);
    double cell = fmax((box.hi.x - box.lo.x) / (W - 2),
                       fmax((box.hi.z - box.lo.z) / (H - 1), (box.hi.y - box.lo.y) / 2 / (D - 1)));
    kg_vec3 middle = kg_scale(kg_add(box.lo, box.hi), 0.5);
    kg_camera camera = kg_camera_default();
    kg_camera_look(&camera, KG_VIEW_FRONT);
    camera.ortho = true;
    camera.center = kg_v3(middle.x, middle.y, box.lo.z + H * cell / 2);
    camera.field_of_view = 0.5;
    camera.distance = H * cell / 2 / tan(0.25);

    kg_renderer *renderer;
    kg_surface surface;
    kg_shape *shape;
    assert_int_equal(kg_renderer_create(&renderer, NULL), KG_OK);
    assert_int_equal(kg_surface_from_mesh(mesh, 0, mesh->face_count, 0, NULL, &surface, NULL),
                     KG_OK);
    assert_int_equal(kg_shape_from_surface(&surface, &shape, NULL), KG_OK);
    kg_item item = {.shape = shape, .style = kg_style_default(kg_palette(0))};
    kg_scene scene = kg_scene_default();
    scene.items = &item;
    scene.item_count = 1;
    kg_target target;
    float drawn_depth[W * H];
    double nearest, farthest;
    assert_int_equal(kg_target_create(W, H, GL_RGBA8, &target, NULL), KG_OK);
    kg_renderer_draw(renderer, &scene, &camera, (kg_viewport){0, 0, W, H, 1});
    glReadPixels(0, 0, W, H, GL_DEPTH_COMPONENT, GL_FLOAT, drawn_depth);
    kg_target_destroy(&target);
    kg_camera_range(&camera, box, &nearest, &farthest);
    int same = 0, near = 0, filled = 0, most = 0;
    for (int x = 1; x < W - 1; x++)
        for (int z = 0; z < H - 1; z++) {
            double seen = (double)drawn_depth[z * W + x]; /* 1: nothing */
            double y = camera.center.y - camera.distance + nearest + seen * (farthest - nearest);
            int drawn = seen < 1 ? (int)floor((middle.y - y) / cell + 0.5) : 0;
            drawn = drawn < 0 ? 0 : drawn;
            int cast = depth[x * H + z];
            filled += cast > 0;
            most = cast > most ? cast : most;
            same += drawn == cast;
            near += abs(drawn - cast) <= 1;
        }
    int cells = (W - 2) * (H - 1);
    assert_true(filled > 200 && most > 5);
    assert_true(near >= cells - cells / 200); /* outlines that pass through a pixel's middle */
    assert_true(same >= cells - cells / 50);  /* depths halfway between two cells */
    kg_shape_destroy(shape);
    kg_surface_destroy(&surface);
    kg_renderer_destroy(renderer);
    kg_mesh_destroy(mesh);
}

int main(void) {
    kg_offscreen *offscreen = NULL;
    if (kg_offscreen_create(&offscreen, NULL))
        return 77;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(rays_and_rendering_find_the_same_depths, offscreen),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    kg_offscreen_destroy(offscreen);
    return failed;
}
