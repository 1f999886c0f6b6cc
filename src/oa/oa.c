/* Cards: memory, comparison, the staircase rule. */
#include "katagami/oa.h"

#include "base/phrase.h"

#include <jansson.h>

#include <stdlib.h>
#include <string.h>

/* Sizes are bounded before they are multiplied: (2048 + 1)² × 4 bytes fits everywhere. */
static kg_oa *allocate(int width, int depth, int height) {
    size_t cells = (size_t)width * (size_t)height;
    kg_oa *oa = calloc(1, sizeof *oa);
    if (!oa)
        return NULL;
    oa->width = width;
    oa->depth_limit = depth;
    oa->height = height;
    oa->net = kg_net_settings_default();
    oa->tiny_mm = KG_OA_TINY;
    oa->depth = calloc(cells, sizeof *oa->depth);
    oa->window = calloc(cells, 1);
    oa->omitted = calloc(cells + (size_t)width, 1);
    oa->title = strdup("");
    if (oa->depth && oa->window && oa->omitted && oa->title)
        return oa;
    kg_oa_destroy(oa);
    return NULL;
}

/* `format` says it of the side in question. */
static kg_status check_size(int cells, const char *format, kg_error *error) {
    if (cells >= 1 && cells <= KG_OA_MAX_SIZE)
        return KG_OK;
    return kg_fail(error, KG_ERR_INPUT, format, KG_OA_MAX_SIZE, cells);
}

static kg_status check_sizes(int width, int depth, int height, double cell_mm, kg_error *error) {
    kg_status status = check_size(width, N_("the width of a card is 1 to %d cells, not %d"), error);
    if (!status)
        status = check_size(depth, N_("the depth of a card is 1 to %d cells, not %d"), error);
    if (!status)
        status = check_size(height, N_("the height of a card is 1 to %d cells, not %d"), error);
    if (!status && !(cell_mm > 0 && cell_mm <= KG_OA_MAX_CELL))
        status = kg_fail(error, KG_ERR_INPUT, "a cell is above 0 and at most %g mm, not %g",
                         KG_OA_MAX_CELL, cell_mm);
    return status;
}

kg_status kg_oa_create(int width, int depth, int height, double cell_mm, kg_oa **out_oa,
                       kg_error *error) {
    kg_status status = check_sizes(width, depth, height, cell_mm, error);
    if (status)
        return status;
    kg_oa *oa = allocate(width, depth, height);
    if (!oa)
        return kg_fail(error, KG_ERR_MEMORY, "out of memory");
    oa->cell_mm = cell_mm;
    *out_oa = oa;
    return KG_OK;
}

kg_oa *kg_oa_copy(const kg_oa *oa) {
    kg_oa *copy = allocate(oa->width, oa->depth_limit, oa->height);
    if (!copy)
        return NULL;
    size_t cells = (size_t)oa->width * (size_t)oa->height;
    memcpy(copy->depth, oa->depth, cells * sizeof *oa->depth);
    memcpy(copy->window, oa->window, cells);
    memcpy(copy->omitted, oa->omitted, cells + (size_t)oa->width);
    copy->cell_mm = oa->cell_mm;
    copy->diagonals = oa->diagonals;
    copy->margin_cells = oa->margin_cells;
    copy->tiny_mm = oa->tiny_mm;
    free(copy->title);
    copy->title = strdup(oa->title);
    copy->json = json_incref(oa->json); /* never changed in place, so it can be shared */
    if (kg_net_settings_copy(&oa->net, &copy->net) && copy->title)
        return copy;
    kg_oa_destroy(copy);
    return NULL;
}

void kg_oa_destroy(kg_oa *oa) {
    if (!oa)
        return;
    free(oa->depth);
    free(oa->window);
    free(oa->omitted);
    free(oa->title);
    kg_net_settings_clear(&oa->net);
    json_decref(oa->json);
    free(oa);
}

bool kg_oa_equal(const kg_oa *a, const kg_oa *b) {
    if (a->width != b->width || a->height != b->height || a->depth_limit != b->depth_limit)
        return false;
    size_t cells = (size_t)a->width * (size_t)a->height;
    return a->cell_mm == b->cell_mm && a->diagonals == b->diagonals &&
           a->margin_cells == b->margin_cells && a->tiny_mm == b->tiny_mm &&
           strcmp(a->title, b->title) == 0 && kg_net_settings_equal(&a->net, &b->net) &&
           memcmp(a->depth, b->depth, cells * sizeof *a->depth) == 0 &&
           memcmp(a->window, b->window, cells) == 0 &&
           memcmp(a->omitted, b->omitted, cells + (size_t)a->width) == 0 &&
           (a->json == b->json || json_equal(a->json, b->json));
}

int kg_oa_top(const kg_oa *oa, int x, int z) {
    if (z < 1 || z > oa->height)
        return 0;
    return kg_oa_depth(oa, x, z - 1) - (z < oa->height ? kg_oa_depth(oa, x, z) : 0);
}

static kg_status check_level(const kg_oa *oa, int x, int z, kg_error *error) {
    int depth = kg_oa_depth(oa, x, z);
    if (depth < 0 || depth > oa->depth_limit)
        return kg_fail(error, KG_ERR_INPUT, "column %d, level %d: depth %d is not within 0 and %d",
                       x, z, depth, oa->depth_limit);
    if (z > 0 && depth > kg_oa_depth(oa, x, z - 1))
        return kg_fail(error, KG_ERR_INPUT,
                       "column %d, level %d: depth %d is more than the %d below it; depths must "
                       "not grow upwards",
                       x, z, depth, kg_oa_depth(oa, x, z - 1));
    if (kg_oa_window(oa, x, z) && depth == 0)
        return kg_fail(error, KG_ERR_INPUT,
                       "column %d, level %d: a window, but no front to cut it from", x, z);
    return KG_OK;
}

kg_status kg_oa_check(const kg_oa *oa, kg_error *error) {
    kg_status status = check_sizes(oa->width, oa->depth_limit, oa->height, oa->cell_mm, error);
    if (!status && (oa->margin_cells < 0 || oa->margin_cells > KG_OA_MAX_MARGIN))
        status = kg_fail(error, KG_ERR_INPUT, "the margin is 0 to %d cells, not %d",
                         KG_OA_MAX_MARGIN, oa->margin_cells);
    for (int x = 0; x < oa->width && !status; x++) {
        for (int z = 0; z < oa->height && !status; z++)
            status = check_level(oa, x, z, error);
        for (int z = 0; z <= oa->height && !status; z++)
            if (kg_oa_omitted(oa, x, z) && kg_oa_top(oa, x, z) == 0)
                status = kg_fail(error, KG_ERR_INPUT,
                                 "column %d, height %d: a top is omitted, but there is none", x, z);
    }
    return status;
}
