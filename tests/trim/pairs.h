/* Random pairs of patches, and what crossings are compared with: surfaces evaluated from the
 * formulas alone, and crossings by brute force. */
#ifndef KG_TESTS_TRIM_PAIRS_H
#define KG_TESTS_TRIM_PAIRS_H

#include "katagami/crossing.h"
#include "tests/check.h"

typedef enum pair_kind {
    PAIR_CUBIC,
    PAIR_QUINTIC,
    PAIR_PLANAR,
    PAIR_PLANAR_S,
    PAIR_STRAIGHT,
    PAIR_WILD,
    PAIR_KINDS
} pair_kind;

/* A patch of about 100 mm somewhere around `middle`. */
kg_patch random_patch(kg_random *r, pair_kind kind, kg_vec3 middle);

/* p + u d, d by derivatives by arc length: the unit vector of p'' × p''' there. Derivatives of p
 * by de Casteljau on differences. Planar and straight patches: the patch's constant ruling. */
kg_vec3 naive_point(const kg_patch *patch, double u, double v);

/* Every crossing point of the rows (rulings of A at equal steps of v) and columns (rulings of B)
 * must be on a branch, and the other way round. Returns the number of points checked. */
size_t check_against_rays(const kg_patch *a, const kg_patch *b, const kg_crossings *found,
                          double tolerance, const char *name);

/* Every point on both surfaces, ends on sides, chords within the tolerance. */
void check_points(const kg_patch *a, const kg_patch *b, const kg_crossings *found,
                  double tolerance);

/* A patch that must be possible; `ruling` may be NULL. */
kg_patch make_patch(const kg_vec3 *points, size_t count, double lo, double hi,
                    const kg_vec3 *ruling);

#endif
