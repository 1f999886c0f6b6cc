#include "app/modes/card_scene.h"

#include "app/modes/card_frame.h"
#include "app/modes/card_state.h"
#include "app/scenery.h"

#include <stdlib.h>

/* A closed card is drawn open by this much, rad: sheets that lie on each other would be drawn
 * through each other. No corner moves by more than a three-hundredth of the card. */
#define AJAR 0.003

/* Below this opening, rad, only rims are drawn: lines are drawn a little before their paper and
 * would show through the sheet that lies on them. */
#define NEARLY_SHUT 0.02

/* A cell of so many layout units has room for its hatching. */
enum { ROOMY_CELL = 12 };

/* Around what is framed, cells. */
enum { FRAME_MARGIN = 3 };

/* What stays on the graphics card: a frame, and its shapes in one pose. */
typedef struct stage {
    kg_card_frame frame;
    uint64_t solved; /* the solution that it shows */
    int shown;       /* and the remark */
    bool made, posed;
    double open;
    kg_shape *surfaces[KG_AREA_COUNT], *lines[KG_CARD_LINE_COUNT];
} stage;

/* ---- styles ------------------------------------------------------------------------------ */

kg_style kg_card_line_style(kg_card_line line, bool dark) {
    static const struct {
        kg_color color;
        float width, dashes[4];
    } looks[KG_CARD_LINE_COUNT] = {
        [KG_CARD_GRID] = {{0.2F, 0.2F, 0.25F, 0.2F}, 1, {0}},
        [KG_CARD_EDGE] = {{0.1F, 0.1F, 0.12F, 1}, 1.4F, {0}},
        [KG_CARD_MOUNTAIN] = {{0.8F, 0.0F, 0.2F, 1}, 1.8F, {9, 3, 1.5F, 3}},
        [KG_CARD_VALLEY] = {{0.0F, 0.3F, 0.72F, 1}, 1.8F, {5, 3.5F, 5, 3.5F}},
        [KG_CARD_HATCH_LOOSE] = {{0.55F, 0.32F, 0, 0.9F}, 1.2F, {0}},
        [KG_CARD_HATCH_FAULT] = {{0.55F, 0, 0.05F, 1}, 1.8F, {0}},
        [KG_CARD_HATCH_SHOWN] = {{0, 0.22F, 0.42F, 1}, 1.5F, {0}},
    };
    kg_style s = kg_line_style(looks[line].color, looks[line].width);
    for (int i = 0; i < 4; i++)
        s.dashes_px[i] = looks[line].dashes[i];
    if (dark && line == KG_CARD_EDGE)
        s.color = (kg_color){0.03F, 0.03F, 0.04F, 1};
    return s;
}

/* Grid and hatching fade where a cell is but a few pixels: else they would be all that is seen. */
static void thin(const kg_editor *e, int line, kg_style *style) {
    if (line != KG_CARD_GRID && line < KG_CARD_HATCH_LOOSE)
        return;
    double pixel = kg_camera_pixel_size(&e->pane.camera, e->pane.area.height) * e->pane.scale;
    float share = (float)fmin(kg_editor_oa(e)->cell_mm / pixel / ROOMY_CELL, 1);
    style->color.a *= line == KG_CARD_GRID ? share * share : share;
    style->size_px *= fmaxf(share, 0.5F);
}

static kg_style surface_style(kg_card_area area) {
    static const kg_color fronts[KG_AREA_COUNT] = {{0.97F, 0.95F, 0.89F, 1},
                                                   {0.96F, 0.74F, 0.33F, 1},
                                                   {0.93F, 0.42F, 0.38F, 1},
                                                   {0.5F, 0.84F, 0.98F, 1}};
    static const kg_color backs[KG_AREA_COUNT] = {{0.66F, 0.72F, 0.8F, 1},
                                                  {0.75F, 0.6F, 0.36F, 1},
                                                  {0.72F, 0.36F, 0.36F, 1},
                                                  {0.4F, 0.64F, 0.76F, 1}};
    kg_style style = kg_style_default(fronts[area]);
    style.back = backs[area];
    return style;
}

/* ---- shapes ------------------------------------------------------------------------------ */

static void clear_shapes(stage *s) {
    for (int i = 0; i < KG_AREA_COUNT; i++) {
        kg_shape_destroy(s->surfaces[i]);
        s->surfaces[i] = NULL;
    }
    for (int i = 0; i < KG_CARD_LINE_COUNT; i++) {
        kg_shape_destroy(s->lines[i]);
        s->lines[i] = NULL;
    }
    s->posed = false;
}

static kg_status upload_surface(const kg_card_frame *f, kg_card_area area, double open,
                                kg_shape **out, kg_error *error) {
    static const uint32_t corners[6] = {0, 1, 2, 0, 2, 3};
    const kg_card_points *points = &f->surfaces[area];
    kg_surface s = {.vertex_count = points->count, .triangle_count = points->count / 2};
    if (points->count == 0)
        return KG_OK;
    s.positions = malloc(points->count * sizeof *s.positions);
    s.triangles = malloc(3 * s.triangle_count * sizeof *s.triangles);
    kg_status status =
        s.positions && s.triangles ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status) {
        kg_card_frame_pose(f, points, open, s.positions);
        for (size_t i = 0; i < 3 * s.triangle_count; i++)
            s.triangles[i] = (uint32_t)(i / 6 * 4) + corners[i % 6];
        status = kg_shape_from_surface(&s, out, error);
    }
    kg_surface_destroy(&s);
    return status;
}

static kg_status upload_lines(const kg_card_frame *f, kg_card_line kind, double open,
                              kg_shape **out, kg_error *error) {
    const kg_card_points *points = &f->lines[kind];
    if (points->count == 0)
        return KG_OK;
    size_t count = points->count / 2;
    kg_vec3 *positions = malloc(points->count * sizeof *positions);
    uint32_t *starts = malloc((count + 1) * sizeof *starts);
    kg_status status = positions && starts ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status) {
        kg_card_frame_pose(f, points, open, positions);
        for (size_t i = 0; i <= count; i++)
            starts[i] = (uint32_t)(2 * i);
        status = kg_shape_from_lines(&(kg_lines){positions, starts, count}, out, error);
    }
    free(positions);
    free(starts);
    return status;
}

static kg_status make(stage *s, const kg_editor *e, int shown, kg_error *error) {
    const kg_document *d = e->document;
    clear_shapes(s);
    kg_card_frame_clear(&s->frame);
    s->made = false;
    kg_status status =
        kg_card_frame_make(kg_editor_oa(e), kg_document_sheet(d), kg_document_stability(d),
                           kg_document_remarks(d), shown, &s->frame, error);
    s->made = !status;
    s->solved = e->solved;
    s->shown = shown;
    return status;
}

static kg_status pose(stage *s, double open, kg_error *error) {
    kg_status status = KG_OK;
    double drawn = fmin(fmax(open, AJAR), KG_PI);
    clear_shapes(s);
    for (int i = 0; i < KG_AREA_COUNT && !status; i++)
        status = upload_surface(&s->frame, (kg_card_area)i, drawn, &s->surfaces[i], error);
    for (int i = 0; i < KG_CARD_LINE_COUNT && !status; i++)
        status = upload_lines(&s->frame, (kg_card_line)i, drawn, &s->lines[i], error);
    s->posed = !status;
    s->open = open;
    return status;
}

/* ---- the picture ------------------------------------------------------------------------- */

/* The cell under the pointer, in whatever view. */
static void add_hovered(const kg_editor *e, kg_overlay *o) {
    const kg_card_state *state = kg_card_state_of(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    kg_style rim = kg_line_style((kg_color){0.95F, 0.55F, 0, 1}, 3);
    kg_vec3 corners[5];
    if (!state->hovering)
        return;
    rim.hidden = 0.35F;
    bool whole = kg_oa_cell_shape(sheet, state->hover_x, state->hover_row) == KG_OA_WHOLE;
    for (int side = 0; side < (whole ? 1 : 2); side++) {
        int n = kg_card_cell_corners(kg_editor_oa(e), sheet, state->hover_x, state->hover_row, side,
                                     state->open, corners);
        corners[n] = corners[0];
        kg_overlay_line(o, corners, (size_t)n + 1, rim);
    }
}

kg_status kg_card_scene_compose(void **cache, const kg_editor *e, kg_overlay *o, kg_error *error) {
    if (!*cache && !(*cache = calloc(1, sizeof(stage))))
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    stage *s = *cache;
    const kg_card_state *state = kg_card_state_of(e);
    int shown = kg_card_remark_now(e);
    bool dark = e->settings.theme == KG_UI_DARK;
    kg_status status = KG_OK;
    if (!kg_document_sheet(e->document))
        return KG_OK;
    if (!s->made || s->solved != e->solved || s->shown != shown)
        status = make(s, e, shown, error);
    if (!status && (!s->posed || s->open != state->open))
        status = pose(s, state->open, error);
    if (status)
        return status;
    for (int i = 0; i < KG_AREA_COUNT; i++)
        kg_overlay_item(o, s->surfaces[i], surface_style((kg_card_area)i));
    bool shut = state->open < NEARLY_SHUT;
    for (int i = 0; i < KG_CARD_LINE_COUNT; i++) {
        if (shut && i != KG_CARD_EDGE)
            continue;
        kg_style style = kg_card_line_style((kg_card_line)i, dark);
        thin(e, i, &style);
        kg_overlay_item(o, s->lines[i], style);
    }
    add_hovered(e, o);
    return KG_OK;
}

void kg_card_scene_drop(void *cache) {
    stage *s = cache;
    clear_shapes(s);
    kg_card_frame_clear(&s->frame);
    free(s);
}

/* ---- bounds ------------------------------------------------------------------------------ */

static void add_cell(const kg_editor *e, int x, int row, kg_box3 *box) {
    kg_vec3 corners[4];
    int n = kg_card_cell_corners(kg_editor_oa(e), kg_document_sheet(e->document), x, row, 0,
                                 kg_card_state_of(e)->open, corners);
    for (int i = 0; i < n; i++)
        kg_box3_add(box, corners[i]);
}

static void add_spots(const kg_editor *e, const kg_spots *b, kg_box3 *box) {
    const kg_oa *oa = kg_editor_oa(e);
    kg_vec3 axes[5];
    kg_oa_axes(kg_card_state_of(e)->open, axes);
    for (int i = 0; i < 8; i++) {
        double x = i & 1 ? b->hi.x + 1 : b->lo.x, y = i & 2 ? b->hi.y + 1 : b->lo.y,
               z = i & 4 ? b->hi.z + 1 : b->lo.z;
        kg_vec3 p = kg_add(kg_scale(axes[1], y), kg_scale(axes[2], z));
        kg_box3_add(box, kg_v3(x * oa->cell_mm, -p.y * oa->cell_mm, p.z * oa->cell_mm));
    }
}

static void widen(kg_box3 *box, double by) {
    box->lo = kg_sub(box->lo, kg_v3(by, by, by));
    box->hi = kg_add(box->hi, kg_v3(by, by, by));
}

kg_box3 kg_card_scene_box(const kg_editor *e, bool selection) {
    const kg_card_state *state = kg_card_state_of(e);
    const kg_oa_sheet *sheet = kg_document_sheet(e->document);
    const kg_oa_remarks *remarks = kg_document_remarks(e->document);
    kg_box3 box = kg_box3_empty();
    if (!sheet || !remarks)
        return box;
    if (selection && state->shown_remark >= 0) {
        const kg_oa_remark *r = &remarks->items[state->shown_remark];
        for (size_t i = 0; i < r->cells; i++) {
            int32_t cell = remarks->cells[r->first_cell + i];
            add_cell(e, cell % sheet->width, cell / sheet->width, &box);
        }
        widen(&box, FRAME_MARGIN * kg_editor_oa(e)->cell_mm);
    } else if (selection && state->boxed) {
        add_spots(e, &state->box, &box);
        widen(&box, FRAME_MARGIN * kg_editor_oa(e)->cell_mm);
    } else if (!selection) {
        for (int row = 0; row < sheet->rows; row++)
            for (int x = 0; x < sheet->width; x++)
                add_cell(e, x, row, &box);
    }
    return box;
}
