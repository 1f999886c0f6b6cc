/* Where the pointer is on a pop-up card: the cell under it, and the voxel that it means. */
#ifndef KG_APP_TOOLS_VOXEL_AIM_H
#define KG_APP_TOOLS_VOXEL_AIM_H

#include "app/modes/card_state.h"

/* The paper under a pixel, at the present opening. */
bool kg_voxel_hit(const kg_editor *editor, kg_vec2 px, kg_oa_hit *out_hit);

/* The voxel a pixel means: `filled`, the one behind the paper there, else the free one before it;
 * beside the paper that of the active plane. False: none. */
bool kg_voxel_under(const kg_editor *editor, kg_vec2 px, bool filled, kg_spot *out_spot);

/* A point over (e1, f, b) in voxels, at the present opening, in the world. */
kg_vec3 kg_voxel_world(const kg_editor *editor, kg_vec3 point);

/* Where the line of sight meets the plane y = `at` (level: z = `at`) of voxel coordinates, as a
 * point of these. False when it is seen edge-on, or the card is nearly flat or closed. */
bool kg_voxel_on_plane(const kg_editor *editor, kg_vec2 px, bool level, double at,
                       kg_vec3 *out_point);

/* Where on the paper a pixel is, in voxel coordinates. */
bool kg_voxel_on_paper(const kg_editor *editor, kg_vec2 px, kg_vec3 *out_point);

#endif
