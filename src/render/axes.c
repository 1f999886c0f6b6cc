#include "render/renderer.h"

enum { MOST_POINTS = 6, MOST_LINES = 3 };

/* Strokes of a letter in a square [-1,1]², x right and y up. */
typedef struct letter {
    size_t line_count;
    uint32_t starts[MOST_LINES + 1];
    double strokes[MOST_POINTS][2];
} letter;

static const letter letters[3] = {
    {2, {0, 2, 4}, {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}}},
    {2, {0, 3, 5}, {{-1, 1}, {0, 0}, {1, 1}, {0, 0}, {0, -1}}},
    {1, {0, 4}, {{-1, 1}, {1, 1}, {-1, -1}, {1, -1}}},
};

static const kg_color colors[3] = {
    {0.835f, 0.369f, 0, 1}, {0, 0.62f, 0.451f, 1}, {0, 0.447f, 0.698f, 1}};

/* An arm of length 1 and its letter behind the tip, facing the camera. */
static void draw_axis(const kg_renderer *renderer, const kg_frame *frame, int axis) {
    const double letter_size = 0.13, letter_at = 1.3;
    kg_vec3 right, up, back;
    kg_camera_axes(frame->camera, &right, &up, &back);
    kg_vec3 tip = kg_v3(axis == 0, axis == 1, axis == 2);
    const letter *l = &letters[axis];
    kg_vec3 points[2 + MOST_POINTS] = {kg_v3(0, 0, 0), tip};
    uint32_t starts[2 + MOST_LINES] = {0};
    for (size_t i = 0; i <= l->line_count; i++)
        starts[1 + i] = 2 + l->starts[i];
    for (size_t i = 0; i < l->starts[l->line_count]; i++) {
        kg_vec3 p = kg_scale(tip, letter_at);
        p = kg_madd(p, 0.8 * letter_size * l->strokes[i][0], right);
        points[2 + i] = kg_madd(p, letter_size * l->strokes[i][1], up);
    }
    kg_lines lines = {points, starts, 1 + l->line_count};
    kg_shape *shape = NULL;
    if (kg_shape_from_lines(&lines, &shape, NULL))
        return; /* out of memory: a picture without axes */
    kg_item item = {shape, kg_style_default(colors[axis])};
    item.style.size_px = 2;
    kg_frame_item(renderer, frame, &item, KG_PART_CORE);
    kg_frame_item(renderer, frame, &item, KG_PART_RIM);
    kg_shape_destroy(shape);
}

void kg_frame_axes(const kg_renderer *renderer, const kg_frame *frame) {
    const double size_px = 90, reach = 1.5, margin_px = 6;
    kg_viewport v = frame->viewport;
    v.x += (int)(margin_px * v.pixel_ratio);
    v.y += (int)(margin_px * v.pixel_ratio);
    v.width = v.height = (int)(size_px * v.pixel_ratio);
    kg_camera camera = *frame->camera;
    camera.center = kg_v3(0, 0, 0);
    camera.ortho = true;
    camera.distance = reach / tan(camera.field_of_view / 2);
    kg_box3 box = {kg_v3(-reach, -reach, -reach), kg_v3(reach, reach, reach)};
    kg_frame corner = kg_frame_make(&camera, box, v);
    kg_vec3 right, up, back;
    kg_camera_axes(&camera, &right, &up, &back);
    double nearness[3] = {back.x, back.y, back.z};
    bool drawn[3] = {false};

    glViewport(v.x, v.y, v.width, v.height);
    glEnable(GL_BLEND);
    for (int n = 0; n < 3; n++) { /* from the far to the near */
        int next = -1;
        for (int i = 0; i < 3; i++) {
            if (!drawn[i] && (next < 0 || nearness[i] < nearness[next]))
                next = i;
        }
        drawn[next] = true;
        draw_axis(renderer, &corner, next);
    }
    glDisable(GL_BLEND);
}
