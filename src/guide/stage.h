/* Pictures of the parts that stand, the new one and its joins, rendered off-screen. */
#ifndef KG_GUIDE_STAGE_H
#define KG_GUIDE_STAGE_H

#include "guide/sight.h"

/* Colours that the legend shows as well, 0xrrggbb. */
#define KG_STAGE_STANDING 0xd3dbe3
#define KG_STAGE_STANDING_BACK 0xa39a8c
#define KG_STAGE_NEW 0xf5a623
#define KG_STAGE_NEW_BACK 0xe6d6a2
#define KG_STAGE_JOIN 0xc2185b

typedef struct kg_stage kg_stage;

/* Starts OpenGL. KG_ERR_SYSTEM when the machine has none. */
kg_status kg_stage_create(const kg_assembly *assembly, kg_stage **out_stage,
                          kg_error *error) KG_CHECKED;
void kg_stage_destroy(kg_stage *stage);

typedef enum kg_stage_look {
    KG_LOOK_STEP,  /* new parts in one colour, others pale */
    KG_LOOK_COLORS /* each part in a colour of its own */
} kg_stage_look;

kg_status kg_stage_picture(kg_stage *stage, const kg_view_of *view, kg_stage_look look,
                           const kg_camera *camera, int width, int height, kg_image *out_image,
                           kg_error *error) KG_CHECKED;

#endif
