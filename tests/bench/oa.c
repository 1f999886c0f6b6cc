/* Pop-up cards: windows against a flood fill for every flag, and growing. */
#include "katagami/oa.h"
#include "bench/bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Always the same towers, arches and overhangs, as a depth map has them, made a staircase. */
static kg_oa *rough_card(int w, int d, int h, unsigned char *raised) {
    uint32_t state = 12345;
    kg_oa *oa;
    if (kg_oa_create(w, d, h, 1, &oa, NULL))
        abort();
    for (int n = 0; n < 200; n++) {
        int at[5];
        const int limit[5] = {w - 2, w / 8, h - 1, h, d - 1};
        for (int i = 0; i < 5; i++) {
            state = state * 1664525u + 1013904223u;
            at[i] = (int)((state >> 8) % (uint32_t)limit[i]);
        }
        for (int x = 1 + at[0]; x <= 1 + at[0] + at[1] && x < w - 1; x++)
            for (int z = at[2]; z < at[2] + at[3] && z < h - 1; z++)
                oa->depth[x * h + z] = at[4];
    }
    kg_oa_staircase(oa->depth, w, h, raised);
    return oa;
}

/* The castle where it is at hand. */
static kg_oa *castle_card(int w, int d, int h, unsigned char *raised) {
    const char *folder = getenv("KATAGAMI_DATA");
    char path[4096];
    kg_mesh *mesh;
    kg_oa *oa;
    kg_oa_options o = kg_oa_options_default();
    o.width = w;
    o.depth = d;
    o.height = h;
    snprintf(path, sizeof path, "%s/castle.obj", folder ? folder : "../shared/data");
    if (kg_mesh_read(path, &mesh, NULL))
        return NULL;
    if (kg_oa_create(w, d, h, 1, &oa, NULL) || kg_oa_depth_map(mesh, &o, NULL, oa->depth, NULL) ||
        kg_oa_smooth(oa->depth, w, h, 3, NULL))
        abort();
    kg_oa_staircase(oa->depth, w, h, raised);
    kg_mesh_destroy(mesh);
    return oa;
}

/* One flood with a stack, over cells whose edge is no cut. */
static void flood(const kg_oa_sheet *s, int row, int step, unsigned char flag,
                  unsigned char *reached, int *stack) {
    int count = 0;
    stack[count++] = row * s->width;
    while (count > 0) {
        int cell = stack[--count], x = cell % s->width, r = cell / s->width;
        if (reached[cell] & flag)
            continue;
        reached[cell] |= flag;
        if (x > 0 && kg_oa_edge_right(s, x - 1, r) != KG_OA_CUT)
            stack[count++] = cell - 1;
        if (x + 1 < s->width && kg_oa_edge_right(s, x, r) != KG_OA_CUT)
            stack[count++] = cell + 1;
        if (r + step >= 0 && r + step < s->rows &&
            kg_oa_edge_below(s, x, step > 0 ? r : r - 1) != KG_OA_CUT)
            stack[count++] = cell + step * s->width;
    }
}

/* The published way: a net and a flood for every flag. */
static void open_windows_slowly(kg_oa *oa, const unsigned char *candidates) {
    size_t cells = (size_t)oa->width * (size_t)(oa->height + oa->depth_limit);
    unsigned char *reached = malloc(cells);
    int *stack = malloc((3 * cells + 1) * sizeof *stack);
    for (int z = oa->height - 1; z >= 0; z--)
        for (int x = 0; x < oa->width; x++) {
            kg_oa_sheet *s;
            if (!candidates[x * oa->height + z] || !kg_oa_set_window(oa, x, z, true))
                continue;
            if (!reached || !stack || kg_oa_sheet_create(oa, &s, NULL))
                abort();
            memset(reached, 0, cells);
            flood(s, 0, 1, 1, reached, stack);
            flood(s, s->rows - 1, -1, 2, reached, stack);
            bool valid = true;
            for (size_t i = 0; i < cells && valid; i++)
                valid = !kg_oa_must_hold(s, i) || reached[i] == 3;
            kg_oa_set_window(oa, x, z, valid);
            kg_oa_sheet_destroy(s);
        }
    free(reached);
    free(stack);
}

static size_t count_of(const unsigned char *flags, size_t count) {
    size_t sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += flags[i];
    return sum;
}

static void bench_card(const char *name, kg_oa *oa, const unsigned char *raised, bool slowly,
                       double target) {
    char what[96];
    size_t cells = (size_t)oa->width * (size_t)oa->height;
    kg_oa *slow = kg_oa_copy(oa), *fast = NULL;
    double best = HUGE_VAL;
    if (!slow)
        abort();
    for (int run = 0; run < (slowly ? 10 : 3); run++) {
        kg_oa_destroy(fast);
        fast = kg_oa_copy(oa);
        double start = bench_now();
        if (!fast || kg_oa_open_windows(fast, raised, NULL, NULL))
            abort();
        best = fmin(best, bench_now() - start);
    }
    snprintf(what, sizeof what, "windows: %s, %dx%dx%d, %zu of %zu", name, oa->width,
             oa->depth_limit, oa->height, count_of(fast->window, cells), count_of(raised, cells));
    bench_row(what, best, "ms", target);
    if (slowly) {
        double start = bench_now();
        open_windows_slowly(slow, raised);
        double time = bench_now() - start;
        bench_row("  a flood fill for every flag", time, "ms", 0);
        printf("  %.0f times faster, %s windows   target 100 times\n", time / best,
               memcmp(fast->window, slow->window, cells) ? "OTHER" : "the same");
    }
    kg_oa_destroy(slow);
    kg_oa_destroy(fast);
    kg_oa_destroy(oa);
}

/* A card of the castle made to stand. */
static void bench_mending(kg_oa *oa, const unsigned char *raised) {
    char what[96];
    kg_oa_mended mended;
    if (kg_oa_open_windows(oa, raised, NULL, NULL))
        abort();
    double start = bench_now();
    if (kg_oa_stabilize(oa, NULL, &mended, NULL))
        abort();
    double time = bench_now() - start;
    snprintf(what, sizeof what, "card: made to stand, castle, %dx%dx%d, %zu cells changed",
             oa->width, oa->depth_limit, oa->height, mended.cells);
    bench_row(what, time, "ms", 0);
    kg_oa_destroy(oa);
}

/* All that an editor needs anew after every voxel, and which cell is below the pointer. */
static void bench_editing(kg_oa *oa) {
    enum { RUNS = 40, RAYS = 1000 };
    double edit = HUGE_VAL, pick = HUGE_VAL;
    for (int run = 0; run < RUNS; run++) {
        kg_oa_sheet *sheet;
        kg_oa_stability *stability;
        kg_oa_remarks *remarks;
        kg_oa_line *lines;
        kg_oa_hit hit;
        size_t count;
        double start = bench_now();
        kg_oa_add(oa, 1 + run, 10 + run % 20, 5 + run % 25);
        if (kg_oa_sheet_create(oa, &sheet, NULL) ||
            kg_oa_stability_create(sheet, &stability, NULL) ||
            kg_oa_remarks_create(oa, sheet, stability, &remarks, NULL) ||
            kg_oa_lines(sheet, &lines, &count, NULL))
            abort();
        edit = fmin(edit, bench_now() - start);
        start = bench_now();
        count = 0;
        for (int i = 0; i < RAYS; i++)
            count += kg_oa_pick(oa, sheet, 1.2, kg_v3(0.08 * i, -500, 60), kg_v3(0, 1, -0.1), &hit);
        pick = fmin(pick, (bench_now() - start) / RAYS);
        if (count == 0)
            abort();
        free(lines);
        kg_oa_remarks_destroy(remarks);
        kg_oa_stability_destroy(stability);
        kg_oa_sheet_destroy(sheet);
    }
    bench_row("card: a voxel added, all that follows, 80x40x40", edit, "ms", 0.003);
    bench_row("card: the cell that a ray meets", pick, "us", 0.001);
    kg_oa_destroy(oa);
}

void bench_cards(void) {
    static const int sizes[2][3] = {{80, 40, 40}, {1024, 512, 512}};
    for (int i = 0; i < 2; i++) {
        int w = sizes[i][0], d = sizes[i][1], h = sizes[i][2];
        unsigned char *raised = calloc((size_t)w, (size_t)h);
        if (!raised)
            abort();
        bench_card("blocks", rough_card(w, d, h, raised), raised, i == 0, i == 0 ? 0.002 : 0.5);
        kg_oa *castle = castle_card(w, d, h, raised);
        if (castle)
            bench_card("castle", castle, raised, i == 0, i == 0 ? 0.002 : 0.5);
        if (i == 0)
            bench_editing(rough_card(w, d, h, raised));
        kg_oa *wobbly = i == 0 ? castle_card(w, d, h, raised) : NULL;
        if (wobbly)
            bench_mending(wobbly, raised);
        free(raised);
    }
}
