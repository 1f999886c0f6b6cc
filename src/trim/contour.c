/* Contours drawn by hand in (u,v). */
#include "katagami/trim.h"

#include "base/array.h"
#include "base/phrase.h"
#include "trim/region.h"

#include <stdlib.h>

/* A contour without repeated corners, in the plane (u, v L). */
typedef struct contour {
    const kg_patch *patch;
    kg_vec2 *corners;
    size_t count;
    double snap;
} contour;

static double point_to_side(kg_vec2 p, kg_vec2 a, kg_vec2 b) {
    return kg_dist2(p, kg_lerp2(a, b, kg_nearest_fraction(p, a, b)));
}

/* Do two sides without a common corner cross or come within the snap distance? */
static bool sides_meet(const contour *c, size_t i, size_t j) {
    kg_vec2 a = c->corners[i], b = c->corners[(i + 1) % c->count];
    kg_vec2 p = c->corners[j], q = c->corners[(j + 1) % c->count];
    if (fmin(a.x, b.x) > fmax(p.x, q.x) + c->snap || fmin(p.x, q.x) > fmax(a.x, b.x) + c->snap ||
        fmin(a.y, b.y) > fmax(p.y, q.y) + c->snap || fmin(p.y, q.y) > fmax(a.y, b.y) + c->snap)
        return false;
    kg_vec2 ab = kg_sub2(b, a), pq = kg_sub2(q, p);
    bool across = (kg_cross2(ab, kg_sub2(p, a)) > 0) != (kg_cross2(ab, kg_sub2(q, a)) > 0) &&
                  (kg_cross2(pq, kg_sub2(a, p)) > 0) != (kg_cross2(pq, kg_sub2(b, p)) > 0);
    return across || point_to_side(a, p, q) <= c->snap || point_to_side(b, p, q) <= c->snap ||
           point_to_side(p, a, b) <= c->snap || point_to_side(q, a, b) <= c->snap;
}

static kg_status fail_crossing(size_t i, size_t j, kg_error *error) {
    return kg_fail(error, KG_ERR_INPUT,
                   "its contour crosses or touches itself (sides %zu and %zu); move its corners",
                   i + 1, j + 1);
}

static kg_status check_shape(const contour *c, kg_error *error) {
    double area = 0, length = 0;
    size_t n = c->count;
    for (size_t i = 0; i < n; i++) {
        kg_vec2 a = kg_sub2(c->corners[i], c->corners[0]),
                b = kg_sub2(c->corners[(i + 1) % n], c->corners[0]);
        area += 0.5 * kg_cross2(a, b);
        length += kg_dist2(a, b);
    }
    if (n < 3 || !(fabs(area) > KG_SLIVER * c->patch->size * length))
        return kg_fail(error, KG_ERR_INPUT, "its contour encloses no area; move its corners apart");
    for (size_t i = 0; i < n; i++) {
        /* neighbours meet in their corner and nowhere else */
        size_t next = (i + 1) % n;
        kg_vec2 a = c->corners[i], b = c->corners[next], d = c->corners[(next + 1) % n];
        if (point_to_side(d, a, b) <= c->snap || point_to_side(a, b, d) <= c->snap)
            return fail_crossing(i, next, error);
        for (size_t j = i + 2; j < n; j++)
            if (!(i == 0 && j == n - 1) && sides_meet(c, i, j))
                return fail_crossing(i, j, error);
    }
    return KG_OK;
}

static kg_status make_contour(const kg_patch *patch, const kg_vec2 *polygon, size_t n, contour *out,
                              kg_error *error) {
    contour c = {.patch = patch, .snap = KG_NODE_SNAP * patch->size};
    if (n < 3)
        return kg_fail(error, KG_ERR_INPUT, "its contour has %zu corners; draw at least 3", n);
    c.corners = calloc(n, sizeof *c.corners);
    if (!c.corners)
        return KG_ERR_MEMORY;
    for (size_t i = 0; i < n; i++) {
        if (!(fabs(polygon[i].x) <= KG_MAX_COORDINATE && fabs(polygon[i].y) <= KG_MAX_COORDINATE)) {
            free(c.corners);
            return kg_fail(error, KG_ERR_INPUT, "corner %zu of its contour is beyond 1e6", i + 1);
        }
        kg_vec2 at = kg_plane(patch, polygon[i].x, polygon[i].y);
        if (c.count == 0 || kg_dist2(c.corners[c.count - 1], at) > c.snap)
            c.corners[c.count++] = at;
    }
    while (c.count > 1 && kg_dist2(c.corners[c.count - 1], c.corners[0]) <= c.snap)
        c.count--;
    kg_status status = check_shape(&c, error);
    if (status) {
        free(c.corners);
        return status;
    }
    *out = c;
    return KG_OK;
}

/* The stretch [f0, f1] of a side inside the rectangle and a little around it, where alone points
 * are worth sampling (Liang and Barsky's clipping); false if there is none. */
static bool clip_side(const kg_patch *p, kg_vec2 a, kg_vec2 b, double *f0, double *f1) {
    const double around = 1e-3;
    double lo[2] = {p->extent[0] - around * p->size, -around};
    double hi[2] = {p->extent[1] + around * p->size, 1 + around};
    double from[2] = {a.x, a.y}, step[2] = {b.x - a.x, b.y - a.y};
    *f0 = 0, *f1 = 1;
    for (int k = 0; k < 2; k++) {
        if (step[k] == 0) {
            if (from[k] < lo[k] || from[k] > hi[k])
                return false;
            continue;
        }
        double x = (lo[k] - from[k]) / step[k], y = (hi[k] - from[k]) / step[k];
        *f0 = fmax(*f0, fmin(x, y));
        *f1 = fmin(*f1, fmax(x, y));
    }
    return *f0 < *f1;
}

/* A point beyond the rectangle; where it is in space is of no use. */
static kg_status push_outside(kg_points *points, kg_vec2 uv) {
    kg_cross_point p = {.u = uv.x, .v = uv.y};
    return kg_push(points, p) ? KG_OK : KG_ERR_MEMORY;
}

static kg_status sample_side(const kg_trim *t, kg_vec2 a, kg_vec2 b, kg_points *points) {
    double f0, f1;
    if (!clip_side(t->patch, a, b, &f0, &f1))
        return push_outside(points, a);
    kg_vec2 from = f0 > 0 ? kg_lerp2(a, b, f0) : a, to = f1 < 1 ? kg_lerp2(a, b, f1) : b;
    kg_status status = f0 > 0 ? push_outside(points, a) : KG_OK;
    if (!status)
        status = kg_sample_straight(t->patch, from, to, t->tolerance, points);
    return status || f1 == 1 ? status : push_outside(points, to);
}

static kg_status contour_chain(const kg_trim *t, const contour *c, int64_t source,
                               kg_chains *chains) {
    kg_points points = {0};
    kg_status status = KG_OK;
    double length = t->patch->length_at[KG_PATCH_CELLS];
    for (size_t i = 0; i < c->count && !status; i++) {
        kg_vec2 a = c->corners[i], b = c->corners[(i + 1) % c->count];
        status = sample_side(t, kg_v2(a.x, a.y / length), kg_v2(b.x, b.y / length), &points);
    }
    kg_cross_point first = status ? (kg_cross_point){0} : points.items[0];
    if (!status && !kg_push(&points, first))
        status = KG_ERR_MEMORY;
    if (status) {
        free(points.items);
        return status;
    }
    return kg_chains_add(chains, (kg_chain){.kind = KG_EDGE_CONTOUR,
                                            .source = source,
                                            .labels = KG_LABEL_CONTOUR,
                                            .closed = true,
                                            .count = points.count,
                                            .points = points.items});
}

static bool on_wanted_side(const kg_arrangement *a, size_t face, const void *user) {
    const bool *inside = user;
    return ((a->labels[face] & KG_LABEL_CONTOUR) != 0) == *inside;
}

kg_status kg_trim_contour(const kg_trim *trim, const kg_regions *regions, const kg_vec2 *polygon,
                          size_t corner_count, bool inside, int64_t source, kg_regions *out_regions,
                          kg_error *error) {
    kg_regions pieces = {0};
    contour c = {0};
    kg_status status = make_contour(trim->patch, polygon, corner_count, &c, error);
    for (size_t i = 0; i < regions->count && !status; i++) {
        kg_chains chains = {0};
        kg_arrangement a = {0};
        status = kg_region_chains(&regions->items[i], trim->finder, &chains);
        if (!status)
            status = contour_chain(trim, &c, source, &chains);
        if (!status)
            status = kg_arrangement_build(trim->patch, &chains, &a);
        if (!status)
            status = kg_regions_from_faces(&a, on_wanted_side, &inside, &pieces);
        kg_arrangement_clear(&a);
        kg_chains_clear(&chains);
    }
    free(c.corners);
    if (!status && pieces.count == 0)
        status = kg_fail(error, KG_ERR_INPUT,
                         inside ? N_("its contour lies wholly outside what is left of it")
                                : N_("its contour takes away all that is left of it"));
    return kg_trim_finish(status, &pieces, out_regions, error);
}
