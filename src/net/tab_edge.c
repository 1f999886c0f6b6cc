#include "net/tab_edge.h"

#include "base/array.h"

#include <stdlib.h>

/* mm a tooth has at least, however tightly the edge bends; nobody cuts smaller ones. */
static const double TOOTH = 2.5;
/* Radians at a point that end a base: at one flagged as a corner, and at any other. */
static const double CORNER = 0.09, BREAK = 0.4;
/* mm between samples along an edge, and how many an edge has at most. */
static const double STEP = 0.4;
enum { SAMPLES_MAX = 4000, BALANCE_STEPS = 12 };

kg_status kg_tab_loop_create(const kg_net_line *line, bool hole, kg_tab_loop *out) {
    double *s = malloc((line->count + 1) * sizeof *s), area = 0;
    if (!s)
        return KG_ERR_MEMORY;
    s[0] = 0;
    for (size_t i = 0; i < line->count; i++) {
        kg_vec2 a = line->points[i], b = line->points[(i + 1) % line->count];
        s[i + 1] = s[i] + kg_dist2(a, b);
        area += kg_cross2(kg_sub2(a, line->points[0]), kg_sub2(b, line->points[0]));
    }
    *out = (kg_tab_loop){line, s, (area > 0) != hole ? 1 : -1};
    return KG_OK;
}

void kg_tab_loop_destroy(kg_tab_loop *loop) {
    free(loop->s);
    loop->s = NULL;
}

double kg_tab_loop_length(const kg_tab_loop *loop) {
    return loop->s[loop->line->count];
}

/* The position in [0, length). */
static double wrapped(const kg_tab_loop *loop, double s) {
    double length = kg_tab_loop_length(loop);
    s = fmod(s, length);
    s = s < 0 ? s + length : s;
    return s < length ? s : 0;
}

/* The last point at or before s, s in [0, length). */
static size_t point_before(const kg_tab_loop *loop, double s) {
    size_t lo = 0, hi = loop->line->count;
    while (hi - lo > 1) {
        size_t mid = lo + (hi - lo) / 2;
        if (loop->s[mid] <= s)
            lo = mid;
        else
            hi = mid;
    }
    return lo;
}

kg_vec2 kg_tab_loop_at(const kg_tab_loop *loop, double s) {
    s = wrapped(loop, s);
    size_t i = point_before(loop, s), n = loop->line->count;
    kg_vec2 a = loop->line->points[i], b = loop->line->points[(i + 1) % n];
    double length = loop->s[i + 1] - loop->s[i];
    return length > 0 ? kg_lerp2(a, b, (s - loop->s[i]) / length) : a;
}

/* Angle from a to b, counterclockwise as y points up, in [0, 2 pi). */
static double angle_between(kg_vec2 a, kg_vec2 b) {
    double angle = atan2(kg_cross2(a, b), kg_dot2(a, b));
    return angle < 0 ? angle + 2 * KG_PI : angle;
}

double kg_tab_loop_gap(const kg_tab_loop *loop, double s) {
    /* Seen at several distances (mm): the smallest decides whether a flank starts free of the
     * contour, the largest what it meets soon. */
    static const double sight[] = {0.02, 0.1, 0.5};
    kg_vec2 p = kg_tab_loop_at(loop, s);
    double gap = 2 * KG_PI, length = kg_tab_loop_length(loop);
    for (size_t i = 0; i < sizeof sight / sizeof *sight; i++) {
        double reach = fmin(sight[i], length / 8);
        kg_vec2 ahead = kg_sub2(kg_tab_loop_at(loop, s + reach), p);
        kg_vec2 back = kg_sub2(kg_tab_loop_at(loop, s - reach), p);
        gap =
            fmin(gap, loop->outward > 0 ? angle_between(back, ahead) : angle_between(ahead, back));
    }
    return gap;
}

kg_tab_edge kg_tab_edge_of(const kg_tab_loop *loop, kg_net_side side, const double *bend) {
    size_t n = loop->line->count, last = side.first + side.count - 1;
    kg_tab_edge edge = {loop, side, bend, loop->s[side.first], 0};
    if (side.count > n)
        edge.to = edge.from + kg_tab_loop_length(loop);
    else
        edge.to = last < n ? loop->s[last] : kg_tab_loop_length(loop) + loop->s[last - n];
    return edge;
}

/* Signed turning of the contour at a point, over neighbours that differ from it. */
static double turn_at(const kg_tab_loop *loop, size_t i) {
    size_t n = loop->line->count, before = i, after = i;
    const kg_vec2 *p = loop->line->points;
    for (size_t k = 0; k < n && kg_dist2(p[before], p[i]) == 0; k++)
        before = before ? before - 1 : n - 1;
    for (size_t k = 0; k < n && kg_dist2(p[after], p[i]) == 0; k++)
        after = after + 1 < n ? after + 1 : 0;
    kg_vec2 in = kg_sub2(p[i], p[before]), out = kg_sub2(p[after], p[i]);
    return atan2(kg_cross2(in, out), kg_dot2(in, out));
}

static double bend_at(const kg_tab_edge *edge, double s) {
    const kg_tab_loop *loop = edge->loop;
    size_t n = loop->line->count;
    for (size_t k = 0; k + 1 < edge->side.count; k++) {
        size_t i = (edge->side.first + k) % n;
        double a = loop->s[i] + (edge->side.first + k >= n ? kg_tab_loop_length(loop) : 0);
        double length = loop->s[i + 1] - loop->s[i];
        if (s <= a + length && length > 0) {
            double t = fmin(fmax((s - a) / length, 0), 1);
            return edge->bend[k] + t * (edge->bend[k + 1] - edge->bend[k]);
        }
    }
    return edge->bend[edge->side.count - 1];
}

/* Turning along one piece of an edge between corners: sums[i] up to sample i, on paper or in
 * space, whichever grows more. */
typedef struct piece {
    double from, step;
    size_t count; /* samples, one more than steps */
    double *sums;
} piece;

static kg_status sample_piece(const kg_tab_edge *edge, double from, double to, piece *out) {
    size_t steps = (size_t)fmin(fmax(ceil((to - from) / STEP), 1), SAMPLES_MAX);
    piece p = {from, (to - from) / (double)steps, steps + 1, malloc((steps + 1) * sizeof(double))};
    if (!p.sums)
        return KG_ERR_MEMORY;
    kg_vec2 before = kg_tab_loop_at(edge->loop, from), leg = {0, 0};
    double bend = edge->bend ? bend_at(edge, from) : 0;
    p.sums[0] = 0;
    for (size_t i = 1; i <= steps; i++) {
        double s = from + p.step * (double)i, turn = 0;
        kg_vec2 point = kg_tab_loop_at(edge->loop, s), next = kg_sub2(point, before);
        if (i > 1)
            turn = fabs(atan2(kg_cross2(leg, next), kg_dot2(leg, next)));
        if (edge->bend) {
            double now = bend_at(edge, s);
            turn = fmax(turn, now - bend);
            bend = now;
        }
        p.sums[i] = p.sums[i - 1] + turn;
        before = point;
        leg = next;
    }
    *out = p;
    return KG_OK;
}

static bool base_fits(const piece *p, size_t i, size_t j, kg_tab_limits limits, double scale) {
    double length = p->step * (double)(j - i), turn = p->sums[j] - p->sums[i];
    if (length > limits.length * scale)
        return false;
    /* An arc of this length and turning rises length * turn / 8 over its chord. */
    return length <= TOOTH * scale ||
           (turn <= limits.turn * scale && length * turn / 8 <= limits.sagitta * scale);
}

/* As many bases as the limits, scaled, need when each takes as much as it can. */
static size_t count_bases(const piece *p, kg_tab_limits limits, double scale, size_t *ends) {
    size_t count = 0;
    for (size_t i = 0; i + 1 < p->count; count++) {
        size_t j = i + 1;
        while (j + 1 < p->count && base_fits(p, i, j + 1, limits, scale))
            j++;
        i = j;
        if (ends)
            ends[count] = j;
    }
    return count;
}

typedef struct numbers {
    double *items;
    size_t count, capacity;
} numbers;

/* Adds the ends of the bases of one piece, `to` the last. The limits are tightened as far as the
 * number of bases stays the same, so that the last one is not a crumb. */
static kg_status divide_piece(const kg_tab_edge *edge, double from, double to, kg_tab_limits limits,
                              numbers *out) {
    piece p;
    kg_status status = sample_piece(edge, from, to, &p);
    if (status != KG_OK)
        return status;
    size_t count = count_bases(&p, limits, 1, NULL);
    double lo = 0, hi = 1;
    for (int i = 0; i < BALANCE_STEPS && count > 1; i++) {
        double mid = (lo + hi) / 2;
        if (count_bases(&p, limits, mid, NULL) == count)
            hi = mid;
        else
            lo = mid;
    }
    size_t *ends = malloc((count + 1) * sizeof *ends);
    status = ends ? KG_OK : KG_ERR_MEMORY;
    if (status == KG_OK) {
        count_bases(&p, limits, hi, ends);
        for (size_t i = 0; i < count && status == KG_OK; i++) {
            double end = i + 1 < count ? from + p.step * (double)ends[i] : to;
            status = kg_push(out, end) ? KG_OK : KG_ERR_MEMORY;
        }
    }
    free(ends);
    free(p.sums);
    return status;
}

kg_status kg_tab_edge_divide(const kg_tab_edge *edge, kg_tab_limits limits, double **out,
                             size_t *out_count) {
    const kg_net_line *line = edge->loop->line;
    numbers ends = {0};
    double begin = edge->from;
    /* A base over a whole contour, or half of it, has no chord to stand on. */
    if (edge->side.count > line->count)
        limits.length = fmin(limits.length, kg_tab_loop_length(edge->loop) / 3);
    kg_status status = kg_push(&ends, begin) ? KG_OK : KG_ERR_MEMORY;
    for (size_t k = 1; k < edge->side.count && status == KG_OK; k++) {
        size_t i = (edge->side.first + k) % line->count;
        double turn = fabs(turn_at(edge->loop, i));
        double end = edge->loop->s[i];
        end += edge->side.first + k >= line->count ? kg_tab_loop_length(edge->loop) : 0;
        bool last = k + 1 == edge->side.count;
        if (last)
            end = edge->to;
        else if (turn < CORNER || (turn < BREAK && !line->corners[i]))
            continue;
        if (end > begin || (last && ends.count == 1))
            status = divide_piece(edge, begin, end, limits, &ends);
        begin = end;
    }
    if (status != KG_OK) {
        free(ends.items);
        return status;
    }
    *out = ends.items;
    *out_count = ends.count - 1;
    return KG_OK;
}

double kg_tab_edge_bulge(const kg_tab_edge *edge) {
    double sum = 0;
    for (size_t k = 1; k + 1 < edge->side.count; k++)
        sum += turn_at(edge->loop, (edge->side.first + k) % edge->loop->line->count);
    return sum * edge->loop->outward;
}
