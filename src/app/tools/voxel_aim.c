#include "app/tools/voxel_aim.h"

/* Voxel coordinates are affine at every opening, but of no use within 3 degrees of flat or closed:
 * a pixel then is many voxels. */
#define LEAST_SINE 0.05

/* Slope of a line of sight in a plane's own terms below which it is edge-on. */
#define EDGE_ON 1e-3

static void axes_of(const kg_editor *e, kg_vec3 out_axes[5]) {
    kg_oa_axes(kg_card_state_of(e)->open, out_axes);
}

kg_vec3 kg_voxel_world(const kg_editor *e, kg_vec3 p) {
    double cell = kg_editor_oa(e)->cell_mm;
    kg_vec3 axes[5];
    axes_of(e, axes);
    kg_vec3 at = kg_add(kg_scale(axes[1], p.y), kg_scale(axes[2], p.z));
    return kg_v3(p.x * cell, -at.y * cell, at.z * cell);
}

static kg_vec3 from_world(kg_vec3 v, const kg_vec3 axes[5], double cell) {
    double z = v.z / (cell * axes[2].z);
    return kg_v3(v.x / cell, -v.y / cell - z * axes[2].y, z);
}

/* The line of sight in voxel coordinates. */
static bool sight(const kg_editor *e, kg_vec2 px, kg_vec3 *out_origin, kg_vec3 *out_direction) {
    double cell = kg_editor_oa(e)->cell_mm;
    kg_vec3 axes[5], origin, direction;
    axes_of(e, axes);
    if (axes[2].z < LEAST_SINE)
        return false;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    *out_origin = from_world(origin, axes, cell);
    *out_direction = from_world(direction, axes, cell);
    return true;
}

bool kg_voxel_hit(const kg_editor *e, kg_vec2 px, kg_oa_hit *out_hit) {
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    kg_vec3 origin, direction;
    if (!sheet)
        return false;
    kg_pane_ray(&e->pane, px, &origin, &direction);
    return kg_oa_pick(kg_editor_oa(e), sheet, kg_card_state_of(e)->open, origin, direction,
                      out_hit);
}

bool kg_voxel_on_plane(const kg_editor *e, kg_vec2 px, bool level, double at, kg_vec3 *out) {
    kg_vec3 origin, direction;
    if (!sight(e, px, &origin, &direction))
        return false;
    double speed = level ? direction.z : direction.y;
    double distance = (at - (level ? origin.z : origin.y)) / speed;
    if (!(fabs(speed) * kg_editor_oa(e)->cell_mm > EDGE_ON) ||
        (distance < 0 && !e->pane.camera.ortho))
        return false;
    *out = kg_madd(origin, distance, direction);
    return true;
}

bool kg_voxel_on_paper(const kg_editor *e, kg_vec2 px, kg_vec3 *out) {
    kg_vec3 origin, direction;
    kg_oa_hit hit;
    if (!kg_voxel_hit(e, px, &hit) || !sight(e, px, &origin, &direction))
        return false;
    *out = kg_madd(origin, hit.distance, direction);
    return true;
}

bool kg_voxel_under(const kg_editor *e, kg_vec2 px, bool filled, kg_spot *out) {
    const kg_card_state *s = kg_card_state_of(e);
    kg_oa_hit hit;
    kg_vec3 p;
    if (kg_voxel_hit(e, px, &hit)) {
        kg_oa_voxel v = hit.voxel;
        *out = (kg_spot){v.x, v.y + (!filled && !v.top), v.z + (!filled && v.top)};
    } else if (!filled &&
               kg_voxel_on_plane(e, px, s->level, s->level ? s->cursor.z : s->cursor.y, &p)) {
        *out = (kg_spot){(int)floor(p.x), s->level ? (int)floor(p.y) : s->cursor.y,
                         s->level ? s->cursor.z : (int)floor(p.z)};
    } else {
        return false;
    }
    return kg_card_has(kg_editor_oa(e), *out);
}
