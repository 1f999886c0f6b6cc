#include "render/shape.h"

#include "base/array.h"

#include <stdlib.h>

kg_status kg_shape_from_lines(const kg_lines *lines, kg_shape **out_shape, kg_error *error) {
    size_t point_count = lines->line_count ? lines->starts[lines->line_count] : 0;
    kg_box3 box;
    kg_status status = kg_shape_bounds(lines->points, point_count, &box, error);
    if (status)
        return status;
    kg_segment *segments = calloc(point_count + 1, sizeof *segments);
    if (!segments)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw lines of %zu points", point_count);
    kg_vec3 center = kg_shape_center(box);
    size_t count = 0;
    for (size_t i = 0; i < lines->line_count; i++) {
        double length = 0;
        for (size_t k = lines->starts[i]; k + 1 < lines->starts[i + 1]; k++) {
            kg_vec3 a = lines->points[k], b = lines->points[k + 1];
            kg_segment *s = &segments[count++];
            kg_shape_store(kg_sub(a, center), s->start);
            kg_shape_store(kg_sub(b, center), s->end);
            s->start[3] = (float)length;
            length += kg_dist(a, b);
            s->end[3] = (float)length;
        }
    }
    status = kg_shape_from_segments(segments, count, box, out_shape, error);
    free(segments);
    return status;
}

kg_status kg_shape_grid(kg_vec3 center, double spacing, size_t half_count, kg_shape **out_shape,
                        kg_error *error) {
    enum { MOST = 1000 };
    if (!(spacing > 0) || half_count < 1 || half_count > MOST)
        return kg_fail(error, KG_ERR_INPUT, "a grid needs a spacing above 0 and 1 to %d cells",
                       MOST);
    struct {
        kg_vec3 *items;
        size_t count, capacity;
    } points = {0};
    struct {
        uint32_t *items;
        size_t count, capacity;
    } starts = {0};
    double half = spacing * (double)half_count;
    bool room = kg_push(&starts, 0);
    for (size_t i = 0; room && i <= 2 * half_count; i++) {
        double at = spacing * (double)i - half;
        room = kg_push(&points, kg_add(center, kg_v3(at, -half, 0))) &&
               kg_push(&points, kg_add(center, kg_v3(at, half, 0))) &&
               kg_push(&starts, (uint32_t)points.count) &&
               kg_push(&points, kg_add(center, kg_v3(-half, at, 0))) &&
               kg_push(&points, kg_add(center, kg_v3(half, at, 0))) &&
               kg_push(&starts, (uint32_t)points.count);
    }
    kg_status status;
    if (room) {
        kg_lines lines = {points.items, starts.items, starts.count - 1};
        status = kg_shape_from_lines(&lines, out_shape, error);
    } else {
        status = kg_fail(error, KG_ERR_MEMORY, "no memory for a grid");
    }
    free(points.items);
    free(starts.items);
    return status;
}
