#include "app/modes/card_net.h"

#include "app/modes/card_edit.h"
#include "app/text.h"
#include "app/ui/ui.h"

#include <stdio.h>

/* Cards up to so many cells tell scripts where their faces are. */
enum { NAMED_CELLS = 1500 };

static void leave(kg_card_state *s) {
    s->hovering = false;
    s->hover_remark = -1;
}

/* The cell of the sheet at a point of the net. */
static bool cell_at(const kg_editor *e, kg_vec2 point, int *out_x, int *out_row) {
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    double cell = kg_editor_oa(e)->cell_mm;
    if (!sheet || !(point.x >= 0 && point.x < sheet->width * cell && point.y >= 0 &&
                    point.y < sheet->rows * cell))
        return false;
    *out_x = (int)(point.x / cell);
    *out_row = (int)(point.y / cell);
    return *out_x < sheet->width && *out_row < sheet->rows;
}

/* Lights the cell up in the 3D view, and takes the cursor there. */
static void hover(kg_editor *e, const kg_vec2 *point) {
    kg_card_state *s = kg_card_state_of(e);
    int x, row;
    if (!point || !cell_at(e, *point, &x, &row)) {
        leave(s);
        return;
    }
    kg_oa_voxel v = kg_oa_faced(kg_document_sheet(e->document), x, row);
    s->hovering = true;
    s->hover_x = x;
    s->hover_row = row;
    s->hover_remark = kg_card_remark_at(e, x, row);
    kg_card_move_cursor(e, (kg_spot){v.x, v.y, v.z});
}

static bool face_at(const kg_editor *e, const kg_vec2 *point, kg_face *out) {
    int x, row;
    return point && cell_at(e, *point, &x, &row) && kg_card_face_at(e, x, row, out);
}

/* A stroke gives all fronts (or tops) on its way the state that the first one had not. */
static bool start(kg_editor *e, const kg_vec2 *point) {
    kg_card_state *s = kg_card_state_of(e);
    kg_face face;
    kg_error error;
    if (!face_at(e, point, &face))
        return false;
    if (kg_editor_begin(e, face.top ? N_("Leave out tops") : N_("Windows"), &error)) {
        kg_editor_say(e, KG_FAULT, "%s", error.message);
        return false;
    }
    s->painting_net = true;
    s->paint_top = face.top;
    s->paint = !kg_card_face_is_set(e, face);
    kg_card_set_face(e, face, s->paint);
    return true;
}

bool kg_card_net_event(kg_editor *e, const kg_event *event, const kg_vec2 *point) {
    kg_card_state *s = kg_card_state_of(e);
    kg_face face;
    switch (event->type) {
    case KG_EVENT_MOVE:
        hover(e, point);
        if (s->painting_net && e->before && face_at(e, point, &face) && face.top == s->paint_top)
            kg_card_set_face(e, face, s->paint);
        return s->painting_net;
    case KG_EVENT_PRESS:
        e->message[0] = '\0';
        return start(e, point);
    case KG_EVENT_RELEASE:
        if (s->painting_net)
            kg_editor_commit(e);
        s->painting_net = false;
        return true;
    default:
        return false;
    }
}

/* ---- what is drawn over the net ---------------------------------------------------------- */

static kg_area box_of(const kg_net_map *map, double cell, int x, int row) {
    kg_box2 box = kg_box2_empty();
    for (int i = 0; i < 4; i++)
        kg_box2_add(
            &box, kg_net_map_apply(map, kg_v2((x + (i & 1)) * cell, (row + (i >> 1 & 1)) * cell)));
    return (kg_area){box.lo.x, box.lo.y, box.hi.x - box.lo.x, box.hi.y - box.lo.y};
}

static void draw_remark(const kg_editor *e, const kg_net_map *map, double scale) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    int shown = kg_card_remark_now(e);
    if (shown < 0 || (size_t)shown >= remarks->count)
        return;
    const kg_oa_remark *r = &remarks->items[shown];
    for (size_t i = 0; i < r->cells; i++) {
        int32_t cell = remarks->cells[r->first_cell + i];
        kg_area a = box_of(map, kg_editor_oa(e)->cell_mm, cell % sheet->width, cell / sheet->width);
        kg_ui_canvas_rect(a, (kg_color){0.2F, 0.65F, 0.95F, 0.4F}, 0);
        kg_ui_canvas_line(kg_v2(a.x, a.y), kg_v2(a.x + a.width, a.y + a.height),
                          (kg_color){0, 0.3F, 0.6F, 0.8F}, scale);
    }
}

/* Cells that something is wrong with are hatched, as in the 3D view. */
static void draw_troubles(const kg_editor *e, const kg_net_map *map, double scale) {
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    for (size_t k = 0; k < remarks->count; k++) {
        const kg_oa_remark *r = &remarks->items[k];
        bool fault = kg_oa_is_fault(r->trouble);
        if (!fault && r->trouble != KG_OA_LOOSE && r->trouble != KG_OA_FLAP)
            continue;
        kg_color color = fault ? (kg_color){0.85F, 0.1F, 0.1F, 1} : (kg_color){0.9F, 0.6F, 0.1F, 1};
        for (size_t i = 0; i < r->cells; i++) {
            int32_t cell = remarks->cells[r->first_cell + i];
            kg_area a =
                box_of(map, kg_editor_oa(e)->cell_mm, cell % sheet->width, cell / sheet->width);
            color.a = 0.3F;
            kg_ui_canvas_rect(a, color, 0);
            color.a = 0.8F;
            kg_ui_canvas_line(kg_v2(a.x, a.y + a.height), kg_v2(a.x + a.width, a.y), color, scale);
        }
    }
}

/* Tells scripts where the faces are. */
static void name_faces(const kg_editor *e, const kg_net_map *map) {
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    for (int row = 0; row < sheet->rows; row++)
        for (int x = 0; x < sheet->width; x++) {
            kg_face face;
            char name[48];
            if (!kg_card_face_at(e, x, row, &face))
                continue;
            snprintf(name, sizeof name, "net %s %d %d", face.top ? "top" : "front", face.x, face.z);
            kg_ui_name(name, box_of(map, kg_editor_oa(e)->cell_mm, x, row));
        }
}

void kg_card_net_draw(const kg_editor *e, const kg_net_map *map, double scale) {
    const kg_card_state *s = kg_card_state_of(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    if (!sheet || !kg_document_remarks(e->document))
        return;
    draw_troubles(e, map, scale);
    draw_remark(e, map, scale);
    if (s->hovering)
        kg_ui_canvas_frame(box_of(map, kg_editor_oa(e)->cell_mm, s->hover_x, s->hover_row),
                           (kg_color){0.95F, 0.55F, 0, 1}, 2.5 * scale, 0);
    if (sheet->width * sheet->rows <= NAMED_CELLS)
        name_faces(e, map);
}
