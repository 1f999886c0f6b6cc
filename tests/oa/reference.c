#include "reference.h"

#include <stdlib.h>

kg_oa *random_card(kg_random *r, double windows, double omitted, bool plain) {
    kg_oa *oa;
    int w = whole(r, 3, 10), d = whole(r, 2, 8), h = whole(r, 2, 9);
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
