/*
 * From arcs to branches: exact points along each chain of arcs, cut where it leaves the rectangles
 * and dense enough for the chord tolerance in space and on both papers.
 */
#include "trim/crossing.h"

#include "base/array.h"

#include <stdlib.h>

/* The chord error is estimated from the tangents at both ends; the aim leaves room for that. */
#define AIM 0.7

/* Turning per span, radians: linear interpolation inside a span is then near enough to the curve
 * for Newton's method to find it, and nothing else. */
#define MAX_TURN 0.35

/* Spans shorter than this (in v and t) are not halved any more: next to singular points. */
#define MIN_SPAN 1e-9

/* Branches shorter than this fraction of the size are touches. */
#define MIN_LENGTH 1e-8

/* Points nearer to each other than this fraction of the tolerance are left out: even at a cusp the
 * chord error then stays in the room that AIM leaves. */
#define THIN 0.2

/* Halvings of one span, and of all spans of a pair: far beyond what any tolerance needs, so that
 * no input runs away. Spans keep the points they have then. */
enum { MAX_DEPTH = 40, MAX_HALVINGS = 1 << 17 };

enum { COORDINATES = 4 };

typedef struct tracer {
    const kg_ruled_pair *pair;
    const kg_arc *arc;
    int direction;
    int halvings; /* so far */
    kg_path path;
} tracer;

static const unsigned side_lo[COORDINATES] = {KG_SIDE_A_U_LO, KG_SIDE_A_V_LO, KG_SIDE_B_U_LO,
                                              KG_SIDE_B_V_LO};

static double coordinate(const kg_cross_point *p, int k) {
    return k == 0 ? p->u : k == 1 ? p->v : k == 2 ? p->s : p->t;
}

static void set_coordinate(kg_cross_point *p, int k, double x) {
    *(k == 0 ? &p->u : k == 1 ? &p->v : k == 2 ? &p->s : &p->t) = x;
}

/* The value of side bit `lo << high` of coordinate k. */
static double side_value(const kg_ruled_pair *pair, int k, int high) {
    return k == 0   ? pair->a.patch->extent[high]
           : k == 2 ? pair->b.patch->extent[high]
                    : (double)high;
}

/* ---- points of an arc ------------------------------------------------------------------ */

/* The arc's point at parameter w (v or t by its kind), searched from `guess` by Newton's method
 * inside the box: the derivative has one sign there, so the sign of F tells the side. */
static kg_sample arc_point(const tracer *tr, double w, double guess) {
    const kg_arc *arc = tr->arc;
    bool over_v = arc->kind == KG_ARC_OVER_V;
    const kg_ruled *fixed = over_v ? &tr->pair->a : &tr->pair->b;
    const kg_ruled *moving = over_v ? &tr->pair->b : &tr->pair->a;
    double lo = over_v ? arc->t[0] : arc->v[0], hi = over_v ? arc->t[1] : arc->v[1];
    w = kg_on_unit_side(tr->pair, w);
    kg_line at = kg_ruled_line(fixed, w);
    double x = kg_min(kg_max(guess, lo), hi);
    for (int i = 0; i < 60; i++) {
        kg_line line = kg_ruled_line(moving, x);
        double fv, ft;
        double f =
            over_v ? kg_cross_value(&at, &line, &fv, &ft) : kg_cross_value(&line, &at, &fv, &ft);
        if (f * arc->slope > 0)
            hi = x;
        else
            lo = x;
        double step = f / (over_v ? ft : fv), next = x - step;
        /* quadratic convergence: the error after this step is about its square */
        if (fabs(step) < 1e-8) {
            x = next;
            break;
        }
        x = next >= lo && next <= hi ? next : 0.5 * (lo + hi);
    }
    x = kg_on_unit_side(tr->pair, x);
    kg_line met = kg_ruled_line(moving, x);
    return over_v ? kg_cross_lines(tr->pair, w, &at, x, &met, arc->kind, tr->direction)
                  : kg_cross_lines(tr->pair, x, &met, w, &at, arc->kind, tr->direction);
}

static double parameter(const tracer *tr, const kg_sample *s) {
    return tr->arc->kind == KG_ARC_OVER_V ? s->at.v : s->at.t;
}
static double other(const tracer *tr, const kg_sample *s) {
    return tr->arc->kind == KG_ARC_OVER_V ? s->at.t : s->at.v;
}
/* d other / d parameter */
static double steepness(const tracer *tr, const kg_sample *s) {
    return tr->arc->kind == KG_ARC_OVER_V ? s->slope.t / s->slope.v : s->slope.v / s->slope.t;
}

/* Between two points of the arc, the guess by the cubic through their tangents. */
static kg_sample between(const tracer *tr, const kg_sample *p, const kg_sample *q, double w) {
    double w0 = parameter(tr, p), w1 = parameter(tr, q), h = w1 - w0, x = (w - w0) / h;
    double y0 = other(tr, p), y1 = other(tr, q), d0 = steepness(tr, p), d1 = steepness(tr, q);
    double guess = y0 + (y1 - y0) * x;
    if (isfinite(d0) && isfinite(d1)) {
        double y = 1 - x;
        guess = y0 * y * y * (1 + 2 * x) + y1 * x * x * (1 + 2 * y) + h * x * y * (d0 * y - d1 * x);
    }
    return arc_point(tr, w, guess);
}

static kg_sample middle(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    return between(tr, p, q, 0.5 * (parameter(tr, p) + parameter(tr, q)));
}

static bool tiny(const kg_sample *p, const kg_sample *q) {
    return fabs(p->at.v - q->at.v) < MIN_SPAN && fabs(p->at.t - q->at.t) < MIN_SPAN;
}

/* ---- shape of a span ------------------------------------------------------------------- */

/* The chord on the paper of A or B; the stretch of the geodesic by Simpson's rule. */
static kg_vec2 paper_chord(const tracer *tr, const kg_sample *p, const kg_sample *q, int which) {
    const kg_ruled *ruled = which ? &tr->pair->b : &tr->pair->a;
    double v = which ? p->at.t : p->at.v, w = which ? q->at.t : q->at.v;
    double middle = kg_ruled_speed(ruled, 0.5 * (v + w));
    double length = (w - v) * (p->speed[which] + 4 * middle + q->speed[which]) / 6;
    return kg_sub2(kg_v2(q->off[which].x, q->off[which].y + length), p->off[which]);
}

/* Turning over the span and the deviation from its chords in space and on both papers, from the
 * tangents at its ends: a quarter of the length times the angle between tangent and chord. Beyond
 * `limit` in space alone the papers are not looked at. */
static double chord_error(const tracer *tr, const kg_sample *p, const kg_sample *q, double limit,
                          double *out_turn) {
    kg_vec3 chord = kg_sub(q->at.x, p->at.x);
    double length = kg_len(chord), bend = 0;
    bool at_p = kg_dot(p->slope.x, p->slope.x) > 0, at_q = kg_dot(q->slope.x, q->slope.x) > 0;
    chord = kg_unit(chord);
    if (at_p)
        bend = kg_max(kg_dist(p->slope.x, chord), bend);
    if (at_q)
        bend = kg_max(kg_dist(q->slope.x, chord), bend);
    for (int k = 0; k < 2 && at_p && at_q && 0.25 * length * bend <= limit; k++) {
        kg_vec2 flat = paper_chord(tr, p, q, k);
        double n = kg_len2(flat);
        flat = kg_scale2(flat, n > 0 ? 1 / n : 0);
        bend = kg_max(kg_dist2(p->paper[k], flat), bend);
        bend = kg_max(kg_dist2(q->paper[k], flat), bend);
    }
    *out_turn = 2 * bend;
    return 0.25 * length * bend;
}

/* Control values of the cubic with the values and slopes of coordinate k at two points; the arc
 * length is taken as the chord's. */
static void cubic(const kg_sample *p, const kg_sample *q, int k, double out[4]) {
    double third = kg_dist(p->at.x, q->at.x) / 3;
    out[0] = coordinate(&p->at, k), out[3] = coordinate(&q->at, k);
    out[1] = out[0] + third * coordinate(&p->slope, k);
    out[2] = out[3] - third * coordinate(&q->slope, k);
    if (!isfinite(out[1]) || !isfinite(out[2]))
        out[1] = out[0], out[2] = out[3];
}

static void reach(const kg_sample *p, const kg_sample *q, int k, double out[2]) {
    double c[4];
    cubic(p, q, k, c);
    out[0] = kg_min(kg_min(c[0], c[1]), kg_min(c[2], c[3]));
    out[1] = kg_max(kg_max(c[0], c[1]), kg_max(c[2], c[3]));
}

/* Coordinate steps that no rounding or interpolation makes, in units of coordinate k. */
static double unit_of(const kg_ruled_pair *pair, int k) {
    return (k & 1) ? pair->tolerance / pair->a.size : pair->tolerance;
}

/* Could the span between two inside points leave the rectangles, or one between two points beyond
 * one side come back? */
static bool may_cross(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    for (int k = 0; k < COORDINATES; k++) {
        double r[2], room = 0.1 * unit_of(tr->pair, k);
        reach(p, q, k, r);
        if (r[0] < side_value(tr->pair, k, 0) - room || r[1] > side_value(tr->pair, k, 1) + room)
            return true;
    }
    return false;
}

static bool stays_out(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    unsigned common = p->out & q->out;
    if (common & KG_SIDE_FALSE)
        return true;
    double turn, length = kg_dist(p->at.x, q->at.x);
    chord_error(tr, p, q, INFINITY, &turn);
    bool bent = turn > 2 * MAX_TURN; /* the cubic says little about the curve */
    for (int k = 0; k < COORDINATES; k++)
        for (int high = 0; high < 2; high++) {
            if (!(common & side_lo[k] << high))
                continue;
            double r[2], side = side_value(tr->pair, k, high);
            double x = fabs(coordinate(&p->at, k) - side), y = fabs(coordinate(&q->at, k) - side);
            double margin = 0.1 * fabs(x - y);
            reach(p, q, k, r);
            /* there and back is farther than a curve over this chord is long */
            bool far = (k == 0 || k == 2) && x + y > 3 * length;
            bool clear = high ? r[0] - margin > side : r[1] + margin < side;
            if (far || (clear && !bent))
                return true;
        }
    return false;
}

/* Does the span pass each side that lies between its ends just once? */
static bool crosses_once(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    double slack = tr->pair->slack * tr->pair->a.size;
    for (int k = 0; k < COORDINATES; k++)
        for (int high = 0; high < 2; high++) {
            if (!((p->out ^ q->out) & side_lo[k] << high))
                continue;
            double c[4], side = side_value(tr->pair, k, high);
            cubic(p, q, k, c);
            int changes = 0;
            for (int i = 0; i < 4; i++) {
                c[i] = high ? side - c[i] : c[i] - side;
                changes += i > 0 && (c[i] < 0) != (c[i - 1] < 0);
            }
            /* an end on the side, from which the curve goes inside before it comes out */
            bool returns = (c[0] == 0 && c[1] > slack) || (c[3] == 0 && c[2] > slack);
            if (changes > 1 || returns)
                return false;
        }
    return true;
}

/* ---- spans ----------------------------------------------------------------------------- */

static bool emit(tracer *tr, const kg_sample *s, bool inside) {
    return kg_push(&tr->path.samples, *s) && kg_push(&tr->path.inside, inside);
}

/* What is within the slack of a side is on it: a point on one side may be on others too, as on the
 * corners of mirrored patches. */
static void snap(const kg_ruled_pair *pair, kg_sample *s) {
    for (int k = 0; k < COORDINATES; k++)
        for (int high = 0; high < 2; high++) {
            double side = side_value(pair, k, high),
                   slack = pair->slack * (k & 1 ? 1 : pair->a.size);
            if (fabs(coordinate(&s->at, k) - side) <= slack) {
                set_coordinate(&s->at, k, side);
                s->out &= ~(side_lo[k] | side_lo[k] << 1);
            }
        }
}

/* Where coordinate k takes the value `side` between p and q, on whose two sides they lie; that
 * coordinate is then exact. */
static kg_sample side_point(const tracer *tr, const kg_sample *p, const kg_sample *q, int k,
                            double side) {
    /* no slack here: it would stop the iteration early */
    kg_ruled_pair exact = *tr->pair;
    exact.slack = 0;
    tracer strict = {.pair = &exact, .arc = tr->arc, .direction = tr->direction};
    kg_sample ends[2] = {*p, *q}, s = *p;
    double f0 = coordinate(&p->at, k) - side, f1 = coordinate(&q->at, k) - side;
    double w0 = parameter(tr, p), w1 = parameter(tr, q), w = w0 + (w1 - w0) * (f0 / (f0 - f1));
    for (int i = 0; i < 60; i++) {
        if (!(w > kg_min(w0, w1) && w < kg_max(w0, w1)))
            w = 0.5 * (w0 + w1);
        s = between(&strict, &ends[0], &ends[1], w);
        double f = coordinate(&s.at, k) - side;
        if (f == 0)
            break;
        if ((f > 0) == (f0 > 0))
            w0 = w, ends[0] = s;
        else
            w1 = w, ends[1] = s;
        double slope =
            coordinate(&s.slope, k) / (tr->arc->kind == KG_ARC_OVER_V ? s.slope.v : s.slope.t);
        double next = w - f / slope;
        if (fabs(next - w) < 1e-15 || fabs(w1 - w0) < 1e-15)
            break;
        w = next;
    }
    set_coordinate(&s.at, k, side);
    s.out &= ~(side_lo[k] | side_lo[k] << 1);
    snap(tr->pair, &s);
    return s;
}

/* Is the span so short that its points would be left out? Its shape then matters no more, nor can
 * it be known next to a point where branches meet: F is flat there, and tangents are rounding. The
 * middle tells a short span from a bow over a short chord. */
static bool fine(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    double limit = THIN * tr->pair->tolerance;
    if (!(kg_dist(p->at.x, q->at.x) < limit))
        return false;
    kg_sample m = middle(tr, p, q);
    return kg_dist(p->at.x, m.at.x) < limit && kg_dist(m.at.x, q->at.x) < limit;
}

/* Is there nothing to be gained by halving the span? */
static bool spent(const tracer *tr, const kg_sample *p, const kg_sample *q, int depth) {
    return tiny(p, q) || depth > MAX_DEPTH || tr->halvings >= MAX_HALVINGS || fine(tr, p, q);
}

static bool inside_span(tracer *tr, const kg_sample *p, const kg_sample *q, int depth);
static bool span(tracer *tr, const kg_sample *p, const kg_sample *q, int depth);

static bool halves(tracer *tr, const kg_sample *p, const kg_sample *q, int depth) {
    kg_sample m = middle(tr, p, q);
    tr->halvings++;
    return span(tr, p, &m, depth + 1) && span(tr, &m, q, depth + 1);
}

/* Both ends inside: halved until chords are good and no excursion can hide. */
static bool inside_span(tracer *tr, const kg_sample *p, const kg_sample *q, int depth) {
    double turn, aim = AIM * tr->pair->tolerance, error = chord_error(tr, p, q, aim, &turn);
    bool good = error <= aim && turn <= MAX_TURN && !may_cross(tr, p, q);
    return good || spent(tr, p, q, depth) ? emit(tr, q, true) : halves(tr, p, q, depth);
}

/* The sides between p (beyond them) and q (not): the last one that the curve passes on the way to
 * q. */
static kg_sample entry(const tracer *tr, const kg_sample *p, const kg_sample *q) {
    kg_sample best = *p;
    unsigned passed = p->out & ~q->out;
    for (int k = 0; k < COORDINATES; k++)
        for (int high = 0; high < 2; high++)
            if (passed & side_lo[k] << high) {
                double side = side_value(tr->pair, k, high);
                kg_sample s = coordinate(&q->at, k) == side ? *q : side_point(tr, p, q, k, side);
                double way = parameter(tr, q) - parameter(tr, p);
                if ((parameter(tr, &s) - parameter(tr, &best)) * way > 0)
                    best = s;
            }
    return best;
}

/* A span that is not wholly inside. */
static bool span(tracer *tr, const kg_sample *p, const kg_sample *q, int depth) {
    if (!p->out && !q->out)
        return inside_span(tr, p, q, depth);
    if (tiny(p, q) || stays_out(tr, p, q))
        return emit(tr, q, false);
    double turn;
    chord_error(tr, p, q, INFINITY, &turn);
    double flip = kg_dot(p->across, q->across);
    bool steady = turn < MAX_TURN && flip > 0.5 * kg_dot(p->across, p->across) &&
                  flip > 0.5 * kg_dot(q->across, q->across);
    /* beyond one side both, yet not certainly out; or too bent to know how often it crosses */
    bool last = false;
    if ((p->out & q->out) || !steady || !crosses_once(tr, p, q)) {
        last = spent(tr, p, q, depth);
        if (!last)
            return halves(tr, p, q, depth);
        if (p->out & q->out)
            return emit(tr, q, false);
    }
    kg_sample in = p->out ? entry(tr, p, q) : *p, out = q->out ? entry(tr, q, p) : *q;
    double way = parameter(tr, q) - parameter(tr, p);
    if (p->out && q->out && (parameter(tr, &out) - parameter(tr, &in)) * way <= 0)
        return emit(tr, q, false);
    if (in.out || out.out) /* beyond yet another side */
        return last || spent(tr, p, q, depth) ? emit(tr, q, false) : halves(tr, p, q, depth);
    if (p->out && !emit(tr, &in, false))
        return false;
    if (parameter(tr, &in) != parameter(tr, &out) && !inside_span(tr, &in, &out, depth + 1))
        return false;
    return !q->out || emit(tr, q, false);
}

/* ---- arcs ------------------------------------------------------------------------------ */

/* Points at equal steps first, as many as the chord error of the halves asks for. */
static bool trace_halved(tracer *tr, const kg_sample *p, const kg_sample *q) {
    enum { MAX_STEPS = 64 };
    double turn, error = chord_error(tr, p, q, INFINITY, &turn);
    int steps = 1;
    if (!p->out && !q->out)
        steps =
            (int)fmin(fmax(ceil(sqrt(error / (AIM * tr->pair->tolerance))), ceil(turn / MAX_TURN)),
                      MAX_STEPS);
    kg_sample from = *p;
    double w0 = parameter(tr, p), w1 = parameter(tr, q);
    for (int i = 1; i <= steps; i++) {
        kg_sample to = i == steps ? *q : between(tr, &from, q, w0 + (w1 - w0) * i / steps);
        if (!span(tr, &from, &to, 0))
            return false;
        from = to;
    }
    return true;
}

static kg_sample end_point(const tracer *tr, const kg_arc_end *e) {
    if (tr->arc->kind == KG_ARC_SHORT)
        return kg_cross_sample(tr->pair, e->v, e->t, KG_ARC_OVER_V, 1);
    return tr->arc->kind == KG_ARC_OVER_V ? arc_point(tr, e->v, e->t) : arc_point(tr, e->t, e->v);
}

static void turn_round(kg_sample *s) {
    s->slope =
        (kg_cross_point){-s->slope.u, -s->slope.v, -s->slope.s, -s->slope.t, kg_neg(s->slope.x)};
    for (int k = 0; k < 2; k++)
        s->paper[k] = kg_scale2(s->paper[k], -1);
}

/* Continues the path along the arc from its end `from` on. */
static bool trace_arc(tracer *tr, const kg_topology *t, const kg_arc *arc, int from) {
    const kg_arc_end *e0 = &t->ends.items[arc->ends[from]];
    const kg_arc_end *e1 = &t->ends.items[arc->ends[1 - from]];
    tr->arc = arc;
    double way = arc->kind == KG_ARC_OVER_T ? e1->t - e0->t : e1->v - e0->v;
    tr->direction = way < 0 ? -1 : 1;
    size_t count = tr->path.samples.count;
    kg_sample p, q = end_point(tr, e1);
    if (count > 0) {
        p = tr->path.samples.items[count - 1];
    } else {
        p = end_point(tr, e0);
        if (!emit(tr, &p, false))
            return false;
    }
    if (arc->kind == KG_ARC_SHORT) {
        /* its tangent has no direction yet; where branches meet, none at all */
        if (e1->line < 0)
            q.slope = (kg_cross_point){0};
        if (kg_dot(q.slope.x, kg_sub(q.at.x, p.at.x)) < 0)
            turn_round(&q);
        return emit(tr, &q, !p.out && !q.out);
    }
    if (parameter(tr, &p) == parameter(tr, &q))
        return true;
    kg_sample m = middle(tr, &p, &q);
    return trace_halved(tr, &p, &m) && trace_halved(tr, &m, &q);
}

/* ---- branches -------------------------------------------------------------------------- */

static unsigned sides_at(const kg_ruled_pair *pair, const kg_cross_point *p) {
    unsigned sides = 0;
    for (int k = 0; k < COORDINATES; k++)
        for (int high = 0; high < 2; high++)
            if (coordinate(p, k) == side_value(pair, k, high))
                sides |= side_lo[k] << high;
    return sides;
}

bool kg_crossings_add(kg_crossings *crossings, const kg_ruled_pair *pair, const kg_sample *samples,
                      size_t count, bool closed) {
    double length = 0;
    for (size_t i = 1; i < count; i++)
        length += kg_dist(samples[i].at.x, samples[i - 1].at.x);
    if (length <= MIN_LENGTH * pair->a.size)
        return true;
    kg_crossing *branches = realloc(crossings->branches, (crossings->count + 1) * sizeof *branches);
    if (!branches)
        return false;
    crossings->branches = branches;
    kg_crossing *branch = &branches[crossings->count];
    *branch = (kg_crossing){.points = malloc(count * sizeof *branch->points), .closed = closed};
    if (!branch->points)
        return false;
    crossings->count++;
    /* Cells that shrink towards a singular point leave points at all scales: the fine ones go. */
    for (size_t i = 0; i < count; i++) {
        size_t n = branch->count;
        bool near =
            n > 0 && kg_dist(branch->points[n - 1].x, samples[i].at.x) < THIN * pair->tolerance;
        if (!near || (i + 1 == count && n == 1))
            branch->points[branch->count++] = samples[i].at;
        else if (i + 1 == count)
            branch->points[n - 1] = samples[i].at;
    }
    if (closed) {
        branch->points[branch->count - 1] = branch->points[0];
    } else {
        branch->ends[0] = sides_at(pair, &branch->points[0]);
        branch->ends[1] = sides_at(pair, &branch->points[branch->count - 1]);
    }
    return true;
}

/* Cuts a path into its stretches of inside spans. A closed path starts where it is outside. */
static bool cut(const kg_ruled_pair *pair, const kg_path *path, bool closed, kg_crossings *out) {
    size_t count = path->samples.count, start = 0;
    const bool *inside = path->inside.items;
    if (closed) {
        for (start = 1; start < count && inside[start]; start++)
            ;
        if (start == count)
            return kg_crossings_add(out, pair, path->samples.items, count, true);
    }
    /* the spans in order, from the one after `start`; a closed path's last point is its first */
    size_t spans = count - 1;
    kg_sample *run = malloc(count * sizeof *run);
    if (!run)
        return false;
    size_t length = 0;
    bool ok = true;
    for (size_t i = 0; i <= spans && ok; i++) {
        size_t end = closed ? (start + i) % spans + 1 : i + 1;
        bool in = i < spans && inside[end];
        if (in) {
            if (length == 0)
                run[length++] = path->samples.items[end - 1];
            run[length++] = path->samples.items[end];
        } else if (length > 0) {
            ok = kg_crossings_add(out, pair, run, length, false);
            length = 0;
        }
    }
    free(run);
    return ok;
}

/* Follows arcs from the end `first` of an arc until there is no next one. */
static bool trace_chain(tracer *tr, const kg_topology *t, bool *done, int first,
                        kg_crossings *out) {
    tr->path.samples.count = tr->path.inside.count = 0;
    int end = first;
    bool closed = false;
    while (end >= 0) {
        int index = t->ends.items[end].arc;
        if (index < 0)
            break;
        if (done[index]) {
            closed = end == first;
            break;
        }
        done[index] = true;
        const kg_arc *arc = &t->arcs.items[index];
        int from = arc->ends[0] == end ? 0 : 1;
        if (!trace_arc(tr, t, arc, from))
            return false;
        end = t->ends.items[arc->ends[1 - from]].match;
    }
    return cut(tr->pair, &tr->path, closed, out);
}

bool kg_trace(const kg_ruled_pair *pair, const kg_topology *topology, kg_crossings *out) {
    size_t count = topology->arcs.count;
    if (count == 0)
        return true;
    bool *done = calloc(count, sizeof *done);
    tracer tr = {.pair = pair};
    bool ok = done != NULL;
    /* open chains first: they start at ends without a neighbour */
    for (int pass = 0; pass < 2 && ok; pass++)
        for (size_t i = 0; i < count && ok; i++)
            for (int k = 0; k < 2 && ok && !done[i]; k++) {
                int end = topology->arcs.items[i].ends[k];
                if (pass == 1 || topology->ends.items[end].match < 0)
                    ok = trace_chain(&tr, topology, done, end, out);
            }
    free(done);
    free(tr.path.samples.items);
    free(tr.path.inside.items);
    return ok;
}
