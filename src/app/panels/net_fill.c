#include "app/panels/net_fill.h"

#include "app/ui/ui.h"
#include "base/array.h"

#include <stdlib.h>

enum { ROWS_TRIED = 9, MOST_ROWS = 8192 };

typedef struct crossing {
    int row;
    double x;
} crossing;

typedef struct crossings {
    crossing *items;
    size_t count, capacity;
} crossings;

void kg_fill_begin(kg_fill *f) {
    *f = (kg_fill){0};
}

void kg_fill_add(kg_fill *f, const kg_polyline *outline) {
    size_t before = f->points.count;
    bool ok = kg_reserve(&f->points, before + outline->count);
    for (size_t i = 0; i < outline->count && ok; i++)
        f->points.items[f->points.count++] = outline->items[i];
    if (!ok || !kg_push(&f->ends, f->points.count))
        f->points.count = before;
}

void kg_fill_end(kg_fill *f) {
    free(f->points.items);
    free(f->ends.items);
}

static int compare(const void *a, const void *b) {
    const crossing *p = a, *q = b;
    if (p->row != q->row)
        return p->row < q->row ? -1 : 1;
    return p->x < q->x ? -1 : p->x > q->x;
}

static kg_vec2 turned(kg_vec2 p, double c, double s) {
    return kg_v2(c * p.x - s * p.y, s * p.x + c * p.y);
}

/* Where the rows y = (row + 1/2) spacing, lo <= row < hi, cross the outlines turned by (c, s). In
 * order, so that each two bound a span. */
static crossings cross(const kg_fill *f, double c, double s, double spacing, int lo, int hi) {
    crossings found = {0};
    size_t first = 0;
    bool ok = true;
    for (size_t k = 0; k < f->ends.count; k++) {
        size_t end = f->ends.items[k];
        for (size_t i = first, j = end - 1; i < end && end > first; j = i++) {
            kg_vec2 a = turned(f->points.items[j], c, s), b = turned(f->points.items[i], c, s);
            kg_vec2 low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
            double from = fmax(ceil(low.y / spacing - 0.5), lo);
            double to = fmin(ceil(high.y / spacing - 0.5), hi);
            for (double row = from; row < to && ok; row++) {
                double t = ((row + 0.5) * spacing - low.y) / (high.y - low.y);
                crossing at = {(int)row, low.x + t * (high.x - low.x)};
                ok = kg_push(&found, at);
            }
        }
        first = end;
    }
    if (!ok)
        found.count = 0;
    if (found.count > 1)
        qsort(found.items, found.count, sizeof *found.items, compare);
    return found;
}

void kg_fill_rows(const kg_fill *f, kg_color color, const kg_area *clip) {
    crossings found =
        cross(f, 1, 0, 1, (int)floor(clip->y), (int)ceil(clip->y + fmin(clip->height, MOST_ROWS)));
    for (size_t i = 0; i + 1 < found.count; i += 2) {
        double x0 = fmax(found.items[i].x, clip->x);
        double x1 = fmin(found.items[i + 1].x, clip->x + clip->width);
        if (x1 > x0)
            kg_ui_canvas_rect((kg_area){x0, found.items[i].row, x1 - x0, 1}, color, 0);
    }
    free(found.items);
}

void kg_fill_hatch(const kg_fill *f, kg_color color, double spacing, double width,
                   const kg_area *clip) {
    const double r = sqrt(0.5);
    double reach = (fabs(clip->x) + clip->width + fabs(clip->y) + clip->height) / spacing;
    int rows = (int)fmin(reach + 1, MOST_ROWS);
    crossings found = cross(f, r, r, spacing, -rows, rows);
    for (size_t i = 0; i + 1 < found.count; i += 2) {
        double y = (found.items[i].row + 0.5) * spacing;
        kg_ui_canvas_line(turned(kg_v2(found.items[i].x, y), r, -r),
                          turned(kg_v2(found.items[i + 1].x, y), r, -r), color, width);
    }
    free(found.items);
}

bool kg_fill_inside(const kg_net_view *v, size_t part, kg_vec2 *out) {
    const kg_net_part *p = &kg_net_state_picture(v->state)->net.net->parts[part];
    kg_box2 box = kg_net_view_part_box(v, part);
    double spacing = (box.hi.y - box.lo.y) / ROWS_TRIED, longest = 0;
    if (!(spacing > 0))
        return false;
    kg_fill f;
    kg_net_map map = kg_net_view_map(v, part);
    kg_fill_begin(&f);
    for (size_t k = 0; k < p->loop_count; k++) {
        const kg_net_line *line = &p->loops[k].line;
        kg_polyline outline = {0};
        for (size_t i = 0; i < line->count; i++) {
            /* from the box's corner, so that the rows lie the same way in it wherever it is */
            kg_vec2 at = kg_sub2(kg_net_map_apply(&map, line->points[i]), box.lo);
            if (!kg_push(&outline, at))
                break;
        }
        kg_fill_add(&f, &outline);
        free(outline.items);
    }
    crossings found = cross(&f, 1, 0, spacing, 0, ROWS_TRIED);
    for (size_t i = 0; i + 1 < found.count; i += 2) {
        double length = found.items[i + 1].x - found.items[i].x;
        if (length > longest) {
            longest = length;
            *out = kg_add2(
                box.lo, kg_v2(found.items[i].x + length / 2, (found.items[i].row + 0.5) * spacing));
        }
    }
    free(found.items);
    kg_fill_end(&f);
    return longest > 0;
}
