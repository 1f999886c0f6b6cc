/*
 * The 3D picture of an editor: what its mode and its tool show. Shapes stay on the graphics card
 * until what they show changes.
 */
#ifndef KG_APP_SCENERY_H
#define KG_APP_SCENERY_H

#include "app/editor.h"
#include "app/overlay.h"

typedef struct kg_scenery kg_scenery;

kg_status kg_scenery_create(kg_scenery **out_stage, kg_error *error) KG_CHECKED;
void kg_scenery_destroy(kg_scenery *stage);

/* Draws into the bound framebuffer, `height_px` high. */
kg_status kg_scenery_draw(kg_scenery *stage, const kg_editor *editor, int height_px,
                          kg_error *error) KG_CHECKED;

/* The same as a picture of its own. */
kg_status kg_scenery_picture(kg_scenery *stage, const kg_editor *editor, int width, int height,
                             kg_image *out_image, kg_error *error) KG_CHECKED;

/* Other things in the same way, small and without background. */
kg_status kg_scenery_thumbnail(kg_scenery *stage, const kg_overlay *overlay,
                               const kg_camera *camera, int width, int height, kg_image *out_image,
                               kg_error *error) KG_CHECKED;

/* Lines so many layout units wide. */
kg_style kg_line_style(kg_color color, float width);

/* "#rrggbb" */
void kg_color_print(kg_color color, char out[8]);

/* Colours of a selected patch by its rank, apart also for colour-blind eyes. */
kg_color kg_rank_color(int rank);

#endif
