/* What is seen of the parts shown, and from where the most of it is. */
#ifndef KG_GUIDE_SIGHT_H
#define KG_GUIDE_SIGHT_H

#include "guide/assembly.h"

typedef enum kg_role { KG_ROLE_ABSENT = 0, KG_ROLE_STANDING, KG_ROLE_NEW } kg_role;

/* What one picture is about. */
typedef struct kg_view_of {
    const unsigned char *roles; /* kg_role per part */
    kg_vec3 offset;             /* how far new parts are drawn from their place */
    const int *joins;           /* to be glued */
    size_t join_count;
} kg_view_of;

typedef struct kg_sight kg_sight;

kg_status kg_sight_create(const kg_assembly *assembly, const kg_view_of *view, kg_sight **out_sight,
                          kg_error *error) KG_CHECKED;
void kg_sight_destroy(kg_sight *sight);

/* Is there nothing between `point` and a camera far away in `direction` (unit)? */
bool kg_sight_is_free(const kg_sight *sight, kg_vec3 point, kg_vec3 direction);

/* Where a sample of a part is drawn. */
kg_vec3 kg_view_sample(const kg_assembly *assembly, const kg_view_of *view, size_t part,
                       size_t sample);

/* A box around all parts of a role (KG_ROLE_ABSENT: all that are shown), as drawn. */
kg_box3 kg_view_box(const kg_assembly *assembly, const kg_view_of *view, kg_role role);

/* The direction and distance by which a new part is drawn away from its joins: away from them in
 * its own surface where they lie on one side of it, else off its front. */
kg_vec3 kg_view_offset(const kg_assembly *assembly, int part, const int *joins, size_t join_count);

/* Turns the camera so that most of the new parts' area and of the joins' length is seen, rather
 * from the front of the paper, from above, and near `camera`'s own direction. */
void kg_sight_aim(const kg_sight *sight, kg_camera *camera);

#endif
