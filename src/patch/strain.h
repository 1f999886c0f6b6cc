/* How near the rulings of a cubic come to folding back: quick, by samples, for searches. */
#ifndef KG_PATCH_STRAIN_H
#define KG_PATCH_STRAIN_H

#include "katagami/patch.h"

/* Searches leave some room to the limits, for what samples miss and for the user's next move. */
#define KG_EASY_STRAIN 0.95
#define KG_EASY_THETA (1.2 * KG_FLAT_RULING)

typedef struct kg_strain {
    double reach; /* greatest u / edge of regression: 1 where the extent touches it */
    double theta; /* least angle between ruling and geodesic, radians */
} kg_strain;

/* NaN where the cubic has no rulings. */
kg_strain kg_cubic_strain(const kg_vec3 points[4], const double extent[2]);

/* The greatest u / u', u' where a ruling meets the plane through `at` with normal `normal` again;
 * of those that do so within `depth` of the line through `at` along `line`, which is a ruling. Like
 * the edge of regression, which it runs into, it has to stay away from the extent. */
double kg_cubic_reach_back(const kg_vec3 points[4], const double extent[2], kg_vec3 at,
                           kg_vec3 line, kg_vec3 normal, double depth);

static inline bool kg_strain_is_easy(kg_strain s) {
    return s.reach <= KG_EASY_STRAIN && s.theta >= KG_EASY_THETA;
}

#endif
