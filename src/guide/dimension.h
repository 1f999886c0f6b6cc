/* Lengths in the pictures of folds: where they are drawn on the page. */
#ifndef KG_GUIDE_DIMENSION_H
#define KG_GUIDE_DIMENSION_H

#include "guide/diagram.h"

/* Millimetres on the page, y down. */
typedef struct kg_dimension {
    kg_vec2 feet[2]; /* the ends of what is measured */
    kg_vec2 outwards;
    double off; /* from them to the line */
    kg_box2 label;
    double length; /* mm of paper */
} kg_dimension;

/* Finds places beside `lengths`, given on the page, where neither lines nor labels lie on the arrow
 * or on each other if that can be; `label_width` mm wide. What another says already is left out: a
 * line parallel to an edge is found by one length. Returns how many there are. */
size_t kg_dimensions_place(const kg_diagram_length *lengths, size_t count, const kg_vec2 *arrow,
                           size_t arrow_count, double label_width,
                           kg_dimension out[KG_DIAGRAM_MEASURES]);

/* A point as far outwards from an end of what is measured. */
kg_vec2 kg_dimension_at(const kg_dimension *dimension, int end, double off);

#endif
