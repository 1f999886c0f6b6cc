#include "app/modes/card_frame.h"

#include "base/array.h"
#include "oa/sheet.h"

#include <stdlib.h>

/* Points are counted in quarters of a cell, for the hatching. */
enum { UNIT = 4 };

typedef struct maker {
    const kg_oa_sheet *sheet;
    kg_card_frame *frame;
    unsigned char *areas; /* of each piece, two per cell */
    bool failed;
} maker;

/* ---- which surface a piece belongs to --------------------------------------------------- */

static void mark_remark(maker *m, const kg_oa_remarks *remarks, const kg_oa_remark *r,
                        kg_card_area area) {
    for (size_t i = 0; i < r->cells; i++) {
        size_t cell = (size_t)remarks->cells[r->first_cell + i];
        m->areas[2 * cell] = m->areas[2 * cell + 1] = (unsigned char)area;
    }
}

static void mark(maker *m, const kg_oa_stability *stability, const kg_oa_remarks *remarks,
                 int shown) {
    size_t pieces = 2 * (size_t)m->sheet->width * (size_t)m->sheet->rows;
    for (size_t i = 0; i < pieces && stability; i++)
        if (!stability->patches[stability->patch_of[i]].stable)
            m->areas[i] = KG_AREA_LOOSE;
    for (size_t i = 0; remarks && i < remarks->count; i++)
        if (kg_oa_is_fault(remarks->items[i].trouble))
            mark_remark(m, remarks, &remarks->items[i], KG_AREA_FAULT);
    if (remarks && shown >= 0 && (size_t)shown < remarks->count)
        mark_remark(m, remarks, &remarks->items[shown], KG_AREA_SHOWN);
}

static int area_of(const maker *m, int x, int row, int side) {
    return m->areas[2 * kg_oa_cell(m->sheet, x, row) + (size_t)side];
}

/* ---- points ----------------------------------------------------------------------------- */

/* A point of a piece, in quarters from the cell's upper left corner, to the right and down. */
static kg_oa_tuple point_of(const kg_oa_piece *piece, int right, int down) {
    kg_oa_tuple o = kg_oa_piece_point(piece, 0, 0), a = kg_oa_piece_point(piece, 1, 0),
                b = kg_oa_piece_point(piece, 0, -1), p;
    for (int i = 0; i < 5; i++)
        p.v[i] = UNIT * o.v[i] + right * (a.v[i] - o.v[i]) + down * (b.v[i] - o.v[i]);
    return p;
}

static void add_point(maker *m, kg_card_points *points, const kg_oa_tuple *p) {
    m->failed = m->failed || !kg_push(points, *p);
}

/* A line; one that goes straight on from the last one of its kind makes that longer. */
static void add_line(maker *m, kg_card_line kind, kg_oa_tuple a, kg_oa_tuple b) {
    kg_card_points *points = &m->frame->lines[kind];
    if (points->count >= 2) {
        kg_oa_tuple *from = &points->items[points->count - 2], *to = from + 1;
        int length = 0, step = 0;
        for (int i = 0; i < 5; i++) {
            length = length > abs(to->v[i] - from->v[i]) ? length : abs(to->v[i] - from->v[i]);
            step = step > abs(b.v[i] - a.v[i]) ? step : abs(b.v[i] - a.v[i]);
        }
        bool straight = kg_oa_tuple_equal(to, &a) && step > 0;
        for (int i = 0; i < 5 && straight; i++)
            straight = (to->v[i] - from->v[i]) * step == (b.v[i] - a.v[i]) * length;
        if (straight) {
            *to = b;
            return;
        }
    }
    add_point(m, points, &a);
    add_point(m, points, &b);
}

/* ---- surfaces --------------------------------------------------------------------------- */

/* Cells side by side that are placed alike, as one rectangle; returns how many. */
static int add_run(maker *m, int x, int row) {
    const kg_oa_sheet *s = m->sheet;
    int area = area_of(m, x, row, 0), end = x + 1;
    int32_t place = s->place[kg_oa_cell(s, x, row)];
    while (end < s->width && kg_oa_bent(s, end, row) < 0 &&
           s->place[kg_oa_cell(s, end, row)] == place && area_of(m, end, row, 0) == area)
        end++;
    kg_oa_piece piece = kg_oa_cell_piece(s, x, row, 0);
    kg_oa_tuple corners[4] = {point_of(&piece, 0, 0), point_of(&piece, 0, UNIT),
                              point_of(&piece, UNIT * (end - x), UNIT),
                              point_of(&piece, UNIT * (end - x), 0)};
    for (int i = 0; i < 4; i++)
        add_point(m, &m->frame->surfaces[area], &corners[i]);
    return end - x;
}

static void add_piece(maker *m, int x, int row, int side) {
    const kg_oa_outline *o = &kg_oa_outlines[kg_oa_cell_shape(m->sheet, x, row)][side];
    kg_oa_piece piece = kg_oa_cell_piece(m->sheet, x, row, side);
    for (int i = 0; i < 4; i++) {
        const int *c = o->corners[i < o->count ? i : o->count - 1];
        kg_oa_tuple p = point_of(&piece, UNIT * c[0], UNIT * c[1]);
        add_point(m, &m->frame->surfaces[area_of(m, x, row, side)], &p);
    }
}

static void add_surfaces(maker *m) {
    const kg_oa_sheet *s = m->sheet;
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width;) {
            if (kg_oa_bent(s, x, row) < 0) {
                x += add_run(m, x, row);
                continue;
            }
            for (int side = 0; side < (kg_oa_cell_shape(s, x, row) == KG_OA_WHOLE ? 1 : 2); side++)
                add_piece(m, x, row, side);
            x++;
        }
}

/* ---- lines ------------------------------------------------------------------------------ */

typedef enum edge { UPPER, LOWER, LEFT, RIGHT } edge;

/* One edge of a cell. */
static void add_edge(maker *m, kg_card_line kind, int x, int row, edge which) {
    static const int ends[4][4] = {
        {0, 0, UNIT, 0}, {0, UNIT, UNIT, UNIT}, {0, 0, 0, UNIT}, {UNIT, 0, UNIT, UNIT}};
    kg_oa_shape shape = kg_oa_cell_shape(m->sheet, x, row);
    bool right_piece =
        shape != KG_OA_WHOLE && (which == RIGHT || (which == UPPER && shape == KG_OA_BACKSLASH) ||
                                 (which == LOWER && shape == KG_OA_SLASH));
    kg_oa_piece piece = kg_oa_cell_piece(m->sheet, x, row, right_piece);
    add_line(m, kind, point_of(&piece, ends[which][0], ends[which][1]),
             point_of(&piece, ends[which][2], ends[which][3]));
}

static const kg_card_line line_kinds[] = {KG_CARD_GRID, KG_CARD_EDGE, KG_CARD_MOUNTAIN,
                                          KG_CARD_VALLEY};

/* The lines between rows. */
static void add_levels(maker *m) {
    const kg_oa_sheet *s = m->sheet;
    for (int row = 0; row <= s->rows; row++) {
        bool border = row == 0 || row == s->rows;
        for (int x = 0; x < s->width; x++) {
            kg_oa_edge kind = border ? KG_OA_CUT : kg_oa_edge_below(s, x, row - 1);
            if (row > 0)
                add_edge(m, line_kinds[kind], x, row - 1, LOWER);
        }
        for (int x = 0; x < s->width; x++)
            if (row == 0 || (!border && kg_oa_edge_below(s, x, row - 1) == KG_OA_CUT))
                add_edge(m, KG_CARD_EDGE, x, row, UPPER);
    }
}

/* The lines between columns. */
static void add_columns(maker *m) {
    const kg_oa_sheet *s = m->sheet;
    for (int x = 0; x <= s->width; x++) {
        bool border = x == 0 || x == s->width;
        for (int row = 0; row < s->rows; row++) {
            kg_oa_edge kind = border ? KG_OA_CUT : kg_oa_edge_right(s, x - 1, row);
            if (x > 0)
                add_edge(m, line_kinds[kind], x - 1, row, RIGHT);
        }
        for (int row = 0; row < s->rows; row++)
            if (x == 0 || (!border && kg_oa_edge_right(s, x - 1, row) == KG_OA_CUT))
                add_edge(m, KG_CARD_EDGE, x, row, LEFT);
    }
}

static void add_inner_folds(maker *m) {
    const kg_oa_sheet *s = m->sheet;
    for (int row = 0; row < s->rows && s->bent_count > 0; row++)
        for (int x = 0; x < s->width; x++) {
            kg_oa_shape shape = kg_oa_cell_shape(s, x, row);
            kg_oa_edge kind = shape == KG_OA_WHOLE ? KG_OA_NONE : kg_oa_edge_inside(s, x, row);
            if (kind == KG_OA_NONE)
                continue;
            kg_oa_piece piece = kg_oa_cell_piece(s, x, row, 0);
            int from = shape == KG_OA_SLASH ? UNIT : 0;
            add_line(m, line_kinds[kind], point_of(&piece, 0, from),
                     point_of(&piece, UNIT, UNIT - from));
        }
}

/* Two slanted lines in a whole cell, one in half a cell; those of shown remarks slant the other
 * way. */
static void hatch(maker *m, kg_card_line kind, int x, int row, int side) {
    kg_oa_piece piece = kg_oa_cell_piece(m->sheet, x, row, side);
    kg_oa_shape shape = kg_oa_cell_shape(m->sheet, x, row);
    bool falling = kind == KG_CARD_HATCH_SHOWN;
    if (shape == KG_OA_WHOLE) {
        int a = falling ? UNIT : 0, b = UNIT - a;
        add_line(m, kind, point_of(&piece, 0, b), point_of(&piece, UNIT, a));
        add_line(m, kind, point_of(&piece, 0, UNIT / 2), point_of(&piece, UNIT / 2, a));
        add_line(m, kind, point_of(&piece, UNIT / 2, b), point_of(&piece, UNIT, UNIT / 2));
        return;
    }
    int y0 = side == 0 ? UNIT / 2 : shape == KG_OA_SLASH ? UNIT : 0;
    int y1 = side == 1 ? UNIT / 2 : shape == KG_OA_SLASH ? 0 : UNIT;
    add_line(m, kind, point_of(&piece, side * UNIT / 2, y0),
             point_of(&piece, side * UNIT / 2 + UNIT / 2, y1));
}

static void add_hatches(maker *m) {
    static const kg_card_line kinds[KG_AREA_COUNT] = {
        [KG_AREA_LOOSE] = KG_CARD_HATCH_LOOSE,
        [KG_AREA_FAULT] = KG_CARD_HATCH_FAULT,
        [KG_AREA_SHOWN] = KG_CARD_HATCH_SHOWN,
    };
    const kg_oa_sheet *s = m->sheet;
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++)
            for (int side = 0; side < (kg_oa_cell_shape(s, x, row) == KG_OA_WHOLE ? 1 : 2); side++)
                if (area_of(m, x, row, side) != KG_AREA_FIRM)
                    hatch(m, kinds[area_of(m, x, row, side)], x, row, side);
}

/* ---- all -------------------------------------------------------------------------------- */

kg_status kg_card_frame_make(const kg_oa *oa, const kg_oa_sheet *sheet,
                             const kg_oa_stability *stability, const kg_oa_remarks *remarks,
                             int shown, kg_card_frame *out, kg_error *error) {
    kg_card_frame frame = {.margin = sheet->margin, .cell_mm = oa->cell_mm};
    size_t cells = (size_t)sheet->width * (size_t)sheet->rows;
    maker m = {sheet, &frame, calloc(cells, 2), false};
    if (!m.areas)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    mark(&m, stability, remarks, shown);
    add_surfaces(&m);
    add_levels(&m);
    add_columns(&m);
    add_inner_folds(&m);
    add_hatches(&m);
    free(m.areas);
    if (m.failed) {
        kg_card_frame_clear(&frame);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out = frame;
    return KG_OK;
}

void kg_card_frame_clear(kg_card_frame *f) {
    for (int i = 0; i < KG_AREA_COUNT; i++)
        free(f->surfaces[i].items);
    for (int i = 0; i < KG_CARD_LINE_COUNT; i++)
        free(f->lines[i].items);
    *f = (kg_card_frame){0};
}

void kg_card_frame_pose(const kg_card_frame *f, const kg_card_points *points, double open,
                        kg_vec3 *out) {
    kg_vec3 axes[5];
    kg_oa_axes(open, axes);
    for (size_t i = 0; i < points->count; i++)
        out[i] = kg_oa_place_point(&points->items[i], axes, UNIT * f->margin, f->cell_mm / UNIT);
}

int kg_card_cell_corners(const kg_oa *oa, const kg_oa_sheet *sheet, int x, int row, int side,
                         double open, kg_vec3 out[4]) {
    const kg_oa_outline *outline = &kg_oa_outlines[kg_oa_cell_shape(sheet, x, row)][side];
    kg_oa_piece piece = kg_oa_cell_piece(sheet, x, row, side);
    kg_vec3 axes[5];
    kg_oa_axes(open, axes);
    for (int i = 0; i < outline->count; i++) {
        kg_oa_tuple p = kg_oa_piece_point(&piece, outline->corners[i][0], -outline->corners[i][1]);
        out[i] = kg_oa_place_point(&p, axes, sheet->margin, oa->cell_mm);
    }
    return outline->count;
}
