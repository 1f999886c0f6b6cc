/* The exact outlines of the parts to nest, in GEOS. */
#ifndef KG_NET_NEST_EXACT_H
#define KG_NET_NEST_EXACT_H

#include "net/nest.h"
#include "net/nest_raster.h"

typedef struct kg_nest_exact kg_nest_exact;

/* Takes the outlines over; fails with KG_ERR_INPUT on one that is no polygon. */
kg_status kg_nest_exact_create(const kg_nest_part *parts, size_t count, kg_nest_exact **out,
                               kg_error *error) KG_CHECKED;
void kg_nest_exact_destroy(kg_nest_exact *exact);

double kg_nest_exact_area(const kg_nest_exact *exact, size_t part);

/* Angle of a side of the smallest rectangle around the part, in [0, pi/2). */
double kg_nest_exact_axis(const kg_nest_exact *exact, size_t part);

/* The part's loops with fewer points, none further than `tolerance` mm from the line they replace.
 * The caller frees the shape's points and ends. */
kg_status kg_nest_exact_simplify(const kg_nest_exact *exact, const kg_nest_part *part,
                                 double tolerance, kg_nest_shape *out) KG_CHECKED;

/* Puts a part on its page, for the questions below. */
kg_status kg_nest_exact_place(kg_nest_exact *exact, size_t part, kg_nest_place place) KG_CHECKED;

/* Whether a placed part lies in the box, to a rounding error. */
bool kg_nest_exact_inside(const kg_nest_exact *exact, size_t part, kg_box2 box);

/* Whether two placed parts of one page are nearer than the spacing, or a part and a box. */
bool kg_nest_exact_near(const kg_nest_exact *exact, size_t a, size_t b, double spacing);
bool kg_nest_exact_near_box(const kg_nest_exact *exact, size_t part, kg_box2 box, double spacing);

#endif
