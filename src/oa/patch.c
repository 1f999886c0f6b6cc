/* Patches of paper and the hinges between them. */
#include "oa/stability.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

typedef struct mapper {
    const kg_oa_sheet *sheet;
    int32_t *patch_of;
    struct {
        struct place {
            size_t piece;
            int x, row;
        } * items; /* pieces to go on from */
        size_t count, capacity;
    } open;
    struct {
        kg_oa_patch *items;
        size_t count, capacity;
    } patches;
    struct {
        int32_t *items; /* of each part of a patch, one that it is joined to, none later; its own */
        size_t count, capacity;
    } parents;
    struct {
        kg_oa_hinge *items;
        size_t count, capacity;
    } hinges;
} mapper;

/* Index of the piece of a cell that has its right, lower, left or upper edge. */
enum { RIGHT, LOWER, LEFT, UPPER };

static size_t piece_at(const kg_oa_sheet *s, int x, int row, int edge) {
    size_t cell = 2 * kg_oa_cell(s, x, row);
    kg_oa_shape shape = kg_oa_cell_shape(s, x, row);
    if (shape == KG_OA_WHOLE || edge == LEFT)
        return cell;
    if (edge == RIGHT)
        return cell + 1;
    return cell + (shape == (edge == LOWER ? KG_OA_SLASH : KG_OA_BACKSLASH));
}

static bool join(mapper *m, size_t piece, int x, int row, int32_t patch) {
    if (m->patch_of[piece] >= 0)
        return true;
    m->patch_of[piece] = patch;
    return kg_push(&m->open, ((struct place){piece, x, row}));
}

/* Gives the patch on to the pieces beyond those edges of `piece` that are no lines. */
static bool go_on(mapper *m, size_t piece, int x, int row, int32_t patch) {
    const kg_oa_sheet *s = m->sheet;
    bool done = true;
    if (x + 1 < s->width && piece_at(s, x, row, RIGHT) == piece &&
        kg_oa_edge_right(s, x, row) == KG_OA_NONE)
        done = join(m, piece_at(s, x + 1, row, LEFT), x + 1, row, patch);
    if (done && x > 0 && piece_at(s, x, row, LEFT) == piece &&
        kg_oa_edge_right(s, x - 1, row) == KG_OA_NONE)
        done = join(m, piece_at(s, x - 1, row, RIGHT), x - 1, row, patch);
    if (done && row + 1 < s->rows && piece_at(s, x, row, LOWER) == piece &&
        kg_oa_edge_below(s, x, row) == KG_OA_NONE)
        done = join(m, piece_at(s, x, row + 1, UPPER), x, row + 1, patch);
    if (done && row > 0 && piece_at(s, x, row, UPPER) == piece &&
        kg_oa_edge_below(s, x, row - 1) == KG_OA_NONE)
        done = join(m, piece_at(s, x, row - 1, LOWER), x, row - 1, patch);
    return done;
}

static void widen(const kg_oa_sheet *s, size_t piece, int x, int row, kg_oa_patch *p) {
    p->x0 = x < p->x0 ? x : p->x0;
    p->x1 = x >= p->x1 ? x + 1 : p->x1;
    p->row0 = row < p->row0 ? row : p->row0;
    p->row1 = row >= p->row1 ? row + 1 : p->row1;
    p->cells++;
    p->front |= (s->marks[piece / 2] & (KG_OA_PUSHED | KG_OA_FALLEN)) == 0;
}

/* Planes: y or z of the piece's corner in the ordinary ones, one of its own for every pyramid's,
 * told apart by the patch that is found first: a pyramid's plane holds a single patch. */
static int plane_id(const kg_oa_sheet *s, const kg_oa_piece *piece, size_t patch) {
    int y = piece->corner.v[1], z = piece->corner.v[2];
    if (piece->plane == KG_OA_BACK)
        return y;
    if (piece->plane == KG_OA_FLOOR)
        return s->depth + 1 + z;
    return s->depth + s->height + 2 + (int)patch;
}

/* A patch that begins at a piece, as yet without cells. */
static kg_oa_patch patch_from(const mapper *m, int x, int row, int side) {
    kg_oa_piece piece = kg_oa_cell_piece(m->sheet, x, row, side);
    return (kg_oa_patch){.x0 = x,
                         .row0 = row,
                         .plane = piece.plane,
                         .plane_id = plane_id(m->sheet, &piece, m->patches.count)};
}

static bool map_patch(mapper *m, size_t first) {
    const kg_oa_sheet *s = m->sheet;
    int32_t patch = (int32_t)m->patches.count;
    int x = (int)(first / 2 % (size_t)s->width), row = (int)(first / 2 / (size_t)s->width);
    kg_oa_patch p = patch_from(m, x, row, (int)(first % 2));
    if (!join(m, first, x, row, patch))
        return false;
    while (m->open.count > 0) {
        struct place at = m->open.items[--m->open.count];
        widen(s, at.piece, at.x, at.row, &p);
        if (!go_on(m, at.piece, at.x, at.row, patch))
            return false;
    }
    return kg_push(&m->patches, p);
}

static bool map_bent(mapper *m) {
    const kg_oa_sheet *s = m->sheet;
    size_t pieces = 2 * (size_t)s->width * (size_t)s->rows;
    for (size_t i = 0; i < pieces; i++)
        m->patch_of[i] = -1;
    for (size_t i = 0; i < pieces; i++) {
        bool whole = s->bent[i / 2] < 0 || s->shapes[s->bent[i / 2]] == KG_OA_WHOLE;
        if (whole && i % 2 == 1)
            m->patch_of[i] = m->patch_of[i - 1];
        else if (m->patch_of[i] < 0 && !map_patch(m, i))
            return false;
    }
    return true;
}

/* ---- sheets without bent cells: by far most, and much faster row by row ------------------- */

/* Parts of patches are numbered as they are found; those that turn out to be one are joined to the
 * first of them, so that patches come in the order of their first cells. */
static int32_t first_part(mapper *m, int32_t part) {
    int32_t *parent = m->parents.items;
    while (parent[part] != part)
        part = parent[part] = parent[parent[part]];
    return part;
}

static void join_parts(mapper *m, int32_t a, int32_t b) {
    a = first_part(m, a);
    b = first_part(m, b);
    m->parents.items[a > b ? a : b] = a < b ? a : b;
}

/* A vertical cell is placed like those above and beside it in the same plane, the y of horizontal
 * ones is one more with every row. */
static bool map_cell(mapper *m, int x, int row) {
    const kg_oa_sheet *s = m->sheet;
    size_t cell = kg_oa_cell(s, x, row), width = (size_t)s->width;
    const int32_t *place = s->place + cell;
    int32_t *part = m->patch_of + 2 * cell;
    bool beside = x > 0 && place[-1] == *place;
    bool below = row > 0 && *(place - width) == *place - (*place & 1 ? 2 : 0);
    if (beside || below) {
        *part = beside ? *(part - 2) : *(part - 2 * width);
        if (beside && below && *(part - 2 * width) != *part)
            join_parts(m, *part, *(part - 2 * width));
    } else {
        *part = (int32_t)m->patches.count;
        if (!kg_push(&m->parents, *part) || !kg_push(&m->patches, patch_from(m, x, row, 0)))
            return false;
    }
    widen(s, 2 * cell, x, row, &m->patches.items[*part]);
    return true;
}

static void add_part(kg_oa_patch *patch, const kg_oa_patch *part) {
    patch->x0 = part->x0 < patch->x0 ? part->x0 : patch->x0;
    patch->x1 = part->x1 > patch->x1 ? part->x1 : patch->x1;
    patch->row1 = part->row1 > patch->row1 ? part->row1 : patch->row1; /* it begins later */
    patch->cells += part->cells;
    patch->front |= part->front;
}

static bool map_plain(mapper *m) {
    const kg_oa_sheet *s = m->sheet;
    size_t cells = (size_t)s->width * (size_t)s->rows, count = 0;
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++)
            if (!map_cell(m, x, row))
                return false;
    int32_t *number = m->parents.items;
    for (size_t i = 0; i < m->patches.count; i++)
        number[i] = first_part(m, (int32_t)i);
    for (size_t i = 0; i < m->patches.count; i++) { /* from here on, up to i, those of patches */
        const kg_oa_patch part = m->patches.items[i];
        bool is_first = number[i] == (int32_t)i;
        number[i] = is_first ? (int32_t)count++ : number[number[i]];
        if (is_first)
            m->patches.items[number[i]] = part;
        else
            add_part(&m->patches.items[number[i]], &part);
    }
    m->patches.count = count;
    for (size_t i = 0; i < cells; i++)
        m->patch_of[2 * i] = m->patch_of[2 * i + 1] = number[m->patch_of[2 * i]];
    return true;
}

static bool map_patches(mapper *m) {
    return m->sheet->bent ? map_bent(m) : map_plain(m);
}

/* ---- hinges ----------------------------------------------------------------------------- */

static bool add_hinge(mapper *m, size_t a, size_t b, kg_oa_tuple from, kg_oa_tuple to) {
    int p = m->patch_of[a], q = m->patch_of[b];
    kg_oa_hinge h = {{p < q ? p : q, p < q ? q : p}, {from, to}};
    if (m->hinges.count > 0) { /* most unit edges go on with the hinge before */
        const kg_oa_hinge *last = &m->hinges.items[m->hinges.count - 1];
        if (last->patches[0] == h.patches[0] && last->patches[1] == h.patches[1])
            return true;
    }
    return kg_push(&m->hinges, h);
}

static bool is_fold(kg_oa_edge edge) {
    return edge == KG_OA_MOUNTAIN || edge == KG_OA_VALLEY;
}

/* Sheets without bent cells have folds below cells only, where the planes change. */
static bool has_plain_fold(const kg_oa_sheet *s, int x, int row) {
    const int32_t *place = s->place + kg_oa_cell(s, x, row);
    return row + 1 < s->rows && ((place[0] ^ place[s->width]) & 1) &&
           kg_oa_place_lower(place[0]) == kg_oa_place_upper(place[s->width]);
}

static bool add_cell_hinges(mapper *m, int x, int row) {
    const kg_oa_sheet *s = m->sheet;
    if (!s->bent && !has_plain_fold(s, x, row))
        return true;
    kg_oa_piece left = kg_oa_cell_piece(s, x, row, 0), right = kg_oa_cell_piece(s, x, row, 1);
    kg_oa_shape shape = kg_oa_cell_shape(s, x, row);
    bool done = true;
    if (row + 1 < s->rows && is_fold(kg_oa_edge_below(s, x, row))) {
        const kg_oa_piece *low = shape == KG_OA_SLASH ? &right : &left;
        done = add_hinge(m, piece_at(s, x, row, LOWER), piece_at(s, x, row + 1, UPPER),
                         kg_oa_piece_point(low, 0, -1), kg_oa_piece_point(low, 1, -1));
    }
    if (done && x + 1 < s->width && is_fold(kg_oa_edge_right(s, x, row)))
        done = add_hinge(m, piece_at(s, x, row, RIGHT), piece_at(s, x + 1, row, LEFT),
                         kg_oa_piece_point(&right, 1, 0), kg_oa_piece_point(&right, 1, -1));
    if (done && is_fold(kg_oa_edge_inside(s, x, row))) {
        int low = shape == KG_OA_SLASH ? -1 : 0;
        size_t cell = 2 * kg_oa_cell(s, x, row);
        done = add_hinge(m, cell, cell + 1, kg_oa_piece_point(&left, 0, low),
                         kg_oa_piece_point(&left, 1, -1 - low));
    }
    return done;
}

static int compare_hinges(const void *a, const void *b) {
    const kg_oa_hinge *h = a, *g = b;
    for (int i = 0; i < 2; i++)
        if (h->patches[i] != g->patches[i])
            return h->patches[i] < g->patches[i] ? -1 : 1;
    for (int i = 0; i < 5; i++)
        if (h->ends[0].v[i] != g->ends[0].v[i])
            return h->ends[0].v[i] < g->ends[0].v[i] ? -1 : 1;
    return 0;
}

/* Two planes meet in one line, so a pair of patches has one hinge, in however many stretches. */
static bool map_hinges(mapper *m) {
    const kg_oa_sheet *s = m->sheet;
    for (int row = 0; row < s->rows; row++)
        for (int x = 0; x < s->width; x++)
            if (!add_cell_hinges(m, x, row))
                return false;
    size_t kept = 0;
    if (m->hinges.count > 1)
        qsort(m->hinges.items, m->hinges.count, sizeof *m->hinges.items, compare_hinges);
    for (size_t i = 0; i < m->hinges.count; i++) {
        const kg_oa_hinge *h = &m->hinges.items[i];
        if (kept == 0 || h->patches[0] != m->hinges.items[kept - 1].patches[0] ||
            h->patches[1] != m->hinges.items[kept - 1].patches[1])
            m->hinges.items[kept++] = *h;
    }
    m->hinges.count = kept;
    return true;
}

/* The first piece of a row that lies in the sheet's own plane; its first at all without one. */
static int patch_in_row(const mapper *m, int row, int32_t place) {
    const kg_oa_sheet *s = m->sheet;
    for (int x = 0; x < s->width; x++)
        if (kg_oa_bent(s, x, row) < 0 && s->place[kg_oa_cell(s, x, row)] == place)
            return m->patch_of[2 * kg_oa_cell(s, x, row)];
    return m->patch_of[2 * kg_oa_cell(s, 0, row)];
}

kg_status kg_oa_patches_map(const kg_oa_sheet *sheet, kg_oa_stability *out, kg_error *error) {
    size_t pieces = 2 * (size_t)sheet->width * (size_t)sheet->rows;
    mapper m = {.sheet = sheet, .patch_of = malloc(pieces * sizeof *m.patch_of)};
    bool done = m.patch_of && map_patches(&m) && map_hinges(&m);
    free(m.open.items);
    free(m.parents.items);
    if (!done) {
        free(m.patch_of);
        free(m.patches.items);
        free(m.hinges.items);
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    }
    *out = (kg_oa_stability){
        .patch_count = m.patches.count,
        .patches = m.patches.items,
        .patch_of = m.patch_of,
        .hinge_count = m.hinges.count,
        .hinges = m.hinges.items,
        .back = patch_in_row(&m, 0, kg_oa_place(0, false)),
        .base = patch_in_row(&m, sheet->rows - 1, kg_oa_place(sheet->depth - 1, true)),
    };
    return KG_OK;
}
