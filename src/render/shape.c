#include "render/shape.h"

#include "base/array.h"

#include <limits.h>
#include <stdlib.h>

typedef struct surface_vertex {
    float position[3], normal[3];
} surface_vertex;

typedef struct segment {
    float start[4], end[4]; /* xyz, and the arc length up to there */
    uint32_t line;
} segment;

/* Bounds of `points`, which must be finite. */
static kg_status bounds(const kg_vec3 *points, size_t count, kg_box3 *out_box, kg_error *error) {
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < count; i++) {
        kg_vec3 p = points[i];
        /* Floats hold 3e38; a model beyond 1e30 is not one of paper. */
        if (!(fabs(p.x) < 1e30 && fabs(p.y) < 1e30 && fabs(p.z) < 1e30))
            return kg_fail(error, KG_ERR_INPUT, "point %zu (%g, %g, %g) is not finite", i, p.x, p.y,
                           p.z);
        kg_box3_add(&box, p);
    }
    *out_box = box;
    return KG_OK;
}

static kg_vec3 center_of(kg_box3 box) {
    return box.lo.x <= box.hi.x ? kg_lerp(box.lo, box.hi, 0.5) : kg_v3(0, 0, 0);
}

static void store(kg_vec3 p, float out[3]) {
    out[0] = (float)p.x;
    out[1] = (float)p.y;
    out[2] = (float)p.z;
}

/* Binds a new vertex array with `bytes` of vertices in it. */
static kg_shape *create(kg_shape_kind kind, kg_box3 box, size_t count, const void *vertices,
                        size_t bytes) {
    kg_shape *shape = calloc(1, sizeof *shape);
    if (!shape)
        return NULL;
    shape->kind = kind;
    shape->box = box;
    shape->origin = center_of(box);
    shape->count = (GLsizei)count;
    glGenVertexArrays(1, &shape->array);
    glBindVertexArray(shape->array);
    glGenBuffers(1, &shape->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, shape->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, vertices, GL_STATIC_DRAW);
    return shape;
}

static void attribute(GLuint location, GLint floats, size_t stride, size_t offset, bool instanced) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, (GLsizei)stride,
                          (const void *)offset);
    glVertexAttribDivisor(location, instanced);
}

static void unbind(void) {
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

kg_status kg_shape_from_surface(const kg_surface *surface, kg_shape **out_shape, kg_error *error) {
    kg_box3 box;
    kg_status status = bounds(surface->positions, surface->vertex_count, &box, error);
    if (status)
        return status;
    if (surface->triangle_count > INT_MAX / 3 || surface->vertex_count > INT_MAX)
        return kg_fail(error, KG_ERR_INPUT, "a surface of %zu triangles is too large to draw",
                       surface->triangle_count);
    for (size_t i = 0; i < 3 * surface->triangle_count; i++) {
        if (surface->triangles[i] >= surface->vertex_count)
            return kg_fail(error, KG_ERR_INPUT, "triangle %zu has corner %u of only %zu", i / 3,
                           surface->triangles[i], surface->vertex_count);
    }
    size_t n = surface->vertex_count;
    surface_vertex *vertices = calloc(n + 1, sizeof *vertices);
    if (!vertices)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw a surface of %zu vertices", n);
    kg_vec3 center = center_of(box);
    for (size_t i = 0; i < n; i++) {
        store(kg_sub(surface->positions[i], center), vertices[i].position);
        if (surface->normals)
            store(kg_unit(surface->normals[i]), vertices[i].normal);
    }
    size_t count = 3 * surface->triangle_count;
    kg_shape *shape = create(KG_SHAPE_SURFACE, box, count, vertices, n * sizeof *vertices);
    free(vertices);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw a surface");
    attribute(0, 3, sizeof(surface_vertex), offsetof(surface_vertex, position), false);
    attribute(1, 3, sizeof(surface_vertex), offsetof(surface_vertex, normal), false);
    glGenBuffers(1, &shape->indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, shape->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof(uint32_t)),
                 surface->triangles, GL_STATIC_DRAW);
    unbind();
    *out_shape = shape;
    return KG_OK;
}

kg_status kg_shape_from_lines(const kg_lines *lines, kg_shape **out_shape, kg_error *error) {
    size_t point_count = lines->line_count ? lines->starts[lines->line_count] : 0;
    kg_box3 box;
    kg_status status = bounds(lines->points, point_count, &box, error);
    if (status)
        return status;
    segment *segments = calloc(point_count + 1, sizeof *segments);
    if (!segments)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw lines of %zu points", point_count);
    kg_vec3 center = center_of(box);
    size_t count = 0;
    for (size_t i = 0; i < lines->line_count; i++) {
        double length = 0;
        for (size_t k = lines->starts[i]; k + 1 < lines->starts[i + 1]; k++) {
            kg_vec3 a = lines->points[k], b = lines->points[k + 1];
            segment *s = &segments[count++];
            store(kg_sub(a, center), s->start);
            store(kg_sub(b, center), s->end);
            s->start[3] = (float)length;
            length += kg_dist(a, b);
            s->end[3] = (float)length;
            s->line = (uint32_t)i;
        }
    }
    kg_shape *shape = create(KG_SHAPE_LINES, box, count, segments, count * sizeof *segments);
    free(segments);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw lines");
    attribute(0, 4, sizeof(segment), offsetof(segment, start), true);
    attribute(1, 4, sizeof(segment), offsetof(segment, end), true);
    glEnableVertexAttribArray(2);
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, sizeof(segment),
                           (const void *)offsetof(segment, line));
    glVertexAttribDivisor(2, 1);
    unbind();
    *out_shape = shape;
    return KG_OK;
}

kg_status kg_shape_from_points(const kg_vec3 *points, size_t count, kg_shape **out_shape,
                               kg_error *error) {
    kg_box3 box;
    kg_status status = bounds(points, count, &box, error);
    if (status)
        return status;
    if (count > INT_MAX)
        return kg_fail(error, KG_ERR_INPUT, "%zu points are too many to draw", count);
    float(*positions)[3] = calloc(count + 1, sizeof *positions);
    if (!positions)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw %zu points", count);
    kg_vec3 center = center_of(box);
    for (size_t i = 0; i < count; i++)
        store(kg_sub(points[i], center), positions[i]);
    kg_shape *shape = create(KG_SHAPE_POINTS, box, count, positions, count * sizeof *positions);
    free(positions);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw points");
    attribute(0, 3, sizeof *positions, 0, true);
    unbind();
    *out_shape = shape;
    return KG_OK;
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

void kg_shape_draw(const kg_shape *shape) {
    if (shape->count == 0)
        return;
    glBindVertexArray(shape->array);
    if (shape->kind == KG_SHAPE_SURFACE)
        glDrawElements(GL_TRIANGLES, shape->count, GL_UNSIGNED_INT, NULL);
    else
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, shape->count);
}

void kg_shape_destroy(kg_shape *shape) {
    if (!shape)
        return;
    glDeleteVertexArrays(1, &shape->array);
    glDeleteBuffers(1, &shape->vertices);
    glDeleteBuffers(1, &shape->indices);
    free(shape);
}

kg_box3 kg_shape_box(const kg_shape *shape) {
    return shape->box;
}
