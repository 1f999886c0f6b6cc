#include "net/perforation.h"

#include "base/array.h"

#include <stdlib.h>

/* A straight or curved step as a cubic, with its length. */
typedef struct arc {
    kg_vec2 p[4];
    bool straight;
    double length;
} arc;

typedef struct arcs {
    arc *items;
    size_t count, capacity;
} arcs;

static kg_vec2 speed(const kg_vec2 p[4], double t) {
    double s = 1 - t;
    kg_vec2 a = kg_sub2(p[1], p[0]), b = kg_sub2(p[2], p[1]), c = kg_sub2(p[3], p[2]);
    return kg_v2(3 * (s * s * a.x + 2 * s * t * b.x + t * t * c.x),
                 3 * (s * s * a.y + 2 * s * t * b.y + t * t * c.y));
}

/* Length of [0,t] by Gauss-Legendre quadrature of five points on eight pieces: far below a
 * micrometre for the gentle cubics that fitting makes. */
static double length_to(const arc *a, double t) {
    static const double node[5] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                   0.9061798459386640};
    static const double weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                     0.4786286704993665, 0.2369268850561891};
    if (a->straight)
        return t * kg_dist2(a->p[0], a->p[3]);
    double sum = 0, h = t / 8;
    for (int piece = 0; piece < 8; piece++)
        for (int i = 0; i < 5; i++)
            sum += weight[i] * kg_len2(speed(a->p, h * (piece + (1 + node[i]) / 2))) * h / 2;
    return sum;
}

/* The parameter at a length, by Newton steps kept within the bracket. */
static double parameter_at(const arc *a, double length) {
    if (length <= 0 || length >= a->length)
        return length <= 0 ? 0 : 1;
    double lo = 0, hi = 1, t = length / a->length;
    for (int i = 0; i < 40 && !a->straight; i++) {
        double excess = length_to(a, t) - length, v = kg_len2(speed(a->p, t));
        if (fabs(excess) < 1e-7)
            break;
        if (excess > 0)
            hi = t;
        else
            lo = t;
        t -= v > 0 ? excess / v : 0;
        if (!(t > lo && t < hi))
            t = (lo + hi) / 2;
    }
    return t;
}

/* Blossom of the cubic: its polar form at three parameters. */
static kg_vec2 blossom(const kg_vec2 p[4], double r, double s, double t) {
    kg_vec2 q[3], u[2];
    for (int i = 0; i < 3; i++)
        q[i] = kg_lerp2(p[i], p[i + 1], r);
    for (int i = 0; i < 2; i++)
        u[i] = kg_lerp2(q[i], q[i + 1], s);
    return kg_lerp2(u[0], u[1], t);
}

static bool arc_part(const arc *a, double t0, double t1, bool start, kg_path *out) {
    if (start && !kg_path_move(out, blossom(a->p, t0, t0, t0)))
        return false;
    kg_vec2 end = blossom(a->p, t1, t1, t1);
    if (a->straight)
        return kg_path_line(out, end);
    return kg_path_curve(out, blossom(a->p, t0, t0, t1), blossom(a->p, t0, t1, t1), end);
}

/* The stretch [from,to] of the whole run as one segment. */
static bool run_part(const arcs *run, double from, double to, kg_path *out) {
    /* Slivers of a step shorter than this would only make points twice. */
    const double least = 1e-6;
    double s = 0;
    bool start = true;
    for (size_t i = 0; i < run->count && s < to; s += run->items[i++].length) {
        const arc *a = &run->items[i];
        double lo = fmax(from - s, 0), hi = fmin(to - s, a->length);
        if (hi - lo <= least)
            continue;
        if (!arc_part(a, parameter_at(a, lo), parameter_at(a, hi), start, out))
            return false;
        start = false;
    }
    return true;
}

static bool run_dashes(const arcs *run, double dash, double gap, kg_path *out) {
    double total = 0;
    for (size_t i = 0; i < run->count; i++)
        total += run->items[i].length;
    double count = fmax(1, floor((total + gap) / (dash + gap)));
    double spare = (total - count * dash - (count - 1) * gap) / 2;
    for (double i = 0; i < count; i++) {
        double from = i == 0 ? 0 : spare + i * (dash + gap);
        double to = i + 1 == count ? total : spare + i * (dash + gap) + dash;
        if (!run_part(run, from, to, out))
            return false;
    }
    return true;
}

bool kg_path_dashes(const kg_path *path, double dash, double gap, kg_path *out) {
    arcs run = {0};
    kg_vec2 at = {0, 0}, start = {0, 0};
    bool done = true;
    for (size_t i = 0; done && i < path->count; i++) {
        const kg_path_step *step = &path->items[i];
        if (step->verb == KG_PATH_MOVE) {
            done = run_dashes(&run, dash, gap, out);
            run.count = 0;
            at = start = step->p[0];
            continue;
        }
        arc a = {.straight = step->verb != KG_PATH_CURVE};
        kg_vec2 end = step->verb == KG_PATH_CLOSE ? start : kg_path_end(step);
        a.p[0] = at;
        a.p[1] = a.straight ? kg_lerp2(at, end, 1.0 / 3) : step->p[0];
        a.p[2] = a.straight ? kg_lerp2(at, end, 2.0 / 3) : step->p[1];
        a.p[3] = end;
        a.length = length_to(&a, 1);
        done = kg_push(&run, a);
        at = end;
    }
    done = done && run_dashes(&run, dash, gap, out);
    free(run.items);
    return done;
}

kg_status kg_perforate(kg_drawing *drawing, double dash, double gap, kg_error *error) {
    for (size_t i = 0; i < drawing->page_count; i++) {
        kg_strokes *strokes = &drawing->pages[i].strokes;
        for (size_t k = 0; k < strokes->count; k++) {
            kg_stroke *stroke = &strokes->items[k];
            if (stroke->layer != KG_LAYER_MOUNTAIN && stroke->layer != KG_LAYER_VALLEY)
                continue;
            kg_path pieces = {0};
            if (!kg_path_dashes(&stroke->path, dash, gap, &pieces)) {
                kg_path_clear(&pieces);
                return kg_fail(error, KG_ERR_MEMORY, "out of memory while perforating folds");
            }
            kg_path_clear(&stroke->path);
            stroke->path = pieces;
            stroke->dashed = false;
        }
    }
    return KG_OK;
}
