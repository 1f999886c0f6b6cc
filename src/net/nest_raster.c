#include "net/nest_raster.h"

#include "base/array.h"

#include <stdlib.h>

/* One more cell on each side of what the reach needs, for rounding. */
static const int GUARD = 1;

typedef struct canvas {
    unsigned char *cells;
    int x0, y0, width, height; /* in cells; (x0, y0) is the first one */
    double cell;
} canvas;

void kg_nest_shape_turn(const kg_nest_shape *shape, double angle, kg_vec2 *out_points,
                        kg_vec2 *out_offset, kg_vec2 *out_size) {
    double c = cos(angle), s = sin(angle);
    size_t n = shape->ends[shape->loop_count - 1];
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < n; i++) {
        kg_vec2 p = shape->points[i];
        out_points[i] = kg_v2(c * p.x - s * p.y, s * p.x + c * p.y);
        kg_box2_add(&box, out_points[i]);
    }
    for (size_t i = 0; i < n; i++)
        out_points[i] = kg_sub2(out_points[i], box.lo);
    *out_offset = kg_scale2(box.lo, -1);
    *out_size = kg_sub2(box.hi, box.lo);
}

static double point_segment_distance(kg_vec2 p, kg_vec2 a, kg_vec2 b) {
    kg_vec2 d = kg_sub2(b, a);
    double dd = kg_dot2(d, d);
    double t = dd > 0 ? kg_dot2(kg_sub2(p, a), d) / dd : 0;
    return kg_dist2(p, kg_lerp2(a, b, fmin(fmax(t, 0), 1)));
}

static double point_box_distance(kg_vec2 p, kg_box2 box) {
    double dx = fmax(fmax(box.lo.x - p.x, p.x - box.hi.x), 0);
    double dy = fmax(fmax(box.lo.y - p.y, p.y - box.hi.y), 0);
    return sqrt(dx * dx + dy * dy);
}

/* Whether the segment comes within `reach` of the box: it crosses a diagonal of it, or the nearest
 * points are an end of the one and a side of the other. */
static bool segment_near_box(kg_vec2 a, kg_vec2 b, kg_box2 box, double reach) {
    kg_vec2 corner[4] = {box.lo, {box.hi.x, box.lo.y}, box.hi, {box.lo.x, box.hi.y}};
    if (point_box_distance(a, box) <= reach || point_box_distance(b, box) <= reach)
        return true;
    kg_vec2 d = kg_sub2(b, a);
    bool left = false, right = false;
    for (int i = 0; i < 4; i++) {
        if (point_segment_distance(corner[i], a, b) <= reach)
            return true;
        double side = kg_cross2(d, kg_sub2(corner[i], a));
        left = left || side >= 0;
        right = right || side <= 0;
    }
    return left && right && fmin(a.x, b.x) <= box.hi.x && fmax(a.x, b.x) >= box.lo.x &&
           fmin(a.y, b.y) <= box.hi.y && fmax(a.y, b.y) >= box.lo.y;
}

static int cell_of(double x, double cell) {
    return (int)floor(x / cell);
}

static int clamp_int(int v, int lo, int hi) {
    return v < lo ? lo : v > hi ? hi : v;
}

/* Marks the cells within `reach` of a segment. In each row they are one run (the set is convex), so
 * only its two ends are searched. */
static void mark_segment(canvas *c, kg_vec2 a, kg_vec2 b, double reach) {
    int last_row = c->y0 + c->height - 1, last_col = c->x0 + c->width - 1;
    int row0 = clamp_int(cell_of(fmin(a.y, b.y) - reach, c->cell), c->y0, last_row);
    int row1 = clamp_int(cell_of(fmax(a.y, b.y) + reach, c->cell), c->y0, last_row);
    kg_vec2 d = kg_sub2(b, a);
    for (int row = row0; row <= row1; row++) {
        double top = row * c->cell - reach, bottom = (row + 1) * c->cell + reach, t0 = 0, t1 = 1;
        if (d.y != 0) {
            double s0 = (top - a.y) / d.y, s1 = (bottom - a.y) / d.y;
            t0 = fmin(fmax(fmin(s0, s1), 0), 1);
            t1 = fmin(fmax(fmax(s0, s1), 0), 1);
        }
        double x0 = a.x + t0 * d.x, x1 = a.x + t1 * d.x;
        int lo = clamp_int(cell_of(fmin(x0, x1) - reach, c->cell), c->x0, last_col);
        int hi = clamp_int(cell_of(fmax(x0, x1) + reach, c->cell), c->x0, last_col);
        kg_box2 box = {{0, row * c->cell}, {0, (row + 1) * c->cell}};
        for (bool found = false; lo <= hi && !found; lo += !found) {
            box.lo.x = lo * c->cell;
            box.hi.x = (lo + 1) * c->cell;
            found = segment_near_box(a, b, box, reach);
        }
        for (bool found = false; lo <= hi && !found; hi -= !found) {
            box.lo.x = hi * c->cell;
            box.hi.x = (hi + 1) * c->cell;
            found = segment_near_box(a, b, box, reach);
        }
        for (int col = lo; col <= hi; col++)
            c->cells[(size_t)(row - c->y0) * (size_t)c->width + (size_t)(col - c->x0)] = 1;
    }
}

/* Adds to every row, per edge that crosses its middle, a flip of all cells right of the crossing;
 * the running parity along the row is then "inside". */
static void mark_inside(canvas *c, const kg_nest_shape *shape, const kg_vec2 *points) {
    size_t begin = 0;
    for (size_t k = 0; k < shape->loop_count; begin = shape->ends[k++])
        for (size_t i = begin, n = shape->ends[k]; i < n; i++) {
            kg_vec2 a = points[i], b = points[i + 1 < n ? i + 1 : begin];
            if (a.y > b.y) {
                kg_vec2 swapped = a;
                a = b;
                b = swapped;
            }
            int first = (int)fmax(ceil(a.y / c->cell - 0.5), c->y0);
            for (int row = first; row < c->y0 + c->height; row++) {
                double y = (row + 0.5) * c->cell;
                if (y < a.y)
                    continue;
                if (y >= b.y)
                    break;
                double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
                int col = clamp_int((int)ceil(x / c->cell - 0.5), c->x0, c->x0 + c->width - 1);
                c->cells[(size_t)(row - c->y0) * (size_t)c->width + (size_t)(col - c->x0)] ^= 1;
            }
        }
    for (int row = 0; row < c->height; row++) {
        unsigned char *cells = c->cells + (size_t)row * (size_t)c->width, inside = 0;
        for (int col = 0; col < c->width; col++)
            cells[col] = inside = (unsigned char)(inside ^ cells[col]);
    }
}

static int longer_first(const void *pa, const void *pb) {
    const kg_nest_run *a = pa, *b = pb;
    int la = a->hi - a->lo, lb = b->hi - b->lo;
    if (la != lb)
        return la > lb ? -1 : 1;
    if (a->row != b->row)
        return a->row < b->row ? -1 : 1;
    return (a->lo > b->lo) - (a->lo < b->lo);
}

static bool collect_runs(const canvas *c, kg_nest_raster *out) {
    struct {
        kg_nest_run *items;
        size_t count, capacity;
    } runs = {0};
    for (int row = 0; row < c->height; row++) {
        const unsigned char *cells = c->cells + (size_t)row * (size_t)c->width;
        for (int col = 0; col < c->width;) {
            int begin = col;
            while (col < c->width && cells[col])
                col++;
            kg_nest_run run = {row + c->y0, begin + c->x0, col - 1 + c->x0};
            if (col > begin && !kg_push(&runs, run)) {
                free(runs.items);
                return false;
            }
            col += col == begin;
        }
    }
    qsort(runs.items, runs.count, sizeof *runs.items, longer_first);
    out->runs = runs.items;
    out->count = runs.count;
    return true;
}

kg_status kg_nest_raster_make(const kg_nest_shape *shape, const kg_vec2 *points, double cell,
                              double reach, const kg_box2 *window, kg_nest_raster *out) {
    kg_box2 box = kg_box2_empty();
    for (size_t i = 0; i < shape->ends[shape->loop_count - 1]; i++)
        kg_box2_add(&box, points[i]);
    if (window) {
        box.lo = kg_v2(fmax(box.lo.x, window->lo.x), fmax(box.lo.y, window->lo.y));
        box.hi = kg_v2(fmin(box.hi.x, window->hi.x), fmin(box.hi.y, window->hi.y));
    }
    canvas c = {.cell = cell};
    c.x0 = cell_of(box.lo.x - reach, cell) - GUARD;
    c.y0 = cell_of(box.lo.y - reach, cell) - GUARD;
    c.width = cell_of(box.hi.x + reach, cell) + GUARD - c.x0 + 1;
    c.height = cell_of(box.hi.y + reach, cell) + GUARD - c.y0 + 1;
    if (c.width <= 0 || c.height <= 0) {
        *out = (kg_nest_raster){0};
        return KG_OK;
    }
    c.cells = calloc((size_t)c.width, (size_t)c.height);
    if (!c.cells)
        return KG_ERR_MEMORY;
    mark_inside(&c, shape, points);
    size_t begin = 0;
    for (size_t k = 0; k < shape->loop_count; begin = shape->ends[k++])
        for (size_t i = begin, n = shape->ends[k]; i < n; i++)
            mark_segment(&c, points[i], points[i + 1 < n ? i + 1 : begin], reach);
    bool done = collect_runs(&c, out);
    free(c.cells);
    return done ? KG_OK : KG_ERR_MEMORY;
}
