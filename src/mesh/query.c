/*
 * Rays and closest points. Embree finds the triangles to look at; it works in single precision, so
 * its tree holds boxes of ours (a "user geometry") that are a little larger than the triangles, and
 * each triangle it names is met in double precision here. The answers are therefore those of a
 * search through all triangles, which the tests check.
 *
 * Everything happens in coordinates scaled by a power of two (which is exact) and moved so that the
 * mesh lies in the box [-1,1]³; single precision is then good to 1e-7.
 */
#include "katagami/mesh.h"

#include "base/progress.h"
#include "base/signals.h"

#include <embree3/rtcore.h>

#include <stdlib.h>
#include <string.h>

/* How much larger boxes and search radii are than they need be, in the scaled coordinates: more
 * than the errors of coordinates, directions and distances in single precision, about 4e-7. */
#define SLACK 2e-6

/* Points further away than this many sizes of the mesh meet every triangle: single precision could
 * not tell its boxes apart. */
#define FAR_AWAY 1e3

struct kg_mesh_query {
    RTCDevice device;
    RTCScene scene;
    kg_vec3 center;
    double scale; /* scaled = (mesh - centre) × scale */
    kg_box3 box;  /* scaled */
    size_t triangle_count;
    kg_vec3 *corners; /* scaled, 3 per triangle */
    uint32_t *faces;  /* of each triangle */
};

/* ---- one triangle ---------------------------------------------------------------------- */

typedef struct best {
    double distance; /* scaled; squared for closest points */
    size_t triangle;
    kg_vec3 point; /* scaled */
} best;

/* Keeps the nearer one, of two equally near the earlier one whatever the order they come in. */
static void improve(best *b, double distance, size_t triangle, kg_vec3 point) {
    if (distance < b->distance || (distance == b->distance && triangle < b->triangle))
        *b = (best){distance, triangle, point};
}

/* A ray and the shear that lays it along the third axis, its largest, through the origin: point p
 * goes to (p[x] - p[z] shear_x, p[y] - p[z] shear_y). */
typedef struct ray_line {
    kg_vec3 origin, direction;
    int x, y, z;
    double shear_x, shear_y;
} ray_line;

static ray_line line_of(kg_vec3 origin, kg_vec3 direction) {
    double d[3] = {direction.x, direction.y, direction.z};
    int z = fabs(d[0]) > fabs(d[1]) ? 0 : 1;
    z = fabs(d[2]) > fabs(d[z]) ? 2 : z;
    int x = (z + 1) % 3, y = (z + 2) % 3;
    return (ray_line){origin, direction, x, y, z, d[x] / d[z], d[y] / d[z]};
}

static kg_vec2 shear(const ray_line *ray, kg_vec3 p) {
    kg_vec3 away = kg_sub(p, ray->origin);
    double a[3] = {away.x, away.y, away.z};
    return kg_v2(a[ray->x] - a[ray->z] * ray->shear_x, a[ray->y] - a[ray->z] * ray->shear_y);
}

/* S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection", Journal of Computer
 * Graphics Techniques 2 (2013), 65-82. Neighbours see the same sheared corners, and the sign of a
 * cross product of theirs, the difference of two rounded products, is right or zero: no ray slips
 * between them, neither at an edge nor at a corner. */
static void meet_ray(best *b, const kg_mesh_query *q, size_t triangle, const ray_line *ray) {
    const kg_vec3 *p = q->corners + 3 * triangle;
    kg_vec2 s0 = shear(ray, p[0]), s1 = shear(ray, p[1]), s2 = shear(ray, p[2]);
    double w0 = kg_cross2(s1, s2), w1 = kg_cross2(s2, s0), w2 = kg_cross2(s0, s1);
    double sum = w0 + w1 + w2;
    bool front = w0 >= 0 && w1 >= 0 && w2 >= 0, back = w0 <= 0 && w1 <= 0 && w2 <= 0;
    if (!(front || back) || sum == 0)
        return;
    kg_vec3 point = kg_madd(kg_madd(kg_scale(p[0], w0 / sum), w1 / sum, p[1]), w2 / sum, p[2]);
    double distance = kg_dot(kg_sub(point, ray->origin), ray->direction);
    if (distance >= 0)
        improve(b, distance, triangle, point);
}

static void meet_segment(best *b, size_t triangle, kg_vec3 p, kg_vec3 from, kg_vec3 to) {
    kg_vec3 d = kg_sub(to, from);
    double length2 = kg_dot(d, d);
    double t = length2 > 0 ? kg_dot(kg_sub(p, from), d) / length2 : 0;
    kg_vec3 point = t <= 0 ? from : t >= 1 ? to : kg_madd(from, t, d);
    kg_vec3 away = kg_sub(p, point);
    improve(b, kg_dot(away, away), triangle, point);
}

/* The foot of the perpendicular when it is inside, else the nearest point of the three sides. */
static void meet_point(best *b, const kg_mesh_query *q, size_t triangle, kg_vec3 p) {
    const kg_vec3 *c = q->corners + 3 * triangle;
    kg_vec3 n = kg_cross(kg_sub(c[1], c[0]), kg_sub(c[2], c[0]));
    bool inside = kg_dot(n, n) > 0;
    for (int i = 0; i < 3 && inside; i++) {
        kg_vec3 from = c[i], to = c[(i + 1) % 3];
        inside = kg_det(n, kg_sub(to, from), kg_sub(p, from)) >= 0;
    }
    if (inside) {
        double height = kg_dot(kg_sub(p, c[0]), n) / kg_dot(n, n);
        kg_vec3 away = kg_scale(n, height);
        improve(b, kg_dot(away, away), triangle, kg_sub(p, away));
        return;
    }
    for (int i = 0; i < 3; i++)
        meet_segment(b, triangle, p, c[i], c[(i + 1) % 3]);
}

/* ---- Embree's callbacks ---------------------------------------------------------------- */

static void bound_triangle(const struct RTCBoundsFunctionArguments *args) {
    const kg_mesh_query *q = args->geometryUserPtr;
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < 3; i++)
        kg_box3_add(&box, q->corners[3 * (size_t)args->primID + i]);
    *args->bounds_o = (struct RTCBounds){
        .lower_x = (float)(box.lo.x - SLACK),
        .upper_x = (float)(box.hi.x + SLACK),
        .lower_y = (float)(box.lo.y - SLACK),
        .upper_y = (float)(box.hi.y + SLACK),
        .lower_z = (float)(box.lo.z - SLACK),
        .upper_z = (float)(box.hi.z + SLACK),
    };
}

/* What a ray carries through Embree: the context comes first, as Embree hands it back. */
typedef struct ray_search {
    struct RTCIntersectContext context;
    const kg_mesh_query *query;
    ray_line line;
    best found;
} ray_search;

static void intersect_triangle(const struct RTCIntersectFunctionNArguments *args) {
    ray_search *s = (ray_search *)args->context;
    if (args->N != 1 || !args->valid[0])
        return;
    meet_ray(&s->found, s->query, args->primID, &s->line);
    /* Boxes behind the hit need no visit; ties do. */
    struct RTCRayHit *ray = (struct RTCRayHit *)args->rayhit;
    float reach = (float)(s->found.distance + SLACK);
    if (reach < ray->ray.tfar)
        ray->ray.tfar = reach;
}

typedef struct point_search {
    const kg_mesh_query *query;
    kg_vec3 point;
    best found;
} point_search;

static bool approach_triangle(struct RTCPointQueryFunctionArguments *args) {
    point_search *s = args->userPtr;
    double before = s->found.distance;
    meet_point(&s->found, s->query, args->primID, s->point);
    if (!(s->found.distance < before))
        return false;
    double distance = sqrt(s->found.distance);
    args->query->radius = (float)(distance * (1 + SLACK) + SLACK);
    return true;
}

/* ---- questions ------------------------------------------------------------------------- */

static kg_vec3 scaled(const kg_mesh_query *q, kg_vec3 p) {
    return kg_scale(kg_sub(p, q->center), q->scale);
}

static bool answer(const kg_mesh_query *q, const best *found, double distance,
                   kg_mesh_hit *out_hit) {
    if (found->triangle == SIZE_MAX || !isfinite(distance))
        return false;
    const kg_vec3 *c = q->corners + 3 * found->triangle;
    *out_hit = (kg_mesh_hit){
        .distance = distance / q->scale,
        .face = q->faces[found->triangle],
        .point = kg_add(kg_scale(found->point, 1 / q->scale), q->center),
        .normal = kg_unit(kg_cross(kg_sub(c[1], c[0]), kg_sub(c[2], c[0]))),
    };
    return true;
}

/* Where the ray enters the box grown by `margin`; false when it passes by. */
static bool enter_box(kg_box3 box, double margin, kg_vec3 origin, kg_vec3 direction,
                      double *out_enter) {
    double o[3] = {origin.x, origin.y, origin.z}, d[3] = {direction.x, direction.y, direction.z};
    double lo[3] = {box.lo.x, box.lo.y, box.lo.z}, hi[3] = {box.hi.x, box.hi.y, box.hi.z};
    double enter = 0, leave = INFINITY;
    for (int i = 0; i < 3; i++) {
        double to_lo = lo[i] - margin - o[i], to_hi = hi[i] + margin - o[i];
        if (d[i] == 0) {
            if (to_lo > 0 || to_hi < 0)
                return false;
            continue;
        }
        double t0 = to_lo / d[i], t1 = to_hi / d[i];
        enter = fmax(enter, fmin(t0, t1));
        leave = fmin(leave, fmax(t0, t1));
    }
    *out_enter = enter;
    return enter <= leave;
}

bool kg_mesh_query_ray(const kg_mesh_query *q, kg_vec3 origin, kg_vec3 direction,
                       kg_mesh_hit *out_hit) {
    kg_vec3 d = kg_unit(direction), o = scaled(q, origin);
    double enter;
    /* Started at the box, however far away the origin is, the ray is as exact as the tree. */
    if (!(kg_len(d) > 0.5) || !isfinite(kg_len(o)) || !enter_box(q->box, 1e-3, o, d, &enter))
        return false;
    o = kg_madd(o, enter, d);
    ray_search s = {.query = q, .line = line_of(o, d)};
    s.found = (best){INFINITY, SIZE_MAX, {0, 0, 0}};
    rtcInitIntersectContext(&s.context);
    struct RTCRayHit ray = {
        .ray = {.org_x = (float)o.x,
                .org_y = (float)o.y,
                .org_z = (float)o.z,
                .dir_x = (float)d.x,
                .dir_y = (float)d.y,
                .dir_z = (float)d.z,
                .tfar = INFINITY,
                .mask = UINT32_MAX},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .instID = {RTC_INVALID_GEOMETRY_ID}},
    };
    rtcIntersect1(q->scene, &s.context, &ray);
    return answer(q, &s.found, enter + s.found.distance, out_hit);
}

bool kg_mesh_query_closest(const kg_mesh_query *q, kg_vec3 point, kg_mesh_hit *out_hit) {
    point_search s = {.query = q, .point = scaled(q, point)};
    s.found = (best){INFINITY, SIZE_MAX, {0, 0, 0}};
    if (!(kg_len(s.point) < FAR_AWAY)) {
        for (size_t i = 0; i < q->triangle_count; i++)
            meet_point(&s.found, q, i, s.point);
    } else {
        struct RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        struct RTCPointQuery query = {.x = (float)s.point.x,
                                      .y = (float)s.point.y,
                                      .z = (float)s.point.z,
                                      .radius = INFINITY};
        rtcPointQuery(q->scene, &query, &context, approach_triangle, &s);
    }
    return answer(q, &s.found, sqrt(s.found.distance), out_hit);
}

/* ---- making ---------------------------------------------------------------------------- */

void kg_mesh_query_destroy(kg_mesh_query *q) {
    if (!q)
        return;
    sigset_t before;
    kg_signals_hold(&before); /* Embree may begin a thread that stays, here and when it builds */
    if (q->scene)
        rtcReleaseScene(q->scene);
    if (q->device)
        rtcReleaseDevice(q->device);
    kg_signals_release(&before);
    free(q->corners);
    free(q->faces);
    free(q);
}

static kg_status scale_to_unit(kg_mesh_query *q, const kg_mesh *mesh, kg_error *error) {
    kg_box3 box = kg_mesh_bounds(mesh);
    kg_vec3 sides = kg_sub(box.hi, box.lo);
    double longest = fmax(sides.x, fmax(sides.y, sides.z));
    if (!mesh->face_count)
        return kg_fail(error, KG_ERR_INPUT, "the mesh has no faces to look for");
    if (!isfinite(longest))
        return kg_fail(error, KG_ERR_INPUT, "the mesh is too large to look for its points");
    int exponent = 0;
    if (longest > 0)
        frexp(longest, &exponent); /* longest < 2^exponent */
    q->scale = ldexp(1, exponent > -1000 ? 1 - exponent : 1000);
    q->center = kg_lerp(box.lo, box.hi, 0.5);
    q->box.lo = scaled(q, box.lo);
    q->box.hi = scaled(q, box.hi);
    return KG_OK;
}

static kg_status copy_triangles(kg_mesh_query *q, const kg_mesh *mesh, kg_error *error) {
    q->triangle_count = kg_mesh_triangle_count(mesh);
    uint32_t *indices = malloc(3 * q->triangle_count * sizeof *indices);
    q->corners = malloc(3 * q->triangle_count * sizeof *q->corners);
    q->faces = malloc(q->triangle_count * sizeof *q->faces);
    kg_status status = KG_OK;
    if (!indices || !q->corners || !q->faces)
        status = kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for its search tree");
    else
        status = kg_mesh_triangulate(mesh, indices, q->faces, error);
    for (size_t i = 0; !status && i < 3 * q->triangle_count; i++)
        q->corners[i] = scaled(q, mesh->positions[indices[i]]);
    free(indices);
    return status;
}

/* Share of the work that copying the triangles is; the rest is the tree. */
#define COPYING_SHARE 0.1

typedef struct building {
    const kg_progress *progress;
    kg_status status;
    kg_error *error;
} building;

/* Embree's: false ends the work. */
static bool go_on(void *user, double fraction) {
    building *b = user;
    double whole = COPYING_SHARE + (1 - COPYING_SHARE) * fmin(fmax(fraction, 0), 1);
    if (!b->status)
        b->status = kg_progress_tell(b->progress, whole, "search tree", b->error);
    return !b->status;
}

static kg_status build_tree(kg_mesh_query *q, const kg_progress *progress, kg_error *error) {
    building b = {progress, KG_OK, error};
    q->device = rtcNewDevice("threads=1,set_affinity=0");
    if (!q->device)
        return kg_fail(error, KG_ERR_SYSTEM, "Embree does not start on this machine (error %d)",
                       (int)rtcGetDeviceError(NULL));
    q->scene = rtcNewScene(q->device);
    RTCGeometry geometry = rtcNewGeometry(q->device, RTC_GEOMETRY_TYPE_USER);
    if (q->scene && geometry) {
        rtcSetSceneFlags(q->scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)q->triangle_count);
        rtcSetGeometryUserData(geometry, q);
        rtcSetGeometryBoundsFunction(geometry, bound_triangle, NULL);
        rtcSetGeometryIntersectFunction(geometry, intersect_triangle);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(q->scene, geometry);
        rtcSetSceneProgressMonitorFunction(q->scene, go_on, &b);
        rtcCommitScene(q->scene);
        rtcSetSceneProgressMonitorFunction(q->scene, NULL, NULL);
    }
    if (geometry)
        rtcReleaseGeometry(geometry);
    bool failed = rtcGetDeviceError(q->device) != RTC_ERROR_NONE;
    if (b.status)
        return b.status;
    if (failed)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: no search tree could be made of it");
    return KG_OK;
}

static kg_status build_holding(kg_mesh_query *q, const kg_progress *progress, kg_error *error) {
    sigset_t before;
    kg_signals_hold(&before);
    kg_status status = build_tree(q, progress, error);
    kg_signals_release(&before);
    return status;
}

kg_status kg_mesh_query_create(const kg_mesh *mesh, const kg_progress *progress,
                               kg_mesh_query **out_query, kg_error *error) {
    kg_mesh_query *q = calloc(1, sizeof *q);
    if (!q)
        return kg_fail(error, KG_ERR_MEMORY, "mesh: out of memory for its search tree");
    kg_status status = scale_to_unit(q, mesh, error);
    if (!status)
        status = copy_triangles(q, mesh, error);
    if (!status)
        status = kg_progress_tell(progress, COPYING_SHARE, "search tree", error);
    if (!status)
        status = build_holding(q, progress, error);
    if (status) {
        kg_mesh_query_destroy(q);
        return status;
    }
    *out_query = q;
    return KG_OK;
}
