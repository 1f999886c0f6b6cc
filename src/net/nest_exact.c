#include "net/nest_exact.h"

#include <geos_c.h>
#include <stdlib.h>
#include <string.h>

/* mm by which a distance may fall short of the spacing: rounding of turned coordinates. */
static const double ROUNDING = 1e-6;

/* Directions are rounded to this, radians: of parts that differ by rounding they are the same. */
static const double ANGLE_GRAIN = 1e-6;

typedef struct placed {
    GEOSGeometry *geometry;
    const GEOSPreparedGeometry *prepared;
    kg_box2 box;
} placed;

struct kg_nest_exact {
    GEOSContextHandle_t geos;
    size_t count;
    GEOSGeometry **parts;
    placed *placed;
};

_Static_assert(sizeof(kg_vec2) == 2 * sizeof(double), "points are handed to GEOS as doubles");

/* A loop as a closed ring or, for simplifying, a closed line. */
static GEOSGeometry *make_ring(GEOSContextHandle_t geos, kg_nest_loop loop, bool line) {
    kg_vec2 *points = malloc((loop.count + 1) * sizeof *points);
    if (!points)
        return NULL;
    memcpy(points, loop.points, loop.count * sizeof *points);
    points[loop.count] = points[0];
    GEOSCoordSequence *seq =
        GEOSCoordSeq_copyFromBuffer_r(geos, &points[0].x, (unsigned)(loop.count + 1), 0, 0);
    free(points);
    if (!seq)
        return NULL;
    return line ? GEOSGeom_createLineString_r(geos, seq) : GEOSGeom_createLinearRing_r(geos, seq);
}

/* The part as a valid polygon: outlines that cross themselves are repaired, keeping every line. */
static GEOSGeometry *make_polygon(GEOSContextHandle_t geos, const kg_nest_part *part) {
    size_t holes = part->loop_count - 1, made = 0;
    GEOSGeometry **rings = malloc(part->loop_count * sizeof *rings), *polygon = NULL;
    if (!rings)
        return NULL;
    while (made < part->loop_count && (rings[made] = make_ring(geos, part->loops[made], false)))
        made++;
    if (made == part->loop_count)
        polygon = GEOSGeom_createPolygon_r(geos, rings[0], rings + 1, (unsigned)holes);
    else
        while (made > 0)
            GEOSGeom_destroy_r(geos, rings[--made]);
    free(rings);
    if (polygon && GEOSisValid_r(geos, polygon) != 1) {
        GEOSGeometry *repaired = GEOSMakeValid_r(geos, polygon);
        GEOSGeom_destroy_r(geos, polygon);
        polygon = repaired;
    }
    return polygon;
}

static kg_status check_part(const kg_nest_part *part, size_t index, kg_error *error) {
    if (part->loop_count == 0)
        return kg_fail(error, KG_ERR_INPUT, "part %zu to nest has no outline", index + 1);
    for (size_t k = 0; k < part->loop_count; k++) {
        kg_nest_loop loop = part->loops[k];
        if (loop.count < 3 || loop.count >= UINT32_MAX)
            return kg_fail(error, KG_ERR_INPUT, "part %zu to nest: outline %zu has %zu points",
                           index + 1, k + 1, loop.count);
        for (size_t i = 0; i < loop.count; i++)
            if (!(fabs(loop.points[i].x) <= 1e6 && fabs(loop.points[i].y) <= 1e6))
                return kg_fail(error, KG_ERR_INPUT,
                               "part %zu to nest: point %zu of outline %zu lies beyond 1e6 mm",
                               index + 1, i + 1, k + 1);
    }
    return KG_OK;
}

kg_status kg_nest_exact_create(const kg_nest_part *parts, size_t count, kg_nest_exact **out,
                               kg_error *error) {
    for (size_t i = 0; i < count; i++) {
        kg_status status = check_part(&parts[i], i, error);
        if (status != KG_OK)
            return status;
    }
    kg_nest_exact *exact = calloc(1, sizeof *exact);
    if (exact) {
        exact->geos = GEOS_init_r();
        exact->parts = calloc(count + 1, sizeof *exact->parts);
        exact->placed = calloc(count + 1, sizeof *exact->placed);
        exact->count = count;
    }
    if (!exact || !exact->geos || !exact->parts || !exact->placed) {
        kg_nest_exact_destroy(exact);
        return kg_fail(error, KG_ERR_MEMORY, "no memory to nest %zu parts", count);
    }
    for (size_t i = 0; i < count; i++) {
        exact->parts[i] = make_polygon(exact->geos, &parts[i]);
        bool made = exact->parts[i] != NULL;
        if (made && kg_nest_exact_area(exact, i) > 0)
            continue;
        kg_nest_exact_destroy(exact);
        return made ? kg_fail(error, KG_ERR_INPUT, "part %zu to nest has no area", i + 1)
                    : kg_fail(error, KG_ERR_MEMORY, "no memory to nest part %zu", i + 1);
    }
    *out = exact;
    return KG_OK;
}

static void forget_placed(GEOSContextHandle_t geos, placed *p) {
    if (p->prepared)
        GEOSPreparedGeom_destroy_r(geos, p->prepared);
    if (p->geometry)
        GEOSGeom_destroy_r(geos, p->geometry);
    *p = (placed){0};
}

void kg_nest_exact_destroy(kg_nest_exact *exact) {
    if (!exact)
        return;
    for (size_t i = 0; i < exact->count; i++) {
        if (exact->placed)
            forget_placed(exact->geos, &exact->placed[i]);
        if (exact->parts && exact->parts[i])
            GEOSGeom_destroy_r(exact->geos, exact->parts[i]);
    }
    if (exact->geos)
        GEOS_finish_r(exact->geos);
    free(exact->parts);
    free(exact->placed);
    free(exact);
}

double kg_nest_exact_area(const kg_nest_exact *exact, size_t part) {
    double area = 0;
    return GEOSArea_r(exact->geos, exact->parts[part], &area) ? area : 0;
}

double kg_nest_exact_axis(const kg_nest_exact *exact, size_t part) {
    GEOSContextHandle_t geos = exact->geos;
    double angle = 0, x[2], y[2];
    GEOSGeometry *rectangle = GEOSMinimumRotatedRectangle_r(geos, exact->parts[part]);
    const GEOSGeometry *ring = rectangle ? GEOSGetExteriorRing_r(geos, rectangle) : NULL;
    const GEOSCoordSequence *seq = ring ? GEOSGeom_getCoordSeq_r(geos, ring) : NULL;
    if (seq && GEOSCoordSeq_getXY_r(geos, seq, 0, &x[0], &y[0]) &&
        GEOSCoordSeq_getXY_r(geos, seq, 1, &x[1], &y[1])) {
        const double quarter = KG_PI / 2;
        angle = fmod(atan2(y[1] - y[0], x[1] - x[0]) + 4 * quarter, quarter);
        angle = quarter - angle < ANGLE_GRAIN ? 0 : round(angle / ANGLE_GRAIN) * ANGLE_GRAIN;
    }
    if (rectangle)
        GEOSGeom_destroy_r(geos, rectangle);
    return angle;
}

kg_status kg_nest_exact_simplify(const kg_nest_exact *exact, const kg_nest_part *part,
                                 double tolerance, kg_nest_shape *out) {
    GEOSContextHandle_t geos = exact->geos;
    size_t total = 0, kept = 0;
    for (size_t k = 0; k < part->loop_count; k++)
        total += part->loops[k].count;
    kg_nest_shape shape = {malloc(total * sizeof *shape.points),
                           malloc(part->loop_count * sizeof *shape.ends), part->loop_count};
    if (!shape.points || !shape.ends) {
        free(shape.points);
        free(shape.ends);
        return KG_ERR_MEMORY;
    }
    for (size_t k = 0; k < part->loop_count; k++) {
        kg_nest_loop loop = part->loops[k];
        GEOSGeometry *line = make_ring(geos, loop, true);
        GEOSGeometry *simple = line ? GEOSSimplify_r(geos, line, tolerance) : NULL;
        const GEOSCoordSequence *seq = simple ? GEOSGeom_getCoordSeq_r(geos, simple) : NULL;
        unsigned size = 0;
        if (seq && GEOSCoordSeq_getSize_r(geos, seq, &size) && size > 2 && size <= loop.count + 1) {
            for (unsigned i = 0; i + 1 < size; i++, kept++)
                GEOSCoordSeq_getXY_r(geos, seq, i, &shape.points[kept].x, &shape.points[kept].y);
        } else {
            memcpy(shape.points + kept, loop.points, loop.count * sizeof *loop.points);
            kept += loop.count;
        }
        shape.ends[k] = kept;
        if (simple)
            GEOSGeom_destroy_r(geos, simple);
        if (line)
            GEOSGeom_destroy_r(geos, line);
    }
    *out = shape;
    return KG_OK;
}

typedef struct motion {
    double cosine, sine;
    kg_vec2 offset;
} motion;

static int move_point(double *x, double *y, void *user) {
    const motion *m = user;
    kg_vec2 p = kg_v2(*x, *y);
    *x = m->cosine * p.x - m->sine * p.y + m->offset.x;
    *y = m->sine * p.x + m->cosine * p.y + m->offset.y;
    return 1;
}

kg_status kg_nest_exact_place(kg_nest_exact *exact, size_t part, kg_nest_place place) {
    placed *p = &exact->placed[part];
    motion m = {cos(place.angle), sin(place.angle), place.offset};
    forget_placed(exact->geos, p);
    p->geometry = GEOSGeom_transformXY_r(exact->geos, exact->parts[part], move_point, &m);
    p->prepared = p->geometry ? GEOSPrepare_r(exact->geos, p->geometry) : NULL;
    if (!p->prepared || !GEOSGeom_getExtent_r(exact->geos, p->geometry, &p->box.lo.x, &p->box.lo.y,
                                              &p->box.hi.x, &p->box.hi.y)) {
        forget_placed(exact->geos, p);
        return KG_ERR_MEMORY;
    }
    return KG_OK;
}

bool kg_nest_exact_inside(const kg_nest_exact *exact, size_t part, kg_box2 box) {
    kg_box2 b = exact->placed[part].box;
    return b.lo.x >= box.lo.x - ROUNDING && b.lo.y >= box.lo.y - ROUNDING &&
           b.hi.x <= box.hi.x + ROUNDING && b.hi.y <= box.hi.y + ROUNDING;
}

static bool boxes_near(kg_box2 a, kg_box2 b, double spacing) {
    return a.lo.x < b.hi.x + spacing && b.lo.x < a.hi.x + spacing && a.lo.y < b.hi.y + spacing &&
           b.lo.y < a.hi.y + spacing;
}

static bool near(const kg_nest_exact *exact, size_t part, const GEOSGeometry *other,
                 double spacing) {
    const GEOSPreparedGeometry *prepared = exact->placed[part].prepared;
    /* Not GEOSPreparedDistanceWithin_r, which compares every pair of segments in GEOS 3.11. */
    double distance = 0;
    if (spacing > ROUNDING)
        return !GEOSPreparedDistance_r(exact->geos, prepared, other, &distance) ||
               distance < spacing - ROUNDING;
    return GEOSPreparedIntersects_r(exact->geos, prepared, other) != 0 &&
           GEOSPreparedTouches_r(exact->geos, prepared, other) != 1;
}

bool kg_nest_exact_near(const kg_nest_exact *exact, size_t a, size_t b, double spacing) {
    return boxes_near(exact->placed[a].box, exact->placed[b].box, spacing) &&
           near(exact, a, exact->placed[b].geometry, spacing);
}

bool kg_nest_exact_near_box(const kg_nest_exact *exact, size_t part, kg_box2 box, double spacing) {
    if (!boxes_near(exact->placed[part].box, box, spacing))
        return false;
    GEOSGeometry *rectangle =
        GEOSGeom_createRectangle_r(exact->geos, box.lo.x, box.lo.y, box.hi.x, box.hi.y);
    bool close = !rectangle || near(exact, part, rectangle, spacing);
    if (rectangle)
        GEOSGeom_destroy_r(exact->geos, rectangle);
    return close;
}
