/*
 * Edits of models: what more than one field has to follow. Everything else is set in the model's
 * own fields. Failed edits leave the model as it was.
 */
#ifndef KG_MODEL_EDIT_H
#define KG_MODEL_EDIT_H

#include "katagami/model.h"

/* Adds a patch behind the others, with the next free id (to `out_id`). `name` may be NULL.
 * KG_ERR_INPUT as kg_patch_init; KG_ERR_MEMORY. */
kg_status kg_model_add_patch(kg_model *model, const kg_patch_input *input, const char *name,
                             int64_t *out_id, kg_error *error) KG_CHECKED;

/* Removes a patch and its id from all trims; trims that it alone made go with it. KG_ERR_INPUT: no
 * such patch. */
kg_status kg_model_remove_patch(kg_model *model, int64_t id, kg_error *error) KG_CHECKED;

/* Adds a copy of a patch, trims included, behind it. */
kg_status kg_model_duplicate_patch(kg_model *model, int64_t id, int64_t *out_id,
                                   kg_error *error) KG_CHECKED;

/* Turns and moves a patch, x -> scale * R x + offset, with its extent, its contours, the places its
 * trims keep and those that name joins. `rotation`: row-major, orthonormal, determinant 1 or -1.
 * Mirrored, the rulings run the other way (D, see kg_curve_darboux, changes its sign against the
 * mirrored one), so extent and contours change sign in u, and the front stays the image of the
 * front. KG_ERR_INPUT: scale not positive, results not finite or out of the model's range. */
typedef struct kg_similarity {
    double rotation[9];
    double scale;
    kg_vec3 offset;
} kg_similarity;
kg_status kg_model_transform_patch(kg_model *model, int64_t id, const kg_similarity *map,
                                   kg_error *error) KG_CHECKED;
kg_vec3 kg_similarity_apply(const kg_similarity *map, kg_vec3 point);
/* The reflection in the plane through `point` with unit `normal`. */
kg_similarity kg_similarity_mirror(kg_vec3 point, kg_vec3 normal);
/* The rotation by `angle` about the axis through `center`, unit `axis`. */
kg_similarity kg_similarity_turn(kg_vec3 center, kg_vec3 axis, double angle);

/* Adds a trim behind the patch's others; takes over the arrays of `op`, also on failure. */
kg_status kg_model_add_trim(kg_model *model, int64_t patch, kg_trim_op *op,
                            kg_error *error) KG_CHECKED;
kg_status kg_model_remove_trim(kg_model *model, int64_t patch, size_t index,
                               kg_error *error) KG_CHECKED;
/* Gives the trim at `from` the place `to`; those between move up. */
kg_status kg_model_move_trim(kg_model *model, int64_t patch, size_t from, size_t to,
                             kg_error *error) KG_CHECKED;

/* Colour of a patch, "#rrggbb"; NULL: none given. It lives among the patch's other keys. */
const char *kg_model_patch_color(const kg_model_patch *patch);
kg_status kg_model_set_patch_color(kg_model_patch *patch, const char *color,
                                   kg_error *error) KG_CHECKED;

/* Whether two models or patches say the same, byte for byte in all that is stored. */
bool kg_model_patch_equal(const kg_model_patch *a, const kg_model_patch *b);
bool kg_model_equal(const kg_model *a, const kg_model *b);

/* Exchanges the contents of two models. */
void kg_model_swap(kg_model *a, kg_model *b);

#endif
