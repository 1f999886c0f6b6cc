/*
 * Matrices of a camera, column by column as OpenGL wants them. The one place that uses GLM.
 */
#ifndef KG_RENDER_CAMERA_H
#define KG_RENDER_CAMERA_H

#include "katagami/render.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Near and far planes (mm from the eye's plane) that hold all of `box`; near is > 0 unless the
 * projection is parallel. */
void kg_camera_range(const kg_camera *camera, kg_box3 box, double *out_near, double *out_far);

/* World to view with `origin` as the world's origin, rounded to float only at the end: shapes far
 * from zero keep their shape. */
void kg_camera_view(const kg_camera *camera, kg_vec3 origin, float out_matrix[16]);

void kg_camera_projection(const kg_camera *camera, double aspect, double near, double far,
                          float out_matrix[16]);

#ifdef __cplusplus
}
#endif
#endif
