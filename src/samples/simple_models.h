/* Small models, each for a few things that a paper model can have. */
#ifndef KG_SAMPLES_SIMPLE_MODELS_H
#define KG_SAMPLES_SIMPLE_MODELS_H

#include "samples/model_writer.h"

/* A curved panel and a fin that stands on it: one contact. */
void fin_model_build(sample_model *out_model);

/* Four sides meeting in seams, a bottom between them, round windows, cut open at the top by a
 * construction patch. */
void lantern_model_build(sample_model *out_model);

/* A twisted ribbon that an arch cuts into three pieces; its front is the hollow side. */
void ribbon_model_build(sample_model *out_model);

#endif
