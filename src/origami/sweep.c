/*
 * Collisions of a fold: loops turning about an axis against loops at rest.
 *
 * In the frame of the axis a moving point (x, y, z) is at (x c - y s, x s + y c, z), c and s being
 * cosine and sine of the angle turned. Whether two convex loops cross can only change where a
 * corner of one reaches the plane of the other, or where the lines of two of their edges meet; each
 * is an equation  A c + B s + C = 0  with two roots. Between neighbouring roots one look in the
 * middle decides for all. Loops that never cross but become coplanar on the way, as leaves that
 * turn about a common line do, pass through each other there.
 */
#include "origami/folding.h"

#include "origami/convex.h"

#include <stdlib.h>

/* Radians: contact this near the start or the end is contact there; roots this near are one. */
#define SAME_ANGLE 1e-7

static const double TURN = 6.283185307179586; /* 2 π */

typedef struct solid {
    const kg_vec3 *corners; /* in the axis' frame, before turning */
    size_t count;
    kg_vec3 normal;
    double offset;
    double radius[2], height[2]; /* what it sweeps about the axis, at most */
} solid;

typedef struct sweep {
    double end;       /* angle to turn, > 0 */
    double tolerance; /* mm */
    struct {
        double *items;
        size_t count, capacity;
    } roots;
    kg_vec3 *turned; /* room for the corners of one loop */
    kg_vec2 *flat;   /* and of two, in a plane */
} sweep;

static kg_vec3 turn(kg_vec3 p, double c, double s) {
    return kg_v3(p.x * c - p.y * s, p.x * s + p.y * c, p.z);
}

/* ---- angles at which something may change ----------------------------------------------- */

/* Roots of  a cos t + b sin t + c  in (0, end). */
static bool add_roots(sweep *w, double a, double b, double c) {
    double r = hypot(a, b);
    if (r <= 1e-300 || fabs(c) > r * (1 + 1e-12))
        return true;
    double middle = atan2(b, a), half = acos(fmax(-1, fmin(1, -c / r)));
    for (int k = -1; k <= 1; k += 2) {
        double t = fmod(middle + k * half, TURN);
        if (t < 0)
            t += TURN;
        if (t > 0 && t < w->end && !kg_push(&w->roots, t))
            return false;
    }
    return true;
}

/* n · (R(t) p) = d */
static bool add_contact(sweep *w, kg_vec3 p, kg_vec3 n, double d, bool turns) {
    double side = turns ? 1 : -1; /* the plane turns instead: the point turns back */
    return add_roots(w, n.x * p.x + n.y * p.y, side * (n.y * p.x - n.x * p.y), n.z * p.z - d);
}

/* Lines p + λ d, turning, and q + μ e meet: (e × ... ) coplanar, w · R d = e · R (p × d) with
 * w = e × q taken the same way round. */
static bool add_meeting(sweep *w, kg_vec3 p, kg_vec3 d, kg_vec3 q, kg_vec3 e) {
    kg_vec3 m = kg_cross(p, d), k = kg_cross(e, q);
    return add_roots(w, k.x * d.x + k.y * d.y - e.x * m.x - e.y * m.y,
                     k.y * d.x - k.x * d.y - e.y * m.x + e.x * m.y, k.z * d.z - e.z * m.z);
}

static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static bool find_roots(sweep *w, const solid *f, const solid *g) {
    w->roots.count = 0;
    for (size_t i = 0; i < f->count; i++) {
        kg_vec3 p = f->corners[i], d = kg_sub(f->corners[(i + 1) % f->count], p);
        if (!add_contact(w, p, g->normal, g->offset, true))
            return false;
        for (size_t k = 0; k < g->count; k++) {
            kg_vec3 q = g->corners[k], e = kg_sub(g->corners[(k + 1) % g->count], q);
            if (!add_meeting(w, p, d, q, e))
                return false;
        }
    }
    for (size_t k = 0; k < g->count; k++)
        if (!add_contact(w, g->corners[k], f->normal, f->offset, false))
            return false;
    if (!kg_push(&w->roots, w->end))
        return false;
    qsort(w->roots.items, w->roots.count, sizeof *w->roots.items, compare_numbers);
    return true;
}

/* ---- one angle -------------------------------------------------------------------------- */

/* Where a polygon cuts the plane n · x = d: its stretch along `l`. False when it does not have
 * corners on both sides. */
static bool cut(const kg_vec3 *p, size_t count, kg_vec3 n, double d, kg_vec3 l, double tolerance,
                double out[2]) {
    bool above = false, below = false;
    out[0] = INFINITY, out[1] = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        kg_vec3 a = p[i], b = p[i + 1 < count ? i + 1 : 0];
        double da = kg_dot(n, a) - d, db = kg_dot(n, b) - d;
        above |= da > tolerance;
        below |= da < -tolerance;
        if ((da <= 0 && db > 0) || (da > 0 && db <= 0)) {
            double t = kg_dot(l, kg_lerp(a, b, da / (da - db)));
            out[0] = fmin(out[0], t), out[1] = fmax(out[1], t);
        }
    }
    return above && below;
}

static bool crosses(const sweep *w, const solid *f, const solid *g, double angle) {
    double c = cos(angle), s = sin(angle), x[2], y[2];
    for (size_t i = 0; i < f->count; i++)
        w->turned[i] = turn(f->corners[i], c, s);
    kg_vec3 n = turn(f->normal, c, s), l = kg_cross(n, g->normal);
    double length = kg_len(l);
    if (length < KG_ON_PLANE)
        return false;
    l = kg_scale(l, 1 / length);
    return cut(w->turned, f->count, g->normal, g->offset, l, w->tolerance, x) &&
           cut(g->corners, g->count, n, f->offset, l, w->tolerance, y) &&
           fmin(x[1], y[1]) - fmax(x[0], y[0]) > w->tolerance;
}

/* In one plane, and overlapping there. */
static bool coincides(const sweep *w, const solid *f, const solid *g, double angle) {
    double c = cos(angle), s = sin(angle);
    kg_vec3 n = turn(f->normal, c, s), u, v;
    if (kg_len(kg_cross(n, g->normal)) > SAME_ANGLE)
        return false;
    kg_plane_axes(g->normal, &u, &v);
    kg_vec2 *p = w->flat, *q = p + f->count;
    bool turned = kg_dot(n, g->normal) < 0;
    for (size_t i = 0; i < f->count; i++) {
        kg_vec3 a = turn(f->corners[i], c, s);
        if (fabs(kg_dot(g->normal, a) - g->offset) > w->tolerance)
            return false;
        p[turned ? f->count - 1 - i : i] = kg_v2(kg_dot(u, a), kg_dot(v, a));
    }
    for (size_t i = 0; i < g->count; i++)
        q[i] = kg_v2(kg_dot(u, g->corners[i]), kg_dot(v, g->corners[i]));
    return kg_convex_overlap(p, f->count, q, g->count, w->tolerance);
}

/* The first angle at which two loops pass through each other; negative when they do not. */
static kg_status first_contact(sweep *w, const solid *f, const solid *g, double *out_angle) {
    *out_angle = -1;
    if (!find_roots(w, f, g))
        return KG_ERR_MEMORY;
    double from = 0;
    for (size_t i = 0; i < w->roots.count; i++) {
        double to = w->roots.items[i];
        if (to - from > SAME_ANGLE) {
            if (crosses(w, f, g, (from + to) / 2)) {
                *out_angle = from;
                return KG_OK;
            }
            from = to;
        }
        if (to > SAME_ANGLE && to < w->end - SAME_ANGLE && coincides(w, f, g, to)) {
            *out_angle = to;
            return KG_OK;
        }
    }
    return KG_OK;
}

/* ---- all loops -------------------------------------------------------------------------- */

static double distance_to_segment(kg_vec2 a, kg_vec2 b) {
    kg_vec2 d = kg_sub2(b, a);
    double n = kg_dot2(d, d), t = n > 0 ? fmax(0, fmin(1, -kg_dot2(a, d) / n)) : 0;
    return kg_len2(kg_lerp2(a, b, t));
}

/* Fills in normal and reach; the least radius is 0 when the axis pierces the loop. */
static void measure(solid *f) {
    kg_vec3 sum = kg_v3(0, 0, 0);
    for (size_t i = 1; i + 1 < f->count; i++)
        sum = kg_add(sum, kg_cross(kg_sub(f->corners[i], f->corners[0]),
                                   kg_sub(f->corners[i + 1], f->corners[0])));
    f->normal = kg_unit(sum);
    f->offset = kg_dot(f->normal, f->corners[0]);
    f->radius[0] = f->height[0] = INFINITY;
    f->radius[1] = f->height[1] = -INFINITY;
    bool left = false, right = false;
    for (size_t i = 0; i < f->count; i++) {
        kg_vec3 p = f->corners[i], q = f->corners[(i + 1) % f->count];
        kg_vec2 a = kg_v2(p.x, p.y), b = kg_v2(q.x, q.y);
        f->radius[0] = fmin(f->radius[0], distance_to_segment(a, b));
        f->radius[1] = fmax(f->radius[1], kg_len2(a));
        f->height[0] = fmin(f->height[0], p.z);
        f->height[1] = fmax(f->height[1], p.z);
        left |= kg_cross2(a, b) > 0;
        right |= kg_cross2(a, b) < 0;
    }
    if (!(left && right))
        f->radius[0] = 0;
}

static bool ranges_meet(const double a[2], const double b[2], double tolerance) {
    return a[0] < b[1] - tolerance && b[0] < a[1] - tolerance;
}

/* All loops in the frame of the axis; mirrored when it turns the other way. */
static kg_vec3 *place(const kg_origami_state *s, const kg_fold_axis *a, solid *solids) {
    kg_vec3 *corners = malloc((s->halves.count + 1) * sizeof *corners);
    size_t n = 0;
    double turn_sign = a->angle > 0 ? 1 : -1;
    for (size_t i = 0; corners && i < s->loops.count; i++) {
        solids[i].corners = corners + n;
        int32_t first = s->loops.items[i].first, h = first;
        do {
            kg_vec3 r = kg_sub(*kg_origin(s, h), a->origin);
            corners[n++] = kg_v3(kg_dot(r, a->side), turn_sign * kg_dot(r, a->normal),
                                 turn_sign * kg_dot(r, a->axis));
        } while ((h = kg_next(s, h)) != first);
        solids[i].count = (size_t)(corners + n - solids[i].corners);
        measure(&solids[i]);
    }
    return corners;
}

kg_status kg_sweep(const kg_origami_state *s, const kg_fold_axis *a, const bool *moves,
                   bool *out_collides, kg_collision *out_collision) {
    /* in the fold's own plane loops part at the start and meet at the end, if at all */
    size_t own_count = 0;
    for (size_t i = 0; i < s->loops.count; i++)
        own_count += s->loops.items[i].group == a->group;
    *out_collides = false;
    if (own_count == s->loops.count)
        return KG_OK;
    sweep w = {.end = fabs(a->angle), .tolerance = s->touch};
    solid *solids = calloc(s->loops.count + 1, sizeof *solids);
    kg_vec3 *corners = solids ? place(s, a, solids) : NULL;
    size_t most = 0;
    for (size_t i = 0; i < s->loops.count && corners; i++)
        most = solids[i].count > most ? solids[i].count : most;
    w.turned = malloc((most + 1) * sizeof *w.turned);
    w.flat = malloc((2 * most + 1) * sizeof *w.flat);
    kg_status status = corners && w.turned && w.flat ? KG_OK : KG_ERR_MEMORY;
    kg_collision first = {-1, -1, INFINITY};
    for (size_t i = 0; i < s->loops.count && !status; i++)
        for (size_t k = 0; k < s->loops.count && !status && moves[i]; k++) {
            bool own = s->loops.items[i].group == a->group && s->loops.items[k].group == a->group;
            double angle;
            if (moves[k] || own || !ranges_meet(solids[i].radius, solids[k].radius, w.tolerance) ||
                !ranges_meet(solids[i].height, solids[k].height, -w.tolerance))
                continue;
            status = first_contact(&w, &solids[i], &solids[k], &angle);
            if (!status && angle >= 0 && angle < first.angle)
                first = (kg_collision){(int32_t)i, (int32_t)k, angle};
        }
    free(w.roots.items);
    free(w.turned);
    free(w.flat);
    free(corners);
    free(solids);
    if (status)
        return status;
    *out_collides = first.moving >= 0;
    if (*out_collides)
        *out_collision = first;
    return KG_OK;
}
