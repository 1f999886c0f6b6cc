/* Sheets and folds for tests. */
#ifndef KG_TESTS_ORIGAMI_SAMPLES_H
#define KG_TESTS_ORIGAMI_SAMPLES_H

#include "katagami/origami.h"

/* One square sheet, (0,0) to (side,side). */
kg_origami *square_sheet(double side);
void add_rectangle(kg_origami *origami, double x, double y, double width, double height);

kg_fold fold_to(kg_vec3 from, kg_vec3 to, double angle_deg);
kg_fold fold_axis(kg_vec3 p, kg_vec3 q, kg_vec3 vertex, double angle_deg);
/* Folds and fails the test, with the message, when it cannot. */
void must_fold(kg_origami *origami, kg_fold fold);
/* Folds, expects a refusal and puts its message in `error`. */
void must_refuse(kg_origami *origami, kg_fold fold, kg_error *error);
/* The last state. */
const kg_origami_state *last(const kg_origami *origami);

#endif
