#include "app/tools/voxel_draw.h"

#include "app/scenery.h"
#include "app/tools/voxel_aim.h"
#include "base/array.h"

#include <stdlib.h>

/* Lines of the plane's grid around the cursor, to each side. */
enum { GRID_REACH = 6 };

static const kg_color colors[] = {[KG_VOXEL_ADDED] = {0.05F, 0.55F, 0.3F, 1},
                                  [KG_VOXEL_REMOVED] = {0.85F, 0.15F, 0.1F, 1},
                                  [KG_VOXEL_SELECTED] = {0.15F, 0.4F, 0.9F, 1}};

/* Corner i of a box: bit 0 is x, bit 1 y, bit 2 z. */
static void corners_of(const kg_editor *e, const kg_spots *b, kg_vec3 out[8]) {
    for (int i = 0; i < 8; i++)
        out[i] =
            kg_voxel_world(e, kg_v3(i & 1 ? b->hi.x + 1 : b->lo.x, i & 2 ? b->hi.y + 1 : b->lo.y,
                                    i & 4 ? b->hi.z + 1 : b->lo.z));
}

void kg_voxel_draw_box(const kg_editor *e, kg_overlay *o, const kg_spots *box, kg_voxel_look look) {
    static const uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    kg_vec3 corners[8];
    uint32_t triangles[36];
    corners_of(e, box, corners);
    for (int f = 0; f < 6; f++) {
        const uint32_t *q = faces[f], two[6] = {q[0], q[1], q[2], q[0], q[2], q[3]};
        for (int i = 0; i < 6; i++)
            triangles[6 * f + i] = two[i];
    }
    kg_style fill = kg_style_default(colors[look]);
    fill.unlit = true;
    fill.color.a = look == KG_VOXEL_SELECTED ? 0.14F : 0.25F;
    kg_overlay_surface(
        o,
        &(kg_surface){
            .vertex_count = 8, .positions = corners, .triangle_count = 12, .triangles = triangles},
        fill);
    kg_style line = kg_line_style(colors[look], 2);
    line.hidden = 0.35F;
    if (look == KG_VOXEL_REMOVED) { /* never by colour alone */
        line.dashes_px[0] = line.dashes_px[2] = 4;
        line.dashes_px[1] = line.dashes_px[3] = 3;
    }
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit))
                kg_overlay_line(o, (kg_vec3[]){corners[i], corners[i | bit]}, 2, line);
}

static int least(int a, int b) {
    return a < b ? a : b;
}
static int most(int a, int b) {
    return a > b ? a : b;
}

void kg_voxel_draw_plane(const kg_editor *e, kg_overlay *o) {
    const kg_card_state *s = kg_card_state_of(e);
    const kg_oa *oa = kg_editor_oa(e);
    int v = s->level ? s->cursor.y : s->cursor.z, rows = s->level ? oa->depth_limit : oa->height;
    int x0 = most(s->cursor.x - GRID_REACH, 0), x1 = least(s->cursor.x + GRID_REACH + 1, oa->width);
    int v0 = most(v - GRID_REACH, 0), v1 = least(v + GRID_REACH + 1, rows);
    kg_vec3 points[4 * (2 * GRID_REACH + 2)];
    uint32_t starts[2 * (2 * GRID_REACH + 2) + 1];
    size_t count = 0;
    double at = s->level ? s->cursor.z : s->cursor.y;
    for (int x = x0; x <= x1; x++)
        for (int end = 0; end < 2; end++) {
            double w = end ? v1 : v0;
            points[count++] = kg_voxel_world(e, s->level ? kg_v3(x, w, at) : kg_v3(x, at, w));
        }
    for (int w = v0; w <= v1; w++)
        for (int end = 0; end < 2; end++) {
            double x = end ? x1 : x0;
            points[count++] = kg_voxel_world(e, s->level ? kg_v3(x, w, at) : kg_v3(x, at, w));
        }
    for (size_t i = 0; i <= count / 2; i++)
        starts[i] = (uint32_t)(2 * i);
    kg_style style = kg_line_style((kg_color){0.1F, 0.45F, 0.75F, 0.55F}, 1);
    style.hidden = 0.15F;
    kg_overlay_lines(o, &(kg_lines){points, starts, count / 2}, style);
}
