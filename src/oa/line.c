/* The lines of the net: unit edges joined where they go straight on in one kind. */
#include "base/array.h"
#include "oa/sheet.h"

#include <stdlib.h>

typedef struct lines {
    kg_oa_line *items;
    size_t count, capacity;
} lines;

/* Lengthens the last line when `unit` begins where it ends; else adds it. */
static bool add_unit(lines *all, size_t first, kg_oa_line unit) {
    if (unit.kind == KG_OA_NONE)
        return true;
    if (all->count > first) {
        kg_oa_line *last = &all->items[all->count - 1];
        if (last->kind == unit.kind && last->x1 == unit.x0 && last->row1 == unit.row0) {
            last->x1 = unit.x1;
            last->row1 = unit.row1;
            return true;
        }
    }
    return kg_push(all, unit);
}

static bool add_straight(const kg_oa_sheet *s, lines *all) {
    bool done = true;
    for (int row = 0; row + 1 < s->rows && done; row++) {
        size_t first = all->count;
        for (int x = 0; x < s->width && done; x++)
            done = add_unit(all, first,
                            (kg_oa_line){kg_oa_edge_below(s, x, row), x, row + 1, x + 1, row + 1});
    }
    for (int x = 0; x + 1 < s->width && done; x++) {
        size_t first = all->count;
        for (int row = 0; row < s->rows && done; row++)
            done = add_unit(all, first,
                            (kg_oa_line){kg_oa_edge_right(s, x, row), x + 1, row, x + 1, row + 1});
    }
    return done;
}

/* The fold across a cell when it has this shape, else none; outside the sheet as well. */
static kg_oa_edge across(const kg_oa_sheet *s, int x, int row, kg_oa_shape shape) {
    if (x < 0 || row < 0 || x >= s->width || row >= s->rows || kg_oa_cell_shape(s, x, row) != shape)
        return KG_OA_NONE;
    return kg_oa_edge_inside(s, x, row);
}

static bool add_oblique(const kg_oa_sheet *s, lines *all) {
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++) {
            kg_oa_shape shape = kg_oa_cell_shape(s, x, row);
            kg_oa_edge kind = kg_oa_edge_inside(s, x, row);
            int down = shape == KG_OA_SLASH ? -1 : 1; /* of the next cell to the right */
            if (kind == KG_OA_NONE || across(s, x - 1, row - down, shape) == kind)
                continue;
            int n = 1;
            while (across(s, x + n, row + n * down, shape) == kind)
                n++;
            int start = shape == KG_OA_SLASH ? row + 1 : row;
            if (!kg_push(all, ((kg_oa_line){kind, x, start, x + n, start + n * down})))
                return false;
        }
    return true;
}

kg_status kg_oa_lines(const kg_oa_sheet *sheet, kg_oa_line **out_lines, size_t *out_count,
                      kg_error *error) {
    lines all = {0};
    if (!kg_reserve(&all, 1) || !add_straight(sheet, &all) ||
        (sheet->bent && !add_oblique(sheet, &all))) {
        free(all.items);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out_lines = all.items;
    *out_count = all.count;
    return KG_OK;
}
