/* Editing cards: every operation keeps the staircase rule, and windows and omissions where there is
 * something to be cut from. */
#include "oa/sheet.h"

#include <string.h>

static bool inside(const kg_oa *oa, int x, int y, int z) {
    return x >= 0 && x < oa->width && y >= 0 && y < oa->depth_limit && z >= 0 && z < oa->height;
}

void kg_oa_clear_faceless(kg_oa *oa, int x) {
    for (int z = 0; z < oa->height; z++)
        if (kg_oa_depth(oa, x, z) == 0)
            oa->window[x * oa->height + z] = 0;
    for (int z = 0; z <= oa->height; z++)
        if (kg_oa_top(oa, x, z) == 0)
            oa->omitted[x * (oa->height + 1) + z] = 0;
}

bool kg_oa_add(kg_oa *oa, int x, int y, int z) {
    bool changed = false;
    if (!inside(oa, x, y, z))
        return false;
    int *column = oa->depth + x * oa->height;
    for (int level = z; level >= 0 && column[level] <= y; level--) {
        column[level] = y + 1;
        changed = true;
    }
    kg_oa_clear_faceless(oa, x);
    return changed;
}

bool kg_oa_remove(kg_oa *oa, int x, int y, int z) {
    bool changed = false;
    if (!inside(oa, x, y, z))
        return false;
    int *column = oa->depth + x * oa->height;
    for (int level = z; level < oa->height && column[level] > y; level++) {
        column[level] = y;
        changed = true;
    }
    kg_oa_clear_faceless(oa, x);
    return changed;
}

bool kg_oa_set_window(kg_oa *oa, int x, int z, bool on) {
    if (!inside(oa, x, 0, z) || kg_oa_depth(oa, x, z) == 0 || kg_oa_window(oa, x, z) == on)
        return false;
    oa->window[x * oa->height + z] = on;
    return true;
}

bool kg_oa_set_omitted(kg_oa *oa, int x, int z, bool on) {
    if (x < 0 || x >= oa->width || kg_oa_top(oa, x, z) == 0 || kg_oa_omitted(oa, x, z) == on)
        return false;
    oa->omitted[x * (oa->height + 1) + z] = on;
    return true;
}

/* ---- whole cards ------------------------------------------------------------------------ */

static int least(int a, int b) {
    return a < b ? a : b;
}

static void swap_cells(kg_oa *a, kg_oa *b) {
    kg_oa kept = *a;
    a->width = b->width, a->depth_limit = b->depth_limit, a->height = b->height;
    a->depth = b->depth, a->window = b->window, a->omitted = b->omitted;
    b->width = kept.width, b->depth_limit = kept.depth_limit, b->height = kept.height;
    b->depth = kept.depth, b->window = kept.window, b->omitted = kept.omitted;
}

kg_status kg_oa_resize(kg_oa *oa, int width, int depth, int height, kg_error *error) {
    kg_oa *other;
    kg_status status = kg_oa_create(width, depth, height, oa->cell_mm, &other, error);
    if (status)
        return status;
    size_t levels = (size_t)least(height, oa->height);
    for (int x = 0; x < least(width, oa->width); x++) {
        for (size_t z = 0; z < levels; z++)
            other->depth[x * height + (int)z] = least(kg_oa_depth(oa, x, (int)z), depth);
        memcpy(other->window + x * height, oa->window + x * oa->height, levels);
        memcpy(other->omitted + x * (height + 1), oa->omitted + x * (oa->height + 1), levels + 1);
        kg_oa_clear_faceless(other, x);
    }
    swap_cells(oa, other);
    kg_oa_destroy(other);
    return KG_OK;
}

/* Copies `size` bytes; whether they were others before. */
static bool copy_changes(void *to, const void *from, size_t size) {
    bool changes = memcmp(to, from, size) != 0;
    memcpy(to, from, size);
    return changes;
}

bool kg_oa_mirror(kg_oa *oa, kg_oa_half half) {
    bool from_right = half == KG_OA_RIGHT_HALF, changed = false;
    size_t levels = (size_t)oa->height;
    for (int left = 0, right = oa->width - 1; left < right; left++, right--) {
        size_t from = (size_t)(from_right ? right : left), to = (size_t)(from_right ? left : right);
        changed |= copy_changes(oa->depth + to * levels, oa->depth + from * levels,
                                levels * sizeof *oa->depth);
        changed |= copy_changes(oa->window + to * levels, oa->window + from * levels, levels);
        changed |= copy_changes(oa->omitted + to * (levels + 1), oa->omitted + from * (levels + 1),
                                levels + 1);
    }
    return changed;
}
