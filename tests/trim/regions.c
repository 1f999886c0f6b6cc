#include "tests/trim/regions.h"

#include <geos_c.h>
#include <stdlib.h>

static double within(kg_random *r, double spread) {
    return spread > 0 ? kg_random_in(r, -spread, spread) : 0;
}

scene random_scene(kg_random *r, size_t count, kg_vec3 spread) {
    scene s = {.count = count};
    for (size_t i = 0; i < count; i++) {
        pair_kind kind = (pair_kind)(kg_random_bits(r) % PAIR_KINDS);
        kg_vec3 middle;
        middle.x = within(r, spread.x);
        middle.y = within(r, spread.y);
        middle.z = within(r, spread.z);
        s.patches[i] = random_patch(r, kind, middle);
    }
    return s;
}

void scene_clear(scene *s) {
    for (size_t i = 0; i < SCENE_MAX; i++)
        for (size_t j = 0; j < SCENE_MAX; j++)
            kg_crossings_clear(&s->crossings[i][j]);
    memset(s, 0, sizeof *s);
}

static const kg_patch *find(const void *user, int64_t id) {
    const scene *s = user;
    assert_true(id >= 1 && id <= (int64_t)s->count);
    return &s->patches[id - 1];
}

kg_patch_finder scene_finder(const scene *s) {
    return (kg_patch_finder){find, s};
}

bool scene_cut(scene *s, size_t a, size_t b, kg_cut *out) {
    size_t lo = a < b ? a : b, hi = a < b ? b : a;
    if (!s->known[lo][hi]) {
        /* both views of one computation, as a model has them */
        s->known[lo][hi] = true;
        const kg_patch *p = &s->patches[lo], *q = &s->patches[hi];
        s->coincide[lo][hi] =
            kg_crossings_find(p, q, TOLERANCE, &s->crossings[lo][hi], NULL) != KG_OK ||
            kg_crossings_find(p, q, TOLERANCE, &s->crossings[hi][lo], NULL) != KG_OK;
        kg_crossings_swap(&s->crossings[hi][lo]);
    }
    *out = (kg_cut){(int64_t)b + 1, &s->patches[b], &s->crossings[a][b], NULL};
    return !s->coincide[lo][hi];
}

kg_trim scene_trim(const scene *s, size_t a, kg_trim_notes *notes) {
    return (kg_trim){&s->patches[a], scene_finder(s), TOLERANCE, notes};
}

kg_regions whole(const scene *s, size_t a) {
    kg_regions r;
    assert_int_equal(kg_regions_rectangle(&s->patches[a], TOLERANCE, &r, NULL), KG_OK);
    return r;
}

/* ---- GEOS ------------------------------------------------------------------------------- */

static void ignore(const char *message, void *user) {
    (void)message;
    (void)user;
}

static GEOSContextHandle_t geos_begin(void) {
    GEOSContextHandle_t g = GEOS_init_r();
    GEOSContext_setNoticeMessageHandler_r(g, ignore, NULL);
    return g;
}

static GEOSCoordSequence *sequence(GEOSContextHandle_t g, const kg_patch *p, size_t count,
                                   const kg_cross_point *points, bool close) {
    GEOSCoordSequence *s = GEOSCoordSeq_create_r(g, (unsigned)(count + close), 2);
    for (size_t i = 0; i < count + close; i++) {
        const kg_cross_point *q = &points[i % count];
        GEOSCoordSeq_setXY_r(g, s, (unsigned)i, q->u, q->v * p->length_at[KG_PATCH_CELLS]);
    }
    return s;
}

static GEOSGeometry *polygon(GEOSContextHandle_t g, const kg_patch *p, const kg_region *r) {
    GEOSGeometry *rings[PIECES_MAX];
    for (size_t i = 0; i < r->loop_count; i++)
        rings[i] = GEOSGeom_createLinearRing_r(
            g, sequence(g, p, r->loops[i].point_count, r->loops[i].points, true));
    return GEOSGeom_createPolygon_r(g, rings[0], rings + 1, (unsigned)r->loop_count - 1);
}

double plane_area(const kg_patch *patch, const kg_region *region) {
    double sum = 0, length = patch->length_at[KG_PATCH_CELLS];
    for (size_t i = 0; i < region->loop_count; i++) {
        const kg_region_loop *loop = &region->loops[i];
        for (size_t k = 0; k < loop->point_count; k++) {
            const kg_cross_point *a = &loop->points[k],
                                 *b = &loop->points[(k + 1) % loop->point_count];
            sum += 0.5 * length * (a->u * b->v - b->u * a->v);
        }
    }
    return sum;
}

static int descending(const void *x, const void *y) {
    double a = *(const double *)x, b = *(const double *)y;
    return a < b ? 1 : a > b ? -1 : 0;
}

size_t areas_of(const kg_patch *patch, const kg_regions *regions, double out[PIECES_MAX]) {
    for (size_t i = 0; i < regions->count; i++)
        out[i] = plane_area(patch, &regions->items[i]);
    qsort(out, regions->count, sizeof *out, descending);
    return regions->count;
}

void lines_add(lines *l, size_t count, const kg_cross_point *points) {
    assert_true(l->count < 256);
    l->items[l->count].count = count;
    l->items[l->count++].points = points;
}

size_t pieces_by_geos(const kg_patch *patch, const kg_regions *regions, const lines *cuts,
                      double out[PIECES_MAX]) {
    GEOSContextHandle_t g = geos_begin();
    size_t count = 0;
    for (size_t i = 0; i < regions->count; i++) {
        GEOSGeometry *parts[300], *region = polygon(g, patch, &regions->items[i]);
        size_t n = 0;
        parts[n++] = GEOSBoundary_r(g, region);
        for (size_t k = 0; k < cuts->count; k++)
            parts[n++] = GEOSGeom_createLineString_r(
                g, sequence(g, patch, cuts->items[k].count, cuts->items[k].points, false));
        GEOSGeometry *all =
            GEOSGeom_createCollection_r(g, GEOS_GEOMETRYCOLLECTION, parts, (unsigned)n);
        GEOSGeometry *noded = GEOSUnaryUnion_r(g, all);
        const GEOSGeometry *list[1] = {noded};
        GEOSGeometry *faces = GEOSPolygonize_r(g, list, 1);
        for (int k = 0; k < GEOSGetNumGeometries_r(g, faces); k++) {
            const GEOSGeometry *face = GEOSGetGeometryN_r(g, faces, k);
            GEOSGeometry *inside = GEOSPointOnSurface_r(g, face);
            double area;
            GEOSArea_r(g, face, &area);
            if (GEOSContains_r(g, region, inside) && area > 1e-3) {
                assert_true(count < PIECES_MAX);
                out[count++] = area;
            }
            GEOSGeom_destroy_r(g, inside);
        }
        GEOSGeom_destroy_r(g, faces);
        GEOSGeom_destroy_r(g, noded);
        GEOSGeom_destroy_r(g, all);
        GEOSGeom_destroy_r(g, region);
    }
    GEOS_finish_r(g);
    qsort(out, count, sizeof *out, descending);
    return count;
}

/* ---- what every region must fulfil ------------------------------------------------------ */

static void check_on_source(const scene *s, const kg_patch *p, const kg_region_edge *e,
                            const kg_cross_point *at, const char *name) {
    double size = p->size;
    if (!(kg_dist(kg_patch_point(p, at->u, at->v), at->x) <= 2e-7 * size))
        fail_msg("%s: point (%g, %g) is %g off its patch", name, at->u, at->v,
                 kg_dist(kg_patch_point(p, at->u, at->v), at->x));
    if (e->kind == KG_EDGE_OUTLINE) {
        const double side[4] = {p->extent[0], p->extent[1], 0, 1};
        double off = e->source < 2 ? at->u - side[e->source] : at->v - side[e->source];
        if (!(fabs(off) <= 1.1e-7 * size))
            fail_msg("%s: a point of side %d is off it by %g", name, (int)e->source, off);
    } else if (e->kind == KG_EDGE_CUT) {
        const kg_patch *c = find(s, e->source);
        double gap = kg_dist(kg_patch_point(c, at->s, at->t), at->x);
        if (!(gap <= 1e-9 * fmax(size, c->size)))
            fail_msg("%s: a cut point (%g %g) is %g off its cutter %d", name, at->u, at->v, gap,
                     (int)e->source);
    }
}

static void check_loop(const scene *s, const kg_patch *p, const kg_region_loop *loop,
                       const char *name) {
    size_t next = 0;
    for (size_t k = 0; k < loop->edge_count; k++) {
        const kg_region_edge *e = &loop->edges[k];
        const kg_patch *cutter = e->kind == KG_EDGE_CUT ? find(s, e->source) : NULL;
        assert_int_equal(e->first, next);
        assert_true(e->count >= 1);
        next += e->count;
        for (size_t i = 0; i < e->count; i++) {
            kg_cross_point at = kg_region_edge_point(loop, e, i);
            check_on_source(s, p, e, &at, name);
            kg_cross_point mid = kg_region_edge_at(p, loop, e, cutter, i, 0.4, NULL);
            check_on_source(s, p, e, &mid, name);
        }
        kg_cross_point end = kg_region_edge_point(loop, e, e->count);
        check_on_source(s, p, e, &end, name);
        const kg_cross_point *shared = &loop->points[(e->first + e->count) % loop->point_count];
        assert_near(kg_dist(end.x, shared->x), 0, 3e-7 * p->size);
    }
    assert_int_equal(next, loop->point_count);
}

void check_regions(const scene *s, size_t a, const kg_regions *regions, const char *name) {
    const kg_patch *p = &s->patches[a];
    GEOSContextHandle_t g = geos_begin();
    for (size_t i = 0; i < regions->count; i++) {
        const kg_region *r = &regions->items[i];
        GEOSGeometry *shape = polygon(g, p, r);
        if (GEOSisValid_r(g, shape) != 1) {
            char *why = GEOSisValidReason_r(g, shape);
            fail_msg("%s: region %zu is not valid: %s", name, i, why);
        }
        GEOSGeom_destroy_r(g, shape);
        for (size_t k = 0; k < r->loop_count; k++) {
            kg_region one = {1, &r->loops[k]};
            assert_true((plane_area(p, &one) > 0) == (k == 0));
            check_loop(s, p, &r->loops[k], name);
        }
    }
    GEOS_finish_r(g);
}

kg_measure total(const scene *s, size_t a, const kg_regions *regions) {
    kg_measure sum = {0};
    for (size_t i = 0; i < regions->count; i++) {
        kg_measure m = kg_region_measure(&s->patches[a], &regions->items[i], scene_finder(s));
        sum.space_length += m.space_length;
        sum.paper_length += m.paper_length;
        sum.space_moment += m.space_moment;
        sum.paper_moment += m.paper_moment;
    }
    return sum;
}
