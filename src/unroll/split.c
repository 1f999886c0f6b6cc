#include "unroll/split.h"

#include "trim/region.h"

#include <stdlib.h>

/* A part is tried on the page in steps of one degree. */
enum { TURNS = 180 };

/* Rulings tried, and how often a piece is cut again: 2^6 pieces are no longer a paper model. */
enum { CANDIDATES = 64, MAX_DEPTH = 6 };

/* Cuts nearer to an end of the part than this fraction of its length leave slivers. */
#define LEAST_SHARE 0.2

/* Does the outline on paper fit the room at some angle? */
static bool fits(const kg_patch *p, const kg_region *region, kg_vec2 room) {
    const kg_region_loop *l = &region->loops[0];
    kg_vec2 *paper = malloc(l->point_count * sizeof *paper);
    bool found = paper == NULL; /* without memory the page's layout finds out */
    for (size_t i = 0; i < l->point_count && paper; i++)
        paper[i] = kg_patch_unroll(p, l->points[i].u, l->points[i].v);
    for (int k = 0; k < TURNS && !found; k++) {
        double angle = KG_PI * k / TURNS, c = cos(angle), s = sin(angle);
        kg_box2 box = kg_box2_empty();
        for (size_t i = 0; i < l->point_count; i++)
            kg_box2_add(&box,
                        kg_v2(c * paper[i].x - s * paper[i].y, s * paper[i].x + c * paper[i].y));
        found = box.hi.x - box.lo.x <= room.x && box.hi.y - box.lo.y <= room.y;
    }
    free(paper);
    return found;
}

/* Length of a ruling inside the region, and how often it crosses the boundary. */
static double ruling_length(const kg_region *region, double v, int *out_crossings) {
    double sum = 0;
    *out_crossings = 0;
    /* each crossing adds its u on the way out and takes it off on the way in */
    for (size_t k = 0; k < region->loop_count; k++) {
        const kg_region_loop *l = &region->loops[k];
        for (size_t i = 0; i < l->point_count; i++) {
            const kg_cross_point *a = &l->points[i], *b = &l->points[(i + 1) % l->point_count];
            if ((a->v > v) == (b->v > v))
                continue;
            double u = a->u + (v - a->v) / (b->v - a->v) * (b->u - a->u);
            sum += b->v > a->v ? u : -u;
            (*out_crossings)++;
        }
    }
    return sum;
}

/* The shortest ruling that crosses the region in one piece, away from its ends; false: none. */
static bool best_ruling(const kg_region *region, double *out_v) {
    double lo = 1, hi = 0, best = HUGE_VAL;
    *out_v = 0.5;
    for (size_t i = 0; i < region->loops[0].point_count; i++) {
        lo = fmin(lo, region->loops[0].points[i].v);
        hi = fmax(hi, region->loops[0].points[i].v);
    }
    for (int k = 0; k <= CANDIDATES; k++) {
        double share = LEAST_SHARE + (1 - 2 * LEAST_SHARE) * k / CANDIDATES;
        double v = lo + share * (hi - lo);
        int crossings;
        double length = ruling_length(region, v, &crossings);
        /* towards the middle by a quarter: pieces of like size are handled best */
        double cost = length * (1 + 0.5 * fabs(share - 0.5));
        if (crossings == 2 && cost < best) {
            best = cost;
            *out_v = v;
        }
    }
    return best < HUGE_VAL;
}

static kg_status split(const kg_trim *trim, const kg_region *region, kg_vec2 room, int depth,
                       int64_t *source, kg_regions *out, kg_error *error) {
    double v;
    if (depth == MAX_DEPTH || fits(trim->patch, region, room) || !best_ruling(region, &v))
        return KG_OK;
    kg_regions halves;
    kg_status status = kg_region_split(trim, region, v, (*source)++, &halves, error);
    if (status)
        return status;
    for (size_t i = 0; i < halves.count; i++) {
        size_t before = out->count;
        if (!status)
            status = split(trim, &halves.items[i], room, depth + 1, source, out, error);
        if (!status && out->count == before)
            status = kg_regions_add(out, halves.items[i]); /* takes it over, also on failure */
        else
            kg_region_clear(&halves.items[i]);
    }
    free(halves.items);
    return status;
}

kg_status kg_split_to_fit(const kg_trim *trim, const kg_region *region, kg_vec2 room,
                          int64_t *source, kg_regions *out, kg_error *error) {
    return split(trim, region, room, 0, source, out, error);
}
