/*
 * 45° folds: square pyramids in stepped blocks, the only ones that fold rigidly.
 *
 * Found on the columns' depths (after Takahashi's 45° rule, restricted to mirrored pairs of
 * diagonals about a horizontal fold that lies on the parent's own row of the sheet). A block is k
 * wide and k high: in a valley it stands before the corner of the planes y = y0 and z = z0, a notch
 * is cut into such an edge. Blocks of neighbouring columns whose k grows by one from column to
 * column become a pyramid with its apex on that corner line. The box from the apex must be clear,
 * so that the pyramid meets nothing while it folds.
 */
#include "base/array.h"
#include "oa/sheet.h"

#include <stdlib.h>

typedef struct block {
    bool notch;
    int y, z, k;
} block;

typedef struct finder {
    const kg_oa *oa;
    const kg_oa_sheet *sheet; /* not bent yet */
    struct {
        kg_oa_pyramid *items;
        size_t count, capacity;
    } found;
} finder;

/* The end of the levels from z on that are as deep as z. */
static int end_of_level(const kg_oa *oa, int x, int z) {
    int end = z + 1;
    while (end < oa->height && kg_oa_depth(oa, x, end) == kg_oa_depth(oa, x, z))
        end++;
    return end;
}

/* The valley block on the levels [z, end) of equal depth. */
static bool valley_at(const kg_oa *oa, int x, int z, int end, block *out) {
    int depth = kg_oa_depth(oa, x, z);
    if (end == oa->height || kg_oa_depth(oa, x, end) != depth - (end - z))
        return false;
    if (z == 0 && depth >= oa->depth_limit)
        return false;
    *out = (block){false, depth - (end - z), z, end - z};
    return true;
}

/* The notch on them. */
static bool notch_at(const kg_oa *oa, int x, int z, int end, block *out) {
    int depth = kg_oa_depth(oa, x, z);
    if (z == 0 || depth == 0 || kg_oa_depth(oa, x, z - 1) != depth + (end - z))
        return false;
    *out = (block){true, depth + (end - z), end, end - z};
    return true;
}

/* Does column x hold this very block? */
static bool holds(const kg_oa *oa, int x, const block *b) {
    block found;
    if (x < 0 || x >= oa->width || b->k < 1)
        return false;
    int z = b->notch ? b->z - b->k : b->z;
    if (z < 0 || z >= oa->height)
        return false;
    if (z > 0 && kg_oa_depth(oa, x, z - 1) == kg_oa_depth(oa, x, z))
        return false;
    int end = end_of_level(oa, x, z);
    bool any = b->notch ? notch_at(oa, x, z, end, &found) : valley_at(oa, x, z, end, &found);
    return any && found.y == b->y && found.z == b->z && found.k == b->k;
}

static int k_of(const kg_oa_pyramid *p, int x) {
    return p->side > 0 ? x - p->apex + 1 : p->apex - x;
}

/* ---- conditions ------------------------------------------------------------------------- */

/* Would taking column x away from its neighbour outside need a new cut? */
static bool tied(const finder *f, const kg_oa_pyramid *p, int x, int neighbour) {
    if (neighbour < 0 || neighbour >= f->oa->width)
        return false;
    int k = k_of(p, x), row = f->oa->height - (p->z - p->y);
    for (int r = row - k; r < row + k; r++)
        if (f->sheet->place[kg_oa_cell(f->sheet, x, r)] ==
            f->sheet->place[kg_oa_cell(f->sheet, neighbour, r)])
            return true;
    return false;
}

/* Columns of the box, within the sheet. */
static void box_columns(const finder *f, const kg_oa_pyramid *p, int *out_first, int *out_last) {
    int first = p->side > 0 ? p->apex : p->apex - p->large;
    int last = first + p->large - 1;
    *out_first = first < 0 ? 0 : first;
    *out_last = last >= f->oa->width ? f->oa->width - 1 : last;
}

static bool column_is_clear(const finder *f, const kg_oa_pyramid *p, int x) {
    const kg_oa *oa = f->oa;
    int low = p->notch ? p->z - p->large : p->z, high = low + p->large;
    bool in_run = x >= p->first && x <= p->last;
    for (int z = low < 0 ? 0 : low; z < high && z < oa->height; z++) {
        int depth = kg_oa_depth(oa, x, z);
        if (!in_run && (p->notch ? depth < p->y : depth > p->y))
            return false;
        if (kg_oa_window(oa, x, z))
            return false;
    }
    for (int z = low < 1 ? 1 : low; z <= high && z <= oa->height; z++)
        if (kg_oa_omitted(oa, x, z))
            return false;
    return true;
}

static bool apart(int low1, int high1, int low2, int high2) {
    return high1 < low2 || high2 < low1;
}

static bool boxes_apart(const finder *f, const kg_oa_pyramid *a, const kg_oa_pyramid *b) {
    int a0, a1, b0, b1;
    box_columns(f, a, &a0, &a1);
    box_columns(f, b, &b0, &b1);
    int ay = a->notch ? a->y - a->large : a->y, az = a->notch ? a->z - a->large : a->z;
    int by = b->notch ? b->y - b->large : b->y, bz = b->notch ? b->z - b->large : b->z;
    return apart(a0, a1, b0, b1) || apart(ay, ay + a->large, by, by + b->large) ||
           apart(az, az + a->large, bz, bz + b->large);
}

static void set_ends(kg_oa_pyramid *p) {
    int a = k_of(p, p->first), b = k_of(p, p->last);
    p->small = a < b ? a : b;
    p->large = a < b ? b : a;
}

/* Drops end columns that are tied and checks the rest. The end at the apex is not tied to a twin
 * (`shared`), which bends the same way there. */
static bool settle(const finder *f, kg_oa_pyramid *p, bool shared) {
    bool first_free = shared && p->side > 0, last_free = shared && p->side < 0;
    while (p->first < p->last && !first_free && tied(f, p, p->first, p->first - 1))
        p->first++;
    while (p->first < p->last && !last_free && tied(f, p, p->last, p->last + 1))
        p->last--;
    if (p->first == p->last)
        return false;
    set_ends(p);
    int first, last;
    box_columns(f, p, &first, &last);
    for (int x = first; x <= last; x++)
        if (!column_is_clear(f, p, x))
            return false;
    for (size_t i = 0; i < f->found.count; i++)
        if (!boxes_apart(f, p, &f->found.items[i]))
            return false;
    return true;
}

/* ---- finding ---------------------------------------------------------------------------- */

/* Is the column's block part of a pyramid found before? */
static bool used(const finder *f, const block *b, int x) {
    for (size_t i = 0; i < f->found.count; i++) {
        const kg_oa_pyramid *p = &f->found.items[i];
        if (p->notch == b->notch && p->y == b->y && p->z == b->z && x >= p->first && x <= p->last)
            return true;
    }
    return false;
}

/* The longest run from column x, towards `step`, whose k grows or falls by `rise` at each column; a
 * block that an earlier pyramid has belongs to that one. Returns its last column. */
static int run_from(const finder *f, int x, const block *b, int step, int rise) {
    block next = *b;
    for (next.k += rise; holds(f->oa, x + step, &next) && !used(f, &next, x + step); next.k += rise)
        x += step;
    return x;
}

/* Two pyramids apex to apex: the columns on both sides of the apex are alike and joined, and stay
 * so when both bend. Returns false when there is no such pair. */
static bool find_twins(const finder *f, kg_oa_pyramid *p, kg_oa_pyramid *out_twin) {
    block b = {p->notch, p->y, p->z, 1};
    int x = p->first - 1;
    if (p->side < 0 || k_of(p, p->first) != 1 || !holds(f->oa, x, &b) || used(f, &b, x))
        return false;
    kg_oa_pyramid a = *p, twin = *p;
    twin.side = -1;
    twin.first = run_from(f, x, &b, -1, 1);
    twin.last = x;
    if (!settle(f, &a, true) || !settle(f, &twin, true))
        return false;
    *p = a;
    *out_twin = twin;
    return true;
}

/* The run from column x on whose k changes by `side`. False when memory runs out. */
static bool find_from(finder *f, int x, const block *b, int side) {
    block before = {b->notch, b->y, b->z, b->k - side};
    if (holds(f->oa, x - 1, &before) && !used(f, &before, x - 1))
        return true; /* the run began further left */
    kg_oa_pyramid twin, p = {.notch = b->notch,
                             .y = b->y,
                             .z = b->z,
                             .apex = side > 0 ? x - b->k + 1 : x + b->k,
                             .side = side,
                             .first = x,
                             .last = run_from(f, x, b, 1, side)};
    if (p.first == p.last)
        return true;
    if (find_twins(f, &p, &twin))
        return kg_push(&f->found, p) && kg_push(&f->found, twin);
    return !settle(f, &p, false) || kg_push(&f->found, p);
}

static bool find_in_column(finder *f, int x, int side) {
    const kg_oa *oa = f->oa;
    for (int z = 0, end; z < oa->height; z = end) {
        block b;
        end = end_of_level(oa, x, z);
        if (valley_at(oa, x, z, end, &b) && !used(f, &b, x) && !find_from(f, x, &b, side))
            return false;
        if (notch_at(oa, x, z, end, &b) && !used(f, &b, x) && !find_from(f, x, &b, side))
            return false;
    }
    return true;
}

/* ---- bending ---------------------------------------------------------------------------- */

/* The upper and the lower plane of a pyramid. */
static kg_oa_class plane_of(const kg_oa_pyramid *p, bool upper) {
    if (p->notch)
        return p->side > 0 ? (upper ? KG_OA_S2 : KG_OA_T2) : (upper ? KG_OA_S : KG_OA_T);
    return p->side > 0 ? (upper ? KG_OA_T : KG_OA_S) : (upper ? KG_OA_T2 : KG_OA_S2);
}

/* Bends one cell of column x: upper or lower half, on the crossed row or inside. */
static void bend_cell(kg_oa_sheet *s, const kg_oa_pyramid *p, int x, int row, int32_t index) {
    int k = k_of(p, x), t = s->height - row, m = p->z - p->y; /* t: the cell's upper edge */
    bool upper = t > m, crossed = t == m + k || t == m - k + 1;
    kg_oa_piece apex = {plane_of(p, upper), {{p->apex, p->y, p->z, 0, 0}}};
    kg_oa_piece inner = {apex.plane, kg_oa_piece_point(&apex, x - p->apex, t - m)};
    kg_oa_piece outer = inner;
    if (crossed) { /* it stays in the plane beyond: y = y0 or z = z0 */
        outer.plane = upper != p->notch ? KG_OA_BACK : KG_OA_FLOOR;
        int y = outer.plane == KG_OA_BACK ? p->y : p->z - t;
        outer.corner = (kg_oa_tuple){{x, y, y + t, 0, 0}};
    }
    bool outer_left = p->side > 0; /* the diagonals run away from the apex */
    s->shapes[index] = !crossed                 ? KG_OA_WHOLE
                       : upper == (p->side > 0) ? KG_OA_SLASH
                                                : KG_OA_BACKSLASH;
    s->pieces[2 * index] = outer_left ? outer : inner;
    s->pieces[2 * index + 1] = outer_left ? inner : outer;
    s->bent[kg_oa_cell(s, x, row)] = index;
}

static kg_status bend_all(kg_oa_sheet *s, kg_error *error) {
    size_t cells = (size_t)s->width * (size_t)s->rows;
    for (size_t i = 0; i < s->pyramid_count; i++)
        for (int x = s->pyramids[i].first; x <= s->pyramids[i].last; x++)
            s->bent_count += 2 * (size_t)k_of(&s->pyramids[i], x);
    s->bent = malloc(cells * sizeof *s->bent);
    s->pieces = calloc(s->bent_count, 2 * sizeof *s->pieces);
    s->shapes = calloc(s->bent_count, 1);
    if (!s->bent || !s->pieces || !s->shapes)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    for (size_t i = 0; i < cells; i++)
        s->bent[i] = -1;
    int32_t index = 0;
    for (size_t i = 0; i < s->pyramid_count; i++) {
        const kg_oa_pyramid *p = &s->pyramids[i];
        for (int x = p->first; x <= p->last; x++) {
            int k = k_of(p, x), row = s->height - (p->z - p->y);
            for (int r = row - k; r < row + k; r++)
                bend_cell(s, p, x, r, index++);
        }
    }
    return KG_OK;
}

kg_status kg_oa_bend(const kg_oa *oa, kg_oa_sheet *sheet, kg_error *error) {
    finder f = {.oa = oa, .sheet = sheet};
    bool done = true;
    for (int side = 1; side >= -1; side -= 2)
        for (int x = 0; x < oa->width && done; x++)
            done = find_in_column(&f, x, side);
    if (!done || f.found.count == 0) {
        free(f.found.items);
        return done ? KG_OK : kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    sheet->pyramids = f.found.items;
    sheet->pyramid_count = f.found.count;
    return bend_all(sheet, error);
}
