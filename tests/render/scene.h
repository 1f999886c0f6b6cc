/* Small scenes for the tests that draw, and a renderer for them. */
#ifndef KG_TESTS_RENDER_SCENE_H
#define KG_TESTS_RENDER_SCENE_H

#include "katagami/render.h"
#include "tests/check.h"

enum { SIZE = 200 }; /* px: pictures of 200 x 200, 1 mm to a pixel */

extern kg_renderer *renderer; /* while run_with_renderer() runs */

extern const kg_color black, red, green, blue, white;

/* From the front, parallel, one pixel to a millimetre, the origin in the middle. */
kg_camera front_camera(void);
kg_scene scene_of(const kg_item *items, size_t count);
kg_shape *surface(kg_vec3 *positions, size_t vertices, uint32_t *triangles, size_t count);
/* A square of edge 2h in the plane y, its front towards the front camera. */
kg_shape *square_at(double y, double h);
kg_shape *cube(double h);
kg_shape *line(kg_vec3 a, kg_vec3 b);
kg_item item_of(const kg_shape *shape, kg_color color);
kg_image picture(const kg_scene *scene, const kg_camera *camera);
const uint8_t *at(const kg_image *image, int x, int y);
void assert_pixel(const kg_image *image, int x, int y, kg_color c);
/* How much of the picture is dark, in pixels: black counts 1, white 0. */
double darkness(const kg_image *image);
double darkness_of(const kg_item *items, size_t count, const kg_camera *camera);

/* main() of such tests: 77, "skipped", where the machine cannot draw. */
int run_with_renderer(const struct CMUnitTest *tests, size_t count);

#endif
