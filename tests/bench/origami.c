/* Folding and the layers of finished patterns, on sheets folded flat many times over. */
#include "katagami/origami.h"
#include "bench/bench.h"
#include "origami/condition.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A repeatable generator (splitmix64). */
static double random_in(uint64_t *state, double lo, double hi) {
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return lo + (hi - lo) * ((double)((z ^ (z >> 31)) >> 11) * 0x1p-53);
}

static kg_fold random_fold(const kg_origami_state *s, uint64_t *seed) {
    kg_fold f = kg_fold_default();
    size_t v = (size_t)random_in(seed, 0, (double)s->vertices.count);
    f.points[0] = s->vertices.items[v].position;
    f.points[1] = kg_add(f.points[0], kg_v3(random_in(seed, -60, 60), random_in(seed, -60, 60), 0));
    f.angle_deg = random_in(seed, -1, 1) < 0 ? -180 : 180;
    return f;
}

/* A square folded flat until it has at least `faces` of them. */
static kg_origami *folded_square(size_t faces, uint64_t seed) {
    kg_vec2 p[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    kg_paper_sheet sheet = {.count = 4, .polygon = p};
    kg_origami *o = kg_origami_create();
    if (!o || kg_origami_add_sheet(o, &sheet, NULL))
        return o;
    for (int tries = 0; tries < 2000; tries++) {
        const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
        if (s->loops.count >= faces)
            break;
        kg_fold f = random_fold(s, &seed);
        if (kg_origami_fold(o, &f, NULL) != KG_OK)
            continue;
    }
    return o;
}

enum { FOLDS = 20 };

static int compare_times(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Times of random folds, done or only worked out, from the fastest to the slowest. */
static void time_folds(kg_origami *o, bool dry, double out[FOLDS]) {
    const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
    uint64_t seed = 11;
    for (int tries = 0, count = 0; tries < 500 && count < FOLDS; tries++) {
        kg_fold f = random_fold(s, &seed);
        kg_fold_preview preview = {0};
        double start = bench_now();
        kg_status status =
            dry ? kg_fold_preview_make(s, &f, &preview, NULL) : kg_origami_fold(o, &f, NULL);
        double time = bench_now() - start;
        kg_fold_preview_clear(&preview);
        if (status)
            continue;
        out[count++] = time;
        if (!dry)
            kg_origami_undo(o);
    }
    qsort(out, FOLDS, sizeof *out, compare_times);
}

static void bench_fold(size_t faces) {
    kg_origami *o = folded_square(faces, 7);
    const kg_origami_state *s = kg_origami_state_at(o, kg_origami_step(o));
    char what[80];
    double times[FOLDS] = {0};
    time_folds(o, false, times);
    snprintf(what, sizeof what, "origami: one fold, %zu faces, %zu pairs on each other",
             s->loops.count, kg_origami_pair_count(s));
    double median = times[FOLDS / 2];
    bench_row(what, median, "ms", 0.010);
    bench_row("  the slowest of twenty", times[FOLDS - 1], "ms", 0.010);
    char *text;
    size_t size;
    if (kg_origami_fold_text(o, kg_origami_step(o), false, &text, &size, NULL) == KG_OK) {
        bench_rabbit("fold", text, size, median, 1000);
        bench_rabbit("fold-orders", text, size, median, 1000);
        free(text);
    }
    time_folds(o, true, times);
    bench_row("origami: the same fold tried while it is dragged", times[FOLDS / 2], "ms", 0.008);
    bench_row("  the slowest of twenty", times[FOLDS - 1], "ms", 0);
    kg_outlines outlines;
    if (kg_outlines_create(s, &outlines) == KG_OK) {
        double start = bench_now();
        kg_status status = kg_layers_check(s, &outlines, NULL, NULL);
        bench_row(status ? "origami: layers that cross" : "origami: check of all its layers",
                  bench_now() - start, "ms", 0);
        kg_outlines_clear(&outlines);
    }
    kg_origami_destroy(o);
}

/* A flap onto a pile of sheets, which can end below any of them. */
static void bench_gaps(int sheets) {
    kg_vec2 wide[] = {{0, 0}, {100, 0}, {100, 60}, {0, 60}},
            narrow[] = {{0, 0}, {50, 0}, {50, 50}, {0, 50}};
    kg_paper_sheet below = {.count = 4, .polygon = wide}, sheet = {.count = 4, .polygon = narrow};
    kg_origami *o = kg_origami_create();
    kg_status status = o ? kg_origami_add_sheet(o, &below, NULL) : KG_ERR_MEMORY;
    for (int i = 0; i < sheets && !status; i++)
        status = kg_origami_add_sheet(o, &sheet, NULL);
    kg_fold f = kg_fold_default();
    f.by_axis = true;
    f.points[0] = kg_v3(60, 0, 0), f.points[1] = kg_v3(60, 60, 0);
    f.vertex = kg_v3(100, 0, 0);
    kg_fold_gap *gaps = NULL;
    size_t count = 0;
    double start = bench_now();
    if (!status)
        status = kg_fold_gaps(kg_origami_state_at(o, 0), &f, &gaps, &count, NULL);
    char what[80];
    snprintf(what, sizeof what, "origami: %zu gaps found in a pile of %d", count, sheets);
    bench_row(status ? "origami: gaps, failed" : what, bench_now() - start, "ms", 0.2);
    free(gaps);
    kg_origami_destroy(o);
}

/* The crease pattern alone, as a file, to be folded and ordered. */
static void bench_layers(size_t faces) {
    kg_origami *o = folded_square(faces, faces), *read = NULL;
    char *text, what[80];
    size_t size;
    kg_error error;
    kg_layer_report report = kg_layer_report_default();
    if (kg_origami_fold_text(o, kg_origami_step(o), false, &text, &size, &error) == KG_OK) {
        memcpy(strstr(text, "\"file_frames\""), "\"some_frames\"", 13);
        double start = bench_now();
        kg_status status =
            kg_origami_import_memory(text, size, "b.fold", NULL, &read, &report, &error);
        double time = bench_now() - start;
        snprintf(what, sizeof what, "origami: layers of %zu faces, %zu pairs, %s%g states",
                 kg_origami_state_at(o, kg_origami_step(o))->loops.count, report.pairs,
                 report.exact ? "" : "over ", report.states);
        bench_row(status ? error.message : what, time, "ms", 0);
        bench_rabbit("layers", text, size, time, 20);
        free(text);
    }
    kg_origami_destroy(o);
    kg_origami_destroy(read);
}

void bench_origami(void) {
    bench_fold(1000);
    bench_gaps(300);
    bench_gaps(1000);
    bench_layers(70);
    bench_layers(150);
    bench_layers(250);
    bench_layers(400);
}
