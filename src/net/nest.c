#include "net/nest.h"

#include "net/nest_exact.h"
#include "net/nest_page.h"
#include "net/nest_raster.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { TURNS_MAX = 24, TURNS_TRIED = 3 };

/* mm the outlines may be off while rastering, made good by as much more reach. */
static const double SIMPLIFY = 0.04;
/* Cells of a page: finer ones waste less paper, but every search is slower by the square. */
static const double PAGE_CELLS = 80e3;
/* Cells of a page's longer side at most, and mm of the smallest cell: bounds on memory. */
static const double SIDE_CELLS = 5000, CELL_LEAST = 0.2;
/* Runs looked at before the search ends: about half a second. A count, not a time, so that the
 * result never depends on the machine. */
static const uint64_t WORK = 50000000;

/* Areas, centres and depths are compared in these steps, mm or mm²: twins differ by rounding. */
static const double GRAIN = 0x1p-16;

static double grained(double x) {
    return round(x / GRAIN) * GRAIN;
}

/* A part turned by one angle. */
typedef struct turn {
    double angle;
    kg_vec2 offset, size; /* of its bounding box */
    double center;        /* height of its centre of area in the box */
    bool made[2];
    kg_nest_raster rasters[2]; /* without the spacing and with it, made when asked for */
} turn;

typedef struct item {
    kg_nest_shape shape;
    double area;
    int turn_count;
    turn turns[TURNS_MAX];
} item;

typedef struct layout {
    kg_nest_place *places;
    size_t left_out;
    int pages;
    double moment; /* sum of area times page: the less, the fuller the first pages */
    double depth;  /* mm, how far down the last page is used */
} layout;

typedef struct nester {
    const kg_nest_part *parts;
    size_t count;
    kg_nest_options options;
    kg_nest_exact *exact;
    item *items;
    double cell;
    int columns, rows;
    kg_nest_page blank; /* only forbidden rectangles */
    struct {
        kg_nest_page *items;
        size_t count, capacity;
    } fixed, pages; /* pages with pinned parts; pages being filled */
    kg_vec2 *scratch;
    uint64_t work, random;
} nester;

kg_nest_options kg_nest_options_default(void) {
    return (kg_nest_options){
        .width = 194, .height = 281, .spacing = 2, .max_pages = 1000, .turn = KG_NEST_FREE};
}

/* splitmix64 */
static uint64_t next_random(nester *n) {
    uint64_t z = (n->random += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Height of the centre of area of the outer contour. */
static double center_height(const kg_nest_shape *shape, const kg_vec2 *points) {
    double area = 0, moment = 0;
    for (size_t i = 0; i < shape->ends[0]; i++) {
        kg_vec2 a = points[i], b = points[i + 1 < shape->ends[0] ? i + 1 : 0];
        area += kg_cross2(a, b);
        moment += kg_cross2(a, b) * (a.y + b.y) / 3;
    }
    return area != 0 ? grained(moment / area) : 0;
}

static void init_turns(nester *n, size_t index) {
    item *it = &n->items[index];
    const double full = 2 * KG_PI;
    double start = 0;
    it->turn_count = n->options.turn == KG_NEST_FIXED ? 1 : 2;
    if (n->options.turn == KG_NEST_FREE) {
        it->turn_count = n->count <= 60 ? TURNS_MAX : n->count <= 150 ? 12 : 8;
        start = -kg_nest_exact_axis(n->exact, index);
    }
    for (int k = 0; k < it->turn_count; k++) {
        turn *t = &it->turns[k];
        t->angle = start + full * k / it->turn_count;
        kg_nest_shape_turn(&it->shape, t->angle, n->scratch, &t->offset, &t->size);
        t->center = center_height(&it->shape, n->scratch);
    }
}

/* The cells of a turned part, with the spacing or without. */
static kg_status raster_of(nester *n, const item *it, turn *t, bool wide,
                           const kg_nest_raster **out) {
    *out = &t->rasters[wide];
    if (t->made[wide])
        return KG_OK;
    kg_vec2 offset, size;
    kg_nest_shape_turn(&it->shape, t->angle, n->scratch, &offset, &size);
    double reach = wide ? n->options.spacing + SIMPLIFY : SIMPLIFY;
    kg_status status =
        kg_nest_raster_make(&it->shape, n->scratch, n->cell, reach, NULL, &t->rasters[wide]);
    t->made[wide] = status == KG_OK;
    return status;
}

/* The last cell a turned part may start in for its exact box to stay on the page. */
static bool last_start(const nester *n, const turn *t, int *out_x, int *out_y) {
    double x = n->options.width - t->size.x - 2 * SIMPLIFY;
    double y = n->options.height - t->size.y - 2 * SIMPLIFY;
    *out_x = (int)floor(x / n->cell);
    *out_y = (int)floor(y / n->cell);
    return x >= 0 && y >= 0;
}

/* Looks for the turn and place of a part on one page whose centre of area is the highest. */
static kg_status place_on_page(nester *n, size_t index, uint64_t turns, kg_nest_page *page,
                               bool *out_found, kg_nest_place *out_place, double *out_depth) {
    const item *it = &n->items[index];
    const kg_nest_raster *raster;
    turn *best = NULL;
    double best_height = HUGE_VAL;
    int best_x = 0, best_y = 0;
    for (int k = 0; k < it->turn_count; k++) {
        turn *t = &n->items[index].turns[k];
        int x, y;
        if (!(turns >> k & 1) || !last_start(n, t, &x, &y))
            continue;
        double limit = floor((best_height - t->center) / n->cell);
        if (limit < 0)
            continue;
        y = limit < y ? (int)limit : y;
        kg_status status = raster_of(n, it, t, true, &raster);
        if (status != KG_OK)
            return status;
        if (!kg_nest_page_find(page, raster, x, y, &x, &y, &n->work))
            continue;
        double height = y * n->cell + t->center;
        if (height < best_height || (height == best_height && x < best_x)) {
            best = t;
            best_height = height;
            best_x = x;
            best_y = y;
        }
    }
    *out_found = best != NULL;
    if (!best)
        return KG_OK;
    kg_status status = raster_of(n, it, best, false, &raster);
    if (status != KG_OK)
        return status;
    kg_nest_page_take(page, raster, best_x, best_y);
    kg_vec2 corner = kg_v2(best_x * n->cell + SIMPLIFY, best_y * n->cell + SIMPLIFY);
    out_place->angle = best->angle;
    out_place->offset = kg_add2(best->offset, corner);
    *out_depth = grained(corner.y + best->size.y);
    return KG_OK;
}

/* A page to fill, as it is before: made new when `index` is one more than there were. */
static kg_status open_page(nester *n, size_t index) {
    if (index == n->pages.count) {
        kg_nest_page page;
        kg_status status = kg_nest_page_create(n->columns, n->rows, &page);
        if (status != KG_OK)
            return status;
        if (!kg_push(&n->pages, page)) {
            kg_nest_page_destroy(&page);
            return KG_ERR_MEMORY;
        }
    }
    kg_nest_page_copy(&n->pages.items[index],
                      index < n->fixed.count ? &n->fixed.items[index] : &n->blank);
    return KG_OK;
}

/* Places the parts in the given order, each on the first page with room for it. masks[i]: turns to
 * try of part i. */
static kg_status lay_out(nester *n, const size_t *order, size_t count, const uint64_t *masks,
                         layout *out) {
    size_t opened = 0;
    out->left_out = 0;
    out->pages = (int)n->fixed.count;
    out->moment = out->depth = 0;
    for (size_t i = 0; i < count; i++) {
        size_t part = order[i];
        kg_nest_place *place = &out->places[part];
        *place = (kg_nest_place){.page = -1};
        bool found = false, fits = false;
        int x, y;
        for (int k = 0; k < n->items[part].turn_count; k++)
            fits = fits || last_start(n, &n->items[part].turns[k], &x, &y);
        double depth = 0;
        for (size_t p = 0; fits && !found && p < (size_t)n->options.max_pages; p++) {
            if (p == opened) {
                kg_status status = open_page(n, opened++);
                if (status != KG_OK)
                    return status;
            }
            bool fresh = p == opened - 1 && p >= n->fixed.count && (int)p >= out->pages;
            kg_status status = place_on_page(n, part, fresh ? UINT64_MAX : masks[part],
                                             &n->pages.items[p], &found, place, &depth);
            if (status != KG_OK)
                return status;
            if (found)
                place->page = (int)p;
            else if (fresh)
                break; /* no room even on an empty page, for forbidden rectangles */
        }
        if (!found) {
            out->left_out++;
            continue;
        }
        if (place->page + 1 > out->pages) {
            out->pages = place->page + 1;
            out->depth = 0;
        }
        if (place->page + 1 == out->pages)
            out->depth = fmax(out->depth, depth);
        out->moment += n->items[part].area * place->page;
    }
    return KG_OK;
}

static bool better(const layout *a, const layout *b) {
    if (a->left_out != b->left_out)
        return a->left_out < b->left_out;
    if (a->pages != b->pages)
        return a->pages < b->pages;
    if (a->moment != b->moment)
        return a->moment < b->moment;
    return a->depth < b->depth;
}

/* Parts not pinned, the largest first. */
static size_t first_order(const nester *n, size_t *order) {
    size_t count = 0;
    for (size_t i = 0; i < n->count; i++) {
        if (n->parts[i].pinned)
            continue;
        size_t at = count++;
        for (; at > 0 && n->items[order[at - 1]].area < n->items[i].area; at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
    return count;
}

/* One change of an order: two parts swapped, or one taken out and put in elsewhere. */
static void change_order(nester *n, size_t *order, size_t count) {
    size_t a = next_random(n) % count, b = next_random(n) % count, moved = order[a];
    if (next_random(n) & 1) {
        order[a] = order[b];
    } else if (a < b) {
        memmove(order + a, order + a + 1, (b - a) * sizeof *order);
    } else {
        memmove(order + b + 1, order + b, (a - b) * sizeof *order);
    }
    order[b] = moved;
}

/* The turn each part has in the best layout, and a few others. */
static void choose_turns(nester *n, const layout *best, uint64_t *masks) {
    for (size_t i = 0; i < n->count; i++) {
        masks[i] = 0;
        if (n->parts[i].pinned)
            continue;
        for (int k = 0; k < n->items[i].turn_count; k++)
            if (n->items[i].turns[k].angle == best->places[i].angle)
                masks[i] = (uint64_t)1 << k;
        for (int k = 0; k < TURNS_TRIED; k++)
            masks[i] |= (uint64_t)1 << next_random(n) % (uint64_t)n->items[i].turn_count;
    }
}

/* First by size with every turn, then by changing the best order while work remains. */
static kg_status search(nester *n, const kg_progress *progress, layout *best, kg_error *error) {
    layout trial = {.places = malloc((n->count + 1) * sizeof *trial.places)};
    size_t *order = malloc(2 * (n->count + 1) * sizeof *order);
    uint64_t *masks = malloc((n->count + 1) * sizeof *masks);
    kg_status status = trial.places && order && masks ? KG_OK : KG_ERR_MEMORY;
    if (status == KG_OK) {
        size_t count = first_order(n, order), *changed = order + n->count;
        memset(masks, 0xff, n->count * sizeof *masks);
        memcpy(trial.places, best->places, n->count * sizeof *trial.places);
        status = lay_out(n, order, count, masks, best);
        /* One page, or those with pinned parts, are the fewest there can be; a single part has no
         * other order. */
        int fewest = n->fixed.count > 1 ? (int)n->fixed.count : 1;
        while (status == KG_OK && n->work < WORK && best->pages > fewest && count > 1) {
            if (progress && progress->call &&
                !progress->call(progress->user, (double)n->work / (double)WORK, "nesting")) {
                status = KG_ERR_CANCELLED;
                break;
            }
            memcpy(changed, order, count * sizeof *order);
            change_order(n, changed, count);
            choose_turns(n, best, masks);
            status = lay_out(n, changed, count, masks, &trial);
            if (status == KG_OK && !better(best, &trial)) {
                kg_nest_place *places = best->places;
                *best = trial;
                best->places = places;
                memcpy(places, trial.places, n->count * sizeof *places);
                memcpy(order, changed, count * sizeof *order);
            }
        }
    }
    free(trial.places);
    free(order);
    free(masks);
    if (status == KG_ERR_CANCELLED)
        return kg_fail(error, status, "nesting was cancelled");
    return status;
}

static kg_box2 page_box(const nester *n) {
    return (kg_box2){{0, 0}, {n->options.width, n->options.height}};
}

/* Takes the cells of a shape that stands still, points in page coordinates. */
static kg_status take_shape(nester *n, const kg_nest_shape *shape, const kg_vec2 *points,
                            kg_nest_page *page) {
    kg_box2 window = page_box(n);
    kg_nest_raster raster;
    kg_status status = kg_nest_raster_make(shape, points, n->cell, SIMPLIFY, &window, &raster);
    if (status != KG_OK)
        return status;
    kg_nest_page_take(page, &raster, 0, 0);
    free(raster.runs);
    return KG_OK;
}

static kg_status take_forbidden(nester *n) {
    for (size_t i = 0; i < n->options.forbidden_count; i++) {
        kg_box2 b = n->options.forbidden[i];
        kg_vec2 corners[4] = {b.lo, {b.hi.x, b.lo.y}, b.hi, {b.lo.x, b.hi.y}};
        size_t end = 4;
        kg_nest_shape shape = {corners, &end, 1};
        kg_status status = take_shape(n, &shape, corners, &n->blank);
        if (status != KG_OK)
            return status;
    }
    return KG_OK;
}

static kg_status take_pinned(nester *n, size_t index) {
    kg_nest_place pin = n->parts[index].pin;
    const kg_nest_shape *shape = &n->items[index].shape;
    while (n->fixed.count <= (size_t)pin.page) {
        kg_nest_page page;
        kg_status status = kg_nest_page_create(n->columns, n->rows, &page);
        if (status != KG_OK)
            return status;
        kg_nest_page_copy(&page, &n->blank);
        if (!kg_push(&n->fixed, page)) {
            kg_nest_page_destroy(&page);
            return KG_ERR_MEMORY;
        }
    }
    kg_vec2 offset, size;
    kg_nest_shape_turn(shape, pin.angle, n->scratch, &offset, &size);
    for (size_t i = 0; i < shape->ends[shape->loop_count - 1]; i++)
        n->scratch[i] = kg_add2(n->scratch[i], kg_sub2(pin.offset, offset));
    return take_shape(n, shape, n->scratch, &n->fixed.items[pin.page]);
}

static kg_status prepare(nester *n) {
    size_t most = 0;
    for (size_t i = 0; i < n->count; i++) {
        kg_status status =
            kg_nest_exact_simplify(n->exact, &n->parts[i], SIMPLIFY, &n->items[i].shape);
        if (status != KG_OK)
            return status;
        const kg_nest_shape *shape = &n->items[i].shape;
        most =
            shape->ends[shape->loop_count - 1] > most ? shape->ends[shape->loop_count - 1] : most;
        n->items[i].area = grained(kg_nest_exact_area(n->exact, i));
    }
    n->scratch = malloc((most + 1) * sizeof *n->scratch);
    kg_status status = n->scratch ? KG_OK : KG_ERR_MEMORY;
    if (status == KG_OK)
        status = kg_nest_page_create(n->columns, n->rows, &n->blank);
    if (status == KG_OK)
        status = take_forbidden(n);
    for (size_t i = 0; i < n->count && status == KG_OK; i++) {
        if (n->parts[i].pinned)
            status = take_pinned(n, i);
        else
            init_turns(n, i);
    }
    return status;
}

static bool clashes(const nester *n, const kg_nest_place *places, size_t index) {
    if (!kg_nest_exact_inside(n->exact, index, page_box(n)))
        return true;
    for (size_t i = 0; i < n->options.forbidden_count; i++)
        if (kg_nest_exact_near_box(n->exact, index, n->options.forbidden[i], n->options.spacing))
            return true;
    for (size_t i = 0; i < n->count; i++)
        if (i != index && places[i].page == places[index].page &&
            (n->parts[i].pinned || (i < index && !n->parts[index].pinned)) &&
            kg_nest_exact_near(n->exact, index, i, n->options.spacing))
            return true;
    return false;
}

/* Confirms every place on the exact outlines. Pinned parts stay, flagged; another part could only
 * clash by an error of the rasters and then counts as left out. */
static kg_status confirm(nester *n, kg_nest_place *places) {
    for (size_t i = 0; i < n->count; i++) {
        if (n->parts[i].pinned)
            places[i] = n->parts[i].pin;
        places[i].clash = false;
        if (places[i].page < 0)
            continue;
        kg_status status = kg_nest_exact_place(n->exact, i, places[i]);
        if (status != KG_OK)
            return status;
    }
    for (size_t i = 0; i < n->count; i++) {
        if (places[i].page < 0 || !clashes(n, places, i))
            continue;
        if (n->parts[i].pinned)
            places[i].clash = true;
        else
            places[i] = (kg_nest_place){.page = -1};
    }
    return KG_OK;
}

static bool usable(double v, double lo, double hi) {
    return v >= lo && v <= hi;
}

static kg_status check_input(const kg_nest_part *parts, size_t count,
                             const kg_nest_options *options, kg_error *error) {
    if (!usable(options->width, 1, 1e6) || !usable(options->height, 1, 1e6))
        return kg_fail(error, KG_ERR_INPUT, "a page of %g x %g mm cannot be filled", options->width,
                       options->height);
    if (!usable(options->spacing, 0, 1000))
        return kg_fail(error, KG_ERR_INPUT, "spacing %g mm between parts is not in 0..1000",
                       options->spacing);
    for (size_t i = 0; i < options->forbidden_count; i++) {
        kg_box2 b = options->forbidden[i];
        if (!usable(b.lo.x, -1e6, b.hi.x) || !usable(b.lo.y, -1e6, b.hi.y) || b.hi.x > 1e6 ||
            b.hi.y > 1e6)
            return kg_fail(error, KG_ERR_INPUT, "forbidden rectangle %zu is none", i + 1);
    }
    for (size_t i = 0; i < count; i++) {
        kg_nest_place pin = parts[i].pin;
        if (!parts[i].pinned)
            continue;
        if (pin.page < 0 || pin.page >= options->max_pages)
            return kg_fail(error, KG_ERR_INPUT, "part %zu is pinned to page %d of at most %d",
                           i + 1, pin.page + 1, options->max_pages);
        if (!usable(pin.angle, -1e6, 1e6) || !usable(pin.offset.x, -1e6, 1e6) ||
            !usable(pin.offset.y, -1e6, 1e6))
            return kg_fail(error, KG_ERR_INPUT, "part %zu is pinned to no place", i + 1);
    }
    return KG_OK;
}

static void destroy(nester *n) {
    for (size_t i = 0; n->items && i < n->count; i++) {
        free(n->items[i].shape.points);
        free(n->items[i].shape.ends);
        for (int k = 0; k < n->items[i].turn_count; k++) {
            free(n->items[i].turns[k].rasters[0].runs);
            free(n->items[i].turns[k].rasters[1].runs);
        }
    }
    for (size_t i = 0; i < n->fixed.count; i++)
        kg_nest_page_destroy(&n->fixed.items[i]);
    for (size_t i = 0; i < n->pages.count; i++)
        kg_nest_page_destroy(&n->pages.items[i]);
    kg_nest_page_destroy(&n->blank);
    free(n->fixed.items);
    free(n->pages.items);
    free(n->items);
    free(n->scratch);
    kg_nest_exact_destroy(n->exact);
}

kg_status kg_nest(const kg_nest_part *parts, size_t count, const kg_nest_options *options,
                  const kg_progress *progress, kg_nest_place *out_places, kg_error *error) {
    kg_status status = check_input(parts, count, options, error);
    if (status != KG_OK || count == 0)
        return status;
    nester n = {.parts = parts, .count = count, .options = *options};
    double width = options->width, height = options->height;
    n.cell =
        fmax(fmax(sqrt(width * height / PAGE_CELLS), fmax(width, height) / SIDE_CELLS), CELL_LEAST);
    n.columns = (int)ceil(width / n.cell);
    n.rows = (int)ceil(height / n.cell);
    layout best = {.places = calloc(count, sizeof *best.places)};
    status = kg_nest_exact_create(parts, count, &n.exact, error);
    if (status == KG_OK) {
        n.items = calloc(count, sizeof *n.items);
        status = best.places && n.items ? prepare(&n) : KG_ERR_MEMORY;
        if (status == KG_OK)
            status = search(&n, progress, &best, error);
        if (status == KG_OK)
            status = confirm(&n, best.places);
        if (status == KG_OK)
            memcpy(out_places, best.places, count * sizeof *out_places);
        if (status == KG_ERR_MEMORY)
            status = kg_fail(error, status, "no memory to nest %zu parts", count);
    }
    free(best.places);
    destroy(&n);
    return status;
}
