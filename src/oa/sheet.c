/*
 * The lattice path: column x of the sheet, from the top of the back sheet to the front of the base,
 * is a path of H + D unit cells from (y,z) = (0,H) to (D,0). It goes out at height z while the
 * column is deeper there than y, else down. Windows and omitted tops place cells anew along their
 * own diagonals.
 */
#include "oa/sheet.h"

#include <stdlib.h>
#include <string.h>

void kg_oa_window_run(const kg_oa *oa, int x, int z, int *out_z0, int *out_z1, int *out_first,
                      int *out_last) {
    int z0 = z, z1 = z;
    while (z0 > 0 && kg_oa_window(oa, x, z0 - 1))
        z0--;
    while (z1 + 1 < oa->height && kg_oa_window(oa, x, z1 + 1))
        z1++;
    *out_z0 = z0;
    *out_z1 = z1;
    *out_first = kg_oa_front_row(oa, x, z1);
    *out_last = kg_oa_front_row(oa, x, z0);
}

static void lay_path(const kg_oa *oa, int x, int32_t *place, unsigned char *marks) {
    int y = 0, z = oa->height;
    for (int row = 0; row < oa->height + oa->depth_limit; row++) {
        bool out = z == 0 || kg_oa_depth(oa, x, z - 1) > y;
        place[row] = kg_oa_place(y, out);
        marks[row] = !out && y > 0 ? KG_OA_FRONT : 0;
        y += out;
        z -= !out;
    }
}

static void drop_top(const kg_oa *oa, int x, int z, int32_t *place, unsigned char *marks) {
    int depth = z < oa->height ? kg_oa_depth(oa, x, z) : 0, first = oa->height - z + depth;
    for (int i = 0; i < kg_oa_top(oa, x, z); i++) {
        place[first + i] = kg_oa_fallen_place(depth, z, i);
        marks[first + i] = KG_OA_FALLEN;
    }
}

/* Pushes the run that ends at level z1 back; returns its lowest level. */
static int push_window(const kg_oa *oa, int x, int z1, int32_t *place, unsigned char *marks) {
    int z0, first, last;
    kg_oa_window_run(oa, x, z1, &z0, &z1, &first, &last);
    for (int row = first; row <= last; row++) {
        place[row] = kg_oa_pushed_place(kg_oa_depth(oa, x, z0), last - row);
        marks[row] = KG_OA_PUSHED;
    }
    return z0;
}

void kg_oa_lay_column(const kg_oa *oa, int x, int32_t *place, unsigned char *marks) {
    lay_path(oa, x, place, marks);
    for (int z = 1; z <= oa->height; z++)
        if (kg_oa_omitted(oa, x, z))
            drop_top(oa, x, z, place, marks);
    for (int z = oa->height - 1; z >= 0; z--)
        if (kg_oa_window(oa, x, z))
            z = push_window(oa, x, z, place, marks);
}

kg_oa *kg_oa_with_margins(const kg_oa *oa) {
    int m = oa->margin_cells;
    kg_oa *all = calloc(1, sizeof *all);
    if (!all)
        return NULL;
    all->width = oa->width + 2 * m;
    all->height = oa->height + m;
    all->depth_limit = oa->depth_limit + m;
    size_t columns = (size_t)all->width, levels = (size_t)all->height;
    all->depth = calloc(columns * levels, sizeof *all->depth);
    all->window = calloc(columns * levels, 1);
    all->omitted = calloc(columns * (levels + 1), 1);
    if (!all->depth || !all->window || !all->omitted) {
        kg_oa_destroy(all);
        return NULL;
    }
    for (int x = 0; x < oa->width; x++) {
        int from = x * oa->height, to = (x + m) * all->height;
        memcpy(all->depth + to, oa->depth + from, (size_t)oa->height * sizeof *all->depth);
        memcpy(all->window + to, oa->window + from, (size_t)oa->height);
        memcpy(all->omitted + to + x + m, oa->omitted + from + x, (size_t)oa->height + 1);
    }
    return all;
}

/* Lays out every column. False when memory runs out. */
static bool lay_columns(const kg_oa *oa, kg_oa_sheet *s) {
    size_t rows = (size_t)s->rows;
    int32_t *place = malloc(rows * sizeof *place);
    unsigned char *marks = malloc(rows);
    bool done = place && marks;
    for (int x = 0; x < s->width && done; x++) {
        kg_oa_lay_column(oa, x, place, marks);
        for (int row = 0; row < s->rows; row++) {
            s->place[kg_oa_cell(s, x, row)] = place[row];
            s->marks[kg_oa_cell(s, x, row)] = marks[row];
        }
    }
    free(place);
    free(marks);
    return done;
}

static kg_status lay_out(const kg_oa *all, bool diagonals, int margin, kg_oa_sheet **out,
                         kg_error *error) {
    kg_oa_sheet *s = calloc(1, sizeof *s);
    if (!s)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    s->width = all->width;
    s->height = all->height;
    s->depth = all->depth_limit;
    s->rows = s->height + s->depth;
    s->margin = margin;
    size_t cells = (size_t)s->width * (size_t)s->rows;
    s->place = calloc(cells, sizeof *s->place);
    s->marks = calloc(cells, 1);
    kg_status status = s->place && s->marks && lay_columns(all, s)
                           ? KG_OK
                           : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    if (!status && diagonals)
        status = kg_oa_bend(all, s, error);
    if (status)
        kg_oa_sheet_destroy(s);
    else
        *out = s;
    return status;
}

kg_status kg_oa_sheet_create(const kg_oa *oa, kg_oa_sheet **out_sheet, kg_error *error) {
    if (oa->margin_cells == 0)
        return lay_out(oa, oa->diagonals, 0, out_sheet, error);
    kg_oa *all = kg_oa_with_margins(oa);
    if (!all)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    kg_status status = lay_out(all, oa->diagonals, oa->margin_cells, out_sheet, error);
    kg_oa_destroy(all);
    return status;
}

void kg_oa_sheet_destroy(kg_oa_sheet *sheet) {
    if (!sheet)
        return;
    free(sheet->place);
    free(sheet->marks);
    free(sheet->pyramids);
    free(sheet->bent);
    free(sheet->pieces);
    free(sheet->shapes);
    free(sheet);
}
