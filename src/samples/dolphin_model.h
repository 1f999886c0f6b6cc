/* The paper dolphin: sheets fitted to the dolphin's shape and cut by each other. */
#ifndef KG_SAMPLES_DOLPHIN_MODEL_H
#define KG_SAMPLES_DOLPHIN_MODEL_H

#include "samples/model_writer.h"

/* Fits all patches. Errors: KG_ERR_INPUT naming the sheet that cannot be fitted. */
kg_status dolphin_model_build(sample_model *out_model, kg_error *error) KG_CHECKED;

#endif
