#include "reference.h"

#include <stdlib.h>

kg_oa *random_card(kg_random *r, double windows, double omitted, bool plain) {
    int w = whole(r, 3, 10), d = whole(r, 2, 8), h = whole(r, 2, 9);
    return random_card_of(r, w, d, h, windows, omitted, plain);
}

kg_oa *random_card_of(kg_random *r, int w, int d, int h, double windows, double omitted,
                      bool plain) {
    kg_oa *oa;
    assert_int_equal(kg_oa_create(w, d, h, 1, &oa, NULL), KG_OK);
    for (int x = plain; x < w - plain; x++) {
        int depth = whole(r, 0, d - plain);
        for (int z = 0; z < h - plain; z++) {
            if (chance(r, 0.35))
                depth = whole(r, 0, depth);
            oa->depth[x * h + z] = depth;
        }
        if (x > plain && chance(r, 0.4)) /* columns alike, so that there are wide fronts */
            memcpy(oa->depth + x * h, oa->depth + (x - 1) * h, (size_t)h * sizeof(int));
    }
    for (int x = 0; x < w; x++)
        for (int z = 0; z <= h; z++) {
            if (z < h && kg_oa_depth(oa, x, z) > 0)
                oa->window[x * h + z] = chance(r, windows);
            if (kg_oa_top(oa, x, z) > 0)
                oa->omitted[x * (h + 1) + z] = chance(r, omitted);
        }
    return oa;
}

/* ---- faces ------------------------------------------------------------------------------ */

static bool solid(const kg_oa *oa, int x, int y, int z) {
    if (y < 0 || z < 0) /* behind the back sheet and below the base */
        return true;
    return z < oa->height && y < kg_oa_depth(oa, x, z);
}

/* The cell on the diagonals from `lower` to `lower` + 1, upright at y or level at height z. */
static face upright(int y, int lower) {
    return (face){y, lower + 1 + y, y, lower + y, y > 0};
}
static face level(int z, int lower) {
    return (face){z - lower - 1, z, z - lower, z, false};
}

static face *cell_at(const kg_oa *oa, face *faces, int x, int lower) {
    return &faces[(oa->height - 1 - lower) * oa->width + x];
}

static void gather(const kg_oa *oa, face *faces, unsigned char *count, int x) {
    for (int y = 0; y <= oa->depth_limit; y++)
        for (int z = 0; z < oa->height; z++)
            if (solid(oa, x, y - 1, z) && !solid(oa, x, y, z)) {
                *cell_at(oa, faces, x, z - y) = upright(y, z - y);
                count[(oa->height - 1 - z + y) * oa->width + x]++;
            }
    for (int y = 0; y < oa->depth_limit; y++)
        for (int z = 0; z <= oa->height; z++)
            if (solid(oa, x, y, z - 1) && !solid(oa, x, y, z)) {
                *cell_at(oa, faces, x, z - y - 1) = level(z, z - y - 1);
                count[(oa->height - z + y) * oa->width + x]++;
            }
}

static void omit(const kg_oa *oa, face *faces, int x, int z) {
    int y0 = z < oa->height ? kg_oa_depth(oa, x, z) : 0, y1 = kg_oa_depth(oa, x, z - 1);
    for (int y = y0; y < y1; y++) {
        int lower = z - y - 1;
        face *f = cell_at(oa, faces, x, lower);
        *f = lower + y0 >= 0 ? upright(y0, lower) : level(0, lower);
        f->front = false;
    }
}

static void push(const kg_oa *oa, face *faces, int x, int low, int high) {
    int bottom = low - kg_oa_depth(oa, x, low), top = high - kg_oa_depth(oa, x, high);
    for (int lower = bottom; lower <= top; lower++) {
        face *f = cell_at(oa, faces, x, lower);
        *f = low - lower - 1 >= 0 ? level(low, lower) : upright(0, lower);
    }
}

face *faces_of(const kg_oa *oa) {
    size_t cells = (size_t)oa->width * (size_t)(oa->height + oa->depth_limit);
    face *faces = calloc(cells, sizeof *faces);
    unsigned char *count = calloc(cells, 1);
    assert_true(faces && count);
    for (int x = 0; x < oa->width; x++) {
        gather(oa, faces, count, x);
        for (int z = 1; z <= oa->height; z++)
            if (kg_oa_omitted(oa, x, z))
                omit(oa, faces, x, z);
        for (int low = 0, high; low < oa->height; low = high + 1) {
            for (high = low; high < oa->height && kg_oa_window(oa, x, high);)
                high++;
            if (high > low)
                push(oa, faces, x, low, high - 1);
        }
    }
    for (size_t i = 0; i < cells; i++)
        assert_int_equal(count[i], 1);
    free(count);
    return faces;
}

kg_oa_edge edge_below(const kg_oa *oa, const face *faces, int x, int row) {
    const face *a = &faces[row * oa->width + x], *b = a + oa->width;
    if (a->y1 != b->y0 || a->z1 != b->z0)
        return KG_OA_CUT;
    bool a_upright = a->y0 == a->y1, b_upright = b->y0 == b->y1;
    return a_upright == b_upright ? KG_OA_NONE : a_upright ? KG_OA_VALLEY : KG_OA_MOUNTAIN;
}

kg_oa_edge edge_right(const kg_oa *oa, const face *faces, int x, int row) {
    const face *a = &faces[row * oa->width + x], *b = a + 1;
    bool same = a->y0 == b->y0 && a->z0 == b->z0 && a->y1 == b->y1 && a->z1 == b->z1;
    return same ? KG_OA_NONE : KG_OA_CUT;
}

/* ---- flood fill ------------------------------------------------------------------------- */

/* `step` rows down (1) or up (-1). */
static void flood_from(const kg_oa *oa, const face *faces, int row, int step, unsigned char flag,
                       unsigned char *reached) {
    int w = oa->width, rows = oa->height + oa->depth_limit, *stack, count = 0;
    stack = malloc((size_t)(3 * w * rows + 1) * sizeof *stack);
    stack[count++] = row * w;
    while (count > 0) {
        int cell = stack[--count], x = cell % w, r = cell / w;
        if (reached[cell] & flag)
            continue;
        reached[cell] |= flag;
        if (x > 0 && edge_right(oa, faces, x - 1, r) != KG_OA_CUT)
            stack[count++] = cell - 1;
        if (x + 1 < w && edge_right(oa, faces, x, r) != KG_OA_CUT)
            stack[count++] = cell + 1;
        if (r + step >= 0 && r + step < rows &&
            edge_below(oa, faces, x, step > 0 ? r : r - 1) != KG_OA_CUT)
            stack[count++] = cell + step * w;
    }
    free(stack);
}

size_t flood_fill(const kg_oa *oa, const face *faces) {
    int rows = oa->height + oa->depth_limit;
    size_t cells = (size_t)oa->width * (size_t)rows, missing = 0;
    unsigned char *reached = calloc(cells, 1);
    flood_from(oa, faces, 0, 1, 1, reached);
    flood_from(oa, faces, rows - 1, -1, 2, reached);
    for (size_t i = 0; i < cells; i++)
        missing += faces[i].front && reached[i] != 3;
    free(reached);
    return missing;
}

/* ---- mobility --------------------------------------------------------------------------- */

/* Patches as sets of cells, the first cell standing for all. */
static int first_of(const int *set, int cell) {
    while (set[cell] != cell)
        cell = set[cell];
    return cell;
}

static void unite(int *set, int a, int b) {
    a = first_of(set, a);
    b = first_of(set, b);
    set[a > b ? a : b] = a < b ? a : b;
}

static int64_t inverse_of(int64_t a, int64_t p) {
    int64_t result = 1;
    for (int64_t n = p - 2; n > 0; n /= 2, a = a * a % p)
        if (n % 2 == 1)
            result = result * a % p;
    return result;
}

/* Gauss and Jordan modulo a prime of 31 bits; returns the rank, moves the solved rows up. */
static int reduce(int64_t *rows, int count, int columns) {
    const int64_t p = 2147483647;
    int rank = 0;
    for (int c = 0; c < columns && rank < count; c++) {
        int pivot = rank;
        while (pivot < count && rows[pivot * columns + c] == 0)
            pivot++;
        if (pivot == count)
            continue;
        int64_t factor = inverse_of((rows[pivot * columns + c] % p + p) % p, p);
        for (int k = 0; k < columns; k++) {
            int64_t value = (rows[pivot * columns + k] % p + p) * factor % p;
            rows[pivot * columns + k] = rows[rank * columns + k];
            rows[rank * columns + k] = value;
        }
        for (int r = 0; r < count; r++) {
            int64_t times = r == rank ? 0 : rows[r * columns + c];
            for (int k = c; times != 0 && k < columns; k++)
                rows[r * columns + k] =
                    (rows[r * columns + k] - times * rows[rank * columns + k]) % p;
        }
        rank++;
    }
    return rank;
}

/* Patch `a` has the speeds (turn w, u, v) of which u - w z and v + w y are those of the point
 * (y,z). Patch `b` has the same there. -1: a patch that is held. */
static void fold_at(int64_t *rows, int columns, int a, int b, int y, int z) {
    for (int i = 0; i < 2; i++) {
        int patch = i ? b : a, sign = i ? -1 : 1;
        if (patch < 0)
            continue;
        rows[3 * patch] -= sign * z;
        rows[3 * patch + 1] += sign;
        rows[columns + 3 * patch] += sign * y;
        rows[columns + 3 * patch + 2] += sign;
    }
}

/* The equations of all folds; `number` is per cell that of its patch. free() them. */
static int64_t *equations_of(const kg_oa *oa, const face *faces, const int *number, int columns,
                             int *out_count) {
    int w = oa->width, rows = oa->height + oa->depth_limit, count = 0;
    int64_t *all = calloc((size_t)(2 * w * rows) * (size_t)columns + 1, sizeof *all);
    assert_non_null(all);
    for (int row = 0; row + 1 < rows; row++)
        for (int x = 0; x < w; x++) {
            int cell = row * w + x;
            kg_oa_edge edge = edge_below(oa, faces, x, row);
            if (edge != KG_OA_MOUNTAIN && edge != KG_OA_VALLEY)
                continue;
            fold_at(all + count * columns, columns, number[cell], number[cell + w], faces[cell].y1,
                    faces[cell].z1);
            count += 2;
        }
    *out_count = count;
    return all;
}

int move_freely(const kg_oa *oa, const face *faces, bool *out_still) {
    int w = oa->width, rows = oa->height + oa->depth_limit, cells = w * rows, count, patches = 0;
    int *patch = malloc((size_t)cells * sizeof *patch),
        *body = malloc((size_t)cells * sizeof *body);
    int *number = calloc((size_t)cells, sizeof *number);
    assert_true(patch && body && number);
    for (int i = 0; i < cells; i++)
        patch[i] = body[i] = i;
    for (int row = 0; row < rows; row++)
        for (int x = 0; x < w; x++) {
            int cell = row * w + x;
            kg_oa_edge right = x + 1 < w ? edge_right(oa, faces, x, row) : KG_OA_CUT;
            kg_oa_edge below = row + 1 < rows ? edge_below(oa, faces, x, row) : KG_OA_CUT;
            if (right != KG_OA_CUT)
                unite(patch, cell, cell + 1), unite(body, cell, cell + 1);
            if (below != KG_OA_CUT)
                unite(body, cell, cell + w);
            if (below == KG_OA_NONE)
                unite(patch, cell, cell + w);
        }
    int bodies = 0, back = 0, base = first_of(patch, cells - 1);
    for (int i = 0; i < cells; i++) {
        bodies += first_of(body, i) == i;
        if (first_of(patch, i) == i)
            number[i] = patches++;
        number[i] = number[first_of(patch, i)];
    }
    int64_t *all = equations_of(oa, faces, number, 3 * patches, &count);
    /* the back holds the plane's three motions; each body may also leave the plane in three ways */
    int degrees = 3 * patches - 3 - reduce(all, count, 3 * patches) + 3 * (bodies - 1);
    free(all);

    back = number[back];
    base = number[base];
    for (int i = 0; i < cells; i++)
        if (number[i] == back || number[i] == base)
            number[i] = -1;
    all = equations_of(oa, faces, number, 3 * patches, &count);
    int rank = reduce(all, count, 3 * patches), *still = calloc((size_t)patches, sizeof *still);
    assert_non_null(still);
    for (int r = 0; r < rank; r++) {
        int terms = 0, first = -1;
        for (int k = 0; k < 3 * patches; k++)
            if (all[r * 3 * patches + k] != 0 && terms++ == 0)
                first = k;
        still[first / 3] += terms == 1; /* that speed is nothing */
    }
    for (int i = 0; i < cells; i++)
        out_still[i] = number[i] < 0 || still[number[i]] == 3;
    free(still);
    free(all);
    free(number);
    free(body);
    free(patch);
    return degrees;
}

void open_windows_slowly(kg_oa *oa, const unsigned char *candidates) {
    for (int z = oa->height - 1; z >= 0; z--)
        for (int x = 0; x < oa->width; x++) {
            unsigned char *window = &oa->window[x * oa->height + z];
            if (!candidates[x * oa->height + z] || kg_oa_depth(oa, x, z) == 0 || *window)
                continue;
            *window = 1;
            face *faces = faces_of(oa);
            *window = flood_fill(oa, faces) == 0;
            free(faces);
        }
}

solved solve(const kg_oa *oa) {
    solved s;
    assert_int_equal(kg_oa_sheet_create(oa, &s.sheet, NULL), KG_OK);
    assert_int_equal(kg_oa_stability_create(s.sheet, &s.stability, NULL), KG_OK);
    assert_int_equal(kg_oa_remarks_create(oa, s.sheet, s.stability, &s.remarks, NULL), KG_OK);
    return s;
}

void clear(solved *s) {
    kg_oa_remarks_destroy(s->remarks);
    kg_oa_stability_destroy(s->stability);
    kg_oa_sheet_destroy(s->sheet);
}
