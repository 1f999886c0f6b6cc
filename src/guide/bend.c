#include "guide/bend.h"

#include "unroll/outline.h"

#include <stdlib.h>

/* A bend wider than this many times the piece is flat to the hand. */
#define FLAT 8.0

/* Step of v for the turning of the normal. */
#define STEP 1e-4

enum { RULINGS = 9, MANY_CROSSINGS = 16 };

/* Signed curvature across the ruling at (u, v): positive where the front bulges. */
static double curvature_at(const kg_patch *patch, double u, double v) {
    double lo = fmax(v - STEP, 0), hi = fmin(v + STEP, 1);
    kg_vec3 turn =
        kg_scale(kg_sub(kg_patch_normal(patch, hi), kg_patch_normal(patch, lo)), 1 / (hi - lo));
    kg_vec3 du, dv;
    kg_patch_derivatives(patch, u, v, &du, &dv);
    kg_vec3 across = kg_madd(dv, -kg_dot(dv, du), du);
    double speed = kg_dot(across, across);
    return speed > 0 ? kg_dot(turn, across) / speed : 0;
}

kg_bend kg_bend_of(const kg_patch *patch, const kg_tessellation *piece) {
    kg_bend bend = {INFINITY, INFINITY};
    kg_box3 box = kg_box3_empty();
    for (size_t i = 0; i < piece->vertex_count; i++)
        kg_box3_add(&box, piece->vertices[i].position);
    for (size_t i = 0; i < piece->vertex_count; i++) {
        double curvature = curvature_at(patch, piece->vertices[i].u, piece->vertices[i].v);
        double radius = 1 / fabs(curvature);
        if (!(radius < FLAT * kg_box_size(box)))
            continue;
        double *least = curvature > 0 ? &bend.radius_out : &bend.radius_in;
        *least = fmin(*least, radius);
    }
    return bend;
}

/* Where the line of constant v enters and leaves the region, in rising order; an even number. */
static size_t crossings_of(const kg_region *region, double v, double *out) {
    size_t count = 0;
    for (size_t k = 0; k < region->loop_count; k++) {
        const kg_region_loop *loop = &region->loops[k];
        for (size_t i = 0, j = loop->point_count - 1; i < loop->point_count; j = i++) {
            const kg_cross_point *a = &loop->points[j], *b = &loop->points[i];
            if ((a->v > v) == (b->v > v) || count == MANY_CROSSINGS)
                continue;
            double u = a->u + (b->u - a->u) * (v - a->v) / (b->v - a->v);
            size_t at = count++;
            for (; at > 0 && out[at - 1] > u; at--)
                out[at] = out[at - 1];
            out[at] = u;
        }
    }
    return count & ~(size_t)1;
}

kg_status kg_bend_rulings(const kg_patch *patch, const kg_region *region, kg_assembly_part *part) {
    if (!isfinite(fmin(part->radius_in, part->radius_out)))
        return KG_OK;
    part->rulings = calloc(RULINGS * MANY_CROSSINGS / 2, sizeof *part->rulings);
    if (!part->rulings)
        return KG_ERR_MEMORY;
    double lo = 1, hi = 0, crossings[MANY_CROSSINGS];
    for (size_t i = 0; i < region->loops[0].point_count; i++) {
        lo = fmin(lo, region->loops[0].points[i].v);
        hi = fmax(hi, region->loops[0].points[i].v);
    }
    for (int i = 0; i < RULINGS; i++) {
        double v = lo + (hi - lo) * (i + 0.5) / RULINGS;
        size_t count = crossings_of(region, v, crossings);
        for (size_t k = 0; k < count; k += 2) {
            part->rulings[part->ruling_count][0] = kg_on_paper(patch, crossings[k], v);
            part->rulings[part->ruling_count++][1] = kg_on_paper(patch, crossings[k + 1], v);
        }
    }
    return KG_OK;
}
