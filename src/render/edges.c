#include "render/shape.h"

#include <stdlib.h>

/* A vertex to be told from those in other places. */
typedef struct place {
    kg_vec3 p;
    uint32_t vertex;
} place;

/* A triangle's side, as vertices that stand for all in their place. */
typedef struct side {
    uint32_t low, high;
    uint32_t triangle;
    bool upwards; /* runs from low to high */
} side;

static int compare_numbers(double a, double b) {
    return (a > b) - (a < b);
}

static int compare_places(const void *a, const void *b) {
    const place *p = a, *q = b;
    int order = compare_numbers(p->p.x, q->p.x);
    if (order == 0)
        order = compare_numbers(p->p.y, q->p.y);
    if (order == 0)
        order = compare_numbers(p->p.z, q->p.z);
    return order ? order : (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

static int compare_sides(const void *a, const void *b) {
    const side *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

/* For each vertex the lowest one in the same place. */
static uint32_t *merged_vertices(const kg_surface *surface) {
    size_t n = surface->vertex_count;
    place *places = calloc(n + 1, sizeof *places);
    uint32_t *merged = calloc(n + 1, sizeof *merged);
    if (!places || !merged) {
        free(places);
        free(merged);
        return NULL;
    }
    for (size_t i = 0; i < n; i++)
        places[i] = (place){surface->positions[i], (uint32_t)i};
    qsort(places, n, sizeof *places, compare_places);
    for (size_t i = 0; i < n; i++) {
        bool same = i > 0 && kg_dist(places[i].p, places[i - 1].p) <= 0;
        merged[places[i].vertex] = same ? merged[places[i - 1].vertex] : places[i].vertex;
    }
    free(places);
    return merged;
}

/* The sides of all triangles in order, those of one edge together; `*out_count` of them. */
static side *sorted_sides(const kg_surface *surface, size_t *out_count) {
    uint32_t *merged = merged_vertices(surface);
    side *sides = calloc(surface->triangle_count + 1, 3 * sizeof *sides);
    size_t count = 0;
    for (uint32_t t = 0; merged && sides && t < surface->triangle_count; t++) {
        const uint32_t *corners = surface->triangles + 3 * (size_t)t;
        for (int k = 0; k < 3; k++) {
            uint32_t a = merged[corners[k]], b = merged[corners[(k + 1) % 3]];
            if (a != b)
                sides[count++] = (side){a < b ? a : b, a < b ? b : a, t, a < b};
        }
    }
    if (!merged) {
        free(sides);
        sides = NULL;
    }
    free(merged);
    if (sides)
        qsort(sides, count, sizeof *sides, compare_sides);
    *out_count = count;
    return sides;
}

static kg_vec3 normal_of(const kg_surface *surface, uint32_t triangle) {
    const uint32_t *c = surface->triangles + 3 * (size_t)triangle;
    kg_vec3 a = surface->positions[c[0]];
    return kg_unit(
        kg_cross(kg_sub(surface->positions[c[1]], a), kg_sub(surface->positions[c[2]], a)));
}

/* Sets the normals on both sides of an edge of two triangles, unless it is drawn always: as a
 * crease, or when one triangle has no area. */
static void set_normals(const kg_surface *surface, const side *sides, double crease,
                        kg_segment *segment) {
    kg_vec3 a = normal_of(surface, sides[0].triangle), b = normal_of(surface, sides[1].triangle);
    if (sides[0].upwards == sides[1].upwards)
        b = kg_neg(b); /* triangles turned against each other */
    if (kg_dot(a, b) <= cos(crease))
        return;
    kg_shape_store(a, segment->normal_a);
    kg_shape_store(b, segment->normal_b);
}

kg_status kg_shape_from_edges(const kg_surface *surface, double crease, kg_shape **out_shape,
                              kg_error *error) {
    kg_box3 box;
    kg_status status = kg_shape_check(surface, &box, error);
    if (status)
        return status;
    size_t side_count = 0, count = 0;
    side *sides = sorted_sides(surface, &side_count);
    kg_segment *segments = calloc(side_count + 1, sizeof *segments);
    if (!sides || !segments) {
        free(sides);
        free(segments);
        return kg_fail(error, KG_ERR_MEMORY, "no memory for the edges of %zu triangles",
                       surface->triangle_count);
    }
    kg_vec3 center = kg_shape_center(box);
    for (size_t i = 0, next; i < side_count; i = next) {
        for (next = i + 1; next < side_count && sides[next].low == sides[i].low &&
                           sides[next].high == sides[i].high;)
            next++;
        kg_vec3 a = surface->positions[sides[i].low], b = surface->positions[sides[i].high];
        kg_segment *s = &segments[count++];
        kg_shape_store(kg_sub(a, center), s->start);
        kg_shape_store(kg_sub(b, center), s->end);
        s->end[3] = (float)kg_dist(a, b);
        if (next == i + 2)
            set_normals(surface, &sides[i], crease, s);
    }
    status = kg_shape_from_segments(segments, count, box, out_shape, error);
    free(sides);
    free(segments);
    return status;
}
