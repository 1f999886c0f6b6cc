#include "net/nest_raster.h"

#include "base/array.h"

#include <stdlib.h>

/* One more cell on each side of what the reach needs, for rounding. */
static const int GUARD = 1;

enum { BITS = 64 };

/* A bit for every cell, rows from whole words on. */
typedef struct canvas {
    uint64_t *words;
    size_t stride;             /* words of a row */
    int x0, y0, width, height; /* in cells; (x0, y0) is the first one */
    double cell;
} canvas;

static uint64_t *row_of(const canvas *c, int row) {
    return c->words + (size_t)(row - c->y0) * c->stride;
}

/* Sets bits lo … hi of a row. */
static void set_bits(uint64_t *row, int lo, int hi) {
    int i = lo / BITS, last = hi / BITS;
    uint64_t mask = UINT64_MAX << (lo % BITS);
    for (; i < last; i++, mask = UINT64_MAX)
        row[i] |= mask;
    row[i] |= mask & (UINT64_MAX >> (BITS - 1 - hi % BITS));
}

/* The first bit from `from` on that is set (or not), `width` if there is none. */
static int next_bit(const uint64_t *row, int from, int width, bool set) {
    for (; from < width; from = (from / BITS + 1) * BITS) {
        uint64_t word = row[from / BITS], bits = (set ? word : ~word) >> (from % BITS);
        if (bits) {
            from += __builtin_ctzll(bits);
            return from < width ? from : width;
        }
    }
    return width;
}

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

static int cell_of(double x, double cell) {
    return (int)floor(x / cell);
}

static int clamp_int(int v, int lo, int hi) {
    return v < lo ? lo : v > hi ? hi : v;
}

/* A segment widened by a disc: all points within `reach` of it. */
typedef struct capsule {
    kg_vec2 end[2];
    double reach;
    kg_vec2 aside; /* from the segment to the side of the capsule on its left */
} capsule;

/* How far the capsule reaches at height y, to the right (sign 1) or left (-1), where y is one of
 * its heights: on a disc or on a side, whichever is farthest. */
static double side_at(const capsule *c, double y, double sign) {
    double far = -INFINITY;
    for (int k = 0; k < 2; k++) {
        double off = y - c->end[k].y, room = c->reach * c->reach - off * off;
        if (room >= 0)
            far = kg_max(sign * c->end[k].x + sqrt(room), far);
    }
    /* of the two sides the one on the right has an outward normal with x > 0 */
    double way = sign * c->aside.x < 0 ? -1 : 1;
    kg_vec2 p = kg_v2(c->end[0].x + way * c->aside.x, c->end[0].y + way * c->aside.y);
    double rise = c->end[1].y - c->end[0].y, t = (y - p.y) / rise;
    if (rise != 0 && t >= 0 && t <= 1)
        far = kg_max(sign * (p.x + t * (c->end[1].x - c->end[0].x)), far);
    if (isinf(far)) /* at the very top or bottom, and rounded out */
        return c->end[fabs(y - c->end[0].y) > fabs(y - c->end[1].y)].x;
    return sign * far;
}

/* mm more than the reach, for what rounding may take from it. */
static const double ROUNDING = 1e-9;

/* Marks the cells within `reach` of a segment. In each row of cells they are one run, as the
 * capsule is convex: its ends in a row are those at the height nearest to its leftmost and to its
 * rightmost point. */
static void mark_segment(canvas *c, kg_vec2 a, kg_vec2 b, double reach) {
    kg_vec2 d = kg_sub2(b, a);
    double length = kg_len2(d), wide = reach + ROUNDING;
    capsule of = {{a, b}, wide, {0, 0}};
    if (length > 0)
        of.aside = kg_v2(-d.y * wide / length, d.x * wide / length);
    double low = kg_min(a.y, b.y) - wide, high = kg_max(a.y, b.y) + wide;
    double leftmost = a.x < b.x ? a.y : b.y, rightmost = a.x < b.x ? b.y : a.y;
    int last_row = c->y0 + c->height - 1, last_col = c->x0 + c->width - 1;
    int row0 = clamp_int(cell_of(low, c->cell), c->y0, last_row);
    int row1 = clamp_int(cell_of(high, c->cell), c->y0, last_row);
    for (int row = row0; row <= row1; row++) {
        double top = kg_max(row * c->cell, low), bottom = kg_min((row + 1) * c->cell, high);
        if (top > bottom) /* outside the window */
            continue;
        double x0 = side_at(&of, kg_min(kg_max(leftmost, top), bottom), -1);
        double x1 = side_at(&of, kg_min(kg_max(rightmost, top), bottom), 1);
        int lo = clamp_int(cell_of(x0, c->cell), c->x0, last_col + 1);
        int hi = clamp_int(cell_of(x1, c->cell), c->x0 - 1, last_col);
        if (lo <= hi)
            set_bits(row_of(c, row), lo - c->x0, hi - c->x0);
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
                row_of(c, row)[(col - c->x0) / BITS] ^= (uint64_t)1 << ((col - c->x0) % BITS);
            }
        }
    for (int row = 0; row < c->height; row++) {
        uint64_t *words = row_of(c, row + c->y0), inside = 0;
        for (size_t i = 0; i < c->stride; i++) {
            for (int shift = 1; shift < BITS; shift *= 2)
                words[i] ^= words[i] << shift;
            words[i] ^= inside;
            inside = words[i] >> (BITS - 1) ? UINT64_MAX : 0;
        }
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
        const uint64_t *words = row_of(c, row + c->y0);
        for (int begin, end = 0; (begin = next_bit(words, end, c->width, true)) < c->width;) {
            end = next_bit(words, begin, c->width, false);
            if (!kg_push(&runs, ((kg_nest_run){row + c->y0, begin + c->x0, end - 1 + c->x0}))) {
                free(runs.items);
                return false;
            }
        }
    }
    if (runs.count)
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
    c.stride = (size_t)(c.width - 1) / BITS + 1;
    c.words = calloc((size_t)c.height, c.stride * sizeof *c.words);
    if (!c.words)
        return KG_ERR_MEMORY;
    mark_inside(&c, shape, points);
    size_t begin = 0;
    for (size_t k = 0; k < shape->loop_count; begin = shape->ends[k++])
        for (size_t i = begin, n = shape->ends[k]; i < n; i++)
            mark_segment(&c, points[i], points[i + 1 < n ? i + 1 : begin], reach);
    bool done = collect_runs(&c, out);
    free(c.words);
    return done ? KG_OK : KG_ERR_MEMORY;
}
