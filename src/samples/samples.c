#include "samples/samples.h"

#include "samples/card_models.h"
#include "samples/castle_mesh.h"
#include "samples/dolphin_mesh.h"
#include "samples/dolphin_model.h"
#include "samples/simple_models.h"

#include <stdlib.h>

static kg_status finish(bool complete, kg_error *error) {
    return complete ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

static kg_status write_reference(text *out, kg_error *error) {
    return finish(dolphin_mesh_write(out), error);
}

static kg_status write_castle(text *out, kg_error *error) {
    return finish(castle_mesh_write(out), error);
}

static kg_status write_dolphin(text *out, kg_error *error) {
    sample_model *model = calloc(1, sizeof *model);
    if (!model)
        return finish(false, error);
    kg_status status = dolphin_model_build(model, error);
    if (status == KG_OK)
        status = finish(sample_write(model, out), error);
    free(model);
    return status;
}

static kg_status write_simple(void (*build)(sample_model *), text *out, kg_error *error) {
    sample_model *model = calloc(1, sizeof *model);
    if (!model)
        return finish(false, error);
    build(model);
    bool complete = sample_write(model, out);
    free(model);
    return finish(complete, error);
}

static kg_status write_fin(text *out, kg_error *error) {
    return write_simple(fin_model_build, out, error);
}

static kg_status write_lantern(text *out, kg_error *error) {
    return write_simple(lantern_model_build, out, error);
}

static kg_status write_ribbon(text *out, kg_error *error) {
    return write_simple(ribbon_model_build, out, error);
}

const sample_file sample_files[SAMPLE_FILE_COUNT] = {
    {"dolphin.obj", write_reference},
    {"dolphin.katagami", write_dolphin},
    {"fin.katagami", write_fin},
    {"lantern.katagami", write_lantern},
    {"ribbon.katagami", write_ribbon},
    {"castle.obj", write_castle},
    {"castle.katagami", castle_card_write},
    {"house.katagami", house_card_write},
    {"pyramids.katagami", pyramids_card_write},
    {"tower.katagami", tower_card_write},
};
