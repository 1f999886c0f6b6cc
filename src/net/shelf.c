#include "net/shelf.h"

#include "base/phrase.h"

#include <stdlib.h>
#include <string.h>

/* A turn must save this share of the box's area to be worth leaving the part as its maker drew it.
 */
#define TURN_GAIN 0.05

/* Heights are compared in steps of this, mm, so that the order of twins, which differ by rounding,
 * is that of their numbers. */
#define GRAIN 1e-3

typedef struct item {
    size_t part;
    double angle;
    kg_box2 box; /* of the turned and scaled part */
    kg_vec2 size;
} item;

static kg_vec2 turned(kg_vec2 p, double c, double s) {
    return kg_v2(c * p.x - s * p.y, s * p.x + c * p.y);
}

static kg_box2 part_box(const kg_net_part *part, double scale, double angle) {
    kg_box2 box = kg_box2_empty();
    double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < part->loop_count; i++) {
        const kg_net_line *line = &part->loops[i].line;
        for (size_t k = 0; k < line->count; k++)
            kg_box2_add(&box, turned(kg_scale2(line->points[k], scale), c, s));
    }
    return box;
}

static int by_x_then_y(const void *a, const void *b) {
    const kg_vec2 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->y < q->y ? -1 : p->y > q->y;
}

/* Convex hull of the outer contour (Andrew's monotone chain); the caller frees it. */
static kg_vec2 *hull(const kg_net_line *line, size_t *out_count) {
    kg_vec2 *sorted = calloc(3 * line->count + 1, sizeof *sorted);
    if (!sorted)
        return NULL;
    memcpy(sorted + 2 * line->count, line->points, line->count * sizeof *sorted);
    kg_vec2 *p = sorted + 2 * line->count;
    qsort(p, line->count, sizeof *p, by_x_then_y);
    size_t n = 0, lower = 0;
    for (size_t pass = 0; pass < 2; pass++) {
        for (size_t k = 0; k < line->count; k++) {
            kg_vec2 q = p[pass == 0 ? k : line->count - 1 - k];
            while (n >= lower + 2 &&
                   kg_cross2(kg_sub2(sorted[n - 1], sorted[n - 2]), kg_sub2(q, sorted[n - 1])) <= 0)
                n--;
            sorted[n++] = q;
        }
        lower = --n;
    }
    *out_count = n;
    return sorted;
}

static bool fits(kg_vec2 size, kg_vec2 room) {
    /* A part exactly as large as the page fits whatever rounding its rotation took. */
    const double slack = 1e-6;
    return size.x <= room.x + slack && size.y <= room.y + slack;
}

/* Width and height of the points turned by an angle. */
static kg_vec2 turned_size(const kg_vec2 *points, size_t count, double angle) {
    double c = cos(angle), s = sin(angle);
    kg_vec2 lo = turned(points[0], c, s), hi = lo;
    for (size_t i = 1; i < count; i++) {
        kg_vec2 q = turned(points[i], c, s);
        lo.x = q.x < lo.x ? q.x : lo.x;
        lo.y = q.y < lo.y ? q.y : lo.y;
        hi.x = q.x > hi.x ? q.x : hi.x;
        hi.y = q.y > hi.y ? q.y : hi.y;
    }
    return kg_sub2(hi, lo);
}

/* What a turn costs: the area of the box; lying comes before upright, and what does not fit after
 * all that does. */
static double turn_cost(kg_vec2 size, kg_vec2 room) {
    double cost = size.x * size.y * (size.y > size.x ? 1.01 : 1);
    return fits(size, room) ? cost : cost + 1e12 + 1e6 * fmax(size.x - room.x, size.y - room.y);
}

/* The turn with the smallest bounding box that fits `room`, among none, a quarter and hull edges
 * laid along x or y. */
static bool item_turn(const kg_net_part *part, const kg_net_options *options, kg_vec2 room,
                      item *it) {
    const double quarter = KG_PI / 2;
    double scale = options->scale, best = INFINITY;
    it->angle = 0;
    if (!options->grain) {
        size_t edges = 0;
        kg_vec2 *points = hull(&part->loops[0].line, &edges);
        if (!points)
            return false;
        /* Of very many edges some dozens come near enough to the best. */
        size_t stride = 1 + edges / 64;
        for (size_t k = 0; k <= edges; k += stride) {
            kg_vec2 e = kg_sub2(points[(k + 1) % edges], points[k % edges]);
            double angle = k == 0 ? 0 : -atan2(e.y, e.x);
            kg_vec2 size = kg_scale2(turned_size(points, edges, angle), scale);
            for (int upright = 0; upright < 2; upright++) {
                double cost = turn_cost(upright ? kg_v2(size.y, size.x) : size, room);
                cost *= k + (size_t)upright > 0 ? 1 + TURN_GAIN : 1;
                if (cost < best - 1e-9) {
                    best = cost;
                    it->angle = angle + upright * quarter;
                }
            }
        }
        free(points);
    }
    it->box = part_box(part, scale, it->angle);
    it->size = kg_sub2(it->box.hi, it->box.lo);
    return true;
}

static int by_height(const void *a, const void *b) {
    const item *p = a, *q = b;
    double x = round(p->size.y / GRAIN), y = round(q->size.y / GRAIN);
    if (x != y)
        return x > y ? -1 : 1;
    return p->part < q->part ? -1 : p->part > q->part;
}

/* The error for a part that no page can hold, with its size and what would help. */
static kg_status refuse(const kg_net_part *part, const item *it, const kg_net_options *options,
                        const kg_sheet *sheet, kg_error *error) {
    char name[300];
    kg_phrase_print(name, sizeof name,
                    *part->name && strlen(part->name) < 256 ? N_("part %d (%s)") : N_("part %d"),
                    part->number, part->name);
    if (fits(it->size, sheet->usable))
        return kg_fail(error, KG_ERR_INPUT,
                       "%s of %.1f x %.1f mm does not fit on a page beside what is printed in its "
                       "corners; use larger paper, a larger margin or a smaller scale",
                       name, it->size.x, it->size.y);
    double factor = fmin(sheet->usable.x / it->size.x, sheet->usable.y / it->size.y);
    return kg_fail(error, KG_ERR_INPUT,
                   "%s is %.1f x %.1f mm, more than the %.1f x %.1f mm a page has within its "
                   "margins; use larger paper, or a scale of %.2f or less",
                   name, it->size.x, it->size.y, sheet->usable.x, sheet->usable.y,
                   fmax(floor(options->scale * factor * 100) / 100, 0.01));
}

/* True when the box lies on one of the page's forbidden rectangles. */
static bool forbidden(const kg_sheet *sheet, kg_vec2 at, kg_vec2 size, double gap) {
    for (int i = 0; i < sheet->forbidden_count; i++) {
        const kg_box2 *f = &sheet->forbidden[i];
        if (at.x < f->hi.x + gap && at.x + size.x > f->lo.x - gap && at.y < f->hi.y + gap &&
            at.y + size.y > f->lo.y - gap)
            return true;
    }
    return false;
}

typedef struct row {
    int page;
    double y, height, x; /* x: where the next part may begin */
} row;

typedef struct shelves {
    const kg_sheet *sheet;
    double gap;
    row *rows; /* room for one per part */
    size_t row_count;
    int page_count;
    double page_y; /* where the next row of the last page may begin */
} shelves;

/* The place of a part: in the first row with room, else in a new row, else on a new page. Forbidden
 * rectangles are stepped over in small steps. */
static bool shelves_place(shelves *s, const item *it, int *out_page, kg_vec2 *out_at) {
    const double step = 1;
    const kg_vec2 room = s->sheet->usable;
    for (size_t i = 0; i < s->row_count; i++) {
        row *r = &s->rows[i];
        if (r->height < it->size.y)
            continue;
        for (double x = r->x; x + it->size.x <= room.x + 1e-6; x += step) {
            kg_vec2 at = kg_v2(x, r->y);
            if (!forbidden(s->sheet, at, it->size, s->gap)) {
                r->x = x + it->size.x + s->gap;
                *out_page = r->page;
                *out_at = at;
                return true;
            }
        }
    }
    for (int attempt = 0; attempt < 2; attempt++) {
        for (double y = s->page_y; s->page_count > 0 && y + it->size.y <= room.y + 1e-6;
             y += step) {
            for (double x = 0; x + it->size.x <= room.x + 1e-6; x += step) {
                kg_vec2 at = kg_v2(x, y);
                if (!forbidden(s->sheet, at, it->size, s->gap)) {
                    s->rows[s->row_count++] =
                        (row){s->page_count - 1, y, it->size.y, x + it->size.x + s->gap};
                    s->page_y = y + it->size.y + s->gap;
                    *out_page = s->page_count - 1;
                    *out_at = at;
                    return true;
                }
                if (s->sheet->forbidden_count == 0)
                    break;
            }
            if (s->sheet->forbidden_count == 0)
                break;
        }
        s->page_count++;
        s->page_y = 0;
    }
    return false;
}

/* Puts the pinned parts where they belong; returns the pages up to the last of them, on which rows
 * would run into them. */
static int place_pinned(const kg_net *net, kg_net_layout *layout) {
    int pages = 0;
    for (size_t i = 0; i < net->part_count; i++)
        if (net->parts[i].pinned) {
            layout->placements[i] = net->parts[i].pin;
            if (pages <= net->parts[i].pin.page)
                pages = net->parts[i].pin.page + 1;
        }
    return pages;
}

static kg_status place_all(const kg_net *net, const kg_sheet *sheet, const kg_net_options *options,
                           item *items, size_t count, row *rows, kg_net_layout *layout,
                           kg_error *error) {
    shelves s = {.sheet = sheet, .gap = options->gap, .rows = rows, .page_y = sheet->usable.y};
    if (!sheet->endless)
        s.page_count = place_pinned(net, layout);
    for (size_t i = 0; i < count; i++) {
        const item *it = &items[i];
        int page;
        kg_vec2 at;
        if (!fits(it->size, sheet->usable) || !shelves_place(&s, it, &page, &at))
            return refuse(&net->parts[it->part], it, options, sheet, error);
        layout->placements[it->part] =
            (kg_net_placement){page, it->angle, kg_add2(sheet->origin, kg_sub2(at, it->box.lo))};
    }
    layout->page_count = (size_t)s.page_count;
    return KG_OK;
}

/* One page as large as the parts: rows of about a square, then the page cut to what they take. */
static void endless_room(const item *items, size_t count, double gap, kg_sheet *sheet) {
    double area = 0, width = 0, height = 0;
    for (size_t i = 0; i < count; i++) {
        area += (items[i].size.x + gap) * (items[i].size.y + gap);
        width = fmax(width, items[i].size.x);
        height += items[i].size.y + gap;
    }
    sheet->usable = kg_v2(fmax(width, 1.2 * sqrt(area)), height + 1);
}

static void endless_cut(const item *items, size_t count, kg_vec2 rim, kg_net_layout *layout) {
    kg_vec2 size = {0, 0};
    for (size_t i = 0; i < count; i++) {
        kg_vec2 corner = kg_add2(items[i].box.hi, layout->placements[items[i].part].offset);
        size = kg_v2(fmax(size.x, corner.x + rim.x), fmax(size.y, corner.y + rim.y));
    }
    layout->page_size = size;
}

static kg_status place_items(const kg_net *net, const kg_net_options *options, kg_sheet *sheet,
                             item *items, kg_net_layout *layout, kg_error *error) {
    kg_vec2 any = {1e9, 1e9};
    size_t count = 0;
    for (size_t i = 0; i < net->part_count; i++) {
        if (net->parts[i].pinned && !sheet->endless)
            continue;
        items[count].part = i;
        if (!item_turn(&net->parts[i], options, sheet->endless ? any : sheet->usable,
                       &items[count++]))
            return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    }
    qsort(items, count, sizeof *items, by_height);
    if (sheet->endless)
        endless_room(items, count, options->gap, sheet);
    row *rows = calloc(net->part_count + 1, sizeof *rows);
    if (!rows)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    kg_status status = place_all(net, sheet, options, items, count, rows, layout, error);
    free(rows);
    if (status == KG_OK && sheet->endless)
        endless_cut(items, count, sheet->origin, layout);
    return status;
}

kg_status kg_shelf_place(const kg_net *net, const kg_net_options *options, const kg_sheet *sheet,
                         kg_net_layout *layout, kg_error *error) {
    kg_sheet page = *sheet;
    item *items = calloc(net->part_count + 1, sizeof *items);
    if (!items)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory while placing the parts");
    kg_status status = place_items(net, options, &page, items, layout, error);
    free(items);
    return status;
}
