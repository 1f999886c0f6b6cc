#include "net/tab_merge.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

/* mm along a contour within which a tab's end is a point of it. */
static const double SAME = 1e-6;

typedef struct builder {
    struct {
        kg_vec2 *items;
        size_t count, capacity;
    } points;
    struct {
        unsigned char *items;
        size_t count, capacity;
    } corners;
    struct { /* positions of the points that lie on the old contour, ascending */
        struct spot {
            double s;
            size_t index;
        } * items;
        size_t count, capacity;
    } spots;
} builder;

/* The contour's point at s, exactly where it has one there. */
static kg_vec2 point_at(const kg_tab_loop *loop, double s) {
    double length = kg_tab_loop_length(loop);
    s = fmod(s, length);
    for (size_t i = 0; i <= loop->line->count; i++)
        if (fabs(loop->s[i] - s) <= SAME)
            return loop->line->points[i < loop->line->count ? i : 0];
    return kg_tab_loop_at(loop, s);
}

/* Moves the feet of a tab into the first lap and onto the contour. */
static void ground_feet(const kg_tab_loop *loop, kg_tab *tab) {
    double length = kg_tab_loop_length(loop), stands = tab->foot[1] - tab->foot[0];
    double start = fmod(tab->foot[0], length);
    tab->foot[0] = start > length - SAME ? 0 : start;
    tab->foot[1] = tab->foot[0] + stands;
    tab->path[0] = point_at(loop, tab->foot[0]);
    tab->path[3] = point_at(loop, tab->foot[1]);
}

static int by_place(const void *pa, const void *pb) {
    const kg_tab *a = pa, *b = pb;
    if (a->loop != b->loop)
        return a->loop < b->loop ? -1 : 1;
    if (a->foot[0] != b->foot[0])
        return a->foot[0] < b->foot[0] ? -1 : 1;
    if (a->join != b->join)
        return a->join < b->join ? -1 : 1;
    return a->base[0] < b->base[0] ? -1 : a->base[0] > b->base[0];
}

/* One point for the end of a tab and the start of the next, where they are the same. */
static void share_foot(const kg_tab *tab, kg_tab *next) {
    if (kg_dist2(tab->path[3], next->path[0]) <= SAME)
        next->path[0] = tab->path[3];
}

void kg_tab_order(const kg_tab_ground *ground, kg_tab_list *tabs) {
    for (size_t i = 0; i < tabs->count; i++)
        if (tabs->items[i].height > 0)
            ground_feet(&ground->loops[tabs->items[i].loop], &tabs->items[i]);
    if (tabs->count > 0)
        qsort(tabs->items, tabs->count, sizeof *tabs->items, by_place);
    kg_tab *first = NULL, *before = NULL;
    for (size_t i = 0; i < tabs->count; i++) {
        kg_tab *tab = &tabs->items[i];
        if (!(tab->height > 0))
            continue;
        if (before && before->loop == tab->loop) {
            share_foot(before, tab);
        } else {
            if (before != first)
                share_foot(before, first);
            first = tab;
        }
        before = tab;
    }
    if (before != first)
        share_foot(before, first);
}

static bool push_point(builder *b, kg_vec2 p, unsigned char corner) {
    return kg_push(&b->points, p) && kg_push(&b->corners, corner);
}

static bool push_spot(builder *b, double s) {
    struct spot spot = {s, b->points.count};
    return kg_push(&b->spots, spot);
}

/* Adds the contour's own points with from < s < to; positions may wrap once. */
static bool push_stretch(builder *b, const kg_tab_loop *loop, double from, double to) {
    double length = kg_tab_loop_length(loop);
    for (int lap = 0; lap < 2; lap++)
        for (size_t i = 0; i < loop->line->count; i++) {
            double s = loop->s[i] + lap * length;
            if (s <= from + SAME || s >= to - SAME)
                continue;
            if (!push_spot(b, s) || !push_point(b, loop->line->points[i], loop->line->corners[i]))
                return false;
        }
    return true;
}

static bool push_tabs(builder *b, const kg_tab_loop *loop, int index, const kg_tab_list *tabs) {
    double length = kg_tab_loop_length(loop), first = -1, end = -1;
    for (size_t k = 0; k < tabs->count; k++) {
        const kg_tab *tab = &tabs->items[k];
        if (tab->loop != index || !(tab->height > 0))
            continue;
        double start = tab->foot[0];
        if (first < 0)
            first = start;
        else if (!push_stretch(b, loop, end, start))
            return false;
        if (end < 0 || start > end + SAME)
            if (!push_spot(b, start) || !push_point(b, tab->path[0], 1))
                return false;
        end = tab->foot[1];
        if (!push_point(b, tab->path[1], 1) || !push_point(b, tab->path[2], 1))
            return false;
        if (end < first + length - SAME)
            if (!push_spot(b, end) || !push_point(b, tab->path[3], 1))
                return false;
    }
    return push_stretch(b, loop, end, first + length);
}

static void make_map(const builder *b, const kg_tab_loop *loop, size_t *map) {
    for (size_t i = 0; i < loop->line->count; i++) {
        double s = loop->s[i];
        if (s < b->spots.items[0].s - SAME)
            s += kg_tab_loop_length(loop);
        size_t k = 0;
        while (k < b->spots.count && b->spots.items[k].s < s - SAME)
            k++;
        map[i] = b->spots.items[k < b->spots.count ? k : 0].index;
    }
}

kg_status kg_tab_merge(const kg_tab_loop *loop, int index, const kg_tab_list *tabs,
                       kg_tab_contour *out) {
    builder b = {0};
    bool any = false;
    for (size_t k = 0; k < tabs->count; k++)
        any = any || (tabs->items[k].loop == index && tabs->items[k].height > 0);
    size_t n = loop->line->count, *map = malloc(n * sizeof *map);
    bool done = map != NULL;
    if (done && any) {
        done = push_tabs(&b, loop, index, tabs);
    } else {
        for (size_t i = 0; i < n && done; i++)
            done = push_spot(&b, loop->s[i]) &&
                   push_point(&b, loop->line->points[i], loop->line->corners[i]);
    }
    if (done)
        make_map(&b, loop, map);
    free(b.spots.items);
    kg_net_line line = *loop->line;
    line.points = b.points.items;
    line.corners = b.corners.items;
    line.count = b.points.count;
    *out = (kg_tab_contour){line, map};
    if (!done)
        kg_tab_contour_destroy(out);
    return done ? KG_OK : KG_ERR_MEMORY;
}

void kg_tab_contour_destroy(kg_tab_contour *contour) {
    free(contour->line.points);
    free(contour->line.corners);
    free(contour->map);
    *contour = (kg_tab_contour){0};
}

kg_status kg_tab_fold(const kg_tab_loop *loop, const kg_tab *tab, kg_net_kind kind, int number,
                      kg_net_line *out) {
    builder b = {0};
    bool done = push_point(&b, tab->path[0], 1) &&
                push_stretch(&b, loop, tab->foot[0], tab->foot[1]) &&
                push_point(&b, tab->path[3], 1);
    free(b.spots.items);
    if (!done) {
        free(b.points.items);
        free(b.corners.items);
        return KG_ERR_MEMORY;
    }
    *out = (kg_net_line){.kind = kind,
                         .count = b.points.count,
                         .points = b.points.items,
                         .corners = b.corners.items,
                         .tab = number,
                         .join = tab->join};
    return KG_OK;
}
