#include "net/nest_page.h"

#include <stdlib.h>
#include <string.h>

kg_status kg_nest_page_create(int width, int height, kg_nest_page *out) {
    size_t cells = (size_t)width * (size_t)height;
    kg_nest_page page = {width, height, NULL, NULL};
    page.taken = calloc(cells, sizeof *page.taken);
    page.free_from = calloc(cells, sizeof *page.free_from);
    if (!page.taken || !page.free_from) {
        kg_nest_page_destroy(&page);
        return KG_ERR_MEMORY;
    }
    kg_nest_page_clear(&page);
    *out = page;
    return KG_OK;
}

void kg_nest_page_destroy(kg_nest_page *page) {
    free(page->taken);
    free(page->free_from);
    page->taken = page->free_from = NULL;
}

void kg_nest_page_clear(kg_nest_page *page) {
    size_t cells = (size_t)page->width * (size_t)page->height;
    for (size_t i = 0; i < cells; i++) {
        page->taken[i] = -1;
        page->free_from[i] = (int16_t)(i % (size_t)page->width);
    }
}

void kg_nest_page_copy(kg_nest_page *to, const kg_nest_page *from) {
    size_t size = (size_t)from->width * (size_t)from->height * sizeof *from->taken;
    memcpy(to->taken, from->taken, size);
    memcpy(to->free_from, from->free_from, size);
}

static void take_run(kg_nest_page *page, int row, int lo, int hi) {
    int16_t *taken = page->taken + (size_t)row * (size_t)page->width;
    int16_t *free_from = page->free_from + (size_t)row * (size_t)page->width;
    int next_free = hi + 1 < page->width ? free_from[hi + 1] : page->width;
    for (int x = lo; x <= hi; x++)
        taken[x] = (int16_t)x;
    for (int x = hi + 1; x < page->width && taken[x] < hi; x++)
        taken[x] = (int16_t)hi;
    for (int x = hi; x >= 0 && (x >= lo || taken[x] == x); x--)
        free_from[x] = (int16_t)next_free;
}

void kg_nest_page_take(kg_nest_page *page, const kg_nest_raster *raster, int x, int y) {
    for (size_t i = 0; i < raster->count; i++) {
        kg_nest_run run = raster->runs[i];
        int row = run.row + y;
        int lo = run.lo + x < 0 ? 0 : run.lo + x;
        int hi = run.hi + x >= page->width ? page->width - 1 : run.hi + x;
        if (row >= 0 && row < page->height && lo <= hi)
            take_run(page, row, lo, hi);
    }
}

bool kg_nest_page_find(const kg_nest_page *page, const kg_nest_raster *raster, int x_max, int y_max,
                       int *out_x, int *out_y, uint64_t *work) {
    size_t width = (size_t)page->width;
    for (int y = 0; y <= y_max; y++) {
        int x = 0;
        /* Around the runs until all of them have passed at one x. */
        for (size_t i = 0, passed = 0; x <= x_max; i = i + 1 < raster->count ? i + 1 : 0) {
            const kg_nest_run *run = &raster->runs[i];
            int row = run->row + y;
            ++*work;
            if (row >= 0 && row < page->height) {
                const int16_t *taken = page->taken + (size_t)row * width;
                int hi = run->hi + x < page->width ? run->hi + x : page->width - 1;
                int hit = hi >= 0 ? taken[hi] : -1;
                if (hit >= 0 && hit >= run->lo + x) {
                    x = page->free_from[(size_t)row * width + (size_t)hit] - run->lo;
                    passed = 0;
                    continue;
                }
            }
            if (++passed == raster->count) {
                *out_x = x;
                *out_y = y;
                return true;
            }
        }
    }
    return false;
}
