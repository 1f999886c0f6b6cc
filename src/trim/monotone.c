/*
 * Triangulation by a sweep in y.
 *
 * Between two events the line y = const meets the polygon in intervals. Each knows the edges on its
 * left and right and its helper, the last point that can be joined to the next one. A diagonal cuts
 * a loop in two: both ends are doubled, one corner for either side, so that what is left at the end
 * are closed lists of corners, monotone in y.
 */
#include "trim/triangulation.h"

#include "base/array.h"

#include <stdlib.h>

enum { NONE = -1 };

typedef struct corner {
    int point, next, prev;
} corner;

/* Edges are named by their upper corners: left -> next[left] falls, prev[right] -> right rises. */
typedef struct interval {
    int left, right, helper;
    bool merge; /* the helper closed a gap and waits for a diagonal */
} interval;

typedef struct sweep {
    const kg_vec2 *points, *paper;
    corner *corners;
    int corner_count;
    struct {
        interval *items;
        size_t count, capacity;
    } intervals;
} sweep;

typedef struct ordered {
    double y, x;
    int index;
} ordered;

static int compare_points(const void *a, const void *b) {
    const ordered *p = a, *q = b;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

static bool is_above(const kg_vec2 *points, int i, int j) {
    ordered p = {points[i].y, points[i].x, i}, q = {points[j].y, points[j].x, j};
    return compare_points(&p, &q) > 0;
}

/* Twice the area of a triangle. */
static double turn(const kg_vec2 *points, int a, int b, int c) {
    return kg_cross2(kg_sub2(points[b], points[a]), kg_sub2(points[c], points[a]));
}

/* Joins corners a and b; returns the new corner at a, on the side of a's next. */
static int add_diagonal(sweep *s, int a, int b) {
    corner *c = s->corners;
    int a2 = s->corner_count++, b2 = s->corner_count++;
    c[a2] = (corner){c[a].point, c[a].next, b};
    c[b2] = (corner){c[b].point, c[b].next, a};
    c[c[a].next].prev = a2;
    c[c[b].next].prev = b2;
    c[a].next = b2;
    c[b].next = a2;
    return a2;
}

/* ---- loops that touch ------------------------------------------------------------------- */

enum { MAX_TOUCHING = 32 };

static double direction(const sweep *s, int from, int to) {
    kg_vec2 d = kg_sub2(s->points[to], s->points[from]);
    return atan2(d.y, d.x);
}

/* Gives the corners at one place the neighbours between which the polygon's inside lies: from each
 * way in, the next way out clockwise. */
static void join_corners(sweep *s, const int *at, size_t count) {
    const double turn_round = 6.283185307179586;
    int in[MAX_TOUCHING], out[MAX_TOUCHING];
    for (size_t i = 0; i < count; i++)
        in[i] = s->corners[at[i]].prev, out[i] = s->corners[at[i]].next;
    for (size_t i = 0; i < count; i++) {
        double back = direction(s, at[i], in[i]), least = INFINITY;
        size_t best = i;
        for (size_t j = 0; j < count; j++) {
            double angle = back - direction(s, at[j], out[j]);
            angle += angle <= 0 ? turn_round : angle > turn_round ? -turn_round : 0;
            if (angle < least)
                least = angle, best = j;
        }
        s->corners[at[i]].next = out[best];
        s->corners[out[best]].prev = at[i];
    }
}

/* Loops that touch become one, which the sweep takes for simple. */
static void join_touching(sweep *s, const ordered *order, size_t count, double snap) {
    for (size_t i = 0; i < count; i++) {
        int at[MAX_TOUCHING] = {order[i].index};
        size_t n = 1;
        const corner *c = &s->corners[at[0]];
        for (size_t j = i + 1; j < count && order[j].y - order[i].y <= snap; j++)
            if (fabs(order[j].x - order[i].x) <= snap && n < MAX_TOUCHING &&
                order[j].index != c->next && order[j].index != c->prev)
                at[n++] = order[j].index;
        if (n > 1)
            join_corners(s, at, n);
    }
}

/* ---- events ---------------------------------------------------------------------------- */

static int interval_by_side(const sweep *s, int corner_index, bool right) {
    for (size_t i = 0; i < s->intervals.count; i++)
        if ((right ? s->intervals.items[i].right : s->intervals.items[i].left) == corner_index)
            return (int)i;
    return NONE;
}

static double edge_x(const sweep *s, int upper, int lower, double y) {
    kg_vec2 p = s->points[s->corners[lower].point], q = s->points[s->corners[upper].point];
    return q.y > p.y ? p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x) : p.x;
}

/* The interval that holds a point, or fails to by least. */
static int interval_around(const sweep *s, kg_vec2 at) {
    int best = NONE;
    double least = INFINITY;
    for (size_t i = 0; i < s->intervals.count; i++) {
        const interval *k = &s->intervals.items[i];
        double left = edge_x(s, k->left, s->corners[k->left].next, at.y);
        double right = edge_x(s, k->right, s->corners[k->right].prev, at.y);
        double off = fmax(left - at.x, at.x - right);
        if (off < least)
            least = off, best = (int)i;
    }
    return best;
}

static void remove_interval(sweep *s, int i) {
    s->intervals.items[i] = s->intervals.items[--s->intervals.count];
}

/* Closes a pending gap of interval i with a diagonal from v; the new corner at v, or v. */
static int close_gap(sweep *s, int i, int v) {
    interval *k = &s->intervals.items[i];
    if (!k->merge)
        return v;
    k->merge = false;
    return add_diagonal(s, v, k->helper);
}

/* Both edges of v rise: an interval begins, or one is split. */
static kg_status begin_at(sweep *s, int v) {
    const corner *c = &s->corners[v];
    int left = c->prev, right = c->next;
    interval fresh = {left, right, v, false};
    if (turn(s->points, s->corners[left].point, c->point, s->corners[right].point) <= 0) {
        int i = interval_around(s, s->points[c->point]);
        if (i == NONE)
            return KG_ERR_INPUT;
        interval *k = &s->intervals.items[i];
        fresh.right = k->right;
        k->right = right;
        k->helper = add_diagonal(s, v, k->helper);
        k->merge = false;
    }
    return kg_push(&s->intervals, fresh) ? KG_OK : KG_ERR_MEMORY;
}

/* Both edges of v fall: an interval ends, or two become one. */
static kg_status end_at(sweep *s, int v) {
    int i = interval_by_side(s, v, false), j = interval_by_side(s, v, true);
    if (i == NONE || j == NONE)
        return KG_ERR_INPUT;
    close_gap(s, i, v);
    if (i == j) {
        remove_interval(s, i);
        return KG_OK;
    }
    interval *left = &s->intervals.items[j];
    left->helper = close_gap(s, j, v);
    left->right = s->intervals.items[i].right;
    left->merge = true;
    remove_interval(s, i);
    return KG_OK;
}

/* The boundary goes up through v, on an interval's right side, or down, on its left. */
static kg_status pass_at(sweep *s, int v, bool up) {
    int i = interval_by_side(s, v, up);
    if (i == NONE)
        return KG_ERR_INPUT;
    int fresh = close_gap(s, i, v);
    interval *k = &s->intervals.items[i];
    if (up) {
        k->right = s->corners[fresh].next;
        k->helper = fresh;
    } else {
        k->left = s->corners[v].prev;
        k->helper = v;
    }
    return KG_OK;
}

static kg_status run_sweep(sweep *s, const ordered *order, size_t count) {
    kg_status status = KG_OK;
    for (size_t i = 0; i < count && !status; i++) {
        int v = order[i].index;
        bool next_above = is_above(s->points, s->corners[s->corners[v].next].point, v);
        bool prev_above = is_above(s->points, s->corners[s->corners[v].prev].point, v);
        if (next_above && prev_above)
            status = begin_at(s, v);
        else if (!next_above && !prev_above)
            status = end_at(s, v);
        else
            status = pass_at(s, v, next_above);
    }
    return status;
}

/* ---- triangles of monotone pieces ------------------------------------------------------- */

typedef struct writer {
    uint32_t *out;
    size_t count, limit;
} writer;

static bool write_triangle(writer *w, const sweep *s, int a, int b, int c) {
    if (w->count == w->limit)
        return false;
    uint32_t *t = w->out + 3 * w->count++;
    t[0] = (uint32_t)s->corners[a].point;
    t[1] = (uint32_t)s->corners[b].point;
    t[2] = (uint32_t)s->corners[c].point;
    return true;
}

/* Triangles of the piece that holds a corner. `stack`: room for its corners; corners that are done
 * have no point. */
static bool triangulate_piece(sweep *s, int start, int *stack, writer *w) {
    corner *c = s->corners;
    int low = start, high = start;
    for (int i = c[start].next; i != start; i = c[i].next) {
        low = is_above(s->points, c[low].point, c[i].point) ? i : low;
        high = is_above(s->points, c[i].point, c[high].point) ? i : high;
    }
    /* right chain by next, left chain by prev, both upwards */
    int right = c[low].next, left = c[low].prev, top = 0;
    bool last_right = false, ok = true;
    stack[top++] = low;
    while (ok && (left != high || right != high)) {
        bool is_right =
            left == high || (right != high && is_above(s->points, c[left].point, c[right].point));
        int v = is_right ? right : left;
        if (top > 1 && is_right != last_right) {
            for (int i = 0; i + 1 < top && ok; i++)
                ok = is_right ? write_triangle(w, s, stack[i], v, stack[i + 1])
                              : write_triangle(w, s, stack[i], stack[i + 1], v);
            stack[0] = stack[top - 1];
            top = 1;
        }
        while (top > 1 && ok) {
            int a = stack[top - 2], b = stack[top - 1];
            double area = turn(s->paper, c[a].point, c[b].point, c[v].point);
            if (is_right ? area <= 0 : area >= 0)
                break;
            ok = is_right ? write_triangle(w, s, a, b, v) : write_triangle(w, s, a, v, b);
            top--;
        }
        stack[top++] = v;
        last_right = is_right;
        if (is_right)
            right = c[right].next;
        else
            left = c[left].prev;
    }
    for (int i = 0; i + 1 < top && ok; i++)
        ok = last_right ? write_triangle(w, s, stack[i], stack[i + 1], high)
                        : write_triangle(w, s, stack[i], high, stack[i + 1]);
    for (int i = c[start].next; i != start; i = c[i].next)
        c[i].point = NONE;
    c[start].point = NONE;
    return ok;
}

static bool triangulate_pieces(sweep *s, int *stack, writer *w) {
    for (int i = 0; i < s->corner_count; i++)
        if (s->corners[i].point != NONE && !triangulate_piece(s, i, stack, w))
            return false;
    return true;
}

kg_status kg_monotone_triangulate(const kg_polygon *polygon, uint32_t *out, size_t *out_count) {
    size_t n = polygon->count;
    if (n > INT32_MAX / 8)
        return KG_ERR_MEMORY;
    /* every event adds two diagonals at most */
    sweep s = {.points = polygon->points,
               .paper = polygon->paper,
               .corners = calloc(5 * n + 1, sizeof *s.corners)};
    ordered *order = calloc(n + 1, sizeof *order);
    int *stack = calloc(5 * n + 1, sizeof *stack);
    kg_status status = s.corners && order && stack ? KG_OK : KG_ERR_MEMORY;
    size_t first = 0;
    for (size_t l = 0; l < polygon->loop_count && !status; first = polygon->ends[l++])
        for (size_t i = first; i < polygon->ends[l]; i++) {
            size_t next = i + 1 < polygon->ends[l] ? i + 1 : first;
            size_t prev = i > first ? i - 1 : polygon->ends[l] - 1;
            s.corners[i] = (corner){(int)i, (int)next, (int)prev};
            order[i] = (ordered){s.points[i].y, s.points[i].x, (int)i};
        }
    s.corner_count = (int)n;
    if (!status) {
        qsort(order, n, sizeof *order, compare_points);
        if (polygon->loop_count > 1)
            join_touching(&s, order, n, polygon->snap);
        status = run_sweep(&s, order, n);
    }
    writer w = {out, 0, kg_triangle_limit(polygon)};
    if (!status && !triangulate_pieces(&s, stack, &w))
        status = KG_ERR_INPUT;
    if (!status)
        *out_count = w.count;
    free(s.corners);
    free(s.intervals.items);
    free(order);
    free(stack);
    return status;
}
