/* The plane that copies are mirrored across, in the model's file. */
#ifndef KG_MODEL_MIRROR_H
#define KG_MODEL_MIRROR_H

#include "katagami/model.h"

struct json_t;

/* y = 0 when the file says nothing, or nothing that makes sense. */
kg_mirror_plane kg_mirror_plane_read(const struct json_t *root);

/* Sets the key, or takes it out for y = 0; what makes no sense is another program's and stays.
 * False when memory runs out. */
bool kg_mirror_plane_write(kg_mirror_plane plane, struct json_t *root) KG_CHECKED;

bool kg_mirror_plane_equal(kg_mirror_plane a, kg_mirror_plane b);
kg_vec3 kg_mirror_plane_normal(kg_mirror_plane plane);

#endif
