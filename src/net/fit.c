#include "net/fit.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

/* Shares of the tolerance. The polyline's chords take a fifth, rounding to four decimals and the
 * sampling of the check a little; a stretch that strays this little from a line is one. */
#define FIT_SHARE 0.75
#define CHORD_SHARE 0.2
#define COLLINEAR_SHARE 1e-3

/* Smooth points nearer to each other than this say little about the curve, and noise in them much
 * too much about its direction. */
#define DISTINCT_SHARE 0.04

/* A chord is straight when, bent as its neighbours bend, it would leave the true curve by this many
 * times what its maker promises. */
#define STRAIGHT_FACTOR 5.0

/* Radians one cubic may turn: more it can rarely follow, and this keeps it free of loops. */
#define GREATEST_TURN 2.4

#define ITERATIONS 8

/* Knots that are enough to find two handle lengths. */
#define SAMPLES 16

typedef struct knot {
    kg_vec2 p;
    bool corner; /* the direction breaks */
    bool breaks; /* a section ends: at a corner, or where a straight chord begins or ends */
    double s;    /* length of the polyline up to here */
    double turn; /* sum of |turning angles| up to and with this knot; breaks count nothing */
} knot;

typedef struct fit {
    knot *items;
    size_t count, capacity;
    bool loops; /* closed without any break: the last knot is the first again */
    double tolerance, fit_tolerance;
    double *t; /* scratch: parameter per knot */
    kg_path *path;
} fit;

static double turn_between(kg_vec2 a, kg_vec2 b) {
    return atan2(kg_cross2(a, b), kg_dot2(a, b));
}

static kg_vec2 chord(const fit *f, size_t i) {
    return kg_sub2(f->items[i + 1].p, f->items[i].p);
}

static double chord_length(const fit *f, size_t i) {
    return kg_len2(chord(f, i));
}

static double unit_clamp(double t) {
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

static double segment_distance(kg_vec2 p, kg_vec2 a, kg_vec2 b) {
    kg_vec2 ab = kg_sub2(b, a), ap = kg_sub2(p, a);
    double len2 = kg_dot2(ab, ab), t = len2 > 0 ? kg_dot2(ap, ab) / len2 : 0;
    return kg_dist2(p, kg_add2(a, kg_scale2(ab, unit_clamp(t))));
}

/* ---- preparing the knots ------------------------------------------------------------------ */

static bool knots_too_near(const fit *f, const knot *a, const knot *b) {
    double share = a->corner && b->corner ? COLLINEAR_SHARE : DISTINCT_SHARE;
    return kg_dist2(a->p, b->p) <= share * f->tolerance;
}

/* Knots at distinct places. Of two points too near to each other a corner stays. */
static bool knots_distinct(fit *f, const kg_vec2 *points, const unsigned char *corners,
                           size_t count, bool closed) {
    for (size_t i = 0; i < count; i++) {
        bool corner = !corners || corners[i] != 0 || (!closed && (i == 0 || i + 1 == count));
        knot next = {.p = points[i], .corner = corner};
        knot *last = f->count > 0 ? &f->items[f->count - 1] : NULL;
        if (!last || !knots_too_near(f, last, &next)) {
            if (!kg_push(f, next))
                return false;
        } else if (corner) {
            *last = next;
        }
    }
    while (closed && f->count > 1 && knots_too_near(f, &f->items[0], &f->items[f->count - 1])) {
        if (f->items[f->count - 1].corner)
            f->items[0] = f->items[f->count - 1];
        f->count--;
    }
    return true;
}

/* Drops knots that lie on the line through their neighbours, so that a straight stretch is one
 * chord. From the last kept knot every one passed over leaves a wedge of directions a chord may
 * take; a knot outside it, or nearer than the one before, ends the chord. */
static void knots_merge_collinear(fit *f) {
    double least = COLLINEAR_SHARE * f->tolerance;
    size_t kept = 1;
    for (size_t i = 1; i < f->count;) {
        kg_vec2 from = f->items[kept - 1].p, axis = kg_sub2(f->items[i].p, from);
        double lo = -INFINITY, hi = INFINITY, reach = 0;
        size_t end = i;
        for (size_t j = i; j < f->count; j++) {
            kg_vec2 d = kg_sub2(f->items[j].p, from);
            double along = kg_dot2(d, axis), slope = kg_cross2(axis, d) / along;
            if (!(along > reach) || slope < lo || slope > hi)
                break;
            end = j;
            if (f->items[j].corner)
                break;
            double spread = least * kg_len2(axis) / along;
            lo = fmax(lo, slope - spread);
            hi = fmin(hi, slope + spread);
            reach = along;
        }
        f->items[kept++] = f->items[end];
        i = end + 1;
    }
    f->count = kept;
}

/* Turns a closed line round so that it starts at its first corner, and repeats that knot at the
 * end. */
static bool knots_close(fit *f) {
    size_t start = 0;
    while (start < f->count && !f->items[start].corner)
        start++;
    f->loops = start == f->count;
    if (f->loops)
        start = 0;
    size_t n = f->count;
    if (!kg_reserve(f, 2 * n + 1))
        return false;
    memcpy(f->items + n, f->items, n * sizeof(knot));
    memmove(f->items, f->items + start, n * sizeof(knot));
    f->items[n] = f->items[0];
    f->count = n + 1;
    return true;
}

/* Turning angle at a knot that is no end; round the loop at the ends of a smooth one. */
static double turn_at(const fit *f, size_t i) {
    size_t last = f->count - 1;
    if (i == 0 || i == last)
        return f->loops ? turn_between(chord(f, last - 1), chord(f, 0)) : 0;
    return turn_between(chord(f, i - 1), chord(f, i));
}

/* Curvature at a knot by the circle through it and its neighbours. */
static double curvature_at(const fit *f, size_t i) {
    if (f->items[i].corner)
        return 0;
    size_t last = f->count - 1;
    size_t before = i > 0 ? i - 1 : last - 1, after = i < last ? i : 0;
    return 2 * fabs(turn_at(f, i)) / (chord_length(f, before) + chord_length(f, after));
}

/* Sections end at corners and at both ends of chords that must be straight. */
static void knots_mark_breaks(fit *f) {
    size_t last = f->count - 1;
    for (size_t i = 0; i <= last; i++)
        f->items[i].breaks = f->items[i].corner;
    for (size_t i = 0; i < last; i++) {
        double c = chord_length(f, i);
        double bend = fmax(curvature_at(f, i), curvature_at(f, i + 1));
        bool alone = f->items[i].corner && f->items[i + 1].corner;
        if (alone || c * c * bend / 8 > STRAIGHT_FACTOR * CHORD_SHARE * f->tolerance)
            f->items[i].breaks = f->items[i + 1].breaks = true;
    }
    if (f->loops && (f->items[0].breaks || f->items[last].breaks)) {
        f->items[0].breaks = f->items[last].breaks = true;
        f->loops = false;
    }
}

static void knots_measure(fit *f) {
    f->items[0].s = f->items[0].turn = 0;
    for (size_t i = 1; i < f->count; i++) {
        knot *k = &f->items[i];
        k->s = k[-1].s + chord_length(f, i - 1);
        k->turn = k[-1].turn + (k->breaks || i + 1 == f->count ? 0 : fabs(turn_at(f, i)));
    }
}

/* ---- tangents ------------------------------------------------------------------------------ */

static kg_vec2 turned(kg_vec2 v, double angle) {
    double n = kg_len2(v), c = cos(angle), s = sin(angle);
    return kg_v2((c * v.x - s * v.y) / n, (s * v.x + c * v.y) / n);
}

/* Direction of the circle through three knots at the middle one, at the first, at the last: the
 * chord's direction turned by its share of the turning angle. */
static kg_vec2 tangent_middle(kg_vec2 before, kg_vec2 after) {
    double a = kg_len2(before), b = kg_len2(after);
    return turned(before, turn_between(before, after) * a / (a + b));
}

static kg_vec2 tangent_first(kg_vec2 c0, kg_vec2 c1) {
    double a = kg_len2(c0), b = kg_len2(c1);
    return turned(c0, -turn_between(c0, c1) * a / (a + b));
}

/* Tangent at knot i of the section [first,last] (at least two chords). Where a section ends without
 * a corner a straight chord goes on, which sets the direction. */
static kg_vec2 tangent(const fit *f, size_t i, size_t first, size_t last) {
    size_t end = f->count - 1;
    size_t before = i > 0 ? i - 1 : end - 1, after = i < end ? i : 0;
    bool corner = f->items[i].corner;
    if (f->items[i].breaks && !corner)
        return turned(chord(f, i == first ? before : after), 0);
    if (corner && i == first)
        return tangent_first(chord(f, i), chord(f, i + 1));
    if (corner && i == last)
        return turned(tangent_first(kg_scale2(chord(f, i - 1), -1), kg_scale2(chord(f, i - 2), -1)),
                      KG_PI);
    return tangent_middle(chord(f, before), chord(f, after));
}

/* ---- one cubic ------------------------------------------------------------------------------ */

typedef struct cubic {
    kg_vec2 p[4];
    kg_vec2 t0, t1; /* unit; t1 points back from the end */
    double a, b;    /* handle lengths */
} cubic;

static void cubic_set(cubic *c) {
    c->p[1] = kg_add2(c->p[0], kg_scale2(c->t0, c->a));
    c->p[2] = kg_add2(c->p[3], kg_scale2(c->t1, c->b));
}

/* First and second derivative by t. */
static kg_vec2 cubic_speed(const cubic *c, double t) {
    double s = 1 - t;
    kg_vec2 d0 = kg_sub2(c->p[1], c->p[0]), d1 = kg_sub2(c->p[2], c->p[1]);
    kg_vec2 d2 = kg_sub2(c->p[3], c->p[2]);
    return kg_v2(3 * (s * s * d0.x + 2 * s * t * d1.x + t * t * d2.x),
                 3 * (s * s * d0.y + 2 * s * t * d1.y + t * t * d2.y));
}

static kg_vec2 cubic_acceleration(const cubic *c, double t) {
    kg_vec2 e0 = kg_add2(kg_sub2(c->p[0], kg_scale2(c->p[1], 2)), c->p[2]);
    kg_vec2 e1 = kg_add2(kg_sub2(c->p[1], kg_scale2(c->p[2], 2)), c->p[3]);
    return kg_scale2(kg_lerp2(e0, e1, t), 6);
}

/* Foot point near t by Newton steps on (B(t) - q)·B'(t) = 0. */
static double cubic_foot(const cubic *c, kg_vec2 q, double t) {
    for (int i = 0; i < 3; i++) {
        kg_vec2 r = kg_sub2(kg_bezier2(c->p, t), q), v = cubic_speed(c, t);
        double vv = kg_dot2(v, v), slope = vv + kg_dot2(r, cubic_acceleration(c, t));
        if (!(vv > 0))
            break;
        /* Far from the curve the second derivative misleads; then the tangent alone is used. */
        double step = kg_dot2(r, v) / (slope > 0.3 * vv ? slope : vv);
        t = unit_clamp(t - step);
        if (fabs(step) < 1e-7)
            break;
    }
    return t;
}

/* Foot points of every stride-th knot of a..b; returns the greatest distance, infinity when they do
 * not advance. */
static double cubic_project(const fit *f, const cubic *c, size_t a, size_t b, size_t stride) {
    double worst = 0;
    for (size_t i = a + stride; i < b; i += stride) {
        f->t[i] = cubic_foot(c, f->items[i].p, f->t[i]);
        if (!(f->t[i] > f->t[i - stride]) || !(f->t[i] < 1))
            return INFINITY;
        double d = kg_dist2(kg_bezier2(c->p, f->t[i]), f->items[i].p);
        worst = d > worst ? d : worst;
    }
    return worst;
}

/* Greatest distance of the cubic from its chords, between the foot points as well. */
static double cubic_stray(const fit *f, const cubic *c, size_t a, size_t b) {
    double worst = 0;
    for (size_t i = a; i < b; i++) {
        double t0 = f->t[i], t1 = f->t[i + 1];
        int samples = 1 + (int)(24 * (t1 - t0));
        for (int k = 1; k <= samples; k++) {
            kg_vec2 q = kg_bezier2(c->p, t0 + (t1 - t0) * k / (samples + 1));
            double d = segment_distance(q, f->items[i].p, f->items[i + 1].p);
            worst = d > worst ? d : worst;
        }
    }
    return worst;
}

/* One Gauss-Newton step for the handle lengths on the normal distances at the foot points. */
static bool cubic_improve(const fit *f, cubic *c, size_t a, size_t b, size_t stride) {
    double m00 = 0, m01 = 0, m11 = 0, r0 = 0, r1 = 0, weight = 0;
    for (size_t i = a + stride; i < b; i += stride) {
        double t = f->t[i], s = 1 - t, b1 = 3 * s * s * t, b2 = 3 * s * t * t;
        kg_vec2 v = cubic_speed(c, t);
        double n = kg_len2(v);
        if (!(n > 0))
            return false;
        kg_vec2 normal = kg_v2(-v.y / n, v.x / n);
        double d = kg_dot2(kg_sub2(kg_bezier2(c->p, t), f->items[i].p), normal);
        double j0 = b1 * kg_dot2(normal, c->t0), j1 = b2 * kg_dot2(normal, c->t1);
        m00 += j0 * j0;
        m01 += j0 * j1;
        m11 += j1 * j1;
        r0 += j0 * d;
        r1 += j1 * d;
        weight += b1 * b1 + b2 * b2;
    }
    /* Where the stretch is nearly straight the handles hardly matter: damping leaves them be. */
    double damping = 1e-8 * weight + 1e-300;
    m00 += damping;
    m11 += damping;
    double det = m00 * m11 - m01 * m01;
    if (!(det > 0))
        return false;
    double length = f->items[b].s - f->items[a].s;
    c->a = fmin(fmax(c->a - (m11 * r0 - m01 * r1) / det, 0.02 * length), 1.2 * length);
    c->b = fmin(fmax(c->b - (m00 * r1 - m01 * r0) / det, 0.02 * length), 1.2 * length);
    cubic_set(c);
    return true;
}

/* Parameters of the knots between every stride-th one, in proportion to the length. */
static void parameters_spread(const fit *f, size_t a, size_t b, size_t stride) {
    const knot *k = f->items;
    for (size_t lo = a; lo < b; lo += stride) {
        size_t hi = lo + stride < b ? lo + stride : b;
        for (size_t i = lo + 1; i < hi; i++)
            f->t[i] = f->t[lo] + (f->t[hi] - f->t[lo]) * (k[i].s - k[lo].s) / (k[hi].s - k[lo].s);
    }
}

/* A cubic along knots a..b of the section [first,last], within the tolerance; false when there is
 * none. */
static bool cubic_fit(const fit *f, size_t a, size_t b, size_t first, size_t last, cubic *c) {
    const knot *k = f->items;
    double length = k[b].s - k[a].s, turn = k[b - 1].turn - k[a].turn;
    if (turn > GREATEST_TURN)
        return false;
    c->p[0] = k[a].p;
    c->p[3] = k[b].p;
    c->t0 = tangent(f, a, first, last);
    c->t1 = kg_scale2(tangent(f, b, first, last), -1);
    c->a = c->b = length / 3;
    cubic_set(c);
    for (size_t i = a; i <= b; i++)
        f->t[i] = (k[i].s - k[a].s) / length;
    /* A part of the knots finds the handles, all of them decide. */
    size_t stride = 1 + (b - a) / SAMPLES;
    double before = INFINITY;
    for (int i = 0; i < ITERATIONS; i++) {
        double worst = cubic_project(f, c, a, b, stride);
        if (worst <= f->fit_tolerance && stride > 1) {
            parameters_spread(f, a, b, stride);
            stride = 1;
            worst = cubic_project(f, c, a, b, stride);
        }
        if (worst <= f->fit_tolerance && cubic_stray(f, c, a, b) <= f->fit_tolerance)
            return true;
        /* Steps that gain nothing any more will not arrive. */
        if (!isfinite(worst) || (i > 1 && worst > 0.8 * before))
            return false;
        before = worst;
        if (!cubic_improve(f, c, a, b, stride))
            return false;
    }
    return false;
}

/* ---- sections ------------------------------------------------------------------------------- */

static bool section_straight(const fit *f, size_t first, size_t last) {
    for (size_t i = first + 1; i < last; i++)
        if (segment_distance(f->items[i].p, f->items[first].p, f->items[last].p) >
            CHORD_SHARE * f->tolerance)
            return false;
    return true;
}

/* Writes the longest cubic from knot a; returns where it ends. When no cubic follows even one
 * chord, the chord. */
static bool section_step(fit *f, size_t a, size_t first, size_t last, size_t *out_next) {
    size_t good = 0, bad = last - a + 1;
    cubic best, c;
    for (size_t n = bad - 1 < 8 ? bad - 1 : 8; n < bad && n > 0;) {
        if (cubic_fit(f, a, a + n, first, last, &c)) {
            good = n;
            best = c;
            /* While nothing has failed, double; then halve the doubt. */
            size_t rest = last - a;
            n = bad > rest ? (2 * n < rest ? 2 * n : n < rest ? rest : bad) : (good + bad) / 2;
        } else {
            bad = n;
            n = (good + bad) / 2;
        }
        if (n == good)
            break;
    }
    *out_next = a + (good > 0 ? good : 1);
    if (good == 0)
        return kg_path_line(f->path, f->items[a + 1].p);
    return kg_path_curve(f->path, best.p[1], best.p[2], best.p[3]);
}

static bool section_write(fit *f, size_t first, size_t last) {
    if (section_straight(f, first, last))
        return kg_path_line(f->path, f->items[last].p);
    for (size_t a = first; a < last;)
        if (!section_step(f, a, first, last, &a))
            return false;
    return true;
}

static bool fit_write(fit *f, bool closed) {
    if (!kg_path_move(f->path, f->items[0].p))
        return false;
    for (size_t first = 0; first + 1 < f->count;) {
        size_t last = first + 1;
        while (last + 1 < f->count && !f->items[last].breaks)
            last++;
        if (!section_write(f, first, last))
            return false;
        first = last;
    }
    if (!closed)
        return true;
    /* Closing draws the line back to the start. */
    if (f->path->items[f->path->count - 1].verb == KG_PATH_LINE)
        f->path->count--;
    return kg_path_close(f->path);
}

static bool fit_run(fit *f, const kg_vec2 *points, const unsigned char *corners, size_t count,
                    bool closed) {
    if (!knots_distinct(f, points, corners, count, closed))
        return false;
    if (f->count < 2)
        return true;
    if (closed && !knots_close(f))
        return false;
    if (!f->loops)
        f->items[0].corner = f->items[f->count - 1].corner = true;
    knots_merge_collinear(f);
    knots_mark_breaks(f);
    knots_measure(f);
    f->t = malloc(f->count * sizeof *f->t);
    return f->t && fit_write(f, closed);
}

kg_status kg_fit(const kg_vec2 *points, const unsigned char *corners, size_t count, bool closed,
                 double tolerance, kg_path *path, kg_error *error) {
    fit f = {.tolerance = tolerance, .fit_tolerance = FIT_SHARE * tolerance, .path = path};
    size_t before = path->count;
    bool done = fit_run(&f, points, corners, count, closed);
    free(f.items);
    free(f.t);
    if (done)
        return KG_OK;
    path->count = before;
    return kg_fail(error, KG_ERR_MEMORY, "out of memory while fitting curves");
}
