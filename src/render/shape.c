#include "render/shape.h"

#include <limits.h>
#include <stdlib.h>

typedef struct surface_vertex {
    float position[3], normal[3];
} surface_vertex;

kg_status kg_shape_bounds(const kg_vec3 *points, size_t count, kg_box3 *out_box, kg_error *error) {
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

kg_vec3 kg_shape_center(kg_box3 box) {
    return box.lo.x <= box.hi.x ? kg_lerp(box.lo, box.hi, 0.5) : kg_v3(0, 0, 0);
}

void kg_shape_store(kg_vec3 p, float out[3]) {
    out[0] = (float)p.x;
    out[1] = (float)p.y;
    out[2] = (float)p.z;
}

/* Fills a new buffer, which stays bound; false when the card's memory runs out. */
static bool upload(GLenum target, const void *data, size_t bytes, GLuint *out_buffer) {
    glGenBuffers(1, out_buffer);
    glBindBuffer(target, *out_buffer);
    glBufferData(target, (GLsizeiptr)bytes, data, GL_STATIC_DRAW);
    return glGetError() != GL_OUT_OF_MEMORY;
}

/* Binds a new vertex array with `bytes` of vertices in it. */
static kg_shape *create(kg_shape_kind kind, kg_box3 box, size_t count, const void *vertices,
                        size_t bytes) {
    kg_shape *shape = calloc(1, sizeof *shape);
    if (!shape)
        return NULL;
    shape->kind = kind;
    shape->box = box;
    shape->origin = kg_shape_center(box);
    shape->count = (GLsizei)count;
    glGenVertexArrays(1, &shape->array);
    glBindVertexArray(shape->array);
    if (!upload(GL_ARRAY_BUFFER, vertices, bytes, &shape->vertices)) {
        kg_shape_destroy(shape);
        return NULL;
    }
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

kg_status kg_shape_check(const kg_surface *surface, kg_box3 *out_box, kg_error *error) {
    if (surface->triangle_count > INT_MAX / 3 || surface->vertex_count > INT_MAX)
        return kg_fail(error, KG_ERR_INPUT, "a surface of %zu triangles is too large to draw",
                       surface->triangle_count);
    for (size_t i = 0; i < 3 * surface->triangle_count; i++) {
        if (surface->triangles[i] >= surface->vertex_count)
            return kg_fail(error, KG_ERR_INPUT, "triangle %zu has corner %u of only %zu", i / 3,
                           surface->triangles[i], surface->vertex_count);
    }
    return kg_shape_bounds(surface->positions, surface->vertex_count, out_box, error);
}

kg_status kg_shape_from_surface(const kg_surface *surface, kg_shape **out_shape, kg_error *error) {
    kg_box3 box;
    kg_status status = kg_shape_check(surface, &box, error);
    if (status)
        return status;
    size_t n = surface->vertex_count;
    surface_vertex *vertices = calloc(n + 1, sizeof *vertices);
    if (!vertices)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw a surface of %zu vertices", n);
    kg_vec3 center = kg_shape_center(box);
    for (size_t i = 0; i < n; i++) {
        kg_shape_store(kg_sub(surface->positions[i], center), vertices[i].position);
        if (surface->normals)
            kg_shape_store(kg_unit(surface->normals[i]), vertices[i].normal);
    }
    size_t count = 3 * surface->triangle_count;
    kg_shape *shape = create(KG_SHAPE_SURFACE, box, count, vertices, n * sizeof *vertices);
    free(vertices);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw a surface");
    attribute(0, 3, sizeof(surface_vertex), offsetof(surface_vertex, position), false);
    attribute(1, 3, sizeof(surface_vertex), offsetof(surface_vertex, normal), false);
    bool room = upload(GL_ELEMENT_ARRAY_BUFFER, surface->triangles, count * sizeof(uint32_t),
                       &shape->indices);
    unbind();
    if (!room) {
        kg_shape_destroy(shape);
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw a surface");
    }
    *out_shape = shape;
    return KG_OK;
}

kg_status kg_shape_from_segments(const kg_segment *segments, size_t count, kg_box3 box,
                                 kg_shape **out_shape, kg_error *error) {
    if (count > INT_MAX)
        return kg_fail(error, KG_ERR_INPUT, "%zu lines are too many to draw", count);
    kg_shape *shape = create(KG_SHAPE_LINES, box, count, segments, count * sizeof *segments);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw lines");
    const size_t stride = sizeof(kg_segment);
    attribute(0, 4, stride, offsetof(kg_segment, start), true);
    attribute(1, 4, stride, offsetof(kg_segment, end), true);
    attribute(2, 3, stride, offsetof(kg_segment, normal_a), true);
    attribute(3, 3, stride, offsetof(kg_segment, normal_b), true);
    unbind();
    *out_shape = shape;
    return KG_OK;
}

kg_status kg_shape_from_points(const kg_vec3 *points, size_t count, kg_shape **out_shape,
                               kg_error *error) {
    kg_box3 box;
    kg_status status = kg_shape_bounds(points, count, &box, error);
    if (status)
        return status;
    if (count > INT_MAX)
        return kg_fail(error, KG_ERR_INPUT, "%zu points are too many to draw", count);
    float(*positions)[3] = calloc(count + 1, sizeof *positions);
    if (!positions)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw %zu points", count);
    kg_vec3 center = kg_shape_center(box);
    for (size_t i = 0; i < count; i++)
        kg_shape_store(kg_sub(points[i], center), positions[i]);
    kg_shape *shape = create(KG_SHAPE_POINTS, box, count, positions, count * sizeof *positions);
    free(positions);
    if (!shape)
        return kg_fail(error, KG_ERR_MEMORY, "no memory to draw points");
    attribute(0, 3, sizeof *positions, 0, true);
    unbind();
    *out_shape = shape;
    return KG_OK;
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
