/* What is wrong with a card, place by place. */
#include "base/array.h"
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

typedef struct finder {
    const kg_oa *oa;
    const kg_oa_sheet *sheet;
    const kg_oa_stability *stability;
    double cell; /* on paper, mm */
    struct {
        kg_oa_remark *items;
        size_t count, capacity;
    } remarks;
    struct {
        struct touch {
            size_t remark;
            int32_t cell;
        } * items;
        size_t count, capacity;
    } touches;     /* cells of remarks, in any order of remarks */
    int32_t *open; /* a remark (or -1) for each patch or each cell of a row or column */
} finder;

static bool begin(finder *f, kg_oa_trouble trouble) {
    kg_oa_remark remark = {.trouble = trouble, .patch = -1};
    return kg_push(&f->remarks, remark);
}

/* Adds a cell to a remark. */
static bool touch(finder *f, size_t remark, int x, int row) {
    kg_oa_remark *r = &f->remarks.items[remark];
    kg_oa_voxel v = kg_oa_faced(f->sheet, x, row);
    const int at[3] = {v.x, v.y, v.z};
    bool first = r->cells++ == 0;
    if (first)
        r->plane = kg_oa_cell_piece(f->sheet, x, row, 0).plane;
    for (int i = 0; i < 3; i++) {
        r->lo[i] = first || at[i] < r->lo[i] ? at[i] : r->lo[i];
        r->hi[i] = first || at[i] > r->hi[i] ? at[i] : r->hi[i];
    }
    r->x0 = first || x < r->x0 ? x : r->x0;
    r->x1 = first || x >= r->x1 ? x + 1 : r->x1;
    r->row0 = first || row < r->row0 ? row : r->row0;
    r->row1 = first || row >= r->row1 ? row + 1 : r->row1;
    struct touch made = {remark, (int32_t)kg_oa_cell(f->sheet, x, row)};
    return kg_push(&f->touches, made);
}

static void close_all(finder *f, size_t count) {
    for (size_t i = 0; i < count; i++)
        f->open[i] = -1;
}

/* Adds a cell to the remark of its patch, which begins with it. */
static bool touch_patch(finder *f, kg_oa_trouble trouble, int patch, int x, int row) {
    int32_t *open = &f->open[patch];
    if (*open < 0) {
        *open = (int32_t)f->remarks.count;
        if (!begin(f, trouble))
            return false;
        f->remarks.items[*open].patch = patch;
    }
    return touch(f, (size_t)*open, x, row);
}

/* ---- floods ----------------------------------------------------------------------------- */

/* Cells that something must hold and that just these floods reach, patch by patch. */
static bool find_missed(finder *f, kg_oa_trouble trouble, const unsigned char *reached,
                        unsigned char by) {
    const kg_oa_sheet *s = f->sheet;
    close_all(f, f->stability->patch_count);
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            size_t cell = kg_oa_cell(s, x, row);
            if (reached[cell] == by && kg_oa_must_hold(s, cell) &&
                !touch_patch(f, trouble, f->stability->patch_of[2 * cell], x, row))
                return false;
        }
    return true;
}

static bool find_faults(finder *f, const unsigned char *reached) {
    return find_missed(f, KG_OA_FLOATING, reached, 0) &&
           find_missed(f, KG_OA_NOT_LIFTED, reached, KG_OA_FROM_BASE) &&
           find_missed(f, KG_OA_NOT_CARRIED, reached, KG_OA_FROM_BACK);
}

/* ---- edges ------------------------------------------------------------------------------ */

/* Cells of one edge of the sheet that do not lie in the plane of back or base: there the model
 * reaches it. */
static bool find_bare_edge(finder *f, int x, int row, int dx, int drow) {
    const kg_oa_sheet *s = f->sheet;
    bool found = false;
    for (; x < s->width && row < s->rows; x += dx, row += drow) {
        int32_t plain =
            row < s->height ? kg_oa_place(0, false) : kg_oa_place(row - s->height, true);
        if (s->place[kg_oa_cell(s, x, row)] == plain)
            continue;
        if (!found && !begin(f, KG_OA_BARE_EDGE))
            return false;
        found = true;
        if (!touch(f, f->remarks.count - 1, x, row))
            return false;
    }
    return true;
}

static bool find_bare_edges(finder *f) {
    const kg_oa_sheet *s = f->sheet;
    return s->margin > 0 ||
           (find_bare_edge(f, 0, 0, 1, 0) && find_bare_edge(f, 0, 0, 0, 1) &&
            find_bare_edge(f, s->width - 1, 0, 0, 1) && find_bare_edge(f, 0, s->rows - 1, 1, 0));
}

/* ---- overhangs -------------------------------------------------------------------------- */

/* The cells of column x that stick out of the closed card; one remark for adjacent columns. */
static bool find_overhang(finder *f, int x, bool *goes_on) {
    const kg_oa_sheet *s = f->sheet;
    bool found = false;
    for (int row = 0; row < s->rows; row++) {
        int cells = kg_oa_closed_reach(s, x, row) - kg_oa_closed_length(s);
        if (cells <= 0)
            continue;
        if (!found && !*goes_on && !begin(f, KG_OA_OVERHANG))
            return false;
        found = *goes_on = true;
        if (!touch(f, f->remarks.count - 1, x, row))
            return false;
        kg_oa_remark *r = &f->remarks.items[f->remarks.count - 1];
        r->mm = fmax(r->mm, cells * f->cell);
    }
    *goes_on = found;
    return true;
}

static bool find_overhangs(finder *f) {
    bool goes_on = false;
    for (int x = 0; x < f->sheet->width; x++)
        if (!find_overhang(f, x, &goes_on))
            return false;
    return true;
}

/* ---- patches ---------------------------------------------------------------------------- */

static bool find_loose(finder *f, bool flap) {
    const kg_oa_sheet *s = f->sheet;
    kg_oa_trouble trouble = flap ? KG_OA_FLAP : KG_OA_LOOSE;
    close_all(f, f->stability->patch_count);
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            const int32_t *patches = &f->stability->patch_of[2 * kg_oa_cell(s, x, row)];
            for (int side = 0; side < (patches[0] == patches[1] ? 1 : 2); side++) {
                const kg_oa_patch *p = &f->stability->patches[patches[side]];
                if (!p->stable && p->flap == flap &&
                    !touch_patch(f, trouble, patches[side], x, row))
                    return false;
            }
        }
    return true;
}

/* ---- tiny features ---------------------------------------------------------------------- */

static bool touch_inside(finder *f, int x, int row) {
    const kg_oa_sheet *s = f->sheet;
    return x < 0 || row < 0 || x >= s->width || row >= s->rows ||
           touch(f, f->remarks.count - 1, x, row);
}

/* The cells on both sides of a line. */
static bool touch_line(finder *f, const kg_oa_line *line) {
    int dx = line->x1 - line->x0, drow = line->row1 - line->row0;
    int units = dx > 0 ? dx : drow;
    bool done = true;
    for (int i = 0; i < units && done; i++) {
        int x = line->x0 + (dx > 0 ? i : 0), row = line->row0 + (dx == 0 ? i : 0);
        if (dx > 0 && drow != 0)
            done = touch_inside(f, x, drow > 0 ? line->row0 + i : line->row0 - i - 1);
        else
            done = touch_inside(f, dx > 0 ? x : x - 1, dx > 0 ? row - 1 : row) &&
                   touch_inside(f, x, row);
    }
    return done;
}

static kg_status find_tiny_folds(finder *f, kg_error *error) {
    kg_oa_line *lines;
    size_t count;
    kg_status status = kg_oa_lines(f->sheet, &lines, &count, error);
    if (status)
        return status;
    bool done = true;
    for (size_t i = 0; i < count && done; i++) {
        double mm = f->cell * hypot(lines[i].x1 - lines[i].x0, lines[i].row1 - lines[i].row0);
        if (lines[i].kind == KG_OA_CUT || mm >= f->oa->tiny_mm)
            continue;
        done = begin(f, KG_OA_TINY_FOLD) && touch_line(f, &lines[i]);
        if (done)
            f->remarks.items[f->remarks.count - 1].mm = mm;
    }
    free(lines);
    return done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

/* Strips lie along rows or, `upright`, along columns; `at` counts across them, `along` on. */
static kg_oa_edge edge_after(const finder *f, bool upright, int at, int along) {
    return upright ? kg_oa_edge_below(f->sheet, along, at) : kg_oa_edge_right(f->sheet, at, along);
}

/* Does the strip [from, to) go on in the one before it, which is as wide and joined with it? */
static bool goes_on(const finder *f, bool upright, int from, int to, int along) {
    if (f->open[from] < 0)
        return false;
    const kg_oa_remark *r = &f->remarks.items[f->open[from]];
    int begin = upright ? r->row0 : r->x0, end = upright ? r->row1 : r->x1;
    int last = upright ? r->x1 : r->row1;
    if (begin != from || end != to || last != along)
        return false;
    for (int at = from; at < to; at++)
        if (edge_after(f, !upright, along - 1, at) != KG_OA_CUT)
            return true;
    return false;
}

static bool add_strip(finder *f, bool upright, int from, int to, int along) {
    if (!goes_on(f, upright, from, to, along)) {
        f->open[from] = (int32_t)f->remarks.count;
        if (!begin(f, KG_OA_TINY_NECK))
            return false;
        f->remarks.items[f->open[from]].mm = (to - from) * f->cell;
    }
    for (int at = from; at < to; at++)
        if (!touch(f, (size_t)f->open[from], upright ? along : at, upright ? at : along))
            return false;
    return true;
}

/* Strips between cuts that are too narrow to hold. */
static bool find_tiny_necks(finder *f, bool upright) {
    int across = upright ? f->sheet->rows : f->sheet->width;
    int length = upright ? f->sheet->width : f->sheet->rows;
    close_all(f, (size_t)across);
    for (int along = 0; along < length; along++)
        for (int at = 0, from = 0; at < across; at++) {
            if (at + 1 < across && edge_after(f, upright, at, along) != KG_OA_CUT)
                continue;
            if ((at + 1 - from) * f->cell < f->oa->tiny_mm &&
                !add_strip(f, upright, from, at + 1, along))
                return false;
            from = at + 1;
        }
    return true;
}

/* ---- all -------------------------------------------------------------------------------- */

static kg_status find_all(finder *f, kg_error *error) {
    const kg_oa_sheet *s = f->sheet;
    size_t missing, entries = f->stability->patch_count + (size_t)s->width + (size_t)s->rows;
    unsigned char *reached = malloc((size_t)s->width * (size_t)s->rows);
    f->open = malloc(entries * sizeof *f->open);
    bool done = reached && f->open;
    kg_status status = done ? kg_oa_flood(s, reached, &missing, error) : KG_OK;
    if (!status && done)
        done = (missing == 0 || find_faults(f, reached)) && find_bare_edges(f) &&
               find_overhangs(f) && find_loose(f, false) && find_loose(f, true);
    if (!status && done && f->cell < f->oa->tiny_mm) {
        status = find_tiny_folds(f, error);
        done = find_tiny_necks(f, false) && find_tiny_necks(f, true);
    }
    free(reached);
    return status || done ? status : kg_fail(error, KG_ERR_MEMORY, "out of memory");
}

/* Hands everything over, each remark's cells together. False when memory runs out. */
static bool gather(finder *f, kg_oa_remarks *out) {
    out->cells = malloc((f->touches.count + 1) * sizeof *out->cells);
    if (!out->cells)
        return false;
    size_t start = 0;
    for (size_t i = 0; i < f->remarks.count; i++) {
        f->remarks.items[i].first_cell = start;
        start += f->remarks.items[i].cells;
        f->remarks.items[i].cells = 0;
        out->faults += kg_oa_is_fault(f->remarks.items[i].trouble);
    }
    for (size_t i = 0; i < f->touches.count; i++) {
        kg_oa_remark *r = &f->remarks.items[f->touches.items[i].remark];
        out->cells[r->first_cell + r->cells++] = f->touches.items[i].cell;
    }
    out->items = f->remarks.items;
    out->count = f->remarks.count;
    f->remarks.items = NULL;
    return true;
}

kg_status kg_oa_remarks_create(const kg_oa *oa, const kg_oa_sheet *sheet,
                               const kg_oa_stability *stability, kg_oa_remarks **out_remarks,
                               kg_error *error) {
    finder f = {
        .oa = oa, .sheet = sheet, .stability = stability, .cell = oa->cell_mm * oa->net.scale};
    kg_oa_remarks *made = calloc(1, sizeof *made);
    kg_status status = made ? find_all(&f, error) : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status && !gather(&f, made))
        status = kg_fail(error, KG_ERR_MEMORY, "out of memory");
    free(f.remarks.items);
    free(f.touches.items);
    free(f.open);
    if (status)
        kg_oa_remarks_destroy(made);
    else
        *out_remarks = made;
    return status;
}

void kg_oa_remarks_destroy(kg_oa_remarks *remarks) {
    if (!remarks)
        return;
    free(remarks->items);
    free(remarks->cells);
    free(remarks);
}
