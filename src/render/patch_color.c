#include "katagami/render.h"

#include "model/edit.h"

kg_color kg_patch_color(const kg_model_patch *patch) {
    kg_color color;
    return kg_color_parse(kg_model_patch_color(patch), &color)
               ? color
               : kg_palette((size_t)(patch->id - 1));
}
