/*
 * katagami: pictures of models: a camera, shapes kept on the graphics card, and a renderer that
 * draws a list of them into a window or an off-screen picture.
 *
 * Nothing of OpenGL starts before kg_offscreen_create() or, in a window's own context,
 * kg_renderer_create(). A renderer, its shapes and its calls belong to the thread and the OpenGL
 * 3.3 core context that were current when it was made.
 *
 * Lengths ending in _px are pixels of the finished picture; colours are sRGB, not premultiplied.
 */
#ifndef KATAGAMI_RENDER_H
#define KATAGAMI_RENDER_H

#include "katagami/base.h"
#include "katagami/mesh.h"
#include "katagami/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- colours ---------------------------------------------------------------------------- */

typedef struct kg_color {
    float r, g, b, a; /* each in [0,1] */
} kg_color;

/* The i-th of eight colours that stay apart for colour-blind eyes, then lighter and darker
 * variants of them, repeating after 24. After Okabe & Ito, "Color Universal Design" (2008); their
 * black is replaced by a grey, so that shading shows on it. */
KG_API kg_color kg_palette(size_t i);
/* The same as linear light, opaque. */
KG_API void kg_palette_linear(size_t i, float out_rgba[4]);

/* From linear light, as meshes and glTF hold it. */
KG_API kg_color kg_color_from_linear(const float rgba[4]);

/* 0xrrggbb, as nets and sheets hold them, opaque; and back. */
KG_API kg_color kg_color_from_rgb(uint32_t rgb);
KG_API uint32_t kg_color_to_rgb(kg_color color);
/* "#rrggbb"; false, and nothing is set, for other texts and NULL. */
KG_API bool kg_color_parse(const char *text, kg_color *out_color);

/* The colour a patch is shown in everywhere: its own, else that of its id in the palette. */
KG_API kg_color kg_patch_color(const kg_model_patch *patch);

/* ---- camera ----------------------------------------------------------------------------- */

/* The six views and an oblique one. World z is up: the front view looks along +y, the right view
 * along -x (from +x), the top view down along -z with +y upwards in the picture. */
typedef enum kg_view {
    KG_VIEW_FRONT,
    KG_VIEW_BACK,
    KG_VIEW_LEFT,
    KG_VIEW_RIGHT,
    KG_VIEW_TOP,
    KG_VIEW_BOTTOM,
    KG_VIEW_ISO,
    KG_VIEW_COUNT
} kg_view;

/* "front", "back", "left", "right", "top", "bottom", "iso". */
KG_API const char *kg_view_name(kg_view view);
KG_API bool kg_view_parse(const char *name, kg_view *out_view);

/* A camera on a sphere around what it looks at. */
typedef struct kg_camera {
    kg_vec3 center;       /* mm; the middle of the picture */
    double distance;      /* mm, > 0, from the eye to `center` */
    double yaw;           /* about z: 0 front view, π/2 right view */
    double pitch;         /* in [-π/2, π/2]: π/2 looks straight down */
    double field_of_view; /* over the picture's height, in (0, π) */
    bool ortho;           /* parallel projection, with the same scale at `center` */
} kg_camera;

/* The oblique view of a 200 mm box at the origin, perspective of 30°. */
KG_API kg_camera kg_camera_default(void);

/* Turns the camera to a named view; center and distance stay. */
KG_API void kg_camera_look(kg_camera *camera, kg_view view);

/* Moves center and distance so that `box` just fills a picture of `aspect` = width / height, with
 * a margin of 5 %; the direction stays. An empty box leaves the camera as it is. */
KG_API void kg_camera_fit(kg_camera *camera, kg_box3 box, double aspect);

/* Size in mm of one pixel at `center` in a picture `height_px` high. */
KG_API double kg_camera_pixel_size(const kg_camera *camera, double height_px);

/* The camera's axes in the world: to the right, up, and from `center` to the eye. */
KG_API void kg_camera_axes(const kg_camera *camera, kg_vec3 *out_right, kg_vec3 *out_up,
                           kg_vec3 *out_back);

/* Where `point` lies in a picture of width × height pixels: x to the right and y down from the
 * upper left corner, z the depth in mm along the line of sight from the eye's plane (positive in
 * front). False when the point is not in front of a perspective eye. */
KG_API bool kg_camera_project(const kg_camera *camera, double width_px, double height_px,
                              kg_vec3 point, kg_vec3 *out_pixel);

/* The ray through a pixel position: starts at the eye (parallel projection: in the eye's plane),
 * unit direction. */
KG_API void kg_camera_ray(const kg_camera *camera, double width_px, double height_px, kg_vec2 pixel,
                          kg_vec3 *out_origin, kg_vec3 *out_direction);

/* ---- what can be drawn ------------------------------------------------------------------ */

/* Triangles; the front is where the corners run counter-clockwise. */
typedef struct kg_surface {
    size_t vertex_count;
    kg_vec3 *positions;
    kg_vec3 *normals; /* per vertex, or NULL: every triangle is flat */
    size_t triangle_count;
    uint32_t *triangles; /* 3 indices each */
} kg_surface;

/* Triangulates the faces [first_face, first_face + face_count) of a mesh. Edges bent by more than
 * `crease` stay sharp, others are shaded smoothly: 0 makes all faces flat, π smooths all. A mesh
 * with its own normals keeps them unless crease is 0. Destroy the surface after use. `progress` may
 * be NULL. KG_ERR_MEMORY, KG_ERR_CANCELLED. */
KG_API kg_status kg_surface_from_mesh(const kg_mesh *mesh, size_t first_face, size_t face_count,
                                      double crease, const kg_progress *progress,
                                      kg_surface *out_surface, kg_error *error) KG_CHECKED;
KG_API void kg_surface_destroy(kg_surface *surface);

/* Polylines: line i runs through points[starts[i]] … points[starts[i + 1] - 1]; a closed one
 * repeats its first point. */
typedef struct kg_lines {
    const kg_vec3 *points;
    const uint32_t *starts; /* line_count + 1 */
    size_t line_count;
} kg_lines;

/* ---- renderer and shapes ---------------------------------------------------------------- */

typedef struct kg_renderer kg_renderer;

/* A surface, lines or points on the graphics card, uploaded once and drawn any number of times. */
typedef struct kg_shape kg_shape;

/* Compiles the shaders in the current OpenGL context. KG_ERR_SYSTEM when there is none or it is
 * older than 3.3. */
KG_API kg_status kg_renderer_create(kg_renderer **out_renderer, kg_error *error) KG_CHECKED;
KG_API void kg_renderer_destroy(kg_renderer *renderer);

/* Upload; the arrays may be freed afterwards. KG_ERR_INPUT for coordinates that are not finite and
 * indices out of range. Shapes must be destroyed before their context. */
KG_API kg_status kg_shape_from_surface(const kg_surface *surface, kg_shape **out_shape,
                                       kg_error *error) KG_CHECKED;
KG_API kg_status kg_shape_from_lines(const kg_lines *lines, kg_shape **out_shape,
                                     kg_error *error) KG_CHECKED;
/* The lines that a drawing of the surface has: its borders, the edges bent by at least `crease`,
 * and, from wherever it is seen, those where it turns its back. Vertices in the same place count as
 * one, whatever their normals. */
KG_API kg_status kg_shape_from_edges(const kg_surface *surface, double crease, kg_shape **out_shape,
                                     kg_error *error) KG_CHECKED;
KG_API kg_status kg_shape_from_points(const kg_vec3 *points, size_t count, kg_shape **out_shape,
                                      kg_error *error) KG_CHECKED;
/* Lines of a grid in the plane z = `center.z`, `half_count` cells to each side. */
KG_API kg_status kg_shape_grid(kg_vec3 center, double spacing, size_t half_count,
                               kg_shape **out_shape, kg_error *error) KG_CHECKED;
KG_API void kg_shape_destroy(kg_shape *shape);
KG_API kg_box3 kg_shape_box(const kg_shape *shape);

typedef struct kg_style {
    kg_color color;     /* alpha is the opacity; surfaces: the front side */
    kg_color back;      /* surfaces: the back side (its alpha is not used) */
    kg_color highlight; /* mixed into both by its alpha, 0 is none */
    bool unlit;         /* surfaces: plain colour without shading */
    bool even;          /* surfaces: as light from below as from above, as what is turned over is */
    float size_px;      /* width of lines, diameter of points */
    float dashes_px[4]; /* lines: on, off, on, off, along the line at the camera's center; all 0
                           is solid */
    bool square;        /* points: squares instead of discs */
    float hidden;       /* lines, points: opacity where a surface hides them, 0 … 1 */
    bool exact;         /* opaque lines, see-through surfaces: as deep as they are, to lie between
                           layers thinner than a pixel; lines along a surface have to be a little
                           before it, and such surfaces are below all lines */
} kg_style;

/* Opaque in `color` with a lighter tint of it on the back; lines 1.5 px, points 7 px. */
KG_API kg_style kg_style_default(kg_color color);

/* One shape in a scene. The same shape may appear several times. */
typedef struct kg_item {
    const kg_shape *shape;
    kg_style style;
} kg_item;

/* All that one picture shows. Opaque surfaces come first, then lines and points in their order,
 * then see-through surfaces from the far to the near, then see-through lines and points. */
typedef struct kg_scene {
    const kg_item *items;
    size_t item_count;
    kg_color background_top, background_bottom; /* alpha 0 leaves the picture see-through */
    bool axes;       /* the directions of x, y, z in the lower left corner */
    bool silhouette; /* surfaces only, plain black on white, to compare outlines */
} kg_scene;

/* No items, a soft grey background. */
KG_API kg_scene kg_scene_default(void);

/* Bounds of all items. */
KG_API kg_box3 kg_scene_box(const kg_scene *scene);

/* A part of a framebuffer; x, y is its lower left corner. */
typedef struct kg_viewport {
    int x, y, width, height; /* framebuffer pixels */
    double pixel_ratio;      /* framebuffer pixels per style pixel, 1 without HiDPI */
} kg_viewport;

/* Draws into the bound framebuffer, which must have a depth buffer; clears the viewport's part of
 * it first. Leaves depth test, blending, culling and scissor off, no program or array
 * bound, and another glViewport. */
KG_API void kg_renderer_draw(kg_renderer *renderer, const kg_scene *scene, const kg_camera *camera,
                             kg_viewport viewport);

/* ---- pictures --------------------------------------------------------------------------- */

/* Rows from the top; each pixel's four bytes are R, G, B, A with the colour premultiplied. */
typedef struct kg_image {
    int width, height;
    uint8_t *pixels;
} kg_image;

/* Draws the scene off-screen in the current context. `supersampling` 1 … 8: each pixel is the mean
 * of that many squared. KG_ERR_INPUT for sizes the card cannot draw. */
KG_API kg_status kg_renderer_picture(kg_renderer *renderer, const kg_scene *scene,
                                     const kg_camera *camera, int width, int height,
                                     int supersampling, kg_image *out_image,
                                     kg_error *error) KG_CHECKED;
KG_API void kg_image_destroy(kg_image *image);

/* Writes a PNG; "-" is standard output. */
KG_API kg_status kg_image_write_png(const kg_image *image, const char *path,
                                    kg_error *error) KG_CHECKED;

/* An OpenGL context without window or display (EGL_MESA_platform_surfaceless), current after
 * creation. KG_ERR_SYSTEM names the packages to install. */
typedef struct kg_offscreen kg_offscreen;
KG_API kg_status kg_offscreen_create(kg_offscreen **out_offscreen, kg_error *error) KG_CHECKED;
KG_API void kg_offscreen_destroy(kg_offscreen *offscreen);

#ifdef __cplusplus
}
#endif
#endif
